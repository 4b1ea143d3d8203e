// SPDX-License-Identifier: MIT
//
// Where predicates promise exact signs, and cases inside, at the border of, and beyond it.
#pragma once

#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "predicates/input_gate.h"
#include "test/stress/case.h"
#include "test/stress/positions/positions.h"

namespace sinkmesh::stress {

/// By the names that case files use.
inline constexpr std::string_view kRaw = "raw";        ///< exponents within the range of the predicate
inline constexpr std::string_view kGated = "gated";    ///< on the grid of the gate
inline constexpr std::string_view kBeyond = "beyond";  ///< any finite doubles: only integer stages are sound

/// The exponents of nonzero coordinates that a polynomial of this degree takes [PS, 11].
constexpr std::pair<int, int> exponent_range(int degree) {
  constexpr std::pair<int, int> kRanges[] = {{-485, 509}, {-306, 338}, {-216, 252}, {-162, 201},
                                             {-127, 167}, {0, 0},      {-82, 124}};
  return kRanges[degree - 2];
}

template <std::size_t Dim>
bool in_range(const std::vector<std::array<double, Dim>>& points, int degree) {
  const auto [low, high] = exponent_range(degree);
  for (const auto& p : points) {
    for (const double x : p) {
      if (!std::isfinite(x) || (x != 0 && (std::ilogb(x) < low || std::ilogb(x) > high))) return false;
    }
  }
  return true;
}

template <std::size_t Dim>
bool is_gated(const std::vector<std::array<double, Dim>>& points) {
  for (const auto& p : points) {
    for (const double x : p) {
      const double units = std::ldexp(x, kGridBits);
      if (!(std::abs(x) < 2) || units != std::nearbyint(units)) return false;
    }
  }
  return true;
}

template <std::size_t Dim>
bool is_finite(const std::vector<std::array<double, Dim>>& points) {
  for (const auto& p : points) {
    for (const double x : p) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

/// A point set for a polynomial of this degree, and its regime.
template <int Dim>
std::string_view make_points(int degree, std::size_t n, std::span<const Base> favourites, Random& random,
                             std::vector<Point<Dim>>& points) {
  const auto [low, high] = exponent_range(degree);
  switch (random() % 32) {
    case 0:
      points = test::make_wide_cloud<Dim>(-1074, 1022, n, random);
      return kBeyond;
    case 1: {
      points = make_position<Dim>(n, favourites, random);
      const int e = test::uniform_int(random, -1074, 950);
      for (auto& p : points) {
        for (double& x : p) x = std::ldexp(x, e);
      }
      return is_finite(points) ? kBeyond : make_points<Dim>(degree, n, favourites, random, points);
    }
    case 2:
    case 3:
      points = test::make_wide_cloud<Dim>(low, high, n, random);
      return kRaw;
    case 4:
      points = test::make_wide_cloud<Dim>(-kGridBits, 0, n, random);
      break;
    default:
      points = make_position<Dim>(n, favourites, random);
      if (random() % 2 == 0 && in_range(points, degree)) return kRaw;
  }
  const InputGate<Dim> gate(points);
  for (auto& p : points) p = gate.in(p);
  return kGated;
}

}  // namespace sinkmesh::stress
