// SPDX-License-Identifier: MIT
//
// Two phases: for each facet those of larger id whose boxes meet its box, and for each of them exact signs.
// No pair is missed: the box of a facet is exact, the extreme coordinates of its corners, so that facets that
// have a point in common have boxes that have.
#include "refine/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "predicates/input_gate.h"
#include "predicates/predicates.h"
#include "predicates/staged.h"
#include "refine/box_forest.h"

namespace sinkmesh {
namespace {

// Moves the corners that are common to the front of both. Returns their number.
template <std::size_t N, class P>
std::size_t align(std::array<P, N>& s, std::array<P, N>& t) {
  std::size_t common = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const auto found = std::find_if(t.begin() + common, t.end(), [&](P p) { return *p == *s[i]; });
    if (found == t.end()) continue;
    std::swap(s[i], s[common]);
    std::swap(*found, t[common]);
    ++common;
  }
  return common;
}

bool is_degenerate(const FacetCorners<2>& s) { return *s[0] == *s[1]; }

// Segments whose boxes meet.
bool meet_badly(const Predicates<2>& predicates, FacetCorners<2> s, FacetCorners<2> t) {
  const std::size_t common = align(s, t);
  if (common == 2) return false;
  const auto side = [&](const FacetCorners<2>& u, const Point2* p) {
    return predicates.orient({u[0], u[1], p});
  };
  // The points of a line are in the order of their coordinates.
  if (common == 1) return side(s, t[1]) == 0 && (*s[1] < *s[0]) == (*t[1] < *t[0]);
  const int first = side(s, t[0]);
  const int second = side(s, t[1]);
  if (first == 0 && second == 0) return true;  // collinear: they overlap where their boxes do
  return first * second <= 0 && side(t, s[0]) * side(t, s[1]) <= 0;
}

// The plane of a triangle, seen along an axis along which the triangle does not shrink to a segment: one to
// one, so that signs in the coordinate plane are signs in the plane.
class PlaneView {
 public:
  explicit PlaneView(const FacetCorners<3>& s) {
    while (turn_ == 0 && axis_ < 3) {
      ++axis_;
      turn_ = orient2d(flat(*s[0]), flat(*s[1]), flat(*s[2]));
    }
  }

  /// Collinear corners: there is no such axis.
  bool is_degenerate() const { return turn_ == 0; }
  /// Of c and the line ab: positive where a triangle abc turns as the given one does.
  int side(const Point3* a, const Point3* b, const Point3* c) const {
    return turn_ * orient2d(flat(*a), flat(*b), flat(*c));
  }

 private:
  Point2 flat(const Point3& p) const { return {p[axis_ % 3], p[(axis_ + 1) % 3]}; }

  std::size_t axis_ = 0;
  int turn_ = 0;
};

bool is_degenerate(const FacetCorners<3>& s) { return PlaneView(s).is_degenerate(); }

// Is all of s strictly outside of an edge of t, which is counterclockwise in the view?
bool is_beyond_an_edge(const PlaneView& view, const FacetCorners<3>& s, const FacetCorners<3>& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3* const a = t[k];
    const Point3* const b = t[(k + 1) % 3];
    if (std::all_of(s.begin(), s.end(), [&](const Point3* p) { return view.side(a, b, p) < 0; })) return true;
  }
  return false;
}

Box<3> box_of(std::span<const Point3* const> points) {
  Box<3> box;
  for (const Point3* const p : points) box.include(*p);
  return box;
}

// Triangles, neither of them degenerate.
class TriangleContact {
 public:
  TriangleContact(const Predicates<3>& predicates, const FacetCorners<3>& s, const FacetCorners<3>& t)
      : predicates_(predicates), s_(s), t_(t), common_(align(s_, t_)) {}

  bool is_bad() const {
    if (common_ == 3) return false;
    if (common_ == 2) return is_folded();
    if (common_ == 1 && !opposite_edge_may_meet(s_, t_) && !opposite_edge_may_meet(t_, s_)) return false;
    const Signs s_sides = sides(s_, t_);
    if (is_on_one_side(s_sides)) return false;
    if (s_sides == Signs{}) return is_bad_in_plane();
    const Signs t_sides = sides(t_, s_);
    if (is_on_one_side(t_sides)) return false;
    return has_edge_through(s_, s_sides, t_) || has_edge_through(t_, t_sides, s_);
  }

 private:
  using Triangle = FacetCorners<3>;
  using Signs = std::array<int, 3>;

  int orient(const Point3* a, const Point3* b, const Point3* c, const Point3* d) const {
    return predicates_.orient({a, b, c, d});
  }
  // Of the corners of s and the plane of t; common corners are on it.
  Signs sides(const Triangle& s, const Triangle& t) const {
    Signs signs{};
    for (std::size_t k = common_; k < 3; ++k) signs[k] = orient(t[0], t[1], t[2], s[k]);
    return signs;
  }
  bool is_on_one_side(const Signs& signs) const {
    return signs[2] != 0 && std::all_of(signs.begin() + static_cast<std::ptrdiff_t>(common_), signs.end(),
                                        [&](int sign) { return sign == signs[2]; });
  }

  // Two triangles at a common edge have more in common only if they are in one plane, on the same side.
  bool is_folded() const {
    if (orient(s_[0], s_[1], s_[2], t_[2]) != 0) return false;
    return PlaneView(s_).side(s_[0], s_[1], t_[2]) > 0;
  }

  // With one common corner; see has_edge_through(). Spares most pairs around a vertex their signs.
  static bool opposite_edge_may_meet(const Triangle& s, const Triangle& t) {
    return boxes_meet<3>(box_of({s.begin() + 1, s.end()}), box_of(t));
  }

