// SPDX-License-Identifier: MIT
//
// The pieces of the facets of a surface, and how they hang together [BR, 3].
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/complex.h"
#include "core/mix.h"

namespace sinkmesh {

/// A piece of a facet of the surface: a triangle in space, a part of a segment in the plane.
using SubFacet = Handle<struct SubFacetTag>;

/// Sub-facets by their vertices. In space also who lies around each edge, any number of them, and which edges
/// are parts of segments. Knows no geometry and no triangulation but a half-facet that its user keeps for each.
template <int Dim>
class SubFacets {
 public:
  using Corners = std::array<Vertex, Dim>;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Record {
    Corners corners{};         ///< in space counterclockwise in the projection of the patch
    std::uint32_t owner = 0;   ///< patch; in the plane segment
    std::uint32_t parent = 0;  ///< facet of the surface; in a patch of several, one of them (see Parents)
    std::uint32_t birth = 0;   ///< no two sub-facets in the same slot share it
    HalfFacet at;              ///< where it is in the triangulation; null: missing
    // In space, by corner, for the edge opposite it:
    std::array<std::uint32_t, Dim> next{};     ///< the next of those around it, as 3 * sub-facet + corner
    std::array<std::uint32_t, Dim> segment{};  ///< of which it is a part, or kNone
  };
  /// An edge of a sub-facet, opposite its corner k.
  struct Side {
    SubFacet facet;
    std::size_t k;
  };

  /// Of the record, `next` and `birth` are set here.
  SubFacet add(const Record& record);
  void remove(SubFacet f);

  /// The other sub-facet at the side of f opposite corner k, if there is exactly one; else a null one.
  Side across(SubFacet f, std::size_t k) const {
    const std::uint32_t next = records_[f.index()].next[k];
    const bool is_pair = next / 3 != f.index() && records_[next / 3].next[next % 3] == 3 * f.index() + k;
    return is_pair ? Side{SubFacet(next / 3), next % 3} : Side{SubFacet(), 0};
  }

  const Record& operator[](SubFacet f) const { return records_[f.index()]; }
  void set_at(SubFacet f, HalfFacet at) { records_[f.index()].at = at; }
  bool is_alive(SubFacet f) const { return records_[f.index()].owner != kNone; }
  bool is_current(SubFacet f, std::uint32_t birth) const {
    return is_alive(f) && records_[f.index()].birth == birth;
  }
  std::size_t size() const { return records_.size() - free_.size(); }

  /// The sub-facet with these vertices, or null. Expected constant time.
  SubFacet find(const Corners& corners) const;
  /// In space: a sub-facet at the edge, or null; in the plane the sub-facet uv itself.
  SubFacet find_edge(Vertex u, Vertex v) const;
  /// All sub-facets at an edge, each with the corner opposite it. Requires space.
  std::vector<Side> around(Vertex u, Vertex v) const;
  /// The segment of which uv is a part, or kNone.
  std::uint32_t segment_of(Vertex u, Vertex v) const;

  /// Calls visit(f) for all of them, by slot.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::uint32_t i = 0; i < records_.size(); ++i) {
      if (records_[i].owner != kNone) visit(SubFacet(i));
    }
  }

 private:
  struct Hash {
    std::size_t operator()(std::uint64_t key) const { return static_cast<std::size_t>(mix(key)); }
  };
  static std::uint64_t key_of(Vertex u, Vertex v) {
    return static_cast<std::uint64_t>(std::min(u, v).slot()) << 32 | std::max(u, v).slot();
  }
  std::uint64_t key_opposite(SubFacet f, std::size_t k) const {
    const Corners& c = records_[f.index()].corners;
    return key_of(c[(k + 1) % Dim], c[(k + 2) % Dim]);
  }

  std::vector<Record> records_;
  std::vector<std::uint32_t> free_;
  /// In space one of the sides at an edge; in the plane the sub-facet.
  std::unordered_map<std::uint64_t, std::uint32_t, Hash> edges_;
  std::uint32_t births_ = 0;
};

}  // namespace sinkmesh
