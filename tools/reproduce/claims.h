// SPDX-License-Identifier: MIT
//
// Where the claims of [EG01] hold on our runs, and where they do not, in words with computed numbers.
#pragma once

#include <string>
#include <vector>

#include "tools/reproduce/study.h"

namespace sinkmesh::reproduce {

struct Claim {
  std::string claim;    ///< of the paper, in our words
  std::string verdict;  ///< "holds", "holds in part", "does not hold": decided by the numbers
  std::string finding;  ///< what the runs show
};

/// Requires the runs of reproduce().
std::vector<Claim> weigh_claims(const std::vector<Study>& studies);

}  // namespace sinkmesh::reproduce
