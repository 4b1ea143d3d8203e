// SPDX-License-Identifier: MIT
#include "tools/models/surface_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <stdexcept>
#include <vector>

#include "core/triangulation.h"
#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/flow.h"
#include "refine/quality.h"

namespace sinkmesh::models {
namespace {
// A triangle above the wanted r/l counts as larger, by its excess to this power: it goes before larger ones.
constexpr double kThinPower = 8;

Point3 along(const Point3& origin, const Point3& direction, double t) {
  return {origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]};
}

// Where `value` changes its sign between a and b, by false position; halves the value at the end that stays
// (the Illinois rule), so that it converges faster than linearly from both sides.
Point3 crossing(const ImplicitSolid& solid, const Point3& a, const Point3& b) {
  const Point3 direction = b - a;
  double low = 0;
  double high = 1;
  double at_low = solid.value(a);
  double at_high = solid.value(b);
  int kept = 0;
  double t = 0.5;
  for (int i = 0; i < 60 && high - low > 1e-14; ++i) {
    // Far from the surface the function may be flat: halve now and then.
    t = i % 4 == 3 ? 0.5 * (low + high) : low + (high - low) * at_low / (at_low - at_high);
    const double at_t = solid.value(along(a, direction, t));
    if (at_t == 0) break;
    if (at_t < 0) {
      low = t;
      at_low = at_t;
      if (kept == 1) at_high *= 0.5;
      kept = 1;
    } else {
      high = t;
      at_high = at_t;
      if (kept == -1) at_low *= 0.5;
      kept = -1;
    }
  }
  return solid.onto(along(a, direction, t));
}

class Sampler {
 public:
  Sampler(const ImplicitSolid& solid, std::size_t vertices)
      : solid_(solid), vertices_(vertices), triangulation_(solid.seeds(vertices)) {
    const Box<3>& box = triangulation_.gate().box();
    for (std::size_t k = 0; k < 3; ++k)
      reach_ = std::max({reach_, std::abs(box.low[k]), std::abs(box.high[k])});
    reach_ = std::ldexp(4 * reach_, -triangulation_.gate().exponent());
    for (const Simplex s : complex().simplices()) enter(s);
    for (const Simplex s : complex().simplices()) enqueue_facets(s);
  }

  void spread() {
    while (complex().num_vertices() < vertices_ && !queue_.empty()) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (is_current(candidate)) insert(candidate.center);
    }
  }

  // Each round removes every facet it was started for; the new ones are smaller.
  void stabilize() {
    for (int round = 0; round < 100; ++round) {
      std::vector<Candidate> unstable;
      Flow<3> flow(triangulation_);
      for (const HalfFacet h : facets()) {
        if (flow.crosses(h)) unstable.push_back(candidate(h));
      }
      if (unstable.empty()) return;
      for (const Candidate& facet : unstable) {
        if (is_current(facet)) insert(facet.center);
      }
    }
    throw std::logic_error("the sampled surface does not become stable");
  }

  Surface3 surface() const {
    Surface3 surface;
    for (std::uint32_t v = 0; v < complex().num_vertices(); ++v) {
      surface.points.push_back(triangulation_.point(Vertex(v)));
    }
    for (const HalfFacet h : facets()) {
      Surface3::Facet& facet = surface.facets.emplace_back();
      const std::array<Vertex, 3> vertices = complex().facet(h);
      for (std::size_t k = 0; k < 3; ++k) facet[k] = vertices[k].index();
    }
    if (surface.facets.size() + 4 != 2 * surface.points.size()) {
      throw std::logic_error("the sampled surface is no sphere");
    }
    return surface;
  }

 private:
  struct State {
    Point3 center{};          // of the circumsphere, if inside
    std::uint32_t birth = 0;  // number of the insertion that made the simplex
    bool is_inside = false;
  };
  // A facet of the surface, as the half-facet of its inside simplex, and the ball that may be divided.
  struct Candidate {
    double priority;
    Point3 center;
    HalfFacet facet;
    std::uint32_t birth_inside;
    std::uint32_t birth_outside;

    bool operator<(const Candidate& other) const { return priority < other.priority; }
  };

  const Complex<3>& complex() const { return triangulation_.complex(); }
  static Simplex owner(HalfFacet h) { return Complex<3>::simplex_of(h); }

  void enter(Simplex s) {
    if (s.index() >= states_.size()) states_.resize(complex().num_slots());
    State& state = states_[s.index()];
    state.birth = birth_;
    state.is_inside = false;
    if (complex().is_ghost(s)) return;
    Point3 center;
    if (!circumcenter(complex().corners(s), center)) return;
    state.center = triangulation_.gate().out(center);
    state.is_inside = solid_.value(state.center) < 0;
  }

