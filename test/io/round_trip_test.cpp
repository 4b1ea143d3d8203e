// SPDX-License-Identifier: MIT
//
// What is written is read back: every bit of the coordinates, every index in its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "test/support/io_files.h"
#include "tools/io/read.h"
#include "tools/io/write.h"

namespace sinkmesh {
namespace {

using test::awkward_mesh;
using test::awkward_points;
using test::awkward_surface;
using test::expect_same_bits;
using test::TemporaryFolder;

struct MeshFormat {
  std::string suffix;
  Format format;
  bool keeps_boundary;
  std::string one_field;        // the name that a single field has after reading, where names are not kept
  std::string one_facet_field;  // the same for facets
  std::int64_t max_value;       // of a field
};

std::ostream& operator<<(std::ostream& out, const MeshFormat& format) { return out << name_of(format.format); }

const std::vector<MeshFormat>& mesh_formats() {
  constexpr std::int64_t kMax32 = std::numeric_limits<std::int32_t>::max();
  constexpr std::int64_t kMax64 = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kMaxWhole = std::int64_t{1} << 53;
  static const std::vector<MeshFormat> formats = {
      {".vtu", Format::vtu, false, "", "", kMax64},
      {".vtk", Format::vtk, false, "", "", kMax64},
      {".mesh", Format::medit, true, "reference", "reference", kMax32},
      {".msh", Format::msh, true, "physical", "physical", kMax32},
      {".msh", Format::msh2, true, "physical", "physical", kMax32},
      {".node", Format::tetgen, true, "attribute1", "marker", kMaxWhole},
  };
  return formats;
}

class MeshRoundTrip : public ::testing::TestWithParam<MeshFormat> {
 protected:
  template <int Dim>
  Mesh<Dim> through_file(const Mesh<Dim>& mesh) const {
    const std::string path = folder_.path("mesh" + GetParam().suffix);
    write_mesh(path, mesh, GetParam().format);
    return read_mesh<Dim>(path);
  }

  template <int Dim>
  void check_plain() const {
    const Mesh<Dim> mesh = awkward_mesh<Dim>();
    const Mesh<Dim> found = through_file(mesh);
    expect_same_bits<Dim>(mesh.points, found.points);
    EXPECT_EQ(mesh.simplices, found.simplices);
    if (GetParam().keeps_boundary) {
      EXPECT_EQ(mesh.boundary, found.boundary);
    } else {
      EXPECT_TRUE(found.boundary.empty());
    }
    EXPECT_TRUE(found.simplex_fields.empty());
  }

  template <int Dim>
  Mesh<Dim> with_field(const std::string& name) const {
    Mesh<Dim> mesh = awkward_mesh<Dim>();
    auto& field = mesh.simplex_fields.emplace_back();
    field.name = name;
    const std::int64_t max = GetParam().max_value;
    for (std::size_t i = 0; i < mesh.simplices.size(); ++i) {
      field.values.push_back(i == 3 ? max : i == 4 ? -max : static_cast<std::int64_t>(i * i % 7) - 2);
    }
    return mesh;
  }

  template <int Dim>
  void check_field() const {
    const std::string name = GetParam().one_field.empty() ? "a \"b\" <c> & 100%\t\xc3\xa9" : "label";
    const Mesh<Dim> mesh = with_field<Dim>(name);
    const Mesh<Dim> found = through_file(mesh);
    EXPECT_EQ(mesh.simplices, found.simplices) << "the order must not depend on the field";
    expect_same_bits<Dim>(mesh.points, found.points);
    ASSERT_EQ(found.simplex_fields.size(), 1U);
    EXPECT_EQ(found.simplex_fields[0].name, GetParam().one_field.empty() ? name : GetParam().one_field);
    EXPECT_EQ(found.simplex_fields[0].values, mesh.simplex_fields[0].values);
  }

