// SPDX-License-Identifier: MIT
//
// The half-facet complex: who shares a facet with whom.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include "core/detail/pod_array.h"
#include "core/handles.h"
#include "predicates/error.h"
#include "predicates/point.h"

namespace sinkmesh {

/// A triangulated Dim-sphere: the solid simplices of the convex hull of the vertices, and one ghost per hull
/// facet between it and the vertex at infinity, so that mate() is total and no traversal tests for a border.
/// Knows no predicate: operations say what is connected, Triangulation<Dim> decides what should be.
///
/// One flat record per simplex: the vertices of its corners and the mates of its half-facets, 32 bytes in
/// space. Records of deleted simplices wait in a free list and are reused last in, first out.
///
/// Invariants, checked by Triangulation::validate():
///   I1  mate(mate(h)) == h, and mate(h) belongs to another live simplex.
///   I2  h and mate(h) have the same corners in opposite orientation.
///   I3  The corners of a simplex are distinct; only the last one may be the vertex at infinity.
///   I4  incident_simplex(v) is alive and has v as a corner, for every vertex that is in the complex.
///   I5  No mark of an unfinished operation is left.
template <int Dim>
class Complex {
 public:
  static constexpr int kCorners = Dim + 1;

  struct Record {
    std::array<std::uint32_t, kCorners> corner;  // slots of vertices
    std::array<std::uint32_t, kCorners> mate;    // half-facets
  };

  /// Coordinates (behind the input gate), one incident simplex, and a scratch word for linking a star.
  struct VertexRecord {
    Point<Dim> point;
    std::uint32_t incident;
    std::uint32_t scratch;
  };

