// SPDX-License-Identifier: MIT
//
// The index of a cell along the Hilbert curve, in any dimension, from a table of states made at compile time.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace sinkmesh {

/// Hamilton's form of the curve (Compact Hilbert Indices, 2006): within one level the 2^Dim cells are visited
/// in the order of the Gray code, turned by a state (entry corner, direction); the state of a cell follows from
/// its place in that order. There are 2^Dim * Dim states.
template <int Dim>
class HilbertCurve {
 public:
  /// Bits for each axis, such that an index has at most 30.
  static constexpr int kLevels = 30 / Dim;

  /// @param cell  coordinates of a cell, each below 2^kLevels.
  static constexpr std::uint32_t index(const std::array<std::uint32_t, Dim>& cell) {
    std::uint32_t state = 0;
    std::uint32_t result = 0;
    for (int level = kLevels - 1; level >= 0; --level) {
      std::uint32_t bits = 0;
      for (int k = 0; k < Dim; ++k) bits |= (cell[static_cast<std::size_t>(k)] >> level & 1U) << k;
      const Step step = kSteps[state][bits];
      result = result << Dim | step.place;
      state = step.next;
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kCells = 1U << Dim;
  struct Step {
    std::uint8_t place;  // of the cell in the order of its level
    std::uint8_t next;   // state within the cell: entry * Dim + direction
  };

  static constexpr std::uint32_t rotate_right(std::uint32_t bits, std::uint32_t by) {
    by %= Dim;
    return (bits >> by | bits << (Dim - by)) & (kCells - 1);
  }
  static constexpr std::uint32_t rotate_left(std::uint32_t bits, std::uint32_t by) {
    return rotate_right(bits, Dim - by % Dim);
  }
  static constexpr std::uint32_t gray(std::uint32_t i) { return i ^ i >> 1; }
  static constexpr std::uint32_t inverse_gray(std::uint32_t g) {
    for (std::uint32_t shift = 1; shift < Dim; shift *= 2) g ^= g >> shift;
    return g;
  }
  static constexpr std::uint32_t entry(std::uint32_t place) {
    return place == 0 ? 0 : gray(2 * ((place - 1) / 2));
  }
  static constexpr std::uint32_t direction(std::uint32_t place) {
    if (place == 0) return 0;
    return static_cast<std::uint32_t>(std::countr_one(place % 2 == 0 ? place - 1 : place)) % Dim;
  }

  static constexpr std::array<std::array<Step, kCells>, kCells* Dim> kSteps = [] {
    std::array<std::array<Step, kCells>, kCells * Dim> steps{};
    for (std::uint32_t e = 0; e < kCells; ++e) {
      for (std::uint32_t d = 0; d < Dim; ++d) {
        for (std::uint32_t bits = 0; bits < kCells; ++bits) {
          const std::uint32_t place = inverse_gray(rotate_right(bits ^ e, d + 1));
          const std::uint32_t next_entry = e ^ rotate_left(entry(place), d + 1);
          const std::uint32_t next_direction = (d + direction(place) + 1) % Dim;
          steps[e * Dim + d][bits] = {static_cast<std::uint8_t>(place),
                                      static_cast<std::uint8_t>(next_entry * Dim + next_direction)};
        }
      }
    }
    return steps;
  }();
};

}  // namespace sinkmesh
