// SPDX-License-Identifier: MIT
#include "refine/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/vector.h"
#include "predicates/constructions.h"
#include "predicates/predicates.h"
#include "refine/quality.h"
#include "refine/ridge_uses.h"

namespace sinkmesh {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// The facet across each edge, or none where the edge has other than two facets.
std::vector<std::array<std::uint32_t, 3>> neighbours(std::span<const PlacedFacet> facets) {
  std::vector<std::array<std::uint32_t, 3>> across(facets.size(), {kNone, kNone, kNone});
  const auto corners_of = [&](std::size_t f) -> const std::array<Vertex, 3>& { return facets[f].vertices; };
  for_each_ridge<3>(facets.size(), corners_of, [&](auto first, auto last) {
    if (last - first != 2) return;
    across[first[0].facet][first[0].k] = first[1].facet;
    across[first[1].facet][first[1].k] = first[0].facet;
  });
  return across;
}

// By decreasing area, ties by coordinates.
std::vector<std::uint32_t> by_size(const Complex<3>& complex, std::span<const PlacedFacet> facets) {
  struct Key {
    double area2;
    std::array<Point3, 3> corners;
  };
  std::vector<Key> key(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) key[f].corners[k] = complex.point(facets[f].vertices[k]);
    std::sort(key[f].corners.begin(), key[f].corners.end());
    key[f].area2 = facet_area2<3>({&key[f].corners[0], &key[f].corners[1], &key[f].corners[2]});
  }
  std::vector<std::uint32_t> order(facets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    return key[f].area2 != key[g].area2 ? key[f].area2 > key[g].area2 : key[f].corners < key[g].corners;
  });
  return order;
}

// The number of the corner within `flat` of the opposite edge, which is then the longest; or 3.
std::size_t needle_point(const Complex<3>& complex, const std::array<Vertex, 3>& facet, double flat) {
  std::size_t k = 0;
  const auto length2 = [&](std::size_t i) {
    return squared_distance(complex.point(facet[(i + 1) % 3]), complex.point(facet[(i + 2) % 3]));
  };
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) k = length2(i) > length2(k) ? i : k;
  const Point3 n =
      facet_normal<3>({&complex.point(facet[0]), &complex.point(facet[1]), &complex.point(facet[2])});
  return dot(n, n) <= flat * flat * length2(k) ? k : 3;
}

}  // namespace

// Each exchange takes one needle away; a pass that makes none is the last. Two needles at one edge could hand
// it to and fro, so there are not more passes than could be needed.
std::vector<PlacedFacet> without_needles(const Complex<3>& complex,
                                         std::span<const std::array<Vertex, 3>> facets,
                                         std::span<const std::int64_t> tags, double flat) {
  std::vector<PlacedFacet> result;
  for (std::uint32_t f = 0; f < facets.size(); ++f) result.push_back({facets[f], f});
  constexpr int kPasses = 16;
  bool has_changed = flat > 0;
  for (int pass = 0; pass < kPasses && has_changed; ++pass) {
    has_changed = false;
    std::vector<std::array<std::uint32_t, 3>> across;
    for (std::uint32_t f = 0; f < result.size(); ++f) {
      const std::array<Vertex, 3> needle = result[f].vertices;
      const std::size_t k = needle_point(complex, needle, flat);
      if (k == 3) continue;
      if (across.empty()) across = neighbours(result);
      const std::uint32_t g = across[f][k];
      if (g == kNone || (!tags.empty() && tags[result[g].parent] != tags[result[f].parent])) continue;
      const std::array<Vertex, 3> other = result[g].vertices;
      const Vertex a = needle[(k + 1) % 3];
      const Vertex b = needle[(k + 2) % 3];
      if (needle_point(complex, other, flat) != 3) continue;
      for (const auto& [gone, facet] : {std::pair(a, f), std::pair(b, g)}) {
        std::array<Vertex, 3> half = other;
        std::replace(half.begin(), half.end(), gone, needle[k]);
        result[facet] = {half, result[g].parent};
      }
      has_changed = true;
      break;  // neighbours have changed
    }
  }
  return result;
}

