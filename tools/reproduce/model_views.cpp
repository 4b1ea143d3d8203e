// SPDX-License-Identifier: MIT
#include "tools/reproduce/model_views.h"

#include <array>
#include <string>

#include "predicates/error.h"

namespace sinkmesh::reproduce {
namespace {

struct ModelViews {
  std::string_view model;
  View surface;
  Cut cut;
  View inside;
};

// The cuboctahedron is about the origin; the paraboloid stands on its tip, with its lid at z = 1; star and head have
// the z axis as their axis, from 0 to 4, and are shown lying.
const std::array<ModelViews, 4> kModels = {{
    {"cuboctahedron",
     {{1, -2.2, 1.1}, {0, 0, 1}, 25},
     {{0, -1, 0}, {0, 0, 0}},
     {{0.35, -2, 0.6}, {0, 0, 1}, 25}},
    {"paraboloid", {{0.4, -2, 0.9}, {0, 0, 1}, 25}, {{0, -1, 0}, {0, 0, 0}}, {{0.35, -2, 0.6}, {0, 0, 1}, 25}},
    {"star", {{1.4, 0.7, 1.3}, {0, 1, 0}, 25}, {{0, 0, 1}, {0, 0, 2}}, {{0.7, 0.45, 1.6}, {0, 1, 0}, 25}},
    {"head", {{1.1, 0.7, 1.5}, {0, 1, 0}, 25}, {{0, 0, 1}, {0, 0, 2}}, {{0.7, 0.45, 1.6}, {0, 1, 0}, 25}},
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

}  // namespace sinkmesh::reproduce
