// SPDX-License-Identifier: MIT
//
// Formats with room for a single number per simplex and per facet: which of the fields it is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "refine/mesh.h"

namespace sinkmesh::io_detail {

/// Of simplices the first field; null if there is none.
template <int Dim>
const typename Mesh<Dim>::Field* simplex_field(const Mesh<Dim>& mesh) {
  return mesh.simplex_fields.empty() ? nullptr : &mesh.simplex_fields.front();
}

/// Of facets their "tag", else the first field; null if there is none.
template <int Dim>
const typename Mesh<Dim>::Field* facet_field(const Mesh<Dim>& mesh) {
  for (const auto& field : mesh.boundary_fields) {
    if (field.name == "tag") return &field;
  }
  return mesh.boundary_fields.empty() ? nullptr : &mesh.boundary_fields.front();
}

/// What is written: zeros without a field.
template <int Dim>
std::vector<std::int64_t> simplex_references(const Mesh<Dim>& mesh) {
  const auto* const field = simplex_field(mesh);
  return field != nullptr ? field->values : std::vector<std::int64_t>(mesh.simplices.size(), 0);
}

/// Parents are as many as the facets of a surface: too many for the groups of some formats.
enum class Parents { counted_from_one, left_out };

/// As above. A "parent" is counted from 1, since 0 means none in all these formats.
template <int Dim>
std::vector<std::int64_t> facet_references(const Mesh<Dim>& mesh, Parents parents = Parents::counted_from_one) {
  const auto* const field = facet_field(mesh);
  const bool is_parent = field != nullptr && field->name == "parent";
  if (field == nullptr || (is_parent && parents == Parents::left_out)) {
    return std::vector<std::int64_t>(mesh.boundary.size(), 0);
  }
  std::vector<std::int64_t> references = field->values;
  if (is_parent) {
    for (std::int64_t& reference : references) ++reference;
  }
  return references;
}

/// Numbers that were read make a field of this name, unless all are 0.
template <class Field>
void add_references(std::vector<Field>& fields, std::string name, std::vector<std::int64_t> values) {
  const bool any = std::any_of(values.begin(), values.end(), [](std::int64_t value) { return value != 0; });
  if (any) fields.push_back({std::move(name), std::move(values)});
}

}  // namespace sinkmesh::io_detail
