// SPDX-License-Identifier: MIT
//
// Predicates beside the plain rounded expression, which is the floor, and CGAL's filtered predicates, in turn
// and in one process: median nanoseconds of user time per call. Exit 1 if a sign differs from CGAL's.
//
//   sinkmesh_rival_predicates [repetitions]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "bench/predicate_inputs.h"
#include "bench/rivals/user_time.h"
#include "predicates/verdict.h"

namespace {

using namespace sinkmesh;
using namespace sinkmesh::bench;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <std::size_t N>
using CgalPoints = std::array<Kernel::Point_3, N>;

int cgal_sign(detail::Orientation<3>, const CgalPoints<4>& p) {
  return CGAL::orientation(p[0], p[1], p[2], p[3]);
}
int cgal_sign(detail::InSphere<3>, const CgalPoints<5>& p) {
  return CGAL::side_of_oriented_sphere(p[0], p[1], p[2], p[3], p[4]);
}
int cgal_sign(detail::Diametral<3>, const CgalPoints<4>& p) {
  return -CGAL::side_of_bounded_sphere(p[0], p[1], p[2], p[3]);
}

struct Row {
  const char* name;
  Input input;
};

template <class P>
class Comparison {
 public:
  explicit Comparison(Input input) : set_(input) {
    for (const Arguments<P>& points : set_.arguments()) {
      CgalPoints<P::kPoints> converted;
      for (std::size_t k = 0; k < P::kPoints; ++k) converted[k] = {points[k][0], points[k][1], points[k][2]};
      cgal_.push_back(converted);
    }
  }

  int plain(std::size_t i) const { return P::value(detail::rounded_vectors<P>(set_.points(i))) > 0 ? 1 : 0; }
  int set_wide(std::size_t i) const { return set_.predicates().template verdict<P>(set_.points(i)).sign; }
  int raw(std::size_t i) const { return detail::decide<P>(set_.points(i)).sign; }
  int cgal(std::size_t i) const { return cgal_sign(P{}, cgal_[i]); }

  bool signs_agree() const {
    bool agree = true;
    for (std::size_t i = 0; i < cgal_.size(); ++i) {
      const int expected = cgal(i);
      agree &= set_wide(i) == expected && raw(i) == expected;
    }
    return agree;
  }

 private:
  InputSet<P> set_;
  std::vector<CgalPoints<P::kPoints>> cgal_;
};

/// ns per call.
template <class F>
double time_calls(F&& f) {
  std::size_t calls = 0;
  const double start = user_seconds();
  double seconds = 0;
  // getrusage() may tick as slowly as every 4 ms.
  while (seconds < 0.06) {
    for (int pass = 0; pass < 8; ++pass) {
      for (std::size_t i = 0; i < kInputSize; ++i) {
        const int sign = f(i);
        // Keeps the call, and keeps the loop from being vectorised.
        asm volatile("" : : "r"(sign) : "memory");
      }
    }
    calls += 8 * kInputSize;
    seconds = user_seconds() - start;
  }
  return 1e9 * seconds / static_cast<double>(calls);
}

template <class P>
bool compare(const char* name, std::initializer_list<Row> rows, int repetitions) {
  bool agree = true;
  for (const Row& row : rows) {
    const Comparison<P> c(row.input);
    std::vector<double> plain, set_wide, raw, cgal, to_plain, to_cgal;
    for (int i = 0; i < repetitions; ++i) {
      plain.push_back(time_calls([&](std::size_t k) { return c.plain(k); }));
      set_wide.push_back(time_calls([&](std::size_t k) { return c.set_wide(k); }));
      raw.push_back(time_calls([&](std::size_t k) { return c.raw(k); }));
      cgal.push_back(time_calls([&](std::size_t k) { return c.cgal(k); }));
      to_plain.push_back(set_wide.back() / plain.back());
      to_cgal.push_back(set_wide.back() / cgal.back());
    }
    const bool row_agrees = c.signs_agree();
    std::printf(
        "%-9s %-28s plain %6.2f  set-wide %7.2f  raw %7.2f  CGAL %8.2f  set-wide/plain %6.2f  set-wide/CGAL "
        "%6.3f%s\n",
        name, row.name, median(plain), median(set_wide), median(raw), median(cgal), median(to_plain),
        median(to_cgal), row_agrees ? "" : "  SIGNS DIFFER");
    std::fflush(stdout);
    agree &= row_agrees;
  }
  return agree;
}

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 9;
  bool agree = true;
  agree &= compare<detail::Orientation<3>>("orient3d",
                                           {{"random", Input::random},
                                            {"coplanar integer grid", Input::integer_tie},
                                            {"near-coplanar rounded", Input::rounded_tie}},
                                           repetitions);
  agree &= compare<detail::InSphere<3>>("insphere",
                                        {{"random", Input::random},
                                         {"cospherical integer boxes", Input::integer_tie},
                                         {"rounded unit sphere", Input::rounded_tie},
                                         {"0.1 i lattice cubes", Input::lattice_tie}},
                                        repetitions);
  agree &= compare<detail::Diametral<3>>("flow G",
                                         {{"random", Input::random},
                                          {"exact ties on integers", Input::integer_tie},
                                          {"exact ties, no granularity", Input::scattered_tie},
                                          {"ties of the 0.1 i lattice", Input::lattice_tie},
                                          {"rounded onto the sphere", Input::rounded_tie}},
                                         repetitions);
  return agree ? 0 : 1;
}
