// SPDX-License-Identifier: MIT
#include "core/retriangulator.h"

#include <algorithm>

namespace sinkmesh {
namespace {

// The same orientation with infinity, if it is there, in the last place. In the plane the corners are turned
// around; in space infinity changes places with the last corner, and two others do as well.
template <int Dim>
std::array<Vertex, Dim + 1> with_infinity_last(std::array<Vertex, Dim + 1> corners) {
  const auto infinity = std::find(corners.begin(), corners.end(), Vertex::infinite());
  if (infinity == corners.end() || infinity == corners.end() - 1) return corners;
  if constexpr (Dim == 2) {
    std::rotate(corners.begin(), infinity + 1, corners.end());
  } else {
    std::iter_swap(infinity, corners.end() - 1);
    const auto first = infinity == corners.begin() ? corners.begin() + 1 : corners.begin();
    const auto second = infinity == corners.begin() + 2 ? corners.begin() + 1 : corners.begin() + 2;
    std::iter_swap(first, second);
  }
  return corners;
}

}  // namespace

template <int Dim>
std::array<std::uint32_t, Dim> Retriangulator<Dim>::key_of(const Complex<Dim>& complex, HalfFacet h) {
  std::array<std::uint32_t, Dim> key;
  const std::array<Vertex, Dim> vertices = complex.facet(h);
  for (std::size_t k = 0; k < Dim; ++k) key[k] = vertices[k].slot();
  std::sort(key.begin(), key.end());
  return key;
}

// Joins h with the open half-facet that has the same vertices, or leaves it open for one that comes later.
template <int Dim>
void Retriangulator<Dim>::link(Complex<Dim>& complex, HalfFacet h) {
  const auto key = key_of(complex, h);
  const auto found =
      std::find_if(open_.begin(), open_.end(), [&](const Open& open) { return open.facet == key; });
  if (found == open_.end()) {
    open_.push_back({key, h});
    return;
  }
  complex.set_mates(found->half_facet, h);
  *found = open_.back();
  open_.pop_back();
}

template <int Dim>
void Retriangulator<Dim>::link_by_sorting(Complex<Dim>& complex) {
  for (const Simplex s : created_) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      open_.push_back({key_of(complex, h), h});
    }
  }
  std::sort(open_.begin(), open_.end(), [](const Open& a, const Open& b) { return a.facet < b.facet; });
  for (std::size_t i = 0; i + 1 < open_.size(); i += 2) {
    SINKMESH_ASSERT(open_[i].facet == open_[i + 1].facet);
    complex.set_mates(open_[i].half_facet, open_[i + 1].half_facet);
  }
  open_.clear();
}

template <int Dim>
const std::vector<Simplex>& Retriangulator<Dim>::replace(Complex<Dim>& complex, std::span<const Simplex> old,
                                                         std::span<const Corners> fresh) {
  created_.resize(fresh.size());
  open_.clear();
  open_.reserve(fresh.size() * (Dim + 1) + old.size() * (Dim + 1));
  complex.reserve(fresh.size());
  complex.reserve_release(old.size());

  auto& records = complex.records();
  for (const Simplex s : old) records[s.index()].corner[0] |= Complex<Dim>::kMark;
  for (const Simplex s : old) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet outer = complex.mate(Complex<Dim>::half_facet(s, i));
      const bool stays = !(records[Complex<Dim>::simplex_of(outer).index()].corner[0] & Complex<Dim>::kMark);
      if (stays) open_.push_back({key_of(complex, outer), outer});
    }
  }
  for (std::size_t n = 0; n < fresh.size(); ++n) created_[n] = n < old.size() ? old[n] : complex.allocate();
  for (std::size_t n = fresh.size(); n < old.size(); ++n) complex.release(old[n]);

  for (std::size_t n = 0; n < fresh.size(); ++n) {
    const Corners corners = with_infinity_last<Dim>(fresh[n]);
    for (std::size_t i = 0; i <= Dim; ++i) {
      records[created_[n].index()].corner[i] = corners[i].slot();
      complex.set_incident(corners[i], created_[n]);
    }
  }
  constexpr std::size_t kFew = 8;
  if (created_.size() > kFew) {
    link_by_sorting(complex);
  } else {
    for (const Simplex s : created_) {
      for (int i = 0; i <= Dim; ++i) link(complex, Complex<Dim>::half_facet(s, i));
    }
  }
  SINKMESH_ASSERT(open_.empty());
  return created_;
}

template class Retriangulator<2>;
template class Retriangulator<3>;

}  // namespace sinkmesh
