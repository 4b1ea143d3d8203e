// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "core/triangulation.h"
#include "refine/refine.h"
#include "test/stress/io/suites.h"
#include "test/stress/refine/run_options.h"
#include "test/stress/refine/surface_case.h"
#include "test/stress/refine/surfaces.h"
#include "test/stress/text.h"
#include "test/support/heap.h"
#include "test/support/temporary_folder.h"
#include "tools/io/read.h"
#include "tools/io/write.h"

namespace sinkmesh::stress {
namespace {

using test::heap::Shortage;

/// One step with one allocation that fails, if there are so many.
class Trial {
 public:
  Trial(std::uint64_t n, Shortage shortage) : n_(n), shortage_(shortage) {}

  /// @return whether the step is done, and not given up for lack of memory.
  template <class Step>
  bool attempt(Step step) {
    test::heap::fail_at(n_, shortage_);
    bool is_done = false;
    std::string other;
    try {
      step();
      is_done = true;
    } catch (const std::bad_alloc&) {
      // the answer that is expected
    } catch (const std::exception& error) {
      test::heap::stop_failing();
      other = error.what();
    }
    has_failed_ = test::heap::stop_failing();
    if (!other.empty())
      throw CheckFailed("another exception: at allocation " + std::to_string(n_) + ": " + other);
    if (!is_done && !has_failed_) throw CheckFailed("bad_alloc: without a failure");
    return is_done;
  }

  bool has_failed() const { return has_failed_; }

 private:
  std::uint64_t n_;
  Shortage shortage_;
  bool has_failed_ = false;
};

/// Calls work(trial) for one allocation after the other, the later ones with gaps, until none fails.
template <class Work>
void for_every_allocation(Counters& counters, Work work) {
  for (const Shortage shortage : {Shortage::once, Shortage::lasting}) {
    bool has_failed = true;
    for (std::uint64_t n = 1; has_failed; n += 1 + n / 32) {
      const std::size_t before = test::heap::live_blocks();
      Trial trial(n, shortage);
      work(trial);
      has_failed = trial.has_failed();
      ++counters.comparisons;
      if (has_failed) ++counters.named[0];
      if (test::heap::live_blocks() != before) {
        throw CheckFailed("leak: " + std::to_string(test::heap::live_blocks() - before) +
                          " blocks after a failure at allocation " + std::to_string(n));
      }
    }
  }
}

template <int Dim>
class Steps {
 public:
  Steps(const Case& c, Counters& counters)
      : surface_(surface_of<Dim>(c)),
        options_(options_of(c)),
        choice_(c.number_setting("choice")),
        counters_(counters) {
    options_.max_vertices = surface_.points.size() + 40;
  }

  void read() {
    const std::string path =
        folder_.path(Dim == 2 ? "a.poly" : std::array{"a.off", "a.obj", "a.ply", "a.stl"}[choice_ % 4]);
    write_surface(path, surface_);
    const auto expected = read_surface<Dim>(path).facets;
    for_every_allocation(counters_, [&](Trial& trial) {
      std::optional<Surface<Dim>> found;
      if (trial.attempt([&] { found = read_surface<Dim>(path); }))
        expect_equal("facets that were read", found->facets == expected, true);
    });
  }

  void triangulate() {
    const std::uint64_t expected = Triangulation<Dim>(surface_.points).hash();
    for_every_allocation(counters_, [&](Trial& trial) {
      std::optional<Triangulation<Dim>> found;
      if (trial.attempt([&] { found.emplace(surface_.points, engine()); }))
        expect_equal("hash", found->hash(), expected);
    });
  }

  /// Of a point between others.
  void insert() {
    Point<Dim> p;
    for (std::size_t k = 0; k < Dim; ++k) {
      p[k] = (surface_.points[choice_ % surface_.points.size()][k] + surface_.points.front()[k]) / 2;
    }
    const Triangulation<Dim> before(surface_.points);
    Triangulation<Dim> after = before;
    after.insert(p);
    for_every_allocation(counters_, [&](Trial& trial) {
      Triangulation<Dim> found = before;
      if (trial.attempt([&] { found.insert(p, engine()); })) {
        expect_equal("hash", found.hash(), after.hash());
        return;
      }
      if (engine() == Engine::star) {
        expect_equal("hash after a failure", found.hash(), before.hash());
        found.insert(p);
        expect_equal("hash after another attempt", found.hash(), after.hash());
      }
      // Flips leave a triangulation that need not be Delaunay.
      for (const auto& violation : found.validate().violations) {
        if (engine() == Engine::star || violation.invariant != "D2") {
          throw CheckFailed("invariant " + violation.invariant + ": " + violation.message);
        }
      }
    });
  }

