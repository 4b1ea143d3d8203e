// SPDX-License-Identifier: MIT
#include "test/stress/refine/suites.h"
#include "test/stress/refine/surface_suite.h"
#include "test/stress/text.h"
#include "test/support/surfaces.h"

namespace sinkmesh::stress {
namespace {

template <int Dim>
class NumberingSuite : public SurfaceSuite<Dim> {
 public:
  NumberingSuite() : SurfaceSuite<Dim>("numbering", false) {}

  std::string check(const Case& c, Counters& counters) override {
    const Surface<Dim> surface = tagged_surface_of<Dim>(c);
    RefineOptions options = options_of(c);
    options.max_vertices = most_vertices<Dim>(surface);
    CheckedRun<Dim> one(surface, counters);
    const bool has_domain = one.find_domain(options);
    if (has_domain) {
      one.refine(options);
      one.improve(options);
    }
    Random random(c.number_setting("numbering"));
    Counters again;
    CheckedRun<Dim> other(test::in_another_order(surface, random), again, false);
    expect_equal("domain in another order", other.find_domain(options), has_domain);
    if (!has_domain) return "";
    other.refine(options);
    other.improve(options);
    ++counters.comparisons;
    expect_equal("hash in another order", other.hash(), one.hash());
    return "";
  }

 private:
  void draw_more(Random& random, Case& c) override {
    c.set("tags", 0U);  // they would go with the facets
    c.set("numbering", random());
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_numbering_suite() {
  return std::make_unique<NumberingSuite<Dim>>();
}
template std::unique_ptr<Suite> make_numbering_suite<2>();
template std::unique_ptr<Suite> make_numbering_suite<3>();

}  // namespace sinkmesh::stress