  // A field of facets only, and one that simplices have, too; of simplices one that facets have not.
  template <int Dim>
  Mesh<Dim> with_facet_fields() const {
    Mesh<Dim> mesh = with_field<Dim>("tag");
    mesh.simplex_fields.push_back({"region", std::vector<std::int64_t>(mesh.simplices.size(), 1)});
    typename Mesh<Dim>::Field parent{"parent", {}};
    typename Mesh<Dim>::Field tag{"tag", {}};
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
      parent.values.push_back(static_cast<std::int64_t>(i / 2));
      tag.values.push_back(i == 7 ? std::numeric_limits<std::int32_t>::max()
                                  : static_cast<std::int64_t>(i * i % 5) - 2);
    }
    mesh.boundary_fields = {parent, tag};
    return mesh;
  }

  template <int Dim>
  void check_facet_fields() const {
    const Mesh<Dim> mesh = with_facet_fields<Dim>();
    const Mesh<Dim> found = through_file(mesh);
    expect_same_bits<Dim>(mesh.points, found.points);
    EXPECT_EQ(found.simplices, mesh.simplices);
    EXPECT_EQ(found.boundary, mesh.boundary);
    const bool has_room = GetParam().one_field.empty();
    ASSERT_EQ(found.simplex_fields.size(), has_room || GetParam().format == Format::tetgen ? 2U : 1U);
    for (std::size_t i = 0; i < found.simplex_fields.size(); ++i) {
      EXPECT_EQ(found.simplex_fields[i].values, mesh.simplex_fields[i].values);
    }
    ASSERT_EQ(found.boundary_fields.size(), has_room ? 2U : 1U);
    const auto& tag = mesh.boundary_fields[1];
    if (!has_room) {
      EXPECT_EQ(found.boundary_fields[0].name, GetParam().one_facet_field);
      EXPECT_EQ(found.boundary_fields[0].values, tag.values);
      return;
    }
    // The order is that of the arrays in the file: those of simplices come first.
    EXPECT_EQ(found.boundary_fields[0].name, "tag");
    EXPECT_EQ(found.boundary_fields[0].values, tag.values);
    EXPECT_EQ(found.boundary_fields[1].name, "parent");
    EXPECT_EQ(found.boundary_fields[1].values, mesh.boundary_fields[0].values);
  }

  TemporaryFolder folder_;
};

TEST_P(MeshRoundTrip, KeepsPointsAndCellsInSpace) { check_plain<3>(); }
TEST_P(MeshRoundTrip, KeepsPointsAndCellsInThePlane) { check_plain<2>(); }
TEST_P(MeshRoundTrip, KeepsAFieldInSpace) { check_field<3>(); }
TEST_P(MeshRoundTrip, KeepsAFieldInThePlane) { check_field<2>(); }

TEST_P(MeshRoundTrip, KeepsAllFieldsWhereThereIsRoom) {
  Mesh3 mesh = with_field<3>("one");
  mesh.simplex_fields.push_back({"two", std::vector<std::int64_t>(mesh.simplices.size(), 42)});
  const Mesh3 found = through_file(mesh);
  const bool has_room = GetParam().one_field.empty() || GetParam().format == Format::tetgen;
  ASSERT_EQ(found.simplex_fields.size(), has_room ? 2U : 1U);
  for (std::size_t i = 0; i < found.simplex_fields.size(); ++i) {
    EXPECT_EQ(found.simplex_fields[i].values, mesh.simplex_fields[i].values);
  }
}

TEST_P(MeshRoundTrip, KeepsFieldsOfFacetsInSpace) { check_facet_fields<3>(); }
TEST_P(MeshRoundTrip, KeepsFieldsOfFacetsInThePlane) { check_facet_fields<2>(); }

// Without a tag the parent is written, counted from 1; but in groups, of which there would be too many.
TEST_P(MeshRoundTrip, CountsParentsFromOneWhereThereIsOneNumber) {
  if (GetParam().one_field.empty()) return;
  Mesh3 mesh = with_facet_fields<3>();
  mesh.boundary_fields.resize(1);
  const Mesh3 found = through_file(mesh);
  EXPECT_EQ(found.boundary, mesh.boundary);
  if (GetParam().one_facet_field == "physical") {
    EXPECT_TRUE(found.boundary_fields.empty());
    return;
  }
  ASSERT_EQ(found.boundary_fields.size(), 1U);
  EXPECT_EQ(found.boundary_fields[0].name, GetParam().one_facet_field);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    EXPECT_EQ(found.boundary_fields[0].values[i], mesh.boundary_fields[0].values[i] + 1);
  }
}