  // At most one common corner.
  bool is_bad_in_plane() const {
    const PlaneView view(s_);
    Triangle t = t_;
    if (view.side(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    if (common_ == 1) return cones_meet(view, s_, t);
    // Unless they meet, an edge of one separates them: the differences of their points are a convex polygon,
    // whose edges are parallel to theirs, and which then misses the origin.
    return !is_beyond_an_edge(view, s_, t) && !is_beyond_an_edge(view, t, s_);
  }
  // Triangles abc, ade in a plane, both counterclockwise, have more in common than a if and only if their cones
  // at a have: then counterclockwise the first ray of the intersection is ab or ad, and in the other cone.
  static bool cones_meet(const PlaneView& view, const Triangle& s, const Triangle& t) {
    const auto [a, b, c] = s;
    const Point3* const d = t[1];
    const Point3* const e = t[2];
    const int bd = view.side(a, b, d);
    return (bd >= 0 && view.side(a, c, d) <= 0) || (bd <= 0 && view.side(a, b, e) >= 0);
  }

  // Of triangles in different planes. Without common corners, they meet only if an edge of one meets the other.
  // With one, every other point of the intersection is on a ray from the common corner that leaves one of the
  // triangles, while within the other, at the edge opposite to that corner; which is clear of the corner.
  bool has_edge_through(const Triangle& s, const Signs& s_sides, const Triangle& t) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (common_ == 1 && k != 1) continue;
      if (s_sides[k] != s_sides[next] && meets(s[k], s[next], t)) return true;
    }
    return false;
  }
  // Of an edge that meets the plane of t in one point. One in the plane need not be looked at: where it meets
  // t, an end of it does, which belongs to another edge, or an edge of t meets it.
  bool meets(const Point3* a, const Point3* b, const Triangle& t) const {
    // Seen along the edge, the triangle turns around its point on the edge, or has it on its border.
    bool turns[3] = {};
    for (std::size_t k = 0; k < 3; ++k) turns[orient(a, b, t[k], t[(k + 1) % 3]) + 1] = true;
    return !(turns[0] && turns[2]);
  }

  const Predicates<3>& predicates_;
  Triangle s_;
  Triangle t_;
  std::size_t common_;
};

bool meet_badly(const Predicates<3>& predicates, const FacetCorners<3>& s, const FacetCorners<3>& t) {
  return TriangleContact(predicates, s, t).is_bad();
}

template <int Dim>
bool takes_part(const Surface<Dim>& surface, typename Surface<Dim>::Facet facet) {
  const bool has_points = std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) {
    if (v >= surface.points.size()) return false;
    const Point<Dim>& p = surface.points[v];
    return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
  });
  std::sort(facet.begin(), facet.end());
  return has_points && std::adjacent_find(facet.begin(), facet.end()) == facet.end();
}

// Points that none of the facets uses are copies of one that is: they do not widen the box. Multiplied by a
// power of two, exactly, where the gate would refuse them as too small.
template <int Dim>
std::vector<Point<Dim>> used_points(const Surface<Dim>& surface, const std::vector<std::uint32_t>& facets) {
  if (facets.empty()) return {};
  const Point<Dim>& some = surface.points[surface.facets[facets.front()][0]];
  std::vector<Point<Dim>> points(surface.points.size(), some);
  double largest = 0;
  for (const std::uint32_t f : facets) {
    for (const std::uint32_t v : surface.facets[f]) {
      points[v] = surface.points[v];
      for (const double x : points[v]) largest = std::max(largest, std::abs(x));
    }
  }
  constexpr double kTooSmall = 0x1p-700;
  constexpr double kFactor = 0x1p+400;  // from the smallest double, 2^-1074, to more than 2^-800
  if (largest < kTooSmall) {
    for (Point<Dim>& p : points) {
      for (double& x : p) x *= kFactor;
    }
  }
  return points;
}

}  // namespace

template <int Dim>
std::vector<FacetPair> self_intersections(const Surface<Dim>& surface, std::size_t limit) {
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t f = 0; f < surface.facets.size(); ++f) {
    if (takes_part<Dim>(surface, surface.facets[f])) candidates.push_back(f);
  }
  std::vector<Point<Dim>> points = used_points(surface, candidates);
  const InputGate<Dim> gate(points);
  for (Point<Dim>& p : points) p = gate.in(p);
  const Predicates<Dim> predicates(gate.box(), gate.granularity());
  const auto corners_of = [&](std::uint32_t f) {
    FacetCorners<Dim> corners;
    for (std::size_t k = 0; k < Dim; ++k) corners[k] = &points[surface.facets[f][k]];
    return corners;
  };

  std::vector<BoxOfFacet<Dim>> facets;
  facets.reserve(candidates.size());
  for (const std::uint32_t f : candidates) {
    const FacetCorners<Dim> corners = corners_of(f);
    if (is_degenerate(corners)) continue;
    BoxOfFacet<Dim>& facet = facets.emplace_back();
    facet.facet = f;
    for (const Point<Dim>* const p : corners) facet.box.include(*p);
  }
  const BoxForest<Dim> forest(facets);

  std::vector<FacetPair> pairs;
  for (const BoxOfFacet<Dim>& f : facets) {
    if (pairs.size() >= limit) break;
    const FacetCorners<Dim> corners = corners_of(f.facet);
    const std::size_t before = pairs.size();
    forest.for_each_larger_id(f, [&](std::uint32_t g) {
      if (meet_badly(predicates, corners, corners_of(g))) pairs.emplace_back(f.facet, g);
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
  }
  pairs.resize(std::min(pairs.size(), limit));
  return pairs;
}

template std::vector<FacetPair> self_intersections(const Surface2&, std::size_t);
template std::vector<FacetPair> self_intersections(const Surface3&, std::size_t);

}  // namespace sinkmesh
