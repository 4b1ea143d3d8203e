// SPDX-License-Identifier: MIT
//
// The formats, from bytes to arrays and back. Nothing here touches the file system; `file` is for messages.
// Readers throw FileError, for every damage that bytes can have; they guarantee indices in range and finite
// coordinates, but not that there is any facet or simplex.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "refine/mesh.h"
#include "refine/surface.h"
#include "tools/io/format.h"
#include "tools/io/read.h"

namespace sinkmesh::io_detail {

/// One file in memory.
struct Source {
  std::string_view bytes;
  std::string_view file;
  /// Filled in by the readers of surfaces and points in text, if set; empty to begin with.
  SourceLines* lines = nullptr;
};

Surface3 decode_off(const Source& source);
Surface3 decode_obj(const Source& source);
Surface3 decode_stl(const Source& source);
Surface3 decode_ply(const Source& source);
/// @param nodes  the companion .node file, which holds the points if the .poly itself has none.
Surface2 decode_poly(const Source& source, const std::optional<Source>& nodes);

std::string encode_off(const Surface3& surface);
std::string encode_obj(const Surface3& surface);
std::string encode_stl(const Surface3& surface);
std::string encode_ply(const Surface3& surface);
std::string encode_poly(const Surface2& surface);

template <int Dim>
std::vector<Point<Dim>> decode_xyz(const Source& source);

template <int Dim>
Mesh<Dim> decode_vtu(const Source& source);
template <int Dim>
Mesh<Dim> decode_vtk(const Source& source);
template <int Dim>
Mesh<Dim> decode_medit(const Source& source);
template <int Dim>
Mesh<Dim> decode_msh(const Source& source);

template <int Dim>
std::string encode_vtu(const Mesh<Dim>& mesh);
template <int Dim>
std::string encode_vtk(const Mesh<Dim>& mesh);
template <int Dim>
std::string encode_medit(const Mesh<Dim>& mesh);
template <int Dim>
std::string encode_msh41(const Mesh<Dim>& mesh);
template <int Dim>
std::string encode_msh22(const Mesh<Dim>& mesh);

/// A picture: edges, the boundary bold.
std::string encode_svg(const Mesh2& mesh);

/// The points of a TetGen or Triangle .node file, and the number of its first one.
template <int Dim>
struct NodeFile {
  std::vector<Point<Dim>> points;
  std::int64_t first = 0;
};
template <int Dim>
NodeFile<Dim> decode_node(const Source& source);
/// Both append to the mesh, whose points are set.
template <int Dim>
void decode_ele(const Source& source, std::int64_t first, Mesh<Dim>& mesh);
template <int Dim>
void decode_face(const Source& source, std::int64_t first, Mesh<Dim>& mesh);

template <int Dim>
std::string encode_node(const std::vector<Point<Dim>>& points);
template <int Dim>
std::string encode_ele(const Mesh<Dim>& mesh);
template <int Dim>
std::string encode_face(const Mesh<Dim>& mesh);

}  // namespace sinkmesh::io_detail
