// SPDX-License-Identifier: MIT
//
// Where features meet, on two patches that share a segment.
#include "refine/boundary_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/triangulation.h"

namespace sinkmesh {
namespace {

using Kind = Feature::Kind;

/// A wedge: two patches that meet at a given angle along a segment of the x axis, from 0 to 1, and a vertex on
/// each of them, at the same distance from that segment. Coordinates are gated as they are.
class Wedge {
 public:
  static constexpr double kRadius = 0.02;

  Wedge(double degrees, double p_along, double q_along)
      : triangulation_(points(degrees, p_along, q_along)), features_(triangulation_.complex()) {
    for (const std::uint32_t v : {0, 1, 2, 3}) features_.set_corner(Vertex(v));
    const std::uint32_t axis = features_.add_segment(Vertex(1), Vertex(0));
    const std::vector<std::vector<Vertex>> corners = {{Vertex(0), Vertex(1), Vertex(2)},
                                                      {Vertex(0), Vertex(1), Vertex(3)}};
    for (const auto& c : corners) {
      const auto plane = Plane::through(point(c[0]), point(c[1]), point(c[2]));
      features_.add_patch({0, plane, {axis}, c, true});
    }
    features_.set_vertex(p(), {{Kind::patch, 0}});
    features_.set_vertex(q(), {{Kind::patch, 1}});
  }

