// SPDX-License-Identifier: MIT
#include "core/triangulation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/bulk_search.h"
#include "core/first_simplex.h"
#include "core/mix.h"

namespace sinkmesh {
namespace {

[[noreturn]] void throw_degenerate(int affine_dimension, std::size_t distinct, std::size_t rounded) {
  static constexpr const char* kWhat[] = {"there is no point", "all points are equal",
                                          "all points are collinear", "all points are coplanar"};
  static constexpr const char* kRemedy[] = {"add points", "add different points", "add points off the line",
                                            "add points off the plane"};
  const int row = affine_dimension + 1;
  std::string numbers = std::to_string(distinct) + " distinct";
  if (rounded != 0) {
    numbers +=
        ", now that " + std::to_string(rounded) + " had to be rounded: coordinates differ too much in size";
  }
  throw DegenerateInput(
      std::string(kWhat[row]) + " (" + numbers + "): " + kRemedy[row] + ", so that they span the whole space",
      affine_dimension);
}

}  // namespace

template <int Dim>
Triangulation<Dim>::Triangulation(std::span<const Point<Dim>> points, Engine engine)
    : gate_(points), predicates_(gate_.box(), gate_.granularity()) {
  std::vector<Point<Dim>> gated(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) gated[i] = gate_.in(points[i]);

  InsertionOrder sorted = insertion_order<Dim>(gated, gate_.box());
  duplicates_ = std::move(sorted.duplicates);
  const std::size_t rank = make_first_simplex<Dim>(complex_, predicates_, gated, sorted.order);
  if (rank <= Dim) {
    throw_degenerate(static_cast<int>(rank) - 1, sorted.order.size(), gate_.rounded_points());
  }
  insert_all(engine);
  restore_ids(gated, sorted.order);
}

template <int Dim>
void Triangulation<Dim>::insert_all(Engine engine) {
  BulkSearch<Dim> search;
  Simplex hint(0);
  const std::size_t count = complex_.num_vertices();
  for (std::uint32_t i = Dim + 1; i < count; ++i) {
    const Vertex v(i);
    const Point<Dim> p = complex_.point(v);
    if (engine == Engine::star) {
      cavity_.grow(complex_, predicates_, p, search.find(complex_, predicates_, p));
      linker_.substitute(complex_, cavity_, v);
      search.settle(complex_, cavity_, v);
    } else {
      flipper_.insert(complex_, predicates_, walk_to(complex_, predicates_, p, hint), v);
      hint = complex_.incident_simplex(v);
    }
  }
}

// Vertices were numbered in the order of insertion, which keeps neighbours close in memory; gives them the ids
// of the input. The new numbers are read along the curve, too, so this is a few percent of the whole.
template <int Dim>
void Triangulation<Dim>::restore_ids(std::span<const Point<Dim>> gated,
                                     const std::vector<std::uint32_t>& order) {
  Complex<Dim> renamed;
  renamed.vertices().reserve(gated.size() + 1);
  for (const Point<Dim>& p : gated) renamed.add_vertex(p);
  std::vector<std::uint32_t> slot(order.size() + 1);
  slot[0] = Vertex::infinite().slot();
  for (std::size_t i = 0; i < order.size(); ++i) slot[i + 1] = Vertex(order[i]).slot();
  for (std::size_t i = 0; i < slot.size(); ++i) {
    renamed.vertices()[slot[i]].incident = complex_.vertices()[i].incident;
  }
  complex_.vertices().swap(renamed.vertices());
  for (auto& record : complex_.records()) {
    for (std::uint32_t& corner : record.corner) corner = slot[corner];
  }
}

template <int Dim>
Location<Dim> Triangulation<Dim>::locate(const Point<Dim>& p, Simplex hint) const {
  return walk_to(complex_, predicates_, p, hint.is_null() ? some_simplex() : hint);
}

template <int Dim>
auto Triangulation<Dim>::insert(const Point<Dim>& p, Engine engine, Simplex hint) -> Insertion {
  if (!gate_.admits(p)) {
    throw InputError(
        "the point to insert is not finite, or one of its coordinates is not below the first power of two "
        "above all coordinates of the input: build a triangulation of all points instead");
  }
  const Point<Dim> x = gate_.in(p);
  announce(x);
  const Location<Dim> at = locate(x, hint);
  if (at.is_at_corner()) {
    for (int i = 0; i <= Dim; ++i) {
      if (at.sign[static_cast<std::size_t>(i)] != 0) return {complex_.corner(at.simplex, i), false};
    }
  }
  if (engine == Engine::star) {
    cavity_.grow(complex_, predicates_, x, at.simplex);
    return {substitute_star(cavity_, x), true};
  }
  const Vertex v = complex_.add_vertex(x);
  flipper_.insert(complex_, predicates_, at, v);
  return {v, true};
}

template <int Dim>
Vertex Triangulation<Dim>::substitute_star(Cavity<Dim>& cavity, const Point<Dim>& x) {
  Vertex v;
  try {
    v = complex_.add_vertex(x);
  } catch (...) {
    release(cavity);
    throw;
  }
  try {
    linker_.substitute(complex_, cavity, v);
  } catch (...) {
    complex_.vertices().pop_back();
    throw;
  }
  return v;
}

template <int Dim>
void Triangulation<Dim>::substitute_star(Cavity<Dim>& cavity, const Point<Dim>& x, Vertex v) {
  SINKMESH_ASSERT(complex_.incident_simplex(v).is_null());
  const Point<Dim> before = std::exchange(complex_.vertices()[v.slot()].point, x);
  try {
    linker_.substitute(complex_, cavity, v);
  } catch (...) {
    complex_.vertices()[v.slot()].point = before;
    throw;
  }
}

template <int Dim>
void Triangulation<Dim>::require_present(Vertex v) const {
  const bool is_there = v.slot() < complex_.vertices().size() && !v.is_infinite();
  if (!is_there || complex_.incident_simplex(v).is_null()) {
    throw InputError("the vertex to remove is not in the triangulation: give one that is in a simplex");
  }
}

template <int Dim>
const std::vector<Simplex>& Triangulation<Dim>::remove(Vertex v) {
  require_present(v);
  if (!remover_.remove(complex_, predicates_, v)) {
    throw DegenerateInput("without vertex " + std::to_string(v.index()) +
                              " all points lie in one hyperplane: keep it, or insert others before",
                          Dim - 1);
  }
  return remover_.created();
}

template <int Dim>
std::span<const std::array<Vertex, Dim + 1>> Triangulation<Dim>::without(Vertex v) {
  require_present(v);
  if (!remover_.plan(complex_, predicates_, v)) return {};
  return remover_.planned();
}

template <int Dim>
Simplex Triangulation<Dim>::some_simplex() const {
  return *complex_.simplices().begin();
}

template <int Dim>
std::size_t Triangulation<Dim>::num_ghosts() const {
  std::size_t count = 0;
  for (const Simplex s : complex_.simplices()) count += complex_.is_ghost(s) ? 1 : 0;
  return count;
}

template <int Dim>
std::uint64_t Triangulation<Dim>::hash() const {
  std::vector<Point<Dim>> points(complex_.num_vertices());
  for (std::uint32_t i = 0; i < points.size(); ++i) points[i] = point(Vertex(i));
  SimplexSetHash<Dim> hash(points);
  for (const Simplex s : complex_.simplices()) {
    if (complex_.is_ghost(s)) continue;
    std::array<std::uint32_t, Dim + 1> corners;
    for (int i = 0; i <= Dim; ++i) corners[static_cast<std::size_t>(i)] = complex_.corner(s, i).index();
    hash.add(corners);
  }
  return hash.value();
}

template class Triangulation<2>;
template class Triangulation<3>;

}  // namespace sinkmesh