  bool is_facet(HalfFacet h) const {
    return states_[owner(h).index()].is_inside && !states_[owner(complex().mate(h)).index()].is_inside;
  }

  std::vector<HalfFacet> facets() const {
    std::vector<HalfFacet> result;
    for (const Simplex s : complex().simplices()) {
      for (int i = 0; i < 4; ++i) {
        if (is_facet(Complex<3>::half_facet(s, i))) result.push_back(Complex<3>::half_facet(s, i));
      }
    }
    return result;
  }

  // The dual edge runs from the inner center along the outward normal; that of the outer simplex may be
  // infinitely far, and the end of the edge is then anywhere outside.
  Candidate candidate(HalfFacet h) const {
    const Simplex inner = owner(h);
    const Simplex outer = owner(complex().mate(h));
    std::array<Point3, 3> p;
    const std::array<Vertex, 3> vertices = complex().facet(h);
    for (std::size_t k = 0; k < 3; ++k) p[k] = triangulation_.point(vertices[k]);
    const Point3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const Point3& start = states_[inner.index()].center;
    double length = reach_;
    Point3 center;
    if (!complex().is_ghost(outer) && circumcenter(complex().corners(outer), center)) {
      const double apart = std::sqrt(squared_distance(start, triangulation_.gate().out(center)));
      if (apart < length) length = apart;
    }
    const Point3 end = along(start, normal, length / std::sqrt(dot(normal, normal)));
    Candidate result;
    result.center = crossing(solid_, start, end);
    const double ratio = std::sqrt(facet_shape<3>({&p[0], &p[1], &p[2]}).ratio2());
    const double excess = std::max(1.0, ratio / solid_.max_ratio());
    result.priority = std::sqrt(squared_distance(result.center, p[0])) / solid_.size(result.center) *
                      std::pow(excess, kThinPower);
    result.facet = h;
    result.birth_inside = states_[inner.index()].birth;
    result.birth_outside = states_[outer.index()].birth;
    return result;
  }

  bool is_current(const Candidate& c) const {
    const Simplex inner = owner(c.facet);
    if (!complex().is_alive(inner) || states_[inner.index()].birth != c.birth_inside) return false;
    return states_[owner(complex().mate(c.facet)).index()].birth == c.birth_outside;
  }

  // Facets between s and its neighbors, from either side, unless the neighbor does the same after s.
  void enqueue_facets(Simplex s) {
    for (int i = 0; i < 4; ++i) {
      HalfFacet h = Complex<3>::half_facet(s, i);
      const Simplex other = owner(complex().mate(h));
      if (states_[other.index()].birth == birth_ && other < s) continue;
      if (!is_facet(h)) h = complex().mate(h);
      if (!is_facet(h)) continue;
      const Candidate c = candidate(h);
      if (solid_.is_clear_of_edges(c.center, vertices_)) queue_.push(c);
    }
  }

  void insert(const Point3& p) {
    insert_one(p);
    if (solid_.is_centrally_symmetric()) insert_one({-p[0], -p[1], -p[2]});
  }

  void insert_one(const Point3& p) {
    const auto [vertex, is_new] = triangulation_.insert(p);
    if (!is_new) return;
    ++birth_;
    star_.assign(1, complex().incident_simplex(vertex));
    enter(star_[0]);
    for (std::size_t next = 0; next < star_.size(); ++next) {
      const Simplex s = star_[next];
      for (int i = 0; i < 4; ++i) {
        const Simplex neighbor = complex().neighbor(s, i);
        if (complex().corner(s, i) == vertex) continue;
        if (neighbor.index() < states_.size() && states_[neighbor.index()].birth == birth_) continue;
        enter(neighbor);
        star_.push_back(neighbor);
      }
    }
    for (const Simplex s : star_) enqueue_facets(s);
  }

  const ImplicitSolid& solid_;
  std::size_t vertices_;
  Triangulation3 triangulation_;
  double reach_ = 0;  // longer than the way out from anywhere inside
  std::uint32_t birth_ = 0;
  std::vector<State> states_;  // by simplex
  std::priority_queue<Candidate> queue_;
  std::vector<Simplex> star_;
};

}  // namespace

Surface3 sample_surface(const ImplicitSolid& solid, std::size_t triangles) {
  Sampler sampler(solid, triangles / 2 + 2);
  sampler.spread();
  sampler.stabilize();
  return sampler.surface();
}

}  // namespace sinkmesh::models
