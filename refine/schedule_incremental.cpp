// SPDX-License-Identifier: MIT
//
// The incremental schedule: the worst simplex first, its points one after the other [EG01, 4.5].
#include "refine/refiner.h"
#include "refine/worst_first_queue.h"

namespace sinkmesh {

template <int Dim>
void Refiner<Dim>::run_incremental(bool divides_boundary) {
  constexpr std::size_t kInsertionsPerRound = 256;
  WorstFirstQueue queue;
  inserter_.on_low_quality = [&](Simplex s, double ratio2) {
    queue.push({ratio2, inserter_.tie(s), s, inserter_.birth(s)});
  };
  for (const Simplex s : inserter_.low_quality()) {
    if (!inserter_.is_excused(s))
      inserter_.on_low_quality(s, shape<Dim>(inserter_.complex().corners(s)).ratio2());
  }
  const auto is_current = [&](const WorstFirstQueue::Entry& e) {
    return inserter_.is_current(e.simplex, e.birth);
  };

  std::vector<WorstFirstQueue::Entry> stuck;
  begin_round();
  for (bool retry = true; retry && !is_stopped();) {
    WorstFirstQueue::Entry entry;
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
    std::erase_if(stuck, [&](const WorstFirstQueue::Entry& e) {
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
bool Refiner<Dim>::insert_center_of(Simplex s) {
  if (inserter_.is_rejected(s)) return false;
  ++round_.candidates;
  Candidate<Dim> candidate;
  if (!inserter_.make_candidate(s, candidate)) return false;
  const bool inserted = inserter_.insert(candidate) == Verdict::inserted;
  round_.passed_boundary += inserted ? 1 : 0;
  return inserted;
}

template <int Dim>
bool Refiner<Dim>::insert_for(Simplex s) {
  if (options_.insert == Insert::circumcenter) return insert_center_of(s);
  if (visit_sinks(s, [this](Simplex sink) { return insert_center_of(sink); })) return true;
  return options_.fallback == Fallback::circumcenter && insert_center_of(s);
}

template <int Dim>
bool Refiner<Dim>::has_candidate(Simplex s) {
  if (options_.insert == Insert::circumcenter) return !inserter_.is_rejected(s);
  if (options_.fallback == Fallback::circumcenter && !inserter_.is_rejected(s)) return true;
  return visit_sinks(s, [this](Simplex sink) { return !inserter_.is_rejected(sink); });
}

template void Refiner<2>::run_incremental(bool);
template void Refiner<3>::run_incremental(bool);

}  // namespace sinkmesh
