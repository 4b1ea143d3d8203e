// SPDX-License-Identifier: MIT
//
// The schedules that work in rounds: block and parallel [EG01, 4.5].
#include <algorithm>

#include "refine/refiner.h"
#include "refine/sphere_set.h"

namespace sinkmesh {
namespace {

template <int Dim>
typename SphereSet<Dim>::Sphere sphere_of(const Candidate<Dim>& candidate) {
  using Exact = std::optional<std::array<Point<Dim>, Dim + 1>>;
  return {candidate.point, candidate.radius2, candidate.is_center ? Exact(candidate.corners) : Exact()};
}

}  // namespace

// A round without an insertion has rejected all its candidates for as long as their simplices live, and nothing
// has changed: what is left are those that fell together with others, which are fewer, and those of the
// fallback.
template <int Dim>
void Refiner<Dim>::run_rounds() {
  bool own_centers = options_.insert == Insert::circumcenter;
  while (!is_stopped()) {
    const std::vector<Candidate<Dim>> candidates = collect(own_centers);
    const std::size_t before = num_inserted();
    if (!candidates.empty()) {
      if (!may_continue()) return;
      begin_round();
      if (options_.literal) {
        insert_literally(candidates);
      } else if (options_.schedule == Schedule::block) {
        insert_block(candidates);
      } else {
        insert_independent(candidates);
      }
      end_round();
    }
    if (!candidates.empty() && num_inserted() > before) {
      own_centers = options_.insert == Insert::circumcenter;
    } else if (num_merged_ > 0) {
      continue;
    } else if (own_centers || !has_fallback()) {
      return;
    } else {
      own_centers = true;
    }
  }
}

// The points of the simplices of low quality, or of the sinks that their flow reaches; of those that fall
// together one, but in the paper's rounds all: there the choice drops the others. The largest circumradius
// first, but off-sinks in the order of the simplices for which they are.
template <int Dim>
std::vector<Candidate<Dim>> Refiner<Dim>::collect(bool own_centers) {
  std::vector<Simplex> low = inserter_.low_quality();
  std::erase_if(low, [this](Simplex s) { return inserter_.is_excused(s); });
  const bool at_sinks = options_.insert == Insert::sink && !own_centers;
  std::vector<Candidate<Dim>> candidates;
  for (const Simplex s : at_sinks ? flow_->sinks_reached(low) : low) {
    if (!inserter_.domain().is_inside(s)) continue;
    if (!options_.literal && inserter_.is_rejected(s)) continue;
    Candidate<Dim> candidate;
    if (!make_candidate(s, own_centers, candidate)) continue;
    if (!candidate.is_center) {
      const Shape owner = shape<Dim>(inserter_.complex().corners(s));
      candidate.priority = priority(owner);
      candidate.tie = ~tie(s, owner);  // here the smallest comes first
    }
    candidates.push_back(candidate);
  }
  const auto comes_before = [](const Candidate<Dim>& a, const Candidate<Dim>& b) {
    if (a.priority != b.priority) return a.priority > b.priority;
    return a.tie != b.tie ? a.tie < b.tie : a.corners < b.corners;
  };
  num_merged_ = 0;
  if (!own_centers && !options_.literal) {
    std::sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
      return a.point != b.point ? a.point < b.point : comes_before(a, b);
    });
    const auto end = std::unique(candidates.begin(), candidates.end(),
                                 [](const auto& a, const auto& b) { return a.point == b.point; });
    num_merged_ = static_cast<std::size_t>(candidates.end() - end);
    candidates.erase(end, candidates.end());
  }
  std::sort(candidates.begin(), candidates.end(), comes_before);
  return candidates;
}

// Whether an off-sink has lost its owner to another point of the round.
template <int Dim>
bool Refiner<Dim>::is_needless(const Candidate<Dim>& candidate) const {
  return !candidate.is_center && !inserter_.is_current(candidate.owner, candidate.owner_birth);
}