TEST_P(MeshRoundTrip, RefusesATagThatItWouldChange) {
  if (GetParam().one_field.empty()) return;
  Mesh3 mesh = with_facet_fields<3>();
  for (const std::int64_t value : {std::int64_t{1} << 31, -(std::int64_t{1} << 31) - 1}) {
    mesh.boundary_fields[1].values[5] = value;
    EXPECT_THROW(write_mesh(folder_.path("mesh" + GetParam().suffix), mesh, GetParam().format), InputError);
  }
  EXPECT_TRUE(folder_.files().empty());
}

TEST_P(MeshRoundTrip, RefusesAValueThatItWouldChange) {
  Mesh3 mesh = with_field<3>("label");
  if (GetParam().max_value == std::numeric_limits<std::int64_t>::max()) return;
  for (const std::int64_t value : {GetParam().max_value + 1, -GetParam().max_value - 2}) {
    mesh.simplex_fields[0].values[5] = value;
    EXPECT_THROW(write_mesh(folder_.path("mesh" + GetParam().suffix), mesh, GetParam().format), InputError);
  }
  EXPECT_TRUE(folder_.files().empty());
}

TEST_P(MeshRoundTrip, RefusesArraysThatDoNotFitTogether) {
  const std::string path = folder_.path("mesh" + GetParam().suffix);
  Mesh3 mesh = awkward_mesh<3>();
  mesh.simplices[7][2] = static_cast<std::uint32_t>(mesh.points.size());
  EXPECT_THROW(write_mesh(path, mesh, GetParam().format), InputError);
  mesh = awkward_mesh<3>();
  mesh.boundary[3][1] = ~std::uint32_t{0};
  EXPECT_THROW(write_mesh(path, mesh, GetParam().format), InputError);
  mesh = awkward_mesh<3>();
  mesh.simplex_fields.push_back({"short", {1, 2, 3}});
  EXPECT_THROW(write_mesh(path, mesh, GetParam().format), InputError);
  mesh = awkward_mesh<3>();
  mesh.boundary_fields.push_back({"short", {1, 2, 3}});
  EXPECT_THROW(write_mesh(path, mesh, GetParam().format), InputError);
  EXPECT_TRUE(folder_.files().empty());
}

// The parts of a mesh are written and read without a look at the geometry, so an inverted simplex stays so.
TEST_P(MeshRoundTrip, KeepsTheOrientation) {
  Mesh3 mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.simplices = {{0, 1, 2, 3}, {1, 0, 2, 3}};
  mesh.boundary = {{0, 2, 1}, {1, 2, 0}};
  const Mesh3 found = through_file(mesh);
  EXPECT_EQ(found.simplices, mesh.simplices);
  if (GetParam().keeps_boundary) {
    EXPECT_EQ(found.boundary, mesh.boundary);
  }
}

TEST_P(MeshRoundTrip, IsAFixedPoint) {
  const Mesh3 mesh = with_field<3>("label");
  const Mesh3 found = through_file(mesh);
  const std::string once = folder_.read("mesh" + GetParam().suffix);
  through_file(found);
  const std::string twice = folder_.read("mesh" + GetParam().suffix);
  if (GetParam().keeps_boundary || GetParam().one_field.empty()) {
    EXPECT_EQ(once, twice);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshRoundTrip, ::testing::ValuesIn(mesh_formats()),
                         [](const auto& test) { return std::string(name_of(test.param.format)); });

class SurfaceRoundTrip : public ::testing::TestWithParam<Format> {};

TEST_P(SurfaceRoundTrip, KeepsPointsAndFacets) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string("surface.") + std::string(name_of(GetParam())));
  const Surface3 surface = awkward_surface<3>();
  write_surface(path, surface);
  const Surface3 found = read_surface(path);
  expect_same_bits<3>(surface.points, found.points);
  EXPECT_EQ(surface.facets, found.facets);
  expect_same_bits<3>(surface.points, read_points(path));
}

