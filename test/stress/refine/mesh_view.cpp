// SPDX-License-Identifier: MIT
#include "test/stress/refine/mesh_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "refine/mesh_check.h"
#include "refine/surface_check.h"
#include "test/stress/refine/runs.h"
#include "test/stress/text.h"
#include "test/support/rational_geometry.h"

namespace sinkmesh::stress {
namespace {

using test::Rational;
using test::RationalPoint;

template <int Dim>
using Ids = std::array<std::uint32_t, Dim>;

template <std::size_t N>
std::array<std::uint32_t, N> sorted(std::array<std::uint32_t, N> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

template <int Dim>
Ids<Dim> facet_of(const typename Mesh<Dim>::Simplex& simplex, std::size_t i) {
  Ids<Dim> f{};
  std::size_t n = 0;
  for (std::size_t k = 0; k <= Dim; ++k) {
    if (k != i) f[n++] = simplex[k];
  }
  return sorted(f);
}

/// By sorted corners: the simplices at a facet, and which of their facets it is.
template <int Dim>
using FacetMap = std::map<Ids<Dim>, std::vector<std::pair<std::size_t, std::size_t>>>;

template <int Dim>
FacetMap<Dim> facets_of(const Mesh<Dim>& mesh) {
  FacetMap<Dim> at;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    for (std::size_t i = 0; i <= Dim; ++i) at[facet_of<Dim>(mesh.simplices[s], i)].emplace_back(s, i);
  }
  return at;
}

template <std::size_t N>
std::string list(const std::array<std::uint32_t, N>& ids) {
  std::string result;
  for (const std::uint32_t id : ids) result += " " + std::to_string(id);
  return result;
}

const std::vector<std::int64_t>& field(const auto& fields, const std::string& name, std::size_t size) {
  for (const auto& f : fields) {
    if (f.name != name) continue;
    expect_equal("length of field " + name, f.values.size(), size);
    return f.values;
  }
  throw CheckFailed("field: there is no field " + name);
}

template <int Dim>
double measure(const std::vector<Point<Dim>>& points, const Ids<Dim>& f) {
  const auto& a = points[f[0]];
  const auto& b = points[f[1]];
  if constexpr (Dim == 2) {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
  } else {
    const auto& c = points[f[2]];
    double n2 = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const double n = (b[k] - a[k]) * (c[l] - a[l]) - (b[l] - a[l]) * (c[k] - a[k]);
      n2 += n * n;
    }
    return std::sqrt(n2) / 2;
  }
}

template <int Dim>
std::array<RationalPoint<Dim>, Dim + 1> corners_of(const Mesh<Dim>& mesh, std::size_t simplex) {
  std::array<RationalPoint<Dim>, Dim + 1> p;
  for (std::size_t i = 0; i <= Dim; ++i) p[i] = test::rational<Dim>(mesh.points[mesh.simplices[simplex][i]]);
  return p;
}

template <int Dim>
double volume(const Mesh<Dim>& mesh) {
  double sum = 0;
  for (const auto& simplex : mesh.simplices) {
    std::array<Point<Dim>, Dim> d;
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t k = 0; k < Dim; ++k)
        d[i][k] = mesh.points[simplex[i + 1]][k] - mesh.points[simplex[0]][k];
    }
    if constexpr (Dim == 2) {
      sum += (d[0][0] * d[1][1] - d[0][1] * d[1][0]) / 2;
    } else {
      sum += (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
              d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
              d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
             6;
    }
  }
  return sum;
}

/// Of the bounding box.
template <int Dim>
double diagonal(const std::vector<Point<Dim>>& points) {
  double sum = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [k](const auto& p, const auto& q) { return p[k] < q[k]; });
    sum += ((*high)[k] - (*low)[k]) * ((*high)[k] - (*low)[k]);
  }
  return std::sqrt(sum);
}

