// SPDX-License-Identifier: MIT
//
// Readers. Coordinates become the nearest double of the text, or keep the bits of the binary file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "refine/mesh.h"
#include "refine/surface.h"
#include "tools/io/file_error.h"
#include "tools/io/format.h"

namespace sinkmesh {

/// Where things came from, for messages about them. Lines count from 1. The arrays are empty after reading a
/// binary file; the line of what is not in them is 0.
struct SourceLines {
  std::vector<std::size_t> points;
  std::vector<std::size_t> facets;
  std::vector<std::size_t> holes;
  std::vector<std::size_t> regions;

  std::size_t point(std::size_t id) const { return id < points.size() ? points[id] : 0; }
  std::size_t facet(std::size_t id) const { return id < facets.size() ? facets[id] : 0; }
  std::size_t hole(std::size_t id) const { return id < holes.size() ? holes[id] : 0; }
  std::size_t region(std::size_t id) const { return id < regions.size() ? regions[id] : 0; }
};

struct ReadOptions {
  /// Default: by the suffix; on standard input by the first bytes.
  std::optional<Format> format = std::nullopt;
  /// If set: receives the source lines (text formats, surfaces and points).
  SourceLines* lines = nullptr;
};

/// Reads a surface: OFF, OBJ, STL or PLY in space, Triangle's .poly in the plane. Points and facets keep the
/// order of the file, and points their ids, used or not; STL, which has no ids, merges equal points at their
/// first occurrence (equal as numbers: no tolerance). Facets are triangles; larger polygons are refused.
///
/// Of a .poly: markers of segments become facet_tags, if it has any; holes and regions its seeds, the
/// attribute of a region its tag, which must be a whole number. Markers of points and bounds on areas are
/// passed over. If it has no points of its own they come from the .node file beside it.
///
/// @param path  "-" is standard input.
/// @return every index in range and every coordinate finite; otherwise as the file has it: see check_surface().
/// @throws FileError if the file cannot be read, is damaged, or has no facet.
/// Cost: linear in the size of the file, which is held in memory.
template <int Dim = 3>
[[nodiscard]] Surface<Dim> read_surface(const std::string& path, const ReadOptions& options = {});

/// Reads points: .xyz or .csv (columns separated by blanks, tabs, commas or semicolons; an optional line of
/// titles; columns after the coordinates are ignored, but every line has the same number), .node, or those of a
/// surface file, used by a facet or not. Duplicates are kept.
/// @throws FileError as read_surface, or if there is no point.
template <int Dim = 3>
[[nodiscard]] std::vector<Point<Dim>> read_points(const std::string& path, const ReadOptions& options = {});

/// Reads a mesh of simplices: .vtu (text, base64, raw; not compressed), legacy .vtk, MEDIT .mesh, Gmsh .msh 4.1
/// or 2.2 (text), TetGen .node with .ele and, if present, .face. For the last, `path` is any of the three.
///
/// Simplices keep the order of the file (Gmsh: of the element tags) and its orientation: a file may hold
/// inverted ones. boundary is what the file lists, and is empty for .vtu and .vtk unless they hold facets as
/// cells. Integer data per simplex become simplex_fields, those per facet boundary_fields: all of them from
/// .vtu and .vtk, where -1 is no value, and .ele ("attribute1", ...); the reference from .mesh ("reference"),
/// the physical tag from .msh ("physical") and the marker from .face ("marker"), unless these are all 0.
/// @throws FileError as read_surface, or if there is no simplex, or a simplex of another kind (hexahedra, ...).
template <int Dim = 3>
[[nodiscard]] Mesh<Dim> read_mesh(const std::string& path, const ReadOptions& options = {});

}  // namespace sinkmesh
