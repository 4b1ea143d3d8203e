// SPDX-License-Identifier: MIT
//
// The incremental schedule: the most urgent simplex first, its points one after the other [EG01, 4.5].
#include "refine/refiner.h"
#include "refine/urgency_queue.h"

namespace sinkmesh {

template <int Dim>
void Refiner<Dim>::run_incremental(bool divides_boundary) {
  constexpr std::size_t kInsertionsPerRound = 256;
  UrgencyQueue queue([this](const UrgencyEntry& e) {
    return tie(e.simplex, shape<Dim>(inserter_.complex().corners(e.simplex)));
  });
  inserter_.on_low_quality = [&](Simplex s, const Shape& shape) {
    queue.push({priority(shape), s, inserter_.birth(s)});
  };
  if (inserter_.num_simplices() == 0) {
    inserter_.measure_all();
  } else {
    for (const Simplex s : inserter_.low_quality()) {
      if (!inserter_.is_excused(s)) inserter_.on_low_quality(s, shape<Dim>(inserter_.complex().corners(s)));
    }
  }
  const auto is_current = [&](const UrgencyEntry& e) { return inserter_.is_current(e.simplex, e.birth); };

  std::vector<UrgencyEntry> stuck;
  begin_round();
  for (bool retry = true; retry && !is_stopped();) {
    UrgencyEntry entry;
    while (queue.pop(entry, is_current) && may_continue()) {
      if (!insert_for(entry.simplex) && !(divides_boundary && divide_for(entry.simplex))) {
        stuck.push_back(entry);
      } else if (is_current(entry)) {
        queue.push(entry);
      }
      if (num_inserted() - inserted_before_round_ >= kInsertionsPerRound) {
        end_round();
        begin_round();
      }
    }
    // Points inserted for others may have turned the flow of a simplex to another sink. Each retry begins with
    // one that is not rejected, so it inserts or rejects.
    retry = false;
    std::erase_if(stuck, [&](const UrgencyEntry& e) {
      if (!is_current(e)) return true;
      if (!has_candidate(e.simplex)) return false;
      queue.push(e);
      return retry = true;
    });
  }
  end_round();
  inserter_.on_low_quality = nullptr;
}

template <int Dim>
bool Refiner<Dim>::insert_point_of(Simplex owner, bool own_center) {
  if (inserter_.is_rejected(owner)) return false;
  ++round_.candidates;
  Candidate<Dim> candidate;
  return make_candidate(owner, own_center, candidate) && try_insert(candidate);
}

template <int Dim>
bool Refiner<Dim>::insert_for(Simplex s) {
  return visit_owners(s, [this](Simplex owner) { return insert_point_of(owner, false); }) ||
         (has_fallback() && insert_point_of(s, true));
}

template <int Dim>
bool Refiner<Dim>::has_candidate(Simplex s) {
  return (has_fallback() && !inserter_.is_rejected(s)) ||
         visit_owners(s, [this](Simplex owner) { return !inserter_.is_rejected(owner); });
}

template void Refiner<2>::run_incremental(bool);
template void Refiner<3>::run_incremental(bool);

}  // namespace sinkmesh