/// The sphere of a facet that has its center on it.
template <int Dim>
test::RationalSphere<Dim> diametral_sphere(const std::vector<Point<Dim>>& points, const Ids<Dim>& f) {
  const auto a = test::rational<Dim>(points[f[0]]);
  const auto b = test::rational<Dim>(points[f[1]]);
  test::RationalSphere<Dim> sphere;
  if constexpr (Dim == 2) {
    for (std::size_t k = 0; k < 2; ++k) sphere.center[k] = (a[k] + b[k]) / 2;
  } else {
    const auto c = test::rational<3>(points[f[2]]);
    const RationalPoint<3> origin{};
    std::array<std::array<Rational, 4>, 3> rows;
    RationalPoint<3> u;
    RationalPoint<3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
      rows[0][k] = 2 * u[k];
      rows[1][k] = 2 * v[k];
    }
    rows[0][3] = test::squared_distance(b, origin) - test::squared_distance(a, origin);
    rows[1][3] = test::squared_distance(c, origin) - test::squared_distance(a, origin);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const std::size_t m = (k + 2) % 3;
      rows[2][k] = u[l] * v[m] - u[m] * v[l];
      rows[2][3] += rows[2][k] * a[k];
    }
    sphere.center = test::solve<3>(rows);
  }
  sphere.radius2 = test::squared_distance(sphere.center, a);
  return sphere;
}

template <int Dim>
bool is_inside(const Mesh<Dim>& mesh, const RationalPoint<Dim>& x) {
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const auto part = test::barycentric<Dim>(corners_of(mesh, s), x);
    if (std::all_of(part.begin(), part.end(), [](const Rational& y) { return y >= 0; })) return true;
  }
  return false;
}

template <int Dim>
void expect_checked(const Mesh<Dim>& mesh, const Promise& promise) {
  const MeshCheck<Dim> check = check_mesh(mesh, promise.options.max_ratio);
  if (!check.ok()) {
    throw CheckFailed(std::string("mesh is ") + name(check.defects.front().kind) + ": " +
                      check.defects.front().message);
  }
  expect_equal("simplices that are not Delaunay", check.simplices_not_delaunay, 0U);
  expect_equal("facets that are not Delaunay", check.facets_not_delaunay, 0U);
  expect_equal("unstable facets", check.unstable_facets, 0U);
}

/// The list of boundary facets: in the complex, each once, and none missing.
template <int Dim>
std::set<Ids<Dim>> expect_boundary(const Mesh<Dim>& mesh, const FacetMap<Dim>& at) {
  std::set<Ids<Dim>> boundary;
  for (const auto& facet : mesh.boundary) {
    if (!at.contains(sorted(facet))) throw CheckFailed("boundary: no facet of a simplex:" + list(facet));
    if (!boundary.insert(sorted(facet)).second) throw CheckFailed("boundary: twice:" + list(facet));
  }
  for (const auto& [facet, sides] : at) {
    if (sides.size() == 1 && !boundary.contains(facet))
      throw CheckFailed("boundary: of one simplex only, and not listed:" + list(facet));
  }
  return boundary;
}

template <int Dim>
void expect_regions(const Mesh<Dim>& mesh, const FacetMap<Dim>& at, const std::set<Ids<Dim>>& boundary,
                    const Promise& promise) {
  const auto& region = field(mesh.simplex_fields, "region", mesh.simplices.size());
  std::set<std::int64_t> met(region.begin(), region.end());
  if (!met.empty() && (*met.begin() < 1 || *met.rbegin() > static_cast<std::int64_t>(promise.boundary.regions)))
    throw CheckFailed("region: out of range");
  if (promise.is_whole()) expect_equal("number of regions", met.size(), promise.boundary.regions);
  for (const auto& [facet, sides] : at) {
    if (sides.size() != 2 || boundary.contains(facet)) continue;
    if (region[sides[0].first] != region[sides[1].first])
      throw CheckFailed("region: changes where no boundary is:" + list(facet));
  }
}

template <int Dim>
void expect_parents(const Surface<Dim>& surface, const Mesh<Dim>& mesh, const Promise& promise) {
  const auto& parent = field(mesh.boundary_fields, "parent", mesh.boundary.size());
  const bool has_tags = !surface.facet_tags.empty();
  std::vector<double> found(surface.facets.size(), 0);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const bool is_new_wall = !promise.is_whole() && parent[i] == -1;
    if (!is_new_wall && (parent[i] < 0 || parent[i] >= static_cast<std::int64_t>(surface.facets.size())))
      throw CheckFailed("parent: out of range:" + list(mesh.boundary[i]));
    if (is_new_wall) continue;
    const auto f = static_cast<std::size_t>(parent[i]);
    if (has_tags) {
      const auto& tag = field(mesh.boundary_fields, "tag", mesh.boundary.size());
      expect_equal("tag", tag[i], surface.facet_tags[f]);
    }
    found[f] += measure<Dim>(mesh.points, mesh.boundary[i]);
  }
  if (!promise.is_whole()) return;
  // Facets with different tags are not joined: the pieces of each have its size. Else only all together have.
  const double size = diagonal<Dim>(surface.points);
  const double least = 1e-10 * std::pow(size, Dim - 1);
  double sum = 0;
  double expected_sum = 0;
  for (std::size_t f = 0; f < found.size(); ++f) {
    const double expected = measure<Dim>(surface.points, surface.facets[f]);
    if (has_tags && !(std::abs(found[f] - expected) <= 1e-8 * expected + least))
      throw CheckFailed(differ("size of the pieces of facet " + std::to_string(f), found[f], expected));
    sum += found[f];
    expected_sum += expected;
  }
  if (!(std::abs(sum - expected_sum) <= 1e-6 * expected_sum + least))
    throw CheckFailed(differ("size of the boundary", sum, expected_sum));
}

