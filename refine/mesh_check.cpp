// SPDX-License-Identifier: MIT
#include "refine/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>

#include "core/triangulation.h"
#include "predicates/input_gate.h"
#include "predicates/predicates.h"

namespace sinkmesh {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Unperturbed, unlike Predicates<Dim>::in_sphere(): in a mesh from elsewhere, ties may be resolved either way.
int in_sphere(const Corners<2>& s, const Point2& x) { return incircle(*s[0], *s[1], *s[2], x); }
int in_sphere(const Corners<3>& s, const Point3& x) { return insphere(*s[0], *s[1], *s[2], *s[3], x); }
int orient(const Corners<2>& s) { return orient2d(*s[0], *s[1], *s[2]); }
int orient(const Corners<3>& s) { return orient3d(*s[0], *s[1], *s[2], *s[3]); }

// The parts of a message, one after the other.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

template <int Dim>
std::string coordinates(const Point<Dim>& p) {
  std::ostringstream out;
  out.precision(17);
  for (int k = 0; k < Dim; ++k) out << (k == 0 ? "(" : ", ") << p[k];
  out << ')';
  return out.str();
}

template <class Ids>
std::string list(const Ids& ids) {
  std::ostringstream out;
  for (const std::uint32_t id : ids) out << ' ' << id;
  return out.str();
}

template <int Dim>
class MeshChecker {
 public:
  MeshChecker(const Mesh<Dim>& mesh, double max_ratio) : mesh_(mesh), check_(max_ratio) {}

  MeshCheck<Dim> run() {
    check_corners();
    collect_vertices();
    check_finite();
    if (!check_.ok() || points_.empty()) return std::move(check_);
    const InputGate<Dim> gate(points_);
    check_.rounded_points = gate.rounded_points();
    for (Point<Dim>& p : points_) p = gate.in(p);
    check_volumes();
    check_duplicates();
    match_facets();
    count_angles();
    find_components();
    check_overlaps();
    std::stable_sort(check_.defects.begin(), check_.defects.end(),
                     [](const MeshDefect& a, const MeshDefect& b) { return a.kind < b.kind; });
    if (check_.ok()) {
      look_at_facets();
      look_at_simplices();
    }
    return std::move(check_);
  }

 private:
  using Simplex = typename Mesh<Dim>::Simplex;
  using Facet = typename Mesh<Dim>::Facet;

  std::size_t num_simplices() const { return mesh_.simplices.size(); }
  void report(MeshDefect::Kind kind, std::string message) {
    check_.defects.push_back({kind, std::move(message)});
  }
  std::string describe(std::size_t s) const {
    std::string result = text("simplex ", s, " with the corners");
    for (const std::uint32_t v : mesh_.simplices[s]) {
      result += text(' ', v, ' ', coordinates<Dim>(mesh_.points[v]));
    }
    return result;
  }

  void check_corners() {
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      Simplex corners = mesh_.simplices[s];
      std::sort(corners.begin(), corners.end());
      const bool repeated = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
      if (corners.back() >= mesh_.points.size() || repeated) {
        report(MeshDefect::Kind::bad_corner,
               text("simplex ", s, " has the corners", list(mesh_.simplices[s]),
                    repeated ? ": one of them twice" : ": there is no such vertex"));
      }
    }
  }

  // Vertices without gaps: points that no simplex uses must not count for anything.
  void collect_vertices() {
    number_.assign(mesh_.points.size(), kNone);
    for (const Simplex& simplex : mesh_.simplices) {
      for (const std::uint32_t v : simplex) {
        if (v < number_.size()) number_[v] = 0;
      }
    }
    for (std::size_t v = 0; v < number_.size(); ++v) {
      if (number_[v] == kNone) continue;
      number_[v] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(mesh_.points[v]);
      ids_.push_back(static_cast<std::uint32_t>(v));
    }
    check_.vertices = points_.size();
    check_.unused_points = mesh_.points.size() - points_.size();
  }

  void check_finite() {
    for (std::size_t v = 0; v < points_.size(); ++v) {
      for (const double x : points_[v]) {
        if (std::isfinite(x)) continue;
        report(MeshDefect::Kind::not_finite, text("vertex ", ids_[v], " at ", coordinates<Dim>(points_[v])));
        break;
      }
    }
  }

