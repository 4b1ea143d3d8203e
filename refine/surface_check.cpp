// SPDX-License-Identifier: MIT
//
// Everything is found by sorting: edges by their vertices, vertices by their coordinates, facets by their
// vertices. Fans and components are classes of a union-find whose representative is the smallest member, so
// that no order but that of the ids shows in the result.
#include "refine/surface_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "predicates/predicates.h"
#include "refine/point_text.h"
#include "refine/self_intersections.h"
#include "refine/union_find.h"

namespace sinkmesh {
namespace {

using Ids = std::vector<std::uint32_t>;

// One use of an edge by a facet. Sorted, the uses of an edge are neighbors, in the order of the facets.
struct EdgeUse {
  std::uint64_t edge;    // both vertices, the smaller one in the upper half; in the plane the vertex
  std::uint64_t corner;  // of all facets: Dim * facet + number

  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

template <int Dim>
class Topology {
 public:
  using Facet = typename Surface<Dim>::Facet;

  explicit Topology(const Surface<Dim>& surface) : surface_(surface), takes_part_(surface.facets.size()) {
    for (std::size_t f = 0; f < takes_part_.size(); ++f) {
      takes_part_[f] = has_valid_indices(surface.facets[f]) && !repeated_vertex(surface.facets[f]);
    }
    list_edges();
  }

  bool takes_part(std::size_t f) const { return takes_part_[f]; }
  bool has_valid_indices(const Facet& facet) const {
    return std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) { return v < surface_.points.size(); });
  }
  static bool repeated_vertex(Facet facet) {
    std::sort(facet.begin(), facet.end());
    return std::adjacent_find(facet.begin(), facet.end()) != facet.end();
  }
  static std::uint32_t facet_of(const EdgeUse& use) { return static_cast<std::uint32_t>(use.corner / Dim); }

  /// Does the facet run along the edge from the smaller vertex to the larger? In the plane: does it end there?
  bool is_forward(const EdgeUse& use) const {
    const Facet& facet = surface_.facets[facet_of(use)];
    const std::size_t k = use.corner % Dim;
    if constexpr (Dim == 2) return k == 1;
    return facet[k] < facet[(k + 1) % Dim];
  }
  /// The vertices of the edge, in the order of the facet.
  Ids vertices_of(const EdgeUse& use) const {
    const Facet& facet = surface_.facets[facet_of(use)];
    const std::size_t k = use.corner % Dim;
    if constexpr (Dim == 2) return {facet[k]};
    return {facet[k], facet[(k + 1) % Dim]};
  }
  Ids facets_of(const EdgeUse* first, const EdgeUse* last) const {
    Ids facets;
    for (; first != last; ++first) facets.push_back(facet_of(*first));
    return facets;
  }

  /// Calls visit(first, last) with the uses of each edge, ordered by the vertices of the edge.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    const EdgeUse* const end = uses_.data() + uses_.size();
    for (const EdgeUse* first = uses_.data(); first != end;) {
      const EdgeUse* last = first;
      while (last != end && last->edge == first->edge) ++last;
      visit(first, last);
      first = last;
    }
  }

