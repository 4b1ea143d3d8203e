// SPDX-License-Identifier: MIT
#include "test/stress/refine/run_options.h"
#include "test/stress/refine/runs.h"
#include "test/stress/refine/suites.h"
#include "test/stress/refine/surface_case.h"
#include "test/stress/refine/surfaces.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

template <int Dim>
class MeshSuite : public Suite {
 public:
  std::string name() const override { return "mesh" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    set_surface<Dim>(c, random_surface<Dim>(random));
    draw_options(random, Dim, c);
  }

  bool accepts(const Case& c) const override { return has_valid_options(c) && has_meshable_surface<Dim>(c); }

  std::string check(const Case& c, Counters& counters) override {
    const Surface<Dim> surface = tagged_surface_of<Dim>(c);
    RefineOptions options = options_of(c);
    options.max_vertices = most_vertices<Dim>(surface);
    const std::string first = run(surface, options, counters);
    Counters again;
    expect_equal("repetition", run(surface, options, again), first);
    return "";
  }

  std::vector<NamedCounter> counters() const override { return run_counters(false); }

 private:
  static std::string run(const Surface<Dim>& surface, const RefineOptions& options, Counters& counters) {
    CheckedRun<Dim> run(surface, counters);
    if (run.find_domain(options)) run.refine(options);
    return run.summary();
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_mesh_suite() {
  return std::make_unique<MeshSuite<Dim>>();
}
template std::unique_ptr<Suite> make_mesh_suite<2>();
template std::unique_ptr<Suite> make_mesh_suite<3>();

}  // namespace sinkmesh::stress
