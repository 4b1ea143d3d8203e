// SPDX-License-Identifier: MIT
//
// Whether a point may be inserted: what its prestar must not meet [EG01, 5.1].
#pragma once

#include <cstdint>

#include "core/triangulation.h"
#include "core/vector.h"
#include "refine/domain.h"

namespace sinkmesh {

/// What became of a candidate.
enum class Verdict : std::uint8_t { inserted, boundary, crossing, separation, dependent };

/// What is left of a squared distance when the error of its computation is taken away: a sum of Dim squares of
/// rounded differences has a relative error below (Dim+2) 2^-53.
inline constexpr double kSurely = 1 - 0x1p-50;

/// Guide of a search for a prestar: watches the boundary, the separation, and vertices that another point has
/// taken. Of the prestars that it lets through the search has found the whole, and replacing one by a star
/// keeps every wall, and the domain stable.
template <int Dim, class IsTaken>
class PointGuide {
 public:
  /// @param x         gated; outlives the guide.
  /// @param least2    squared distance that x must have from all vertices of the closure of its prestar.
  /// @param is_taken  asked for each of these vertices; a claim ends the search with the verdict `dependent`.
  PointGuide(const Triangulation<Dim>& triangulation, const Domain<Dim>& domain, const Point<Dim>& x,
             double least2, IsTaken& is_taken)
      : triangulation_(&triangulation), domain_(&domain), x_(&x), least2_(least2), is_taken_(&is_taken) {}

  /// Of a search that has been given up, or has come to its end; `inserted` means: could be inserted.
  Verdict verdict() const { return crossed_ && verdict_ == Verdict::inserted ? Verdict::crossing : verdict_; }

  /// All corners of the first simplex.
  bool start(Simplex s) {
    for (int i = 0; i <= Dim; ++i) {
      if (!meet(triangulation_->complex().corner(s, i))) return false;
    }
    return true;
  }
  bool enter(HalfFacet entry) { return meet(triangulation_->complex().apex(entry)); }

  Passage cross(HalfFacet inner, HalfFacet outer) {
    if (!domain_->is_wall(inner)) [[likely]] {
      return Passage::pass;
    }
    const Complex<Dim>& complex = triangulation_->complex();
    const Predicates<Dim>& predicates = triangulation_->predicates();
    if (predicates.diametral_side(complex.facet_corners(inner), *x_) <= 0) {
      verdict_ = Verdict::boundary;
      return Passage::stop;
    }
    // Goes on after a crossing: a boundary facet met later may hold x in its diametral sphere, which is the
    // reason that is reported, whatever the order of the search.
    crossed_ = crossed_ || in_conflict(complex, predicates, Complex<Dim>::simplex_of(outer), *x_);
    return Passage::wall;
  }

 private:
  bool meet(Vertex v) {
    if ((*is_taken_)(v)) {
      verdict_ = Verdict::dependent;
      return false;
    }
    if (!(squared_distance(*x_, triangulation_->complex().point(v)) * kSurely >= least2_)) {
      verdict_ = Verdict::separation;
      return false;
    }
    return true;
  }

  const Triangulation<Dim>* triangulation_;
  const Domain<Dim>* domain_;
  const Point<Dim>* x_;
  double least2_;
  IsTaken* is_taken_;
  Verdict verdict_ = Verdict::inserted;
  bool crossed_ = false;
};

}  // namespace sinkmesh
