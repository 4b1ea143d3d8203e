// SPDX-License-Identifier: MIT
//
// The numbers of the page for other programs.
#pragma once

#include <string>
#include <vector>

#include "tools/reproduce/study.h"

namespace sinkmesh::reproduce {

/// Everything that the page says in numbers, the paper's included, as one JSON object.
std::string results_json(const std::vector<Study>& studies, const std::string& machine);
/// One line for each run.
std::string runs_csv(const std::vector<Study>& studies);
/// One line for each round of each run.
std::string rounds_csv(const std::vector<Study>& studies);

}  // namespace sinkmesh::reproduce
