// SPDX-License-Identifier: MIT
#include "refine/domain.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/mix.h"
#include "core/star_walk.h"
#include "refine/cells.h"
#include "refine/facet_index.h"
#include "refine/point_text.h"

namespace sinkmesh {
namespace {

// "hole 0 (1, 2)"
template <int Dim>
std::string seed_text(SeedError::Kind kind, std::size_t seed, const Point<Dim>& p) {
  return (kind == SeedError::Kind::hole ? "hole " : "region ") + std::to_string(seed) + ' ' +
         point_text<Dim>(p);
}

}  // namespace

// One half-facet for each facet, or null.
template <int Dim>
std::vector<HalfFacet> Domain<Dim>::find(std::span<const Facet> facets) const {
  const Complex<Dim>& complex = triangulation_->complex();
  const FacetIndex<Dim> index(facets, complex.num_vertices());
  std::vector<HalfFacet> found(facets.size());
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) continue;
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const Simplex t = Complex<Dim>::simplex_of(complex.mate(h));
      if (s < t || complex.is_ghost(t)) {
        index.look_up(complex.facet(h), [&](std::size_t f) { found[f] = h; });
      }
    }
  }
  return found;
}

template <int Dim>
std::vector<std::size_t> Domain<Dim>::label_facets(std::span<const Facet> facets, const Seeds<Dim>& seeds) {
  const std::vector<HalfFacet> found = find(facets);
  std::vector<std::size_t> missing;
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (found[f].is_null()) missing.push_back(f);
  }
  if (missing.empty()) label(facets, walls_at(found), seeds);
  return missing;
}

template <int Dim>
auto Domain<Dim>::walls_at(std::span<const HalfFacet> found) -> std::vector<Wall> {
  std::vector<Wall> walls;
  for (std::uint32_t f = 0; f < found.size(); ++f) {
    if (!found[f].is_null()) walls.push_back({found[f], f});
  }
  return walls;
}

template <int Dim>
void Domain<Dim>::set_walls(std::span<const Wall> walls) {
  const Complex<Dim>& complex = triangulation_->complex();
  region_.assign(complex.num_slots(), kOutside);
  walls_.assign(complex.num_slots(), 0);
  for (const Wall& wall : walls) {
    add_wall(wall.half_facet);
    add_wall(complex.mate(wall.half_facet));
  }
}

// Whether a wall holds all corners of the least face on which a point lies.
template <int Dim>
bool Domain<Dim>::is_on_wall(const Location<Dim>& at) const {
  const Complex<Dim>& complex = triangulation_->complex();
  std::vector<Vertex> face;
  for (int i = 0; i <= Dim; ++i) {
    if (at.sign[static_cast<std::size_t>(i)] == 1) face.push_back(complex.corner(at.simplex, i));
  }
  if (face.empty() || face.size() == Dim + 1) return false;
  const auto holds_face = [&](HalfFacet h) {
    const auto corners = complex.facet(h);
    return std::all_of(face.begin(), face.end(),
                       [&](Vertex v) { return std::find(corners.begin(), corners.end(), v) != corners.end(); });
  };
  StarWalk<Dim> star_walk;
  return star_walk(complex, face[0], [&](Simplex s) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (is_wall(h) && holds_face(h)) return true;
    }
    return false;
  });
}

template <int Dim>
void Domain<Dim>::label(std::span<const Facet> facets, std::span<const Wall> walls, const Seeds<Dim>& seeds) {
  const Complex<Dim>& complex = triangulation_->complex();
  set_walls(walls);
  const Cells<Dim> cells(complex, *this);
  const auto beside = [&](HalfFacet h) { return cells.of(Complex<Dim>::simplex_of(h)); };

  std::vector<bool> inside(cells.size(), false);
  std::vector<std::pair<std::uint32_t, std::int64_t>> tagged;
  if (seeds.empty() && cells.size() == 2) {
    inside[1] = true;  // one bounded cell: whatever the surface is, that cell is what it keeps from its outside
  } else if (seeds.empty()) {
    const SurfaceComponents<Dim> components(facets);
    CellGraph graph(cells.size());
    for (const Wall& wall : walls) {
      graph.add(beside(wall.half_facet), beside(complex.mate(wall.half_facet)), components.of(wall.facet));
    }
    inside = graph.label(components.is_even());
  } else {
    std::fill(inside.begin() + 1, inside.end(), true);
    const auto cell_of = [&](SeedError::Kind kind, std::size_t seed, const Point<Dim>& p) {
      const auto fail = [&](const char* why) {
        throw SeedError(kind, seed, seed_text<Dim>(kind, seed, p) + why);
      };
      std::uint32_t cell = Cells<Dim>::kUnbounded;
      if (triangulation_->gate().admits(p)) {
        const Location<Dim> at = triangulation_->locate(triangulation_->gate().in(p));
        if (is_on_wall(at)) fail(" lies on the surface: move it");
        cell = cells.of(at.simplex);
      }
      if (cell == Cells<Dim>::kUnbounded) fail(" is not enclosed by the surface: remove or move it");
      return cell;
    };
    for (std::size_t i = 0; i < seeds.regions.size(); ++i) {
      const auto& region = seeds.regions[i];
      const std::uint32_t cell = cell_of(SeedError::Kind::region, i, region.point);
      for (const auto& [other, tag] : tagged) {
        if (other != cell || tag == region.tag) continue;
        throw SeedError(SeedError::Kind::region, i,
                        seed_text<Dim>(SeedError::Kind::region, i, region.point) + " has the attribute " +
                            std::to_string(region.tag) + ", but lies in one region with a point that has " +
                            std::to_string(tag) + ": remove one of them");
      }
      tagged.emplace_back(cell, region.tag);
    }
    for (std::size_t i = 0; i < seeds.holes.size(); ++i) {
      inside[cell_of(SeedError::Kind::hole, i, seeds.holes[i])] = false;
    }
  }
  if (std::find(inside.begin(), inside.end(), true) == inside.end()) {
    throw InputError(
        "the surface does not separate inside from outside: it is not closed, or all of it is holes");
  }
  number_regions(cells.all(), inside, tagged);
}

