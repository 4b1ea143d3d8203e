// SPDX-License-Identifier: MIT
//
// Interior and boundary refined together: what must hold of every mesh, looked at from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "refine/mesh_check.h"
#include "refine/refine.h"
#include "test/support/boundary_surfaces.h"
#include "test/support/dimensions.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh {
namespace {

using test::Rational;

struct Combination {
  std::string name;
  Insert insert;
  Schedule schedule;
};
std::vector<Combination> combinations() {
  std::vector<Combination> result;
  for (const Insert insert : {Insert::off_sink, Insert::sink, Insert::circumcenter}) {
    for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
      result.push_back({std::string(name(insert)) + " " + name(schedule), insert, schedule});
    }
  }
  return result;
}

RefineOptions options_for(int dim, const Combination& combination) {
  RefineOptions options;
  options.insert = combination.insert;
  options.schedule = combination.schedule;
  options.max_ratio = dim == 2 ? 1.0 : 2.0;
  options.boundary.mode = BoundaryMode::refine;
  options.max_vertices = 5000;  // so that a run that does not end fails
  return options;
}

// Small ones: the exact checks take longer than the meshes.
template <int Dim>
std::vector<test::NamedSurface<Dim>> inputs() {
  auto all = test::boundary_surfaces<Dim>();
  std::erase_if(all, [](const auto& input) {
    return input.name == "plate 1:10" || input.name == "wedge of 1" || input.name == "grid cube";
  });
  return all;
}

template <int Dim>
std::array<test::RationalPoint<Dim>, Dim + 1> corners_of(const Mesh<Dim>& mesh, std::size_t simplex) {
  std::array<test::RationalPoint<Dim>, Dim + 1> p;
  for (std::size_t i = 0; i <= Dim; ++i) p[i] = test::rational<Dim>(mesh.points[mesh.simplices[simplex][i]]);
  return p;
}

// Dim! times the volume.
template <int Dim>
Rational volume(const std::array<test::RationalPoint<Dim>, Dim + 1>& p) {
  std::array<std::array<Rational, Dim>, Dim> d;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) d[i][k] = p[i + 1][k] - p[0][k];
  }
  if constexpr (Dim == 2) {
    return d[0][0] * d[1][1] - d[0][1] * d[1][0];
  } else {
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
           d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }
}

template <int Dim>
const std::vector<std::int64_t>& field(const std::vector<typename Mesh<Dim>::Field>& fields,
                                       const std::string& name) {
  for (const auto& f : fields) {
    if (f.name == name) return f.values;
  }
  throw std::runtime_error("no field " + name);
}

// A walk in the mesh towards the exact circumcenter, facet by facet: it must not leave the mesh, nor pass into
// another region. Facets of the boundary that the walk need not cross do not matter.
template <int Dim>
void expect_circumcenters_inside(const Mesh<Dim>& mesh) {
  using Facet = std::array<std::uint32_t, Dim>;
  std::map<Facet, std::vector<std::size_t>> at;
  const auto facet = [&](std::size_t s, std::size_t i) {
    Facet f{};
    std::size_t n = 0;
    for (std::size_t k = 0; k <= Dim; ++k) {
      if (k != i) f[n++] = mesh.simplices[s][k];
    }
    std::sort(f.begin(), f.end());
    return f;
  };
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    for (std::size_t i = 0; i <= Dim; ++i) at[facet(s, i)].push_back(s);
  }
  for (std::size_t first = 0; first < mesh.simplices.size(); ++first) {
    const auto center = test::orthosphere<Dim>(corners_of(mesh, first)).center;
    std::size_t s = first;
    for (std::size_t steps = 0;; ++steps) {
      ASSERT_LE(steps, mesh.simplices.size());
      const auto part = test::barycentric<Dim>(corners_of(mesh, s), center);
      const auto out = std::find_if(part.begin(), part.end(), [](const Rational& x) { return x < 0; });
      if (out == part.end()) break;
      const auto& sides = at[facet(s, static_cast<std::size_t>(out - part.begin()))];
      ASSERT_EQ(sides.size(), 2U) << "the circumcenter of simplex " << first << " is outside";
      s = sides[0] == s ? sides[1] : sides[0];
    }
  }
}

