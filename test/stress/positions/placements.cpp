// SPDX-License-Identifier: MIT
//
// Where the degenerate positions are put, and how they are left.
#include <algorithm>
#include <cmath>

#include "test/stress/positions/similarity.h"

namespace sinkmesh::stress {
namespace {

using test::uniform;
using test::uniform_int;

template <int Dim>
void map_exactly(std::vector<Point<Dim>>& points, Random& random) {
  std::array<double, 4> quaternion;
  const int most = 1 << uniform_int(random, 0, 9);
  for (double& x : quaternion) x = uniform_int(random, -most, most);
  quaternion[random() % 2] = most;  // not the zero map
  const Similarity<Dim> map(quaternion);
  const int far = 1 << uniform_int(random, 0, 30);
  Point<Dim> offset;
  for (double& x : offset) x = random() % 2 == 0 ? 0 : uniform_int(random, -far, far);
  for (auto& p : points) {
    p = map(p);
    for (std::size_t k = 0; k < Dim; ++k) p[k] += offset[k];
  }
}

template <int Dim>
void scale(std::vector<Point<Dim>>& points, double factor) {
  for (auto& p : points) {
    for (double& x : p) x *= factor;
  }
}

template <int Dim>
void move_far(std::vector<Point<Dim>>& points, Random& random) {
  const double offset = std::ldexp(uniform(random, 1, 2), uniform_int(random, 10, 48));
  for (auto& p : points) {
    for (double& x : p) x += offset;
  }
}

}  // namespace

template <int Dim>
void place(std::vector<Point<Dim>>& points, Random& random) {
  switch (random() % 8) {
    case 0:
    case 1:
      break;
    case 2:
    case 3:
    case 4:
      map_exactly<Dim>(points, random);
      break;
    case 5:
    case 6:
      scale<Dim>(points, uniform(random, 0.1, 1));
      break;
    default:
      move_far<Dim>(points, random);
  }
  if (random() % 4 == 0) scale<Dim>(points, std::ldexp(1.0, uniform_int(random, -20, 40)));
}

template <int Dim>
void nudge(std::vector<Point<Dim>>& points, Random& random) {
  for (int n = uniform_int(random, 1, 3); n > 0; --n) {
    double& x = points[random() % points.size()][random() % Dim];
    const double target = random() % 2 != 0 ? HUGE_VAL : -HUGE_VAL;
    // From zero the next double is too small for any range.
    if (x == 0) x = std::copysign(0x1p-52, target);
    if (random() % 4 != 0) {
      for (int steps = uniform_int(random, 1, 3); steps > 0; --steps) x = std::nextafter(x, target);
    } else {
      x += std::ldexp(x, uniform_int(random, -51, -1));
    }
  }
}

template <int Dim>
std::vector<Point<Dim>> make_position(std::size_t n, std::span<const Base> favourites, Random& random) {
  const bool any = favourites.empty() || random() % 2 == 0;
  const std::span<const Base> bases = any ? std::span<const Base>(kAllBases) : favourites;
  auto points = base_points<Dim>(bases[random() % bases.size()], n, random);
  place<Dim>(points, random);
  if (random() % 5 < 2) nudge<Dim>(points, random);
  return points;
}

template void place<2>(std::vector<Point2>&, Random&);
template void place<3>(std::vector<Point3>&, Random&);
template void nudge<2>(std::vector<Point2>&, Random&);
template void nudge<3>(std::vector<Point3>&, Random&);
template std::vector<Point2> make_position<2>(std::size_t, std::span<const Base>, Random&);
template std::vector<Point3> make_position<3>(std::size_t, std::span<const Base>, Random&);

}  // namespace sinkmesh::stress
