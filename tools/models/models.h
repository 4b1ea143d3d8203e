// SPDX-License-Identifier: MIT
//
// The paper's five models, made from its description of them [EG01, 5]; its files are not available.
//
// Every model is a closed surface, oriented outward, without points inside, whose facets are all Delaunay: each
// is a facet of the Delaunay triangulation of the points. It is stable: no flow leads out of it, and all
// circumcenters of simplices inside are inside. The same arguments give the same model.
//
// The functions take the number of triangles that is wanted, and meet it within two percent, mostly exactly.
// They are meant for a tenth to ten times the paper's number (Model::least_triangles(), most_triangles()) and
// tested there; beyond, they may break these promises or throw std::logic_error. Finer models have more slender
// simplices inside, since nothing but the surface is sampled.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <variant>

#include "refine/surface.h"

namespace sinkmesh::models {

/// The outline of the contiguous United States without islands; Albers' projection, units of 1000 km. Has as
/// many segments as it takes for `triangles` inside: two more. With few, the shape is coarse; with more than
/// about 280 some points lie between two of the source, where its edges have to be divided to be stable.
/// Cost: 0.02 s, and 0.3 s for ten times the paper's triangles.
Surface2 make_usa(std::size_t triangles);

/// A level set of Gaussian blobs at the vertices of a cuboctahedron of circumradius 1, filled; sampled more
/// finely where it is curved. Centrally symmetric: with p, -p is a point, exactly. Genus 0.
/// Cost: 0.2 s; 5 s for ten times the paper's triangles.
Surface3 make_cuboctahedron(std::size_t triangles);

/// The solid x^2 + y^2 <= z <= 1, with a flat lid and a sharp rim; sampled more finely towards the middle of
/// the lid, which gives the tetrahedra the paper's range of r/l. Genus 0.
/// Cost: 0.1 s; 3 s for ten times the paper's triangles.
Surface3 make_paraboloid(std::size_t triangles);

/// The cavity in a segment of a rocket motor: a core of radius 0.5 with eleven fins, each 1.2 long and 0.14
/// thick; 4 long, in metres. Rows of points along z, every other one shifted by half a segment, moved by 0.2 %
/// of their distances so that opposite walls and neighboring rows are not cospherical; the core is rough by a
/// few tenths of a millimetre (for the paper's number of triangles) for the same reason. With less than about a
/// quarter of the paper's triangles, these are less slender, because the fins are thin. Genus 0.
/// Cost: 0.05 s; 0.5 s for ten times the paper's triangles.
Surface3 make_star(std::size_t triangles);

/// The propellant around that cavity: a cylinder of radius 1.87, through which the star goes from end to end.
/// The facets around the cavity are the star's, reversed: those of make_star(round(triangles * 53508 / 67940)).
/// With less than about a quarter of the paper's triangles, the outer wall is sampled more finely than the
/// rest, because the fins' tips are close to it. Genus 1.
/// Cost: as for the star.
Surface3 make_head(std::size_t triangles);

struct Model {
  std::string_view name;
  std::string_view description;
  /// The paper's: on the surface, or in the plane inside.
  std::size_t triangles;
  std::variant<Surface2 (*)(std::size_t), Surface3 (*)(std::size_t)> make;

  std::size_t least_triangles() const { return (triangles + 9) / 10; }
  std::size_t most_triangles() const { return triangles * 10; }
};

/// All of them, in the paper's order.
std::span<const Model> all_models();
/// Null if there is none of that name.
const Model* find_model(std::string_view name);

}  // namespace sinkmesh::models
