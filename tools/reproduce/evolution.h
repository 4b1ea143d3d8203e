// SPDX-License-Identifier: MIT
//
// The evolution charts of [EG01, Figures 7-11]: sizes, candidates, and ratios over the rounds.
#pragma once

#include <string>
#include <vector>

#include "tools/reproduce/study.h"

namespace sinkmesh::reproduce {

/// Three charts, each with the run that inserts sinks and the run that inserts circumcenters. Values that the
/// paper prints for sinks in this schedule are drawn at both ends of the evolution.
std::vector<std::string> evolution_charts(const Study& study, Schedule schedule);

}  // namespace sinkmesh::reproduce