TEST_P(SurfaceRoundTrip, RefusesAnIndexOutOfRange) {
  const TemporaryFolder folder;
  Surface3 surface = awkward_surface<3>();
  surface.facets[2][0] = 99;
  EXPECT_THROW(write_surface(folder.path("a.off"), surface, GetParam()), InputError);
  EXPECT_TRUE(folder.files().empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceRoundTrip,
                         ::testing::Values(Format::off, Format::obj, Format::stl, Format::ply),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST(SurfaceRoundTrip, KeepsUnusedPointsWherePointsHaveIds) {
  const TemporaryFolder folder;
  Surface3 surface = awkward_surface<3>();
  surface.facets.resize(1);
  for (const char* name : {"a.off", "a.obj", "a.ply"}) {
    SCOPED_TRACE(name);
    write_surface(folder.path(name), surface);
    const Surface3 found = read_surface(folder.path(name));
    expect_same_bits<3>(surface.points, found.points);
    EXPECT_EQ(surface.facets, found.facets);
  }
}

TEST(SurfaceRoundTrip, KeepsAPolygonInThePlane) {
  const TemporaryFolder folder;
  const Surface2 surface = awkward_surface<2>();
  write_surface(folder.path("a.poly"), surface);
  const Surface2 found = read_surface<2>(folder.path("a.poly"));
  expect_same_bits<2>(surface.points, found.points);
  EXPECT_EQ(surface.facets, found.facets);
}

TEST(SurfaceRoundTrip, KeepsTagsHolesAndRegionsInThePlane) {
  const TemporaryFolder folder;
  Surface2 surface = awkward_surface<2>();
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    surface.facet_tags.push_back(static_cast<std::int64_t>(i % 5) - 2);
  }
  surface.seeds.holes = awkward_points<2>(7);
  for (const Point2& p : awkward_points<2>(9)) {
    surface.seeds.regions.push_back({p, static_cast<std::int64_t>(surface.seeds.regions.size()) - 4});
  }
  write_surface(folder.path("a.poly"), surface);
  const Surface2 found = read_surface<2>(folder.path("a.poly"));
  EXPECT_EQ(surface.facets, found.facets);
  EXPECT_EQ(surface.facet_tags, found.facet_tags);
  expect_same_bits<2>(surface.seeds.holes, found.seeds.holes);
  ASSERT_EQ(surface.seeds.regions.size(), found.seeds.regions.size());
  for (std::size_t i = 0; i < surface.seeds.regions.size(); ++i) {
    expect_same_bits<2>({surface.seeds.regions[i].point}, {found.seeds.regions[i].point});
    EXPECT_EQ(surface.seeds.regions[i].tag, found.seeds.regions[i].tag);
  }
  surface.facet_tags.pop_back();
  EXPECT_THROW(write_surface(folder.path("a.poly"), surface), InputError);
}

// Points have readers only; the shortest decimals of the standard library are their other side.
template <int Dim>
void check_points(const std::string& separator) {
  const auto points = awkward_points<Dim>();
  std::ostringstream text;
  text.precision(17);
  for (const auto& p : points) {
    for (std::size_t k = 0; k < Dim; ++k) text << (k != 0 ? separator : "") << p[k];
    text << '\n';
  }
  const TemporaryFolder folder;
  expect_same_bits<Dim>(points, read_points<Dim>(folder.write("a.xyz", text.str())));
}

TEST(PointsRoundTrip, KeepsEveryBit) {
  for (const char* separator : {" ", "\t", ",", ", ", ";", " ; "}) {
    SCOPED_TRACE(separator);
    check_points<3>(separator);
    check_points<2>(separator);
  }
}

TEST(PointsRoundTrip, NodeFilesOfAMeshArePoints) {
  const TemporaryFolder folder;
  const Mesh3 mesh = awkward_mesh<3>();
  write_mesh(folder.path("a.ele"), mesh);
  EXPECT_THAT(folder.files(), ::testing::ElementsAre("a.ele", "a.face", "a.node"));
  expect_same_bits<3>(mesh.points, read_points(folder.path("a.node")));
  for (const char* name : {"a.node", "a.ele", "a.face"}) {
    EXPECT_EQ(read_mesh(folder.path(name)).simplices, mesh.simplices);
  }
}

}  // namespace
}  // namespace sinkmesh
