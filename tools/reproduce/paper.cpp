// SPDX-License-Identifier: MIT
#include "tools/reproduce/paper.h"

#include <algorithm>
#include <array>
#include <string>

#include "predicates/error.h"

namespace sinkmesh::reproduce {
namespace {

using enum Insert;
using enum Schedule;

constexpr std::array<PaperRow, 4> kUsa = {{
    {sink, block, 879, {}, 0.58, 0.76, 2.58, {}},
    {circumcenter, block, 941, {}, 0.58, 0.75, 3.54, {}},
    {sink, incremental, 841, {}, 0.58, 0.77, 3.06, {}},
    {circumcenter, incremental, 997, {}, 0.58, 0.76, 3.54, {}},
}};
constexpr std::array<PaperRow, 2> kCuboctahedron = {{
    {sink, parallel, 15948, {}, 0.63, 1.27, 2.00, 6},
    {circumcenter, parallel, 15066, {}, 0.64, 1.29, 2.00, 121},
}};
constexpr std::array<PaperRow, 2> kParaboloid = {{
    {sink, parallel, 14793, {}, 0.65, 1.24, 2.00, 7},
    {circumcenter, parallel, 13639, {}, 0.64, 1.28, 2.00, 176},
}};
constexpr std::array<PaperRow, 2> kStar = {{
    {sink, parallel, 118633, 481, 0.62, 1.27, 2.11, 12},
    {circumcenter, parallel, 119442, 1867, 0.63, 1.27, 2.17, 58},
}};
constexpr std::array<PaperRow, 2> kHead = {{
    {sink, parallel, 190269, 245, 0.62, 1.24, 2.21, 38},
    {circumcenter, parallel, 183027, 104, 0.62, 1.27, 2.15, 177},
}};

const std::array<PaperModel, 5> kModels = {{
    {"usa", 7, {}, {229, {}, 0.61, 2.36, 17.23}, kUsa},
    {"cuboctahedron", 8, PaperSurface{7496, 0.58, 0.70, 1.05}, {14670, {}, 0.71, 7.29, 22.80}, kCuboctahedron},
    {"paraboloid", 9, PaperSurface{6272, 0.58, 0.80, 1.31}, {10050, {}, 0.87, 18.77, 90.75}, kParaboloid},
    {"star", 10, PaperSurface{53508, 0.578, 1.315, 1.601}, {78114, 58147, 0.68, 2.40, 14.09}, kStar},
    {"head", 11, PaperSurface{67940, 0.577, 1.206, 1.601}, {100454, 79238, 0.67, 4.11, 8.67}, kHead},
}};

}  // namespace

const PaperModel& paper_model(std::string_view model) {
  const auto found =
      std::find_if(kModels.begin(), kModels.end(), [&](const PaperModel& m) { return m.model == model; });
  if (found == kModels.end()) throw InputError("the paper has no model '" + std::string(model) + "'");
  return *found;
}

}  // namespace sinkmesh::reproduce
