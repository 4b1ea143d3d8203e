// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "test/stress/refine/run_options.h"
#include "test/stress/refine/runs.h"
#include "test/stress/refine/suites.h"
#include "test/stress/refine/surface_case.h"
#include "test/stress/refine/surfaces.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

/// Corners of facets, too, so that normals point anywhere.
template <int Dim>
Surface<Dim> in_another_order(const Surface<Dim>& s, Random& random) {
  std::vector<std::uint32_t> place(s.points.size());
  std::iota(place.begin(), place.end(), 0U);
  std::shuffle(place.begin(), place.end(), random);
  Surface<Dim> result = s;
  for (std::size_t i = 0; i < place.size(); ++i) result.points[place[i]] = s.points[i];
  for (auto& facet : result.facets) {
    for (std::uint32_t& p : facet) p = place[p];
    std::shuffle(facet.begin(), facet.end(), random);
  }
  std::shuffle(result.facets.begin(), result.facets.end(), random);
  return result;
}

template <int Dim>
class NumberingSuite : public Suite {
 public:
  std::string name() const override { return "numbering" + std::to_string(Dim) + "d"; }

  void generate(Random& random, Case& c) override {
    set_surface<Dim>(c, random_surface<Dim>(random));
    draw_options(random, Dim, c);
    c.set("tags", 0U);  // they would go with the facets
    c.set("numbering", random());
  }

  bool accepts(const Case& c) const override { return has_valid_options(c) && has_meshable_surface<Dim>(c); }

  std::string check(const Case& c, Counters& counters) override {
    const Surface<Dim> surface = tagged_surface_of<Dim>(c);
    RefineOptions options = options_of(c);
    options.max_vertices = most_vertices<Dim>(surface);
    CheckedRun<Dim> one(surface, counters);
    const bool has_domain = one.find_domain(options);
    if (has_domain) one.refine(options);
    Random random(c.number_setting("numbering"));
    Counters again;
    CheckedRun<Dim> other(in_another_order<Dim>(surface, random), again, false);
    expect_equal("domain in another order", other.find_domain(options), has_domain);
    if (!has_domain) return "";
    other.refine(options);
    ++counters.comparisons;
    expect_equal("hash in another order", other.hash(), one.hash());
    return "";
  }

  std::vector<NamedCounter> counters() const override { return run_counters(false); }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_numbering_suite() {
  return std::make_unique<NumberingSuite<Dim>>();
}
template std::unique_ptr<Suite> make_numbering_suite<2>();
template std::unique_ptr<Suite> make_numbering_suite<3>();

}  // namespace sinkmesh::stress
