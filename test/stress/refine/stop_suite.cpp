// SPDX-License-Identifier: MIT
#include <cmath>

#include "test/stress/refine/suites.h"
#include "test/stress/refine/surface_suite.h"
#include "test/stress/text.h"

namespace sinkmesh::stress {
namespace {

constexpr std::uint64_t kBytesPerUnit = 1024;

template <int Dim>
class StopSuite : public SurfaceSuite<Dim> {
 public:
  StopSuite() : SurfaceSuite<Dim>("stop", true) {}

  std::string check(const Case& c, Counters& counters) override {
    const std::string first = run(c, counters);
    Counters again;
    expect_equal("repetition", run(c, again), first);
    return "";
  }

 private:
  void draw_more(Random& random, Case& c) override {
    // Which of the limits there are; at least one.
    const auto kinds = 1 + random() % 7;
    const auto log_uniform = [&](double low, double high) {
      return static_cast<std::uint64_t>(std::exp2(test::uniform(random, low, high)));
    };
    c.set("more-vertices", (kinds & 1) != 0 ? log_uniform(0, 8) : 0U);
    c.set("kilobytes", (kinds & 2) != 0 ? log_uniform(3, 9) : 0U);
    c.set("stop-answer", (kinds & 4) == 0 ? "yes" : random() % 2 == 0 ? "cancelled" : "budget-spent");
    c.set("stop-poll", random() % 2 == 0 ? random() % 4 : log_uniform(0, 6));
    // While the surface is conformed, too, or not.
    c.set("stops-conforming", random() % 2);
  }

  static std::string run(const Case& c, Counters& counters) {
    const Surface<Dim> surface = tagged_surface_of<Dim>(c);
    RefineOptions generous = options_of(c);
    generous.max_vertices = most_vertices<Dim>(surface);
    RefineOptions limited = generous;
    if (const auto more = c.number_setting("more-vertices"); more != 0) {
      limited.max_vertices = surface.points.size() + more;
    }
    if (const auto units = c.number_setting("kilobytes"); units != 0) limited.max_bytes = units * kBytesPerUnit;
    const auto stopper = std::make_shared<Stopper>();
    stopper->polls_left = c.number_setting("stop-poll");
    const auto answer = c.setting("stop-answer");
    stopper->answer = answer == "cancelled"      ? Continue::cancelled
                      : answer == "budget-spent" ? Continue::budget_spent
                                                 : Continue::yes;
    CheckedRun<Dim> run(surface, counters);
    const bool stops_conforming = c.number_setting("stops-conforming") != 0;
    const bool has_domain = stops_conforming ? run.find_domain(limited, stopper) : run.find_domain(generous);
    if (!has_domain) return run.summary();
    run.refine(limited, stopper);
    run.improve(limited, stopper);
    // And it can go on where it stopped.
    run.refine(generous);
    run.improve(generous);
    return run.summary();
  }
};

}  // namespace

template <int Dim>
std::unique_ptr<Suite> make_stop_suite() {
  return std::make_unique<StopSuite<Dim>>();
}
template std::unique_ptr<Suite> make_stop_suite<2>();
template std::unique_ptr<Suite> make_stop_suite<3>();

}  // namespace sinkmesh::stress
