// SPDX-License-Identifier: MIT
//
// A solid given by a function, for SurfaceSampler.
#pragma once

#include <vector>

#include "predicates/point.h"

namespace sinkmesh::models {

/// A bounded solid { p : value(p) < 0 } whose surface is a topological sphere, and how finely to sample it.
class ImplicitSolid {
 public:
  virtual ~ImplicitSolid() = default;

  /// Negative inside, positive outside, continuous. Need not be a distance.
  virtual double value(const Point3& p) const = 0;
  /// Wanted circumradius of the triangles around a point of the surface, up to a common factor.
  virtual double size(const Point3& p) const = 0;
  /// Wanted bound on r/l of the triangles; exceeded only where there is no room.
  virtual double max_ratio() const = 0;
  /// The point of the surface nearest to p, about; p is on it up to rounding.
  virtual Point3 onto(const Point3& p) const = 0;

  /// Points of the surface to begin with, spread over it and not in one plane; sharp edges are given here and
  /// never divided. `vertices` says how many the surface will have.
  virtual std::vector<Point3> seeds(std::size_t vertices) const = 0;
  /// Whether p keeps its distance from the sharp edges, so that these remain edges of the surface.
  virtual bool is_clear_of_edges(const Point3& p, std::size_t vertices) const = 0;
  /// p and -p are both on the surface or both not; points are then added in such pairs.
  virtual bool is_centrally_symmetric() const = 0;
};

}  // namespace sinkmesh::models
