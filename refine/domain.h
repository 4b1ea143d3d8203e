// SPDX-License-Identifier: MIT
//
// Which simplices are inside, and in which region: the part of the complex that is meshed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/location.h"
#include "core/triangulation.h"
#include "refine/flow.h"
#include "refine/surface.h"

namespace sinkmesh {

/// A label for each simplex of a triangulation, and the walls that no prestar of an inner point crosses: the
/// facets of the surface, or what is left of them after peeling. Region 0 is outside; two simplices that share
/// a facet without a wall have the same region. Whoever replaces simplices labels the new ones.
template <int Dim>
class Domain {
 public:
  /// The facets of a surface, as vertices of a triangulation.
  using Facet = std::array<Vertex, Dim>;
  using Region = std::uint32_t;
  static constexpr Region kOutside = 0;

  /// A facet of the surface, or a piece of one, that is a facet of the triangulation.
  struct Wall {
    HalfFacet half_facet;
    std::uint32_t facet;  ///< of the surface
  };

  /// Everything outside, no wall.
  explicit Domain(const Triangulation<Dim>& triangulation);

  /// Puts up the walls, and labels what they separate. A component of the surface (facets connected through
  /// their ridges) each of whose ridges has an even number of facets is crossed by parity, so a cavity inside a
  /// solid is outside whichever way its facets are turned. Any other one, where a facet divides a region in two
  /// or is a membrane inside one, turns over everything that it keeps from its own outside. Seeds, if there
  /// are any, decide instead: then every bounded region is inside but those with a hole.
  ///
  /// Regions are numbered from 1 in the order of their least vertices, so that only the geometry counts.
  ///
  /// Why a component has one outside: the border of an unbounded part of the complement of a connected set is
  /// connected, and what is disjoint from it, or meets it in single points, lies on one side of it.
  ///
  /// @param facets  of the surface; in `walls` each one, or its pieces.
  /// @throws InputError if the surface bounds nothing, if parities contradict each other (it crosses itself),
  ///         or if a hole or region lies outside; nothing is labelled then.
  /// Cost: linear in the complex, log-linear in the surface.
  void label(std::span<const Facet> facets, std::span<const Wall> walls, const Seeds<Dim>& seeds = {});

  /// The same for a surface whose facets are all in the triangulation.
  /// @return the facets, by index, that are no facets of the triangulation; unless empty, nothing was labelled.
  [[nodiscard]] std::vector<std::size_t> label_facets(std::span<const Facet> facets,
                                                      const Seeds<Dim>& seeds = {});

  /// One half-facet of the triangulation for each facet, or null. Linear in the complex.
  std::vector<HalfFacet> find(std::span<const Facet> facets) const;

  /// One wall for each facet that is not null.
  static std::vector<Wall> walls_at(std::span<const HalfFacet> found);

  struct Peeled {
    std::size_t simplices = 0;  ///< taken away
    std::size_t facets = 0;     ///< facets of the boundary that no longer are
  };
  /// Shrinks the domain to its maximal stable subcomplex [EG01, 5.1]: takes away every simplex that flows,
  /// directly or not, to the outside. What remains is the largest part from which no flow leads out: a union of
  /// parts with that property has it, too. One reverse search, linear in what is taken away and the boundary.
  Peeled peel(Flow<Dim>& flow);

  Region region(Simplex s) const { return s.index() < region_.size() ? region_[s.index()] : kOutside; }
  bool is_inside(Simplex s) const { return region(s) != kOutside; }
  bool is_wall(HalfFacet h) const {
    const Simplex s = Complex<Dim>::simplex_of(h);
    return s.index() < walls_.size() && (walls_[s.index()] >> Complex<Dim>::corner_of(h) & 1) != 0;
  }
  /// 0 before anything is labelled.
  Region num_regions() const { return static_cast<Region>(tags_.size()); }
  /// Of the seed of a region, or 0.
  std::int64_t tag(Region region) const { return tags_[region - 1]; }

  // -- for whoever replaces simplices

  /// After the star of a point has taken the place of a prestar that crossed no wall.
  /// @param region  of the prestar.
  void inherit(const Cavity<Dim>& cavity, Region region) {
    const Complex<Dim>& complex = triangulation_->complex();
    for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
      const HalfFacet outer(cavity.facet(i).outer);
      set_region(cavity.star(i), region);
      clear_walls(cavity.star(i));
      if (is_wall(outer)) add_wall(complex.mate(outer));
    }
  }

  /// After the star of a point that no wall meets has given way to other simplices.
  /// @param region  of the star.
  /// @param visit   called with the outer half-facet of each wall that has a new simplex at it.
  template <class Visit>
  void fill(std::span<const Simplex> fresh, Region region, Visit&& visit) {
    for (const Simplex s : fresh) {
      set_region(s, region);
      clear_walls(s);
    }
    const Complex<Dim>& complex = triangulation_->complex();
    for (const Simplex s : fresh) {
      for (int i = 0; i <= Dim; ++i) {
        const HalfFacet outer = complex.mate(Complex<Dim>::half_facet(s, i));
        if (!is_wall(outer)) continue;
        add_wall(complex.mate(outer));
        visit(outer);
      }
    }
  }

  void set_region(Simplex s, Region region) {
    make_room(s);
    region_[s.index()] = region;
  }
  /// Facet by facet of s. Both half-facets of a wall must know of it.
  void clear_walls(Simplex s) {
    make_room(s);
    walls_[s.index()] = 0;
  }
  void add_wall(HalfFacet h) {
    const Simplex s = Complex<Dim>::simplex_of(h);
    make_room(s);
    walls_[s.index()] = static_cast<std::uint8_t>(walls_[s.index()] | 1U << Complex<Dim>::corner_of(h));
  }
  void remove_wall(HalfFacet h) {
    std::uint8_t& walls = walls_[Complex<Dim>::simplex_of(h).index()];
    walls = static_cast<std::uint8_t>(walls & ~(1U << Complex<Dim>::corner_of(h)));
  }

  /// Inside simplices, by index. Linear.
  std::vector<Simplex> simplices() const;
  /// Walls with the inside on at least one side, each once, as the half-facet of its inside simplex; between
  /// two regions that of the smaller number. Linear.
  std::vector<HalfFacet> boundary() const;

 private:
  void make_room(Simplex s) {
    if (s.index() >= region_.size()) {
      region_.resize(triangulation_->complex().num_slots(), kOutside);
      walls_.resize(region_.size(), 0);
    }
  }
  void set_walls(std::span<const Wall> walls);
  bool is_on_wall(const Location<Dim>& at) const;
  void number_regions(const std::vector<std::uint32_t>& cell, std::vector<bool> inside,
                      const std::vector<std::pair<std::uint32_t, std::int64_t>>& tagged);

  const Triangulation<Dim>* triangulation_;
  std::vector<Region> region_;
  std::vector<std::uint8_t> walls_;  // bit i: facet i of the simplex
  std::vector<std::int64_t> tags_;   // by region, from 1
};

}  // namespace sinkmesh
