// SPDX-License-Identifier: MIT
#include "tools/reproduce/model_views.h"

#include <array>
#include <cmath>
#include <string>

#include "predicates/error.h"

namespace sinkmesh::reproduce {
namespace {

struct ModelViews {
  std::string_view model;
  View surface;
  Cut cut;
  View inside;
  double height;  // of a picture, as a part of its width
};

// The cuboctahedron is about the origin; the paraboloid stands on its tip, with its lid at z = 1; star and head
// have the z axis as their axis, from 0 to 4, and are shown lying.
const std::array<ModelViews, 4> kModels = {{
    {.model = "cuboctahedron",
     .surface = {{1, -2.2, 1.1}, {0, 0, 1}},
     .cut = {{0, -1, 0}, {0, 0, 0}},
     .inside = {{0.45, -2, 0.75}, {0, 0, 1}},
     .height = 0.78},
    {.model = "paraboloid",
     .surface = {{0.4, -2, 0.85}, {0, 0, 1}},
     .cut = {{0, -1, 0}, {0, 0, 0}},
     .inside = {{0.35, -2, 0.6}, {0, 0, 1}},
     .height = 0.62},
    // No fin is seen edge-on: they are at multiples of 360/11 degrees.
    {.model = "star",
     .surface = {{1.25, 0.95, 1.4}, {0, 1, 0}},
     .cut = {{0, 0, 1}, {0, 0, 2}},
     .inside = {{0.58, 0.68, 1.6}, {0, 1, 0}},
     .height = 0.78},
    {.model = "head",
     .surface = {{1.0, 0.75, 1.6}, {0, 1, 0}},
     .cut = {{0, 0, 1}, {0, 0, 2}},
     .inside = {{0.58, 0.68, 1.6}, {0, 1, 0}},
     .height = 0.78},
}};

const ModelViews& views(std::string_view model) {
  for (const ModelViews& views : kModels) {
    if (views.model == model) return views;
  }
  throw InputError("no view is known of a model '" + std::string(model) + "'");
}

}  // namespace

View view_of(std::string_view model) { return views(model).surface; }
Cut cut_of(std::string_view model) { return views(model).cut; }
View cut_view_of(std::string_view model) { return views(model).inside; }

int picture_height(std::string_view model, int width) {
  return static_cast<int>(std::lround(views(model).height * width));
}

}  // namespace sinkmesh::reproduce
