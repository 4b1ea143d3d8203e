// SPDX-License-Identifier: MIT
//
// What `refine` tells about the boundary: how it was conformed, and what stays bad because of it.
#pragma once

#include <string>
#include <vector>

#include "refine/options.h"
#include "tools/io/read.h"
#include "tools/program/report.h"
#include "tools/program/summary.h"

namespace sinkmesh::program {

/// Keys "mode", "regions", ...; those that start with "refine_" count points inserted for quality.
Json to_json(const BoundaryResult& boundary, const RefineResult& result);
/// One object per simplex, at most a thousand.
template <int Dim>
Json to_json(const std::vector<Leftover<Dim>>& leftovers);
Json to_json(const Remaining& remaining);

/// @param asked   the mode that was asked for.
/// @param facets  of the surface.
void add_boundary(Summary& summary, const BoundaryResult& boundary, const RefineResult& result,
                  BoundaryMode asked, std::size_t facets, int dim);

/// One line that says why there is no domain, and ends with the hint. Requires !boundary.ok().
std::string failure_line(const BoundaryResult& boundary, const std::string& path, const SourceLines& lines,
                         std::size_t facets, const std::string& hint);

}  // namespace sinkmesh::program
