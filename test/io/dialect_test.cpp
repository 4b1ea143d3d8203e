// SPDX-License-Identifier: MIT
//
// The same content as other programs and people write it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/support/io_files.h"
#include "test/support/sample_files.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

using io_detail::Source;
using test::sample_mesh;
using test::sample_points;
using test::sample_surface;
using ::testing::ElementsAre;

using DecodeSurface = Surface3 (*)(const Source&);

std::vector<Point3> corners(const Surface3& surface) {
  std::vector<Point3> result;
  for (const Surface3::Facet& facet : surface.facets) {
    for (const std::uint32_t v : facet) result.push_back(surface.points[v]);
  }
  return result;
}

void expect_sample(DecodeSurface decode, const std::string& bytes) {
  SCOPED_TRACE(bytes.substr(0, 400));
  Surface3 found;
  ASSERT_NO_THROW(found = decode({bytes, "file"}));
  test::expect_same_bits<3>(corners(sample_surface()), corners(found));
  // STL numbers points as they come.
  if (decode == io_detail::decode_stl) return;
  test::expect_same_bits<3>(sample_points(), found.points);
  EXPECT_EQ(found.facets, sample_surface().facets);
}

void expect_sample(const Mesh3& found) {
  const Mesh3 mesh = sample_mesh();
  test::expect_same_bits<3>(mesh.points, found.points);
  EXPECT_EQ(found.simplices, mesh.simplices);
  ASSERT_EQ(found.simplex_fields.size(), 1U);
  EXPECT_EQ(found.simplex_fields[0].values, mesh.simplex_fields[0].values);
}

std::string with_line_ends(const std::string& text, std::string_view line_end) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += line_end;
    } else {
      out += c;
    }
  }
  return out;
}

struct TextFile {
  const char* name;
  DecodeSurface decode;
  std::string bytes;
  const char* comment;  // a line that says nothing
};

std::vector<TextFile> text_files() {
  return {
      {"off", io_detail::decode_off, io_detail::encode_off(sample_surface()), "# a comment: 1 2 3\n"},
      {"obj", io_detail::decode_obj, io_detail::encode_obj(sample_surface()), "# v 1 2 3\n"},
      {"ply", io_detail::decode_ply, test::text_ply(sample_surface()), ""},
      {"stl", io_detail::decode_stl, io_detail::encode_stl(sample_surface()), ""},
  };
}

TEST(TextDialects, AnyLineEnds) {
  for (const TextFile& file : text_files()) {
    for (const char* line_end : {"\r\n", "\r", "\n\n", " \t\n", "\n  \t", "\r\n\r\n"}) {
      expect_sample(file.decode, with_line_ends(file.bytes, line_end));
    }
  }
}

TEST(TextDialects, NoFinalLineEndAndTooManyOfThem) {
  for (const TextFile& file : text_files()) {
    expect_sample(file.decode, file.bytes.substr(0, file.bytes.size() - 1));
    expect_sample(file.decode, file.bytes + "\n \r\n\t\n");
  }
}

TEST(TextDialects, CommentsBetweenLinesAndBehindNumbers) {
  for (const TextFile& file : text_files()) {
    if (file.comment[0] == '\0') continue;
    expect_sample(file.decode, with_line_ends(file.bytes, std::string(" # end\n") + file.comment));
    expect_sample(file.decode, with_line_ends(file.bytes, std::string("#end\n") + file.comment));
  }
}

TEST(TextDialects, ByteOrderMark) {
  for (const TextFile& file : text_files()) {
    if (std::string_view(file.name) == "stl") continue;  // see is_binary() in stl.cpp
    expect_sample(file.decode, "\xef\xbb\xbf" + file.bytes);
  }
}

