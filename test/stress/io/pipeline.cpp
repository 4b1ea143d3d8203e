// SPDX-License-Identifier: MIT
#include "test/stress/io/pipeline.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/triangulation.h"
#include "refine/mesh_check.h"
#include "refine/refine.h"
#include "refine/surface_check.h"
#include "test/stress/text.h"
#include "test/support/temporary_folder.h"
#include "tools/io/write.h"

namespace sinkmesh::stress {
namespace {

template <std::size_t Dim>
bool have_same_bits(const std::vector<std::array<double, Dim>>& p,
                    const std::vector<std::array<double, Dim>>& q) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), [&](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), same);
  });
}

/// What the library may answer instead of a result; everything else that is thrown is a failure.
template <class Step>
bool is_done(Step step) {
  try {
    step();
    return true;
  } catch (const InputError& refusal) {
    const std::string why = refusal.what();
    if (why.size() < 20 || why.find('\n') != std::string::npos)
      throw CheckFailed("refusal: is no line: " + why);
    return false;
  }
}

void expect(bool holds, const std::string& kind, std::string_view format) {
  if (!holds) throw CheckFailed(kind + ": " + std::string(format));
}

/// Written, read, and written again: the same things, and then the same bytes.
class RoundTrips {
 public:
  explicit RoundTrips(Counters& counters) : counters_(counters) {}

  template <int Dim>
  void check(const Mesh<Dim>& mesh) {
    struct Trip {
      Format format;
      const char* file;
      bool keeps_boundary;
    };
    const bool has_cells = !mesh.boundary_fields.empty();
    for (const Trip& trip : {Trip{Format::vtu, "a.vtu", has_cells}, Trip{Format::vtk, "a.vtk", has_cells},
                             Trip{Format::medit, "a.mesh", true}, Trip{Format::msh, "a.msh", true},
                             Trip{Format::msh2, "a.msh", true}, Trip{Format::tetgen, "a.node", true}}) {
      const std::string path = folder_.path(trip.file);
      // A field that the format has no room for is refused.
      if (!is_done([&] { write_mesh(path, mesh, trip.format); })) continue;
      const Mesh<Dim> found = read_mesh<Dim>(path);
      expect(have_same_bits(found.points, mesh.points), "round trip of points", name_of(trip.format));
      expect(found.simplices == mesh.simplices, "round trip of simplices", name_of(trip.format));
      if (trip.keeps_boundary)
        expect(found.boundary == mesh.boundary, "round trip of the boundary", name_of(trip.format));
      expect_same_files([&] { write_mesh(path, found, trip.format); }, name_of(trip.format));
    }
  }

  template <int Dim>
  void check(const Surface<Dim>& surface) {
    constexpr std::array kInPlane{Format::poly};
    constexpr std::array kInSpace{Format::off, Format::obj, Format::ply};
    for (const Format format : in_dimension<Dim>(kInPlane, kInSpace)) {
      const std::string path = folder_.path("a." + std::string(name_of(format)));
      write_surface(path, surface, format);
      const Surface<Dim> found = read_surface<Dim>(path);
      expect(have_same_bits(found.points, surface.points), "round trip of points", name_of(format));
      expect(found.facets == surface.facets, "round trip of facets", name_of(format));
      expect(found.facet_tags == surface.facet_tags || Dim == 3, "round trip of tags", name_of(format));
      expect_same_files([&] { write_surface(path, found, format); }, name_of(format));
    }
    if constexpr (Dim == 3) {
      // Without ids, it merges what is equal, 0 and -0, too; from then on nothing changes.
      const std::string path = folder_.path("a.stl");
      write_surface(path, surface);
      const Surface3 merged = read_surface(path);
      expect(merged.facets.size() == surface.facets.size(), "round trip of facets", "stl");
      write_surface(path, merged);
      const Surface3 found = read_surface(path);
      expect_same_files([&] { write_surface(path, found); }, "stl");
    }
  }

 private:
  template <int Dim>
  static constexpr auto in_dimension(const auto& plane, const auto& space) {
    if constexpr (Dim == 2) {
      return plane;
    } else {
      return space;
    }
  }

  template <class Write>
  void expect_same_files(Write write, std::string_view format) {
    const auto before = folder_.contents();
    folder_.set_contents({});
    write();
    expect(folder_.contents() == before, "round trip of bytes", format);
    folder_.set_contents({});
    ++counters_.comparisons;
  }

  test::TemporaryFolder folder_;
  Counters& counters_;
};

template <std::size_t Dim>
void use(const std::vector<std::array<double, Dim>>& points, Counters& counters) {
  is_done([&] {
    try {
      const Triangulation<static_cast<int>(Dim)> triangulation(points);
      ++counters.comparisons;
      if (!triangulation.validate().ok()) throw CheckFailed("triangulation: of what was read is not valid");
    } catch (const DegenerateInput&) {
      // they span no volume
    }
  });
}

template <int Dim>
void use(const Mesh<Dim>& mesh, Counters& counters) {
  if (mesh.simplices.empty()) return;
  RoundTrips(counters).check(mesh);
  is_done([&] { static_cast<void>(check_mesh(mesh)); });
}

template <int Dim>
void use(const Surface<Dim>& surface, Counters& counters) {
  constexpr std::size_t kMorePoints = 100;
  use(surface.points, counters);
  if (surface.facets.empty()) return;
  RoundTrips(counters).check(surface);
  const auto defects = check_surface(surface);
  const bool is_meshable = std::none_of(defects.begin(), defects.end(), [](const SurfaceDefect& defect) {
    return severity(defect.kind) == SurfaceSeverity::error;
  });
  std::optional<Mesh<Dim>> mesh;
  const bool is_refined = is_done([&] {
    RefineOptions options;
    options.max_vertices = surface.points.size() + kMorePoints;
    mesh = refine(surface, options);
  });
  if (!is_refined) return;
  expect(is_meshable, "refined in spite of", defects.empty() ? "nothing" : defects.front().message);
  const auto check = check_mesh(*mesh);
  ++counters.comparisons;
  expect(check.ok(), "mesh of what was read", check.ok() ? "" : check.defects.front().message);
  RoundTrips(counters).check(*mesh);
}

}  // namespace

void expect_usable(const test::Contents& contents, Counters& counters) {
  std::visit([&](const auto& what) { use(what, counters); }, contents);
}

}  // namespace sinkmesh::stress
