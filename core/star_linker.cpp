// SPDX-License-Identifier: MIT
#include "core/star_linker.h"

#include <algorithm>

namespace sinkmesh {
namespace {

// The scratch word of a vertex is a stamp of 24 bits, which says in which star it was numbered last, and its
// number there, 8 bits. A star of f facets is a triangulated sphere around v: f vertices in the plane, f/2 + 2
// in space.
constexpr int kNumberBits = 8;

// Tables of two sizes: most stars fit the small one.
constexpr int kLogShortRow = 5;
constexpr int kLogLongRow = kNumberBits;
constexpr std::size_t kShortRow = std::size_t{1} << kLogShortRow;
constexpr std::size_t kLongRow = std::size_t{1} << kLogLongRow;

template <int Dim>
constexpr std::size_t num_link_vertices(std::size_t facets) {
  return Dim == 2 ? facets : facets / 2 + 2;
}

// A simplex of the star stands on the facet (f0, f1[, f2]) and is (v, f0, f1[, f2]), positively oriented.
// Infinity must be the last corner. In space the order of facets sees to that (Complex::kFacet); in the plane,
// where f0 may be infinity, all corners move up by one place: (f1, v, f0).
template <int Dim>
std::uint32_t shift(const std::array<std::uint32_t, Dim>& facet) {
  return Dim == 2 && facet[0] == 0 ? 1 : 0;
}

// The place of (v, f0, f1, ...)[i] in the record.
template <int Dim>
std::uint32_t place(std::uint32_t i, std::uint32_t shifted) {
  if constexpr (Dim == 3) return i;
  return i + shifted < 3 ? i + shifted : 0;
}

// The side facet opposite f_k contains v and a ridge: in space the directed edge f_{k+1} f_{k+2}, which the
// simplex on its other side sees reversed; in the plane the vertex f_{1-k}, which is the second vertex of one
// edge of the link and the first one of the other. So (row, column) of one side are those of its twin
// exchanged, or k and 1-k.
template <int Dim, int kLogRow>
std::size_t own_entry(const std::array<std::uint32_t, Dim>& local, std::size_t k) {
  if constexpr (Dim == 3) {
    return (std::size_t{local[(k + 1) % 3]} << kLogRow) + local[(k + 2) % 3];
  } else {
    return (k << kLogRow) + local[1 - k];
  }
}
template <int Dim, int kLogRow>
std::size_t twin_entry(const std::array<std::uint32_t, Dim>& local, std::size_t k) {
  if constexpr (Dim == 3) {
    return (std::size_t{local[(k + 2) % 3]} << kLogRow) + local[(k + 1) % 3];
  } else {
    return ((1 - k) << kLogRow) + local[1 - k];
  }
}

}  // namespace

template <int Dim>
void StarLinker<Dim>::substitute(Complex<Dim>& complex, Cavity<Dim>& cavity, Vertex v) {
  try {
    make_room(complex, cavity);
  } catch (...) {
    cavity.release(complex);
    throw;
  }
  plan(complex, cavity);
  const std::size_t num_vertices = num_link_vertices<Dim>(cavity.num_facets());
  if (num_vertices <= kShortRow) {
    number_vertices(complex);
    write_by_table<kLogShortRow>(complex, v);
  } else if (num_vertices <= kLongRow) {
    number_vertices(complex);
    write_by_table<kLogLongRow>(complex, v);
  } else {
    write_by_sorting(complex, v);
  }
  complex.set_incident(v, cavity.star(0));
  for (std::size_t i = cavity.num_facets(); i < cavity.num_simplices(); ++i) complex.release(cavity.simplex(i));
}

// All that needs memory, before anything is changed.
template <int Dim>
void StarLinker<Dim>::make_room(Complex<Dim>& complex, Cavity<Dim>& cavity) {
  const std::size_t num_facets = cavity.num_facets();
  const std::size_t reused = std::min(num_facets, cavity.num_simplices());
  cavity.star_.resize(num_facets);
  planned_.resize(num_facets);
  complex.reserve(num_facets - reused);
  complex.reserve_release(cavity.num_simplices() - reused);
  const std::size_t num_vertices = num_link_vertices<Dim>(num_facets);
  if (num_vertices <= kShortRow) {
    table_.resize(kShortRow * kShortRow);
  } else if (num_vertices <= kLongRow) {
    table_.resize(kLongRow * kLongRow);
  } else {
    sides_.reserve(num_facets * Dim);
  }
}

// Chooses the slots and copies the facets out of the records that are about to be overwritten.
template <int Dim>
void StarLinker<Dim>::plan(Complex<Dim>& complex, Cavity<Dim>& cavity) {
  const std::size_t num_facets = cavity.num_facets();
  const std::size_t reused = std::min(num_facets, cavity.num_simplices());
  for (std::size_t i = 0; i < reused; ++i) cavity.star_[i] = cavity.members_[i] / kCorners;
  for (std::size_t i = reused; i < num_facets; ++i) cavity.star_[i] = complex.allocate().index();

  const auto* const records = complex.records().data();
  auto* const vertices = complex.vertices().data();
  for (std::size_t n = 0; n < num_facets; ++n) {
    const auto [outer, inner] = cavity.facet(n);
    const auto& record = records[inner / kCorners];
    const auto& order = Complex<Dim>::kFacet[inner % kCorners];
    Planned& planned = planned_[n];
    for (std::size_t k = 0; k < Dim; ++k) {
      planned.corner[k] = record.corner[order[k]] & ~Complex<Dim>::kMark;
      vertices[planned.corner[k]].incident = cavity.star_[n];
    }
    planned.outer = outer;
    planned.slot = cavity.star_[n];
  }
}

template <int Dim>
void StarLinker<Dim>::number_vertices(Complex<Dim>& complex) {
  auto* const vertices = complex.vertices().data();
  const std::uint32_t stamp = complex.fresh_stamp(32 - kNumberBits);
  std::uint32_t count = 0;
  for (Planned& planned : planned_) {
    for (std::size_t k = 0; k < Dim; ++k) {
      std::uint32_t& scratch = vertices[planned.corner[k]].scratch;
      const bool is_new = scratch >> kNumberBits != stamp;
      scratch = is_new ? stamp << kNumberBits | count : scratch;
      count += is_new ? 1 : 0;
      planned.local[k] = scratch & ((1U << kNumberBits) - 1);
    }
  }
}

// Corners of the new simplex and the two mates across its facet; the sides are the caller's.
template <int Dim>
void StarLinker<Dim>::write(Complex<Dim>& complex, const Planned& planned, Vertex v) {
  auto* const records = complex.records().data();
  auto& record = records[planned.slot];
  const std::uint32_t shifted = shift<Dim>(planned.corner);
  record.corner[place<Dim>(0, shifted)] = v.slot();
  record.mate[place<Dim>(0, shifted)] = planned.outer;
  for (std::uint32_t k = 0; k < Dim; ++k) record.corner[place<Dim>(k + 1, shifted)] = planned.corner[k];
  records[planned.outer / kCorners].mate[planned.outer % kCorners] =
      planned.slot * kCorners + place<Dim>(0, shifted);
}

// Every entry that is read has been written in this call: the link is closed, so each ridge is seen from both
// sides.
template <int Dim>
template <int kLogRow>
void StarLinker<Dim>::write_by_table(Complex<Dim>& complex, Vertex v) {
  std::uint32_t* const table = table_.data();
  for (const Planned& planned : planned_) {
    const std::uint32_t shifted = shift<Dim>(planned.corner);
    for (std::uint32_t k = 0; k < Dim; ++k) {
      table[own_entry<Dim, kLogRow>(planned.local, k)] = planned.slot * kCorners + place<Dim>(k + 1, shifted);
    }
  }
  auto* const records = complex.records().data();
  for (const Planned& planned : planned_) {
    write(complex, planned, v);
    const std::uint32_t shifted = shift<Dim>(planned.corner);
    for (std::uint32_t k = 0; k < Dim; ++k) {
      records[planned.slot].mate[place<Dim>(k + 1, shifted)] =
          table[twin_entry<Dim, kLogRow>(planned.local, k)];
    }
  }
}

template <int Dim>
void StarLinker<Dim>::write_by_sorting(Complex<Dim>& complex, Vertex v) {
  sides_.clear();
  for (const Planned& planned : planned_) {
    write(complex, planned, v);
    const std::uint32_t shifted = shift<Dim>(planned.corner);
    for (std::uint32_t k = 0; k < Dim; ++k) {
      const std::uint64_t a = planned.corner[(k + 1) % Dim];
      const std::uint64_t b = planned.corner[(k + 2) % Dim];
      const std::uint64_t ridge = Dim == 2 ? a : std::min(a, b) << 32 | std::max(a, b);
      sides_.push_back({ridge, planned.slot * kCorners + place<Dim>(k + 1, shifted)});
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) { return a.ridge < b.ridge; });
  for (std::size_t i = 0; i + 1 < sides_.size(); i += 2) {
    SINKMESH_ASSERT(sides_[i].ridge == sides_[i + 1].ridge);
    complex.set_mates(HalfFacet(sides_[i].half_facet), HalfFacet(sides_[i + 1].half_facet));
  }
}

template class StarLinker<2>;
template class StarLinker<3>;

}  // namespace sinkmesh
