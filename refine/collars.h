// SPDX-License-Identifier: MIT
//
// Spheres around corners where small angles meet in a web that conforming alone cannot take apart [BR, 9].
#pragma once

#include <array>
#include <map>
#include <span>

#include "core/complex.h"
#include "refine/boundary.h"

namespace sinkmesh {

/// Corners with a sphere around each, inside which no point of the boundary is put: segments are divided where
/// they leave it, and facets on it, by points as far from the corner as all others. A sub-facet between the
/// corner and two such points is Gabriel as soon as no other point of the sphere lies in the cap above the arc
/// between them [BR, Lemma 3], and nothing outside is in the sliver of its diametral sphere beyond the arc:
/// dividing arcs is enough, as dividing segments is in the plane, and equal pieces at the ends of arcs leave
/// each other alone there, too.
class Collars {
 public:
  /// Of the corner; gated. 0 if it has none.
  double radius(Vertex corner) const {
    const auto found = radii_.find(corner);
    return found == radii_.end() ? 0 : found->second;
  }
  bool empty() const { return radii_.empty(); }
  auto begin() const { return radii_.begin(); }
  auto end() const { return radii_.end(); }

  /// Adds the corners of a surface at which sub-facets have become far smaller than the segments there: two
  /// fifths of the distance from all features that do not have the corner.
  /// @param facets  of the surface
  /// @return whether there was one that had no collar.
  template <int Dim>
  bool add_crowded(const Boundary<Dim>& boundary, std::span<const typename Boundary<Dim>::Facet> facets);

 private:
  std::map<Vertex, double> radii_;
};

extern template bool Collars::add_crowded<2>(const Boundary<2>&, std::span<const Boundary<2>::Facet>);
extern template bool Collars::add_crowded<3>(const Boundary<3>&, std::span<const Boundary<3>::Facet>);

}  // namespace sinkmesh