template <int Dim>
void expect_input(const Surface<Dim>& surface, const Mesh<Dim>& mesh, const Promise& promise) {
  if (mesh.points.size() < surface.points.size() ||
      !std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin()))
    throw CheckFailed("input points: not the first ones of the mesh");
  if (!promise.is_whole()) return;
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& simplex : mesh.simplices) {
    for (const std::uint32_t v : simplex) used[v] = true;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) throw CheckFailed("unused point: " + std::to_string(v) + " is in no simplex");
  }
  const SurfaceSummary summary = summarize_surface(surface);
  if (!promise.has_normals || !summary.is_manifold || summary.signed_volume == 0) return;
  const double tolerance = 1e-8 * std::pow(diagonal<Dim>(surface.points), Dim);
  if (!(std::abs(volume(mesh) - std::abs(summary.signed_volume)) <= tolerance))
    throw CheckFailed(differ("volume", volume(mesh), std::abs(summary.signed_volume)));
}

template <int Dim>
void expect_gabriel(const Mesh<Dim>& mesh, const FacetMap<Dim>& at, Counters& counters) {
  for (const auto& facet : mesh.boundary) {
    const auto sphere = diametral_sphere<Dim>(mesh.points, facet);
    for (const auto& [s, i] : at.at(sorted(facet))) {
      const std::uint32_t apex = mesh.simplices[s][i];
      const int side = sgn(sphere.power(test::rational<Dim>(mesh.points[apex])));
      ++counters.comparisons;
      if (side == 0) ++counters.ties;
      if (side < 0)
        throw CheckFailed("Gabriel: vertex " + std::to_string(apex) + " is in the sphere of" + list(facet));
    }
  }
}

}  // namespace

template <int Dim>
void expect_sound(const Surface<Dim>& surface, const Mesh<Dim>& mesh, const Promise& promise,
                  Counters& counters) {
  expect_input(surface, mesh, promise);
  expect_checked(mesh, promise);
  const auto at = facets_of(mesh);
  const auto boundary = expect_boundary<Dim>(mesh, at);
  expect_regions<Dim>(mesh, at, boundary, promise);
  expect_parents(surface, mesh, promise);
  if (promise.is_divided()) {
    expect_gabriel<Dim>(mesh, at, counters);
  } else if (promise.is_whole()) {
    std::set<Ids<Dim>> given;
    for (const auto& facet : surface.facets) given.insert(sorted(facet));
    if (given != boundary) throw CheckFailed("boundary: is fixed, and not the one that was given");
  }
  counters.comparisons += mesh.simplices.size() + mesh.boundary.size();
}

template <int Dim>
void expect_separated(const Surface<Dim>& surface, const Mesh<Dim>& mesh, double separation) {
  const auto shortest2 = [](std::vector<Point<Dim>> points) {
    std::sort(points.begin(), points.end());
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        if (std::pow(points[j][0] - points[i][0], 2) > shortest) break;
        double d2 = 0;
        for (std::size_t k = 0; k < Dim; ++k) d2 += std::pow(points[j][k] - points[i][k], 2);
        shortest = std::min(shortest, d2);
      }
    }
    return shortest;
  };
  const double promised2 = std::min(separation * separation, shortest2(surface.points));
  const double found2 = shortest2(mesh.points);
  if (!(found2 >= promised2 * (1 - 1e-12)))
    throw CheckFailed(differ("separation", std::sqrt(found2), std::sqrt(promised2)));
}

