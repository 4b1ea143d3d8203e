// SPDX-License-Identifier: MIT
//
// The star-shaped cavity of a rocket motor, and the propellant around it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/vector.h"
#include "tools/models/models.h"
#include "tools/models/planar_region.h"
#include "tools/models/tube.h"

namespace sinkmesh::models {
namespace {

using std::numbers::pi;

// Metres [EG01, 5.5, 5.6]; but the paper does not say how thick the propellant is. With this radius the initial
// tetrahedra of the head have the paper's ratios.
constexpr double kLength = 4;
constexpr double kCoreRadius = 0.5;
constexpr int kFins = 11;
constexpr double kFinLength = 1.2;
constexpr double kFinThickness = 0.14;
constexpr double kOuterRadius = 1.87;

const double kRootAngle = std::asin(kFinThickness / 2 / kCoreRadius);
const double kRoot = kCoreRadius * std::cos(kRootAngle);

// The number of rows and segments grows like the square root of the number of triangles; for the paper's it is
// this, from the ratios of its surface triangles.
constexpr double kStarTriangles = 53508;
constexpr int kSideSegments = 29;  // along a side of a fin
constexpr int kCavityRows = 36;    // intervals along z
constexpr double kHeadTriangles = 67940;
constexpr int kOuterSegments = 150;  // around the propellant
constexpr int kOuterRows = 38;
// Points inside a cap of the star, for the paper's number of triangles.
constexpr double kCapPoints = 546;

struct TubeSampling {
  int segments;  // of a side of a fin, or around the propellant
  int rows;
};

// Of a triangle with two equal sides.
double circumradius(double base, double height) { return (height * height + base * base / 4) / (2 * height); }

Point2 polar(double r, double angle) { return {r * std::cos(angle), r * std::sin(angle)}; }

// Counterclockwise, fin by fin: out along a side, across the tip, back, and along the core to the next.
std::vector<SectionPiece> cavity_section(int side_segments) {
  // Segments of tips and core in proportion to the sides', 3 and 4 for the paper's number of triangles.
  const auto proportion = [&](double part) {
    return std::max(1, static_cast<int>(std::lround(part * side_segments / kSideSegments)));
  };
  const auto line = [](double angle, Point2 a, Point2 b) {
    return [=, c = std::cos(angle), s = std::sin(angle)](double t, double) {
      const double x = a[0] * (1 - t) + b[0] * t;
      const double y = a[1] * (1 - t) + b[1] * t;
      return Point2{c * x - s * y, s * x + c * y};
    };
  };
  const double h = kFinThickness / 2;
  const double end = kRoot + kFinLength;
  std::vector<SectionPiece> section;
  for (int fin = 0; fin < kFins; ++fin) {
    const double angle = 2 * pi * fin / kFins;
    section.push_back({line(angle, {kRoot, -h}, {end, -h}), kFinLength, side_segments});
    section.push_back({line(angle, {end, -h}, {end, h}), kFinThickness, proportion(3)});
    section.push_back({line(angle, {end, h}, {kRoot, h}), kFinLength, side_segments, 0.05, 0.08});
    const double from = angle + kRootAngle;
    const double to = angle + 2 * pi / kFins - kRootAngle;
    const auto core = [=](double t, double outward) {
      return polar(kCoreRadius + outward, from * (1 - t) + to * t);
    };
    const double length = kCoreRadius * (to - from);
    const double spacing = length / proportion(4);
    // Rough enough to be seen beside the rise of an arc over its chord, spacing^2 / 8 radius.
    section.push_back({core, length, proportion(4), 0, 0, 0.38 * spacing * spacing});
  }
  return section;
}

// Distance from the outline of the star, about: folded into one fin, whose root is rounded off.
double distance_from_star(const Point2& p) {
  const double r = std::hypot(p[0], p[1]);
  const double sector = 2 * pi / kFins;
  const double angle = std::abs(std::remainder(std::atan2(p[1], p[0]), sector));
  const double x = r * std::cos(angle);
  const double y = r * std::sin(angle);
  const double to_side = std::hypot(x - std::clamp(x, kRoot, kRoot + kFinLength), y - kFinThickness / 2);
  const double to_tip = std::hypot(x - kRoot - kFinLength, y - std::min(y, kFinThickness / 2));
  const double to_arc = angle > kRootAngle ? std::abs(r - kCoreRadius) : to_side;
  return std::min({to_side, to_tip, to_arc});
}

// The sampling that leaves about the right number of triangles for the caps and keeps the proportions of the
// paper's triangles; but a wall is stable only if the diametral spheres of its triangles, the widest of which
// are at the ends of a row, do not reach far into the opposite wall. With few triangles they have to be less
// slender for that.
TubeSampling cavity_sampling(double triangles) {
  constexpr double kSlenderness = (kLength / kCavityRows) / (kFinLength / kSideSegments);
  const double caps = 4 * kCapPoints * std::pow(triangles / kStarTriangles, 0.85);
  TubeSampling best{};
  double least = std::numeric_limits<double>::infinity();
  for (int segments = 4; segments < 2 * kSideSegments * 4; ++segments) {
    const std::vector<SectionPiece> section = cavity_section(segments);
    double outline = 0;
    for (const SectionPiece& piece : section) outline += piece.segments;
    const double per_row = static_cast<double>(tube_facets(section, true, 2)) / 2;
    const double wanted = triangles - caps - 2 * outline;
    const int rows = static_cast<int>(std::lround(wanted / per_row));
    if (rows < 4) break;
    const double width = kFinLength / segments;
    const double height = kLength / rows;
    const double reach = circumradius(1.5 * width, height) / kFinThickness;
    const double misfit = std::abs(std::log(height / width / kSlenderness)) + 8 * std::max(0.0, reach - 0.9) +
                          8 * std::abs(per_row * rows - wanted) / triangles;
    if (misfit < least) {
      least = misfit;
      best = {segments, rows};
    }
  }
  return best;
}

// The same for the outer wall, which is close to the fins' tips.
TubeSampling outer_sampling(double triangles) {
  const double scale = std::sqrt(triangles / kHeadTriangles);
  const double reach = 0.93 * (kOuterRadius - kRoot - kFinLength);
  double width = 2 * pi * kOuterRadius / (kOuterSegments * scale);
  double height = kLength / (kOuterRows * scale);
  while (circumradius(width, height) > reach) {
    height *= 0.99;
    width = std::min(width, 1.15 * height);
  }
  return {static_cast<int>(std::lround(2 * pi * kOuterRadius / width)),
          static_cast<int>(std::lround(kLength / height))};
}

Tube make_cavity(const TubeSampling& sampling) {
  return make_tube(cavity_section(sampling.segments), true, kLength, sampling.rows);
}

Tube make_outer_wall(const TubeSampling& sampling) {
  const auto circle = [](double t, double outward) { return polar(kOuterRadius + outward, 2 * pi * t); };
  return make_tube({{circle, 2 * pi * kOuterRadius, sampling.segments}}, false, kLength, sampling.rows);
}

void append(Surface3& surface, const Tube& tube, bool reversed) {
  const auto first = static_cast<std::uint32_t>(surface.points.size());
  surface.points.insert(surface.points.end(), tube.points.begin(), tube.points.end());
  for (const auto& [a, b, c] : tube.facets) {
    surface.facets.push_back(reversed ? Surface3::Facet{a + first, c + first, b + first}
                                      : Surface3::Facet{a + first, b + first, c + first});
  }
}

// Closes the surface at height z with a plane region bounded by some of its vertices.
void append_cap(Surface3& surface, const std::vector<std::vector<std::uint32_t>>& loops, double z,
                const std::function<double(const Point2&)>& size, std::size_t triangles) {
  std::vector<std::vector<Point2>> outlines;
  std::vector<std::uint32_t> id;
  for (const auto& loop : loops) {
    std::vector<Point2>& outline = outlines.emplace_back();
    for (const std::uint32_t v : loop) {
      outline.push_back({surface.points[v][0], surface.points[v][1]});
      id.push_back(v);
    }
  }
  // Euler: a region with n vertices on its outline, m inside and one or two loops.
  const std::size_t least = loops.size() == 1 ? id.size() - 2 : id.size();
  const Mesh2 mesh = mesh_region(outlines, size, triangles > least ? (triangles - least) / 2 : 0);
  while (id.size() < mesh.points.size()) {
    const Point2& p = mesh.points[id.size()];
    id.push_back(static_cast<std::uint32_t>(surface.points.size()));
    surface.points.push_back({p[0], p[1], z});
  }
  for (const auto& [a, b, c] : mesh.simplices) {
    surface.facets.push_back(z == 0 ? Surface3::Facet{id[a], id[c], id[b]}
                                    : Surface3::Facet{id[a], id[b], id[c]});
  }
}

void append_caps(Surface3& surface, const std::vector<std::vector<std::uint32_t>>& bottom,
                 const std::vector<std::vector<std::uint32_t>>& top,
                 const std::function<double(const Point2&)>& size, std::size_t triangles) {
  const auto rest = [&] { return triangles - std::min(triangles, surface.facets.size()); };
  append_cap(surface, bottom, 0, size, rest() / 2);
  append_cap(surface, top, kLength, size, rest());
}

std::vector<std::uint32_t> shifted(std::vector<std::uint32_t> ids, std::size_t by) {
  for (std::uint32_t& id : ids) id += static_cast<std::uint32_t>(by);
  return ids;
}

}  // namespace

Surface3 make_star(std::size_t triangles) {
  const TubeSampling sampling = cavity_sampling(static_cast<double>(triangles));
  const Tube cavity = make_cavity(sampling);
  const double spacing = kFinLength / sampling.segments;
  const auto size = [&](const Point2& p) { return spacing + 0.29 * distance_from_star(p); };
  Surface3 surface;
  append(surface, cavity, false);
  append_caps(surface, {cavity.bottom}, {cavity.top}, size, triangles);
  return surface;
}

Surface3 make_head(std::size_t triangles) {
  const auto wanted = static_cast<double>(triangles);
  const TubeSampling sampling = cavity_sampling(std::round(wanted * kStarTriangles / kHeadTriangles));
  const TubeSampling outer_tube = outer_sampling(wanted);
  const Tube cavity = make_cavity(sampling);
  const Tube outer = make_outer_wall(outer_tube);
  const double spacing = kFinLength / sampling.segments;
  const double outer_spacing = 2 * pi * kOuterRadius / outer_tube.segments;
  const auto size = [&](const Point2& p) {
    return std::min(spacing + 0.22 * distance_from_star(p),
                    outer_spacing + 0.22 * (kOuterRadius - std::hypot(p[0], p[1])));
  };
  Surface3 surface;
  append(surface, cavity, true);
  append(surface, outer, false);
  const std::size_t first = cavity.points.size();
  append_caps(surface, {shifted(outer.bottom, first), cavity.bottom}, {shifted(outer.top, first), cavity.top},
              size, triangles);
  return surface;
}

}  // namespace sinkmesh::models
