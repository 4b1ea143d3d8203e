// SPDX-License-Identifier: MIT
//
// Two engines, one complex, on real surfaces and point sets: the project's own models, and a larger collection
// where there is one.
#include <gtest/gtest.h>

#include <optional>

#include "core/triangulation.h"
#include "test/support/complexes.h"
#include "test/support/data_files.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

using namespace test;

/// Whether the points span the space: otherwise both engines refuse them.
template <int Dim>
bool engines_agree(const std::vector<Point<Dim>>& points) {
  std::optional<Triangulation<Dim>> star;
  try {
    star.emplace(points, Engine::star);
  } catch (const DegenerateInput&) {
    EXPECT_THROW(Triangulation<Dim>(points, Engine::flips), DegenerateInput);
    return false;
  }
  const auto report = star->validate();
  EXPECT_TRUE(report.ok()) << report;
  const std::uint64_t hash = star->hash();
  const auto duplicates = star->duplicates().size();
  const auto sets = simplex_sets(star->complex());
  star.reset();

  const Triangulation<Dim> flips(points, Engine::flips);
  EXPECT_EQ(flips.hash(), hash);
  EXPECT_TRUE(simplex_sets(flips.complex()) == sets);
  EXPECT_EQ(flips.duplicates().size(), duplicates);
  return true;
}

/// Runs over all files of a folder, and says how many of them gave a triangulation.
int count_agreeing(const std::filesystem::path& folder) {
  int count = 0;
  for (const auto& file : data_files(folder)) {
    SCOPED_TRACE(file);
    std::vector<Point3> points;
    try {
      points = read_points<3>(file.string());
    } catch (const InputError&) {
      continue;  // the reader's subject
    }
    try {
      count += engines_agree<3>(points) ? 1 : 0;
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  return count;
}

TEST(Corpus, EnginesAgreeOnTheModelsOfThePaper) { EXPECT_EQ(count_agreeing(SINKMESH_TEST_MODELS), 4); }

TEST(Corpus, EnginesAgreeOnThePointsOfTheMapOfThePaper) {
  EXPECT_TRUE(engines_agree<2>(read_points<2>(std::string(SINKMESH_TEST_MODELS) + "/usa.poly")));
}

TEST(Corpus, EnginesAgreeOnRealSurfaces) {
  if (!has_collection()) GTEST_SKIP() << "no folder " << collection();
  EXPECT_GE(count_agreeing(collection() / "real"), 10);
}

TEST(Corpus, EnginesAgreeOnRealPoints) {
  if (!has_collection()) GTEST_SKIP() << "no folder " << collection();
  EXPECT_GE(count_agreeing(collection() / "real/points"), 3);
}

TEST(Corpus, EnginesAgreeOnTheNastyFiles) {
  if (!has_collection()) GTEST_SKIP() << "no folder " << collection();
  EXPECT_GE(count_agreeing(collection() / "real/nasty"), 20);
}

}  // namespace
}  // namespace sinkmesh
