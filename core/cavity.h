// SPDX-License-Identifier: MIT
//
// The prestar of a point: found once, then tested, and replaced by the star or left alone [EG01, 4.1].
#pragma once

#include <cstdint>

#include "core/complex.h"
#include "core/conflict.h"

namespace sinkmesh {

/// What a guide says about a facet that the search for a prestar wants to cross.
enum class Passage : std::uint8_t {
  pass,  ///< test the simplex beyond
  wall,  ///< the simplex beyond is not in the prestar, whatever its sphere
  stop,  ///< give up the search
};

/// Lets a search go everywhere. Other guides have the same two members.
struct FreeGuide {
  /// A simplex has been found to be in the prestar, entered through its half-facet `entry`; the apex of entry
  /// may be new to the closure of the prestar. Not called for the first simplex. Returns false to give up the
  /// search.
  bool enter(HalfFacet entry) {
    (void)entry;
    return true;
  }
  /// The search wants to cross from half-facet `inner` of a simplex in the prestar to its mate.
  Passage cross(HalfFacet inner, HalfFacet outer) {
    (void)inner, (void)outer;
    return Passage::pass;
  }
};

/// The Dim-simplices of the prestar of a point, and the facets between them and the rest. Working memory of one
/// search after the other: keep one and reuse it.
///
/// Between grow() and the next StarLinker::substitute() or release() the complex carries the marks of the
/// prestar, and no other operation that changes it is allowed.
template <int Dim>
class Cavity {
 public:
  /// One facet of the boundary of the prestar.
  struct Facet {
    std::uint32_t outer;  ///< half-facet of the simplex that stays
    std::uint32_t inner;  ///< its mate, of the simplex in the prestar
  };

  /// Finds the simplices in conflict with x that can be reached from `start` through shared facets: the prestar
  /// is connected [EG01, 4.1], so without walls these are all of it.
  ///
  /// @param start  a simplex in conflict with x (not checked).
  /// @param guide  is asked at every step; see FreeGuide.
  /// @return false if the guide gave up: the complex is then as before, and the cavity holds what was found.
  /// @throws std::bad_alloc; the complex is then as before.
  ///
  /// Cost: one conflict test for each facet of the boundary and each simplex of the prestar.
  template <class Guide>
  bool grow(Complex<Dim>& complex, const Predicates<Dim>& predicates, const Point<Dim>& x, Simplex start,
            Guide&& guide);
  void grow(Complex<Dim>& complex, const Predicates<Dim>& predicates, const Point<Dim>& x, Simplex start) {
    grow(complex, predicates, x, start, FreeGuide());
  }

  /// Clears the marks: the complex is as it was before grow().
  void release(Complex<Dim>& complex) const;

  /// Simplices of the prestar, in the order in which the search met them, `start` first.
  std::size_t num_simplices() const { return members_.size(); }
  Simplex simplex(std::size_t i) const { return Simplex(members_[i] / Complex<Dim>::kCorners); }

  std::size_t num_facets() const { return facets_.size(); }
  const Facet& facet(std::size_t i) const { return facets_[i]; }

  /// After StarLinker::substitute(): the simplex of the star on facet(i).
  Simplex star(std::size_t i) const { return Simplex(star_[i]); }

 private:
  template <int>
  friend class StarLinker;

  void make_room(Complex<Dim>& complex);

  detail::PodArray<std::uint32_t> members_;  // each the half-facet through which the search entered its simplex
  detail::PodArray<Facet> facets_;
  detail::PodArray<std::uint32_t> star_;
};

template <int Dim>
template <class Guide>
bool Cavity<Dim>::grow(Complex<Dim>& complex, const Predicates<Dim>& predicates, const Point<Dim>& x,
                       Simplex start, Guide&& guide) {
  constexpr std::uint32_t kCorners = Complex<Dim>::kCorners;
  constexpr std::uint32_t kMark = Complex<Dim>::kMark;
  typename Complex<Dim>::Record* const records = complex.records().data();

  members_.clear();
  facets_.clear();
  members_.push_back(start.index() * kCorners);
  records[start.index()].corner[0] |= kMark;
  std::size_t num_members = 1;
  std::size_t num_facets = 0;

  // Marks one record and pushes to both lists without a branch on the outcome of the test, which is a coin
  // toss.
  const auto test = [&](HalfFacet inner, std::uint32_t outer) {
    const std::uint32_t s = outer / kCorners;
    std::uint32_t conflict = 0;
    const Passage passage = guide.cross(inner, HalfFacet(outer));
    if (passage == Passage::pass) [[likely]] {
      conflict = in_conflict(complex, predicates, Simplex(s), x) ? 1 : 0;
    } else if (passage == Passage::stop) {
      return false;
    }
    facets_.data()[num_facets] = {outer, inner.index()};
    num_facets += conflict ^ 1;
    members_.data()[num_members] = outer;
    num_members += conflict;
    records[s].corner[0] |= conflict << 31;
    return true;
  };
  const auto visit = [&](std::uint32_t s, std::uint32_t i) {
    const std::uint32_t outer = records[s].mate[i];
    if (records[outer / kCorners].corner[0] & kMark) return true;
    return test(HalfFacet(s * kCorners + i), outer);
  };

  bool finished = true;
  for (std::size_t head = 0; head < num_members && finished; ++head) {
    if (num_members + kCorners > members_.capacity() || num_facets + kCorners > facets_.capacity()) {
      members_.resize(num_members);
      facets_.resize(num_facets);
      make_room(complex);
    }
    if (head + 2 < num_members) {
      for (const std::uint32_t mate : records[members_.data()[head + 2] / kCorners].mate) {
        __builtin_prefetch(&records[mate / kCorners]);
      }
    }
    const std::uint32_t entry = members_.data()[head];
    const std::uint32_t s = entry / kCorners;
    if (head != 0) finished = guide.enter(HalfFacet(entry));
    // The facet of entry leads back into the prestar; the first simplex was not entered through one.
    for (std::uint32_t i = 0; i < kCorners && finished; ++i) {
      if (i != entry % kCorners || head == 0) finished = visit(s, i);
    }
  }
  members_.resize(num_members);
  facets_.resize(num_facets);
  if (!finished) release(complex);
  return finished;
}

template <int Dim>
void Cavity<Dim>::make_room(Complex<Dim>& complex) {
  try {
    members_.reserve(2 * members_.size() + 64);
    facets_.reserve(2 * facets_.size() + 64);
  } catch (...) {
    release(complex);
    throw;
  }
}

template <int Dim>
void Cavity<Dim>::release(Complex<Dim>& complex) const {
  for (const std::uint32_t member : members_) {
    complex.records()[member / Complex<Dim>::kCorners].corner[0] &= ~Complex<Dim>::kMark;
  }
}

}  // namespace sinkmesh
