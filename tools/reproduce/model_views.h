// SPDX-License-Identifier: MIT
//
// From where the models of [EG01, 5] are looked at.
#pragma once

#include <string_view>

#include "tools/reproduce/cut.h"
#include "tools/reproduce/view.h"

namespace sinkmesh::reproduce {

/// By the name of the model: "cuboctahedron", "paraboloid", "star", "head".
/// @throws InputError for any other name.
View view_of(std::string_view model);

/// A plane through the middle, and a view of what is behind it.
Cut cut_of(std::string_view model);
View cut_view_of(std::string_view model);

/// Of pictures of the model, for a width: little is left empty.
int picture_height(std::string_view model, int width);

}  // namespace sinkmesh::reproduce
