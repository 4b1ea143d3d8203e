// SPDX-License-Identifier: MIT
//
// Three passes: which face is seen at each sample; how deep each pixel lies; then light, edges and the mean
// over the samples of a pixel, which smooths all borders at once.
#include "tools/reproduce/render.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/vector.h"
#include "tools/reproduce/occlusion.h"
#include "tools/reproduce/palette.h"
#include "tools/reproduce/rasterizer.h"

namespace sinkmesh::reproduce {
namespace {

constexpr int kDensity = 4;            // samples per pixel and direction
constexpr double kEdgeWidth = 0.5;     // of the half of an edge that lies in one triangle, in pixels
constexpr double kEdgeDarkness = 0.6;  // light that an edge takes away at most
// Size of a triangle, as the side of a square of its area, in pixels: no edges below the first, full ones above
// the second. Smaller triangles would be all edges.
constexpr double kNoEdges = 2.5;
constexpr double kFullEdges = 9;
// Hollows: the radius is a part of the picture's width, the depth one of the bounding sphere's radius.
constexpr double kHollowRadius = 0.016;
constexpr double kHollowDepth = 0.2;
constexpr double kDarkest = 0.4;
constexpr double kBrightest = 1.06;

constexpr double kInsideDimming = 0.55;

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Light on a face, by its normal as seen by the eye: a lamp above the left shoulder, a weak one from the right,
// and the sky.
double brightness(const Point3& normal) {
  constexpr Point3 kLamp{-0.456, 0.570, 0.684};
  constexpr Point3 kFill{0.844, 0.000, 0.537};
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0)) return 1;
  const auto towards = [&](const Point3& light) { return std::max(0.0, dot(normal, light) / length); };
  const double sky = 0.5 + 0.5 * normal[1] / length;
  return 0.20 + 0.22 * sky + 0.64 * towards(kLamp) + 0.22 * towards(kFill);
}

// A face in the picture, ready for its samples.
struct Seen {
  TriangleFunctions functions;
  Light colour;       // lit
  double edge_light;  // factor on edges
};

class Renderer {
 public:
  Renderer(std::span<const Point3> points, std::span<const Face> faces, const Projection& projection, int width,
           int height)
      : faces_(faces),
        points_(points),
        projection_(projection),
        buffer_(width, height, kDensity),
        image_(width, height) {
    screen_.reserve(points.size());
    for (const Point3& p : points) screen_.push_back(projection.project(p));
  }

  Image run() {
    for (std::uint32_t id = 0; id < faces_.size(); ++id) buffer_.draw(triangle(id), id);
    measure_hollows();
    place_.assign(faces_.size(), kUnlit);
    for (int y = 0; y < image_.height; ++y) {
      for (int x = 0; x < image_.width; ++x) image_.at(x, y) = resolve(x, y);
    }
    reduce_colours(image_);
    return std::move(image_);
  }

 private:
  static constexpr std::uint32_t kUnlit = ~std::uint32_t{0};

  ScreenTriangle triangle(std::uint32_t id) const {
    const auto& c = faces_[id].corners;
    return {screen_[c[0]], screen_[c[1]], screen_[c[2]]};
  }

  template <class Visit>
  void for_each_sample(int x, int y, Visit visit) const {
    for (int row = y * kDensity; row < (y + 1) * kDensity; ++row) {
      for (int column = x * kDensity; column < (x + 1) * kDensity; ++column) {
        const VisibilityBuffer::Sample& sample = buffer_.at(column, row);
        if (sample.triangle != VisibilityBuffer::kNothing) visit(sample, column, row);
      }
    }
  }

  void measure_hollows() {
    Plane depth{image_.width, image_.height, {}};
    Plane coverage{image_.width, image_.height, {}};
    for (int y = 0; y < image_.height; ++y) {
      for (int x = 0; x < image_.width; ++x) {
        double sum = 0;
        int count = 0;
        for_each_sample(x, y, [&](const VisibilityBuffer::Sample& sample, int, int) {
          sum += projection_.depth(sample.nearness);
          ++count;
        });
        depth.values.push_back(static_cast<float>(sum / (kDensity * kDensity)));
        coverage.values.push_back(static_cast<float>(count) / (kDensity * kDensity));
      }
    }
    const int radius = std::max(1, static_cast<int>(kHollowRadius * image_.width));
    hollows_ = behind_surroundings(depth, coverage, radius).values;
  }

  // Only faces that are seen are lit.
  const Seen& seen(std::uint32_t id) {
    if (place_[id] == kUnlit) {
      place_[id] = static_cast<std::uint32_t>(seen_.size());
      seen_.push_back(lit(id));
    }
    return seen_[place_[id]];
  }

  Seen lit(std::uint32_t id) const {
    const Face& face = faces_[id];
    const Point3& a = points_[face.corners[0]];
    Point3 normal = projection_.rotate(cross(points_[face.corners[1]] - a, points_[face.corners[2]] - a));
    const double area = signed_area(triangle(id));
    if (area < 0) normal = {-normal[0], -normal[1], -normal[2]};
    double light = 1 + face.relief * (brightness(normal) - 1);
    if (area < 0) light *= kInsideDimming;
    Light colour = face.colour;
    for (double& channel : colour) channel *= light;
    const double strength = smooth_step(kNoEdges, kFullEdges, std::sqrt(std::abs(area) / 2));
    return {TriangleFunctions(triangle(id)), colour, 1 - kEdgeDarkness * strength};
  }

  Pixel resolve(int x, int y) {
    Light sum{};
    int count = 0;
    for_each_sample(x, y, [&](const VisibilityBuffer::Sample& sample, int column, int row) {
      const Seen& face = seen(sample.triangle);
      bool on_edge = false;
      for (const auto& distance : face.functions.inside) {
        on_edge |= value(distance, buffer_.position(column), buffer_.position(row)) < kEdgeWidth;
      }
      for (std::size_t k = 0; k < 3; ++k) sum[k] += face.colour[k] * (on_edge ? face.edge_light : 1);
      ++count;
    });
    if (count == 0) return {};
    const std::size_t place =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
    const double openness = std::clamp(1 - hollows_[place] / kHollowDepth, kDarkest, kBrightest);
    for (double& channel : sum) channel *= openness / count;
    return to_pixel(sum, static_cast<double>(count) / (kDensity * kDensity));
  }

  std::span<const Face> faces_;
  std::span<const Point3> points_;
  const Projection& projection_;
  std::vector<ScreenPoint> screen_;
  VisibilityBuffer buffer_;
  std::vector<float> hollows_;
  std::vector<std::uint32_t> place_;  // of a face in seen_
  std::vector<Seen> seen_;
  Image image_;
};

}  // namespace

Image render(std::span<const Point3> points, std::span<const Face> faces, const Projection& projection,
             int width, int height) {
  return Renderer(points, faces, projection, width, height).run();
}

}  // namespace sinkmesh::reproduce
