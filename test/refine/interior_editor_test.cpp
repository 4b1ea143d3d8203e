// SPDX-License-Identifier: MIT
//
// Vertices that leave and come: labels, walls, flow and boundary against those found anew.
#include "refine/interior_editor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "predicates/input_gate.h"
#include "refine/steiner_inserter.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/conformed.h"
#include "test/support/dimensions.h"
#include "test/support/point_sets.h"

namespace sinkmesh {
namespace {

using namespace test;

// The sides of a square in four pieces each, and a wall through its middle; the sides of a cube as a grid.
template <int Dim>
Surface<Dim> cut_box() {
  Surface<Dim> s;
  if constexpr (Dim == 2) {
    add_polygon(s, square_outline());
    s.points.insert(s.points.end(), {{2, 1}, {2, 2}, {2, 3}});
    s.facets.insert(s.facets.end(), {{2, 16}, {16, 17}, {17, 18}, {18, 10}});
  } else {
    s = grid_cube(3, 3);
  }
  return s;
}

// Conforms a box, and puts points in at random, but in no diametral sphere of the boundary. Behind the gate the
// box holds the unit box.
template <int Dim>
struct Filled : Conforming<Dim> {
  explicit Filled(std::uint64_t seed) : Conforming<Dim>(cut_box<Dim>()) {
    this->conformer.start();
    EXPECT_TRUE(this->conform());
    num_given = static_cast<std::uint32_t>(this->complex().num_vertices());
    for (const Point<Dim>& p : uniform_points<Dim>(200, seed)) {
      const Point<Dim> x = on_grid<Dim>(p);
      this->triangulation.announce(x);
      bool is_free = true;
      for (const SubFacet f : this->sub_facets()) {
        is_free =
            is_free && this->triangulation.predicates().diametral_side(this->boundary.corner_points(f), x) > 0;
      }
      if (is_free) this->insert(x, {});
    }
    EXPECT_GT(this->complex().num_vertices(), num_given + 10);
    this->label();
  }

  // Everything that is kept beside the triangulation, found anew.
  void expect_consistent() {
    ASSERT_TRUE(this->triangulation.validate().ok()) << this->triangulation.validate();
    expect_walls(*this);
    Domain<Dim> fresh(this->triangulation);
    fresh.label(this->facets, this->boundary.walls(), this->surface.seeds);
    Flow<Dim> fresh_flow(this->triangulation);
    for (const Simplex s : this->complex().simplices()) {
      ASSERT_EQ(this->domain.region(s), fresh.region(s)) << s;
      for (int i = 0; i <= Dim; ++i) {
        const HalfFacet h = Complex<Dim>::half_facet(s, i);
        ASSERT_EQ(this->domain.is_wall(h), fresh.is_wall(h)) << h;
        if (this->complex().is_ghost(s)) continue;
        ASSERT_EQ(this->flow.crosses(h), fresh_flow.crosses(h)) << h;
        ASSERT_FALSE(this->domain.is_wall(h) && fresh_flow.crosses(h)) << "not stable any more: " << h;
      }
    }
  }

