// SPDX-License-Identifier: MIT
//
// The JSON object that --report writes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "refine/quality.h"
#include "refine/refine.h"

namespace sinkmesh::program {

/// Keys keep the order in which they are set. Numbers that are not finite become null.
using Json = nlohmann::ordered_json;

/// An object with "program", "version" and "command".
Json begin_report(const std::string& command);

/// { simplices low_quality ratio{min avg max} dihedral{min max} }, after the vertices; in the plane "angle"
/// instead of "dihedral".
Json to_json(int dim, std::size_t vertices, const QualityStatistics& quality);
/// [{ up_to, simplices }]: the bins of r/l, the last one open (null).
Json histogram(const QualityStatistics& quality);

/// { below{5 10 15} inner_below{5 10 15} histogram[{ from to angles }] }: simplices with an angle below so many
/// degrees, those of them that have an inner vertex, and all angles in bins.
Json to_json(const AngleCensus& angles);

/// Of the final complex, 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);
/// The largest amount of memory that the process has had.
std::uint64_t peak_memory_bytes();

/// The text of the file.
std::string to_text(const Json& report);

}  // namespace sinkmesh::program
