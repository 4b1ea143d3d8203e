// SPDX-License-Identifier: MIT
#include "tools/program/boundary_account.h"

#include <fmt/format.h>

#include "tools/program/surface_input.h"
#include "tools/program/text.h"

namespace sinkmesh::program {
namespace {

// As { "segment": [3, 8] }; null where there is none.
Json to_json(const BoundaryFeature& feature) {
  using Kind = BoundaryFeature::Kind;
  if (feature.kind == Kind::none) return {};
  Json ids = Json::array({feature.ids[0]});
  if (feature.kind == Kind::segment) ids.push_back(feature.ids[1]);
  return {{name(feature.kind), ids}};
}

std::string points_put(std::size_t on_segments, std::size_t on_patches, int dim) {
  std::string text = fmt::format("{} on segments", count(on_segments, "point", "points"));
  if (dim == 3) text += fmt::format(", {} on patches", grouped(on_patches));
  return text;
}

}  // namespace

Json to_json(const BoundaryResult& boundary, const RefineResult& result) {
  return {{"mode", name(boundary.mode)},
          {"regions", boundary.regions},
          {"patches", boundary.patches},
          {"joined_facets", boundary.joined_facets},
          {"segments", boundary.segments},
          {"points_on_segments", boundary.points_on_segments},
          {"points_on_patches", boundary.points_on_patches},
          {"unconformed", boundary.unconformed},
          {"refine_points_on_segments", result.points_on_segments},
          {"refine_points_on_patches", result.points_on_patches}};
}

template <int Dim>
Json to_json(const std::vector<Leftover<Dim>>& leftovers) {
  constexpr std::size_t kMaxListed = 1000;
  Json list = Json::array();
  for (const Leftover<Dim>& leftover : leftovers) {
    if (list.size() == kMaxListed) break;
    list.push_back({{"corners", leftover.corners},
                    {"ratio", leftover.ratio},
                    {"reason", name(leftover.reason)},
                    {"first", to_json(leftover.first)},
                    {"second", to_json(leftover.second)},
                    {"common", to_json(leftover.common)}});
  }
  return list;
}

Json to_json(const Remaining& remaining) {
  Json json = {{"total", remaining.total()}};
  for (const LeftoverReason reason : kLeftoverReasons) json[name(reason)] = remaining.count(reason);
  return json;
}

void add_boundary(Summary& summary, const BoundaryResult& boundary, const RefineResult& result,
                  BoundaryMode asked, std::size_t facets, int dim) {
  if (boundary.mode == BoundaryMode::fixed) {
    if (boundary.peeled_simplices == 0) {
      summary.line("boundary", "kept as given: it is stable");
      return;
    }
    summary.line(
        "boundary",
        fmt::format("kept as given, but {} with {} of it were peeled off, from which the flow leads out",
                    simplices(boundary.peeled_simplices, dim),
                    count(boundary.peeled_facets, "facet", "facets")));
    summary.line("", "--boundary refine loses nothing");
    return;
  }
  summary.line("boundary", asked == BoundaryMode::refine
                               ? "divided where that was needed"
                               : "divided where that was needed: as given it was not stable");
  if (dim == 3) {
    summary.line("", fmt::format("{} in {}, with {} between them", count(facets, "facet", "facets"),
                                 count(boundary.patches, "patch", "patches"),
                                 count(boundary.segments, "segment", "segments")));
  }
  summary.line("", fmt::format("to conform: {}",
                               points_put(boundary.points_on_segments, boundary.points_on_patches, dim)));
  summary.line(
      "", fmt::format("for quality: {}", points_put(result.points_on_segments, result.points_on_patches, dim)));
}

std::string failure_line(const BoundaryResult& boundary, const std::string& path, const SourceLines& lines,
                         std::size_t facets, const std::string& hint) {
  if (boundary.unconformed.empty()) {
    return FileError(
               path,
               fmt::format("{} before its facets were divided into Delaunay ones ({} on it so far): no mesh is "
                           "written; {}",
                           boundary.stop == Stop::budget ? "the limit was reached" : "stopped on request",
                           count(boundary.points_on_segments + boundary.points_on_patches, "point", "points"),
                           boundary.stop == Stop::budget ? "raise --max-vertices or --time-limit"
                                                         : "let it run longer"))
        .what();
  }
  const std::uint32_t first = boundary.unconformed.front();
  const std::string message = fmt::format(
      "{} of {} could not be divided into Delaunay ones, the first is facet {}: no mesh is written; look there "
      "for parts of the surface that nearly touch, or meet at a tiny angle{}",
      grouped(boundary.unconformed.size()), count(facets, "facet", "facets"), first, hint);
  return error_at(path, lines.facet(first), message).what();
}

template Json to_json(const std::vector<Leftover<2>>&);
template Json to_json(const std::vector<Leftover<3>>&);

}  // namespace sinkmesh::program
