// SPDX-License-Identifier: MIT
//
// The set of sinks of one simplex, the steepest way first.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "refine/flow.h"
#include "refine/steepest_order.h"

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
    // The steepest last, since the stack is taken from its end.
    order_.sort(complex, std::span(stack_).subspan(first));
    return count;
  }

  std::vector<Simplex> stack_;
  SteepestOrder<Dim> order_;
  std::vector<std::uint64_t> met_;  // by simplex: the last search that met it
  std::uint64_t search_ = 0;
};

}  // namespace sinkmesh
