// SPDX-License-Identifier: MIT
//
// What is told about points that were moved and taken away.
#pragma once

#include <vector>

#include "refine/improvement.h"
#include "tools/program/report.h"
#include "tools/program/summary.h"

namespace sinkmesh::program {

Json to_json(const CoarsenResult& coarsening);

/// The counts, and the slivers that are left: how many for which reason, and the thousand worst.
template <int Dim>
Json to_json(const SliverResult& moving, const std::vector<Sliver<Dim>>& slivers);

/// @param coarsens, moves  which of the two was asked for.
template <int Dim>
void add_improvement(Summary& summary, const Improvement& improvement, bool coarsens, bool moves,
                     const std::vector<Sliver<Dim>>& slivers);

}  // namespace sinkmesh::program
