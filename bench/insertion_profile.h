// SPDX-License-Identifier: MIT
//
// What an insertion of a bulk load does, on average: counted in a load of its own, which is not timed.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "core/bulk_search.h"
#include "core/first_simplex.h"
#include "core/flip_inserter.h"
#include "core/spatial_order.h"
#include "core/star_linker.h"
#include "core/triangulation.h"
#include "predicates/input_gate.h"

namespace sinkmesh::bench {

struct InsertionProfile {
  double steps = 0;    ///< simplices visited by the walk
  double prestar = 0;  ///< simplices
  double star = 0;     ///< simplices
  double flips = 0;    ///< without subdivisions; of the engine that flips only
};

/// As Triangulation loads the points, and in its order.
template <int Dim>
InsertionProfile profile_insertions(const std::vector<Point<Dim>>& points, Engine engine) {
  const InputGate<Dim> gate(points);
  std::vector<Point<Dim>> gated(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) gated[i] = gate.in(points[i]);
  const Predicates<Dim> predicates(gate.box(), gate.granularity());
  InsertionOrder sorted = insertion_order<Dim>(gated, gate.box());
  Complex<Dim> complex;
  make_first_simplex<Dim>(complex, predicates, gated, sorted.order);

  BulkSearch<Dim> search;
  Cavity<Dim> cavity;
  StarLinker<Dim> linker;
  FlipInserter<Dim> flipper;
  InsertionProfile sum;
  Simplex hint(0);
  for (std::uint32_t i = Dim + 1; i < complex.num_vertices(); ++i) {
    const Vertex v(i);
    const Point<Dim> p = complex.point(v);
    if (engine == Engine::star) {
      cavity.grow(complex, predicates, p, search.find(complex, predicates, p));
      sum.steps += search.last_walk();
      sum.prestar += static_cast<double>(cavity.num_simplices());
      sum.star += static_cast<double>(cavity.num_facets());
      linker.substitute(complex, cavity, v);
      search.settle(complex, cavity, v);
    } else {
      const Location<Dim> at = walk_to(complex, predicates, p, hint);
      sum.steps += at.steps;
      flipper.insert(complex, predicates, at, v);
      hint = complex.incident_simplex(v);
    }
  }
  const auto& counts = flipper.counts();
  sum.flips =
      static_cast<double>(counts.two_to_two + counts.two_to_three + counts.three_to_two + counts.four_to_four);
  const auto inserted = static_cast<double>(complex.num_vertices()) - (Dim + 1);
  return {sum.steps / inserted, sum.prestar / inserted, sum.star / inserted, sum.flips / inserted};
}

}  // namespace sinkmesh::bench
