// SPDX-License-Identifier: MIT
#include "core/bulk_search.h"

#include <algorithm>
#include <cmath>

#include "core/location.h"
#include "core/vector.h"

namespace sinkmesh {
namespace {

// How far the simplex reaches from p.
template <int Dim>
double reach2(const Complex<Dim>& complex, Simplex s, const Point<Dim>& p) {
  double reach = 0;
  for (const Point<Dim>* q : complex.corners(s)) reach = std::max(reach, squared_distance(*q, p));
  return reach;
}

constexpr int kLongWalk = 8;
constexpr int kPatience = 32;

}  // namespace

template <int Dim>
Simplex BulkSearch<Dim>::find(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                              const Point<Dim>& p) {
  const bool starts_on_hull = complex.is_ghost(at_) && trust_in_the_hull_ > -kPatience;
  if (starts_on_hull && find_over_hull(complex, predicates, p)) {
    trust_in_the_hull_ = std::min(trust_in_the_hull_ + 1, kPatience);
    steps_ = 0;
    return at_;
  }
  if (starts_on_hull) --trust_in_the_hull_;
  const Location<Dim> found = walk_to_conflict(complex, predicates, p, at_);
  steps_ = found.steps;
  return found.simplex;
}

// From ghost to ghost, as long as that brings a vertex nearer to p for a farther one; so it ends. Not found,
// the last ghost is a start as good as any.
template <int Dim>
bool BulkSearch<Dim>::find_over_hull(const Complex<Dim>& complex, const Predicates<Dim>& predicates,
                                     const Point<Dim>& p) {
  const auto is_found = [&](Simplex ghost) { return ghost_in_conflict<Dim>(complex, predicates, ghost, p); };
  for (;;) {
    if (is_found(at_)) return true;
    double nearest = HUGE_VAL;
    Simplex next;
    for (int i = 0; i < Dim; ++i) {
      const HalfFacet beyond = complex.mate(Complex<Dim>::half_facet(at_, i));
      const double d = squared_distance(complex.point(complex.apex(beyond)), p);
      if (d >= nearest || d >= squared_distance(complex.point(complex.corner(at_, i)), p)) continue;
      nearest = d;
      next = Complex<Dim>::simplex_of(beyond);
    }
    if (next.is_null()) break;
    at_ = next;
  }
  for (int i = 0; i < Dim; ++i) {
    const Simplex beside = complex.neighbor(at_, i);
    if (!is_found(beside)) continue;
    at_ = beside;
    return true;
  }
  return false;
}

template <int Dim>
void BulkSearch<Dim>::settle(const Complex<Dim>& complex, const Cavity<Dim>& cavity, Vertex v) {
  at_ = cavity.star(0);
  if (steps_ != 0 && steps_ <= kLongWalk) return;
  const Point<Dim>& p = complex.point(v);
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
    const Simplex s = cavity.star(i);
    if (complex.is_ghost(s)) {
      if (trust_in_the_hull_ <= -kPatience) continue;
      at_ = s;
      return;
    }
    const double reach = reach2<Dim>(complex, s, p);
    if (reach >= least) continue;
    least = reach;
    at_ = s;
  }
}

template class BulkSearch<2>;
template class BulkSearch<3>;

}  // namespace sinkmesh
