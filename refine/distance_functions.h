// SPDX-License-Identifier: MIT
//
// The two square distance functions of a point set, pi_S and phi_S [EG01, 3.1].
#pragma once

#include <optional>

#include "core/cavity.h"
#include "core/triangulation.h"

namespace sinkmesh {

/// pi_S(x) is the square distance to the nearest vertex. phi_S(y) is the smallest weighted square distance
/// |y-z|^2 - r^2 to a Delaunay sphere (z,r). Their extremes are the vertices, where both are 0, and the sinks.
///
/// Points and values are in the units of the input (values: squared). A value is computed from exact integers
/// and rounded, but for pi: the error bounds below are relative to the value itself, and hold for all simplices
/// however flat. Squares below 2^-1022 or above 2^1023 are lost to underflow and overflow.
///
/// The triangulation is as before after each call, but its predicates know the points asked for. Keep one and
/// reuse it: searches start where the last one ended.
template <int Dim>
class DistanceFunctions {
 public:
  explicit DistanceFunctions(Triangulation<Dim>& triangulation) : triangulation_(&triangulation) {}

  struct Pi {
    double value;
    Vertex nearest;  ///< of several at the same rounded distance that with the smallest coordinates
  };
  /// Relative error below 2^-50. Cost: location, and the prestar of x.
  /// @throws InputError if x is not finite, or one of its coordinates not below the first power of two above
  ///         all coordinates of the input.
  Pi pi(const Point<Dim>& x);

  struct Phi {
    double value;
    /// At which the minimum is attained. Where several do, on a common face, the one with the largest sphere;
    /// equal ones by their corners.
    Simplex simplex;
    /// 2 (y - z). Each coordinate has a relative error below 2^-51, plus 2^-97 of the circumradius. On a common
    /// face phi has one gradient for each of its simplices; the negative of the one of the largest sphere is
    /// the direction in which phi falls the fastest: phi = |y-z|^2 - r^2 is the same for all of them, so the
    /// largest r has the longest gradient, and along a direction u the minimum of the simplices' functions
    /// falls like the steepest of them. It is the direction of the flow. At a vertex phi has a local maximum,
    /// and falls that fast, too.
    Point<Dim> gradient;
    bool is_inside_hull;
  };
  /// Relative error of the value below 2^-51; exactly 0 at vertices. Cost: location, and the star of the face
  /// that holds y.
  ///
  /// Inside the hull the minimum is attained by the simplices that hold y. In terms of the lifting to the
  /// paraboloid, |y-z|^2 - r^2 = |y|^2 - h(y), where h is the affine function that agrees with |p|^2 at the
  /// corners p of the simplex; because the sphere is empty, h(q) <= |q|^2 at every other vertex q. So if a
  /// simplex with corners p_i holds y = sum l_i p_i, l_i >= 0, then for the h' of any other simplex
  ///   h'(y) = sum l_i h'(p_i) <= sum l_i |p_i|^2 = h(y),
  /// and -h(y) is the smallest. It is at most 0, since |y|^2 <= sum l_i |p_i|^2, by convexity.
  ///
  /// Outside the hull no location helps: the cells of the power diagram of the Delaunay spheres need not meet
  /// there as the simplices do inside. All spheres are compared, in time linear in the complex. phi need not be
  /// negative there.
  /// @throws InputError as pi().
  Phi phi(const Point<Dim>& y);

 private:
  Point<Dim> gated(const Point<Dim>& p);
  Location<Dim> locate(const Point<Dim>& gated);
  Simplex with_smallest_power(const Point<Dim>& gated) const;
  double in_input_units(double square) const;

  Triangulation<Dim>* triangulation_;
  Cavity<Dim> cavity_;
  Simplex hint_;
};

extern template class DistanceFunctions<2>;
extern template class DistanceFunctions<3>;

}  // namespace sinkmesh
