// SPDX-License-Identifier: MIT
#include "refine/flow.h"

#include <algorithm>

namespace sinkmesh {

template <int Dim>
unsigned Flow<Dim>::evaluate(HalfFacet h) const {
  const Complex<Dim>& c = complex();
  if (c.is_ghost(Complex<Dim>::simplex_of(h))) return 1;
  const int side = triangulation_->predicates().flow_side(c.facet_corners(h), c.point(c.apex(h)));
  return side < 0 ? 0x11 : 1;
}

template <int Dim>
void Flow<Dim>::begin_search() {
  if (seen_.size() < complex().num_slots()) seen_.resize(complex().num_slots(), 0);
  if (++search_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0U);
    search_ = 1;
  }
}

template <int Dim>
std::vector<Simplex> Flow<Dim>::successors(Simplex s) {
  std::vector<Simplex> result;
  for (int i = 0; i <= Dim; ++i) {
    if (crosses(Complex<Dim>::half_facet(s, i))) result.push_back(complex().neighbor(s, i));
  }
  return result;
}

template <int Dim>
std::vector<Simplex> Flow<Dim>::sinks() {
  std::vector<Simplex> result;
  for (const Simplex s : complex().simplices()) {
    if (is_sink(s)) result.push_back(s);
  }
  return result;
}

template <int Dim>
std::vector<Simplex> Flow<Dim>::sinks_reached(const std::vector<Simplex>& sources) {
  begin_search();
  std::vector<Simplex> reached;
  std::vector<Simplex> result;
  for (const Simplex s : sources) {
    if (meet(s)) reached.push_back(s);
  }
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const Simplex s = reached[next];
    bool has_successor = complex().is_ghost(s);
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (!crosses(h)) continue;
      has_successor = true;
      const Simplex t = Complex<Dim>::simplex_of(complex().mate(h));
      if (meet(t)) reached.push_back(t);
    }
    if (!has_successor) result.push_back(s);
  }
  return result;
}

template <int Dim>
std::vector<Simplex> Flow<Dim>::ancestors(const std::vector<Simplex>& targets) {
  begin_search();
  std::vector<Simplex> result;
  for (const Simplex s : targets) {
    if (meet(s)) result.push_back(s);
  }
  for (std::size_t next = 0; next < result.size(); ++next) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet into = complex().mate(Complex<Dim>::half_facet(result[next], i));
      const Simplex s = Complex<Dim>::simplex_of(into);
      if (crosses(into) && meet(s)) result.push_back(s);
    }
  }
  return result;
}

template class Flow<2>;
template class Flow<3>;

}  // namespace sinkmesh
