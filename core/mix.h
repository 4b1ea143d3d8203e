// SPDX-License-Identifier: MIT
//
// Hashes of coordinates and of sets of simplices: equal for equal geometry, whatever the numbering.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// A bijection of 64-bit words in which every bit of the argument changes about half the bits of the result
/// (the finaliser of SplitMix64: Steele, Lea, Flood 2014).
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

/// Hash of the coordinates' bits.
template <int Dim>
constexpr std::uint64_t hash_point(const Point<Dim>& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15;
  for (const double x : p) h = mix(h + std::bit_cast<std::uint64_t>(x));
  return h;
}

/// Hash of a set of points, in any order.
template <int Dim, std::size_t N>
constexpr std::uint64_t hash_points(const std::array<const Point<Dim>*, N>& points) {
  std::uint64_t sum = 0;
  for (const Point<Dim>* p : points) sum += hash_point<Dim>(*p);
  return sum;
}

/// Hash of a set of simplices over an indexed set of points, by coordinates.
template <int Dim>
class SimplexSetHash {
 public:
  explicit SimplexSetHash(std::span<const Point<Dim>> points) {
    of_point_.reserve(points.size());
    for (const Point<Dim>& p : points) of_point_.push_back(hash_point<Dim>(p));
  }

  /// Corners in any order.
  void add(const std::array<std::uint32_t, Dim + 1>& simplex) {
    std::array<std::uint64_t, Dim + 1> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = of_point_[simplex[i]];
    std::sort(corners.begin(), corners.end());
    std::uint64_t h = Dim;
    for (const std::uint64_t x : corners) h = mix(h + x);
    sum_ += h;
  }

  std::uint64_t value() const { return mix(sum_); }

 private:
  std::vector<std::uint64_t> of_point_;
  std::uint64_t sum_ = 0;
};

}  // namespace sinkmesh