template <int Dim>
void expect_no_worse(const Mesh<Dim>& before, const Mesh<Dim>& after, double max_ratio) {
  using Facet = std::array<Point<Dim>, Dim>;
  const auto boundary_of = [](const Mesh<Dim>& mesh) {
    const auto& parent = field(mesh.boundary_fields, "parent", mesh.boundary.size());
    std::vector<std::pair<Facet, std::int64_t>> facets;
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
      Facet facet;
      for (std::size_t k = 0; k < Dim; ++k) facet[k] = mesh.points[mesh.boundary[i][k]];
      std::sort(facet.begin(), facet.end());
      facets.emplace_back(facet, parent[i]);
    }
    std::sort(facets.begin(), facets.end());
    return facets;
  };
  if (boundary_of(after) != boundary_of(before)) throw CheckFailed("boundary: has changed");
  if (after.simplices.size() > before.simplices.size())
    throw CheckFailed(differ("simplices after improvement", after.simplices.size(), before.simplices.size()));
  struct Quality {
    std::size_t low = 0;
    double worst2 = 0;
    double shortest2 = HUGE_VAL;
  };
  const auto quality_of = [&](const Mesh<Dim>& mesh) {
    Quality quality;
    for (const auto& simplex : mesh.simplices) {
      Corners<Dim> corners;
      for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &mesh.points[simplex[i]];
      const Shape s = shape<Dim>(corners);
      quality.low += s.ratio2() > max_ratio * max_ratio ? 1 : 0;
      quality.worst2 = std::max(quality.worst2, s.ratio2());
      quality.shortest2 = std::min(quality.shortest2, s.shortest2);
    }
    return quality;
  };
  const Quality old = quality_of(before);
  const Quality now = quality_of(after);
  if (now.low > old.low) throw CheckFailed(differ("of low quality after improvement", now.low, old.low));
  if (!(now.worst2 <= std::max(old.worst2, max_ratio * max_ratio) * (1 + 1e-9)))
    throw CheckFailed(differ("largest r/l after improvement", now.worst2, old.worst2));
  if (!(now.shortest2 >= old.shortest2 * (1 - 1e-12)))
    throw CheckFailed(differ("shortest edge after improvement", now.shortest2, old.shortest2));
}