  /// For each vertex with several fans: the vertex, and the first facet of each fan. In the plane the edges
  /// tell already.
  std::vector<std::pair<std::uint32_t, Ids>> nonmanifold_vertices() const {
    if constexpr (Dim == 2) return {};
    UnionFind fans(Dim * surface_.facets.size());
    for_each_edge([&](const EdgeUse* first, const EdgeUse* last) {
      for (const EdgeUse* use = first + 1; use < last; ++use) {
        const bool same = is_forward(*first) == is_forward(*use);
        const std::uint64_t start = use->corner;
        const std::uint64_t end = next_corner(start);
        fans.unite(first->corner, same ? start : end);
        fans.unite(next_corner(first->corner), same ? end : start);
      }
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> starts;  // vertex, first facet of a fan
    for (std::size_t f = 0; f < takes_part_.size(); ++f) {
      for (std::size_t k = 0; takes_part_[f] && k < Dim; ++k) {
        if (fans.find(Dim * f + k) == Dim * f + k) {
          starts.emplace_back(surface_.facets[f][k], static_cast<std::uint32_t>(f));
        }
      }
    }
    std::sort(starts.begin(), starts.end());
    std::vector<std::pair<std::uint32_t, Ids>> result;
    for (auto first = starts.begin(); first != starts.end();) {
      auto last = first;
      while (last != starts.end() && last->first == first->first) ++last;
      if (last - first > 1) {
        Ids facets;
        std::transform(first, last, std::back_inserter(facets), [](const auto& start) { return start.second; });
        result.emplace_back(first->first, std::move(facets));
      }
      first = last;
    }
    return result;
  }

  /// By vertex: does a facet use it? A facet with a repeated vertex uses its vertices too.
  std::vector<bool> used_vertices() const {
    std::vector<bool> used(surface_.points.size());
    for (const Facet& facet : surface_.facets) {
      if (!has_valid_indices(facet)) continue;
      for (const std::uint32_t v : facet) used[v] = true;
    }
    return used;
  }

 private:
  static std::uint64_t next_corner(std::uint64_t corner) {
    return corner % Dim + 1 == Dim ? corner + 1 - Dim : corner + 1;
  }

  void list_edges() {
    uses_.reserve(Dim * surface_.facets.size());
    for (std::size_t f = 0; f < takes_part_.size(); ++f) {
      if (!takes_part_[f]) continue;
      const Facet& facet = surface_.facets[f];
      for (std::size_t k = 0; k < Dim; ++k) {
        std::uint64_t edge = facet[k];
        if constexpr (Dim == 3) {
          const std::uint64_t other = facet[(k + 1) % Dim];
          edge = std::min(edge, other) << 32 | std::max(edge, other);
        }
        uses_.push_back({edge, Dim * f + k});
      }
    }
    std::sort(uses_.begin(), uses_.end());
  }

  const Surface<Dim>& surface_;
  std::vector<bool> takes_part_;
  std::vector<EdgeUse> uses_;
};

template <int Dim>
bool is_finite(const Point<Dim>& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

// The power of two that brings the largest of the coordinates close to 1; 0 if that is not needed, lest it cost
// time.
template <int Dim>
int scale_exponent(const FacetCorners<Dim>& corners, int comfortable) {
  double largest = 0;
  for (const auto* const p : corners) {
    for (const double x : *p) largest = std::max(largest, std::abs(x));
  }
  if (largest == 0) return 0;
  const int exponent = std::ilogb(largest);
  return std::abs(exponent) <= comfortable ? 0 : -exponent;
}

template <int Dim>
Point<Dim> scaled(const Point<Dim>& p, int exponent) {
  Point<Dim> result = p;
  if (exponent != 0) {
    for (double& x : result) x = std::ldexp(x, exponent);
  }
  return result;
}

bool is_degenerate(const FacetCorners<2>& corners) { return *corners[0] == *corners[1]; }

// Collinear in space if and only if collinear in the three coordinate planes.
bool is_degenerate(const FacetCorners<3>& corners) {
  // Products of two coordinates stay far from both ends of the exponents.
  constexpr int kComfortable = 100;
  const int exponent = scale_exponent<3>(corners, kComfortable);
  const Point3 a = scaled<3>(*corners[0], exponent);
  const Point3 b = scaled<3>(*corners[1], exponent);
  const Point3 c = scaled<3>(*corners[2], exponent);
  constexpr std::pair<std::size_t, std::size_t> kPlanes[] = {{0, 1}, {1, 2}, {2, 0}};
  return std::all_of(std::begin(kPlanes), std::end(kPlanes), [&](const auto& plane) {
    const auto [i, j] = plane;
    return orient2d({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}) == 0;
  });
}

template <int Dim>
FacetCorners<Dim> corners_of(const Surface<Dim>& surface, const typename Surface<Dim>::Facet& facet) {
  FacetCorners<Dim> corners{};
  for (std::size_t k = 0; k < Dim; ++k) corners[k] = &surface.points[facet[k]];
  return corners;
}

// Twice the area or six times the volume between the facet and the origin.
double cone(const std::array<Point2, 2>& p) { return p[0][0] * p[1][1] - p[0][1] * p[1][0]; }
double cone(const std::array<Point3, 3>& p) {
  return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
         p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
}

struct SignedVolume {
  double value = 0;
  bool is_surely_negative = false;
};

// Relative to the middle of the box and in its size, so that neither far away nor huge coordinates spoil it.
// Requires a closed, consistent surface of finite points.
template <int Dim>
SignedVolume signed_volume(const Surface<Dim>& surface) {
  Box<Dim> box;
  for (const auto& facet : surface.facets) {
    for (const std::uint32_t v : facet) box.include(surface.points[v]);
  }
  FacetCorners<Dim> corners{};
  corners.fill(&box.low);
  corners.back() = &box.high;
  const int exponent = scale_exponent<Dim>(corners, 0);
  const Point<Dim> low = scaled<Dim>(box.low, exponent);
  const Point<Dim> high = scaled<Dim>(box.high, exponent);
  double sum = 0;
  double magnitude = 0;
  for (const auto& facet : surface.facets) {
    std::array<Point<Dim>, Dim> p;
    for (std::size_t k = 0; k < Dim; ++k) {
      p[k] = scaled<Dim>(surface.points[facet[k]], exponent);
      for (std::size_t i = 0; i < Dim; ++i) p[k][i] -= 0.5 * (low[i] + high[i]);
    }
    const double term = cone(p);
    sum += term;
    magnitude += std::abs(term);
  }
  // Rounding errors stay below a few units of 2^-53 per term of the sum.
  const double error = 1e-15 * magnitude * static_cast<double>(surface.facets.size() + 16);
  return {std::ldexp(sum / (Dim == 2 ? 2 : 6), -Dim * exponent), sum < -error};
}

template <int Dim>
class Checker {
 public:
  explicit Checker(const Surface<Dim>& surface) : surface_(surface), topology_(surface) {}

  std::vector<SurfaceDefect> run(SurfaceChecks checks) {
    check_indices();
    check_finite();
    check_repeated_vertices();
    check_degenerate_facets();
    check_duplicate_vertices();
    check_duplicate_facets();
    check_edges();
    check_vertices();
    check_unused();
    check_inside_out();
    if (checks == SurfaceChecks::all) check_self_intersections();
    // Within a kind the checks go by ids.
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const SurfaceDefect& a, const SurfaceDefect& b) { return a.kind < b.kind; });
    return std::move(defects_);
  }

 private:
  using Kind = SurfaceDefectKind;

  void add(Kind kind, Ids facets, Ids vertices, std::string message) {
    defects_.push_back({kind, std::move(facets), std::move(vertices), std::move(message)});
  }

  std::string vertex_text(std::uint32_t v) const {
    std::string text = "vertex " + std::to_string(v);
    if (v >= surface_.points.size()) return text;
    return text + ' ' + point_text<Dim>(surface_.points[v]);
  }
  template <class Vertices>
  std::string vertices_text(const Vertices& vertices) const {
    std::string text;
    for (const std::uint32_t v : vertices) {
      if (!text.empty()) text += ", ";
      text += vertex_text(v);
    }
    return text;
  }
  static std::string ids_text(const Ids& ids) {
    std::string text;
    for (const std::uint32_t id : ids) {
      if (!text.empty()) text += ", ";
      text += std::to_string(id);
    }
    return text;
  }
  // "edge of vertex 1 (..), vertex 2 (..)"; in the plane "vertex 1 (..)".
  std::string edge_text(const Ids& vertices) const {
    return (Dim == 3 ? std::string("edge of ") : std::string()) + vertices_text(vertices);
  }
  static Ids sorted_ids(const typename Surface<Dim>::Facet& facet) {
    Ids ids(facet.begin(), facet.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }
  static std::uint32_t id(std::size_t i) { return static_cast<std::uint32_t>(i); }

  void check_indices() {
    for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
      const auto& facet = surface_.facets[f];
      if (topology_.has_valid_indices(facet)) continue;
      Ids bad = sorted_ids(facet);
      bad.erase(bad.begin(), std::lower_bound(bad.begin(), bad.end(), surface_.points.size()));
      std::string message = "facet " + std::to_string(f) + " refers to vertex " + ids_text(bad);
      message += ", but there are " + std::to_string(surface_.points.size()) + " vertices";
      add(Kind::index_out_of_range, {id(f)}, std::move(bad), std::move(message));
    }
  }

  void check_finite() {
    for (std::size_t v = 0; v < surface_.points.size(); ++v) {
      if (is_finite<Dim>(surface_.points[v])) continue;
      add(Kind::not_finite, {}, {id(v)}, vertex_text(id(v)) + " is not finite");
    }
  }

  void check_repeated_vertices() {
    for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
      const auto& facet = surface_.facets[f];
      if (!topology_.has_valid_indices(facet) || !topology_.repeated_vertex(facet)) continue;
      std::string message = "facet " + std::to_string(f) + " has a vertex twice: ";
      message += vertices_text(facet);
      add(Kind::repeated_vertex, {id(f)}, sorted_ids(facet), std::move(message));
    }
  }

