// SPDX-License-Identifier: MIT
//
// The tables of [EG01, Figures 7-11], ours beside the paper's.
#pragma once

#include <string>

#include "tools/reproduce/study.h"

namespace sinkmesh::reproduce {

/// The surface and every mesh: simplices, low quality, ratio; the paper's value beside ours.
std::string mesh_table(const Study& study);

/// What the kinds of points cost: candidates, prestars and CPU time of each schedule, and their ratios
/// circumcenter / sink; the paper's times and their ratio.
std::string cost_table(const Study& study);

/// One row for each model: the ratios circumcenter / sink of the paper's time and of ours, by schedule.
std::string comparison_table(const std::vector<Study>& studies);

/// What the paper does not have: off-sinks beside sinks and circumcenters, for each model, one by one and in
/// blocks.
std::string off_sink_table(const std::vector<Study>& studies);

}  // namespace sinkmesh::reproduce