  static Vertex p() { return Vertex(4); }
  static Vertex q() { return Vertex(5); }
  const Point3& point(Vertex v) const { return triangulation_.complex().point(v); }
  const BoundaryFeatures<3>& features() const { return features_; }
  double length() const {
    const Point3& a = point(p());
    const Point3& b = point(q());
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

 private:
  static std::vector<Point3> points(double degrees, double p_along, double q_along) {
    const double half = degrees / 360 * std::numbers::pi;
    const auto on = [&](double along, double radius, int side) {
      return Point3{along, radius * std::cos(half), side * radius * std::sin(half)};
    };
    return {
        {0, 0, 0}, {1, 0, 0}, on(0.5, 1, 1), on(0.5, 1, -1), on(p_along, kRadius, 1), on(q_along, kRadius, -1)};
  }

  Triangulation3 triangulation_;
  BoundaryFeatures<3> features_;
};

// From the nearer end, in units of the distance from the segment.
TEST(BoundaryFeatures, ARungIsShortForItsDistanceFromWhatTheFeaturesShare) {
  for (const double degrees : {5.0, 20.0, 50.0, 90.0, 170.0}) {
    SCOPED_TRACE(degrees);
    const Wedge wedge(degrees, 0.4, 0.4);
    for (const double factor : {0.99, 1.01}) {
      // |pq| = factor lambda radius
      const double lambda = wedge.length() / (factor * Wedge::kRadius);
      for (const auto& [a, b] : {std::pair(Wedge::p(), Wedge::q()), std::pair(Wedge::q(), Wedge::p())}) {
        const auto rung = wedge.features().rung(a, b, lambda);
        ASSERT_EQ(rung.has_value(), factor < 1 || degrees < 60);  // at an acute angle the corner may be meant
        if (!rung) continue;
        EXPECT_EQ(rung->first, (Feature{Kind::patch, a == Wedge::p() ? 0U : 1U}));
        EXPECT_EQ(rung->second, (Feature{Kind::patch, a == Wedge::p() ? 1U : 0U}));
        EXPECT_EQ(rung->common.kind, factor < 1 ? Kind::segment : Kind::corner);
        const double reach = factor < 1 ? Wedge::kRadius : std::hypot(0.4, Wedge::kRadius);
        EXPECT_NEAR(std::sqrt(rung->reach2), reach, 1e-12);
      }
    }
  }
}

// Where the edge is long for its distance from the segment, but short for that from a corner.
TEST(BoundaryFeatures, TheNearestCornerTakesThePlaceOfASegmentAtAnAcuteAngle) {
  for (const double degrees : {10.0, 30.0, 50.0, 59.0, 61.0, 70.0, 89.0, 91.0, 130.0}) {
    SCOPED_TRACE(degrees);
    for (const double along : {0.1, 0.9}) {
      for (const double apart : {0.0, 0.004}) {
        const Wedge wedge(degrees, along, along + apart);
        const double lambda = 0.8 * wedge.length() / Wedge::kRadius;
        const double reach = std::hypot(along < 0.5 ? along : 1 - along - apart, Wedge::kRadius);
        ASSERT_LT(wedge.length(), lambda * reach);
        for (const auto& [a, b] : {std::pair(Wedge::p(), Wedge::q()), std::pair(Wedge::q(), Wedge::p())}) {
          const auto rung = wedge.features().rung(a, b, lambda);
          ASSERT_EQ(rung.has_value(), degrees < 60);
          if (!rung) continue;
          EXPECT_EQ(rung->common, (Feature{Kind::corner, along < 0.5 ? 0U : 1U}));
          EXPECT_NEAR(std::sqrt(rung->reach2), reach, 1e-12);
        }
      }
    }
    const Wedge wedge(degrees, 0.1, 0.1);
    const double corner = std::hypot(0.1, Wedge::kRadius);
    EXPECT_FALSE(wedge.features().rung(Wedge::p(), Wedge::q(), 0.99 * wedge.length() / corner));
  }
}

TEST(BoundaryFeatures, NoRungWithinOneFeatureOrFromAnInnerVertex) {
  const Wedge wedge(20, 0.4, 0.4);
  const auto& features = wedge.features();
  EXPECT_FALSE(features.rung(Wedge::p(), Vertex(2), 1e9, BoundaryFeatures<3>::Ends::any));  // one patch
  EXPECT_TRUE(features.rung(Wedge::p(), Vertex(3), 1e9, BoundaryFeatures<3>::Ends::any));
  EXPECT_FALSE(features.rung(Wedge::p(), Vertex(3), 1e9));  // a corner, which is given
  EXPECT_FALSE(features.rung(Wedge::p(), Vertex(0), 1e9, BoundaryFeatures<3>::Ends::any));
  EXPECT_TRUE(features.is_on_patch(Vertex(0), 1));
  EXPECT_TRUE(features.is_on_segment(Vertex(1), 0));
  EXPECT_FALSE(features.is_on_segment(Vertex(2), 0));
  EXPECT_FALSE(features.is_on_patch(Vertex(2), 1));
  EXPECT_FALSE(features.is_on_boundary(Vertex(100)));
  EXPECT_TRUE(features.patches_at(Vertex(100)).empty());
  EXPECT_EQ(features.patches_at(Vertex(1)), (std::vector<std::uint32_t>{0, 1}));
}

TEST(BoundaryFeatures, DistanceFromASegmentIsThatFromItsNearestPoint) {
  const Wedge wedge(20, 0.4, 0.4);
  const Feature axis{Kind::segment, 0};
  EXPECT_NEAR(wedge.features().distance2({0.5, 3, 4}, axis), 25, 1e-12);
  EXPECT_NEAR(wedge.features().distance2({-3, 4, 0}, axis), 25, 1e-12);
  EXPECT_NEAR(wedge.features().distance2({4, 0, 4}, axis), 25, 1e-12);
  EXPECT_NEAR(wedge.features().distance2({4, 0, 4}, {Kind::corner, 0}), 32, 1e-12);
}

// Any order of corners: the same plane, to the last bit, and counterclockwise in the projection.
TEST(BoundaryFeatures, APlaneDependsOnTheCyclicOrderOnly) {
  const std::vector<Point3> corners = {{0.3, 0.1, 0.7}, {0.9, 0.2, 0.4}, {0.5, 0.8, 0.1}};
  for (int axis = 0; axis < 3; ++axis) {
    const auto turned = [&](const Point3& p) { return Point3{p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
    const Point3 a = turned(corners[0]);
    const Point3 b = turned(corners[1]);
    const Point3 c = turned(corners[2]);
    const Plane plane = Plane::through(a, b, c);
    const Plane back = Plane::through(c, b, a);
    for (const Plane& same : {Plane::through(b, c, a), Plane::through(c, a, b)}) {
      EXPECT_EQ(same.origin, plane.origin);
      EXPECT_EQ(same.normal, plane.normal);
      EXPECT_EQ(same.kept, plane.kept);
      EXPECT_EQ(same.dropped, plane.dropped);
    }
    EXPECT_EQ(back.kept, (std::array{plane.kept[1], plane.kept[0]}));
    double length2 = 0;
    for (const double x : plane.normal) length2 += x * x;
    EXPECT_NEAR(length2, 1, 1e-15);
    EXPECT_GE(std::abs(plane.normal[plane.dropped]), std::sqrt(1.0 / 3) - 1e-15);
    for (const Point3& p : {a, b, c}) {
      EXPECT_NEAR(plane.distance(p), 0, 1e-15);
      const Point3 lifted = plane.lift(plane.project(p));
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(lifted[k], p[k], 1e-15);
    }
    const Point3 beside{a[0] + plane.normal[0], a[1] + plane.normal[1], a[2] + plane.normal[2]};
    EXPECT_NEAR(plane.distance(beside), 1, 1e-14);
  }
}

}  // namespace
}  // namespace sinkmesh
