// SPDX-License-Identifier: MIT
//
// Formats that mix cells of many kinds: which of them make a mesh.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "refine/mesh.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/shapes.h"

namespace sinkmesh::io_detail {

/// VTK's cells as arrays: cell i has the type types[i] and the corners connectivity[offsets[i] ..
/// offsets[i+1]).
struct VtkCells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;  // one more than cells, from 0
  std::vector<std::int64_t> types;
};

/// Cell data of whole numbers, one per cell.
using VtkField = std::pair<std::string, std::vector<std::int64_t>>;

/// In a field, of cells that have no value.
constexpr std::int64_t kVtkNoValue = -1;

/// The facets of the boundary that are cells of a file: those with fields. Without fields a facet says nothing
/// that the simplices do not say.
template <int Dim>
std::span<const typename Mesh<Dim>::Facet> vtk_facets(const Mesh<Dim>& mesh) {
  if (mesh.boundary_fields.empty()) return {};
  return mesh.boundary;
}

/// The fields of a mesh as cell data: simplices first, then the facets that are cells. A field of simplices and
/// one of facets are one array if they have the same name.
template <int Dim>
std::vector<VtkField> vtk_fields(const Mesh<Dim>& mesh) {
  std::vector<VtkField> fields;
  for (const auto& field : mesh.simplex_fields) {
    fields.emplace_back(field.name, field.values)
        .second.resize(mesh.simplices.size() + vtk_facets(mesh).size(), kVtkNoValue);
  }
  for (const auto& field : mesh.boundary_fields) {
    auto found =
        std::find_if(fields.begin(), fields.end(), [&](const VtkField& f) { return f.first == field.name; });
    if (found == fields.end()) {
      fields.emplace_back(field.name,
                          std::vector<std::int64_t>(mesh.simplices.size() + mesh.boundary.size(), kVtkNoValue));
      found = fields.end() - 1;
    }
    std::copy(field.values.begin(), field.values.end(),
              found->second.end() - static_cast<std::ptrdiff_t>(mesh.boundary.size()));
  }
  return fields;
}

inline bool has_value(const std::vector<std::int64_t>& values) {
  return std::any_of(values.begin(), values.end(), [](std::int64_t value) { return value != kVtkNoValue; });
}

/// Sorts the cells into simplices and boundary facets, and the values of each field with them. A field belongs
/// to the facets if one of them has a value, and to the simplices if one of them has, or no facet. Cells of
/// lower dimension (points and edges in space) are passed over.
/// @param fail  called with a message; must throw.
template <int Dim, class Fail>
void collect_vtk_cells(const VtkCells& cells, const std::vector<VtkField>& fields, Mesh<Dim>& mesh, Fail fail) {
  constexpr std::int64_t kVertex = 1;
  constexpr std::int64_t kLine = 3;
  const std::size_t count = cells.types.size();
  if (cells.offsets.size() != count + 1 || cells.offsets.front() != 0) {
    fail(concat("the cells have ", count, " types and ", cells.offsets.size(),
                " offsets, which do not fit together: the file is damaged"));
  }
  for (const auto& [name, values] : fields) {
    if (values.size() != count) {
      fail(concat("a field has ", values.size(), " values for ", count, " cells: the file is damaged"));
    }
  }
  std::vector<std::size_t> simplices;  // as cells
  std::vector<std::size_t> facets;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t first = cells.offsets[i];
    const std::int64_t last = cells.offsets[i + 1];
    if (last < first || static_cast<std::uint64_t>(last) > cells.connectivity.size()) {
      fail(concat("cell ", i, " has offsets ", first, " to ", last, " in a connectivity of ",
                  cells.connectivity.size(), ": the file is damaged"));
    }
    const auto take = [&](auto& cell) {
      if (last - first != static_cast<std::int64_t>(cell.size())) {
        fail(concat("cell ", i, " has ", last - first, " corners instead of ", cell.size(),
                    ": the file is damaged"));
      }
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const std::int64_t v = cells.connectivity[static_cast<std::size_t>(first) + k];
        if (v < 0 || static_cast<std::uint64_t>(v) >= mesh.points.size()) {
          fail(concat("cell ", i, " uses point ", v, ", which does not exist: there are ", mesh.points.size(),
                      ", counted from 0"));
        }
        cell[k] = static_cast<std::uint32_t>(v);
      }
    };
    const std::int64_t type = cells.types[i];
    if (type == Shapes<Dim>::kVtkSimplex) {
      take(mesh.simplices.emplace_back());
      simplices.push_back(i);
    } else if (type == Shapes<Dim>::kVtkFacet) {
      take(mesh.boundary.emplace_back());
      facets.push_back(i);
    } else if (type != kVertex && type != kLine) {
      fail(concat("cell ", i, " has VTK type ", type, ": only type ", Shapes<Dim>::kVtkSimplex, " (",
                  Shapes<Dim>::kSimplex, ") can be read; convert the mesh"));
    }
  }
  for (const auto& [name, values] : fields) {
    typename Mesh<Dim>::Field of_simplices{name, {}};
    typename Mesh<Dim>::Field of_facets{name, {}};
    for (const std::size_t i : simplices) of_simplices.values.push_back(values[i]);
    for (const std::size_t i : facets) of_facets.values.push_back(values[i]);
    const bool in_facets = has_value(of_facets.values);
    if (has_value(of_simplices.values) || !in_facets) mesh.simplex_fields.push_back(std::move(of_simplices));
    if (in_facets) mesh.boundary_fields.push_back(std::move(of_facets));
  }
}

/// Points of VTK have three coordinates; in the plane the third must be 0.
template <int Dim, class Fail>
std::vector<Point<Dim>> collect_points(const std::vector<double>& coordinates, Fail fail) {
  if (coordinates.size() % 3 != 0) fail("the points do not have 3 coordinates each: the file is damaged");
  std::vector<Point<Dim>> points(coordinates.size() / 3);
  if (points.size() >= 0xffffffffU) fail("there are more points than 32-bit indices can tell apart");
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = coordinates[3 * i + k];
      if (!(x - x == 0)) fail(concat("point ", i, " is not finite: repair or remove it"));
      if (k < Dim) {
        points[i][k] = x;
      } else if (x != 0) {
        fail(concat("point ", i, " is not in the plane z = 0: a plane mesh is needed here"));
      }
    }
  }
  return points;
}

}  // namespace sinkmesh::io_detail