  /// The corners of facet i, in the order in which they are counterclockwise seen from outside the simplex.
  /// With the apex in front they give the simplex again, positively oriented: (i, kFacet[i][0], ...) is an even
  /// permutation. In space corner Dim, the place of infinity, comes last in every facet that has it; in the
  /// plane facet 1 has it first.
  static constexpr std::array<std::array<std::uint8_t, Dim>, kCorners> kFacet = [] {
    if constexpr (Dim == 2) {
      return std::array<std::array<std::uint8_t, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
    } else {
      return std::array<std::array<std::uint8_t, 3>, 4>{{{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {1, 0, 2}}};
    }
  }();

  // -- arithmetic of handles

  static constexpr Simplex simplex_of(HalfFacet h) { return Simplex(h.index() / kCorners); }
  /// The number of the corner opposite h.
  static constexpr int corner_of(HalfFacet h) { return static_cast<int>(h.index() % kCorners); }
  static constexpr HalfFacet half_facet(Simplex s, int i) {
    return HalfFacet(s.index() * kCorners + static_cast<std::uint32_t>(i));
  }

  // -- queries, all constant time

  /// Simplices alive, ghosts included.
  std::size_t num_simplices() const { return records_.size() - free_.size(); }
  /// One more than the largest index of a simplex so far.
  std::size_t num_slots() const { return records_.size(); }
  /// Vertices with an id, those in no simplex (duplicates, removed ones) included; infinity is not counted.
  std::size_t num_vertices() const { return vertices_.empty() ? 0 : vertices_.size() - 1; }

  bool is_alive(Simplex s) const { return records_[s.index()].corner[0] != kDead; }
  bool is_ghost(Simplex s) const { return records_[s.index()].corner[Dim] == 0; }
  bool is_solid(Simplex s) const { return is_alive(s) && !is_ghost(s); }

  Vertex corner(Simplex s, int i) const { return Vertex::at_slot(slot(s, i)); }
  /// The corner opposite h.
  Vertex apex(HalfFacet h) const { return corner(simplex_of(h), corner_of(h)); }
  HalfFacet mate(HalfFacet h) const {
    return HalfFacet(records_[simplex_of(h).index()].mate[static_cast<std::size_t>(corner_of(h))]);
  }
  Simplex neighbor(Simplex s, int i) const { return simplex_of(mate(half_facet(s, i))); }
  /// Vertices of a facet, counterclockwise seen from outside its simplex.
  std::array<Vertex, Dim> facet(HalfFacet h) const {
    std::array<Vertex, Dim> vertices;
    for (int k = 0; k < Dim; ++k) vertices[k] = corner(simplex_of(h), kFacet[corner_of(h)][k]);
    return vertices;
  }
  /// The number of the corner of s that is v, or -1.
  int index_of(Simplex s, Vertex v) const {
    for (int i = 0; i < kCorners; ++i) {
      if (slot(s, i) == v.slot()) return i;
    }
    return -1;
  }

  const Point<Dim>& point(Vertex v) const { return vertices_[v.slot()].point; }
  /// A simplex that has v as a corner; null if v is in none (a duplicate, or removed).
  Simplex incident_simplex(Vertex v) const { return Simplex(vertices_[v.slot()].incident); }
  /// Requires a solid simplex.
  Corners<Dim> corners(Simplex s) const {
    Corners<Dim> points;
    points[0] = &vertices_[slot(s, 0)].point;  // only here there may be a mark
    for (std::size_t i = 1; i < kCorners; ++i) points[i] = &vertices_[records_[s.index()].corner[i]].point;
    return points;
  }
  /// Requires a facet without the vertex at infinity.
  FacetCorners<Dim> facet_corners(HalfFacet h) const {
    FacetCorners<Dim> points;
    const std::array<Vertex, Dim> vertices = facet(h);
    for (int k = 0; k < Dim; ++k) points[k] = &vertices_[vertices[k].slot()].point;
    return points;
  }

  /// The simplices alive, in the order of their indices: `for (Simplex s : complex.simplices())`.
  class SimplexRange;
  SimplexRange simplices() const;

  // -- building blocks of the operations that keep the invariants (star substitution, flips, bulk loading)

  /// Makes sure that `count` more simplices can be allocated without an exception.
  /// @throws CapacityError when half-facets would no longer fit 32 bits, std::bad_alloc.
  void reserve(std::size_t count) {
    if (count <= free_.size()) return;
    const std::size_t needed = records_.size() + count - free_.size();
    if (needed <= records_.capacity()) return;
    if (needed > kMaxSimplices) throw CapacityError("more than 2^30 simplices: the complex is full");
    records_.reserve(std::max(needed, records_.capacity() + records_.capacity() / 2));
  }
  /// A record to fill in; the caller writes corners and mates. Requires reserve().
  Simplex allocate() {
    if (!free_.empty()) {
      const Simplex s(free_.back());
      free_.pop_back();
      return s;
    }
    SINKMESH_ASSERT(records_.size() < records_.capacity());
    records_.resize(records_.size() + 1);
    return Simplex(static_cast<std::uint32_t>(records_.size() - 1));
  }
  void release(Simplex s) {
    records_[s.index()].corner[0] = kDead;
    free_.push_back(s.index());
  }
  /// Makes sure that `count` simplices can be released without an exception.
  void reserve_release(std::size_t count) {
    const std::size_t needed = free_.size() + count;
    if (needed > free_.capacity()) free_.reserve(std::max(needed, 2 * free_.capacity()));
  }
  /// Takes away all simplices and vertices; keeps the memory.
  void clear() {
    records_.clear();
    vertices_.clear();
    free_.clear();
  }
  /// Appends a vertex that is in no simplex yet.
  Vertex add_vertex(const Point<Dim>& p) {
    if (vertices_.empty()) vertices_.push_back({Point<Dim>{}, kNone, 0});  // infinity
    if (vertices_.size() >= kMaxVertices) throw CapacityError("more than 2^31 vertices: the complex is full");
    vertices_.push_back({p, kNone, 0});
    return Vertex::at_slot(static_cast<std::uint32_t>(vertices_.size() - 1));
  }
  /// Turns an empty complex into one solid simplex and its ghosts. Requires positively oriented corners.
  Simplex make_sphere(const std::array<Vertex, kCorners>& corners);
  void set_mates(HalfFacet g, HalfFacet h) {
    records_[simplex_of(g).index()].mate[static_cast<std::size_t>(corner_of(g))] = h.index();
    records_[simplex_of(h).index()].mate[static_cast<std::size_t>(corner_of(h))] = g.index();
  }
  void set_incident(Vertex v, Simplex s) { vertices_[v.slot()].incident = s.index(); }

  /// A number of `bits` bits, not 0, that no scratch word of a vertex holds in its upper bits: for numbering
  /// the vertices of one operation without a pass that resets them. Constant time, but for one pass in 2^bits
  /// calls.
  std::uint32_t fresh_stamp(int bits) {
    if (++stamp_ >> bits != 0) {
      for (VertexRecord& vertex : vertices_) vertex.scratch = 0;
      stamp_ = 1;
    }
    return stamp_;
  }

  /// Raw arrays, for the loops that measurement proved to need them and for tests that break invariants on
  /// purpose.
  detail::PodArray<Record>& records() { return records_; }
  const detail::PodArray<Record>& records() const { return records_; }
  detail::PodArray<VertexRecord>& vertices() { return vertices_; }
  const detail::PodArray<VertexRecord>& vertices() const { return vertices_; }
  const detail::PodArray<std::uint32_t>& free_slots() const { return free_; }

  /// Renumbers the simplices alive to 0, 1, 2, ... in their order and drops the free list. Handles of simplices
  /// and half-facets change; vertices keep theirs. Linear.
  void compact();

  std::size_t bytes() const { return records_.bytes() + vertices_.bytes() + free_.bytes(); }

  /// The highest bit of corner 0 marks a simplex during an operation; it is clear between operations.
  static constexpr std::uint32_t kMark = std::uint32_t{1} << 31;

 private:
  static constexpr std::uint32_t kDead = 0;  // in corner 0, where infinity never is (I3)
  static constexpr std::uint32_t kNone = Simplex().index();
  static constexpr std::size_t kMaxSimplices = std::size_t{1} << 30;
  static constexpr std::size_t kMaxVertices = std::size_t{1} << 31;

  std::uint32_t slot(Simplex s, int i) const {
    return records_[s.index()].corner[static_cast<std::size_t>(i)] & ~kMark;
  }

  detail::PodArray<Record> records_;
  detail::PodArray<VertexRecord> vertices_;
  detail::PodArray<std::uint32_t> free_;
  std::uint32_t stamp_ = 0;
};

template <int Dim>
class Complex<Dim>::SimplexRange {
 public:
  class Iterator {
   public:
    using value_type = Simplex;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    using pointer = const Simplex*;
    using reference = Simplex;

    Iterator() = default;
    Iterator(const Complex* complex, std::size_t index) : complex_(complex), index_(index) { skip_dead(); }
    Simplex operator*() const { return Simplex(static_cast<std::uint32_t>(index_)); }
    Iterator& operator++() {
      ++index_;
      skip_dead();
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    void skip_dead() {
      while (index_ < complex_->num_slots() &&
             !complex_->is_alive(Simplex(static_cast<std::uint32_t>(index_)))) {
        ++index_;
      }
    }
    const Complex* complex_ = nullptr;
    std::size_t index_ = 0;
  };

  explicit SimplexRange(const Complex& complex) : complex_(&complex) {}
  Iterator begin() const { return {complex_, 0}; }
  Iterator end() const { return {complex_, complex_->num_slots()}; }

 private:
  const Complex* complex_;
};

template <int Dim>
auto Complex<Dim>::simplices() const -> SimplexRange {
  return SimplexRange(*this);
}

extern template class Complex<2>;
extern template class Complex<3>;

}  // namespace sinkmesh