  void remove() {
    const Triangulation<Dim> before(surface_.points);
    const Vertex v(static_cast<std::uint32_t>(choice_ % surface_.points.size()));
    std::optional<std::uint64_t> expected;
    for_every_allocation(counters_, [&](Trial& trial) {
      Triangulation<Dim> found = before;
      const auto remove = [&] {
        try {
          found.remove(v);
        } catch (const DegenerateInput&) {
          // it is kept
        }
      };
      if (!trial.attempt(remove)) {
        expect_equal("hash after a failure", found.hash(), before.hash());
        remove();
      }
      if (!expected) expected = found.hash();
      expect_equal("hash", found.hash(), *expected);
      expect_equal("validity", found.validate().ok(), true);
    });
  }

  void refine() {
    const std::optional<Mesh<Dim>> expected = refined();
    for_every_allocation(counters_, [&](Trial& trial) {
      std::optional<Mesh<Dim>> found;
      if (!trial.attempt([&] { found = refined(); })) return;
      expect_equal("mesh", found.has_value(), expected.has_value());
      if (expected) expect_equal("simplices", found->simplices == expected->simplices, true);
    });
  }

  void write() {
    const Mesh<Dim> mesh = hull_mesh(Triangulation<Dim>(surface_.points));
    constexpr std::array kFiles{"a.vtu", "a.vtk", "a.mesh", "a.msh", "a.node"};
    const char* const name = kFiles[choice_ % kFiles.size()];
    const std::string path = folder_.path(name);
    write_mesh(path, mesh);
    const auto expected = folder_.contents();
    auto before = expected;
    for (auto& [file, bytes] : before) bytes = "before";
    if (choice_ / 8 % 2 == 0) before.clear();
    for_every_allocation(counters_, [&](Trial& trial) {
      folder_.set_contents(before);
      const bool is_done = trial.attempt([&] { write_mesh(path, mesh); });
      expect_equal("files", folder_.contents() == (is_done ? expected : before), true);
    });
  }

 private:
  Engine engine() const { return choice_ % 2 == 0 ? Engine::star : Engine::flips; }

  /// Nothing if the surface is refused with these options.
  std::optional<Mesh<Dim>> refined() const {
    try {
      return sinkmesh::refine(surface_, options_);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  test::TemporaryFolder folder_;
  Surface<Dim> surface_;
  RefineOptions options_;
  std::uint64_t choice_;
  Counters& counters_;
};

class MemorySuite : public Suite {
 public:
  std::string name() const override { return "memory"; }

  void generate(Random& random, Case& c) override {
    const int dim = test::uniform_int(random, 2, 3);
    c.set("dimension", static_cast<std::uint64_t>(dim));
    c.set("step", kSteps[random() % kSteps.size()]);
    c.set("choice", random());
    if (dim == 2) {
      set_surface<2>(c, random_surface<2>(random));
    } else {
      set_surface<3>(c, random_surface<3>(random));
    }
    draw_options(random, dim, c);
  }

  bool accepts(const Case& c) const override {
    const bool has_surface =
        c.number_setting("dimension") == 2 ? has_meshable_surface<2>(c) : has_meshable_surface<3>(c);
    return has_surface && has_valid_options(c);
  }

  std::string check(const Case& c, Counters& counters) override {
    if (c.number_setting("dimension") == 2) {
      run(Steps<2>(c, counters), c.setting("step"));
    } else {
      run(Steps<3>(c, counters), c.setting("step"));
    }
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"failures", 10}}; }
  unsigned seconds_per_case() const override { return 600; }

 private:
  static constexpr std::array kSteps{"read", "triangulate", "insert", "remove", "refine", "write"};

  static void run(auto steps, std::string_view step) {
    if (step == "read") return steps.read();
    if (step == "triangulate") return steps.triangulate();
    if (step == "insert") return steps.insert();
    if (step == "remove") return steps.remove();
    if (step == "refine") return steps.refine();
    steps.write();
  }
};

}  // namespace

std::unique_ptr<Suite> make_memory_suite() { return std::make_unique<MemorySuite>(); }

}  // namespace sinkmesh::stress
