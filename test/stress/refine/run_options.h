// SPDX-License-Identifier: MIT
//
// All options of a refinement as settings of a case.
#pragma once

#include <string>

#include "refine/options.h"
#include "test/stress/case.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Any combination that require_valid() takes, without budgets.
void draw_options(Random& random, int dim, Case& c);

/// @throws CaseError for a name that there is not.
RefineOptions options_of(const Case& c);

bool has_valid_options(const Case& c);

}  // namespace sinkmesh::stress
