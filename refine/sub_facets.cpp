// SPDX-License-Identifier: MIT
#include "refine/sub_facets.h"

#include <algorithm>

namespace sinkmesh {

template <int Dim>
SubFacet SubFacets<Dim>::add(const Record& record) {
  std::uint32_t slot = static_cast<std::uint32_t>(records_.size());
  if (free_.empty()) {
    records_.push_back(record);
  } else {
    slot = free_.back();
    free_.pop_back();
    records_[slot] = record;
  }
  records_[slot].birth = ++births_;
  const SubFacet f(slot);
  if constexpr (Dim == 2) {
    edges_[key_of(record.corners[0], record.corners[1])] = slot;
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = static_cast<std::uint32_t>(3 * slot + k);
      const auto [entry, is_new] = edges_.try_emplace(key_opposite(f, k), side);
      std::uint32_t& next = records_[slot].next[k];
      next = side;
      if (!is_new) std::swap(next, records_[entry->second / 3].next[entry->second % 3]);
    }
  }
  return f;
}

template <int Dim>
void SubFacets<Dim>::remove(SubFacet f) {
  Record& record = records_[f.index()];
  if constexpr (Dim == 2) {
    edges_.erase(key_of(record.corners[0], record.corners[1]));
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = static_cast<std::uint32_t>(3 * f.index() + k);
      const auto entry = edges_.find(key_opposite(f, k));
      std::uint32_t before = side;
      while (records_[before / 3].next[before % 3] != side) before = records_[before / 3].next[before % 3];
      if (before == side) {
        edges_.erase(entry);
      } else {
        records_[before / 3].next[before % 3] = record.next[k];
        entry->second = before;
      }
    }
  }
  record.owner = kNone;
  free_.push_back(f.index());
}

template <int Dim>
SubFacet SubFacets<Dim>::find_edge(Vertex u, Vertex v) const {
  const auto entry = edges_.find(key_of(u, v));
  if (entry == edges_.end()) return {};
  return SubFacet(Dim == 2 ? entry->second : entry->second / 3);
}

template <int Dim>
SubFacet SubFacets<Dim>::find(const Corners& corners) const {
  if constexpr (Dim == 2) {
    return find_edge(corners[0], corners[1]);
  } else {
    const auto entry = edges_.find(key_of(corners[0], corners[1]));
    if (entry == edges_.end()) return {};
    std::uint32_t side = entry->second;
    do {
      if (records_[side / 3].corners[side % 3] == corners[2]) return SubFacet(side / 3);
      side = records_[side / 3].next[side % 3];
    } while (side != entry->second);
    return {};
  }
}

template <int Dim>
auto SubFacets<Dim>::around(Vertex u, Vertex v) const -> std::vector<Side> {
  std::vector<Side> result;
  const auto entry = edges_.find(key_of(u, v));
  if (entry == edges_.end()) return result;
  std::uint32_t side = entry->second;
  do {
    result.push_back({SubFacet(side / 3), side % 3});
    side = records_[side / 3].next[side % 3];
  } while (side != entry->second);
  return result;
}

template <int Dim>
std::uint32_t SubFacets<Dim>::segment_of(Vertex u, Vertex v) const {
  const auto entry = edges_.find(key_of(u, v));
  if (entry == edges_.end()) return kNone;
  if constexpr (Dim == 2) return records_[entry->second].owner;
  return records_[entry->second / 3].segment[entry->second % 3];
}

template class SubFacets<2>;
template class SubFacets<3>;

}  // namespace sinkmesh