// Volumes of the regions, in their order.
template <int Dim>
std::vector<double> region_volumes(const Mesh<Dim>& mesh) {
  std::vector<Rational> sums;
  const auto& region = field<Dim>(mesh.simplex_fields, "region");
  EXPECT_EQ(region.size(), mesh.simplices.size());
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const auto r = static_cast<std::size_t>(region[s]);
    EXPECT_GE(r, 1U);
    if (sums.size() < r) sums.resize(r, 0);
    sums[r - 1] += volume<Dim>(corners_of(mesh, s));
  }
  std::vector<double> result;
  for (const Rational& sum : sums) result.push_back(sum.get_d() / (Dim == 2 ? 2 : 6));
  return result;
}

// What is written about simplices of low quality that remain, against the mesh.
template <int Dim>
void expect_leftovers(const Mesh<Dim>& mesh, const std::vector<Leftover<Dim>>& leftovers,
                      const Remaining& remaining, double max_ratio, std::size_t num_input) {
  using Ids = std::array<std::uint32_t, Dim + 1>;
  std::map<Ids, double> low;
  for (const auto& simplex : mesh.simplices) {
    Corners<Dim> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &mesh.points[simplex[i]];
    const double ratio2 = shape<Dim>(corners).ratio2();
    Ids ids = simplex;
    std::sort(ids.begin(), ids.end());
    if (ratio2 > max_ratio * max_ratio) low[ids] = std::sqrt(ratio2);
  }
  EXPECT_EQ(leftovers.size(), low.size());
  EXPECT_EQ(remaining.total(), low.size());
  Remaining counted;
  double before = HUGE_VAL;
  for (const Leftover<Dim>& leftover : leftovers) {
    ++counted.count(leftover.reason);
    Ids ids = leftover.corners;
    std::sort(ids.begin(), ids.end());
    ASSERT_TRUE(low.contains(ids)) << "no simplex of the mesh, or none of low quality";
    EXPECT_NEAR(leftover.ratio / low[ids], 1, 1e-6);
    EXPECT_LE(leftover.ratio, before);
    before = leftover.ratio;
    low.erase(ids);
    using Kind = BoundaryFeature::Kind;
    if (leftover.reason != LeftoverReason::small_angle) {
      EXPECT_EQ(leftover.first.kind, Kind::none);
      EXPECT_EQ(leftover.common.kind, Kind::none);
    } else if (leftover.common.kind != Kind::none) {
      EXPECT_TRUE(leftover.common.kind == Kind::corner || leftover.common.kind == Kind::segment);
      for (const BoundaryFeature& feature : {leftover.first, leftover.second}) {
        EXPECT_TRUE(feature.kind == Kind::segment || feature.kind == Kind::patch);
        if (feature.kind != Kind::segment) continue;
        for (const std::uint32_t v : feature.ids) EXPECT_LT(v, num_input);
        // A segment touches another feature in one of its ends.
        if (leftover.common.kind == Kind::corner) {
          EXPECT_NE(std::find(feature.ids.begin(), feature.ids.end(), leftover.common.ids[0]),
                    feature.ids.end());
        }
      }
    }
  }
  for (const LeftoverReason reason : kLeftoverReasons)
    EXPECT_EQ(counted.count(reason), remaining.count(reason));
}

// Of what the mesher says about itself, and of all meshes.
template <int Dim>
void expect_sound(const test::NamedSurface<Dim>& input, const SurfaceMesher<Dim>& mesher,
                  const RefineResult& result, double max_ratio) {
  ASSERT_TRUE(mesher.triangulation().validate().ok()) << mesher.triangulation().validate();
  const Mesh<Dim> mesh = mesher.mesh();
  const MeshCheck<Dim> check = check_mesh(mesh, max_ratio);
  ASSERT_TRUE(check.ok()) << check.defects.front().message;
  EXPECT_EQ(check.simplices_not_delaunay, 0U);
  EXPECT_EQ(check.facets_not_delaunay, 0U);
  EXPECT_EQ(check.unstable_facets, 0U);
  ASSERT_LE(input.surface.points.size(), mesh.points.size());
  EXPECT_TRUE(std::equal(input.surface.points.begin(), input.surface.points.end(), mesh.points.begin()));
  double sum = 0;
  for (const double v : region_volumes(mesh)) sum += v;
  EXPECT_NEAR(sum, input.measure, 1e-12 * std::max(1.0, input.measure));
  expect_leftovers(mesh, mesher.leftovers(), result.remaining, max_ratio, input.surface.points.size());
}

