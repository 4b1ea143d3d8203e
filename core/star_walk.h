// SPDX-License-Identifier: MIT
//
// Looking around a vertex, without a set for each look.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/complex.h"

namespace sinkmesh {

/// Visits the simplices around a vertex. Holds working memory only; keep one and reuse it.
template <int Dim>
class StarWalk {
 public:
  /// Calls visit(s) for the simplices with v as a corner, ghosts included, until it returns true.
  /// @return whether it did. Linear in what is visited.
  template <class Visit>
  bool operator()(const Complex<Dim>& complex, Vertex v, Visit&& visit) {
    ++walk_;
    stack_.clear();
    meet(complex, complex.incident_simplex(v));
    while (!stack_.empty()) {
      const Simplex s = stack_.back();
      stack_.pop_back();
      if (visit(s)) return true;
      const int at = complex.index_of(s, v);
      for (int i = 0; i <= Dim; ++i) {
        if (i != at) meet(complex, complex.neighbor(s, i));
      }
    }
    return false;
  }

  /// The half-facet with these corners, one of the two, or null. Looks around the youngest of them.
  HalfFacet find_facet(const Complex<Dim>& complex, const std::array<Vertex, Dim>& corners) {
    const Vertex youngest = *std::max_element(corners.begin(), corners.end());
    HalfFacet found;
    (*this)(complex, youngest, [&](Simplex s) {
      int sum = 0;
      for (const Vertex v : corners) {
        const int at = complex.index_of(s, v);
        if (at < 0) return false;
        sum += at;
      }
      // The numbers of all corners of a simplex add up to Dim (Dim+1) / 2.
      found = Complex<Dim>::half_facet(s, Dim * (Dim + 1) / 2 - sum);
      return true;
    });
    return found;
  }

  bool has_edge(const Complex<Dim>& complex, Vertex u, Vertex v) {
    if (u < v) std::swap(u, v);
    return (*this)(complex, u, [&](Simplex s) { return complex.index_of(s, v) >= 0; });
  }

  /// The vertex nearest to p, by rounded distances. Goes from neighbour to nearer neighbour: in a Delaunay
  /// triangulation a vertex without a nearer neighbour is the nearest.
  Vertex nearest(const Complex<Dim>& complex, const Point<Dim>& p, Vertex start) {
    const auto distance2 = [&](Vertex v) {
      double sum = 0;
      for (std::size_t k = 0; k < Dim; ++k) {
        const double d = complex.point(v)[k] - p[k];
        sum += d * d;
      }
      return sum;
    };
    Vertex best = start;
    double best2 = distance2(start);
    for (Vertex from; from != best;) {
      from = best;
      (*this)(complex, from, [&](Simplex s) {
        for (int i = 0; i <= Dim; ++i) {
          const Vertex v = complex.corner(s, i);
          if (v.is_infinite()) continue;
          const double d2 = distance2(v);
          if (d2 < best2 || (d2 == best2 && complex.point(v) < complex.point(best))) {
            best = v;
            best2 = d2;
          }
        }
        return false;
      });
    }
    return best;
  }

 private:
  void meet(const Complex<Dim>& complex, Simplex s) {
    if (s.index() >= met_.size()) met_.resize(complex.records().capacity(), 0);
    if (std::exchange(met_[s.index()], walk_) != walk_) stack_.push_back(s);
  }

  std::vector<Simplex> stack_;
  std::vector<std::uint64_t> met_;  // by simplex: the last walk that met it
  std::uint64_t walk_ = 0;
};

}  // namespace sinkmesh
