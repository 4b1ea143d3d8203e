// SPDX-License-Identifier: MIT
#include "refine/domain.h"

#include <algorithm>
#include <cmath>

namespace sinkmesh {
namespace {

template <int Dim>
std::array<Vertex, Dim> sorted(std::array<Vertex, Dim> facet) {
  std::sort(facet.begin(), facet.end());
  return facet;
}

// Facets by their smallest vertex: few have the same one, so that looking one up is a short scan.
template <int Dim>
class FacetIndex {
 public:
  FacetIndex(std::span<const std::array<Vertex, Dim>> facets, std::size_t num_vertices)
      : first_(num_vertices + 1, 0), entries_(facets.size()) {
    for (const auto& facet : facets) ++first_[sorted<Dim>(facet)[0].index() + 1];
    for (std::size_t v = 0; v < num_vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const auto facet = sorted<Dim>(facets[i]);
      entries_[next[facet[0].index()]++] = {facet, i};
    }
  }

  /// Calls found(index) for every facet of the list with these corners.
  template <class Found>
  void look_up(const std::array<Vertex, Dim>& corners, Found&& found) const {
    const Vertex smallest = *std::min_element(corners.begin(), corners.end());
    const std::uint32_t v = smallest.index();
    if (first_[v] == first_[v + 1]) return;
    const auto facet = sorted<Dim>(corners);
    for (std::uint32_t k = first_[v]; k < first_[v + 1]; ++k) {
      if (entries_[k].facet == facet) found(entries_[k].index);
    }
  }

 private:
  struct Entry {
    std::array<Vertex, Dim> facet;
    std::size_t index;
  };
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace

// One half-facet for each facet, or null.
template <int Dim>
std::vector<HalfFacet> Domain<Dim>::find(std::span<const Facet> facets) const {
  const Complex<Dim>& complex = triangulation_->complex();
  const FacetIndex<Dim> index(facets, complex.num_vertices());
  std::vector<HalfFacet> found(facets.size());
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const Simplex t = Complex<Dim>::simplex_of(complex.mate(h));
      if (s < t || complex.is_ghost(t)) {
        index.look_up(complex.facet(h), [&](std::size_t f) { found[f] = h; });
      }
    }
  }
  return found;
}

template <int Dim>
std::vector<std::size_t> Domain<Dim>::label_by_parity(std::span<const Facet> facets) {
  const Complex<Dim>& complex = triangulation_->complex();
  const std::vector<HalfFacet> found = find(facets);
  std::vector<std::size_t> missing;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (found[f].is_null()) missing.push_back(f);
  }
  if (!missing.empty()) return missing;

  // Facets that occur twice cancel.
  std::vector<std::uint8_t> crossed(complex.num_slots(), 0);
  const auto flip = [&](HalfFacet h) {
    std::uint8_t& bits = crossed[Complex<Dim>::simplex_of(h).index()];
    bits = static_cast<std::uint8_t>(bits ^ 1U << Complex<Dim>::corner_of(h));
  };
  for (const HalfFacet h : found) {
    flip(h);
    flip(complex.mate(h));
  }

  constexpr std::uint8_t kUnknown = 2;
  inside_.assign(complex.num_slots(), kUnknown);
  std::vector<Simplex> stack;
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) {
      inside_[s.index()] = 0;
      stack.push_back(s);
    }
  }
  bool contradiction = false;
  while (!stack.empty()) {
    const Simplex s = stack.back();
    stack.pop_back();
    for (int i = 0; i <= Dim; ++i) {
      const Simplex t = complex.neighbor(s, i);
      const auto label = static_cast<std::uint8_t>(inside_[s.index()] ^ (crossed[s.index()] >> i & 1));
      if (inside_[t.index()] == kUnknown) {
        inside_[t.index()] = label;
        stack.push_back(t);
      } else if (inside_[t.index()] != label) {
        contradiction = true;
      }
    }
  }
  for (std::uint8_t& label : inside_) {
    if (label == kUnknown) label = 0;  // slots without a simplex
  }
  if (contradiction) {
    std::fill(inside_.begin(), inside_.end(), std::uint8_t{0});
    throw InputError("the surface does not separate inside from outside: it is not closed");
  }
  return {};
}

template <int Dim>
auto Domain<Dim>::peel(Flow<Dim>& flow) -> Peeled {
  const Complex<Dim>& complex = triangulation_->complex();
  Peeled peeled;
  std::vector<Simplex> stack;
  const auto peel_if_it_flows_out = [&](HalfFacet h) {
    const Simplex s = Complex<Dim>::simplex_of(h);
    if (!is_inside(s) || !flow.crosses(h)) return;
    set_inside(s, false);
    ++peeled.simplices;
    stack.push_back(s);
  };
  const std::vector<HalfFacet> boundary_before = boundary();
  for (const HalfFacet h : boundary_before) peel_if_it_flows_out(h);
  while (!stack.empty()) {
    const Simplex s = stack.back();
    stack.pop_back();
    for (int i = 0; i <= Dim; ++i) peel_if_it_flows_out(complex.mate(Complex<Dim>::half_facet(s, i)));
  }
  for (const HalfFacet h : boundary_before) peeled.facets += is_inside(Complex<Dim>::simplex_of(h)) ? 0 : 1;
  return peeled;
}

template <int Dim>
std::vector<Simplex> Domain<Dim>::simplices() const {
  std::vector<Simplex> result;
  for (const Simplex s : triangulation_->complex().simplices()) {
    if (is_inside(s)) result.push_back(s);
  }
  return result;
}

template <int Dim>
std::vector<HalfFacet> Domain<Dim>::boundary() const {
  std::vector<HalfFacet> result;
  for (const Simplex s : simplices()) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (!is_inside(Complex<Dim>::simplex_of(triangulation_->complex().mate(h)))) result.push_back(h);
    }
  }
  return result;
}

template class Domain<2>;
template class Domain<3>;

}  // namespace sinkmesh
