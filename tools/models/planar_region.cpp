// SPDX-License-Identifier: MIT
#include "tools/models/planar_region.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <stdexcept>

#include "core/triangulation.h"
#include "core/vector.h"
#include "predicates/circumcenter.h"
#include "refine/domain.h"
#include "refine/quality.h"

namespace sinkmesh::models {
namespace {

// A triangle with r/l above kThin counts as larger, by the excess to this power.
constexpr double kThin = 1.0;
constexpr double kThinPower = 4;
// New points stay away from the diametral circles of segments by this factor.
constexpr double kMargin = 1.05;

std::vector<Point2> joined(const std::vector<std::vector<Point2>>& loops) {
  std::vector<Point2> points;
  for (const auto& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
  return points;
}

class RegionMesher {
 public:
  RegionMesher(const std::vector<std::vector<Point2>>& loops, const std::function<double(const Point2&)>& size)
      : size_(size), triangulation_(joined(loops)), domain_(triangulation_) {
    std::vector<Domain<2>::Facet> segments;
    std::uint32_t first = 0;
    for (const auto& loop : loops) {
      const auto n = static_cast<std::uint32_t>(loop.size());
      for (std::uint32_t i = 0; i < n; ++i)
        segments.push_back({Vertex(first + i), Vertex(first + (i + 1) % n)});
      first += n;
    }
    if (!domain_.label_facets(segments).empty()) {
      throw std::logic_error("an outline has segments that are not Delaunay");
    }
    for (const Simplex s : domain_.simplices()) enqueue(s);
  }

  void insert(std::size_t count) {
    while (count != 0 && !queue_.empty()) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (is_current(candidate) && try_insert(candidate)) --count;
    }
  }

  Mesh2 mesh() const {
    Mesh2 mesh;
    for (std::uint32_t v = 0; v < complex().num_vertices(); ++v) {
      mesh.points.push_back(triangulation_.point(Vertex(v)));
    }
    for (const Simplex s : domain_.simplices()) {
      mesh.simplices.push_back(
          {complex().corner(s, 0).index(), complex().corner(s, 1).index(), complex().corner(s, 2).index()});
    }
    return mesh;
  }

 private:
  struct Candidate {
    double priority;
    Simplex triangle;
    std::uint32_t birth;
    bool operator<(const Candidate& other) const { return priority < other.priority; }
  };

  const Complex<2>& complex() const { return triangulation_.complex(); }

  void enqueue(Simplex s) {
    if (s.index() >= births_.size()) births_.resize(complex().num_slots(), 0);
    births_[s.index()] = ++birth_;
    const Shape shape = sinkmesh::shape<2>(complex().corners(s));
    const double thinness = std::max(1.0, std::sqrt(shape.ratio2()) / kThin);
    Point2 center{};
    for (int i = 0; i < 3; ++i) {
      const Point2 p = triangulation_.point(complex().corner(s, i));
      for (std::size_t k = 0; k < 2; ++k) center[k] += p[k] / 3;
    }
    queue_.push({std::sqrt(shape.radius2) / size_(center) * std::pow(thinness, kThinPower), s, birth_});
  }

  bool is_current(const Candidate& c) const {
    return complex().is_alive(c.triangle) && births_[c.triangle.index()] == c.birth;
  }

  // Keeps the search inside; stops it at a segment with the point in its diametral circle. Other segments have
  // an empty circle, so nothing beyond them is in the prestar.
  struct Guide : FreeGuide {
    const RegionMesher& mesher;
    const Point2& p;

    Passage cross(HalfFacet inner, HalfFacet outer) const {
      if (!mesher.domain_.is_wall(inner)) return Passage::pass;
      const auto [a, b] = mesher.complex().facet_corners(outer);
      const Point2 middle{((*a)[0] + (*b)[0]) / 2, ((*a)[1] + (*b)[1]) / 2};
      const double clearance2 = kMargin * kMargin * squared_distance(middle, *a);
      return squared_distance(middle, p) < clearance2 ? Passage::stop : Passage::wall;
    }
  };

  bool try_insert(const Candidate& c) {
    Point2 p;
    if (!circumcenter(complex().corners(c.triangle), p)) return false;
    triangulation_.announce(p);
    if (!triangulation_.grow_prestar(cavity_, p, c.triangle, Guide{{}, *this, p})) return false;
    triangulation_.substitute_star(cavity_, p);
    domain_.inherit(cavity_, 1);
    for (std::size_t i = 0; i < cavity_.num_facets(); ++i) enqueue(cavity_.star(i));
    return true;
  }

  const std::function<double(const Point2&)>& size_;
  Triangulation2 triangulation_;
  Domain<2> domain_;
  Cavity<2> cavity_;
  std::vector<std::uint32_t> births_;
  std::uint32_t birth_ = 0;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

Mesh2 mesh_region(const std::vector<std::vector<Point2>>& loops,
                  const std::function<double(const Point2&)>& size, std::size_t interior_points) {
  RegionMesher mesher(loops, size);
  mesher.insert(interior_points);
  return mesher.mesh();
}

}  // namespace sinkmesh::models