  void check_degenerate_facets() {
    for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
      if (!topology_.takes_part(f)) continue;
      const auto& facet = surface_.facets[f];
      const auto corners = corners_of(surface_, facet);
      const bool finite =
          std::all_of(corners.begin(), corners.end(), [](const auto* p) { return is_finite<Dim>(*p); });
      if (!finite || !is_degenerate(corners)) continue;
      std::string message = "facet " + std::to_string(f);
      message += Dim == 3 ? " has collinear corners: " : " has length 0: ";
      message += vertices_text(facet);
      add(Kind::degenerate_facet, {id(f)}, sorted_ids(facet), std::move(message));
    }
  }

  void check_duplicate_vertices() {
    const std::vector<bool> used = topology_.used_vertices();
    Ids order;
    for (std::size_t v = 0; v < surface_.points.size(); ++v) {
      if (used[v] && is_finite<Dim>(surface_.points[v])) order.push_back(id(v));
    }
    const auto& points = surface_.points;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points[a] != points[b] ? points[a] < points[b] : a < b;
    });
    report_equal(
        order, [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; },
        [&](Ids group) {
          std::string message = vertex_text(group.front()) + " has the same coordinates as vertex ";
          message += ids_text({group.begin() + 1, group.end()});
          add(Kind::duplicate_vertex, {}, std::move(group), std::move(message));
        });
  }

  void check_duplicate_facets() {
    struct Row {
      typename Surface<Dim>::Facet vertices;
      std::uint32_t facet;
      auto operator<=>(const Row&) const = default;
    };
    std::vector<Row> rows;
    rows.reserve(surface_.facets.size());
    for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
      if (!topology_.takes_part(f)) continue;
      rows.push_back({surface_.facets[f], id(f)});
      std::sort(rows.back().vertices.begin(), rows.back().vertices.end());
    }
    std::sort(rows.begin(), rows.end());
    Ids order(rows.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto is_same = [&](std::uint32_t a, std::uint32_t b) { return rows[a].vertices == rows[b].vertices; };
    report_equal(order, is_same, [&](const Ids& group) {
      Ids facets;
      for (const std::uint32_t row : group) facets.push_back(rows[row].facet);
      const auto& vertices = rows[group.front()].vertices;
      std::string message = "facets " + ids_text(facets) + " have the same vertices: ";
      message += vertices_text(vertices);
      add(Kind::duplicate_facet, std::move(facets), {vertices.begin(), vertices.end()}, std::move(message));
    });
  }

  // Groups of equal neighbors, of two or more, ordered by their first member.
  template <class Equal, class Report>
  static void report_equal(const Ids& order, Equal equal, Report report) {
    std::vector<Ids> groups;
    for (auto first = order.begin(); first != order.end();) {
      const auto last = std::find_if(first, order.end(), [&](std::uint32_t i) { return !equal(*first, i); });
      if (last - first > 1) groups.emplace_back(first, last);
      first = last;
    }
    std::sort(groups.begin(), groups.end());
    for (Ids& group : groups) report(std::move(group));
  }

  void check_edges() {
    topology_.for_each_edge([&](const EdgeUse* first, const EdgeUse* last) {
      const auto uses = last - first;
      if (uses == 2 && topology_.is_forward(first[0]) != topology_.is_forward(first[1])) return;
      Ids facets = topology_.facets_of(first, last);
      Ids vertices = topology_.vertices_of(*first);
      std::string text = edge_text(vertices);
      if (uses == 1) {
        text += " belongs to facet " + std::to_string(facets.front()) + " only";
        add(Dim == 3 ? Kind::open_edge : Kind::dangling_end, std::move(facets), std::move(vertices),
            std::move(text));
      } else if (uses > 2) {
        text += " belongs to " + std::to_string(uses) + " facets: ";
        text += ids_text(facets);
        add(Kind::nonmanifold_edge, std::move(facets), std::move(vertices), std::move(text));
      } else {
        text += Dim == 3 ? " is run along in the same direction by facets " : " is the same end of facets ";
        text += ids_text(facets);
        add(Kind::inconsistent_orientation, std::move(facets), std::move(vertices), std::move(text));
      }
    });
  }

  void check_vertices() {
    for (auto& [vertex, facets] : topology_.nonmanifold_vertices()) {
      std::string text = vertex_text(vertex) + " joins " + std::to_string(facets.size());
      text += " fans of facets, which begin with facets ";
      text += ids_text(facets);
      add(Kind::nonmanifold_vertex, facets, {vertex}, std::move(text));
    }
  }

  void check_unused() {
    const std::vector<bool> used = topology_.used_vertices();
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) add(Kind::unused_vertex, {}, {id(v)}, vertex_text(id(v)) + " belongs to no facet");
    }
  }

  void check_self_intersections() {
    for (const auto& [f, g] : self_intersections(surface_)) {
      const auto& first = surface_.facets[f];
      const auto& second = surface_.facets[g];
      std::string text = "facets " + ids_text({f, g}) + " intersect: ";
      text += vertices_text(first) + " with " + vertices_text(second);
      Ids vertices(first.begin(), first.end());
      vertices.insert(vertices.end(), second.begin(), second.end());
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      add(Kind::self_intersection, {f, g}, std::move(vertices), std::move(text));
    }
  }

  // Where every edge has two facets that agree, there is a volume, whatever touches or crosses.
  void check_inside_out() {
    const bool is_sound = std::none_of(defects_.begin(), defects_.end(), [](const SurfaceDefect& defect) {
      switch (defect.kind) {
        case Kind::degenerate_facet:
        case Kind::duplicate_vertex:
        case Kind::nonmanifold_vertex:
        case Kind::unused_vertex:
          return false;
        default:
          return true;
      }
    });
    if (!is_sound || surface_.facets.empty()) return;
    const SignedVolume volume = signed_volume(surface_);
    if (!volume.is_surely_negative) return;
    add(Kind::inside_out, {}, {},
        "the normals point inward: the signed volume is " + number_text(volume.value));
  }

  const Surface<Dim>& surface_;
  const Topology<Dim> topology_;
  std::vector<SurfaceDefect> defects_;
};