template <class T>
class BoundaryRefiner : public testing::Test {};
TYPED_TEST_SUITE(BoundaryRefiner, test::PlaneAndSpace, test::DimensionName);

TYPED_TEST(BoundaryRefiner, MakesASoundMeshOfEverySurface) {
  constexpr int kDim = TypeParam::value;
  for (const auto& input : inputs<kDim>()) {
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      SurfaceMesher<kDim> mesher(input.surface);
      const RefineOptions options = options_for(kDim, combination);
      const BoundaryResult boundary = mesher.find_domain(options);
      ASSERT_TRUE(boundary.ok());
      EXPECT_EQ(boundary.mode, BoundaryMode::refine);
      const std::size_t before = mesher.mesh().points.size();
      EXPECT_EQ(before, input.surface.points.size() + boundary.points_on_segments + boundary.points_on_patches);
      const RefineResult result = mesher.refine(options);
      EXPECT_EQ(result.stop, Stop::no_candidate);
      EXPECT_EQ(mesher.mesh().points.size(), before + result.inserted);
      expect_sound(input, mesher, result, options.max_ratio);
      EXPECT_EQ(result.remaining.untried, 0U);
      if (combination.schedule != Schedule::block) expect_circumcenters_inside(mesher.mesh());
    }
  }
}

// A simplex with all its vertices on one side of an axis-parallel solid.
TEST(BoundaryRefiner, LeavesNoSimplexFlatOnASide) {
  for (const auto& input : inputs<3>()) {
    if (!input.is_exact) continue;
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      const Mesh3 mesh = refine(input.surface, options_for(3, combination));
      for (const auto& simplex : mesh.simplices) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = mesh.points[simplex[0]][k];
          const bool is_flat = std::all_of(simplex.begin(), simplex.end(),
                                           [&](std::uint32_t v) { return mesh.points[v][k] == x; });
          EXPECT_FALSE(is_flat);
        }
      }
    }
  }
}

void expect_no_thin_simplex(test::NamedSurface<3> input) {
  const std::vector<Point3> upright = input.surface.points;
  for (Point3& p : input.surface.points) {
    const double x = 0.36 * p[0] - 0.48 * p[1] + 0.8 * p[2];
    const double y = 0.8 * p[0] + 0.6 * p[1];
    const double z = -0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2];
    p = {x, y, z};
  }
  const auto is_excused = [&](const Mesh3::Simplex& simplex) {
    if (*std::max_element(simplex.begin(), simplex.end()) >= upright.size()) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = upright[simplex[0]][k];
      const bool is_on_side =
          std::all_of(simplex.begin(), simplex.end(), [&](std::uint32_t v) { return upright[v][k] == x; });
      const auto [low, high] = std::minmax_element(upright.begin(), upright.end(),
                                                   [k](const auto& p, const auto& q) { return p[k] < q[k]; });
      if (is_on_side && (x == (*low)[k] || x == (*high)[k])) return false;
    }
    return true;
  };
  for (const Combination& combination : combinations()) {
    if (combination.schedule == Schedule::block) continue;
    SCOPED_TRACE(input.name + ", " + combination.name);
    SurfaceMesher3 mesher(input.surface);
    const RefineOptions options = options_for(3, combination);
    ASSERT_TRUE(mesher.find_domain(options).ok());
    const RefineResult result = mesher.refine(options);
    expect_sound(input, mesher, result, 2);
    const Mesh3 mesh = mesher.mesh();
    for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
      if (is_excused(mesh.simplices[s])) continue;
      double longest2 = 0;
      for (const std::uint32_t a : mesh.simplices[s]) {
        for (const std::uint32_t b : mesh.simplices[s]) {
          double d2 = 0;
          for (std::size_t k = 0; k < 3; ++k) d2 += std::pow(mesh.points[a][k] - mesh.points[b][k], 2);
          longest2 = std::max(longest2, d2);
        }
      }
      EXPECT_GT(volume<3>(corners_of(mesh, s)).get_d() / 6, 1e-9 * std::pow(longest2, 1.5));
    }
  }
}

