// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <string>

#include "test/stress/io/suites.h"
#include "test/stress/io/trouble.h"
#include "test/stress/text.h"
#include "test/support/readers.h"
#include "test/support/temporary_folder.h"
#include "tools/io/write.h"

namespace sinkmesh::stress {
namespace {

struct Target {
  const char* file;
  Format format;
};
constexpr std::array kMeshes{Target{"a.vtu", Format::vtu},    Target{"a.vtk", Format::vtk},
                             Target{"a.mesh", Format::medit}, Target{"a.msh", Format::msh},
                             Target{"a.msh", Format::msh2},   Target{"a.node", Format::tetgen}};
constexpr std::array kSurfaces{Target{"a.off", Format::off}, Target{"a.obj", Format::obj},
                               Target{"a.stl", Format::stl}, Target{"a.ply", Format::ply}};

/// A case has no rows: what is written, and how far that goes, are settings.
class OutputSuite : public Suite {
 public:
  std::string name() const override { return "output"; }

  void generate(Random& random, Case& c) override {
    c.set("target", random() % (kMeshes.size() + kSurfaces.size()));
    c.set("trouble", name_of(kTroubles[random() % kTroubles.size()]));
    c.set("bytes", random() % 1200);
    c.set("before", random() % 2);
  }

  bool accepts(const Case& c) const override { return trouble_named(c.setting("trouble")).has_value(); }

  std::string check(const Case& c, Counters& counters) override {
    const test::TemporaryFolder folder;
    const std::size_t target = c.number_setting("target") % (kMeshes.size() + kSurfaces.size());
    const Trouble trouble = *trouble_named(c.setting("trouble"));
    write(target, folder, "");
    const auto expected = folder.contents();
    auto before = expected;
    for (auto& [file, bytes] : before) bytes = "before";
    if (c.number_setting("before") == 0) before.clear();
    folder.set_contents(before);

    std::string message;
    {
      const Troubled troubled(trouble, folder, c.number_setting("bytes"));
      try {
        write(target, folder, troubled.device());
      } catch (const FileError& error) {
        message = error.what();
      }
    }
    ++counters.comparisons;
    ++counters.named[message.empty() ? 0 : 1];
    expect_equal("files", folder.contents() == (message.empty() ? expected : before), true);
    if (message.empty()) {
      const bool may_be_done = trouble == Trouble::none || trouble == Trouble::limit || is_tetgen(target);
      expect_equal("a write without an error in spite of " + std::string(name_of(trouble)), may_be_done, true);
    } else {
      expect_equal("message", test::find_message_defect(message, message.substr(0, message.find(": cannot "))),
                   "");
    }
    return "";
  }

  std::vector<NamedCounter> counters() const override { return {{"written", 0.05}, {"failed", 0.3}}; }

 private:
  static const Target& target_of(std::size_t i) {
    return i < kMeshes.size() ? kMeshes[i] : kSurfaces[i - kMeshes.size()];
  }
  /// Several files, never written to a device.
  static bool is_tetgen(std::size_t i) { return target_of(i).format == Format::tetgen; }

  static void write(std::size_t target, const test::TemporaryFolder& folder, const std::string& device) {
    const Target& to = target_of(target);
    const std::string path = device.empty() || is_tetgen(target) ? folder.path(to.file) : device;
    if (target < kMeshes.size()) {
      write_mesh(path, test::sample_mesh(), to.format);
    } else {
      write_surface(path, test::sample_surface(), to.format);
    }
  }
};

}  // namespace

std::unique_ptr<Suite> make_output_suite() { return std::make_unique<OutputSuite>(); }

}  // namespace sinkmesh::stress
