// SPDX-License-Identifier: MIT
//
// Point sets at the weak spots of predicates. A set is a degenerate position (a base), placed by an exact
// similarity or by a rounded map, and possibly left by a few units in the last place.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "predicates/point.h"
#include "test/support/clouds.h"

namespace sinkmesh::stress {

using test::Random;

/// What the points have in common, exactly, before they are placed.
enum class Base {
  kUniform,       ///< nothing
  kGrid,          ///< small integers, in different units along the axes
  kBoxCorners,    ///< corners of a box of integers
  kSpheres,       ///< on two orthogonal spheres of one size, small integers, two of them antipodal
  kPythagorean,   ///< on one sphere, integers of up to about 30 bits, two of them antipodal
  kGreatCircle,   ///< all but the last on a great circle of a sphere of integers, the last on the sphere
  kFlat,          ///< on a hyperplane
  kFlatScales,    ///< on a hyperplane, at distances of very different orders from one of its points
  kCollinear,     ///< on a line
  kSliver,        ///< one unit beside a hyperplane, far apart
  kThin,          ///< one axis 2^-40 times as long as the others
  kTwoScales,     ///< every other one 2^-40 times as far from the origin
  kRoundedSphere  ///< rounded onto a sphere
};
inline constexpr std::array kAllBases{
    Base::kUniform,     Base::kGrid,      Base::kBoxCorners,   Base::kSpheres,   Base::kPythagorean,
    Base::kGreatCircle, Base::kFlat,      Base::kFlatScales,   Base::kCollinear, Base::kSliver,
    Base::kThin,        Base::kTwoScales, Base::kRoundedSphere};

template <int Dim>
std::vector<Point<Dim>> base_points(Base base, std::size_t n, Random& random);

/// Maps all points: by nothing, an integer rotation, magnification and translation (exact while the integers
/// have 53 bits), a factor that is no power of two (rounds), or a large offset (rounds off detail).
template <int Dim>
void place(std::vector<Point<Dim>>& points, Random& random);

/// Moves one to three coordinates by a few units in the last place, or by a small power of two.
template <int Dim>
void nudge(std::vector<Point<Dim>>& points, Random& random);

/// One of all of it.
/// @param favourites  every other set has one of these bases, if there are any.
template <int Dim>
std::vector<Point<Dim>> make_position(std::size_t n, std::span<const Base> favourites, Random& random);

}  // namespace sinkmesh::stress