// Turned by angles that are no multiples of anything, four points of a side are rarely coplanar any more. Thin
// simplices between four input points in the inside are theirs.
TEST(BoundaryRefiner, LeavesNoThinSimplexOnARotatedSide) {
  for (const auto& input : inputs<3>()) {
    if (input.is_exact) expect_no_thin_simplex(input);
  }
}

TYPED_TEST(BoundaryRefiner, DoesNotDependOnTheOrderOfTheInput) {
  constexpr int kDim = TypeParam::value;
  for (const auto& input : inputs<kDim>()) {
    for (const Combination& combination : combinations()) {
      if (combination.schedule == Schedule::block) continue;
      SCOPED_TRACE(input.name + ", " + combination.name);
      const RefineOptions options = options_for(kDim, combination);
      std::set<std::pair<std::size_t, std::uint64_t>> conformed;
      std::set<std::pair<std::size_t, std::uint64_t>> refined;
      for (const std::uint64_t seed : {0, 1, 2}) {
        test::Random random(seed);
        SurfaceMesher<kDim> mesher(seed == 0 ? input.surface : test::in_another_order(input.surface, random));
        ASSERT_TRUE(mesher.find_domain(options).ok());
        conformed.emplace(mesher.mesh().points.size(), mesher.hash());
        mesher.refine(options);
        refined.emplace(mesher.mesh().points.size(), mesher.hash());
      }
      EXPECT_EQ(conformed.size(), 1U) << "after conforming";
      EXPECT_EQ(refined.size(), 1U);
    }
  }
}

// Parents and tags of the pieces of the boundary, regions of the simplices beside it.
TYPED_TEST(BoundaryRefiner, FieldsCarryParentsTagsAndRegions) {
  constexpr int kDim = TypeParam::value;
  for (auto input : inputs<kDim>()) {
    if (input.name == "wedge of 5") continue;  // does not conform like this, see below
    SCOPED_TRACE(input.name);
    for (std::size_t f = 0; f < input.surface.facets.size(); ++f) {
      input.surface.facet_tags.push_back(static_cast<std::int64_t>(100 + 7 * f));  // none are joined
    }
    const Mesh<kDim> mesh = refine(input.surface, options_for(kDim, combinations()[0]));
    const auto& parent = field<kDim>(mesh.boundary_fields, "parent");
    const auto& tag = field<kDim>(mesh.boundary_fields, "tag");
    ASSERT_EQ(parent.size(), mesh.boundary.size());
    ASSERT_EQ(tag.size(), mesh.boundary.size());
    std::vector<double> measure(input.surface.facets.size(), 0);
    const auto size_of = [&](const std::array<std::uint32_t, kDim>& f) {
      const auto& a = mesh.points[f[0]];
      const auto& b = mesh.points[f[1]];
      if constexpr (kDim == 2) {
        return std::hypot(b[0] - a[0], b[1] - a[1]);
      } else {
        const auto& c = mesh.points[f[2]];
        double n2 = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t l = (k + 1) % 3;
          n2 += std::pow((b[k] - a[k]) * (c[l] - a[l]) - (b[l] - a[l]) * (c[k] - a[k]), 2);
        }
        return std::sqrt(n2) / 2;
      }
    };
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
      ASSERT_GE(parent[i], 0);
      const auto f = static_cast<std::size_t>(parent[i]);
      ASSERT_LT(f, input.surface.facets.size());
      EXPECT_EQ(tag[i], input.surface.facet_tags[f]);
      measure[f] += size_of(mesh.boundary[i]);
    }
    for (std::size_t f = 0; f < measure.size(); ++f) {
      const double size = size_of(input.surface.facets[f]);
      EXPECT_NEAR(measure[f], size, 1e-12 * size) << "facet " << f;
    }
  }
}

