// SPDX-License-Identifier: MIT
//
// Arguments for predicates: random, exactly degenerate, and next to degenerate.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "bench/point_sets.h"
#include "predicates/input_gate.h"
#include "predicates/polynomials.h"
#include "predicates/staged.h"

namespace sinkmesh::bench {

/// A tie is on the zero set of its polynomial: all points in a hyperplane, all on a sphere, x on the diametral
/// sphere of the facet, two orthogonal spheres.
enum class Input {
  random,        ///< uniform in the unit cube
  integer_tie,   ///< integers, an exact tie
  lattice_tie,   ///< 0.1 i rounded: a tie of the lattice, and of its doubles where they are corners of a box
  rounded_tie,   ///< general points moved onto the tie and rounded there
  scattered_tie  ///< integer_tie, but other points of the set have 53 bits: its granularity proves no zero
};

/// Arguments in a set: more than a branch predictor learns by heart, and small enough for a second-level cache.
inline constexpr std::size_t kInputSize = 4096;

template <class P>
using Arguments = std::array<Point<P::kDim>, P::kPoints>;

class InputRandom : public Uniform {
 public:
  using Uniform::Uniform;
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  int integer(int low, int high) {
    return low + static_cast<int>(generator()() % static_cast<std::uint64_t>(high - low + 1));
  }
};

/// A corner of the box, at random.
template <int Dim>
Point<Dim> corner_of(const Box<Dim>& box, InputRandom& random) {
  Point<Dim> p;
  for (std::size_t k = 0; k < Dim; ++k) p[k] = random.integer(0, 1) != 0 ? box.high[k] : box.low[k];
  return p;
}

/// Another integer or lattice box, with coordinates in 0..20.
template <int Dim>
Box<Dim> small_box(Input input, InputRandom& random) {
  Box<Dim> box;
  const int size = random.integer(1, 4);
  for (std::size_t k = 0; k < Dim; ++k) {
    const int low = random.integer(0, 16);
    const double step = input == Input::lattice_tie ? 0.1 : 1;
    box.low[k] = step * low;
    box.high[k] = step * (low + (input == Input::lattice_tie ? size : random.integer(1, 4)));
  }
  return box;
}

/// On the unit sphere up to rounding.
template <int Dim>
Point<Dim> rounded_direction(InputRandom& random) {
  Point<Dim> p;
  double square = 0;
  do {
    square = 0;
    for (double& x : p) {
      x = random.between(-1, 1);
      square += x * x;
    }
  } while (square > 1 || square < 0.01);
  for (double& x : p) x /= std::sqrt(square);
  return p;
}

/// Exactly on the sphere of squared radius 9 (in the plane 25) around the origin.
template <int Dim>
Point<Dim> integer_direction(InputRandom& random) {
  Point<Dim> p;
  if constexpr (Dim == 2) {
    p = random.integer(0, 1) != 0 ? Point2{3, 4} : Point2{5, 0};
  } else {
    p = random.integer(0, 2) != 0 ? Point3{1, 2, 2} : Point3{3, 0, 0};
  }
  std::shuffle(p.begin(), p.end(), random.generator());
  for (double& x : p) {
    if (random.integer(0, 1) != 0 && x != 0) x = -x;
  }
  return p;
}

// One tie for each polynomial.

template <int Dim>
void make_tie(detail::Orientation<Dim>, Input input, Arguments<detail::Orientation<Dim>>& points,
              InputRandom& random) {
  for (Point<Dim>& p : points) {
    double height = 7;
    for (std::size_t k = 0; k + 1 < Dim; ++k) {
      const int i = random.integer(0, 100);
      p[k] = input == Input::rounded_tie ? random() : input == Input::lattice_tie ? 0.1 * i : i;
      height += (static_cast<double>(k) + (input == Input::rounded_tie ? 0.7 : 1)) * p[k];
    }
    p[Dim - 1] = height;
  }
}

template <int Dim>
void make_tie(detail::InSphere<Dim>, Input input, Arguments<detail::InSphere<Dim>>& points,
              InputRandom& random) {
  const Box<Dim> box = small_box<Dim>(input, random);
  for (Point<Dim>& p : points) {
    p = input == Input::rounded_tie ? rounded_direction<Dim>(random) : corner_of(box, random);
  }
}

template <int Dim>
void make_tie(detail::Diametral<Dim>, Input input, Arguments<detail::Diametral<Dim>>& points,
              InputRandom& random) {
  if (input == Input::rounded_tie) {
    Point<Dim> center;
    for (double& x : center) x = random();
    for (Point<Dim>& p : points) {
      p = rounded_direction<Dim>(random);
      for (std::size_t k = 0; k < Dim; ++k) p[k] = center[k] + 0.3 * p[k];
    }
    // Antipodal corners make the sphere of the others the diametral one.
    for (std::size_t k = 0; k < Dim; ++k) points[1][k] = 2 * center[k] - points[0][k];
    return;
  }
  const Box<Dim> box = small_box<Dim>(input, random);
  for (Point<Dim>& p : points) p = corner_of(box, random);
  for (std::size_t k = 0; k < Dim; ++k) points[1][k] = points[0][k] == box.low[k] ? box.high[k] : box.low[k];
}

template <int Dim>
void make_tie(detail::Orthogonality<Dim>, Input input, Arguments<detail::Orthogonality<Dim>>& points,
              InputRandom& random) {
  constexpr std::size_t kHalf = Dim + 1;
  const double scale = input == Input::rounded_tie   ? random.between(0.01, 0.02)
                       : input == Input::lattice_tie ? 0.1
                                                     : 1;
  const Point<Dim> second = [] {
    if constexpr (Dim == 2) {
      return Point2{7, 1};
    } else {
      return Point3{4, 1, 1};
    }
  }();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = integer_direction<Dim>(random);
    for (std::size_t k = 0; k < Dim; ++k) points[i][k] = scale * (points[i][k] + (i < kHalf ? 0 : second[k]));
  }
}