struct KindText {
  std::string_view name;
  std::string_view advice;
};

// In the order of SurfaceDefectKind.
constexpr KindText kTexts[] = {
    {"index out of range", "correct the index, or add the missing vertices"},
    {"coordinate not finite", "repair the coordinates, or remove the vertex and close the hole"},
    {"repeated vertex", "remove the facet"},
    {"degenerate facet", "collapse its shortest edge, or flip its longest"},
    {"duplicate vertex", "merge the vertices, or move them apart"},
    {"duplicate facet", "remove all but one, or all of them if two face each other"},
    {"open edge", "close the hole, or merge the vertices along the seam"},
    {"self-intersection", "move the facets apart, or divide both along the line where they meet"},
    {"inconsistent orientation", "reverse one of the facets, and all that must follow it"},
    {"non-manifold edge", "nothing need be done: it is where regions meet, or parts touch"},
    {"non-manifold vertex", "nothing need be done: parts touch there"},
    {"dangling end", "nothing need be done, unless the curve should be closed: then add the segment"},
    {"unused vertex", "nothing need be done"},
    {"inside out", "nothing need be done, unless the normals matter: then reverse all facets"},
};

}  // namespace

SurfaceSeverity severity(SurfaceDefectKind kind) {
  switch (kind) {
    case SurfaceDefectKind::nonmanifold_edge:
    case SurfaceDefectKind::nonmanifold_vertex:
    case SurfaceDefectKind::dangling_end:
    case SurfaceDefectKind::unused_vertex:
    case SurfaceDefectKind::inside_out:
      return SurfaceSeverity::note;
    case SurfaceDefectKind::inconsistent_orientation:
      return SurfaceSeverity::orientation;
    default:
      return SurfaceSeverity::error;
  }
}

