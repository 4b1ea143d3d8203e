// SPDX-License-Identifier: MIT
//
// Points from a file, in the plane or in space as the file has it.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "predicates/point.h"
#include "tools/program/files.h"

namespace sinkmesh::program {

using PointInput = std::variant<std::vector<Point3>, std::vector<Point2>>;

/// @param dimension  default: in space if every line has three coordinates, otherwise in the plane.
/// @throws FileError, UsageError
PointInput read_point_input(const FileArguments& files, std::optional<int> dimension);

}  // namespace sinkmesh::program
