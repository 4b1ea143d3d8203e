// SPDX-License-Identifier: MIT
//
// What is the same in all suites of stress_refine: a case is a surface and options.
#pragma once

#include <string>

#include "test/stress/refine/run_options.h"
#include "test/stress/refine/runs.h"
#include "test/stress/refine/surface_case.h"
#include "test/stress/refine/surfaces.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

template <int Dim>
class SurfaceSuite : public Suite {
 public:
  /// @param name        without the dimension.
  /// @param is_stopped  whether runs are ended from outside.
  SurfaceSuite(std::string name, bool is_stopped)
      : name_(std::move(name) + std::to_string(Dim) + "d"), is_stopped_(is_stopped) {}

  std::string name() const override { return name_; }

  void generate(Random& random, Case& c) override {
    set_surface<Dim>(c, random_surface<Dim>(random));
    draw_options(random, Dim, c);
    draw_more(random, c);
  }

  bool accepts(const Case& c) const override { return has_valid_options(c) && has_meshable_surface<Dim>(c); }

  std::vector<NamedCounter> counters() const override { return run_counters(is_stopped_); }

 private:
  /// The settings that only this suite has.
  virtual void draw_more(Random& random, Case& c) = 0;

  std::string name_;
  bool is_stopped_;
};

}  // namespace sinkmesh::stress
