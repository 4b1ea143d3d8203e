// SPDX-License-Identifier: MIT
#include "refine/places.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/mix.h"
#include "core/vector.h"
#include "predicates/constructions.h"
#include "predicates/input_gate.h"
#include "refine/corner_order.h"

namespace sinkmesh {
namespace {

// Numbers at random from [-1, 1), the same for the same seed (SplitMix64: Steele, Lea, Flood 2014).
class NumberStream {
 public:
  explicit NumberStream(std::uint64_t seed) : state_(mix(seed)) {}

  double next() {
    state_ += 0x9e3779b97f4a7c15;
    return static_cast<double>(static_cast<std::int64_t>(mix(state_)) >> 11) * 0x1p-52;
  }

 private:
  std::uint64_t state_;
};

// Of a simplex with one corner at the origin: Dim! times its volume, positive or negative as the others are
// ordered, and twice that number times its circumcenter.
template <int Dim>
struct Moment {
  double volume;
  Point<Dim> center;
};
Moment<3> moment(const Point3& u, const Point3& v, const Point3& w) {
  const Point3 vw = cross(v, w);
  const Point3 wu = cross(w, u);
  const Point3 uv = cross(u, v);
  Moment<3> result{dot(u, vw), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    result.center[k] = dot(u, u) * vw[k] + dot(v, v) * wu[k] + dot(w, w) * uv[k];
  }
  return result;
}
Moment<2> moment(const Point2& u, const Point2& v) {
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  return {cross(u, v), {uu * v[1] - vv * u[1], vv * u[0] - uu * v[0]}};
}

}  // namespace

// What is behind the gate is on the grid; where rounding made no number, there is no place.
template <int Dim>
void Places<Dim>::add(const Point<Dim>& place) {
  if (std::all_of(place.begin(), place.end(), [](double x) { return std::abs(x) < 2; })) {
    places_.push_back(on_grid<Dim>(place));
  }
}

template <int Dim>
void Places<Dim>::add_random(const Point<Dim>& center, double radius, std::uint64_t seed, int count) {
  NumberStream numbers(seed);
  for (int i = 1; i <= count; ++i) {
    Point<Dim> offset;
    do {
      for (double& x : offset) x = numbers.next();
    } while (dot(offset, offset) > 1);
    for (std::size_t k = 0; k < Dim; ++k) offset[k] = center[k] + radius * i / count * offset[k];
    add(offset);
  }
}

template <int Dim>
const std::vector<Point<Dim>>& Places<Dim>::around(const Complex<Dim>& complex, std::span<const Simplex> star,
                                                   Vertex v, std::uint64_t seed, int count) {
  constexpr double kRadius = 0.5;
  const Point<Dim>& x = complex.point(v);
  link_.clear();
  for (const Simplex s : star) {
    FacetCorners<Dim> corners = complex.facet_corners(Complex<Dim>::half_facet(s, complex.index_of(s, v)));
    sort_corners(corners);
    link_.emplace_back(hash_points<Dim>(corners), corners);
  }
  std::sort(link_.begin(), link_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  double volume = 0;
  double length = 0;
  Point<Dim> optimal{};
  Point<Dim> gravity{};
  for (const auto& [hash, corners] : link_) {
    std::array<Point<Dim>, Dim> edge;
    for (std::size_t i = 0; i < Dim; ++i) edge[i] = *corners[i] - x;
    const Moment<Dim> m = std::apply([](const auto&... e) { return moment(e...); }, edge);
    volume += std::abs(m.volume);
    for (const Point<Dim>& e : edge) length += std::sqrt(dot(e, e));
    for (std::size_t k = 0; k < Dim; ++k) {
      optimal[k] += std::copysign(1.0, m.volume) * m.center[k];
      for (const Point<Dim>& e : edge) gravity[k] += std::abs(m.volume) * e[k];
    }
  }
  for (std::size_t k = 0; k < Dim; ++k) {
    optimal[k] = x[k] + optimal[k] / (2 * volume);
    gravity[k] = x[k] + gravity[k] / ((Dim + 1) * volume);
  }
  places_.clear();
  add(optimal);
  add(gravity);
  add_random(x, kRadius * length / static_cast<double>(link_.size() * Dim), hash_point<Dim>(x) + seed, count);
  return places_;
}

template <int Dim>
const std::vector<Point<Dim>>& Places<Dim>::in_sphere(Corners<Dim> corners, std::uint64_t seed, int count) {
  constexpr double kRadius = 0.9;
  sort_corners(corners);
  Point<Dim> center = vector_to_circumcenter<Dim>(corners, *corners[0]);
  const double radius = std::sqrt(dot(center, center));
  for (std::size_t k = 0; k < Dim; ++k) center[k] += (*corners[0])[k];
  places_.clear();
  add_random(center, kRadius * radius, hash_points<Dim>(corners) + seed, count);
  return places_;
}

template class Places<2>;
template class Places<3>;

}  // namespace sinkmesh
