// SPDX-License-Identifier: MIT
#include "test/stress/delaunay/clouds.h"

#include <algorithm>
#include <cmath>

#include "test/stress/delaunay/triangulate.h"

namespace sinkmesh::stress {

using test::uniform_int;

template <int Dim>
std::vector<Point<Dim>> small_cloud(std::size_t n, Random& random) {
  std::vector<Point<Dim>> points;
  switch (random() % 8) {
    case 0:
    case 1:
    case 2:
      points = test::grid_cloud<Dim>(n, uniform_int(random, -3, 1), uniform_int(random, 2, 6), random);
      break;
    case 3:
      points = test::make_wide_cloud<Dim>(-kGridBits, 0, n, random);
      break;
    default:
      points = make_position<Dim>(n, {}, random);
  }
  const InputGate<Dim> gate(points);
  for (auto& p : points) p = gate.in(p);
  make_distinct<Dim>(points, random);
  return points;
}

template <int Dim>
std::vector<Point<Dim>> cloud(std::size_t n, Random& random) {
  std::vector<Point<Dim>> points;
  if (random() % 2 == 0) {
    points = test::make_shape<Dim>(test::kShapes[random() % test::kShapes.size()], n, random);
    if (random() % 2 == 0) place<Dim>(points, random);
    if (random() % 4 == 0) nudge<Dim>(points, random);
  } else {
    // Each of them within [-1, 1], so that they meet.
    for (int parts = uniform_int(random, 1, 4); parts > 0; --parts) {
      auto part = make_position<Dim>(std::max<std::size_t>(n / 4, 2), {}, random);
      double largest = 0;
      for (const auto& p : part) {
        for (const double x : p) largest = std::max(largest, std::abs(x));
      }
      const int e = largest == 0 ? 0 : -1 - std::ilogb(largest);
      for (auto& p : part) {
        for (double& x : p) x = std::ldexp(x, e);
        points.push_back(p);
      }
    }
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

template std::vector<Point2> small_cloud<2>(std::size_t, Random&);
template std::vector<Point3> small_cloud<3>(std::size_t, Random&);
template std::vector<Point2> cloud<2>(std::size_t, Random&);
template std::vector<Point3> cloud<3>(std::size_t, Random&);

}  // namespace sinkmesh::stress
