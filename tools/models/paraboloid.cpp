// SPDX-License-Identifier: MIT
//
// The solid x^2 + y^2 <= z <= 1.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/vector.h"
#include "tools/models/models.h"
#include "tools/models/surface_sampler.h"

namespace sinkmesh::models {
namespace {

// The size grows from the middle of the lid: kSmallest + kGrowth * distance^kPower. That is what gives the
// tetrahedra the range of r/l the paper has.
constexpr double kSmallest = 0.0052;
constexpr double kGrowth = 0.068;
constexpr double kPower = 1.25;
// Points on the rim for the paper's 6,272 triangles; they grow like the square root.
constexpr double kRimPoints = 110;
constexpr double kPaperVertices = 3138;

double rim_points(std::size_t vertices) {
  return std::round(kRimPoints * std::sqrt(static_cast<double>(vertices) / kPaperVertices));
}

class Solid final : public ImplicitSolid {
 public:
  double value(const Point3& p) const override {
    const double r2 = p[0] * p[0] + p[1] * p[1];
    return std::max((r2 - p[2]) / std::sqrt(1 + 4 * r2), p[2] - 1);
  }

  double size(const Point3& p) const override {
    return kSmallest + kGrowth * std::pow(std::sqrt(squared_distance(p, Point3{0, 0, 1})), kPower);
  }

  double max_ratio() const override { return 1.2; }

  Point3 onto(const Point3& p) const override {
    const double r2 = p[0] * p[0] + p[1] * p[1];
    return {p[0], p[1], r2 < 1 && p[2] > 0.5 * (1 + r2) ? 1 : r2};
  }

  std::vector<Point3> seeds(std::size_t vertices) const override {
    std::vector<Point3> seeds;
    const double n = rim_points(vertices);
    for (double i = 0; i < n; ++i) {
      // Not quite evenly, since the vertices of a regular polygon are cocircular with any of its mirror images.
      const double t = 2 * std::numbers::pi * (i + 0.05 * std::sin(7 * i)) / n;
      seeds.push_back({std::cos(t), std::sin(t), 1});
    }
    for (const Point2& p : {Point2{0.01, 0.02}, Point2{0.41, 0.3}, Point2{-0.5, 0.1}, Point2{0.1, -0.55}}) {
      seeds.push_back({p[0], p[1], 1});
      seeds.push_back({p[1], p[0], p[0] * p[0] + p[1] * p[1]});
    }
    return seeds;
  }

  bool is_clear_of_edges(const Point3& p, std::size_t vertices) const override {
    const double spacing = 2 * std::numbers::pi / rim_points(vertices);
    return std::hypot(std::hypot(p[0], p[1]) - 1, p[2] - 1) > 0.5 * spacing;
  }
  bool is_centrally_symmetric() const override { return false; }
};

}  // namespace

Surface3 make_paraboloid(std::size_t triangles) { return sample_surface(Solid(), triangles); }

}  // namespace sinkmesh::models
