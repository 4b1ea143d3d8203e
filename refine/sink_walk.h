// SPDX-License-Identifier: MIT
//
// The set of sinks of one simplex, the steepest way first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "refine/flow.h"
#include "refine/quality.h"

namespace sinkmesh {

/// Depth-first search along the flow. Holds working memory only; keep one and reuse it.
template <int Dim>
class SinkWalk {
 public:
  /// Calls visit(sink) for the sinks of s, until it returns true. At each simplex the successor with the
  /// largest circumsphere comes first: the flow leads to larger ones, so this is the longest way down. Each
  /// simplex is met once; the visitor may change the complex when it returns true.
  /// @return whether it did.
  template <class Visit>
  bool operator()(Flow<Dim>& flow, Simplex s, Visit&& visit) {
    const Complex<Dim>& complex = flow.complex();
    ++search_;
    stack_.clear();
    stack_.push_back(s);
    while (!stack_.empty()) {
      const Simplex at = stack_.back();
      stack_.pop_back();
      if (!meet(complex, at) || complex.is_ghost(at)) continue;
      if (push_successors(flow, at) == 0 && visit(at)) return true;
    }
    return false;
  }

 private:
  // Whether this search meets s for the first time.
  bool meet(const Complex<Dim>& complex, Simplex s) {
    if (s.index() >= met_.size()) met_.resize(complex.records().capacity(), 0);
    return std::exchange(met_[s.index()], search_) != search_;
  }

  int push_successors(Flow<Dim>& flow, Simplex s) {
    const Complex<Dim>& complex = flow.complex();
    const std::size_t first = stack_.size();
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (flow.crosses(h)) stack_.push_back(Complex<Dim>::simplex_of(complex.mate(h)));
    }
    const auto count = static_cast<int>(stack_.size() - first);
    if (count > 1) sort_by_radius(complex, first);
    return count;
  }

  // The largest last, since the stack is taken from its end; equal ones by their corners.
  void sort_by_radius(const Complex<Dim>& complex, std::size_t first) {
    keys_.clear();
    for (std::size_t i = first; i < stack_.size(); ++i) {
      const Simplex s = stack_[i];
      Key key{complex.is_ghost(s) ? HUGE_VAL : shape<Dim>(complex.corners(s)).radius2, {}, s};
      for (int k = 0; k <= Dim; ++k)
        key.corners[static_cast<std::size_t>(k)] = complex.point(complex.corner(s, k));
      std::sort(key.corners.begin(), key.corners.end());
      keys_.push_back(key);
    }
    std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
      return a.radius2 != b.radius2 ? a.radius2 < b.radius2 : a.corners < b.corners;
    });
    for (std::size_t i = 0; i < keys_.size(); ++i) stack_[first + i] = keys_[i].simplex;
  }

  struct Key {
    double radius2;
    std::array<Point<Dim>, Dim + 1> corners;
    Simplex simplex;
  };

  std::vector<Simplex> stack_;
  std::vector<Key> keys_;
  std::vector<std::uint64_t> met_;  // by simplex: the last search that met it
  std::uint64_t search_ = 0;
};

}  // namespace sinkmesh
