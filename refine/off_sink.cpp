// SPDX-License-Identifier: MIT
#include "refine/off_sink.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "predicates/constructions.h"
#include "predicates/input_gate.h"
#include "refine/quality.h"

namespace sinkmesh {
namespace {

// from + distance direction / |direction|. Gated simplices are not so flat that the square of a vector to their
// centers would overflow: below 2^754.
template <int Dim>
Point<Dim> at_distance(Point<Dim> from, const Point<Dim>& direction, double distance) {
  const double scale = distance / std::sqrt(dot(direction, direction));
  for (std::size_t k = 0; k < Dim; ++k) from[k] += scale * direction[k];
  return from;
}

// Between the midpoint of the shortest edge and the circumcenter, in the plane that halves that edge.
template <int Dim>
Point<Dim> off_center(Corners<Dim> corners, double reach2) {
  const auto by_point = [](const Point<Dim>* a, const Point<Dim>* b) { return *a < *b; };
  std::sort(corners.begin(), corners.end(), by_point);
  double shortest2 = HUGE_VAL;
  Point<Dim> middle{};
  for (std::size_t i = 0; i <= Dim; ++i) {
    for (std::size_t j = i + 1; j <= Dim; ++j) {
      const double length2 = squared_distance(*corners[i], *corners[j]);
      if (length2 >= shortest2) continue;
      shortest2 = length2;
      for (std::size_t k = 0; k < Dim; ++k) middle[k] = ((*corners[i])[k] + (*corners[j])[k]) / 2;
    }
  }
  middle = on_grid<Dim>(middle);
  return at_distance<Dim>(middle, vector_to_circumcenter<Dim>(corners, middle),
                          std::sqrt(reach2 - shortest2 / 4));
}

// On the Voronoi edge of a facet, on the side from which it is counterclockwise. What is rounded here does not
// depend on the order of the corners.
template <int Dim>
Point<Dim> on_voronoi_edge(const FacetCorners<Dim>& facet, double reach2) {
  return at_distance<Dim>(facet_center<Dim>(facet), facet_normal<Dim>(facet),
                          std::sqrt(std::max(0.0, reach2 - facet_shape<Dim>(facet).radius2)));
}

}  // namespace

template <int Dim>
std::optional<HalfFacet> OffSinkWalk<Dim>::steepest(Flow<Dim>& flow, Simplex s) {
  const Complex<Dim>& complex = flow.complex();
  std::size_t count = 0;
  for (int i = 0; i <= Dim; ++i) {
    if (flow.crosses(Complex<Dim>::half_facet(s, i))) successors_[count++] = complex.neighbor(s, i);
  }
  if (count == 0) return std::nullopt;
  order_.sort(complex, std::span(successors_).first(count));
  for (int i = 0; i <= Dim; ++i) {
    if (complex.neighbor(s, i) == successors_[count - 1]) return Complex<Dim>::half_facet(s, i);
  }
  return std::nullopt;
}

template <int Dim>
std::optional<OffSink<Dim>> OffSinkWalk<Dim>::operator()(Flow<Dim>& flow, Simplex s, double reach2) {
  const Complex<Dim>& complex = flow.complex();
  double radius2 = shape<Dim>(complex.corners(s)).radius2;
  if (radius2 >= reach2)
    return OffSink<Dim>{s, on_grid<Dim>(off_center<Dim>(complex.corners(s), reach2)), reach2};
  while (const auto exit = steepest(flow, s)) {
    s = Complex<Dim>::simplex_of(complex.mate(*exit));
    if (complex.is_ghost(s)) return std::nullopt;
    radius2 = shape<Dim>(complex.corners(s)).radius2;
    if (radius2 >= reach2) {
      return OffSink<Dim>{s, on_grid<Dim>(on_voronoi_edge<Dim>(complex.facet_corners(*exit), reach2)), reach2};
    }
  }
  Point<Dim> center;
  if (!circumcenter(complex.corners(s), center)) return std::nullopt;
  return OffSink<Dim>{s, center, radius2};
}

template class OffSinkWalk<2>;
template class OffSinkWalk<3>;

}  // namespace sinkmesh