TEST(TextDialects, NumbersInEveryNotation) {
  const std::pair<const char*, double> notations[] = {
      {"1", 1},
      {"+1", 1},
      {"1.", 1},
      {".5", 0.5},
      {"-.5", -0.5},
      {"+.5", 0.5},
      {"1e3", 1000},
      {"1E+3", 1000},
      {"1e-3", 1e-3},
      {"-0", -0.0},
      {"0.1", 0.1},
      {"00012", 12},
      {"1e-400", 0},
      {"-1e-400", -0.0},
      {"5e-324", 5e-324},
      {"1e+0300", 1e300},
      {"0.1000000000000000055511151231257827", 0.1},
      {"179769313486231570000000000000000000000e270", 1.7976931348623157e308}};
  for (const auto& [text, value] : notations) {
    SCOPED_TRACE(text);
    const std::string bytes =
        std::string("OFF\n3 1 0\n0 0 ") + text + "\n1 " + text + " 0\n" + text + " 1 0\n3 0 1 2";
    Surface3 found;
    ASSERT_NO_THROW(found = io_detail::decode_off({bytes, "file"}));
    test::expect_same_bits<3>({{0, 0, value}, {1, value, 0}, {value, 1, 0}}, found.points);
  }
}

TEST(TextDialects, NotNumbers) {
  for (const char* text : {"", "x", "1x", "1e", "0x10", "1,5", "--1", "+-1", "1e999", "-1e999", "nan", "inf",
                           "-inf", "infinity", "NaN", "1_000", "1d3", "\xc2\xbd"}) {
    SCOPED_TRACE(text);
    const std::string bytes = std::string("OFF\n3 1 0\n0 0 ") + text + "\n1 0 0\n0 1 0\n3 0 1 2";
    EXPECT_THROW(io_detail::decode_off({bytes, "file"}), FileError);
  }
}

