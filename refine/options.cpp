// SPDX-License-Identifier: MIT
#include "refine/options.h"

namespace sinkmesh {

const char* name(Insert insert) { return insert == Insert::sink ? "sink" : "circumcenter"; }

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
    case Stop::budget:
      return "budget";
    case Stop::cancelled:
      return "cancelled";
  }
  return "";
}

}  // namespace sinkmesh
