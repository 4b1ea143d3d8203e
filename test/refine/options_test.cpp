// SPDX-License-Identifier: MIT
//
// What options are refused, and how the parts of a result are named and counted.
#include "refine/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "predicates/error.h"

namespace sinkmesh {
namespace {

TEST(Options, AnglesAndFlatnessHaveARange) {
  for (const double angle : {0.0, -1.0, 60.1, HUGE_VAL, std::nan("")}) {
    RefineOptions options;
    options.boundary.small_angle = angle;
    EXPECT_THROW(require_valid(options), InputError) << angle;
  }
  for (const double flat : {-1e-9, 1.0, HUGE_VAL, std::nan("")}) {
    RefineOptions options;
    options.boundary.flat = flat;
    EXPECT_THROW(require_valid(options), InputError) << flat;
  }
  RefineOptions options;
  EXPECT_NO_THROW(require_valid(options));
  options.boundary = {BoundaryMode::refine, 60, 0};
  EXPECT_NO_THROW(require_valid(options));
}

TEST(Options, ReachIsAtLeastOne) {
  for (const double reach : {0.0, -2.0, std::nextafter(1.0, 0.0), -HUGE_VAL, std::nan("")}) {
    for (const Insert insert : {Insert::off_sink, Insert::sink, Insert::circumcenter}) {
      RefineOptions options;
      options.insert = insert;
      options.reach = reach;
      EXPECT_THROW(require_valid(options), InputError) << reach;
    }
  }
  for (const double reach : {1.0, 1.3, 1e9}) {
    RefineOptions options;
    options.reach = reach;
    EXPECT_NO_THROW(require_valid(options)) << reach;
  }
}

TEST(Options, LiteralRoundsAreForCentersInRounds) {
  for (const Insert insert : {Insert::off_sink, Insert::sink, Insert::circumcenter}) {
    for (const Schedule schedule : {Schedule::incremental, Schedule::block, Schedule::parallel}) {
      RefineOptions options;
      options.insert = insert;
      options.schedule = schedule;
      EXPECT_NO_THROW(require_valid(options));
      options.literal = true;
      if (insert == Insert::off_sink || schedule == Schedule::incremental) {
        EXPECT_THROW(require_valid(options), InputError) << name(insert) << ' ' << name(schedule);
      } else {
        EXPECT_NO_THROW(require_valid(options)) << name(insert) << ' ' << name(schedule);
      }
    }
  }
}

TEST(Options, ReasonsAreCountedUnderNamesOfTheirOwn) {
  const Remaining remaining{1, 2, 4, 8, 16, 32, 64};
  std::size_t total = 0;
  std::set<std::string> names;
  for (const LeftoverReason reason : kLeftoverReasons) {
    total += remaining.count(reason);
    names.insert(name(reason));
  }
  EXPECT_EQ(total, 127U);
  EXPECT_EQ(remaining.total(), 127U);
  EXPECT_EQ(names.size(), kLeftoverReasons.size());
  EXPECT_EQ(remaining.count(LeftoverReason::small_angle), 32U);
  EXPECT_STREQ(name(Leftover<3>::Reason::small_angle), "small_angle");
}

TEST(Options, PointsOrdersAndSchedulesAreNamedAsInTheProgram) {
  EXPECT_STREQ(name(Insert::sink), "sink");
  EXPECT_STREQ(name(Insert::circumcenter), "circumcenter");
  EXPECT_STREQ(name(Insert::off_sink), "offsink");
  EXPECT_STREQ(name(Order::ratio), "ratio");
  EXPECT_STREQ(name(Order::shortest), "shortest");
  EXPECT_STREQ(name(Order::smallest), "smallest");
  EXPECT_STREQ(name(Schedule::incremental), "incremental");
  EXPECT_STREQ(name(Schedule::block), "block");
  EXPECT_STREQ(name(Schedule::parallel), "parallel");
}

TEST(Options, ModesAndFeaturesAreNamedAsInTheProgram) {
  EXPECT_STREQ(name(BoundaryMode::automatic), "auto");
  EXPECT_STREQ(name(BoundaryMode::fixed), "fixed");
  EXPECT_STREQ(name(BoundaryMode::refine), "refine");
  EXPECT_STREQ(name(BoundaryFeature::Kind::none), "none");
  EXPECT_STREQ(name(BoundaryFeature::Kind::corner), "corner");
  EXPECT_STREQ(name(BoundaryFeature::Kind::segment), "segment");
  EXPECT_STREQ(name(BoundaryFeature::Kind::patch), "patch");
}

}  // namespace
}  // namespace sinkmesh
