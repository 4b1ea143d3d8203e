// SPDX-License-Identifier: MIT
//
// The degenerate positions, as exact integers.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "test/stress/positions/similarity.h"

namespace sinkmesh::stress {
namespace {

using test::uniform;
using test::uniform_int;

template <int Dim>
using Points = std::vector<Point<Dim>>;

double integer(Random& random, int most) { return uniform_int(random, -most, most); }

template <int Dim>
Point<Dim> integer_point(Random& random, int most) {
  Point<Dim> p;
  for (double& x : p) x = integer(random, most);
  return p;
}

template <int Dim>
Point<Dim> with_random_signs_and_order(Point<Dim> p, Random& random) {
  std::shuffle(p.begin(), p.end(), random);
  for (double& x : p) x = random() % 2 != 0 ? 0 - x : x + 0;
  return p;
}

template <int Dim>
Point<Dim> opposite(const Point<Dim>& p) {
  Point<Dim> q;
  for (std::size_t k = 0; k < Dim; ++k) q[k] = 0 - p[k];
  return q;
}

/// Images of one vector under rotations of one magnification: quaternions with the same components in another
/// order, or, in the plane, products of the same Gaussian integers with another selection of conjugates.
template <int Dim>
Points<Dim> pythagorean_points(std::size_t n, Random& random) {
  Points<Dim> points(n);
  const int most = 1 << uniform_int(random, 2, Dim == 2 ? 7 : 12);
  if constexpr (Dim == 2) {
    std::array<Point2, 4> factors;
    for (Point2& f : factors) f = integer_point<2>(random, most);
    for (Point2& p : points) {
      p = {1, 0};
      for (Point2 f : factors) {
        if (random() % 2 != 0) f[1] = 0 - f[1];
        p = {p[0] * f[0] - p[1] * f[1], p[0] * f[1] + p[1] * f[0]};
      }
      p = with_random_signs_and_order<2>(p, random);
    }
  } else {
    std::array<double, 4> quaternion;
    for (double& x : quaternion) x = integer(random, most);
    const Point3 v = integer_point<3>(random, 9);
    for (Point3& p : points) {
      std::shuffle(quaternion.begin(), quaternion.end(), random);
      p = with_random_signs_and_order<3>(Similarity<3>(quaternion)(v), random);
    }
  }
  if (n > 1) points[1] = opposite<Dim>(points[0]);
  return points;
}

/// In the plane the great "circle" is a pair of antipodal points.
template <int Dim>
Points<Dim> great_circle_points(std::size_t n, Random& random) {
  Points<Dim> points(n);
  if constexpr (Dim == 2) {
    constexpr std::array<Point2, 5> kOn{{{25, 60}, {16, 63}, {33, 56}, {39, 52}, {65, 0}}};
    for (Point2& p : points) p = with_random_signs_and_order<2>(kOn[random() % kOn.size()], random);
    if (n > 1) points[1] = opposite<2>(points[0]);
  } else {
    constexpr std::array<Point2, 2> kCircle{{{9, 12}, {15, 0}}};
    constexpr std::array<Point3, 5> kSphere{{{2, 10, 11}, {2, 5, 14}, {10, 10, 5}, {9, 12, 0}, {15, 0, 0}}};
    for (Point3& p : points) {
      const Point2 q = with_random_signs_and_order<2>(kCircle[random() % kCircle.size()], random);
      p = {q[0], q[1], 0};
    }
    points.back() = with_random_signs_and_order<3>(kSphere[random() % kSphere.size()], random);
  }
  return points;
}

/// origin + integer combinations of `span` integer vectors.
template <int Dim>
Points<Dim> flat_points(std::size_t n, std::size_t span, int most, Random& random) {
  Points<Dim> points(n, integer_point<Dim>(random, most));
  for (std::size_t i = 0; i < span; ++i) {
    const Point<Dim> direction = integer_point<Dim>(random, 9);
    for (Point<Dim>& p : points) {
      const double factor = integer(random, most);
      for (std::size_t k = 0; k < Dim; ++k) p[k] += factor * direction[k];
    }
  }
  return points;
}

}  // namespace

template <int Dim>
std::vector<Point<Dim>> base_points(Base base, std::size_t n, Random& random) {
  constexpr std::size_t kHyperplane = Dim - 1;
  switch (base) {
    case Base::kUniform:
      return test::candidate_cloud<Dim>(test::Cloud::kUniform, n, random);
    case Base::kGrid: {
      Points<Dim> points(n);
      const int most = uniform_int(random, 1, 4);
      for (auto& p : points) p = integer_point<Dim>(random, most);
      if (random() % 2 != 0) {
        for (std::size_t k = 0; k < Dim; ++k) {
          const double unit = std::ldexp(1.0, -uniform_int(random, 0, 60));
          for (auto& p : points) p[k] *= unit;
        }
      }
      return points;
    }
    case Base::kBoxCorners: {
      const Point<Dim> low = integer_point<Dim>(random, 1000);
      const Point<Dim> high = integer_point<Dim>(random, 1000);
      Points<Dim> points(n);
      for (auto& p : points) {
        for (std::size_t k = 0; k < Dim; ++k) p[k] = random() % 2 != 0 ? low[k] : high[k];
      }
      return points;
    }
    case Base::kSpheres:
      return test::candidate_cloud<Dim>(test::Cloud::kIntegerSphere, n, random);
    case Base::kPythagorean:
      return pythagorean_points<Dim>(n, random);
    case Base::kGreatCircle:
      return great_circle_points<Dim>(n, random);
    case Base::kFlat:
      return flat_points<Dim>(n, kHyperplane, 1 << uniform_int(random, 1, 20), random);
    case Base::kFlatScales: {
      auto points = flat_points<Dim>(n, kHyperplane, 1 << uniform_int(random, 1, 20), random);
      const Point<Dim> origin = points[0];
      const int most = uniform_int(random, 10, 150);
      for (auto& p : points) {
        const double factor = std::ldexp(1.0, -uniform_int(random, 0, most));
        for (std::size_t k = 0; k < Dim; ++k) p[k] = (p[k] - origin[k]) * factor;
      }
      return points;
    }
    case Base::kCollinear:
      return flat_points<Dim>(n, 1, 1 << uniform_int(random, 1, 20), random);
    case Base::kSliver: {
      auto points = flat_points<Dim>(n, kHyperplane, 1 << uniform_int(random, 10, 26), random);
      points[random() % n][random() % Dim] += 1;
      return points;
    }
    case Base::kThin: {
      auto points = test::candidate_cloud<Dim>(test::Cloud::kUniform, n, random);
      const std::size_t axis = random() % Dim;
      for (auto& p : points) p[axis] *= 0x1p-40;
      return points;
    }
    case Base::kTwoScales:
      return test::candidate_cloud<Dim>(test::Cloud::kTwoScales, n, random);
    case Base::kRoundedSphere:
      return test::candidate_cloud<Dim>(test::Cloud::kRoundedSphere, n, random);
  }
  return {};
}
template std::vector<Point2> base_points<2>(Base, std::size_t, Random&);
template std::vector<Point3> base_points<3>(Base, std::size_t, Random&);

}  // namespace sinkmesh::stress
