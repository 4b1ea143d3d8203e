// SPDX-License-Identifier: MIT
#include "test/stress/refine/surface_case.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "predicates/input_gate.h"
#include "refine/surface_check.h"

namespace sinkmesh::stress {
namespace {

template <int Dim>
using Facets = std::vector<std::array<std::uint32_t, Dim>>;

template <int Dim>
Facets<Dim> parse_facets(const std::string& text) {
  Facets<Dim> facets;
  std::istringstream words(text);
  std::uint32_t id = 0;
  std::size_t k = 0;
  for (; words >> id; k = (k + 1) % Dim) {
    if (k == 0) facets.emplace_back();
    facets.back()[k] = id;
  }
  if (!words.eof() || k != 0) throw CaseError("the facets are no list of ids");
  return facets;
}

template <int Dim>
void drop_collapsed(Facets<Dim>& facets) {
  std::erase_if(facets, [](auto f) {
    std::sort(f.begin(), f.end());
    return std::adjacent_find(f.begin(), f.end()) != f.end();
  });
  std::map<std::array<std::uint32_t, Dim>, std::size_t> count;
  const auto sorted = [](auto f) {
    std::sort(f.begin(), f.end());
    return f;
  };
  for (const auto& f : facets) ++count[sorted(f)];
  std::set<std::array<std::uint32_t, Dim>> kept;
  std::erase_if(facets, [&](const auto& f) {
    const auto key = sorted(f);
    return count[key] % 2 == 0 || !kept.insert(key).second;
  });
}

}  // namespace

template <int Dim>
void set_surface(Case& c, const Surface<Dim>& surface) {
  c.rows.clear();
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    auto& row = c.rows.emplace_back(surface.points[i].begin(), surface.points[i].end());
    row.push_back(static_cast<double>(i));
  }
  std::string facets;
  for (const auto& f : surface.facets) {
    for (const std::uint32_t id : f) {
      if (!facets.empty()) facets += ' ';
      facets += std::to_string(id);
    }
  }
  c.set("facets", facets);
}

template <int Dim>
Surface<Dim> surface_of(const Case& c) {
  auto facets = parse_facets<Dim>(std::string(c.setting("facets")));
  std::map<std::uint32_t, Point<Dim>> points;
  for (const auto& row : c.rows) {
    if (row.size() != Dim + 1) throw CaseError("a row is no point with its id");
    const double id = row[Dim];
    if (!(id >= 0 && id < 1e6) || id != std::floor(id)) throw CaseError("no id");
    Point<Dim> p;
    std::copy_n(row.begin(), Dim, p.begin());
    if (!points.emplace(static_cast<std::uint32_t>(id), p).second) throw CaseError("an id twice");
  }
  std::set<std::uint32_t> missing;
  for (const auto& f : facets) {
    for (const std::uint32_t id : f) {
      if (!points.contains(id)) missing.insert(id);
    }
  }
  for (const std::uint32_t gone : missing) {
    std::set<std::uint32_t> neighbors;
    for (const auto& f : facets) {
      if (std::find(f.begin(), f.end(), gone) != f.end()) neighbors.insert(f.begin(), f.end());
    }
    neighbors.erase(gone);
    if (neighbors.empty()) continue;
    const auto present =
        std::find_if(neighbors.begin(), neighbors.end(), [&](std::uint32_t v) { return points.contains(v); });
    const std::uint32_t heir = present != neighbors.end() ? *present : *neighbors.begin();
    for (auto& f : facets) std::replace(f.begin(), f.end(), gone, heir);
    drop_collapsed<Dim>(facets);
  }
  Surface<Dim> surface;
  std::map<std::uint32_t, std::uint32_t> new_id;
  for (const auto& f : facets) {
    for (const std::uint32_t id : f) {
      if (!points.contains(id)) throw CaseError("a facet without points");
      new_id[id] = 0;
    }
  }
  for (auto& [id, place] : new_id) {
    place = static_cast<std::uint32_t>(surface.points.size());
    surface.points.push_back(points[id]);
  }
  for (auto& f : facets) {
    for (std::uint32_t& id : f) id = new_id[id];
  }
  surface.facets = facets;
  return surface;
}

template <int Dim>
bool is_meshable(const Surface<Dim>& surface) {
  if (surface.facets.empty()) return false;
  for (const auto& p : surface.points) {
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) < 0x1p300; })) return false;
  }
  if (InputGate<Dim>(surface.points).rounded_points() != 0) return false;
  const auto defects = check_surface(surface);
  return std::none_of(defects.begin(), defects.end(), [](const SurfaceDefect& defect) {
    return severity(defect.kind) == SurfaceSeverity::error || defect.kind == SurfaceDefectKind::unused_vertex;
  });
}

template <int Dim>
bool has_meshable_surface(const Case& c) {
  try {
    return is_meshable(surface_of<Dim>(c));
  } catch (const CaseError&) {
    return false;
  }
}

template void set_surface(Case&, const Surface<2>&);
template void set_surface(Case&, const Surface<3>&);
template Surface<2> surface_of<2>(const Case&);
template Surface<3> surface_of<3>(const Case&);
template bool is_meshable(const Surface<2>&);
template bool is_meshable(const Surface<3>&);
template bool has_meshable_surface<2>(const Case&);
template bool has_meshable_surface<3>(const Case&);

}  // namespace sinkmesh::stress
