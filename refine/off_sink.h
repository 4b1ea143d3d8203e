// SPDX-License-Identifier: MIT
//
// Off-sinks: how far along the flow a point is put [OS, 0].
#pragma once

#include <array>
#include <optional>

#include "refine/flow.h"
#include "refine/steepest_order.h"

namespace sinkmesh {

/// Where a chain was left.
template <int Dim>
struct OffSink {
  Simplex simplex;  ///< the point lies strictly inside its circumsphere, but for rounding
  Point<Dim> point{};
  double distance2 = 0;  ///< squared, from the nearest vertices
};

/// Follows the chain of a simplex: the midpoint of its shortest edge, its circumcenter, that of its steepest
/// successor, and so on, until a sink.
///
/// From the circumcenter of a simplex to that of its successor the chain is a piece of the Voronoi edge of the
/// facet between the two, so the nearest vertices of each point on it are the corners of that facet, and their
/// distance grows along the way. Before the first circumcenter the point is off-center in the sense of
/// [U04], and a vertex may be nearer than the ends of the shortest edge.
///
/// Holds working memory only; keep one and reuse it.
template <int Dim>
class OffSinkWalk {
 public:
  /// The first point of the chain that is at the given distance from the vertices to which it belongs, or the
  /// center of the sink, if that comes before. A function of the geometry alone.
  /// @param reach2  squared distance; more than a quarter of the squared shortest edge of s.
  /// @return nothing, if the flow leads outside, or the center is out of the range of Steiner points.
  /// Cost: linear in the length of the chain, which in the mean is below 3.
  std::optional<OffSink<Dim>> operator()(Flow<Dim>& flow, Simplex s, double reach2);

 private:
  std::optional<HalfFacet> steepest(Flow<Dim>& flow, Simplex s);

  std::array<Simplex, Dim + 1> successors_{};
  SteepestOrder<Dim> order_;
};

extern template class OffSinkWalk<2>;
extern template class OffSinkWalk<3>;

}  // namespace sinkmesh
