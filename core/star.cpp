// SPDX-License-Identifier: MIT
#include "core/star.h"

#include <unordered_set>

namespace sinkmesh {
namespace {

struct IndexHash {
  std::size_t operator()(Simplex s) const { return std::size_t{s.index()} * 0x9e3779b97f4a7c15U >> 16; }
};

}  // namespace

// The star of a face is connected through facets that contain the face; the set of hashes is only asked
// whether it holds a simplex, so its order does not show.
template <int Dim>
std::vector<Simplex> star(const Complex<Dim>& complex, std::span<const Vertex> face, Simplex start) {
  const auto is_in_face = [&](Vertex v) { return std::find(face.begin(), face.end(), v) != face.end(); };
  std::vector<Simplex> result{start};
  std::unordered_set<Simplex, IndexHash> met{start};
  for (std::size_t next = 0; next < result.size(); ++next) {
    for (int i = 0; i <= Dim; ++i) {
      if (is_in_face(complex.corner(result[next], i))) continue;
      const Simplex t = complex.neighbor(result[next], i);
      if (met.insert(t).second) result.push_back(t);
    }
  }
  return result;
}

template <int Dim>
std::vector<Simplex> prestar(Triangulation<Dim>& triangulation, const PointArg<Dim>& x, Simplex hint) {
  triangulation.announce(x);
  const Location<Dim> at = triangulation.locate(x, hint);
  std::vector<Simplex> result;
  if (at.is_at_corner()) return result;
  Cavity<Dim> cavity;
  // The simplex that holds x is in conflict with it, and so is a ghost whose facet x lies strictly beyond.
  triangulation.grow_prestar(cavity, x, at.simplex);
  for (std::size_t i = 0; i < cavity.num_simplices(); ++i) result.push_back(cavity.simplex(i));
  triangulation.release(cavity);
  return result;
}

template <int Dim>
std::vector<Vertex> closure_vertices(const Complex<Dim>& complex, std::span<const Simplex> set) {
  std::vector<Vertex> result;
  for (const Simplex s : set) {
    for (int i = 0; i <= Dim; ++i) result.push_back(complex.corner(s, i));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <int Dim>
std::vector<HalfFacet> boundary(const Complex<Dim>& complex, std::span<const Simplex> set) {
  std::vector<Simplex> sorted(set.begin(), set.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<HalfFacet> result;
  for (const Simplex s : set) {
    for (int i = 0; i <= Dim; ++i) {
      if (!std::binary_search(sorted.begin(), sorted.end(), complex.neighbor(s, i))) {
        result.push_back(Complex<Dim>::half_facet(s, i));
      }
    }
  }
  return result;
}

template std::vector<Simplex> star(const Complex<2>&, std::span<const Vertex>, Simplex);
template std::vector<Simplex> prestar<2>(Triangulation<2>&, const Point2&, Simplex);
template std::vector<Vertex> closure_vertices(const Complex<2>&, std::span<const Simplex>);
template std::vector<HalfFacet> boundary(const Complex<2>&, std::span<const Simplex>);
template std::vector<Simplex> star(const Complex<3>&, std::span<const Vertex>, Simplex);
template std::vector<Simplex> prestar<3>(Triangulation<3>&, const Point3&, Simplex);
template std::vector<Vertex> closure_vertices(const Complex<3>&, std::span<const Simplex>);
template std::vector<HalfFacet> boundary(const Complex<3>&, std::span<const Simplex>);

}  // namespace sinkmesh
