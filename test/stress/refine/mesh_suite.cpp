// SPDX-License-Identifier: MIT
#include "test/stress/refine/suites.h"
#include "test/stress/refine/surface_suite.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

template <int Dim>
class MeshSuite : public SurfaceSuite<Dim> {
 public:
  MeshSuite() : SurfaceSuite<Dim>("mesh", false) {}

  std::string check(const Case& c, Counters& counters) override {
    const Surface<Dim> surface = tagged_surface_of<Dim>(c);
    RefineOptions options = options_of(c);
    options.max_vertices = most_vertices<Dim>(surface);
    const std::string first = run(surface, options, counters);
    Counters again;
    expect_equal("repetition", run(surface, options, again), first);
    return "";
  }

 private:
  void draw_more(Random&, Case&) override {}

  static std::string run(const Surface<Dim>& surface, const RefineOptions& options, Counters& counters) {
    CheckedRun<Dim> run(surface, counters);
    if (run.find_domain(options)) {
      run.refine(options);
      run.improve(options);
    }
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
