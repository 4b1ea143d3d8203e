// SPDX-License-Identifier: MIT
//
// What the suites of stress_delaunay have in common.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "core/triangulation.h"
#include "test/stress/case.h"
#include "test/stress/suite.h"
#include "test/stress/text.h"
#include "test/support/simplex_sets.h"

namespace sinkmesh::stress {

using test::triangulate;

inline const char* name_of(Engine engine) { return engine == Engine::star ? "star" : "flips"; }

template <int Dim>
bool are_points(const Case& c) {
  return std::all_of(c.rows.begin(), c.rows.end(), [](const auto& row) {
    return row.size() == Dim && std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
  });
}

template <int Dim>
bool are_distinct(std::vector<Point<Dim>> points) {
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) == points.end();
}

/// Each once, in random order.
template <int Dim>
void make_distinct(std::vector<Point<Dim>>& points, Random& random) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::shuffle(points.begin(), points.end(), random);
}

template <int Dim>
void expect_valid(const Triangulation<Dim>& triangulation, const std::string& what) {
  const ValidationReport report = triangulation.validate();
  if (report.ok()) return;
  std::ostringstream out;
  const auto& first = report.violations.front();
  out << "invariant " << first.invariant << ": " << what << ": " << first.message << ", and "
      << report.violations.size() - 1 << " more";
  throw CheckFailed(out.str());
}

/// Equal complexes over the same ids, ghosts included.
template <std::size_t N>
void expect_same_sets(const std::string& what, const std::vector<test::IdSet<N>>& found,
                      const std::vector<test::IdSet<N>>& expected) {
  if (found == expected) return;
  std::vector<test::IdSet<N>> missing;
  std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                      std::back_inserter(missing));
  std::ostringstream out;
  out << "complex: " << what << ": found " << found.size() << " simplices and ghosts, expected "
      << expected.size() << ", of which " << missing.size() << " are missing";
  if (!missing.empty()) {
    out << ", the first at the points";
    for (const std::uint32_t id : missing.front()) out << ' ' << static_cast<std::int32_t>(id);
  }
  throw CheckFailed(out.str());
}

}  // namespace sinkmesh::stress