  std::uint32_t num_given;
};

template <class T>
class InteriorEditorTest : public testing::Test {};
TYPED_TEST_SUITE(InteriorEditorTest, PlaneAndSpace, DimensionName);

TYPED_TEST(InteriorEditorTest, RemovingAndPuttingBackKeepsAllInStep) {
  constexpr int kDim = TypeParam::value;
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Filled<kDim> mesh(seed);
    mesh.expect_consistent();
    InteriorEditor<kDim> editor(mesh.triangulation, mesh.domain, mesh.flow, &mesh.boundary, mesh.num_given);
    for (const HalfFacet h : mesh.domain.boundary()) mesh.flow.crosses(h);
    for (std::uint32_t i = mesh.num_given; i < mesh.complex().num_vertices(); ++i) {
      const Vertex v(i);
      ASSERT_TRUE(editor.is_movable(v));
      const std::uint64_t hash = mesh.triangulation.hash();
      const std::size_t star_size = editor.star(v).size();
      const std::size_t filling_size = editor.without(v).size();
      ASSERT_EQ(mesh.triangulation.hash(), hash) << "looking has changed the complex";
      const std::vector<Simplex> fresh = editor.remove(v);
      ASSERT_EQ(fresh.size(), filling_size);
      ASSERT_TRUE(kDim == 3 || fresh.size() + 2 == star_size);  // in space there may even be more
      ASSERT_FALSE(editor.is_movable(v));
      mesh.expect_consistent();
      ASSERT_EQ(editor.insert(mesh.complex().point(v), fresh.front(), v), v);
      mesh.expect_consistent();
      ASSERT_EQ(mesh.triangulation.hash(), hash);
    }
  }
}

TYPED_TEST(InteriorEditorTest, GivenVerticesAndThoseOnTheBoundaryStay) {
  constexpr int kDim = TypeParam::value;
  Filled<kDim> mesh(4);
  InteriorEditor<kDim> all(mesh.triangulation, mesh.domain, mesh.flow, &mesh.boundary, 0);
  for (std::uint32_t i = 0; i < mesh.num_given; ++i) EXPECT_FALSE(all.is_movable(Vertex(i)));
  const auto num_vertices = static_cast<std::uint32_t>(mesh.complex().num_vertices());
  InteriorEditor<kDim> none(mesh.triangulation, mesh.domain, mesh.flow, &mesh.boundary, num_vertices);
  for (std::uint32_t i = 0; i < num_vertices; ++i) EXPECT_FALSE(none.is_movable(Vertex(i)));
  EXPECT_FALSE(all.is_movable(Vertex::infinite()));
}

// A point that is looked at may be inserted exactly if it is inside, in no diametral sphere of the boundary, no
// nearer to a vertex than the shortest edge, and its insertion destroys no wall.
TYPED_TEST(InteriorEditorTest, LooksAtPointsAsTheDefinitionDoes) {
  constexpr int kDim = TypeParam::value;
  Filled<kDim> mesh(5);
  const Complex<kDim>& complex = mesh.complex();
  InteriorEditor<kDim> editor(mesh.triangulation, mesh.domain, mesh.flow, &mesh.boundary, mesh.num_given);
  double shortest2 = HUGE_VAL;
  for (const Simplex s : complex.simplices()) {
    if (!complex.is_ghost(s)) shortest2 = std::min(shortest2, shape<kDim>(complex.corners(s)).shortest2);
  }
  std::size_t yes = 0;
  std::size_t no = 0;
  for (Point<kDim> p : uniform_points<kDim>(400, 6)) {
    for (double& x : p) x *= 1.2;
    const Point<kDim> x = on_grid<kDim>(p);
    mesh.triangulation.announce(x);
    const Simplex near = mesh.triangulation.locate(x).simplex;
    if (!mesh.domain.is_inside(near)) continue;
    bool expected = true;
    for (std::uint32_t v = 0; v < complex.num_vertices(); ++v) {
      expected = expected && squared_distance(x, complex.point(Vertex(v))) > shortest2;
    }
    for (const HalfFacet h : mesh.domain.boundary()) {
      expected = expected && mesh.triangulation.predicates().diametral_side(complex.facet_corners(h), x) > 0;
    }
    const std::uint64_t hash = mesh.triangulation.hash();
    EXPECT_EQ(editor.look(x, near, [] { return true; }), expected);
    EXPECT_FALSE(editor.look(x, near, [] { return false; }));
    ASSERT_EQ(mesh.triangulation.hash(), hash);
    ASSERT_TRUE(mesh.triangulation.validate().ok());
    yes += expected ? 1 : 0;
    no += expected ? 0 : 1;
  }
  EXPECT_GT(yes, 5U);
  EXPECT_GT(no, 20U);
}

}  // namespace
}  // namespace sinkmesh