TEST(BoundaryRefiner, RegionsHaveTheirOwnVolumes) {
  for (const Combination& combination : combinations()) {
    SCOPED_TRACE(combination.name);
    Surface3 boxes = test::two_boxes(true);
    for (Point3& p : boxes.points) p[0] = p[0] == 2 ? 3 : p[0];
    EXPECT_EQ(region_volumes(refine(boxes, options_for(3, combination))), (std::vector<double>{1, 2}));
    boxes.seeds.regions = {{{2, 0.5, 0.5}, 42}, {{0.5, 0.5, 0.5}, -7}};
    const Mesh3 tagged = refine(boxes, options_for(3, combination));
    const auto& region = field<3>(tagged.simplex_fields, "region");
    const auto& tag = field<3>(tagged.simplex_fields, "tag");
    for (std::size_t s = 0; s < region.size(); ++s) EXPECT_EQ(tag[s], region[s] == 1 ? -7 : 42);
    boxes.seeds.holes = {{0.5, 0.5, 0.5}};
    boxes.seeds.regions.pop_back();
    EXPECT_EQ(region_volumes(refine(boxes, options_for(3, combination))), std::vector<double>{2});
    // Without the wall it is one box.
    Surface3 open = test::two_boxes(false);
    EXPECT_EQ(region_volumes(refine(open, options_for(3, combination))), std::vector<double>{2});

    auto plans = test::boundary_plans();
    const auto& cut =
        *std::find_if(plans.begin(), plans.end(), [](const auto& p) { return p.name == "cut square"; });
    const auto areas = region_volumes(refine(cut.surface, options_for(2, combination)));
    ASSERT_EQ(areas.size(), 2U);
    for (const double area : areas) EXPECT_NEAR(area, 50, 1e-12);
  }
}

// At any moment: while conforming there is no domain yet; afterwards the mesh is sound whenever it stops.
TYPED_TEST(BoundaryRefiner, EndsWithASoundMeshWheneverItIsStopped) {
  constexpr int kDim = TypeParam::value;
  test::Random random(31);
  for (const auto& input : inputs<kDim>()) {
    if (input.name.find("star") == std::string::npos && input.name != "L" && input.name != "wedge of 20")
      continue;
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      RefineOptions options = options_for(kDim, combination);
      SurfaceMesher<kDim> whole(input.surface);
      ASSERT_TRUE(whole.find_domain(options).ok());
      const std::size_t conformed = whole.mesh().points.size();
      whole.refine(options);
      const std::size_t most = whole.mesh().points.size();
      for (int round = 0; round < 3; ++round) {
        SurfaceMesher<kDim> mesher(input.surface);
        ASSERT_TRUE(mesher.find_domain(options).ok());
        RefineOptions less = options;
        less.max_vertices = conformed + random() % (most - conformed + 1);
        const RefineResult result = mesher.refine(less);
        if (result.stop == Stop::budget) {
          EXPECT_LE(mesher.num_vertices(), less.max_vertices);
          EXPECT_LE(mesher.num_vertices(), whole.num_vertices());
        } else {
          EXPECT_EQ(result.stop, Stop::no_candidate);
          EXPECT_EQ(mesher.hash(), whole.hash());
        }
        expect_sound(input, mesher, result, options.max_ratio);
        EXPECT_EQ(mesher.mesh().points.size(), conformed + result.inserted);
        // And it can go on.
        const RefineResult rest = mesher.refine(options);
        EXPECT_EQ(rest.stop, Stop::no_candidate);
        expect_sound(input, mesher, rest, options.max_ratio);
      }
      std::size_t polls = 0;
      std::size_t last = random() % 4;
      options.should_continue = [&] { return polls++ >= last ? Continue::cancelled : Continue::yes; };
      SurfaceMesher<kDim> mesher(input.surface);
      RefineOptions unlimited = options;
      unlimited.should_continue = {};
      ASSERT_TRUE(mesher.find_domain(unlimited).ok());
      const RefineResult result = mesher.refine(options);
      EXPECT_EQ(result.stop, polls > last ? Stop::cancelled : Stop::no_candidate);
      expect_sound(input, mesher, result, options.max_ratio);
    }
  }
}