// A maximal set of candidates whose spheres are mutually orthogonal or further. One that passes the boundary
// test is inserted at once: the test of a later one then sees the complex with it, which changes no verdict
// (SteinerInserter), and its own simplex may be gone, but not the sphere. Of off-sinks the spheres reach to the
// nearest vertices.
template <int Dim>
void Refiner<Dim>::insert_block(const std::vector<Candidate<Dim>>& candidates) {
  SphereSet<Dim> block(inserter_.triangulation().predicates());
  for (const Candidate<Dim>& candidate : candidates) {
    if (is_needless(candidate)) continue;
    if (!may_continue()) return;
    ++round_.candidates;
    const typename SphereSet<Dim>::Sphere sphere = sphere_of(candidate);
    if (!block.is_orthogonal_to_all(sphere)) {
      ++dependent_;
    } else if (try_insert(candidate)) {
      block.add(sphere);
    }
  }
}

template <int Dim>
void Refiner<Dim>::take(Vertex v) {
  if (v.slot() >= taken_.size()) taken_.resize(inserter_.complex().vertices().capacity(), 0);
  taken_[v.slot()] = result_.rounds;
}

// A maximal set of candidates with disjoint closed prestars, pruned: verdicts are cached (collect), a search
// stops at the first vertex that is taken, and a point is inserted as soon as it is chosen.
//
// The set is that of the literal rounds. Closures are disjoint iff they share no vertex. If the closed prestars
// of x and y are disjoint, inserting y leaves that of x as it is. If they share a vertex, and y has been
// inserted, then the prestar of x is met with a vertex of the closed star of y in its closure: x and y are
// dependent whichever is looked at in the presence of the other [EG01, 4.4].
template <int Dim>
void Refiner<Dim>::insert_independent(const std::vector<Candidate<Dim>>& candidates) {
  for (const Candidate<Dim>& candidate : candidates) {
    if (is_needless(candidate)) continue;
    if (!may_continue()) return;
    ++round_.candidates;
    if (!inserter_.is_current(candidate.simplex, candidate.birth)) {
      ++dependent_;
    } else if (inserter_.insert(candidate, [this](Vertex v) { return is_taken(v); }) == Verdict::inserted) {
      ++round_.passed_boundary;
      inserter_.visit_closed_star([this](Vertex v) { take(v); });
    }
  }
}

// The paper's round: first the prestar and the boundary test of every candidate, then the choice, then the
// insertions.
template <int Dim>
void Refiner<Dim>::insert_literally(const std::vector<Candidate<Dim>>& candidates) {
  struct Passed {
    const Candidate<Dim>* candidate;
    std::vector<Vertex> closure;  // of the prestar
  };
  std::vector<Passed> passed;
  std::vector<Vertex> closure;
  for (const Candidate<Dim>& candidate : candidates) {
    if (!may_continue()) return;
    ++round_.candidates;
    if (inserter_.test(candidate, closure) == Verdict::inserted) passed.push_back({&candidate, closure});
  }
  round_.passed_boundary = passed.size();

  SphereSet<Dim> block(inserter_.triangulation().predicates());
  const auto admits = [&](const Passed& p) {
    if (options_.schedule == Schedule::block) return block.is_orthogonal_to_all(sphere_of(*p.candidate));
    return std::none_of(p.closure.begin(), p.closure.end(), [this](Vertex v) { return is_taken(v); });
  };
  std::vector<const Candidate<Dim>*> chosen;
  for (const Passed& p : passed) {
    if (!admits(p)) {
      ++dependent_;
      continue;
    }
    if (options_.schedule == Schedule::block) {
      block.add(sphere_of(*p.candidate));
    } else {
      std::for_each(p.closure.begin(), p.closure.end(), [this](Vertex v) { take(v); });
    }
    chosen.push_back(p.candidate);
  }
  for (const Candidate<Dim>* candidate : chosen) {
    if (!may_continue()) return;
    inserter_.insert(*candidate);
  }
}

template void Refiner<2>::run_rounds();
template void Refiner<3>::run_rounds();

}  // namespace sinkmesh
