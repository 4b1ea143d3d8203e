// SPDX-License-Identifier: MIT
#include "tools/reproduce/detail/planar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "core/dual.h"

namespace sinkmesh::reproduce::detail {

// A ring of points on a rounded square, a little uneven, and random ones inside: so few triangles at the hull
// are so flat that they would drown the rest.
std::vector<Point2> sample_points() {
  constexpr int kOnRing = 16;
  constexpr std::size_t kCount = 40;
  constexpr double kPi = 3.14159265358979323846;
  // The bits of the engine are specified, those of the standard distributions are not.
  std::mt19937_64 engine(154);
  const auto uniform = [&engine] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  // The norm whose unit circle is the rounded square.
  const auto rounding = [](double x, double y) { return std::cbrt(std::abs(x * x * x) + std::abs(y * y * y)); };
  std::vector<Point2> points;
  for (int k = 0; k < kOnRing; ++k) {
    const double angle = 2 * kPi * (k + 0.5 * uniform()) / kOnRing;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double radius = (1 - 0.03 * uniform()) / rounding(x, y);
    points.push_back({1.1 * radius * x, radius * y});
  }
  while (points.size() < kCount) {
    const double x = 2 * uniform() - 1;
    const double y = 2 * uniform() - 1;
    const Point2 p = {1.1 * x, y};
    const bool is_far = std::all_of(points.begin(), points.end(),
                                    [&](const Point2& q) { return distance2(p, q) >= 0.14 * 0.14; });
    if (rounding(x, y) < 0.87 && is_far) points.push_back(p);
  }
  return points;
}

std::vector<Simplex> solid_triangles(const Complex<2>& complex) {
  std::vector<Simplex> solid;
  for (const Simplex s : complex.simplices()) {
    if (!complex.is_ghost(s)) solid.push_back(s);
  }
  return solid;
}

std::vector<Point2> triangle(const Triangulation<2>& triangulation, Simplex s) {
  std::vector<Point2> corners;
  for (int i = 0; i < 3; ++i) corners.push_back(triangulation.point(triangulation.complex().corner(s, i)));
  return corners;
}

std::vector<std::vector<Point2>> triangles(const Triangulation<2>& triangulation,
                                           std::span<const Simplex> set) {
  std::vector<std::vector<Point2>> result;
  for (const Simplex s : set) result.push_back(triangle(triangulation, s));
  return result;
}

Segment edge(const Triangulation<2>& triangulation, HalfFacet h) {
  const std::array<Vertex, 2> ends = triangulation.complex().facet(h);
  return {triangulation.point(ends[0]), triangulation.point(ends[1])};
}

std::vector<Segment> edges(const Triangulation<2>& triangulation, std::span<const HalfFacet> half_edges) {
  std::vector<Segment> result;
  for (const HalfFacet h : half_edges) result.push_back(edge(triangulation, h));
  return result;
}

std::vector<HalfFacet> edges_of(const Complex<2>& complex, std::span<const Simplex> set) {
  std::vector<HalfFacet> result;
  for (const Simplex s : set) {
    for (int i = 0; i < 3; ++i) {
      const HalfFacet h = Complex<2>::half_facet(s, i);
      result.push_back(std::min(h, complex.mate(h)));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::vector<Point2>> outline(const Triangulation<2>& triangulation,
                                         std::span<const HalfFacet> boundary) {
  // Where polygons touch at a vertex, any way to go on covers the same area.
  std::multimap<Vertex, Vertex> next;
  for (const HalfFacet h : boundary) {
    const std::array<Vertex, 2> ends = triangulation.complex().facet(h);
    next.emplace(ends[0], ends[1]);
  }
  std::vector<std::vector<Point2>> polygons;
  while (!next.empty()) {
    std::vector<Point2>& polygon = polygons.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      const Vertex to = at->second;
      polygon.push_back(triangulation.point(to));
      next.erase(at);
      at = next.find(to);
    }
  }
  return polygons;
}

Ball delaunay_ball(const Triangulation<2>& triangulation, Simplex s) {
  const Point2 center = dual_vertex(triangulation, s);
  return {center, distance2(center, triangulation.point(triangulation.complex().corner(s, 0)))};
}

Ball incircle(const std::vector<Point2>& triangle) {
  std::array<double, 3> side;  // opposite the corner
  for (std::size_t i = 0; i < 3; ++i) {
    side[i] = std::sqrt(distance2(triangle[(i + 1) % 3], triangle[(i + 2) % 3]));
  }
  const double around = side[0] + side[1] + side[2];
  Point2 center = {0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 2; ++k) center[k] += side[i] / around * triangle[i][k];
  }
  const double half = around / 2;
  return {center, std::max(0.0, (half - side[0]) * (half - side[1]) * (half - side[2]) / half)};
}

Box<2> bounding_box(std::span<const Point2> points) {
  Box<2> box;
  for (const Point2& p : points) box.include(p);
  return box;
}

double distance2(const Point2& p, const Point2& q) {
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

std::vector<Point2> place(const Frame& frame, const std::vector<Point2>& polygon) {
  std::vector<Point2> result;
  for (const Point2& p : polygon) result.push_back(frame(p));
  return result;
}

std::vector<std::vector<Point2>> place(const Frame& frame, std::vector<std::vector<Point2>> polygons) {
  for (std::vector<Point2>& polygon : polygons) polygon = place(frame, polygon);
  return polygons;
}

std::vector<Segment> place(const Frame& frame, std::vector<Segment> segments) {
  for (auto& [p, q] : segments) {
    p = frame(p);
    q = frame(q);
  }
  return segments;
}

std::vector<Ellipse> place_balls(const Frame& frame, const Triangulation<2>& triangulation,
                                 std::span<const Simplex> set) {
  std::vector<Ellipse> result;
  for (const Simplex s : set) {
    const Ball ball = delaunay_ball(triangulation, s);
    const double radius = frame.scale() * std::sqrt(ball.radius2);
    result.push_back({frame(ball.center), radius, radius});
  }
  return result;
}

}  // namespace sinkmesh::reproduce::detail
