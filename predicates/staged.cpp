// SPDX-License-Identifier: MIT
#include "predicates/staged.h"

#include <algorithm>

#include "predicates/detail/grid.h"
#include "predicates/detail/symbolic.h"

namespace sinkmesh {
namespace detail {

template <class P>
void Filter<P>::update(const Point<P::kDim>& extents, int granularity) {
  error = error_within<P>(extents);
  const int bits = P::kDegree * granularity;
  unit = bits <= 1022 ? std::ldexp(1.0, -bits) : 0;
}

}  // namespace detail

template <int Dim>
Predicates<Dim>::Predicates(const Box<Dim>& box, int granularity) : box_(box), granularity_(granularity) {
  update();
}

template <int Dim>
void Predicates<Dim>::include(const Point<Dim>& p) {
  int granularity = granularity_;
  for (const double x : p) granularity = std::max(granularity, detail::fraction_bits(x));
  if (box_.contains(p) && granularity == granularity_) return;
  box_.include(p);
  granularity_ = granularity;
  update();
}

/// An extent is the largest rounded difference of two coordinates, because rounding is monotone.
template <int Dim>
void Predicates<Dim>::update() {
  Point<Dim> extents;
  for (std::size_t k = 0; k < Dim; ++k) extents[k] = std::max(0.0, box_.high[k] - box_.low[k]);
  const auto update_filter = [&]<class P>(detail::Filter<P>& filter) { filter.update(extents, granularity_); };
  update_filter.template operator()<detail::Orientation<Dim>>(filters_);
  update_filter.template operator()<detail::InSphere<Dim>>(filters_);
  update_filter.template operator()<detail::Diametral<Dim>>(filters_);
  update_filter.template operator()<detail::FacetNormals<Dim>>(filters_);
  update_filter.template operator()<detail::Orthogonality<Dim>>(filters_);
}

template <int Dim>
int Predicates<Dim>::in_sphere_at_tie(const detail::Points<detail::InSphere<Dim>>& points) const {
  return detail::in_sphere_at_tie<Dim>(points, [this](const Corners<Dim>& s) { return orient(s); });
}

template <int Dim>
int Predicates<Dim>::flow_at_tie(const detail::Points<detail::Diametral<Dim>>& points) const {
  using Normals = detail::FacetNormals<Dim>;
  return detail::flow_at_tie<Dim>(
      points, [this](const detail::Points<Normals>& normals) { return verdict<Normals>(normals).sign; });
}

/// The polynomial is the value times both volumes.
template <int Dim>
int Predicates<Dim>::orthogonality(const Corners<Dim>& s, const Corners<Dim>& t) const {
  detail::Points<detail::Orthogonality<Dim>> points;
  std::copy(s.begin(), s.end(), points.begin());
  std::copy(t.begin(), t.end(), points.begin() + Dim + 1);
  return verdict<detail::Orthogonality<Dim>>(points).sign * orient(s) * orient(t);
}

template class Predicates<2>;
template class Predicates<3>;

}  // namespace sinkmesh
