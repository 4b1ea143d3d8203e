// SPDX-License-Identifier: MIT
#include "tools/program/report.h"

#include <fmt/format.h>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace sinkmesh::program {

Json begin_report(const std::string& command) {
  return {{"program", "sinkmesh"}, {"version", SINKMESH_VERSION}, {"command", command}};
}

Json to_json(int dim, std::size_t vertices, const QualityStatistics& quality) {
  return {
      {"vertices", vertices},
      {"simplices", quality.simplices()},
      {"low_quality", quality.low_quality()},
      {"ratio", {{"min", quality.min_ratio()}, {"avg", quality.average_ratio()}, {"max", quality.max_ratio()}}},
      {dim == 2 ? "angle" : "dihedral", {{"min", quality.min_angle()}, {"max", quality.max_angle()}}}};
}

Json histogram(const QualityStatistics& quality) {
  Json bins = Json::array();
  for (std::size_t i = 0; i < QualityStatistics::kBins.size(); ++i) {
    const bool open = i + 1 == QualityStatistics::kBins.size();
    bins.push_back(
        {{"up_to", open ? Json() : Json(QualityStatistics::kBins[i])}, {"simplices", quality.histogram()[i]}});
  }
  return bins;
}

Json to_json(const AngleCensus& angles) {
  Json json = {{"below", Json::object()}, {"inner_below", Json::object()}, {"histogram", Json::array()}};
  for (std::size_t i = 0; i < AngleCensus::kSmall.size(); ++i) {
    const std::string degrees = fmt::format("{:g}", AngleCensus::kSmall[i]);
    json["below"][degrees] = angles.below(i);
    json["inner_below"][degrees] = angles.inner_below(i);
  }
  int from = 0;
  for (const std::uint64_t number : angles.histogram()) {
    json["histogram"].push_back({{"from", from}, {"to", from + AngleCensus::kBinWidth}, {"angles", number}});
    from += AngleCensus::kBinWidth;
  }
  return json;
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::uint64_t peak_memory_bytes() {
#ifdef _WIN32
  return 0;
#else
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
#endif
}

std::string to_text(const Json& report) {
  // Names of files may be anything but UTF-8.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sinkmesh::program
