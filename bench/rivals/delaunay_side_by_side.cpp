// SPDX-License-Identifier: MIT
//
// Delaunay triangulation in space, ours and CGAL's, in turn and in one process: prints user seconds and their
// ratio.
//
//   sinkmesh_rival_delaunay [points [repetitions]]
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/point_sets.h"
#include "core/triangulation.h"

namespace {

double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void compare(const char* name, const std::vector<sinkmesh::Point3>& points, int repetitions) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> cgal_points;
  for (const auto& [x, y, z] : points) cgal_points.emplace_back(x, y, z);
  std::vector<double> ours;
  std::vector<double> theirs;
  std::vector<double> ratio;
  std::size_t solid = 0;
  std::size_t cells = 0;
  for (int i = 0; i < repetitions; ++i) {
    double start = user_seconds();
    {
      const sinkmesh::Triangulation3 triangulation(points);
      ours.push_back(user_seconds() - start);
      solid = triangulation.num_solid();
    }
    start = user_seconds();
    {
      const CGAL::Delaunay_triangulation_3<Kernel> triangulation(cgal_points.begin(), cgal_points.end());
      theirs.push_back(user_seconds() - start);
      cells = triangulation.number_of_finite_cells();
    }
    ratio.push_back(ours.back() / theirs.back());
  }
  std::printf("%-24s %9zu tetrahedra (CGAL %9zu)  ours %7.3f s  CGAL %7.3f s  ratio %.3f\n", name, solid, cells,
              median(ours), median(theirs), median(ratio));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  using namespace sinkmesh::bench;
  compare("uniform cube", uniform_cube(n), repetitions);
  compare("unit sphere, rounded", rounded_sphere(n / 10), repetitions);
  compare("paraboloid", paraboloid(n / 10), repetitions);
  compare("open cylinder", open_cylinder(n / 10), repetitions);
  compare("50^3 grid, shuffled", shuffled_grid(50), repetitions);
  return 0;
}
