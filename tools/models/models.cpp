// SPDX-License-Identifier: MIT
#include "tools/models/models.h"

namespace sinkmesh::models {
namespace {

constexpr Model kModels[] = {
    {"usa", "the outline of the contiguous United States", 229, &make_usa},
    {"cuboctahedron", "blobs at the vertices of a cuboctahedron", 7496, &make_cuboctahedron},
    {"paraboloid", "a paraboloid with a flat lid", 6272, &make_paraboloid},
    {"star", "the star-shaped cavity of a rocket motor", 53508, &make_star},
    {"head", "the propellant around that cavity", 67940, &make_head},
};

}  // namespace

std::span<const Model> all_models() { return kModels; }

const Model* find_model(std::string_view name) {
  for (const Model& model : kModels) {
    if (model.name == name) return &model;
  }
  return nullptr;
}

}  // namespace sinkmesh::models
