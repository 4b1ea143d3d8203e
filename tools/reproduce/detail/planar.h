// SPDX-License-Identifier: MIT
//
// From triangulations in the plane to shapes that can be drawn, in the units of the input.
#pragma once

#include <span>
#include <vector>

#include "core/triangulation.h"
#include "tools/reproduce/svg_canvas.h"

namespace sinkmesh::reproduce::detail {

/// A few dozen points, the same ones on every machine, not too close to each other: the example of the figures
/// that need no data set.
std::vector<Point2> sample_points();

/// The solid triangles, by index.
std::vector<Simplex> solid_triangles(const Complex<2>& complex);

std::vector<Point2> triangle(const Triangulation<2>& triangulation, Simplex s);
std::vector<std::vector<Point2>> triangles(const Triangulation<2>& triangulation, std::span<const Simplex> set);
Segment edge(const Triangulation<2>& triangulation, HalfFacet h);
std::vector<Segment> edges(const Triangulation<2>& triangulation, std::span<const HalfFacet> half_edges);
/// The edges of a set of triangles, each once.
std::vector<HalfFacet> edges_of(const Complex<2>& complex, std::span<const Simplex> set);

/// Half-edges of a boundary, joined to closed polygons.
std::vector<std::vector<Point2>> outline(const Triangulation<2>& triangulation,
                                         std::span<const HalfFacet> boundary);

/// The Delaunay ball of a solid triangle [EG01, 2.3].
struct Ball {
  Point2 center;
  double radius2;
};
Ball delaunay_ball(const Triangulation<2>& triangulation, Simplex s);
/// The point of a triangle where its three bisectors of angles meet, and its distance from the edges.
Ball incircle(const std::vector<Point2>& triangle);

Box<2> bounding_box(std::span<const Point2> points);
double distance2(const Point2& p, const Point2& q);

// The same shapes in the picture.
std::vector<Point2> place(const Frame& frame, const std::vector<Point2>& polygon);
std::vector<std::vector<Point2>> place(const Frame& frame, std::vector<std::vector<Point2>> polygons);
std::vector<Segment> place(const Frame& frame, std::vector<Segment> segments);
/// The Delaunay balls of a set: as one shape, their union, the flower [EG01, 4.1].
std::vector<Ellipse> place_balls(const Frame& frame, const Triangulation<2>& triangulation,
                                 std::span<const Simplex> set);

}  // namespace sinkmesh::reproduce::detail
