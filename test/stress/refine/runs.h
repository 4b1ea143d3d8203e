// SPDX-License-Identifier: MIT
//
// What the suites of stress_refine have in common: one run after the other, each looked at from outside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "refine/refine.h"
#include "test/stress/case.h"
#include "test/stress/refine/mesh_view.h"
#include "test/stress/suite.h"

namespace sinkmesh::stress {

/// Counters::named of all suites here.
enum RunCounter : std::size_t {
  kRefused,      ///< with a reason that the options or the surface allow
  kUnconformed,  ///< facets given up
  kDivided,      ///< meshed with a boundary that was divided
  kBarred,       ///< leftovers that the boundary bars, looked at
  kStopped,      ///< ended by a budget or on request
  kFloor,        ///< ended by the floor
  kLeft,         ///< with simplices of low quality left
  kImproved      ///< with points that have been moved, added or taken away after refinement
};
std::vector<NamedCounter> run_counters(bool is_stopped);

/// When a run is told to end: after how many polls, and with what.
struct Stopper {
  std::uint64_t polls_left = 0;
  Continue answer = Continue::yes;
  bool has_answered = false;

  Continue poll() {
    if (answer == Continue::yes || polls_left-- != 0) return Continue::yes;
    polls_left = 0;
    has_answered = true;
    return answer;
  }
};

/// One surface through the mesher, with every promise checked on the way.
template <int Dim>
class CheckedRun {
 public:
  CheckedRun(const Surface<Dim>& surface, Counters& counters, bool has_normals = true)
      : surface_(surface), counters_(&counters) {
    promise_.has_normals = has_normals;
  }

  /// @return whether there is a domain.
  /// @throws CheckFailed
  bool find_domain(RefineOptions options, std::shared_ptr<Stopper> stopper = {});
  /// @throws CheckFailed
  void refine(RefineOptions options, std::shared_ptr<Stopper> stopper = {});
  /// After refine(): as far as the options ask for it.
  /// @throws CheckFailed
  void improve(RefineOptions options, std::shared_ptr<Stopper> stopper = {});

  /// Of everything that it did: equal for the same input.
  std::string summary() const { return summary_; }
  std::uint64_t hash() const { return mesher_ ? mesher_->hash() : 0; }
  const Promise& promise() const { return promise_; }
  Mesh<Dim> mesh() const { return mesher_->mesh(); }

 private:
  void refused(const std::string& message, const RefineOptions& options);
  void expect_stop(Stop stop, const RefineOptions& options, const Stopper* stopper) const;
  void expect_known_mesh(const Mesh<Dim>& mesh, Schedule schedule);
  void note(const std::string& what) { summary_ += what + "; "; }

  Surface<Dim> surface_;
  Counters* counters_;
  std::unique_ptr<SurfaceMesher<Dim>> mesher_;
  Promise promise_;
  std::string summary_;
};

/// The surface of a case, with tags if it says so.
template <int Dim>
Surface<Dim> tagged_surface_of(const Case& c);

/// Generous: a run that small angles blow up ends by it.
template <int Dim>
std::size_t most_vertices(const Surface<Dim>& surface) {
  return surface.points.size() + (Dim == 2 ? 2000 : 800);
}

}  // namespace sinkmesh::stress
