// SPDX-License-Identifier: MIT
#include "tools/reproduce/cut.h"

#include <algorithm>

#include "core/vector.h"

namespace sinkmesh::reproduce {
namespace {

using Triple = std::array<std::uint32_t, 3>;

// Faces of a positively oriented tetrahedron, opposite its corners, counterclockwise seen from outside.
constexpr std::array<std::array<std::size_t, 3>, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

struct HalfFace {
  Triple key;        // the corners in ascending order: equal for both sides
  std::uint32_t id;  // four times the simplex, plus the opposite corner

  friend auto operator<=>(const HalfFace&, const HalfFace&) = default;
};

Triple corners(const Mesh3& mesh, std::uint32_t id) {
  const auto& simplex = mesh.simplices[id / 4];
  const auto& face = kFaces[id % 4];
  return {simplex[face[0]], simplex[face[1]], simplex[face[2]]};
}

}  // namespace

bool Cut::keeps(const Point3& p) const { return dot(normal, p - through) <= 0; }

std::vector<bool> kept_simplices(const Mesh3& mesh, const Cut& cut) {
  std::vector<bool> kept;
  kept.reserve(mesh.simplices.size());
  for (const auto& simplex : mesh.simplices) {
    Point3 centroid{};
    for (const std::uint32_t v : simplex) {
      for (std::size_t k = 0; k < 3; ++k) centroid[k] += mesh.points[v][k] / 4;
    }
    kept.push_back(cut.keeps(centroid));
  }
  return kept;
}

std::vector<VisibleFace> visible_faces(const Mesh3& mesh, const std::vector<bool>& kept) {
  std::vector<HalfFace> half_faces;
  half_faces.reserve(4 * mesh.simplices.size());
  for (std::uint32_t id = 0; id < 4 * mesh.simplices.size(); ++id) {
    Triple key = corners(mesh, id);
    std::sort(key.begin(), key.end());
    half_faces.push_back({key, id});
  }
  std::sort(half_faces.begin(), half_faces.end());

  std::vector<std::uint32_t> seen;  // half-faces; twice the id, plus whether it has a mate
  for (std::size_t i = 0; i < half_faces.size();) {
    const bool has_mate = i + 1 < half_faces.size() && half_faces[i].key == half_faces[i + 1].key;
    const bool first = kept[half_faces[i].id / 4];
    const bool second = has_mate && kept[half_faces[i + 1].id / 4];
    if (first != second) seen.push_back(2 * half_faces[first ? i : i + 1].id + (has_mate ? 1 : 0));
    i += has_mate ? 2 : 1;
  }
  std::sort(seen.begin(), seen.end());

  std::vector<VisibleFace> result;
  result.reserve(seen.size());
  for (const std::uint32_t code : seen) {
    const std::uint32_t id = code / 2;
    result.push_back({corners(mesh, id), id / 4, code % 2 == 1});
  }
  return result;
}

}  // namespace sinkmesh::reproduce
