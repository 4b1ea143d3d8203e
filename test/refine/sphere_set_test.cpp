// SPDX-License-Identifier: MIT
#include "refine/sphere_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "predicates/circumcenter.h"
#include "predicates/predicates.h"
#include "refine/quality.h"

namespace sinkmesh {
namespace {

SphereSet<3>::Sphere random_sphere(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (;;) {
    SphereSet<3>::Sphere sphere;
    std::array<Point3, 4>& points = sphere.corners.emplace();
    const Point3 at = {uniform(random), uniform(random), uniform(random)};
    for (Point3& p : points) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = at[k] * 0.9 + size * 0.1 * uniform(random);
    }
    const Corners<3> corners = {&points[0], &points[1], &points[2], &points[3]};
    if (!circumcenter(corners, sphere.center)) continue;
    sphere.radius2 = shape<3>(corners).radius2;
    return sphere;
  }
}

// Offers the spheres one by one; returns how many were kept.
std::size_t keep_as_all_pairs_do(const std::vector<SphereSet<3>::Sphere>& spheres) {
  const Predicates<3> predicates({{-2, -2, -2}, {2, 2, 2}}, 121);
  SphereSet<3> set(predicates);
  std::vector<SphereSet<3>::Sphere> kept;
  for (const auto& sphere : spheres) {
    const bool expected = std::all_of(kept.begin(), kept.end(), [&](const auto& other) {
      return orthogonality(*sphere.corners, *other.corners) >= 0;
    });
    EXPECT_EQ(set.is_orthogonal_to_all(sphere), expected);
    if (!expected) continue;
    set.add(sphere);
    kept.push_back(sphere);
  }
  return kept.size();
}

TEST(SphereSet, AgreesWithTestingAllPairs) {
  std::mt19937_64 random(5);
  std::vector<SphereSet<3>::Sphere> spheres;
  for (int i = 0; i < 3000; ++i)
    spheres.push_back(random_sphere(random, std::ldexp(1.0, -static_cast<int>(random() % 8))));
  std::sort(spheres.begin(), spheres.end(), [](const auto& a, const auto& b) { return a.radius2 > b.radius2; });
  const std::size_t kept = keep_as_all_pairs_do(spheres);
  EXPECT_GT(kept, 50U);
  EXPECT_LT(kept, spheres.size() / 2);
}

// A large sphere that comes late must not look at every cell of the size of the smallest ones: there are 2^100.
TEST(SphereSet, TakesSpheresOfAllSizesInAnyOrder) {
  std::mt19937_64 random(9);
  std::vector<SphereSet<3>::Sphere> spheres;
  for (int i = 0; i < 400; ++i) spheres.push_back(random_sphere(random, std::ldexp(1.0, -i / 12)));
  for (const bool smallest_first : {true, false}) {
    std::sort(spheres.begin(), spheres.end(), [&](const auto& a, const auto& b) {
      return smallest_first ? a.radius2 < b.radius2 : a.radius2 > b.radius2;
    });
    EXPECT_GT(keep_as_all_pairs_do(spheres), 50U);
  }
}

TEST(SphereSet, RefusesACopy) {
  const Predicates<3> predicates({{-2, -2, -2}, {2, 2, 2}}, 121);
  std::mt19937_64 random(6);
  const auto sphere = random_sphere(random, 0.5);
  SphereSet<3> set(predicates);
  EXPECT_TRUE(set.is_orthogonal_to_all(sphere));
  set.add(sphere);
  EXPECT_FALSE(set.is_orthogonal_to_all(sphere));
}

TEST(SphereSet, TakesSpheresWithoutCornersAsTheyAreRounded) {
  const Predicates<3> predicates({{-2, -2, -2}, {2, 2, 2}}, 121);
  SphereSet<3> set(predicates);
  set.add({{0, 0, 0}, 9.0 / 64, {}});
  EXPECT_TRUE(set.is_orthogonal_to_all({{0.625, 0, 0}, 16.0 / 64, {}}));  // 3, 4, 5 eighths
  EXPECT_FALSE(set.is_orthogonal_to_all({{std::nextafter(0.625, 0), 0, 0}, 16.0 / 64, {}}));
  EXPECT_FALSE(set.is_orthogonal_to_all({{0.625, 0, 0}, std::nextafter(16.0 / 64, 1), {}}));

  // One with corners, however exact, is met as it is rounded, too. Its corners are elsewhere here.
  std::mt19937_64 random(7);
  SphereSet<3>::Sphere exact = random_sphere(random, 0.5);
  exact.center = {0.625, 0, 0};
  exact.radius2 = 16.0 / 64;
  EXPECT_TRUE(set.is_orthogonal_to_all(exact));
  exact.center = {0, 0, 0.5};
  EXPECT_FALSE(set.is_orthogonal_to_all(exact));
}

}  // namespace
}  // namespace sinkmesh
