// SPDX-License-Identifier: MIT
//
// Typed indices. Trivially copyable, four bytes, and meaningless without their complex.
#pragma once

#include <compare>
#include <cstdint>
#include <ostream>

namespace sinkmesh {

/// Handles of different kinds neither compare nor convert: `simplex == vertex` does not compile. A handle
/// survives every operation that leaves its simplex alive, except compact().
template <class Tag>
class Handle {
 public:
  constexpr Handle() = default;  // null
  constexpr explicit Handle(std::uint32_t index) : index_(index) {}

  constexpr std::uint32_t index() const { return index_; }
  constexpr bool is_null() const { return index_ == kNull; }
  friend constexpr auto operator<=>(Handle, Handle) = default;

 private:
  static constexpr std::uint32_t kNull = ~std::uint32_t{0};
  std::uint32_t index_ = kNull;
};

/// A Dim-simplex: a triangle in the plane, a tetrahedron in space; solid, or a ghost.
using Simplex = Handle<struct SimplexTag>;

/// One facet seen from one of the two simplices that share it. Half-facet (Dim+1)*s+i is the facet of simplex s
/// opposite its corner i. Owner and number are arithmetic (Complex<Dim>::simplex_of, corner_of); only the mate
/// is stored.
using HalfFacet = Handle<struct HalfFacetTag>;

/// A vertex. index() is the id: that of the input point, or the number of earlier vertices for a Steiner point.
/// The vertex at infinity has no id; it is stored as slot 0, before all others, so that every array of vertices
/// holds it and no loop over corners tests for it.
class Vertex {
 public:
  constexpr Vertex() = default;  // null
  constexpr explicit Vertex(std::uint32_t id) : slot_(id + 1) {}
  static constexpr Vertex at_slot(std::uint32_t slot) { return Vertex(slot - 1); }
  static constexpr Vertex infinite() { return at_slot(0); }

  constexpr std::uint32_t index() const { return slot_ - 1; }
  constexpr std::uint32_t slot() const { return slot_; }
  constexpr bool is_infinite() const { return slot_ == 0; }
  constexpr bool is_null() const { return slot_ == kNull; }
  friend constexpr auto operator<=>(Vertex, Vertex) = default;

 private:
  static constexpr std::uint32_t kNull = ~std::uint32_t{0};
  std::uint32_t slot_ = kNull;
};

inline std::ostream& operator<<(std::ostream& out, Vertex v) {
  if (v.is_null()) return out << "no vertex";
  if (v.is_infinite()) return out << "infinity";
  return out << 'v' << v.index();
}
inline std::ostream& operator<<(std::ostream& out, Simplex s) {
  return s.is_null() ? out << "no simplex" : out << 's' << s.index();
}
inline std::ostream& operator<<(std::ostream& out, HalfFacet h) {
  return h.is_null() ? out << "no half-facet" : out << 'h' << h.index();
}

}  // namespace sinkmesh
