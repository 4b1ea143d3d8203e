// SPDX-License-Identifier: MIT
#include "refine/patch_triangulation.h"

#include <algorithm>
#include <unordered_set>

#include "predicates/predicates.h"

namespace sinkmesh {

using Kind = Feature::Kind;

void PatchTriangulation::divide(const SubSegment& sub_segment, Vertex x, std::vector<SubFacet>& created) {
  const auto first = static_cast<std::ptrdiff_t>(created.size());
  boundary_->divide_edge(sub_segment.u, sub_segment.v, x, created);
  flip_from({created.begin() + first, created.end()}, created);
}

void PatchTriangulation::divide(SubFacet f, std::size_t k, Vertex x, std::vector<SubFacet>& created) {
  const auto first = static_cast<std::ptrdiff_t>(created.size());
  if (k < 3) {
    boundary_->divide_edge(boundary_->sub_facets()[f].corners[(k + 1) % 3],
                           boundary_->sub_facets()[f].corners[(k + 2) % 3], x, created);
  } else {
    const auto record = boundary_->sub_facets()[f];
    boundary_->remove(f);
    for (std::size_t j = 0; j < 3; ++j) {
      auto third = record;
      third.corners[j] = x;
      third.segment = {SubFacets<3>::kNone, SubFacets<3>::kNone, SubFacets<3>::kNone};
      third.segment[j] = record.segment[j];
      created.push_back(boundary_->add(third));
    }
  }
  flip_from({created.begin() + first, created.end()}, created);
}

// ------------------------------------------------------------------------------------------------
//  Flips within a patch.

/// A side ab of two sub-facets of one patch, with the corners c and d opposite it: abc and bad are
/// counterclockwise, and so are adc and dbc, which take their place.
struct PatchTriangulation::Diagonal {
  SubFacet first;   // abc
  SubFacet second;  // bad
  Vertex a, b, c, d;
};

Point2 PatchTriangulation::projected(SubFacet f, Vertex v) const {
  return boundary_->features().patches()[boundary_->sub_facets()[f].owner].plane.project(complex().point(v));
}

auto PatchTriangulation::diagonal(SubFacet f, std::size_t k) const -> std::optional<Diagonal> {
  const auto& record = boundary_->sub_facets()[f];
  if (record.segment[k] != SubFacets<3>::kNone) return std::nullopt;
  const auto other = boundary_->sub_facets().across(f, k);
  if (other.facet.is_null()) return std::nullopt;
  const Diagonal diagonal{f,
                          other.facet,
                          record.corners[(k + 1) % 3],
                          record.corners[(k + 2) % 3],
                          record.corners[k],
                          boundary_->sub_facets()[other.facet].corners[other.k]};
  const auto is_counterclockwise = [&](Vertex p, Vertex q, Vertex r) {
    return orient2d(projected(f, p), projected(f, q), projected(f, r)) > 0;
  };
  const auto is_on_one_segment = [&](Vertex p, Vertex q, Vertex r) {
    for (const Vertex v : {p, q, r}) {
      const Feature on = boundary_->features().vertex(v).on;
      if (on.kind != Kind::segment) continue;
      return boundary_->features().is_on_segment(p, on.id) && boundary_->features().is_on_segment(q, on.id) &&
             boundary_->features().is_on_segment(r, on.id);
    }
    return false;
  };
  const auto& [first, second, a, b, c, d] = diagonal;
  for (const auto& [p, q, r] : {std::array{a, d, c}, std::array{d, b, c}}) {
    if (!is_counterclockwise(p, q, r) || is_on_one_segment(p, q, r)) return std::nullopt;
  }
  return diagonal;
}

bool PatchTriangulation::should_flip(const Diagonal& diagonal) {
  const auto& [first, second, a, b, c, d] = diagonal;
  const auto is_encroached = [&](Vertex p, Vertex q, Vertex r, Vertex by) {
    const Complex<3>& k = complex();
    return boundary_->triangulation().predicates().diametral_side({&k.point(p), &k.point(q), &k.point(r)},
                                                                  k.point(by)) < 0;
  };
  const bool is_old_bad = is_encroached(a, b, c, d) || is_encroached(b, a, d, c);
  if (!is_old_bad && !boundary_->is_missing(first) && !boundary_->is_missing(second)) return false;
  const bool is_new_bad = is_encroached(a, d, c, b) || is_encroached(d, b, c, a);
  if (is_old_bad != is_new_bad) return is_old_bad;
  if (!boundary_->is_missing(first) && !boundary_->is_missing(second)) return false;
  return !boundary_->star_walk().find_facet(complex(), {a, d, c}).is_null() &&
         !boundary_->star_walk().find_facet(complex(), {d, b, c}).is_null();
}

void PatchTriangulation::exchange(const Diagonal& diagonal, std::vector<SubFacet>& created) {
  const auto& [first, second, a, b, c, d] = diagonal;
  const auto one = boundary_->sub_facets()[first];
  const auto two = boundary_->sub_facets()[second];
  const auto segment_of = [](const auto& record, Vertex opposite) {
    const auto at = std::find(record.corners.begin(), record.corners.end(), opposite);
    return record.segment[static_cast<std::size_t>(at - record.corners.begin())];
  };
  auto with_a = one;
  with_a.corners = {a, d, c};
  with_a.segment = {SubFacets<3>::kNone, segment_of(one, b), segment_of(two, b)};
  auto with_b = one;
  with_b.corners = {d, b, c};
  with_b.segment = {segment_of(one, a), SubFacets<3>::kNone, segment_of(two, a)};
  boundary_->remove(first);
  boundary_->remove(second);
  created.push_back(boundary_->add(with_a));
  created.push_back(boundary_->add(with_b));
}

bool PatchTriangulation::flip(SubFacet f, std::size_t k, std::vector<SubFacet>& created) {
  const std::optional<Diagonal> found = diagonal(f, k);
  if (found) exchange(*found, created);
  return found.has_value();
}

// Ends: for points that are exactly coplanar, a flipped edge never comes back, because each flip lowers the
// lifted surface. Where rounding breaks that, the list of retired edges enforces it, and there are finitely
// many edges.
bool PatchTriangulation::flip_from(std::vector<SubFacet> stack, std::vector<SubFacet>& created) {
  struct PairHash {
    std::size_t operator()(const std::pair<Vertex, Vertex>& e) const {
      return static_cast<std::size_t>(mix(std::uint64_t{e.first.slot()} << 32 | e.second.slot()));
    }
  };
  std::unordered_set<std::pair<Vertex, Vertex>, PairHash> retired;
  const auto edge = [](Vertex u, Vertex v) { return std::pair(std::min(u, v), std::max(u, v)); };
  bool has_flipped = false;
  while (!stack.empty()) {
    const SubFacet f = stack.back();
    stack.pop_back();
    for (std::size_t k = 0; k < 3 && boundary_->sub_facets().is_alive(f); ++k) {
      const std::optional<Diagonal> found = diagonal(f, k);
      if (!found || retired.contains(edge(found->c, found->d)) || !should_flip(*found)) continue;
      retired.insert(edge(found->a, found->b));
      exchange(*found, created);
      stack.push_back(created.back());
      stack.push_back(created[created.size() - 2]);
      has_flipped = true;
      break;
    }
  }
  return has_flipped;
}

void PatchTriangulation::flip_all() {
  std::vector<SubFacet> stack;
  std::vector<SubFacet> created;
  boundary_->sub_facets().for_each([&](SubFacet f) { stack.push_back(f); });
  flip_from(std::move(stack), created);
}

// ------------------------------------------------------------------------------------------------
//  Walks within a patch.

// Through the first side that separates the sub-facet from the point. Ends, because in a patch that is Delaunay
// in its plane the powers of the point go up; where it is not, after as many steps as there are sub-facets.
auto PatchTriangulation::walk(SubFacet f, const Point2& x) const -> std::optional<Location> {
  for (std::size_t steps = 0; steps <= boundary_->sub_facets().size(); ++steps) {
    Location at{f, 3, {}};
    int on = 0;
    bool is_beyond = false;  // a barrier
    SubFacet next;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& record = boundary_->sub_facets()[f];
      const Vertex u = record.corners[(k + 1) % 3];
      const Vertex v = record.corners[(k + 2) % 3];
      const int side = orient2d(projected(f, u), projected(f, v), x);
      if (side > 0) continue;
      const bool is_barrier = record.segment[k] != SubFacets<3>::kNone;
      // Beyond one sub-segment the point may still be on the line of another.
      if (is_barrier && (!at.barrier || (side < 0 && !is_beyond)))
        at.barrier = SubSegment{u, v, record.segment[k]};
      is_beyond = is_beyond || (is_barrier && side < 0);
      if (side < 0 && !is_barrier && next.is_null()) next = boundary_->sub_facets().across(f, k).facet;
      if (side == 0) {
        ++on;
        at.side = k;
      }
    }
    if (next.is_null()) {
      if (!at.barrier && on > 1) return std::nullopt;
      return at;
    }
    f = next;
  }
  return std::nullopt;
}

}  // namespace sinkmesh
