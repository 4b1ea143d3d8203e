// SPDX-License-Identifier: MIT
//
// Which facets have boxes that meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/point.h"

namespace sinkmesh {

/// Without branches: either answer is likely.
template <int Dim>
bool boxes_meet(const Box<Dim>& a, const Box<Dim>& b) {
  bool apart = false;
  for (std::size_t k = 0; k < Dim; ++k) {
    apart |= a.low[k] > b.high[k];
    apart |= b.low[k] > a.high[k];
  }
  return !apart;
}

template <int Dim>
struct BoxOfFacet {
  Box<Dim> box;
  std::uint32_t facet = 0;
};

/// The boxes of facets, to be searched for those that meet a box: a bounding-volume hierarchy for each class of
/// sizes, so that large facets do not swell the boxes over small ones.
///
/// A node's box contains the boxes of all facets below it, and its last_facet is the largest id there; so a
/// search that skips a node misses nothing.
/// Cost: O(n log n) to build; a search, about log n for each class of sizes, and what it finds. Memory linear.
template <int Dim>
class BoxForest {
 public:
  explicit BoxForest(const std::vector<BoxOfFacet<Dim>>& facets) {
    std::vector<Entry> entries;
    entries.reserve(facets.size());
    for (std::uint32_t i = 0; i < facets.size(); ++i) entries.push_back(entry(facets[i].box, i));
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.size_class < b.size_class; });
    leaves_.reserve(facets.size());
    for (auto first = entries.begin(); first != entries.end();) {
      const auto last = std::find_if(first, entries.end(),
                                     [&](const Entry& other) { return other.size_class != first->size_class; });
      add_tree(facets, {first, last});
      first = last;
    }
  }

  /// Calls visit(facet) for every facet of larger id whose box meets that of `query`.
  template <class Visit>
  void for_each_larger_id(const BoxOfFacet<Dim>& query, Visit visit) const {
    for (std::size_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      if (node.last_facet <= query.facet || !boxes_meet<Dim>(node.box, query.box)) {
        n = node.next;
        continue;
      }
      for (std::uint32_t i = node.first_leaf; i < node.end_leaf; ++i) {
        const BoxOfFacet<Dim>& leaf = leaves_[i];
        if (leaf.facet > query.facet && boxes_meet<Dim>(leaf.box, query.box)) visit(leaf.facet);
      }
      ++n;
    }
  }

 private:
  // In the order of a depth-first traversal, in which `next` is where it goes on without the nodes below.
  struct Node {
    Box<Dim> box;
    std::uint32_t last_facet = 0;
    std::uint32_t next = 0;
    std::uint32_t first_leaf = 0;  // none for inner nodes
    std::uint32_t end_leaf = 0;
  };
  // What the facets are ordered by: rounding does no harm.
  struct Entry {
    std::array<float, Dim> middle;
    int size_class;
    std::uint32_t facet;  // index into the list of facets
  };
  static constexpr std::ptrdiff_t kLeafSize = 4;
  static constexpr int kSizeBits = 3;  // sizes of a class differ by a factor below 2^kSizeBits

  static Entry entry(const Box<Dim>& box, std::uint32_t facet) {
    Entry result{{}, 0, facet};
    double size = 0;
    for (std::size_t k = 0; k < Dim; ++k) {
      result.middle[k] = static_cast<float>(0.5 * (box.low[k] + box.high[k]));
      size = std::max(size, box.high[k] - box.low[k]);
    }
    result.size_class = (std::ilogb(size) + 1024) / kSizeBits;
    return result;
  }

  // Halves at the median of the coordinate that varies most, down to a few facets.
  void add_tree(const std::vector<BoxOfFacet<Dim>>& facets, std::span<Entry> entries) {
    const std::size_t n = nodes_.size();
    nodes_.emplace_back();
    Node node;
    if (std::ssize(entries) <= kLeafSize) {
      node.first_leaf = static_cast<std::uint32_t>(leaves_.size());
      for (const Entry& e : entries) {
        const BoxOfFacet<Dim>& facet = facets[e.facet];
        leaves_.push_back(facet);
        enlarge(node, facet.box, facet.facet);
      }
      node.end_leaf = static_cast<std::uint32_t>(leaves_.size());
    } else {
      const std::size_t axis = widest_axis(entries);
      const std::size_t half = entries.size() / 2;
      std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half), entries.end(),
                       [axis](const Entry& a, const Entry& b) { return a.middle[axis] < b.middle[axis]; });
      for (const std::span<Entry> part : {entries.first(half), entries.subspan(half)}) {
        const std::size_t child = nodes_.size();
        add_tree(facets, part);
        enlarge(node, nodes_[child].box, nodes_[child].last_facet);
      }
    }
    node.next = static_cast<std::uint32_t>(nodes_.size());
    nodes_[n] = node;
  }

  static void enlarge(Node& node, const Box<Dim>& box, std::uint32_t facet) {
    node.box.include(box.low);
    node.box.include(box.high);
    node.last_facet = std::max(node.last_facet, facet);
  }

  static std::size_t widest_axis(std::span<const Entry> entries) {
    std::array<float, Dim> low = entries.front().middle;
    std::array<float, Dim> high = low;
    for (const Entry& e : entries) {
      for (std::size_t k = 0; k < Dim; ++k) {
        low[k] = std::min(low[k], e.middle[k]);
        high[k] = std::max(high[k], e.middle[k]);
      }
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < Dim; ++k) {
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    }
    return axis;
  }

  std::vector<Node> nodes_;
  std::vector<BoxOfFacet<Dim>> leaves_;
};

}  // namespace sinkmesh
