// SPDX-License-Identifier: MIT
//
// What goes in: surfaces that bound solids in space, a straight-line graph in the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "predicates/error.h"
#include "predicates/point.h"

namespace sinkmesh {

/// Points that say what the parts of space are which a surface encloses.
template <int Dim>
struct Seeds {
  struct Region {
    Point<Dim> point;
    std::int64_t tag = 0;
  };
  std::vector<Point<Dim>> holes;
  std::vector<Region> regions;

  bool empty() const { return holes.empty() && regions.empty(); }
};

/// Facets over an indexed set of points. Units and ids are the user's.
template <int Dim>
struct Surface {
  using Facet = std::array<std::uint32_t, Dim>;

  std::vector<Point<Dim>> points;
  std::vector<Facet> facets;

  /// One per facet, or none at all. The pieces of a facet carry its tag; facets with different tags are never
  /// joined to one patch.
  std::vector<std::int64_t> facet_tags = {};
  /// If there are any, every bounded region is inside but those that hold a hole; else parity decides (Domain).
  Seeds<Dim> seeds = {};
};
using Surface2 = Surface<2>;
using Surface3 = Surface<3>;

/// The surface cannot be used because of some facets, which the message names.
class FacetError : public InputError {
 public:
  FacetError(std::size_t facet, const std::string& message) : InputError(message), facet_(facet) {}

  /// The first of them.
  std::size_t facet() const { return facet_; }

 private:
  std::size_t facet_;
};

/// The surface cannot be used because of one of its seeds, which the message names.
class SeedError : public InputError {
 public:
  enum class Kind : std::uint8_t { hole, region };

  SeedError(Kind kind, std::size_t seed, const std::string& message)
      : InputError(message), kind_(kind), seed_(seed) {}

  Kind kind() const { return kind_; }
  /// Its place among those of its kind.
  std::size_t seed() const { return seed_; }

 private:
  Kind kind_;
  std::size_t seed_;
};

}  // namespace sinkmesh
