// SPDX-License-Identifier: MIT
//
// Small closed surfaces for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "refine/surface.h"
#include "test/support/clouds.h"

namespace sinkmesh::test {

/// The sides of a square of width 4, in pieces of length 1; counterclockwise from the origin.
inline std::vector<Point2> square_outline() {
  return {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}, {4, 2}, {4, 3},
          {4, 4}, {3, 4}, {2, 4}, {1, 4}, {0, 4}, {0, 3}, {0, 2}, {0, 1}};
}

/// Axis-parallel box, each side two triangles, outward.
inline Surface3 box_surface(const Point3& low, const Point3& high) {
  Surface3 surface;
  for (int i = 0; i < 8; ++i) {
    surface.points.push_back({i & 4 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 1 ? high[2] : low[2]});
  }
  // Corners 4x+2y+z.
  surface.facets = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return surface;
}

/// Each triangle divided into four at the midpoints of its edges, which `place` may move.
template <class Place>
Surface3 divided_in_four(Surface3 s, Place&& place) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [known, is_new] = middles.try_emplace(std::minmax(a, b), s.points.size());
    if (is_new) {
      Point3 m;
      for (std::size_t k = 0; k < 3; ++k) m[k] = (s.points[a][k] + s.points[b][k]) / 2;
      s.points.push_back(place(m));
    }
    return known->second;
  };
  std::vector<Surface3::Facet> facets;
  for (const auto& [a, b, c] : s.facets) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    facets.insert(facets.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  s.facets = facets;
  return s;
}

/// Octahedron subdivided `levels` times, its vertices pushed to the unit sphere, then scaled to the half-axes,
/// and moved a little along its normal (fraction `jitter`, fixed seed), so that it is not cospherical.
inline Surface3 ellipsoid_surface(int levels, const Point3& axes, double jitter = 0) {
  Surface3 s;
  s.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    s = divided_in_four(s, [](Point3 m) {
      const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      for (double& x : m) x /= length;
      return m;
    });
  }
  Random random(1);
  for (Point3& p : s.points) {
    const double stretch = 1 + jitter * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    for (std::size_t k = 0; k < 3; ++k) p[k] *= axes[k] * stretch;
  }
  return s;
}

/// The same surface with points, facets, and corners of facets shuffled, so that normals point anywhere.
template <int Dim>
Surface<Dim> in_another_order(const Surface<Dim>& s, Random& random) {
  std::vector<std::uint32_t> place(s.points.size());
  std::iota(place.begin(), place.end(), 0U);
  std::shuffle(place.begin(), place.end(), random);
  Surface<Dim> result = s;
  for (std::size_t i = 0; i < place.size(); ++i) result.points[place[i]] = s.points[i];
  for (auto& facet : result.facets) {
    for (std::uint32_t& p : facet) p = place[p];
    std::shuffle(facet.begin(), facet.end(), random);
  }
  std::shuffle(result.facets.begin(), result.facets.end(), random);
  return result;
}

/// Puts b beside a, as one surface.
inline Surface3 join(Surface3 a, const Surface3& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.facets) a.facets.push_back({i + shift, j + shift, k + shift});
  return a;
}

/// All facets turned over.
inline Surface3 reversed(Surface3 s) {
  for (auto& facet : s.facets) std::swap(facet[0], facet[1]);
  return s;
}

/// The same surface with points and facets in another order.
inline Surface3 shuffled(const Surface3& s, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> place(s.points.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
  std::shuffle(place.begin(), place.end(), random);
  Surface3 result = s;
  for (std::size_t i = 0; i < place.size(); ++i) result.points[place[i]] = s.points[i];
  for (auto& facet : result.facets) {
    for (std::uint32_t& p : facet) p = place[p];
  }
  std::shuffle(result.facets.begin(), result.facets.end(), random);
  return result;
}

}  // namespace sinkmesh::test
