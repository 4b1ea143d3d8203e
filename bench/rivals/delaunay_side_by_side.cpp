// SPDX-License-Identifier: MIT
//
// Delaunay triangulation in space: ours, CGAL's, and TetGen's where its library is installed, in turn. Each run
// is a child process of its own, so that none finds memory that another has warmed or fragmented. Prints
// medians of user seconds and of memory, and the median of the ratios of neighbouring runs. Exit 1 if the
// number of tetrahedra differs from CGAL's on a set whose triangulation is unique.
//
//   sinkmesh_rival_delaunay [repetitions [largest [row]]]     row: the beginning of a name
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#ifdef SINKMESH_HAS_TETGEN
#include <tetgen.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/point_sets.h"
#include "bench/rivals/child_process.h"
#include "bench/rivals/user_time.h"
#include "core/triangulation.h"

namespace {

using namespace sinkmesh;
using namespace sinkmesh::bench;
using Points3 = std::vector<Point3>;

// Each builds the triangulation from the points as a program has them, and returns how to count the finite
// tetrahedra. Neither that nor taking it down is measured: the processes exit without.
using Count = std::function<std::size_t()>;

Count build_ours(const Points3& points) {
  const auto* triangulation = new Triangulation3(points);
  return [=] { return triangulation->num_solid(); };
}

Count build_cgal(const Points3& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> converted;
  converted.reserve(points.size());
  for (const auto& [x, y, z] : points) converted.emplace_back(x, y, z);
  const auto* triangulation = new CGAL::Delaunay_triangulation_3<Kernel>(converted.begin(), converted.end());
  return [=] { return triangulation->number_of_finite_cells(); };
}

#ifdef SINKMESH_HAS_TETGEN
Count build_tetgen(const Points3& points) {
  auto* in = new tetgenio;
  auto* out = new tetgenio;
  in->numberofpoints = static_cast<int>(points.size());
  in->pointlist = new double[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) std::copy_n(points[i].data(), 3, in->pointlist + 3 * i);
  char switches[] = "Q";  // quiet; all else by default
  tetrahedralize(switches, in, out);
  return [=] { return static_cast<std::size_t>(out->numberoftetrahedra); };
}
#endif

struct Runs {
  std::vector<double> seconds;
  std::vector<double> bytes_per_tetrahedron;
  std::size_t tetrahedra = 0;
  bool failed = false;

  // Returns the user seconds, 0 if the process failed.
  double add(Count (*build)(const Points3&), const Points3& points) {
    // A rival that needs ten minutes has lost.
    constexpr unsigned kSecondsAllowed = 600;
    const ChildResult run = measure_in_child([&] { return build(points); }, kSecondsAllowed);
    failed |= !run.succeeded;
    if (failed) return 0;
    tetrahedra = run.value;
    seconds.push_back(run.user_seconds);
    bytes_per_tetrahedron.push_back(run.peak_bytes / static_cast<double>(run.value));
    return run.user_seconds;
  }

  void print(const char* name, const std::vector<double>& ratios) const {
    if (failed) {
      std::printf("  %-6s failed\n", name);
      return;
    }
    std::printf("  %-6s %9zu tetrahedra %8.3f s  %5.0f bytes per tetrahedron", name, tetrahedra,
                median(seconds), median(bytes_per_tetrahedron));
    if (!ratios.empty()) std::printf("  ratio to CGAL %.3f", median(ratios));
    std::printf("\n");
    std::fflush(stdout);
  }
};

/// @return whether the numbers of tetrahedra agree, where they must.
bool compare(const char* name, const Points3& points, int repetitions, bool is_unique) {
  Runs ours;
  Runs cgal;
  std::vector<double> ours_to_cgal;
#ifdef SINKMESH_HAS_TETGEN
  Runs tetgen;
  std::vector<double> tetgen_to_cgal;
#endif
  for (int i = 0; i < repetitions; ++i) {
    const double ours_seconds = ours.add(build_ours, points);
    const double cgal_seconds = cgal.add(build_cgal, points);
    ours_to_cgal.push_back(ours_seconds / cgal_seconds);
#ifdef SINKMESH_HAS_TETGEN
    if (!tetgen.failed) tetgen_to_cgal.push_back(tetgen.add(build_tetgen, points) / cgal_seconds);
#endif
  }
  const bool differs = ours.failed || cgal.failed || (is_unique && ours.tetrahedra != cgal.tetrahedra);
  std::printf("%s, %zu points%s\n", name, points.size(), differs ? ": TETRAHEDRA DIFFER" : "");
  ours.print("ours", ours_to_cgal);
  cgal.print("CGAL", {});
#ifdef SINKMESH_HAS_TETGEN
  tetgen.print("TetGen", tetgen_to_cgal);
#endif
  return !differs;
}

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 5;
  const std::size_t largest = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000000;
  const std::string_view row = argc > 3 ? argv[3] : "";
  bool agree = true;
  const auto run = [&](std::string_view name, std::size_t n, auto make_points, bool is_unique = true) {
    if (n > largest || !name.starts_with(row)) return;
    agree &= compare(name.data(), make_points(n), repetitions, is_unique);
  };
  run("uniform cube", 10000, uniform_cube);
  run("uniform cube", 100000, uniform_cube);
  run("uniform cube", 1000000, uniform_cube);
  // Doubles near a sphere, a paraboloid or a cylinder are in general position: only the grid has ties.
  run("unit sphere, rounded", 100000, rounded_sphere);
  run("paraboloid", 100000, paraboloid);
  run("open cylinder", 100000, open_cylinder);
  run("grid, shuffled", 125000, cubic_grid, false);
  return agree ? 0 : 1;
}