template <int Dim>
void expect_leftovers(const Mesh<Dim>& mesh, const std::vector<Leftover<Dim>>& leftovers,
                      const Promise& promise, Counters& counters) {
  const double max_ratio2 = promise.options.max_ratio * promise.options.max_ratio;
  std::map<Ids<Dim + 1>, double> low;
  for (const auto& simplex : mesh.simplices) {
    Corners<Dim> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = &mesh.points[simplex[i]];
    const double ratio2 = shape<Dim>(corners).ratio2();
    if (ratio2 > max_ratio2) low[sorted(simplex)] = std::sqrt(ratio2);
  }
  std::set<Ids<Dim>> walls;
  std::set<Ids<Dim>> bad_walls;
  std::vector<std::pair<Point<Dim>, double>> spheres;
  for (const auto& facet : mesh.boundary) {
    FacetCorners<Dim> corners;
    for (std::size_t k = 0; k < Dim; ++k) corners[k] = &mesh.points[facet[k]];
    const Shape s = facet_shape<Dim>(corners);
    walls.insert(sorted(facet));
    if (!(s.ratio2() <= max_ratio2)) bad_walls.insert(sorted(facet));
    spheres.emplace_back(facet_center<Dim>(corners), s.radius2);
  }
  const Remaining& remaining = promise.result.remaining;
  expect_equal("simplices of low quality in the list", leftovers.size(), low.size());
  expect_equal("simplices of low quality in the sum of reasons", remaining.total(), low.size());
  if (promise.is_done() && !promise.is_improved) {
    expect_equal("untried after a finished run", remaining.untried, 0U);
    expect_equal("centers beyond after a finished run", promise.result.centers_beyond, 0U);
  }
  Remaining counted;
  double before = HUGE_VAL;
  for (const Leftover<Dim>& leftover : leftovers) {
    ++counters.comparisons;
    ++counted.count(leftover.reason);
    const auto found = low.find(sorted(leftover.corners));
    if (found == low.end())
      throw CheckFailed("leftover: not of low quality, or twice:" + list(leftover.corners));
    if (!(std::abs(leftover.ratio / found->second - 1) <= 1e-6 || leftover.ratio == found->second))
      throw CheckFailed(differ("ratio of a leftover", leftover.ratio, found->second));
    if (!(leftover.ratio <= before)) throw CheckFailed("order of leftovers: not the worst first");
    before = leftover.ratio;
    low.erase(found);
    bool has_bad_wall = false;
    std::size_t num_walls = 0;
    for (std::size_t i = 0; i <= Dim; ++i) {
      has_bad_wall |= bad_walls.contains(facet_of<Dim>(leftover.corners, i));
      num_walls += walls.count(facet_of<Dim>(leftover.corners, i));
    }
    if (leftover.reason == LeftoverReason::small_angle) {
      // Of a fixed boundary, the angle is one of the triangle itself.
      if (!promise.is_divided() && !(Dim == 2 && num_walls >= 2))
        throw CheckFailed("reason: small_angle, but the boundary is fixed");
    } else if (leftover.reason != LeftoverReason::untried) {
      expect_equal("reason boundary_facet", leftover.reason == LeftoverReason::boundary_facet, has_bad_wall);
    }
    // A circumcenter inside that is in no sphere of the boundary could have been inserted. Facets of a fixed
    // boundary need not be Gabriel on their outer sides: there a prestar may cross them from farther away.
    const bool is_barred = leftover.reason == LeftoverReason::boundary ||
                           (leftover.reason == LeftoverReason::crossing && promise.is_divided());
    // The point was refused before others have moved.
    if (!is_barred || promise.is_improved || promise.options.insert != Insert::circumcenter) continue;
    std::array<RationalPoint<Dim>, Dim + 1> corners;
    for (std::size_t i = 0; i <= Dim; ++i) corners[i] = test::rational<Dim>(mesh.points[leftover.corners[i]]);
    const auto center = test::orthosphere<Dim>(corners).center;
    const bool is_encroaching = std::any_of(spheres.begin(), spheres.end(), [&](const auto& sphere) {
      double d2 = 0;
      for (std::size_t k = 0; k < Dim; ++k) d2 += std::pow(sphere.first[k] - center[k].get_d(), 2);
      return d2 <= sphere.second * (1 + 1e-6);
    });
    ++counters.named[kBarred];
    if (!is_encroaching && is_inside<Dim>(mesh, center))
      throw CheckFailed("attackable: its circumcenter is free:" + list(leftover.corners));
  }
  for (const LeftoverReason reason : kLeftoverReasons) {
    expect_equal(std::string("number of leftovers by reason ") + name(reason), remaining.count(reason),
                 counted.count(reason));
  }
}

template <int Dim>
void expect_centers_inside(const Mesh<Dim>& mesh) {
  const auto at = facets_of(mesh);
  for (std::size_t first = 0; first < mesh.simplices.size(); ++first) {
    const auto center = test::orthosphere<Dim>(corners_of(mesh, first)).center;
    std::size_t s = first;
    for (std::size_t steps = 0;; ++steps) {
      if (steps > mesh.simplices.size()) throw CheckFailed("walk to a circumcenter: does not end");
      const auto part = test::barycentric<Dim>(corners_of(mesh, s), center);
      const auto out = std::find_if(part.begin(), part.end(), [](const Rational& x) { return x < 0; });
      if (out == part.end()) break;
      const auto& sides = at.at(facet_of<Dim>(mesh.simplices[s], static_cast<std::size_t>(out - part.begin())));
      if (sides.size() != 2) throw CheckFailed("circumcenter outside: of" + list(mesh.simplices[first]));
      s = sides[0].first == s ? sides[1].first : sides[0].first;
    }
  }
}

template void expect_sound(const Surface<2>&, const Mesh<2>&, const Promise&, Counters&);
template void expect_sound(const Surface<3>&, const Mesh<3>&, const Promise&, Counters&);
template void expect_separated(const Surface<2>&, const Mesh<2>&, double);
template void expect_separated(const Surface<3>&, const Mesh<3>&, double);
template void expect_no_worse(const Mesh<2>&, const Mesh<2>&, double);
template void expect_no_worse(const Mesh<3>&, const Mesh<3>&, double);
template void expect_leftovers(const Mesh<2>&, const std::vector<Leftover<2>>&, const Promise&, Counters&);
template void expect_leftovers(const Mesh<3>&, const std::vector<Leftover<3>>&, const Promise&, Counters&);
template void expect_centers_inside(const Mesh<2>&);
template void expect_centers_inside(const Mesh<3>&);

}  // namespace sinkmesh::stress
