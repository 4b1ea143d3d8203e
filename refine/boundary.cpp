// SPDX-License-Identifier: MIT
#include "refine/boundary.h"

#include <algorithm>

#include "refine/patches.h"
#include "refine/ridge_uses.h"

namespace sinkmesh {
namespace {

// One segment for each facet.
std::vector<SubFacets<2>::Record> make_records(const Complex<2>&, std::span<const std::array<Vertex, 2>> facets,
                                               std::span<const std::int64_t>, double,
                                               BoundaryFeatures<2>& features) {
  std::vector<SubFacets<2>::Record> records(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    records[f].corners = facets[f];
    records[f].owner = features.add_segment(facets[f][0], facets[f][1]);
    records[f].parent = f;
  }
  return records;
}

// Patches, and the segments between them.
std::vector<SubFacets<3>::Record> make_records(const Complex<3>& complex,
                                               std::span<const std::array<Vertex, 3>> facets,
                                               std::span<const std::int64_t> tags, double flat,
                                               BoundaryFeatures<3>& features) {
  std::vector<BoundaryFeatures<3>::Patch> patches;
  const std::vector<PlacedFacet> placed = without_needles(complex, facets, tags, flat);
  const std::vector<PatchFacet> of_facet = find_patches(complex, placed, tags, flat, patches);

  std::vector<SubFacets<3>::Record> records(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    records[f].corners = of_facet[f].vertices;
    records[f].owner = of_facet[f].patch;
    records[f].parent = placed[f].parent;
    records[f].segment.fill(SubFacets<3>::kNone);
  }
  const auto corners_of = [&](std::size_t f) -> const std::array<Vertex, 3>& { return records[f].corners; };
  for_each_ridge<3>(records.size(), corners_of, [&](auto first, auto last) {
    if (last - first == 2 && records[first[0].facet].owner == records[first[1].facet].owner) return;
    const std::uint32_t segment = features.add_segment(first->ridge[0], first->ridge[1]);
    for (auto use = first; use != last; ++use) {
      records[use->facet].segment[use->k] = segment;
      patches[records[use->facet].owner].segments.push_back(segment);
    }
  });
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (const Vertex v : records[f].corners) patches[records[f].owner].corners.push_back(v);
  }
  const auto make_set = [](auto& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  for (auto& patch : patches) {
    make_set(patch.segments);
    make_set(patch.corners);
    features.add_patch(std::move(patch));
  }
  return records;
}

}  // namespace

template <int Dim>
Boundary<Dim>::Boundary(const Triangulation<Dim>& triangulation, Domain<Dim>& domain,
                        std::span<const Facet> facets, std::span<const HalfFacet> found,
                        std::span<const std::int64_t> tags, double flat)
    : triangulation_(&triangulation), domain_(&domain), features_(triangulation.complex()) {
  for (const Facet& facet : facets) {
    for (const Vertex v : facet) features_.set_corner(v);
  }
  const auto records = make_records(complex(), facets, tags, flat, features_);
  const auto sorted = [](Facet facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  for (std::size_t f = 0; f < records.size(); ++f) {
    if (sorted(records[f].corners) == sorted(facets[f])) {
      place(sub_facets_.add(canonical(records[f])), found[f]);
    } else {
      add(records[f]);
    }
  }
}

template <int Dim>
FacetCorners<Dim> Boundary<Dim>::corner_points(SubFacet f) const {
  FacetCorners<Dim> points;
  for (std::size_t k = 0; k < Dim; ++k) points[k] = &complex().point(sub_facets_[f].corners[k]);
  return points;
}

template <int Dim>
std::vector<Vertex> Boundary<Dim>::encroaching_apexes(SubFacet f) const {
  std::vector<Vertex> result;
  const HalfFacet h = sub_facets_[f].at;
  for (const HalfFacet side : {h, complex().mate(h)}) {
    const Vertex apex = complex().apex(side);
    if (apex.is_infinite()) continue;
    if (triangulation_->predicates().diametral_side(corner_points(f), complex().point(apex)) < 0) {
      result.push_back(apex);
    }
  }
  return result;
}

template <int Dim>
bool Boundary<Dim>::has_edge(Vertex u, Vertex v) {
  if constexpr (Dim == 3) {
    for (const auto& side : sub_facets_.around(u, v)) {
      if (!is_missing(side.facet)) return true;
    }
  }
  return star_walk_.has_edge(complex(), u, v);
}

template <int Dim>
std::vector<SubSegment> Boundary<Dim>::sub_segments(SubFacet f) const {
  const auto& record = sub_facets_[f];
  if constexpr (Dim == 2) {
    return {{record.corners[0], record.corners[1], record.owner}};
  } else {
    std::vector<SubSegment> result;
    for (std::size_t k = 0; k < 3; ++k) {
      if (record.segment[k] == SubFacets<3>::kNone) continue;
      result.push_back({record.corners[(k + 1) % 3], record.corners[(k + 2) % 3], record.segment[k]});
    }
    return result;
  }
}

template <int Dim>
std::vector<typename Domain<Dim>::Wall> Boundary<Dim>::walls() const {
  std::vector<typename Domain<Dim>::Wall> result;
  sub_facets_.for_each([&](SubFacet f) { result.push_back({sub_facets_[f].at, sub_facets_[f].parent}); });
  return result;
}

template <int Dim>
BoundaryFeature Boundary<Dim>::describe(const Feature& feature) const {
  using Kind = BoundaryFeature::Kind;
  switch (feature.kind) {
    case Feature::Kind::interior:
      break;
    case Feature::Kind::corner:
      return {Kind::corner, {feature.id, 0}};
    case Feature::Kind::segment: {
      const auto& ends = features_.segments()[feature.id].ends;
      return {Kind::segment, {ends[0].index(), ends[1].index()}};
    }
    case Feature::Kind::patch:
      return {Kind::patch, {features_.patches()[feature.id].facet, 0}};
  }
  return {};
}

template <int Dim>
void Boundary<Dim>::restore(const Snapshot& snapshot) {
  features_ = snapshot.features;
  sub_facets_ = snapshot.sub_facets;
  sub_facets_.for_each(
      [this](SubFacet f) { place(f, star_walk_.find_facet(complex(), sub_facets_[f].corners)); });
}

template <int Dim>
void Boundary<Dim>::before_insertion(const Cavity<Dim>& cavity) {
  touched_.clear();
  for (std::size_t i = 0; i < cavity.num_simplices(); ++i) {
    for (int k = 0; k <= Dim; ++k) {
      const HalfFacet h = Complex<Dim>::half_facet(cavity.simplex(i), k);
      if (!domain_->is_wall(h)) continue;
      const SubFacet f = at(h);
      if (is_missing(f)) continue;  // met from its other side
      sub_facets_.set_at(f, {});
      touched_.push_back(f);
    }
  }
}

template <int Dim>
const std::vector<SubFacet>& Boundary<Dim>::after_insertion(const Cavity<Dim>& cavity) {
  for (std::size_t i = 0; i < cavity.num_facets(); ++i) {
    const HalfFacet outer(cavity.facet(i).outer);
    domain_->clear_walls(cavity.star(i));
    if (!domain_->is_wall(outer)) continue;
    domain_->add_wall(complex().mate(outer));
    sub_facets_.set_at(at(outer), outer);
  }
  return touched_;
}

template <int Dim>
void Boundary<Dim>::place(SubFacet f, HalfFacet at) {
  sub_facets_.set_at(f, at);
  if (at.is_null()) return;
  domain_->add_wall(at);
  domain_->add_wall(complex().mate(at));
}

// The same sub-facet with its least corner first: loops over corners then go by geometry.
template <int Dim>
auto Boundary<Dim>::canonical(typename SubFacets<Dim>::Record record) const -> typename SubFacets<Dim>::Record {
  if constexpr (Dim == 3) {
    const auto least =
        std::min_element(record.corners.begin(), record.corners.end(),
                         [this](Vertex a, Vertex b) { return complex().point(a) < complex().point(b); });
    const auto shift = least - record.corners.begin();
    std::rotate(record.corners.begin(), least, record.corners.end());
    std::rotate(record.segment.begin(), record.segment.begin() + shift, record.segment.end());
  }
  return record;
}

template <int Dim>
SubFacet Boundary<Dim>::add(const typename SubFacets<Dim>::Record& record) {
  const SubFacet f = sub_facets_.add(canonical(record));
  place(f, star_walk_.find_facet(complex(), record.corners));
  return f;
}

template <int Dim>
void Boundary<Dim>::remove(SubFacet f) {
  const HalfFacet h = sub_facets_[f].at;
  if (!h.is_null()) {
    domain_->remove_wall(h);
    domain_->remove_wall(complex().mate(h));
  }
  sub_facets_.remove(f);
}

// Every sub-facet at the edge becomes two. Their sides along the edge keep its segment, if it has one.
template <int Dim>
void Boundary<Dim>::divide_edge(Vertex u, Vertex v, Vertex x, std::vector<SubFacet>& created) {
  std::vector<typename SubFacets<Dim>::Record> old;
  if constexpr (Dim == 2) {
    old.push_back(sub_facets_[sub_facets_.find_edge(u, v)]);
    remove(sub_facets_.find_edge(u, v));
  } else {
    for (const auto& side : sub_facets_.around(u, v)) {
      old.push_back(sub_facets_[side.facet]);
      remove(side.facet);
    }
  }
  for (const auto& record : old) {
    const auto number = [&](Vertex w) {
      return static_cast<std::size_t>(std::find(record.corners.begin(), record.corners.end(), w) -
                                      record.corners.begin());
    };
    for (const auto& [replaced, kept] : {std::pair(u, v), std::pair(v, u)}) {
      auto half = record;
      half.corners[number(replaced)] = x;
      if constexpr (Dim == 3) half.segment[number(kept)] = SubFacets<3>::kNone;
      created.push_back(add(half));
    }
  }
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace sinkmesh