std::string_view name_of(SurfaceDefectKind kind) { return kTexts[static_cast<std::size_t>(kind)].name; }
std::string_view advice(SurfaceDefectKind kind) { return kTexts[static_cast<std::size_t>(kind)].advice; }

template <int Dim>
std::vector<SurfaceDefect> check_surface(const Surface<Dim>& surface, SurfaceChecks checks) {
  return Checker<Dim>(surface).run(checks);
}

template <int Dim>
SurfaceSummary summarize_surface(const Surface<Dim>& surface) {
  const Topology<Dim> topology(surface);
  SurfaceSummary summary;
  const std::vector<bool> used = topology.used_vertices();
  summary.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));

  UnionFind parts(surface.points.size());
  bool is_finite_everywhere = true;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (!topology.takes_part(f)) continue;
    ++summary.facets;
    for (const std::uint32_t v : surface.facets[f]) {
      parts.unite(surface.facets[f][0], v);
      is_finite_everywhere = is_finite_everywhere && is_finite<Dim>(surface.points[v]);
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v) summary.components += used[v] && parts.find(v) == v ? 1 : 0;

  bool is_closed = summary.facets != 0 && summary.facets == surface.facets.size();
  bool is_consistent = is_closed;
  topology.for_each_edge([&](const EdgeUse* first, const EdgeUse* last) {
    ++summary.edges;
    is_closed = is_closed && last - first == 2;
    is_consistent =
        is_consistent && last - first == 2 && topology.is_forward(first[0]) != topology.is_forward(first[1]);
  });
  summary.euler_characteristic =
      static_cast<std::int64_t>(summary.vertices) - static_cast<std::int64_t>(summary.facets);
  if constexpr (Dim == 3) {
    summary.euler_characteristic += 2 * static_cast<std::int64_t>(summary.facets);
    summary.euler_characteristic -= static_cast<std::int64_t>(summary.edges);
  }
  summary.is_manifold = is_closed && is_consistent && topology.nonmanifold_vertices().empty();
  if (Dim == 3 && summary.is_manifold) {
    summary.genus = static_cast<std::int64_t>(summary.components) - summary.euler_characteristic / 2;
  }
  if (is_consistent && is_finite_everywhere) summary.signed_volume = signed_volume(surface).value;
  return summary;
}

template std::vector<SurfaceDefect> check_surface(const Surface2&, SurfaceChecks);
template std::vector<SurfaceDefect> check_surface(const Surface3&, SurfaceChecks);
template SurfaceSummary summarize_surface(const Surface2&);
template SurfaceSummary summarize_surface(const Surface3&);

}  // namespace sinkmesh
