// SPDX-License-Identifier: MIT
#include "core/first_simplex.h"

#include <algorithm>
#include <array>
#include <utility>

#include "predicates/predicates.h"

namespace sinkmesh {
namespace {

// Whether the points collected so far span a flat of dimension size-1.
bool is_independent(std::span<const Point2* const> p) {
  return p.size() < 3 || orient2d(*p[0], *p[1], *p[2]) != 0;
}
bool is_independent(std::span<const Point3* const> p) {
  if (p.size() == 4) return orient3d(*p[0], *p[1], *p[2], *p[3]) != 0;
  if (p.size() < 3) return true;
  // Three points are collinear in space iff they are in all three projections to coordinate planes.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto project = [i, j](const Point3& q) { return Point2{q[i], q[j]}; };
    if (orient2d(project(*p[0]), project(*p[1]), project(*p[2])) != 0) return true;
  }
  return false;
}

template <int Dim>
std::size_t move_basis_to_front(std::span<const Point<Dim>> points, std::vector<std::uint32_t>& order) {
  std::array<const Point<Dim>*, Dim + 1> basis{};
  std::size_t rank = 0;
  for (std::size_t i = 0; i < order.size() && rank <= Dim; ++i) {
    basis[rank] = &points[order[i]];
    if (!is_independent(std::span(basis).first(rank + 1))) continue;
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(rank),
                order.begin() + static_cast<std::ptrdiff_t>(i),
                order.begin() + static_cast<std::ptrdiff_t>(i + 1));
    ++rank;
  }
  return rank;
}

}  // namespace

template <int Dim>
std::size_t make_first_simplex(Complex<Dim>& complex, const Predicates<Dim>& predicates,
                               std::span<const Point<Dim>> points, std::vector<std::uint32_t>& order) {
  const std::size_t rank = move_basis_to_front<Dim>(points, order);
  if (rank <= Dim) return rank;
  complex.vertices().reserve(order.size() + 1);
  for (const std::uint32_t i : order) complex.add_vertex(points[i]);
  std::array<Vertex, Dim + 1> corners;
  Corners<Dim> at;
  for (std::uint32_t i = 0; i <= Dim; ++i) {
    corners[i] = Vertex(i);
    at[i] = &complex.point(corners[i]);
  }
  if (predicates.orient(at) < 0) std::swap(corners[0], corners[1]);
  complex.make_sphere(corners);
  return rank;
}

template std::size_t make_first_simplex<2>(Complex<2>&, const Predicates<2>&, std::span<const Point2>,
                                           std::vector<std::uint32_t>&);
template std::size_t make_first_simplex<3>(Complex<3>&, const Predicates<3>&, std::span<const Point3>,
                                           std::vector<std::uint32_t>&);

}  // namespace sinkmesh
