// SPDX-License-Identifier: MIT
#include "tools/models/outline_simplifier.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

#include "core/triangulation.h"
#include "core/vector.h"
#include "predicates/predicates.h"

namespace sinkmesh::models {
namespace {

using Id = std::uint32_t;

// Ids of the outline's points, the least important last: the one that spans the smallest triangle with its
// neighbors is taken away, again and again, and none counts less than one taken away before it (Visvalingam,
// Whyatt 1993).
std::vector<Id> by_importance(const std::vector<Point2>& outline) {
  const auto n = static_cast<Id>(outline.size());
  std::vector<Id> next(n);
  std::vector<Id> previous(n);
  std::vector<double> area(n);
  for (Id i = 0; i < n; ++i) {
    next[i] = (i + 1) % n;
    previous[i] = (i + n - 1) % n;
  }
  const auto area_at = [&](Id i) {
    const Point2& a = outline[previous[i]];
    return std::abs(cross(outline[next[i]] - a, outline[i] - a)) / 2;
  };
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto set_area = [&](Id i, double value) {
    area[i] = value;
    queue.push({value, i});
  };
  for (Id i = 0; i < n; ++i) set_area(i, area_at(i));
  std::vector<Id> removed;
  std::vector<bool> is_removed(n);
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (is_removed[i] || value != area[i]) continue;
    is_removed[i] = true;
    removed.push_back(i);
    next[previous[i]] = next[i];
    previous[next[i]] = previous[i];
    for (const Id j : {previous[i], next[i]}) set_area(j, std::max(area_at(j), value * (1 + 1e-12)));
  }
  std::reverse(removed.begin(), removed.end());
  return removed;
}

// The outline as a closed curve: points at whole parameters, straight in between.
class Curve {
 public:
  explicit Curve(std::vector<Point2> points) : points_(std::move(points)) {}

  double length() const { return static_cast<double>(points_.size()); }

  Point2 at(double t) const {
    const auto i = static_cast<std::size_t>(t);
    const double f = t - std::floor(t);
    const Point2& a = points_[i % points_.size()];
    if (f == 0) return a;
    const Point2& b = points_[(i + 1) % points_.size()];
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])};
  }

  // Where to divide the edge between the points at s < t: at the corner of the curve between them that is
  // nearest to the middle; where there is none, about the middle. Beside a corner, at a distance from it that
  // is a power of two: otherwise edges that meet at a sharp angle would go on encroaching on each other
  // (Ruppert 1995).
  double divide(double s, double t) const {
    const Point2 a = at(s);
    const Point2 b = at(t);
    const Point2 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    double best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (double k = std::floor(s) + 1; k < t; ++k) {
      const double distance2 = squared_distance(at(k), middle);
      if (distance2 < least) {
        least = distance2;
        best = k;
      }
    }
    if (std::isfinite(least)) return best;
    const bool from_start = is_corner(s);
    if (from_start == is_corner(t)) return (s + t) / 2;
    const double edge = std::sqrt(squared_distance(a, b));
    const double share = std::exp2(std::round(std::log2(edge / 2))) / edge;
    return from_start ? s + share * (t - s) : t - share * (t - s);
  }

 private:
  static bool is_corner(double t) { return t == std::floor(t); }

  std::vector<Point2> points_;
};

// Edges, as the numbers of their first vertices, that are no edges of the Delaunay triangulation of the
// polygon's vertices, or have the apex of their inner triangle in or on their diametral circle.
std::vector<std::size_t> bad_edges(const std::vector<Point2>& polygon) {
  const Triangulation2 triangulation(polygon);
  const Complex<2>& complex = triangulation.complex();
  std::vector<bool> is_good(polygon.size());
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = complex.facet(Complex<2>::half_facet(s, i));
      if (b.index() != (a.index() + 1) % polygon.size()) continue;
      const Point2& apex = polygon[complex.corner(s, i).index()];
      is_good[a.index()] = diametral_side(polygon[a.index()], polygon[b.index()], apex) > 0;
    }
  }
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!is_good[i]) bad.push_back(i);
  }
  return bad;
}

// A polygon with vertices on the curve, by increasing parameter.
using Parameters = std::vector<double>;

class Simplifier {
 public:
  explicit Simplifier(const std::vector<Point2>& points) : curve_(points), importance_(by_importance(points)) {}

  Parameters simplify(std::size_t vertices) const {
    std::size_t low = 3;
    std::size_t high = std::min(vertices + 1, importance_.size() + 1);
    Parameters result = divided(low);
    while (low + 1 < high) {
      const std::size_t middle = (low + high) / 2;
      Parameters attempt = divided(middle);
      if (attempt.size() <= vertices) {
        low = middle;
        result = std::move(attempt);
      } else {
        high = middle;
      }
    }
    for (std::size_t i = low; i < importance_.size() && result.size() < vertices; ++i) {
      Parameters longer = with(result, {static_cast<double>(importance_[i])});
      if (longer.size() > result.size() && bad_edges(points(longer)).empty()) result = std::move(longer);
    }
    return result;
  }

  std::vector<Point2> points(const Parameters& polygon) const {
    std::vector<Point2> points;
    for (const double t : polygon) points.push_back(curve_.at(t));
    return points;
  }

 private:
  // The most important points, and those that it takes to make all edges good. Ends because edges get shorter,
  // and short ones are good, Ruppert's argument; the bound on rounds is for outlines that touch themselves.
  Parameters divided(std::size_t count) const {
    Parameters polygon(importance_.begin(), importance_.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(polygon.begin(), polygon.end());
    for (int round = 0; round < 1000; ++round) {
      const std::vector<std::size_t> bad = bad_edges(points(polygon));
      if (bad.empty()) return polygon;
      Parameters more;
      for (const std::size_t i : bad) {
        const bool is_last = i + 1 == polygon.size();
        const double t = curve_.divide(polygon[i], is_last ? polygon[0] + curve_.length() : polygon[i + 1]);
        more.push_back(t < curve_.length() ? t : t - curve_.length());
      }
      polygon = with(std::move(polygon), more);
    }
    throw std::logic_error("the outline does not become Delaunay");
  }

  static Parameters with(Parameters polygon, const Parameters& more) {
    polygon.insert(polygon.end(), more.begin(), more.end());
    std::sort(polygon.begin(), polygon.end());
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    return polygon;
  }

  Curve curve_;
  std::vector<Id> importance_;
};

}  // namespace

std::vector<Point2> simplify_outline(const std::vector<Point2>& curve, std::size_t vertices) {
  const Simplifier simplifier(curve);
  return simplifier.points(simplifier.simplify(vertices));
}

}  // namespace sinkmesh::models