std::optional<Fold> sharpest_fold(const Complex<3>& complex, std::span<const std::array<Vertex, 3>> facets) {
  std::optional<Fold> sharpest;
  const auto corners_of = [&](std::size_t f) -> const std::array<Vertex, 3>& { return facets[f]; };
  for_each_ridge<3>(facets.size(), corners_of, [&](auto first, auto last) {
    const Point3& a = complex.point(first->ridge[0]);
    const Point3 along = complex.point(first->ridge[1]) - a;
    const auto out = [&](const RidgeUse<3>& use) {
      Point3 way = complex.point(facets[use.facet][use.k]) - a;
      const double t = dot(way, along) / dot(along, along);
      for (std::size_t i = 0; i < 3; ++i) way[i] -= t * along[i];
      return way;
    };
    for (auto one = first; one != last; ++one) {
      for (auto other = one + 1; other != last; ++other) {
        const Point3 u = out(*one);
        const Point3 v = out(*other);
        const Point3 n = cross(u, v);
        const double angle = std::atan2(std::sqrt(dot(n, n)), dot(u, v));
        if (!sharpest || angle < sharpest->angle) sharpest = Fold{one->facet, other->facet, angle};
      }
    }
  });
  return sharpest;
}

std::vector<PatchFacet> find_patches(const Complex<3>& complex, std::span<const PlacedFacet> facets,
                                     std::span<const std::int64_t> tags, double flat,
                                     std::vector<BoundaryFeatures<3>::Patch>& planes) {
  const std::vector<std::array<std::uint32_t, 3>> across = neighbours(facets);
  std::vector<PatchFacet> result(facets.size(), {{}, kNone});
  std::vector<std::uint32_t> stack;
  planes.clear();
  for (const std::uint32_t seed : by_size(complex, facets)) {
    if (result[seed].patch != kNone) continue;
    const std::array<const Point3*, 3> base = {&complex.point(facets[seed].vertices[0]),
                                               &complex.point(facets[seed].vertices[1]),
                                               &complex.point(facets[seed].vertices[2])};
    const Plane plane = Plane::through(*base[0], *base[1], *base[2]);
    const auto patch = static_cast<std::uint32_t>(planes.size());
    planes.push_back({facets[seed].parent, plane});

    const auto is_near = [&](Vertex v) {
      const Point3& p = complex.point(v);
      return flat > 0 ? plane.distance(p) <= flat : orient3d(*base[0], *base[1], *base[2], p) == 0;
    };
    const auto is_counterclockwise = [&](const std::array<Vertex, 3>& f) {
      return orient2d(plane.project(complex.point(f[0])), plane.project(complex.point(f[1])),
                      plane.project(complex.point(f[2]))) > 0;
    };
    result[seed] = {facets[seed].vertices, patch};
    stack.assign(1, seed);
    while (!stack.empty()) {
      const std::uint32_t f = stack.back();
      stack.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t g = across[f][k];
        if (g == kNone || result[g].patch != kNone) continue;
        if (!tags.empty() && tags[facets[g].parent] != tags[facets[seed].parent]) continue;
        // Turned so that the common edge runs the other way.
        const Vertex a = facets[f].vertices[(k + 1) % 3];
        const Vertex b = facets[f].vertices[(k + 2) % 3];
        const auto& v = facets[g].vertices;
        const Vertex apex = *std::find_if(v.begin(), v.end(), [&](Vertex x) { return x != a && x != b; });
        const auto& mine = result[f].vertices;
        const auto at = static_cast<std::size_t>(std::find(mine.begin(), mine.end(), a) - mine.begin());
        const bool runs_ab = mine[(at + 1) % 3] == b;
        const std::array<Vertex, 3> turned =
            runs_ab ? std::array<Vertex, 3>{b, a, apex} : std::array<Vertex, 3>{a, b, apex};
        if (!is_near(apex) || !is_counterclockwise(turned)) continue;
        result[g] = {turned, patch};
        planes.back().is_joined = true;
        stack.push_back(g);
      }
    }
  }
  return result;
}

}  // namespace sinkmesh
