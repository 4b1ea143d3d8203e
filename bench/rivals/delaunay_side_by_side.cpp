// SPDX-License-Identifier: MIT
//
// Delaunay triangulation in space and in the plane: ours, CGAL's, and in space TetGen's where its library is
// installed, in turn. Each run is a child process of its own, so that none finds memory that another has
// warmed or fragmented. Prints medians of user seconds and of memory, and the median of the ratios of
// neighbouring runs. Exit 1 if the number of simplices differs from CGAL's on a set whose triangulation is
// unique.
//
//   sinkmesh_rival_delaunay [repetitions [largest [row]]]     row: the beginning of a name
#include <CGAL/Delaunay_triangulation_2.h>
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
template <int Dim>
using Points = std::vector<Point<Dim>>;

// Each builds the triangulation from the points as a program has them, and returns how to count the finite
// simplices. Neither that nor taking it down is measured: the processes exit without.
using Count = std::function<std::size_t()>;

template <int Dim>
Count build_ours(const Points<Dim>& points) {
  const auto* triangulation = new Triangulation<Dim>(points);
  return [=] { return triangulation->num_solid(); };
}

template <int Dim>
Count build_cgal(const Points<Dim>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if constexpr (Dim == 2) {
    std::vector<Kernel::Point_2> converted;
    converted.reserve(points.size());
    for (const auto& [x, y] : points) converted.emplace_back(x, y);
    const auto* triangulation = new CGAL::Delaunay_triangulation_2<Kernel>(converted.begin(), converted.end());
    return [=] { return triangulation->number_of_faces(); };
  } else {
    std::vector<Kernel::Point_3> converted;
    converted.reserve(points.size());
    for (const auto& [x, y, z] : points) converted.emplace_back(x, y, z);
    const auto* triangulation = new CGAL::Delaunay_triangulation_3<Kernel>(converted.begin(), converted.end());
    return [=] { return triangulation->number_of_finite_cells(); };
  }
}

#ifdef SINKMESH_HAS_TETGEN
Count build_tetgen(const Points<3>& points) {
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
  std::vector<double> bytes_per_simplex;
  std::size_t simplices = 0;
  bool failed = false;

  // Returns the user seconds, 0 if the process failed.
  template <int Dim>
  double add(Count (*build)(const Points<Dim>&), const Points<Dim>& points) {
    // A rival that needs ten minutes has lost.
    constexpr unsigned kSecondsAllowed = 600;
    const ChildResult run = measure_in_child([&] { return build(points); }, kSecondsAllowed);
    failed |= !run.succeeded;
    if (failed) return 0;
    simplices = run.value;
    seconds.push_back(run.user_seconds);
    bytes_per_simplex.push_back(run.peak_bytes / static_cast<double>(run.value));
    return run.user_seconds;
  }

  void print(const char* name, const std::vector<double>& ratios) const {
    if (failed) {
      std::printf("  %-6s failed\n", name);
      return;
    }
    std::printf("  %-6s %9zu simplices %8.3f s  %5.0f bytes per simplex", name, simplices, median(seconds),
                median(bytes_per_simplex));
    if (!ratios.empty()) std::printf("  ratio to CGAL %.3f", median(ratios));
    std::printf("\n");
    std::fflush(stdout);
  }
};

/// @return whether the numbers of simplices agree, where they must.
template <int Dim>
bool compare(const char* name, const Points<Dim>& points, int repetitions, bool is_unique) {
  Runs ours;
  Runs cgal;
  std::vector<double> ours_to_cgal;
#ifdef SINKMESH_HAS_TETGEN
  Runs tetgen;
  std::vector<double> tetgen_to_cgal;
#endif
  for (int i = 0; i < repetitions; ++i) {
    const double ours_seconds = ours.add<Dim>(build_ours<Dim>, points);
    const double cgal_seconds = cgal.add<Dim>(build_cgal<Dim>, points);
    ours_to_cgal.push_back(ours_seconds / cgal_seconds);
#ifdef SINKMESH_HAS_TETGEN
    if constexpr (Dim == 3) {
      if (!tetgen.failed) tetgen_to_cgal.push_back(tetgen.add<3>(build_tetgen, points) / cgal_seconds);
    }
#endif
  }
  const bool differs = ours.failed || cgal.failed || (is_unique && ours.simplices != cgal.simplices);
  std::printf("%s, %zu points%s\n", name, points.size(), differs ? ": SIMPLICES DIFFER" : "");
  ours.print("ours", ours_to_cgal);
  cgal.print("CGAL", {});
#ifdef SINKMESH_HAS_TETGEN
  if constexpr (Dim == 3) tetgen.print("TetGen", tetgen_to_cgal);
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
    const auto points = make_points(n);
    agree &= compare<std::tuple_size_v<typename decltype(points)::value_type>>(name.data(), points, repetitions,
                                                                               is_unique);
  };
  run("uniform cube", 10000, uniform_cube);
  run("uniform cube", 100000, uniform_cube);
  run("uniform cube", 1000000, uniform_cube);
  // Doubles near a sphere, a paraboloid or a cylinder are in general position: only the grid has ties.
  run("unit sphere, rounded", 100000, rounded_sphere);
  run("paraboloid", 100000, paraboloid);
  run("open cylinder", 100000, open_cylinder);
  run("grid, shuffled", 125000, cubic_grid, false);
  run("plane, uniform square", 1000000, uniform_square);
  run("plane, rounded circle", 1000000, rounded_circle);
  run("plane, grid, shuffled", 1000000, square_grid, false);
  return agree ? 0 : 1;
}