TEST(OffDialects, HeaderAndColors) {
  const std::string rows =
      "0 0 0\n1 0 0\n0 1.5 0\n-0.25 0 1\n3 0 2 1\n3 0 1 3 0.5 0.5 0.5\n3 0 3 2 255 0 0 255\n3 1 2 3";
  for (const char* head : {"OFF\n4 4 6\n", "OFF 4 4 6\n", "OFF\n4 4\n", "# first\n\nOFF\n\n# then\n4 4 0\n"}) {
    expect_sample(io_detail::decode_off, head + rows);
  }
  for (const char* head : {"COFF", "NOFF", "STOFF", "CNOFF", "OFF"}) {
    expect_sample(io_detail::decode_off, std::string(head) +
                                             "\n4 4 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1.5 0 1 1 1 1\n"
                                             "-0.25 0 1 1 1 1 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  }
}

TEST(ObjDialects, CornersOfAllKinds) {
  const std::string points =
      "o thing\nv 0 0 0\nv 1 0 0 1.0\nvt 0 0\nvn 0 0 1\nv 0 1.5 0\nv -0.25 0 1 1 1 1\ns off\n";
  for (const char* facets :
       {"f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
        "f 1/1 3/1 2/1\nf 1/1/1 2/1/1 4/1/1\nf 1//1 4//1 3//1\nf -3/-1/-1 3 4\n",
        "usemtl a\ng b c\nf 1 3 2 # why not\nf 1 2 4\nl 1 2\nf 1 4 3\np 1\nf 2 3 4"}) {
    expect_sample(io_detail::decode_obj, points + facets);
  }
  // Indices may run ahead of the vertices, if they are positive.
  expect_sample(io_detail::decode_obj, "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + points);
  // Negative ones count back from where they stand.
  expect_sample(io_detail::decode_obj,
                "v 0 0 0\nv 1 0 0\nv 0 1.5 0\nf -3 -1 -2\nv -0.25 0 1\nf 1 -3 -1\nf 1 -1 -2\nf -3 -2 -1\n");
}

TEST(StlDialects, BinaryWhateverTheHeaderSays) {
  for (const char* header : {"", "solid", "solid facet normal", "binary", "\xff\xfe"}) {
    expect_sample(io_detail::decode_stl, test::binary_stl(sample_surface(), header));
  }
}

TEST(StlDialects, SeveralSolidsAndLooseText) {
  const std::string facets[] = {
      "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 0 1.5 0\nvertex 1 0 0\nendloop\nendfacet\n",
      "  facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex -2.5e-1 0 1 endloop endfacet ",
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex -0.25 0 1\nvertex 0 1.5 0\nendloop\nendfacet\n",
      "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1.5 0\nvertex -0.25 0 1\nendloop\nendfacet\n"};
  const std::string bytes =
      "solid one\n" + facets[0] + facets[1] + "\nendsolid one\nsolid\n" + facets[2] + facets[3] + "endsolid";
  const Surface3 found = io_detail::decode_stl({bytes, "file"});
  // Points are numbered as they come.
  test::expect_same_bits<3>({{0, 0, 0}, {0, 1.5, 0}, {1, 0, 0}, {-0.25, 0, 1}}, found.points);
  EXPECT_THAT(found.facets, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3), ElementsAre(0, 3, 1),
                                        ElementsAre(2, 1, 3)));
}

TEST(StlDialects, EqualPointsAreOneWhateverTheSignOfZero) {
  const std::string bytes =
      "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex -0 0 -0.0\nvertex 0 1 0\nvertex 0 0 "
      "1\nendloop\nendfacet\nendsolid\n";
  const Surface3 found = io_detail::decode_stl({bytes, "file"});
  EXPECT_EQ(found.points.size(), 4U);
  EXPECT_THAT(found.facets, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
}

TEST(PlyDialects, AllEncodings) {
  expect_sample(io_detail::decode_ply, test::text_ply(sample_surface()));
  expect_sample(io_detail::decode_ply, test::binary_ply(sample_surface(), std::endian::little));
  expect_sample(io_detail::decode_ply, test::binary_ply(sample_surface(), std::endian::big));
  expect_sample(io_detail::decode_ply, io_detail::encode_ply(sample_surface()));
}

TEST(PlyDialects, FacesBeforeVertices) {
  expect_sample(
      io_detail::decode_ply,
      "ply\r\nformat ascii 1.0\r\nelement face 4\r\nproperty list uchar int vertex_indices\r\n"
      "element vertex 4\r\nproperty double z\r\nproperty double y\r\nproperty double x\r\nend_header\r\n"
      "3 0 2 1\r\n3 0 1 3\r\n3 0 3 2\r\n3 1 2 3\r\n0 0 0\r\n0 0 1\r\n0 1.5 0\r\n1 0 -0.25\r\n");
}

TEST(VtkDialects, BinaryOfBothVersions) {
  for (const int version : {3, 5}) {
    SCOPED_TRACE(version);
    const std::string bytes = test::binary_vtk(sample_mesh(), version);
    expect_sample(io_detail::decode_vtk<3>({bytes, "file"}));
  }
}

TEST(VtuDialects, AllEncodings) {
  for (const auto encoding : {test::VtuEncoding::text, test::VtuEncoding::base64,
                              test::VtuEncoding::appended_base64, test::VtuEncoding::appended_raw_big}) {
    SCOPED_TRACE(static_cast<int>(encoding));
    const std::string bytes = test::vtu(sample_mesh(), encoding);
    expect_sample(io_detail::decode_vtu<3>({bytes, "file"}));
  }
}

TEST(MeditDialects, FreeFormAndOtherSections) {
  const std::string bytes =
      "MeshVersionFormatted 1 # version\nDimension\n3\nVertices 5\n0 0 0 1\n1 0 0 1\n0 1.5 0 1\n-0.25 0 1 1\n"
      "0.5 0.5 2 1\nCorners 1\n3\nEdges\n1\n1 2 0\nRidges 1 1\nTetrahedra\n2\n1 2 3 4 7\n2 3 4 5 "
      "-3\nEnd\nrubbish";
  expect_sample(io_detail::decode_medit<3>({bytes, "file"}));
}

TEST(GmshDialects, TagsWithGapsInAnyOrder) {
  const std::string two =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nanything\n$EndComments\n$Nodes\n5\n10 0 0 0\n7 1 0 "
      "0\n30 0 1.5 0\n"
      "4 -0.25 0 1\n99 0.5 0.5 2\n$EndNodes\n$Elements\n4\n9 4 2 -3 1 7 30 4 99\n1 15 2 0 1 10\n2 1 2 0 1 10 "
      "7\n"
      "5 4 3 7 1 0 10 7 30 4\n$EndElements\n";
  expect_sample(io_detail::decode_msh<3>({two, "file"}));
  const std::string four =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"inside\"\n$EndPhysicalNames\n"
      "$Entities\n1 0 0 2\n1 0 0 0 0\n8 0 0 0 1 1 1 1 7 0\n9 0 0 0 1 1 1 2 -3 4 1 5\n$EndEntities\n"
      "$Nodes\n2 5 4 99\n3 8 0 2\n10\n7\n0 0 0\n1 0 0\n3 9 0 3\n30\n4\n99\n0 1.5 0\n-0.25 0 1\n0.5 0.5 "
      "2\n$EndNodes\n"
      "$Elements\n3 3 1 9\n0 1 15 1\n1 10\n3 9 4 1\n9 7 30 4 99\n3 8 4 1\n5 10 7 30 4\n$EndElements\n";
  expect_sample(io_detail::decode_msh<3>({four, "file"}));
}

TEST(TetgenDialects, CountsFromZeroOrOneWithAttributesAndMarkers) {
  const std::string nodes[] = {
      "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1.5 0\n3 -0.25 0 1\n4 0.5 0.5 2\n",
      "# made by hand\n5 3 2 1 # counts\n\n1 0 0 0 9 9 1\n2 1 0 0 9 9 1\n3 0 1.5 0 9 9 1\n"
      "4 -0.25 0 1 9 9 1\n5 0.5 0.5 2 9 9 1\n"};
  const std::string cells[] = {"2 4 1\n0 0 1 2 3 7\n1 1 2 3 4 -3\n", "2 4 1\n1 1 2 3 4 7\n2 2 3 4 5 -3 # last"};
  for (std::size_t base = 0; base < 2; ++base) {
    SCOPED_TRACE(base);
    auto node_file = io_detail::decode_node<3>({nodes[base], "file"});
    EXPECT_EQ(node_file.first, static_cast<std::int64_t>(base));
    Mesh3 mesh;
    mesh.points = node_file.points;
    io_detail::decode_ele<3>({cells[base], "file"}, node_file.first, mesh);
    expect_sample(mesh);
  }
}

TEST(TetgenDialects, APolygonWithItsPointsBesideIt) {
  const test::TemporaryFolder folder;
  folder.write("a.node", "3 2 0 1\n1 0 0 1\n2 1 0 1\n3 0 1.5 1\n");
  folder.write("a.poly", "0 2 0 1\n3 1\n1 1 2 1\n2 2 3 1\n3 3 1 1\n1\n1 0.2 0.2\n");
  const Surface2 found = read_surface<2>(folder.path("a.poly"));
  EXPECT_EQ(found.points, test::sample_polygon().points);
  EXPECT_EQ(found.facets, test::sample_polygon().facets);
}

TEST(TetgenDialects, MarkersHolesAndRegionsOfAPolygon) {
  const test::TemporaryFolder folder;
  const std::string nodes = "3 2 1 1\n1 0 0 9 7\n2 1 0 9 7\n3 0 1.5 9 7\n";
  const std::string rest = "# holes\n1\n1 0.2 0.2 # here\n\n2 # regions\n1 0.1 0.3 -4.0 0.01\n2 .5 .25 1e3\n";
  const Surface2 marked =
      read_surface<2>(folder.write("a.poly", nodes + "3 1\n1 1 2 5\n2 2 3 -1\n3 3 1 5\n" + rest));
  EXPECT_EQ(marked.facet_tags, (std::vector<std::int64_t>{5, -1, 5}));
  EXPECT_EQ(marked.seeds.holes, (std::vector<Point2>{{0.2, 0.2}}));
  ASSERT_EQ(marked.seeds.regions.size(), 2U);
  EXPECT_EQ(marked.seeds.regions[0].point, (Point2{0.1, 0.3}));
  EXPECT_EQ(marked.seeds.regions[0].tag, -4);
  EXPECT_EQ(marked.seeds.regions[1].point, (Point2{0.5, 0.25}));
  EXPECT_EQ(marked.seeds.regions[1].tag, 1000);
  const Surface2 plain = read_surface<2>(folder.write("b.poly", nodes + "3\n1 1 2\n2 2 3\n3 3 1\n0\n"));
  EXPECT_EQ(plain.facets, marked.facets);
  EXPECT_TRUE(plain.facet_tags.empty());
  EXPECT_TRUE(plain.seeds.holes.empty());
  EXPECT_TRUE(plain.seeds.regions.empty());
}

// Facets beside the simplices in any order; a field that only they have is none of the simplices.
TEST(VtkDialects, FacetsAmongTheSimplices) {
  const std::string bytes =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n"
      "0 0 1\nCELLS 4 16\n3 0 2 1\n4 0 1 2 3\n2 0 1\n3 1 2 3\nCELL_TYPES 4\n5\n10\n3\n5\nCELL_DATA 4\n"
      "SCALARS parent long 1\nLOOKUP_TABLE default\n4\n-1\n-1\n-1\n"
      "SCALARS region long 1\nLOOKUP_TABLE default\n-1\n6\n-1\n-1\n"
      "SCALARS nothing long 1\nLOOKUP_TABLE default\n-1\n-1\n-1\n-1\n"
      "SCALARS tag long 1\nLOOKUP_TABLE default\n8\n7\n-1\n9\n";
  const Mesh3 mesh = io_detail::decode_vtk<3>({bytes, "file"});
  EXPECT_EQ(mesh.simplices.size(), 1U);
  EXPECT_EQ(mesh.boundary, (std::vector<Mesh3::Facet>{{0, 2, 1}, {1, 2, 3}}));
  ASSERT_EQ(mesh.simplex_fields.size(), 3U);
  EXPECT_EQ(mesh.simplex_fields[0].name, "region");
  EXPECT_EQ(mesh.simplex_fields[1].name, "nothing");
  EXPECT_EQ(mesh.simplex_fields[2].values, (std::vector<std::int64_t>{7}));
  ASSERT_EQ(mesh.boundary_fields.size(), 2U);
  EXPECT_EQ(mesh.boundary_fields[0].name, "parent");
  EXPECT_EQ(mesh.boundary_fields[0].values, (std::vector<std::int64_t>{4, -1}));
  EXPECT_EQ(mesh.boundary_fields[1].values, (std::vector<std::int64_t>{8, 9}));
}

TEST(XyzDialects, SeparatorsTitlesAndMoreColumns) {
  const std::string rows[] = {"0 0 0\n1 0 0\n0 1.5 0\n-0.25 0 1\n",
                              "x y z\n0 0 0\n1 0 0\n0 1.5 0\n-0.25 0 1",
                              "\"x\",\"y\",\"z\"\r\n0,0,0\r\n1,0,0\r\n0,1.5,0\r\n-0.25,0,1\r\n",
                              "\xef\xbb\xbfx;y;z;name\n0;0;0;a\n1;0;0;b\n0;1.5;0;c\n-0.25;0;1;d\n",
                              "# points\n\n 0\t0\t0\n1\t0\t0 # second\n\n0\t1.5\t0\n-2.5e-1\t+0\t1e0\n",
                              "0 , 0 , 0 , 9\n1 , 0 , 0 , 9\n0 , 1.5 , 0 , 9\n-.25 , 0 , 1 , 9\n"};
  for (const std::string& bytes : rows) {
    SCOPED_TRACE(bytes);
    test::expect_same_bits<3>(sample_points(), io_detail::decode_xyz<3>({bytes, "file"}));
  }
}

TEST(StandardInput, FormatsAreToldByTheirFirstBytesOrNamed) {
  EXPECT_THROW(static_cast<void>(format_from_name("docx")), InputError);
  EXPECT_EQ(format_from_name("csv"), Format::xyz);
  EXPECT_EQ(format_of_path("a.b/c.OFF", FileRole::surface_in), Format::off);
  EXPECT_THROW(static_cast<void>(format_of_path("a.off/c", FileRole::surface_in)), FileError);
  EXPECT_THROW(static_cast<void>(format_of_path("c.vtu", FileRole::surface_in)), FileError);
}

}  // namespace
}  // namespace sinkmesh