TYPED_TEST(BoundaryRefiner, ConformingObeysBudgets) {
  constexpr int kDim = TypeParam::value;
  for (const auto& input : inputs<kDim>()) {
    RefineOptions options = options_for(kDim, combinations()[0]);
    SurfaceMesher<kDim> whole(input.surface);
    ASSERT_TRUE(whole.find_domain(options).ok());
    const std::size_t needed = whole.mesh().points.size() - input.surface.points.size();
    if (needed < 2) continue;
    SCOPED_TRACE(input.name);
    options.max_vertices = input.surface.points.size() + needed / 2;
    SurfaceMesher<kDim> mesher(input.surface);
    const BoundaryResult result = mesher.find_domain(options);
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.stop, Stop::budget);
    EXPECT_EQ(result.points_on_segments + result.points_on_patches, needed / 2);
    EXPECT_TRUE(mesher.mesh().simplices.empty());
    EXPECT_THROW(refine(input.surface, options), InputError);
    options.max_vertices = options_for(kDim, combinations()[0]).max_vertices;
    options.should_continue = [] { return Continue::cancelled; };
    SurfaceMesher<kDim> cancelled(input.surface);
    EXPECT_EQ(cancelled.find_domain(options).stop, Stop::cancelled);
  }
}

// What it tells while it works, points on the boundary included.
TYPED_TEST(BoundaryRefiner, ObserverSeesTheMeshAfterEachRound) {
  constexpr int kDim = TypeParam::value;
  std::size_t taken_back = 0;
  for (const auto& input : inputs<kDim>()) {
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      RefineOptions options = options_for(kDim, combination);
      SurfaceMesher<kDim> mesher(input.surface);
      ASSERT_TRUE(mesher.find_domain(options).ok());
      const std::size_t before = mesher.num_vertices();
      std::size_t inserted = 0;
      std::size_t rounds = 0;
      std::size_t low = 0;
      options.observer = [&](const Progress& progress) {
        low = progress.low_quality;
        EXPECT_EQ(progress.round, ++rounds);
        inserted += progress.inserted;
        EXPECT_EQ(progress.vertices, before + inserted);
        const QualityStatistics quality = progress.statistics();
        EXPECT_EQ(quality.simplices(), progress.simplices);
        EXPECT_EQ(quality.low_quality(), progress.low_quality);
      };
      const RefineResult result = mesher.refine(options);
      EXPECT_EQ(mesher.num_vertices(), before + result.inserted);
      if (result.rounds != rounds || result.inserted < inserted) {
        // Dividing the boundary left more than there had been, or fewer were to be excused than was asked for
        // and that did not end well: it was taken back.
        EXPECT_TRUE(result.remaining.total() < low || input.name == "wedge of 20");
        ++taken_back;
        EXPECT_EQ(result.stop, Stop::no_candidate);
      } else {
        EXPECT_EQ(result.rounds, rounds);
        EXPECT_EQ(result.inserted, inserted);
      }
    }
  }
  EXPECT_EQ(taken_back > 0, kDim == 3);
}