  Simplex numbered(std::size_t s) const {
    Simplex corners = mesh_.simplices[s];
    for (std::uint32_t& v : corners) v = number_[v];
    return corners;
  }
  Corners<Dim> corners(std::size_t s) const {
    Corners<Dim> result;
    const Simplex vertices = numbered(s);
    for (std::size_t i = 0; i <= Dim; ++i) result[i] = &points_[vertices[i]];
    return result;
  }

  void check_volumes() {
    is_positive_.resize(num_simplices());
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      const int sign = orient(corners(s));
      is_positive_[s] = sign > 0;
      if (sign != 0) check_.quality.template add<Dim>(corners(s));
      if (sign > 0) continue;
      report(sign == 0 ? MeshDefect::Kind::flat : MeshDefect::Kind::inverted, describe(s));
    }
  }

  void check_duplicates() {
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a] != points_[b] ? points_[a] < points_[b] : a < b;
    });
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (points_[order[k - 1]] != points_[order[k]]) continue;
      const std::uint32_t v = ids_[order[k]];
      report(MeshDefect::Kind::duplicate_point,
             text("vertices ", ids_[order[k - 1]], " and ", v, " at ", coordinates<Dim>(mesh_.points[v])));
    }
  }

  // A facet as the sorted set of its vertices; `odd` if sorting changed the orientation that it has seen from
  // outside its simplex.
  struct FacetEntry {
    Facet vertices;
    std::uint32_t half_facet;
    bool odd;
  };
  FacetEntry facet_entry(std::size_t s, std::size_t i) const {
    FacetEntry entry{{}, static_cast<std::uint32_t>((Dim + 1) * s + i), false};
    for (std::size_t k = 0; k < Dim; ++k) {
      entry.vertices[k] = number_[mesh_.simplices[s][Complex<Dim>::kFacet[i][k]]];
    }
    for (std::size_t k = 1; k < Dim; ++k) {
      for (std::size_t j = k; j > 0 && entry.vertices[j] < entry.vertices[j - 1]; --j) {
        std::swap(entry.vertices[j], entry.vertices[j - 1]);
        entry.odd = !entry.odd;
      }
    }
    return entry;
  }

  void match_facets() {
    std::vector<FacetEntry> entries;
    entries.reserve((Dim + 1) * num_simplices());
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      for (std::size_t i = 0; i <= Dim; ++i) entries.push_back(facet_entry(s, i));
    }
    std::sort(entries.begin(), entries.end(), [](const FacetEntry& a, const FacetEntry& b) {
      return a.vertices != b.vertices ? a.vertices < b.vertices : a.half_facet < b.half_facet;
    });
    mate_.assign(entries.size(), kNone);
    is_on_boundary_.assign(points_.size(), false);
    for (std::size_t first = 0, last = 0; first < entries.size(); first = last) {
      while (last < entries.size() && entries[last].vertices == entries[first].vertices) ++last;
      if (last - first == 1) {
        ++check_.boundary_facets;
        for (const std::uint32_t v : entries[first].vertices) is_on_boundary_[v] = true;
      } else {
        ++check_.interior_facets;
        mate_[entries[first].half_facet] = entries[first + 1].half_facet;
        mate_[entries[first + 1].half_facet] = entries[first].half_facet;
        check_sides({&entries[first], last - first});
      }
    }
  }

  void count_angles() {
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      if (orient(corners(s)) == 0) continue;
      const Simplex vertices = numbered(s);
      const bool is_inner = std::any_of(vertices.begin(), vertices.end(),
                                        [this](std::uint32_t v) { return !is_on_boundary_[v]; });
      check_.angles.template add<Dim>(corners(s), is_inner);
    }
  }

  void check_sides(std::span<const FacetEntry> same) {
    const auto kind = same.size() > 2 ? MeshDefect::Kind::crowded_facet : MeshDefect::Kind::same_side;
    if (kind == MeshDefect::Kind::same_side) {
      // The side of a simplex without positive volume says nothing more.
      for (const FacetEntry& entry : same) {
        if (!is_positive_[entry.half_facet / (Dim + 1)]) return;
      }
      if (same[0].odd != same[1].odd) return;
    }
    std::ostringstream message;
    message << "facet";
    for (const std::uint32_t v : same[0].vertices) message << ' ' << ids_[v];
    message << " of the simplices";
    for (const FacetEntry& entry : same) message << ' ' << entry.half_facet / (Dim + 1);
    report(kind, message.str());
  }

  void find_components() {
    component_.assign(num_simplices(), kNone);
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < num_simplices(); ++first) {
      if (component_[first] != kNone) continue;
      const auto number = static_cast<std::uint32_t>(check_.components++);
      component_[first] = number;
      stack.push_back(first);
      while (!stack.empty()) {
        const std::size_t s = stack.back();
        stack.pop_back();
        for (std::size_t i = 0; i <= Dim; ++i) {
          const std::uint32_t h = mate_[(Dim + 1) * s + i];
          if (h == kNone || component_[h / (Dim + 1)] != kNone) continue;
          component_[h / (Dim + 1)] = number;
          stack.push_back(h / (Dim + 1));
        }
      }
    }
  }

  bool holds(const Corners<Dim>& s, const Point<Dim>& x, bool strictly) const {
    for (std::size_t i = 0; i <= Dim; ++i) {
      Corners<Dim> replaced = s;
      replaced[i] = &x;
      if (orient(replaced) < (strictly ? 1 : 0)) return false;
    }
    return true;
  }

  // A point of the interior of s, exactly; none if its centroid is lost by rounding.
  std::optional<Point<Dim>> interior_point(std::size_t s) const {
    const Corners<Dim> c = corners(s);
    Point<Dim> x{};
    for (std::size_t k = 0; k < Dim; ++k) {
      for (std::size_t i = 0; i <= Dim; ++i) x[k] += (*c[i])[k] / (Dim + 1);
    }
    if (!holds(c, x, true)) return std::nullopt;
    return x;
  }

  // One interior point for each part, against the simplices of the others. If no boundary crosses another, two
  // parts overlap only if one lies in the other as a whole.
  void check_overlaps() {
    if (!check_.ok() || check_.components < 2) return;
    struct Probe {
      Point<Dim> point;
      std::size_t simplex;
    };
    std::vector<Probe> probes;
    std::vector<bool> probed(check_.components, false);
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      if (probed[component_[s]]) continue;
      if (const auto x = interior_point(s)) {
        probes.push_back({*x, s});
        probed[component_[s]] = true;
      }
    }
    std::sort(probes.begin(), probes.end(), [](const Probe& a, const Probe& b) { return a.point < b.point; });
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      const Corners<Dim> c = corners(s);
      Box<Dim> box;
      for (const Point<Dim>* p : c) box.include(*p);
      auto probe = std::lower_bound(probes.begin(), probes.end(), box.low,
                                    [](const Probe& a, const Point<Dim>& low) { return a.point[0] < low[0]; });
      for (; probe != probes.end() && probe->point[0] <= box.high[0]; ++probe) {
        if (component_[probe->simplex] == component_[s] || !box.contains(probe->point)) continue;
        if (holds(c, probe->point, false)) {
          report(MeshDefect::Kind::overlap, text("simplices ", probe->simplex, " and ", s));
        }
      }
    }
  }

  void look_at_facets() {
    Box<Dim> box;
    for (const Point<Dim>& p : points_) box.include(p);
    const Predicates<Dim> predicates(box, kGridBits);
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      const Simplex vertices = numbered(s);
      bool is_sink = true;
      for (std::size_t i = 0; i <= Dim; ++i) {
        FacetCorners<Dim> facet;
        for (std::size_t k = 0; k < Dim; ++k) facet[k] = &points_[vertices[Complex<Dim>::kFacet[i][k]]];
        const bool flows = predicates.flow_side(facet, points_[vertices[i]]) < 0;
        is_sink = is_sink && !flows;
        const std::size_t h = (Dim + 1) * s + i;
        const std::uint32_t mate = mate_[h];
        if (mate == kNone) {
          const Point<Dim>& apex = points_[vertices[i]];
          check_.unstable_facets += predicates.diametral_side(facet, apex) < 0 ? 1 : 0;
        } else if (h < mate) {
          const int side = in_sphere(corners(s), points_[numbered(mate / (Dim + 1))[mate % (Dim + 1)]]);
          check_.facets_not_delaunay += side > 0 ? 1 : 0;
          check_.cospherical_facets += side == 0 ? 1 : 0;
        }
      }
      check_.sinks += is_sink ? 1 : 0;
    }
  }

  void look_at_simplices() {
    const Triangulation<Dim> triangulation(points_);
    const Complex<Dim>& complex = triangulation.complex();
    std::vector<Simplex> known;
    known.reserve(triangulation.num_solid());
    for (const auto s : complex.simplices()) {
      if (complex.is_ghost(s)) continue;
      Simplex vertices;
      for (int i = 0; i <= Dim; ++i) vertices[static_cast<std::size_t>(i)] = complex.corner(s, i).index();
      std::sort(vertices.begin(), vertices.end());
      known.push_back(vertices);
    }
    std::sort(known.begin(), known.end());
    for (std::size_t s = 0; s < num_simplices(); ++s) {
      Simplex vertices = numbered(s);
      std::sort(vertices.begin(), vertices.end());
      if (std::binary_search(known.begin(), known.end(), vertices)) continue;
      if (has_empty_sphere(complex, s)) continue;
      if (check_.simplices_not_delaunay++ == 0) check_.first_not_delaunay = s;
    }
  }

  // Lifted to the paraboloid, the circumsphere is a plane through the simplex. If any vertex lies below it, one
  // at the other end of an edge of the lower hull does, seen from a corner of the simplex; and the edges of the
  // lower hull are edges of every Delaunay triangulation, however it divides cospherical points.
  bool has_empty_sphere(const Complex<Dim>& complex, std::size_t s) {
    const Corners<Dim> sphere = corners(s);
    const Vertex center(numbered(s)[0]);
    seen_.resize(complex.num_slots(), kNone);
    const auto visit = [&](sinkmesh::Simplex t) {
      if (seen_[t.index()] == s) return;
      seen_[t.index()] = static_cast<std::uint32_t>(s);
      star_.push_back(t);
    };
    star_.clear();
    visit(complex.incident_simplex(center));
    for (std::size_t k = 0; k < star_.size(); ++k) {
      const auto t = star_[k];
      for (int i = 0; i <= Dim; ++i) {
        const Vertex v = complex.corner(t, i);
        if (v == center) continue;
        if (!v.is_infinite() && in_sphere(sphere, complex.point(v)) > 0) return false;
        visit(complex.neighbor(t, i));
      }
    }
    return true;
  }

  const Mesh<Dim>& mesh_;
  MeshCheck<Dim> check_;
  std::vector<std::uint32_t> number_;  // of a point among the vertices
  std::vector<std::uint32_t> ids_;     // of a vertex among the points
  std::vector<Point<Dim>> points_;     // of the vertices; gated once they are known to be finite
  std::vector<bool> is_positive_;
  std::vector<bool> is_on_boundary_;  // by vertex
  std::vector<std::uint32_t> mate_;   // of half-facets, (Dim+1)*simplex + corner
  std::vector<std::uint32_t> component_;
  std::vector<sinkmesh::Simplex> star_;
  std::vector<std::uint32_t> seen_;  // of a simplex of the triangulation: the last search that met it
};

}  // namespace

const char* name(MeshDefect::Kind kind) {
  switch (kind) {
    case MeshDefect::Kind::not_finite:
      return "coordinate that is not finite";
    case MeshDefect::Kind::bad_corner:
      return "impossible corner";
    case MeshDefect::Kind::flat:
      return "volume zero";
    case MeshDefect::Kind::inverted:
      return "volume negative";
    case MeshDefect::Kind::duplicate_point:
      return "duplicate vertices";
    case MeshDefect::Kind::crowded_facet:
      return "facet of more than two simplices";
    case MeshDefect::Kind::same_side:
      return "simplices on the same side of their facet";
    case MeshDefect::Kind::overlap:
      return "overlapping simplices";
  }
  return "";
}

template <int Dim>
MeshCheck<Dim> check_mesh(const Mesh<Dim>& mesh, double max_ratio) {
  return MeshChecker<Dim>(mesh, max_ratio).run();
}

template struct MeshCheck<2>;
template struct MeshCheck<3>;
template MeshCheck<2> check_mesh(const Mesh<2>&, double);
template MeshCheck<3> check_mesh(const Mesh<3>&, double);

}  // namespace sinkmesh
