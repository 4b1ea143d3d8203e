// SPDX-License-Identifier: MIT
//
// The level set of Gaussian blobs at the vertices of a cuboctahedron.
#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "tools/models/models.h"
#include "tools/models/surface_sampler.h"

namespace sinkmesh::models {
namespace {

// Twelve blobs around the vertices, which are at distance 1 from the origin, and one around the origin, without
// which there would be a hollow. value(p) = 1 - sum of exp(-2 (|p-c|^2 / radius^2 - 1)).
constexpr double kDecay = 2;
constexpr double kRadius = 0.63;
constexpr double kCoreRadius = 0.5;
// The size is (radius of curvature / kReference)^kAdaption, within bounds.
constexpr double kReference = 0.4;
constexpr double kAdaption = 0.65;
constexpr double kSmallest = 0.3;
constexpr double kLargest = 2;

struct Blob {
  Point3 center;
  double radius2;
};

std::vector<Blob> make_blobs() {
  std::vector<Blob> blobs = {{{0, 0, 0}, kCoreRadius * kCoreRadius}};
  const double q = std::sqrt(0.5);
  for (const double a : {-q, q}) {
    for (const double b : {-q, q}) {
      for (const Point3& center : {Point3{a, b, 0}, Point3{a, 0, b}, Point3{0, a, b}}) {
        blobs.push_back({center, kRadius * kRadius});
      }
    }
  }
  return blobs;
}

class Solid final : public ImplicitSolid {
 public:
  double value(const Point3& p) const override {
    double sum = 0;
    for (const Blob& blob : blobs_) sum += strength(blob, p);
    return 1 - sum;
  }

  // By the larger of the two principal curvatures: the eigenvalues of the Hessian in the tangent plane, divided
  // by the length of the gradient.
  double size(const Point3& p) const override {
    const Point3 gradient = gradient_at(p);
    const double length = std::sqrt(dot(gradient, gradient));
    const Point3 u =
        unit(cross(gradient, std::abs(gradient[0]) < 0.8 * length ? Point3{1, 0, 0} : Point3{0, 1, 0}));
    const Point3 v = unit(cross(gradient, u));
    double uu = 0;
    double uv = 0;
    double vv = 0;
    for (const Blob& blob : blobs_) {
      const double slope = 2 * kDecay / blob.radius2 * strength(blob, p);
      const Point3 d = p - blob.center;
      const double du = dot(d, u);
      const double dv = dot(d, v);
      const double bend = 2 * kDecay / blob.radius2;
      uu += slope * (1 - bend * du * du);
      uv -= slope * bend * du * dv;
      vv += slope * (1 - bend * dv * dv);
    }
    const double curvature = (std::abs(uu + vv) / 2 + std::hypot((uu - vv) / 2, uv)) / length;
    return std::clamp(std::pow(1 / (curvature * kReference), kAdaption), kSmallest, kLargest);
  }

  double max_ratio() const override { return 1.05; }

  Point3 onto(const Point3& p) const override {
    const Point3 gradient = gradient_at(p);
    const double step = value(p) / dot(gradient, gradient);
    return {p[0] - step * gradient[0], p[1] - step * gradient[1], p[2] - step * gradient[2]};
  }

  // In the directions of the vertices, faces and edges of a cube, a little turned so that no five are
  // cospherical.
  std::vector<Point3> seeds(std::size_t) const override {
    std::vector<Point3> seeds;
    for (int i = 14; i < 27; ++i) {  // one of each pair of opposite directions
      const int y = i / 3 % 3;
      const int z = i / 9;
      const Point3 direction{i % 3 - 1 + 0.1, y - 1 + 0.07, z - 1 - 0.04};
      const Point3 p = first_crossing(direction);
      seeds.push_back(p);
      seeds.push_back({-p[0], -p[1], -p[2]});
    }
    return seeds;
  }

  bool is_clear_of_edges(const Point3&, std::size_t) const override { return true; }
  bool is_centrally_symmetric() const override { return true; }

 private:
  static double strength(const Blob& blob, const Point3& p) {
    return std::exp(-kDecay * (squared_distance(p, blob.center) / blob.radius2 - 1));
  }
  static Point3 unit(const Point3& v) {
    const double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
  }

  Point3 gradient_at(const Point3& p) const {
    Point3 gradient{};
    for (const Blob& blob : blobs_) {
      const double slope = 2 * kDecay / blob.radius2 * strength(blob, p);
      for (std::size_t k = 0; k < 3; ++k) gradient[k] += slope * (p[k] - blob.center[k]);
    }
    return gradient;
  }

  // Along a ray from the origin; the solid is star-shaped.
  Point3 first_crossing(const Point3& direction) const {
    const Point3 d = unit(direction);
    double low = 0;
    double high = 3;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (value({middle * d[0], middle * d[1], middle * d[2]}) < 0 ? low : high) = middle;
    }
    return {low * d[0], low * d[1], low * d[2]};
  }

  std::vector<Blob> blobs_ = make_blobs();
};

}  // namespace

Surface3 make_cuboctahedron(std::size_t triangles) { return sample_surface(Solid(), triangles); }

}  // namespace sinkmesh::models
