// SPDX-License-Identifier: MIT
#include "tools/program/improvement_account.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

std::string_view phrase(SliverReason reason) {
  switch (reason) {
    case SliverReason::untried:
      return "not tried: the run ended before";
    case SliverReason::boundary_vertices:
      return "with all vertices on the boundary";
    case SliverReason::no_better_place:
      return "for whose vertices no better place was found";
  }
  return "";
}

template <int Dim>
std::size_t number_of(const std::vector<Sliver<Dim>>& slivers, SliverReason reason) {
  return static_cast<std::size_t>(std::count_if(
      slivers.begin(), slivers.end(), [reason](const Sliver<Dim>& sliver) { return sliver.reason == reason; }));
}

}  // namespace

Json to_json(const CoarsenResult& coarsening) {
  return {{"tried", coarsening.tried}, {"removed", coarsening.removed}};
}

template <int Dim>
Json to_json(const SliverResult& moving, const std::vector<Sliver<Dim>>& slivers) {
  constexpr std::size_t kMaxListed = 1000;
  Json remaining = {{"total", slivers.size()}};
  for (const SliverReason reason : kSliverReasons) remaining[name(reason)] = number_of(slivers, reason);
  Json list = Json::array();
  for (const Sliver<Dim>& sliver : slivers) {
    if (list.size() == kMaxListed) break;
    list.push_back({{"corners", sliver.corners}, {"angle", sliver.angle}, {"reason", name(sliver.reason)}});
  }
  return {{"tried", moving.tried},
          {"moved", moving.moved},
          {"removed", moving.removed},
          {"inserted", moving.inserted},
          {"cost_before", moving.cost_before},
          {"cost_after", moving.cost_after},
          {"remaining", remaining},
          {"list", list}};
}

template <int Dim>
void add_improvement(Summary& summary, const Improvement& improvement, bool coarsens, bool moves,
                     const std::vector<Sliver<Dim>>& slivers) {
  if (coarsens) {
    summary.line("coarsened",
                 fmt::format("{} taken away", count(improvement.coarsening.removed, "point", "points")));
  }
  if (!moves) return;
  const SliverResult& moving = improvement.moving;
  summary.line("moved", fmt::format("{}; {} taken away, {} added", count(moving.moved, "point", "points"),
                                    grouped(moving.removed), grouped(moving.inserted)));
  if (slivers.empty()) return;
  summary.line("slivers", fmt::format("{} left:", grouped(slivers.size())));
  for (const SliverReason reason : kSliverReasons) {
    const std::size_t number = number_of(slivers, reason);
    if (number != 0) summary.line("", fmt::format("{:>9} {}", grouped(number), phrase(reason)));
  }
}

template Json to_json(const SliverResult&, const std::vector<Sliver<2>>&);
template Json to_json(const SliverResult&, const std::vector<Sliver<3>>&);
template void add_improvement(Summary&, const Improvement&, bool, bool, const std::vector<Sliver<2>>&);
template void add_improvement(Summary&, const Improvement&, bool, bool, const std::vector<Sliver<3>>&);

}  // namespace sinkmesh::program
