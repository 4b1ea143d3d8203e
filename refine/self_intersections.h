// SPDX-License-Identifier: MIT
//
// Where a surface crosses, touches or overlaps itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "refine/surface.h"

namespace sinkmesh {

/// Two facets by their ids, the smaller one first.
using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// The pairs of facets whose intersection, as closed sets, is more than the face spanned by their common
/// vertices: nothing, a vertex, or an edge. In the plane read "segment" for facet. A vertex inside another
/// facet or edge counts, and so does an overlap in a common plane or line.
///
/// Vertices are common if their coordinates are equal, whatever their ids: a seam of duplicate vertices, or a
/// soup of triangles without common ids, is no intersection. Facets with the same vertices are not reported: as
/// duplicate_vertex and duplicate_facet (surface_check.h) all these are defects of their own. Facets with an
/// index out of range, a repeated vertex, or a coordinate that is not finite take no part; nor do those with
/// collinear corners (in the plane: of length 0).
///
/// @param limit  stop at this many pairs: with 1, whether there is any, and the first.
/// @return the first `limit` pairs in ascending order: a function of the surface and its ids. Decided by exact
///         signs of the gated coordinates (predicates/input_gate.h). Never throws but for lack of memory.
/// Cost: O(n log n), and the pairs of facets whose boxes meet, which are a few to a facet unless many facets
/// share a vertex or are long, thin and oblique; about 0.1 s for 100,000 triangles. Memory linear. A limit
/// saves time only if it is reached.
template <int Dim>
[[nodiscard]] std::vector<FacetPair> self_intersections(
    const Surface<Dim>& surface, std::size_t limit = std::numeric_limits<std::size_t>::max());

}  // namespace sinkmesh
