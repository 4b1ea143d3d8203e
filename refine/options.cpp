// SPDX-License-Identifier: MIT
#include "refine/options.h"

#include <string>

#include "predicates/error.h"

namespace sinkmesh {

void require_valid(const RefineOptions& options) {
  if (!(options.max_ratio >= 1)) {
    throw InputError("max_ratio is " + std::to_string(options.max_ratio) +
                     ": it must be at least 1, or refinement need not end");
  }
  const double angle = options.boundary.small_angle.value_or(BoundaryOptions::kSmallAngle3);
  if (!(angle > 0 && angle <= 60)) {
    throw InputError("small_angle is " + std::to_string(angle) + ": it must be above 0 and at most 60 degrees");
  }
  if (!(options.boundary.flat >= 0 && options.boundary.flat < 1)) {
    throw InputError("flat is " + std::to_string(options.boundary.flat) +
                     ": it must be at least 0 and below 1, a fraction of the diagonal of the bounding box");
  }
  if (options.reach && !(*options.reach >= 1)) {
    throw InputError("reach is " + std::to_string(*options.reach) +
                     ": it must be at least 1, or the simplices of an off-sink are of low quality again");
  }
  if (!(options.min_dihedral > 0 && options.min_dihedral <= 45)) {
    throw InputError("min_dihedral is " + std::to_string(options.min_dihedral) +
                     ": it must be above 0 and at most 45 degrees");
  }
  if (options.literal && options.insert == Insert::off_sink) {
    throw InputError("literal rounds exist for sinks and circumcenters only");
  }
  if (options.literal && options.schedule == Schedule::incremental) {
    throw InputError("literal rounds exist in the block and parallel schedules only");
  }
}

std::size_t& Remaining::count(LeftoverReason reason) {
  switch (reason) {
    case LeftoverReason::small_angle:
      return small_angle;
    case LeftoverReason::boundary_facet:
      return boundary_facet;
    case LeftoverReason::boundary:
      return boundary;
    case LeftoverReason::crossing:
      return crossing;
    case LeftoverReason::separation:
      return separation;
    case LeftoverReason::omega:
      return omega;
    case LeftoverReason::untried:
      break;
  }
  return untried;
}

std::size_t Remaining::count(LeftoverReason reason) const { return Remaining(*this).count(reason); }

const char* name(Insert insert) {
  switch (insert) {
    case Insert::sink:
      return "sink";
    case Insert::circumcenter:
      return "circumcenter";
    case Insert::off_sink:
      return "offsink";
  }
  return "";
}

const char* name(Order order) {
  switch (order) {
    case Order::ratio:
      return "ratio";
    case Order::shortest:
      return "shortest";
    case Order::smallest:
      return "smallest";
  }
  return "";
}

const char* name(Schedule schedule) {
  switch (schedule) {
    case Schedule::incremental:
      return "incremental";
    case Schedule::block:
      return "block";
    case Schedule::parallel:
      return "parallel";
  }
  return "";
}

const char* name(Stop stop) {
  switch (stop) {
    case Stop::no_candidate:
      return "no_candidate";
    case Stop::floor:
      return "floor";
    case Stop::budget:
      return "budget";
    case Stop::cancelled:
      return "cancelled";
  }
  return "";
}

const char* name(BoundaryMode mode) {
  switch (mode) {
    case BoundaryMode::automatic:
      return "auto";
    case BoundaryMode::fixed:
      return "fixed";
    case BoundaryMode::refine:
      return "refine";
  }
  return "";
}

const char* name(LeftoverReason reason) {
  switch (reason) {
    case LeftoverReason::boundary_facet:
      return "boundary_facet";
    case LeftoverReason::boundary:
      return "boundary";
    case LeftoverReason::crossing:
      return "crossing";
    case LeftoverReason::separation:
      return "separation";
    case LeftoverReason::omega:
      return "omega";
    case LeftoverReason::small_angle:
      return "small_angle";
    case LeftoverReason::untried:
      return "untried";
  }
  return "";
}

const char* name(BoundaryFeature::Kind kind) {
  switch (kind) {
    case BoundaryFeature::Kind::none:
      return "none";
    case BoundaryFeature::Kind::corner:
      return "corner";
    case BoundaryFeature::Kind::segment:
      return "segment";
    case BoundaryFeature::Kind::patch:
      return "patch";
  }
  return "";
}

}  // namespace sinkmesh
