// SPDX-License-Identifier: MIT
//
// The file formats, their names and suffixes, and what each of them can hold.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinkmesh {

enum class Format {
  off,     ///< .off   surface
  obj,     ///< .obj   surface
  stl,     ///< .stl   surface; reads text and binary, writes text, since binary holds single precision only
  ply,     ///< .ply   surface; reads text and binary, writes binary doubles
  poly,    ///< .poly  polygon in the plane (Triangle)
  xyz,     ///< .xyz .csv  points
  vtu,     ///< .vtu   mesh; writes appended raw
  vtk,     ///< .vtk   mesh; legacy, reads text and binary, writes text
  medit,   ///< .mesh  mesh; text
  msh,     ///< .msh   mesh; Gmsh, text, writes 4.1, reads 4.1 and 2.2
  msh2,    ///< no suffix of its own: Gmsh 2.2
  tetgen,  ///< .node .ele .face (.edge in the plane)  mesh; the .node file alone: points
  svg,     ///< .svg   mesh in the plane, a picture; written only
};

enum class FileRole { surface_in, points_in, mesh_in, surface_out, mesh_out };

/// Whether the format can be used so, in dimension `dim`.
bool supports(Format format, FileRole role, int dim = 3);

/// The name `--format` takes.
std::string_view name_of(Format format);

/// All names for a role, as "off, obj, stl or ply".
std::string format_names(FileRole role, int dim = 3);

/// @throws InputError listing the names, if there is no such format.
Format format_from_name(std::string_view name);

/// By the suffix, in upper or lower case.
/// @throws FileError listing the formats, if the suffix is missing, unknown, or of a format without that role.
Format format_of_path(const std::string& path, FileRole role, int dim = 3);

}  // namespace sinkmesh