TYPED_TEST(BoundaryRefiner, KeepsTheOrderThatIsAskedForOrTheBest) {
  constexpr int kDim = TypeParam::value;
  std::size_t different = 0;
  for (const auto& input : inputs<kDim>()) {
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      RefineOptions options = options_for(kDim, combination);
      options.max_ratio = 1.2;  // so that there is work enough
      std::set<std::uint64_t> hashes;
      for (const std::optional<Order> order :
           {std::optional<Order>(), std::optional(Order::ratio), std::optional(Order::shortest),
            std::optional(Order::smallest)}) {
        options.order = order;
        SurfaceMesher<kDim> mesher(input.surface);
        ASSERT_TRUE(mesher.find_domain(options).ok());
        EXPECT_EQ(mesher.refine(options).order, order.value_or(default_order<kDim>(combination.insert, true)));
        hashes.insert(mesher.hash());
      }
      different += hashes.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(different, 5U);
}

// Nor is anything tried for excused simplices when it is done again.
TYPED_TEST(BoundaryRefiner, LeavesSimplicesAloneThatASmallAngleExcuses) {
  constexpr int kDim = TypeParam::value;
  std::size_t excused = 0;
  auto all = inputs<kDim>();
  if constexpr (kDim == 3) all.push_back({"twisted by 50 degrees", test::schoenhardt(50), 0, false});
  for (const auto& input : all) {
    for (const Combination& combination : combinations()) {
      if (combination.schedule == Schedule::incremental) continue;
      SCOPED_TRACE(input.name + ", " + combination.name);
      SurfaceMesher<kDim> mesher(input.surface);
      const RefineOptions options = options_for(kDim, combination);
      const BoundaryResult boundary = mesher.find_domain(options);
      ASSERT_TRUE(boundary.ok());
      const Remaining remaining = mesher.refine(options).remaining;
      // Where no point was needed to conform, fewer may be excused the second time.
      if (boundary.points_on_segments + boundary.points_on_patches == 0) continue;
      if (remaining.small_angle != remaining.total()) continue;
      excused += remaining.small_angle;
      const RefineResult again = mesher.refine(options);
      EXPECT_EQ(again.candidates, 0U);
      EXPECT_EQ(again.inserted, 0U);
      EXPECT_EQ(again.remaining.small_angle, remaining.small_angle);
    }
  }
  EXPECT_GT(excused, 30U);
}

// What is stable as given is not touched, unless it is asked for.
TEST(BoundaryRefiner, AutomaticKeepsAStableSurfaceFixed) {
  const Surface3 stable = test::ellipsoid_surface(3, {1, 1.1, 0.9}, 1e-3);
  for (const Combination& combination : combinations()) {
    SCOPED_TRACE(combination.name);
    RefineOptions options = options_for(3, combination);
    options.max_ratio = 1.2;
    std::map<BoundaryMode, std::uint64_t> hashes;
    for (const BoundaryMode mode : {BoundaryMode::automatic, BoundaryMode::fixed}) {
      options.boundary.mode = mode;
      SurfaceMesher3 mesher(stable);
      const BoundaryResult boundary = mesher.find_domain(options);
      EXPECT_EQ(boundary.mode, BoundaryMode::fixed);
      EXPECT_EQ(boundary.peeled_simplices, 0U);
      const RefineResult result = mesher.refine(options);
      EXPECT_EQ(result.points_on_segments + result.points_on_patches, 0U);
      EXPECT_EQ(mesher.mesh().boundary.size(), stable.facets.size());
      hashes[mode] = mesher.hash();
    }
    EXPECT_EQ(hashes[BoundaryMode::automatic], hashes[BoundaryMode::fixed]);
    options.boundary.mode = BoundaryMode::automatic;
    SurfaceMesher3 unstable(test::wedge(10));
    EXPECT_EQ(unstable.find_domain(options).mode, BoundaryMode::refine);
  }
}

// With the boundary in play no more simplices of low quality stay than without.
TYPED_TEST(BoundaryRefiner, LeavesNothingWhereAnglesAreLarge) {
  constexpr int kDim = TypeParam::value;
  for (const auto& input : inputs<kDim>()) {
    if (!input.is_exact) continue;
    for (const Combination& combination : combinations()) {
      SCOPED_TRACE(input.name + ", " + combination.name);
      SurfaceMesher<kDim> mesher(input.surface);
      const RefineOptions options = options_for(kDim, combination);
      ASSERT_TRUE(mesher.find_domain(options).ok());
      EXPECT_EQ(mesher.refine(options).remaining.total(), 0U);
    }
  }
}

}  // namespace
}  // namespace sinkmesh
