// SPDX-License-Identifier: MIT
#include "tools/reproduce/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "refine/distance_functions.h"
#include "refine/flow.h"
#include "refine/refine.h"
#include "test/support/xml_check.h"
#include "tools/io/read.h"
#include "tools/reproduce/detail/planar.h"

namespace sinkmesh::reproduce {
namespace {

using testing::HasSubstr;

const Surface2& usa() {
  static const Surface2 surface = read_surface<2>(std::string(SINKMESH_TEST_MODELS) + "/usa.poly");
  return surface;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

struct Figure {
  const char* name;
  std::function<std::string()> draw;
};
std::vector<Figure> figures() {
  return {{"figure-1", figure_level_sets},
          {"figure-2", [] { return figure_watersheds(usa()); }},
          {"figure-3", [] { return figure_graph_of_phi(usa()); }},
          {"figure-4", figure_flow_relation},
          {"figure-5", figure_flowers},
          {"figure-6", [] { return figure_first_sinks(usa()); }},
          {"figure-7", [] { return figure_block_meshes(usa()); }}};
}

TEST(Figures, AreWellFormedSmallAndTheSameEveryTime) {
  for (const Figure& figure : figures()) {
    SCOPED_TRACE(figure.name);
    const std::string svg = figure.draw();
    EXPECT_EQ(test::xml_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(std::string("id=\"") + figure.name + "\" viewBox=\"0 0 "));
    EXPECT_THAT(svg, HasSubstr("<title "));
    EXPECT_THAT(svg, HasSubstr("<desc "));
    EXPECT_LT(svg.size(), 400'000u);
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0u);
    EXPECT_EQ(figure.draw(), svg);
  }
}

// On a page, ids and style rules are seen by all pictures.
TEST(Figures, ShareNoNames) {
  for (const Figure& figure : figures()) {
    SCOPED_TRACE(figure.name);
    const std::string svg = figure.draw();
    EXPECT_EQ(count(svg, " id=\""), count(svg, " id=\"" + std::string(figure.name)));
    const std::size_t begin = svg.find("<style>") + 8;
    const std::string style = svg.substr(begin, svg.find("</style>") - begin);
    std::size_t at = 0;
    for (std::size_t end; (end = style.find('\n', at)) != std::string::npos; at = end + 1) {
      const std::string line = style.substr(at, end - at);
      const bool is_scoped = line.rfind("#" + std::string(figure.name), 0) == 0 ||
                             line.rfind("@media(prefers-color-scheme:dark){", 0) == 0 || line == "}";
      EXPECT_TRUE(is_scoped) << line;
    }
  }
}

// What Figure 1 relies on: phi is the minimum over all Delaunay balls, pi over all points.
TEST(Figures, LevelSetsAreUnionsOfDiscs) {
  const std::vector<Point2> points = detail::sample_points();
  Triangulation<2> triangulation(points);
  std::vector<detail::Ball> balls;
  for (const Simplex s : detail::solid_triangles(triangulation.complex())) {
    balls.push_back(detail::delaunay_ball(triangulation, s));
  }
  DistanceFunctions<2> functions(triangulation);
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(-0.9, 0.9);
  for (int n = 0; n < 500; ++n) {
    const Point2 y = {uniform(engine), uniform(engine)};
    double pi = HUGE_VAL;
    for (const Point2& p : points) pi = std::min(pi, detail::distance2(y, p));
    double phi = HUGE_VAL;
    for (const detail::Ball& ball : balls)
      phi = std::min(phi, detail::distance2(y, ball.center) - ball.radius2);
    EXPECT_NEAR(functions.pi(y).value, pi, 1e-12);
    EXPECT_NEAR(functions.phi(y).value, phi, 1e-9);
  }
}

TEST(Figures, LevelSetsMarkPointsAndSinks) {
  const std::vector<Point2> points = detail::sample_points();
  const Triangulation<2> triangulation(points);
  Flow<2> flow(triangulation);
  const std::string svg = figure_level_sets();
  // In two panels, and once in the legend.
  EXPECT_EQ(count(svg, "class=\"dot\""), 2 * points.size() + 1);
  EXPECT_EQ(count(svg, "class=\"mark\""), 2 * flow.sinks().size() + 1);
}

TEST(Figures, WatershedsCountWhatTheLibraryFinds) {
  SurfaceMesher2 mesher(usa());
  EXPECT_EQ(mesher.find_domain().peeled_simplices, 0u);
  Flow<2> flow(mesher.triangulation());
  const Complex<2>& complex = mesher.triangulation().complex();
  const std::vector<Simplex> inside = mesher.domain().simplices();
  std::size_t sinks = 0;
  std::size_t between = 0;  // sides of edges between ancestor sets; every such edge has two
  for (const Simplex s : inside) {
    if (flow.is_sink(s)) ++sinks;
    for (int i = 0; i < 3; ++i) {
      const Simplex t = complex.neighbor(s, i);
      if (mesher.domain().is_inside(t) && flow.sinks_reached({s}) != flow.sinks_reached({t})) ++between;
    }
  }
  const std::size_t bounding = between / 2 + mesher.domain().boundary().size();
  const std::string svg = figure_watersheds(usa());
  EXPECT_THAT(svg,
              HasSubstr(std::to_string(inside.size()) + " triangles, " + std::to_string(sinks) + " of which"));
  EXPECT_THAT(svg, HasSubstr(std::to_string(bounding) + " edges bound"));
  EXPECT_EQ(count(svg, "class=\"mark\""), sinks + 1);
  EXPECT_THAT(svg, HasSubstr(">" + std::to_string(sinks) + " sink triangles<"));
}

TEST(Figures, GraphOfPhiHasASummitForEverySinkAndAPatchForEveryTriangle) {
  SurfaceMesher2 mesher(usa());
  static_cast<void>(mesher.find_domain());
  Flow<2> flow(mesher.triangulation());
  const std::vector<Simplex> inside = mesher.domain().simplices();
  const auto sinks = static_cast<std::size_t>(
      std::count_if(inside.begin(), inside.end(), [&](Simplex s) { return flow.is_sink(s); }));
  const std::string svg = figure_graph_of_phi(usa());
  EXPECT_EQ(count(svg, "class=\"mark\""), sinks + 1);
  EXPECT_THAT(svg, HasSubstr(std::to_string(inside.size()) + " paraboloid patches"));
}

TEST(Figures, FlowRelationHasAnArrowForEveryPair) {
  const Triangulation<2> triangulation(detail::sample_points());
  Flow<2> flow(triangulation);
  std::size_t pairs = 0;
  for (const Simplex s : detail::solid_triangles(triangulation.complex())) pairs += flow.successors(s).size();
  const std::string svg = figure_flow_relation();
  EXPECT_EQ(count(svg, "class=\"flow\""), pairs + 1);  // and the large one
  EXPECT_THAT(svg, HasSubstr("all " + std::to_string(pairs) + " pairs"));
}

// Star and prestar have the same boundary: around k vertices, k triangles against k-2.
TEST(Figures, TheStarHasTwoTrianglesMoreThanThePrestar) {
  const std::string svg = figure_flowers();
  const auto number_after = [&](const std::string& word) {
    const std::size_t at = svg.find(word);
    return at == std::string::npos ? -1 : std::stoi(svg.substr(at + word.size()));
  };
  EXPECT_GE(number_after(">prestar: "), 4);
  EXPECT_EQ(number_after(">star: "), number_after(">prestar: ") + 2);
}

// [EG01, Figure 6]: 229 triangles, and two more for every sink.
TEST(Figures, FirstSinksAddTwoTrianglesEach) {
  const std::string svg = figure_first_sinks(usa());
  EXPECT_THAT(svg, HasSubstr(">no sink: 229 triangles, 147 of low quality<"));
  EXPECT_THAT(svg, HasSubstr(">4 sinks: 237 triangles,"));
  EXPECT_THAT(svg, HasSubstr(">12 sinks: 253 triangles,"));
  EXPECT_THAT(svg, HasSubstr(">15 sinks: 259 triangles,"));
  EXPECT_EQ(count(svg, "class=\"mark\""), 0u + 4 + 12 + 15 + 1);
}

TEST(Figures, BlockMeshesAreThoseOfTheLibrary) {
  const std::string svg = figure_block_meshes(usa());
  std::size_t added = 0;
  for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
    const Mesh2 mesh = refine<2>(usa(), {.max_ratio = 1, .insert = insert, .schedule = Schedule::block});
    EXPECT_THAT(svg, HasSubstr(": " + std::to_string(mesh.simplices.size()) + " triangles, "));
    added += mesh.points.size() - usa().points.size();
  }
  EXPECT_EQ(count(svg, "class=\"mark\""), added + 1);
}

}  // namespace
}  // namespace sinkmesh::reproduce
