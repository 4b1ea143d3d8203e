// SPDX-License-Identifier: MIT
//
// Writers. Coordinates keep every bit, in text too: the shortest decimals that read back as the same double.
#pragma once

#include <optional>
#include <string>

#include "refine/mesh.h"
#include "refine/surface.h"
#include "tools/io/file_error.h"
#include "tools/io/format.h"

namespace sinkmesh {

/// Writes a mesh: points and simplices; the boundary to .mesh, .msh and .face, and, if it has fields, to .vtu
/// and .vtk. Fields:
///   .vtu .vtk  all, as cell data: simplices and then facets, -1 where a field has no value; fields of the same
///              name are one
///   .ele       all of simplices, as attributes
///   .mesh      of simplices the first one, of facets "tag", else the first one, as references
///   .msh       the same, as physical tags, but no "parent": these tags are groups, each an entity
///   .face      the same as .mesh, as boundary markers
/// As references and markers, a "parent" is counted from 1.
///
/// The file appears under its name only when it is complete: it is written under a temporary name in the same
/// folder and renamed; on failure nothing is left behind and a file that was there before is untouched. A
/// device or pipe is written in place. TetGen's three files are completed before the first is renamed.
///
/// @param path    "-" is standard output.
/// @param format  default: by the suffix.
/// @throws FileError if the file cannot be written: unknown suffix, no such folder, full disk, closed pipe.
/// @throws InputError if a field's length is not the number of simplices or facets, an index is out of range,
///         or a reference, marker or physical tag does not fit 32 bits, or an attribute is beyond the whole
///         numbers that doubles hold.
template <int Dim>
void write_mesh(const std::string& path, const Mesh<Dim>& mesh, std::optional<Format> format = std::nullopt);

/// Writes a surface: OFF, OBJ, STL or PLY in space, Triangle's .poly in the plane. STL keeps neither ids nor
/// points without facet, and its facet normals are all 0 0 0, "to be computed from the corners". Tags, holes
/// and regions go to .poly only.
/// @throws as write_mesh; InputError if there are tags, but not one per facet.
template <int Dim>
void write_surface(const std::string& path, const Surface<Dim>& surface,
                   std::optional<Format> format = std::nullopt);

}  // namespace sinkmesh
