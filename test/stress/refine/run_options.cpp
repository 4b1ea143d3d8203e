// SPDX-License-Identifier: MIT
#include "test/stress/refine/run_options.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace sinkmesh::stress {
namespace {

constexpr std::array kInserts{Insert::sink, Insert::circumcenter, Insert::off_sink};
constexpr std::array kOrders{Order::ratio, Order::shortest, Order::smallest};
constexpr std::array kSchedules{Schedule::incremental, Schedule::block, Schedule::parallel};
constexpr std::array kModes{BoundaryMode::refine, BoundaryMode::automatic, BoundaryMode::fixed};
constexpr const char* kDefault = "default";

template <class T, std::size_t N>
T by_name(const std::array<T, N>& all, std::string_view wanted) {
  for (const T x : all) {
    if (wanted == name(x)) return x;
  }
  throw CaseError("there is no '" + std::string(wanted) + "'");
}

}  // namespace

void draw_options(Random& random, int dim, Case& c) {
  const Insert insert = kInserts[random() % 3];
  const Schedule schedule = kSchedules[random() % 3];
  c.set("insert", name(insert));
  const auto order = random() % 6;
  c.set("order", order < 3 ? name(kOrders[order]) : kDefault);
  c.set("schedule", name(schedule));
  // Most surfaces are not stable as given, so that many a run with a fixed boundary ends before it starts.
  const auto mode = random() % 8;
  c.set("boundary", name(kModes[mode < 4 ? 0 : mode < 6 ? 1 : 2]));
  const bool usual = random() % 2 == 0;
  c.set("ratio-thousandths",
        usual ? (dim == 2 ? 1000U : 2000U)
              : static_cast<unsigned>(test::uniform_int(random, 1000, dim == 2 ? 2000 : 3000)));
  c.set("small-angle-tenths",
        random() % 2 == 0 ? 0U : static_cast<unsigned>(test::uniform_int(random, 150, 600)));
  constexpr std::array<unsigned, 4> kFlatBits{42, 42, 0, 30};
  c.set("flat-bits", kFlatBits[random() % 4]);
  c.set("reach-thousandths",
        random() % 2 == 0 ? 0U : static_cast<unsigned>(test::uniform_int(random, 1000, 2000)));
  const bool may_be_literal = insert != Insert::off_sink && schedule != Schedule::incremental;
  c.set("literal", may_be_literal && random() % 4 == 0 ? 1U : 0U);
  c.set("fallback", random() % 2);
  c.set("tags", random() % 2);
  c.set("coarsen", random() % 4 == 0 ? 1U : 0U);
  c.set("slivers", random() % 3 == 0 ? 1U : 0U);
  c.set("min-dihedral-tenths",
        random() % 2 == 0 ? 0U : static_cast<unsigned>(test::uniform_int(random, 10, dim == 2 ? 450 : 300)));
}

RefineOptions options_of(const Case& c) {
  RefineOptions options;
  options.insert = by_name(kInserts, c.setting("insert"));
  if (c.setting("order") != kDefault) options.order = by_name(kOrders, c.setting("order"));
  options.schedule = by_name(kSchedules, c.setting("schedule"));
  options.boundary.mode = by_name(kModes, c.setting("boundary"));
  options.max_ratio = static_cast<double>(c.number_setting("ratio-thousandths")) / 1000;
  if (const auto angle = c.number_setting("small-angle-tenths"); angle != 0) {
    options.boundary.small_angle = static_cast<double>(angle) / 10;
  }
  const auto bits = static_cast<int>(c.number_setting("flat-bits"));
  options.boundary.flat = bits == 0 ? 0 : std::ldexp(1.0, -bits);
  if (const auto reach = c.number_setting("reach-thousandths"); reach != 0) {
    options.reach = static_cast<double>(reach) / 1000;
  }
  options.literal = c.number_setting("literal") != 0;
  options.fallback = c.number_setting("fallback") != 0 ? Fallback::circumcenter : Fallback::none;
  options.coarsen = c.number_setting("coarsen") != 0;
  options.slivers = c.number_setting("slivers") != 0;
  if (const auto angle = c.number_setting("min-dihedral-tenths"); angle != 0) {
    options.min_dihedral = static_cast<double>(angle) / 10;
  }
  return options;
}

bool has_valid_options(const Case& c) {
  try {
    require_valid(options_of(c));
    return true;
  } catch (const CaseError&) {
    return false;
  } catch (const std::invalid_argument&) {  // InputError, too
    return false;
  }
}

}  // namespace sinkmesh::stress
