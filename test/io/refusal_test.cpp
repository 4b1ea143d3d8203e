// SPDX-License-Identifier: MIT
//
// What a refusal says: the file, the line (or the byte, in binary data), what is wrong there, and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/support/io_files.h"
#include "test/support/sample_files.h"
#include "tools/io/read.h"

namespace sinkmesh {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

enum class Kind { surface, polygon, points, mesh };

struct Refusal {
  const char* file;
  Kind kind;
  std::string bytes;
  std::size_t line;  // 0: the message has none
  const char* what;  // part of the message
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.file << ": " << refusal.what; }

void read(Kind kind, const std::string& path) {
  switch (kind) {
    case Kind::surface:
      static_cast<void>(read_surface(path));
      return;
    case Kind::polygon:
      static_cast<void>(read_surface<2>(path));
      return;
    case Kind::points:
      static_cast<void>(read_points(path));
      return;
    case Kind::mesh:
      static_cast<void>(read_mesh(path));
  }
}

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
constexpr const char* kStl = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
constexpr const char* kMedit =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
constexpr const char* kMsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
constexpr const char* kMsh41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 "
    "1\n$EndNodes\n";
constexpr const char* kVtk =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 "
    "0 1\n";

constexpr const char* kPoly = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
constexpr const char* kSegments = "3 0\n1 1 2\n2 2 3\n3 3 1\n";

std::string with(const char* head, const char* rest, const char* end = "") {
  return std::string(head) + rest + end;
}

std::vector<Refusal> refusals() {
  using enum Kind;
  return {
      // OFF
      {"a.off", surface, "", 1, "empty"},
      {"a.off", surface, "\n\nply\n", 3, "instead of OFF"},
      {"a.off", surface, "4OFF\n1 0 0\n", 1, "dimension"},
      {"a.off", surface, "OFF BINARY\n", 1, "save it as text"},
      {"a.off", surface, "OFF\n3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 2, "number of facets"},
      {"a.off", surface, "OFF\n-3 1 0\n0 0 0\n", 2, "negative"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 4, "fewer than 3 coordinates"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n", 4, "4 numbers instead of 3"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", 4, "'zero' is not a number"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", 4, "not finite"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n", 4, "rescale"},
      {"a.off", surface, "OFF\n# c\n\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n", 9, "triangulate"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", 6, "2 corners"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 6, "run from 0 to 2"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n", 6, "vertex -1 does not exist"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n", 6, "not a whole number"},
      {"a.off", surface, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n", 6, "fewer than 3 vertices"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", 6, "ends inside facet 0"},
      {"a.off", surface, "OFF\r\n3 2 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n\r\n", 8,
       "after 1 of 2 facets"},
      {"a.off", surface, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", 7, "goes on"},
      {"a.off", surface, "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", 0, "holds no triangle"},
      {"a.off", surface, "OFF\n1152921504606846976 1 0\n0 0 0\n", 2, "bytes that follow"},
      {"a.off", surface, "OFF\n3 99999999999999999999 0\n0 0 0\n", 2, "64 bits"},
      {"a.off", points, "OFF\n0 0 0\n", 0, "no point"},
      // OBJ
      {"a.obj", surface, "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", 2, "vertex 2 has fewer"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n", 5, "triangulate"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n", 5, "facet 2 has fewer"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", 4, "'0' is not a vertex"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n", 5, "vertex 4 does not exist"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nf -1 -2 -3\nv 0 1 0\n", 3, "vertex -3 does not exist"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967296\n", 4, "does not exist"},
      {"a.obj", surface, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/x 2 3\nf 1 2x 3\n", 5, "'2x'"},
      {"a.obj", surface, "v 0 0 0\nfacets\n", 2, "is this an OBJ file?"},
      {"a.obj", surface, "", 0, "holds no triangle"},
      // STL
      {"a.stl", surface, "", 0, "empty"},
      {"a.stl", surface, "rubbish", 0, "at byte 0: not an STL file"},
      {"a.stl", surface, with(kStl, "vertex 0 1\nendloop\nendfacet\nendsolid\n"), 7,
       "'endloop' is not a number"},
      {"a.stl", surface, with(kStl, "vertex 0 1 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n"), 7,
       "triangulate"},
      {"a.stl", surface, with(kStl, "endloop\nendfacet\nendsolid\n"), 6, "'vertex' was expected"},
      {"a.stl", surface, with(kStl, "vertex 0 1 inf\nendloop\nendfacet\nendsolid\n"), 6, "not finite"},
      {"a.stl", surface, with(kStl, "vertex 0 1 0\nendloop\nendfacet\n"), 9, "truncated"},
      {"a.stl", surface, test::binary_stl(test::sample_surface(), "b").substr(0, 200), 0,
       "at byte 84: the file announces 4"},
      {"a.stl", surface, test::binary_stl({{{0, 0, 1}, {HUGE_VAL, 0, 0}}, {{{0, 1, 0}}}}, "b"), 0,
       "at byte 112: a coordinate is not finite"},
      // PLY
      {"a.ply", surface, "OFF\n", 1, "instead of ply"},
      {"a.ply", surface, "ply\nformat ascii 1.0\nelement vertex 3\nproperty real x\nend_header\n", 4,
       "'real' is not a type"},
      {"a.ply", surface, "ply\nformat binary 1.0\nend_header\n", 2, "binary_little_endian"},
      {"a.ply", surface, "ply\nelement vertex 0\nend_header\n", 4, "no format line"},
      {"a.ply", surface, "ply\nformat ascii 1.0\nproperty float x\nend_header\n", 3,
       "before the first element"},
      {"a.ply", surface,
       "ply\nformat ascii 1.0\nelement vertex 1152921504606846976\nproperty float x\nend_header\n", 3, "bytes"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), 11, "the row ends"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"), 11, "'0' follows"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n"), 13, "triangulate"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), 13, "vertex 3, which does not exist"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), 13, "vertex -1, which does not exist"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0\n0 1 0\n"), 13, "truncated"},
      {"a.ply", surface, with(kPly, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"), 14, "goes on"},
      // points
      {"a.xyz", points, "0 0 0\n1 0\n", 2, "2 coordinates: 3 are needed"},
      {"a.xyz", points, "0 0 0\n1 0 0 1\n", 2, "4 columns, but line 1 has 3"},
      {"a.csv", points, "x,y,z\n0,0,0\n1,,0\n", 3, "column 2 is empty"},
      {"a.csv", points, "x,y,z\n0,0,0\n1,0,zero\n", 3, "'zero' is not a number"},
      {"a.xyz", points, "nan 0 0\n", 1, "not finite"},
      {"a.csv", points, "id,x,y,z\n1,0,0,0\n", 1, "title x stands over column 2"},
      {"a.csv", points, "z y x\n0 0 0\n", 1, "title z stands over column 1"},
      {"a.xyz", points, "0,5 0,5 0,5\n", 1, "by commas and by blanks"},
      {"a.xyz", points, "\n# nothing\n", 0, "no point"},
      {"a.node", points, "2 3 0 0\n1 0 0 0\n3 1 0 0\n", 3, "row number 3 stands where 2"},
      {"a.node", points, "2 3 0 0\n1 0 0\n2 1 0 0\n", 2, "the row ends where a coordinate"},
      {"a.node", points, "2 3 0 0\n1 0 0 0 5\n2 1 0 0\n", 2, "'5' follows"},
      {"a.node", points, "2 2 0 0\n1 0 0\n2 1 0\n", 1, "dimension 2: 3 is needed"},
      {"a.node", points, "1 3 0 0\n1 0 0 0\n2 1 0 0\n", 3, "goes on"},
      {"a.poly", polygon, "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n1 0\n1 1 4\n", 6, "run from 1 to 3"},
      {"a.poly", polygon, "0 2 0 0\n1 0\n1 1 4\n", 1, ".node"},
      {"a.poly", polygon, with(kPoly, "3 1\n1 1 2 5\n2 2 3\n3 3 1 5\n"), 7, "ends where a marker"},
      {"a.poly", polygon, with(kPoly, "3 1\n1 1 2 5\n2 2 3 0.5\n3 3 1 5\n"), 7, "'0.5' is not a whole number"},
      {"a.poly", polygon, with(kPoly, "3 0\n1 1 2 5\n2 2 3\n3 3 1\n"), 6, "'5' follows"},
      {"a.poly", polygon, with(kPoly, "3 1\n1 1 2 5\n2 2 3 5\n"), 8, "ends where the number of a row"},
      {"a.poly", polygon, with(kPoly, kSegments, "holes\n"), 9, "'holes' is not a whole number"},
      {"a.poly", polygon, with(kPoly, kSegments, "-1\n"), 9, "cannot be negative"},
      {"a.poly", polygon, with(kPoly, kSegments, "1\n1 0.5\n"), 10, "ends where a coordinate"},
      {"a.poly", polygon, with(kPoly, kSegments, "1\n1 0.5 0.5 7\n"), 10, "'7' follows"},
      {"a.poly", polygon, with(kPoly, kSegments, "1\n1 nan 0.5\n"), 10, "not finite"},
      {"a.poly", polygon, with(kPoly, kSegments, "2\n1 0.5 0.5\n3 0.5 0.6\n"), 11, "row number 3"},
      {"a.poly", polygon, with(kPoly, kSegments, "9\n1 0.5 0.5\n"), 9, "bytes that follow"},
      {"a.poly", polygon, with(kPoly, kSegments, "0\n1\n1 0.5 0.5\n"), 11, "the attribute of a region"},
      {"a.poly", polygon, with(kPoly, kSegments, "0\n1\n1 0.5 0.5 1.5\n"), 11,
       "attribute of this region is 1.5"},
      {"a.poly", polygon, with(kPoly, kSegments, "0\n1\n1 0.5 0.5 1 0.1 9\n"), 11, "'9' follows"},
      {"a.poly", polygon, with(kPoly, kSegments, "0\n1\n1 0.5 0.5 1\n2 0.5 0.5 1\n"), 12, "goes on"},
      // meshes
      {"a.mesh", mesh, "MeshVersionFormatted 2\nDimension 2\nVertices\n0\n", 2, "dimension 2: 3 is needed"},
      {"a.mesh", mesh, with(kMedit, "Tetrahedra\n1\n1 2 3 5 0\n"), 11, "run from 1 to 4"},
      {"a.mesh", mesh, with(kMedit, "Tetrahedra\n1\n0 1 2 3 0\n"), 11, "vertex 0 does not exist"},
      {"a.mesh", mesh, with(kMedit, "Hexahedra\n1\n1 2 3 4 1 2 3 4 0\n"), 9, "'Hexahedra' is not"},
      {"a.mesh", mesh, with(kMedit, "Tetrahedra\n7\n1 2 3 4 0\n"), 10, "bytes that follow"},
      {"a.mesh", mesh, with(kMedit, "End\n"), 0, "holds no tetrahedron"},
      {"a.mesh", mesh, "MeshVersionFormatted 2\nDimension 3\nTetrahedra\n0\n", 3, "put the vertices first"},
      {"a.msh", mesh, "$Nodes\n", 1, "$MeshFormat"},
      {"a.msh", mesh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n", 2, "4.1 or 2.2"},
      {"a.msh", mesh, "$MeshFormat\n4.1 1 8\n\x01\x00\x00\x00\n$EndMeshFormat\n", 2, "save it as text"},
      {"a.msh", mesh, with(kMsh, "$Elements\n1\n1 4 2 0 1 1 2 3 5\n$EndElements\n"), 13,
       "node 5 does not exist"},
      {"a.msh", mesh, with(kMsh, "$Elements\n1\n1 5 2 0 1 1 2 3 4 1 2 3 4\n$EndElements\n"), 13,
       "only type 4 (tetrahedron)"},
      {"a.msh", mesh, with(kMsh, "$Elements\n2\n1 4 2 0 1 1 2 3 4\n$EndElements\n"), 14,
       "'$EndElements' is not"},
      {"a.msh", mesh, kMsh, 11, "$Elements"},
      {"a.msh", mesh, with(kMsh41, "$Elements\n1 2 1 2\n3 1 4 1\n1 1 2 3 4\n$EndElements\n"), 19,
       "the blocks hold 1 elements, but 2"},
      {"a.vtk", mesh, "vtk\n", 1, "# vtk DataFile Version"},
      {"a.vtk", mesh, "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n", 4,
       "UNSTRUCTURED_GRID is needed"},
      {"a.vtk", mesh, with(kVtk, "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n"), 14,
       "point 4, which does not exist"},
      {"a.vtk", mesh, with(kVtk, "CELLS 1 9\n8 0 1 2 3 0 1 2 3\nCELL_TYPES 1\n12\n"), 14, "type 12"},
      {"a.vtk", mesh, with(kVtk, "CELLS 2 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"), 11, "correct the counts"},
      {"a.vtk", mesh, with(kVtk, "CELLS 1 5\n4 0 1 2\n"), 11, "truncated"},
      {"a.vtk", mesh, test::binary_vtk(test::sample_mesh(), 3).substr(0, 150), 0, "at byte 82: 15 values"},
      {"a.vtk", mesh, test::binary_vtk(test::sample_mesh(), 3) + "RUBBISH", 0, "at byte 337: 'RUBBISH'"},
      {"a.vtu", mesh, "<html>\n", 0, "VTKFile"},
      {"a.vtu", mesh, "<?xml?>\n<VTKFile type=\"PolyData\">\n", 2, "UnstructuredGrid is needed"},
      {"a.vtu", mesh, "<VTKFile type=\"UnstructuredGrid\"\n compressor=\"vtkZLibDataCompressor\">\n", 1,
       "without compression"},
      {"a.vtu", mesh, io_detail::encode_vtu(test::sample_mesh()).substr(0, 900), 10, "truncated"},
  };
}

class Refusals : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refusals, NamesTheLineTheFaultAndTheRemedy) {
  const Refusal& refusal = GetParam();
  const test::TemporaryFolder folder;
  const std::string path = folder.write(refusal.file, refusal.bytes);
  try {
    read(refusal.kind, path);
    FAIL() << "accepted:\n" << refusal.bytes;
  } catch (const FileError& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.line(), refusal.line) << message;
    EXPECT_EQ(error.file(), path);
    const std::string place = refusal.line == 0 ? ": " : ":" + std::to_string(refusal.line) + ": ";
    EXPECT_THAT(message, StartsWith(path + place));
    EXPECT_THAT(message, HasSubstr(refusal.what));
    // What is wrong, and then what to do about it or what was expected instead.
    EXPECT_THAT(message.substr(path.size() + place.size()), ::testing::MatchesRegex(".+[:;?,].+|.*needed.*"))
        << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Refusals, ::testing::ValuesIn(refusals()));

TEST(Refusals, FilesThatCannotBeOpened) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("folder.off"));
  for (const char* name : {"missing.off", "folder.off", "no/such/folder.off"}) {
    try {
      static_cast<void>(read_surface(folder.path(name)));
      FAIL() << name;
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), StartsWith(folder.path(name) + ": cannot "));
      EXPECT_THAT(error.what(),
                  HasSubstr(std::string(name) == "folder.off" ? "not a folder" : "check the path"));
    }
  }
  folder.write("a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  try {
    static_cast<void>(read_mesh(folder.path("a.node")));
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), StartsWith(folder.path("a.ele") + ": cannot open it"));
  }
}

TEST(Refusals, AreOnePrintableLineWhateverTheNameOfTheFile) {
  const FileError error("a\nb\x1b\xff.off", 3, "word '\n\t' is wrong");
  EXPECT_STREQ(error.what(), "a\\x0ab\\x1b\\xff.off:3: word '\\x0a\\x09' is wrong");
}

}  // namespace
}  // namespace sinkmesh