template <int Dim>
void Domain<Dim>::number_regions(const std::vector<std::uint32_t>& cell, std::vector<bool> inside,
                                 const std::vector<std::pair<std::uint32_t, std::int64_t>>& tagged) {
  const Complex<Dim>& complex = triangulation_->complex();
  // The least vertex; two regions that share it are told apart by the least sum of hashes of a simplex there.
  struct Key {
    Point<Dim> least;
    std::uint64_t hash = 0;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<std::uint32_t> order;
  for (std::uint32_t c = 0; c < inside.size(); ++c) {
    if (inside[c]) order.push_back(c);
  }
  if (order.size() > 1) {
    std::vector<Key> key(inside.size());
    for (Key& k : key) k.least.fill(HUGE_VAL);
    for (const Simplex s : complex.simplices()) {
      if (!inside[cell[s.index()]]) continue;
      const Corners<Dim> corners = complex.corners(s);
      Key of_simplex{*corners[0], hash_points<Dim>(corners)};
      for (const Point<Dim>* p : corners) of_simplex.least = std::min(of_simplex.least, *p);
      key[cell[s.index()]] = std::min(key[cell[s.index()]], of_simplex);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  }
  std::vector<Region> number(inside.size(), kOutside);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i + 1;
  tags_.assign(order.size(), 0);
  for (const auto& [c, tag] : tagged) {
    if (inside[c]) tags_[number[c] - 1] = tag;
  }
  for (const Simplex s : complex.simplices()) region_[s.index()] = number[cell[s.index()]];
}

template <int Dim>
auto Domain<Dim>::peel(Flow<Dim>& flow) -> Peeled {
  const Complex<Dim>& complex = triangulation_->complex();
  Peeled peeled;
  std::vector<Simplex> stack;
  std::vector<Simplex> taken;
  const auto peel_if_it_flows_out = [&](HalfFacet h) {
    const Simplex s = Complex<Dim>::simplex_of(h);
    if (!is_inside(s) || !flow.crosses(h)) return;
    set_region(s, kOutside);
    ++peeled.simplices;
    stack.push_back(s);
    taken.push_back(s);
  };
  // Flow between two regions, or around a membrane, does not lead out.
  std::vector<HalfFacet> boundary_before = boundary();
  std::erase_if(boundary_before,
                [&](HalfFacet h) { return is_inside(Complex<Dim>::simplex_of(complex.mate(h))); });
  for (const HalfFacet h : boundary_before) peel_if_it_flows_out(h);
  while (!stack.empty()) {
    const Simplex s = stack.back();
    stack.pop_back();
    for (int i = 0; i <= Dim; ++i) peel_if_it_flows_out(complex.mate(Complex<Dim>::half_facet(s, i)));
  }
  for (const HalfFacet h : boundary_before) peeled.facets += is_inside(Complex<Dim>::simplex_of(h)) ? 0 : 1;
  for (const Simplex s : taken) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      const bool is_border = is_inside(complex.neighbor(s, i));
      for (const HalfFacet side : {h, complex.mate(h)}) is_border ? add_wall(side) : remove_wall(side);
    }
  }
  return peeled;
}

template <int Dim>
Domain<Dim>::Domain(const Triangulation<Dim>& triangulation)
    : triangulation_(&triangulation),
      region_(triangulation.complex().num_slots(), kOutside),
      walls_(triangulation.complex().num_slots(), 0) {}

template <int Dim>
std::vector<Simplex> Domain<Dim>::simplices() const {
  std::vector<Simplex> result;
  for (const Simplex s : triangulation_->complex().simplices()) {
    if (is_inside(s)) result.push_back(s);
  }
  return result;
}

template <int Dim>
std::vector<HalfFacet> Domain<Dim>::boundary() const {
  const Complex<Dim>& complex = triangulation_->complex();
  std::vector<HalfFacet> result;
  for (const Simplex s : simplices()) {
    for (int i = 0; i <= Dim; ++i) {
      const HalfFacet h = Complex<Dim>::half_facet(s, i);
      if (!is_wall(h)) continue;
      const HalfFacet mate = complex.mate(h);
      const Region beyond = region(Complex<Dim>::simplex_of(mate));
      const bool is_first = beyond == region(s) ? h < mate : region(s) < beyond;
      if (beyond == kOutside || is_first) result.push_back(h);
    }
  }
  return result;
}

template class Domain<2>;
template class Domain<3>;

}  // namespace sinkmesh