// How many simplices the points of a polynomial begin with. Its perturbed form needs them to have volume, and
// in-sphere needs a positive one.
template <int Dim>
constexpr std::size_t num_simplices(detail::Orientation<Dim>) {
  return 0;
}
template <int Dim>
constexpr std::size_t num_simplices(detail::InSphere<Dim>) {
  return 1;
}
template <int Dim>
constexpr std::size_t num_simplices(detail::Diametral<Dim>) {
  return 1;
}
template <int Dim>
constexpr std::size_t num_simplices(detail::Orthogonality<Dim>) {
  return 2;
}

/// Orients the simplices; false if that is impossible, or if points are equal.
template <class P>
bool make_legal(Arguments<P>& points) {
  using Volume = detail::Orientation<static_cast<int>(P::kDim)>;
  for (std::size_t i = 0; i < num_simplices(P{}); ++i) {
    const std::size_t first = i * Volume::kPoints;
    detail::Points<Volume> simplex;
    for (std::size_t k = 0; k < Volume::kPoints; ++k) simplex[k] = &points[first + k];
    const double volume = Volume::value(detail::rounded_vectors<Volume>(simplex));
    if (std::abs(volume) < 1e-9) return false;
    if (volume < 0) std::swap(points[first], points[first + 1]);
  }
  Arguments<P> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

/// Arguments for P behind the input gate, and the set-wide predicates of all their points.
template <class P>
class InputSet {
 public:
  explicit InputSet(Input input) : InputSet(input, raw_arguments(input)) {}

  const Predicates<P::kDim>& predicates() const { return predicates_; }
  const std::vector<Arguments<P>>& arguments() const { return arguments_; }
  detail::Points<P> points(std::size_t i) const {
    detail::Points<P> p;
    for (std::size_t k = 0; k < P::kPoints; ++k) p[k] = &arguments_[i][k];
    return p;
  }

 private:
  using PointP = Point<P::kDim>;

  InputSet(Input input, std::vector<Arguments<P>> arguments)
      : InputSet(input, arguments, InputGate<P::kDim>({arguments.front().data(), kInputSize * P::kPoints})) {}

  InputSet(Input input, const std::vector<Arguments<P>>& arguments, const InputGate<P::kDim>& gate)
      : arguments_(arguments), predicates_(gate.box(), gate.granularity()) {
    for (Arguments<P>& points : arguments_) {
      for (PointP& p : points) p = gate.in(p);
    }
    if (input == Input::scattered_tie) {
      PointP fine = gate.box().low;
      fine[0] += std::numeric_limits<double>::epsilon();
      predicates_.include(fine);
    }
  }

  static std::vector<Arguments<P>> raw_arguments(Input input) {
    InputRandom random(7);
    std::vector<Arguments<P>> result;
    while (result.size() < kInputSize) {
      Arguments<P> points;
      if (input == Input::random) {
        for (PointP& p : points) {
          for (double& x : p) x = random();
        }
      } else {
        make_tie(P{}, input, points, random);
      }
      if (make_legal<P>(points)) result.push_back(points);
    }
    return result;
  }

  std::vector<Arguments<P>> arguments_;
  Predicates<P::kDim> predicates_;
};

}  // namespace sinkmesh::bench
