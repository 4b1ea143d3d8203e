// SPDX-License-Identifier: MIT
//
// Where chains lead, in the rationals of GMP: which facets the flow crosses, from exact circumcenters; which
// successor is the largest, from exact radii; and points on a chain as points between two circumcenters, which
// needs no normal of a facet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/triangulation.h"
#include "test/support/exact_signs.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh::test {

template <int Dim>
class ChainOracle {
 public:
  enum class Part { off_center, voronoi, sink, outside };
  /// One end of a chain. Where two radii differ by less than rounding sees, both ways are right.
  struct End {
    Part part;
    Simplex simplex;      ///< null: outside
    Point<Dim> point{};   ///< rounded
    double distance2{};   ///< of the two facets or edges of the chain there; rounded
    Point<Dim> middle{};  ///< of the shortest edge; off-center only
  };

  explicit ChainOracle(const Triangulation<Dim>& triangulation) : complex_(&triangulation.complex()) {
    known_.resize(complex_->num_slots());
  }

  std::vector<End> ends(Simplex s, double reach2) {
    result_.clear();
    met_.clear();
    if (is_at_least(radius2(s), reach2)) add_off_centers(s, reach2);
    if (!is_surely_at_least(radius2(s), reach2)) follow(s, reach2);
    return result_;
  }

  /// Squared; infinite for ghosts.
  double radius2(Simplex s) {
    return complex_->is_ghost(s) ? std::numeric_limits<double>::infinity() : at(s).radius2;
  }
  const RationalSphere<Dim>& sphere(Simplex s) { return at(s).sphere; }
  /// Facets, by their opposite corners, across which s flows.
  bool crosses(Simplex s, int i) { return at(s).crosses[static_cast<std::size_t>(i)]; }

 private:
  struct Known {
    RationalSphere<Dim> sphere;
    double radius2;
    std::array<bool, Dim + 1> crosses;
  };

  static constexpr double kTolerance = 1e-9;
  static bool is_at_least(double a2, double b2) { return a2 >= b2 * (1 - kTolerance); }
  static bool is_surely_at_least(double a2, double b2) { return a2 >= b2 * (1 + kTolerance); }

  const Known& at(Simplex s) {
    std::optional<Known>& known = known_[s.index()];
    if (known) return *known;
    const auto corners = rational_corners<Dim>(complex_->corners(s));
    known.emplace();
    known->sphere = orthosphere<Dim>(corners);
    known->radius2 = known->sphere.radius2.get_d();
    const auto weight = barycentric<Dim>(corners, known->sphere.center);
    for (int i = 0; i <= Dim; ++i) {
      int sign = sgn(weight[static_cast<std::size_t>(i)]);
      if (sign == 0) {
        const HalfFacet h = Complex<Dim>::half_facet(s, i);
        std::vector<Point<Dim>> points;
        for (const Point<Dim>* p : complex_->facet_corners(h)) points.push_back(*p);
        points.push_back(complex_->point(complex_->apex(h)));
        sign = exact_perturbed_flow<Dim>(ExactPoints<Dim>(points));
      }
      known->crosses[static_cast<std::size_t>(i)] = sign < 0;
    }
    return *known;
  }

  // Between two points given in rationals.
  static Point<Dim> between(const RationalPoint<Dim>& a, const RationalPoint<Dim>& b, double part) {
    Point<Dim> x;
    for (std::size_t k = 0; k < Dim; ++k) {
      x[k] = Rational(a[k] + Rational(std::clamp(part, 0.0, 1.0)) * (b[k] - a[k])).get_d();
    }
    return x;
  }

  void add_off_centers(Simplex s, double reach2) {
    const auto p = rational_corners<Dim>(complex_->corners(s));
    Rational shortest2 = squared_distance(p[0], p[1]);
    for (std::size_t i = 0; i <= Dim; ++i) {
      for (std::size_t j = 0; j < i; ++j) shortest2 = std::min(shortest2, squared_distance(p[i], p[j]));
    }
    for (std::size_t i = 0; i <= Dim; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!is_at_least(shortest2.get_d(), squared_distance(p[i], p[j]).get_d())) continue;
        RationalPoint<Dim> middle;
        for (std::size_t k = 0; k < Dim; ++k) middle[k] = (p[i][k] + p[j][k]) / 2;
        const double way2 = squared_distance(middle, sphere(s).center).get_d();
        const double part = std::sqrt(Rational(Rational(reach2) - shortest2 / 4).get_d() / way2);
        End end{Part::off_center, s, between(middle, sphere(s).center, part), reach2, {}};
        for (std::size_t k = 0; k < Dim; ++k) end.middle[k] = middle[k].get_d();
        result_.push_back(end);
      }
    }
  }

  // From the center of s on.
  void follow(Simplex s, double reach2) {
    if (std::find(met_.begin(), met_.end(), s) != met_.end()) return;
    met_.push_back(s);
    double largest2 = 0;
    std::vector<Simplex> successors;
    for (int i = 0; i <= Dim; ++i) {
      if (!crosses(s, i)) continue;
      successors.push_back(complex_->neighbor(s, i));
      largest2 = std::max(largest2, radius2(successors.back()));
    }
    if (successors.empty()) {
      const auto& center = sphere(s).center;
      const bool is_near =
          std::all_of(center.begin(), center.end(), [](const Rational& x) { return abs(x) <= 2; });
      result_.push_back({is_near ? Part::sink : Part::outside,
                         is_near ? s : Simplex(),
                         between(center, center, 0),
                         radius2(s),
                         {}});
    }
    for (const Simplex t : successors) {
      if (!is_at_least(radius2(t), largest2)) continue;
      if (complex_->is_ghost(t)) {
        result_.push_back({Part::outside, Simplex(), {}, 0, {}});
        continue;
      }
      if (is_at_least(radius2(t), reach2)) result_.push_back(on_voronoi_edge(s, t, reach2));
      if (!is_surely_at_least(radius2(t), reach2)) follow(t, reach2);
    }
  }

  // On the way from one center z to the next, z + u, and from a common corner z + w: the part at which
  // |part u - w|^2 is what it has to be.
  End on_voronoi_edge(Simplex s, Simplex t, double reach2) {
    const auto& from = sphere(s).center;
    const auto& to = sphere(t).center;
    RationalPoint<Dim> corner;
    for (int i = 0; i <= Dim; ++i) {
      if (complex_->neighbor(s, i) != t) corner = rational<Dim>(complex_->point(complex_->corner(s, i)));
    }
    Rational uu = 0;
    Rational uw = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      uu += (to[k] - from[k]) * (to[k] - from[k]);
      uw += (to[k] - from[k]) * (corner[k] - from[k]);
    }
    const double missing = std::max(0.0, Rational(Rational(reach2) - sphere(s).radius2).get_d());
    const double b = -uw.get_d();  // not negative: the distance grows
    const double root = std::sqrt(std::max(0.0, b * b + uu.get_d() * missing));
    const double part = missing == 0 ? 0 : missing / (b + root);
    return {Part::voronoi, t, between(from, to, part), reach2, {}};
  }

  const Complex<Dim>* complex_;
  std::vector<std::optional<Known>> known_;
  std::vector<Simplex> met_;
  std::vector<End> result_;
};

}  // namespace sinkmesh::test
