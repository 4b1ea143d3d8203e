// SPDX-License-Identifier: MIT
#include "refine/refine.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "core/mix.h"
#include "core/vector.h"
#include "refine/boundary.h"
#include "refine/budget.h"
#include "refine/coarsener.h"
#include "refine/conformer.h"
#include "refine/facet_index.h"
#include "refine/interior_editor.h"
#include "refine/parents.h"
#include "refine/patches.h"
#include "refine/refiner.h"
#include "refine/self_intersections.h"
#include "refine/sliver_mover.h"
#include "refine/surface_check.h"
#include "refine/used_points.h"

namespace sinkmesh {
namespace {

constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};

template <int Dim>
std::array<std::uint32_t, Dim + 1> corner_ids(const Complex<Dim>& complex, Simplex s) {
  std::array<std::uint32_t, Dim + 1> ids;
  for (int i = 0; i <= Dim; ++i) ids[static_cast<std::size_t>(i)] = complex.corner(s, i).index();
  return ids;
}

template <int Dim>
std::array<std::uint32_t, Dim> facet_ids(const Complex<Dim>& complex, HalfFacet h) {
  std::array<std::uint32_t, Dim> ids;
  const std::array<Vertex, Dim> vertices = complex.facet(h);
  for (std::size_t k = 0; k < Dim; ++k) ids[k] = vertices[k].index();
  return ids;
}

std::string not_conformed(const BoundaryResult& boundary) {
  if (boundary.unconformed.empty()) return "the surface was not conformed within the limits that were set";
  return std::to_string(boundary.unconformed.size()) +
         " facets of the surface could not be made Delaunay (the first "
         "is facet " +
         std::to_string(boundary.unconformed.front()) + "): angles or distances there are too small";
}

std::string count_of(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace

template <int Dim>
struct SurfaceMesher<Dim>::State {
  explicit State(const Surface<Dim>& surface)
      : facet_tags(surface.facet_tags),
        seeds(surface.seeds),
        used(surface),
        unused_points(surface.points.size() - used.points.size()),
        triangulation(used.points),
        domain(triangulation),
        flow(triangulation) {}

  BoundaryResult find_fixed();
  void require_no_crossing() const;
  void require_room_between_facets() const;
  void start_conforming(std::span<const HalfFacet> found, const BoundaryOptions& options);
  BoundaryResult conform(std::vector<HalfFacet> found, const RefineOptions& options);
  void restore(const typename Boundary<Dim>::Snapshot& snapshot);
  std::size_t count_vertices(Feature::Kind kind, std::size_t first) const;
  bool is_stable();
  Refiner<Dim> make_refiner(const RefineOptions& options) {
    if (!conformer) return {triangulation, domain, flow, options};
    return {triangulation, domain, flow, *boundary, *conformer, rules, options};
  }
  std::uint64_t place_of(const Leftover<Dim>& leftover) const;
  void update_leftovers(const std::map<std::uint64_t, Leftover<Dim>>& before, const RefineOptions& options);
  bool is_removed(Vertex v) const {
    return v.index() >= used.points.size() && triangulation.complex().incident_simplex(v).is_null();
  }
  std::vector<std::int64_t> parents_of(std::span<const HalfFacet> walls) const;
  std::vector<std::uint32_t> mesh_ids() const;
  template <class Listed>
  std::vector<Listed> in_mesh(std::vector<Listed> list) const;

  std::vector<std::int64_t> facet_tags;
  Seeds<Dim> seeds;
  UsedPoints<Dim> used;
  std::size_t unused_points;
  Triangulation<Dim> triangulation;
  Domain<Dim> domain;
  Flow<Dim> flow;
  // If the boundary is divided:
  std::optional<Boundary<Dim>> boundary;
  std::optional<Conformer<Dim>> conformer;
  BoundaryRules<Dim> rules;
  bool projects = true;  // see Conformer
  Collars collars;
  std::vector<Leftover<Dim>> leftovers;
  std::vector<Sliver<Dim>> slivers;
};

template <int Dim>
SurfaceMesher<Dim>::SurfaceMesher(const Surface<Dim>& surface) {
  if (surface.facets.empty()) throw InputError("the surface has no facet: it bounds nothing");
  state_ = std::make_unique<State>(surface);
}
template <int Dim>
SurfaceMesher<Dim>::SurfaceMesher(SurfaceMesher&&) noexcept = default;
template <int Dim>
SurfaceMesher<Dim>& SurfaceMesher<Dim>::operator=(SurfaceMesher&&) noexcept = default;
template <int Dim>
SurfaceMesher<Dim>::~SurfaceMesher() = default;

template <int Dim>
bool SurfaceMesher<Dim>::State::is_stable() {
  const Complex<Dim>& complex = triangulation.complex();
  for (const HalfFacet h : domain.boundary()) {
    for (const HalfFacet side : {h, complex.mate(h)}) {
      if (domain.is_inside(Complex<Dim>::simplex_of(side)) && flow.crosses(side)) return false;
    }
  }
  return true;
}

template <int Dim>
BoundaryResult SurfaceMesher<Dim>::State::find_fixed() {
  const typename Domain<Dim>::Peeled peeled = domain.peel(flow);
  if (domain.simplices().empty()) {
    throw InputError("nothing stable is inside the surface: the flow leads out of it from everywhere (" +
                     std::to_string(peeled.simplices) + " of " +
                     count_of(peeled.simplices, "simplex", "simplices") +
                     "); let the boundary be refined, or divide its facets into smaller ones");
  }
  BoundaryResult result;
  result.regions = domain.num_regions();
  result.peeled_simplices = peeled.simplices;
  result.peeled_facets = peeled.facets;
  return result;
}

template <int Dim>
void SurfaceMesher<Dim>::State::require_room_between_facets() const {
  if constexpr (Dim == 3) {
    const std::optional<Fold> fold = sharpest_fold(triangulation.complex(), used.facets);
    if (!fold || !fold->is_too_sharp()) return;
    throw FacetError(
        fold->first,
        "facets " + std::to_string(fold->first) + " and " + std::to_string(fold->second) +
            " of the surface meet at an angle of less than a thousandth of a degree: remove one of them, "
            "or move them apart");
  }
}

template <int Dim>
void SurfaceMesher<Dim>::State::start_conforming(std::span<const HalfFacet> found,
                                                 const BoundaryOptions& options) {
  constexpr double kFloor = 0x1p-30;  // of the diagonal
  const double default_angle = Dim == 2 ? BoundaryOptions::kSmallAngle2 : BoundaryOptions::kSmallAngle3;
  const Box<Dim>& box = triangulation.gate().box();
  const double diagonal = std::sqrt(squared_distance(box.low, box.high));
  domain = Domain<Dim>(triangulation);
  flow = Flow<Dim>(triangulation);
  // Far from the origin planes are rounded by more than the fraction of the diagonal; coordinates are below 2.
  const double flat = options.flat > 0 ? std::max(options.flat * diagonal, 0x1p-52) : 0;
  boundary.emplace(triangulation, domain, used.facets, found, facet_tags, flat);
  rules = {&boundary->features(),
           2 * std::sin(options.small_angle.value_or(default_angle) * (std::numbers::pi / 360)),
           kFloor * diagonal};
  conformer.emplace(triangulation, domain, flow, *boundary, collars, rules.lambda, rules.floor, projects);
  conformer->start();
}

// From the beginning, if a sub-facet had to be given up: without projections, and then with collars at the
// corners where points have crowded, as long as there is one that has none.
template <int Dim>
BoundaryResult SurfaceMesher<Dim>::State::conform(std::vector<HalfFacet> found, const RefineOptions& options) {
  Budget budget(options);
  for (;;) {
    start_conforming(found, options.boundary);
    conformer->conform([&] {
      const Complex<Dim>& complex = triangulation.complex();
      return budget.may_continue(complex.num_vertices(), complex.bytes());
    });
    if (conformer->unconformed().empty()) break;
    if (!projects && !collars.add_crowded<Dim>(*boundary, used.facets)) break;
    projects = false;
    triangulation = Triangulation<Dim>(used.points);
    found = domain.find(used.facets);
  }
  BoundaryResult result;
  result.mode = BoundaryMode::refine;
  result.patches = boundary->features().patches().size();
  result.joined_facets = Dim == 3 ? used.facets.size() - result.patches : 0;
  result.segments = boundary->features().segments().size();
  result.stop = budget.stop();
  result.points_on_segments = conformer->points_on_segments();
  result.points_on_patches = conformer->points_on_patches();
  Parents<Dim> parents(*boundary, used.facets);
  for (const SubFacet f : conformer->unconformed()) result.unconformed.push_back(parents.of(f));
  std::sort(result.unconformed.begin(), result.unconformed.end());
  result.unconformed.erase(std::unique(result.unconformed.begin(), result.unconformed.end()),
                           result.unconformed.end());
  if (!result.ok()) {
    domain = Domain<Dim>(triangulation);
    return result;
  }
  domain.label(used.facets, boundary->walls(), seeds);
  conformer->remember_regions();
  result.regions = domain.num_regions();
  return result;
}

template <int Dim>
BoundaryResult SurfaceMesher<Dim>::find_domain(const RefineOptions& options) {
  require_valid(options);
  State& state = *state_;
  const BoundaryMode mode = options.boundary.mode;
  const std::vector<HalfFacet> found = state.domain.find(state.used.facets);
  const auto missing = static_cast<std::size_t>(std::count(found.begin(), found.end(), HalfFacet()));
  if (mode == BoundaryMode::fixed && missing != 0) {
    const auto first =
        static_cast<std::size_t>(std::find(found.begin(), found.end(), HalfFacet()) - found.begin());
    throw FacetError(
        first,
        std::to_string(missing) + " of " + count_of(state.used.facets.size(), "facet", "facets") +
            " of the surface are not in the Delaunay triangulation of its vertices (the first is facet " +
            std::to_string(first) + "): let the boundary be refined, or divide them into smaller ones");
  }
  if (missing == 0) {
    state.domain.label(state.used.facets, Domain<Dim>::walls_at(found), state.seeds);
    const bool is_to_divide = mode == BoundaryMode::refine || !state.is_stable();
    if (mode == BoundaryMode::fixed || !is_to_divide) return state.find_fixed();
  }
  if (missing != 0) state.require_no_crossing();
  state.require_room_between_facets();
  return state.conform(found, options);
}

template <int Dim>
RefineResult SurfaceMesher<Dim>::refine(const RefineOptions& options) {
  State& state = *state_;
  const std::size_t before = state.triangulation.complex().num_vertices();
  Refiner<Dim> refiner = state.make_refiner(options);
  RefineResult result = refiner.run();
  state.leftovers = refiner.leftovers();
  if (refiner.last_valid() == nullptr) return result;
  state.restore(*refiner.last_valid());
  if (!refiner.knows_leftovers()) {
    Refiner<Dim> restored = state.make_refiner(options);
    const RefineResult seen = restored.look();
    result.remaining = seen.remaining;
    result.centers_beyond = seen.centers_beyond;
    state.leftovers = restored.leftovers();
  }
  result.inserted = state.triangulation.complex().num_vertices() - before;
  result.points_on_segments = state.count_vertices(Feature::Kind::segment, before);
  result.points_on_patches = state.count_vertices(Feature::Kind::patch, before);
  return result;
}

template <int Dim>
std::uint64_t SurfaceMesher<Dim>::State::place_of(const Leftover<Dim>& leftover) const {
  Corners<Dim> corners;
  for (std::size_t i = 0; i <= Dim; ++i)
    corners[i] = &triangulation.complex().point(Vertex(leftover.corners[i]));
  return hash_points<Dim>(corners);
}

// After vertices have moved: what is of low quality still keeps its reason.
template <int Dim>
void SurfaceMesher<Dim>::State::update_leftovers(const std::map<std::uint64_t, Leftover<Dim>>& before,
                                                 const RefineOptions& options) {
  Refiner<Dim> refiner = make_refiner(options);
  refiner.find_leftovers();
  leftovers = refiner.leftovers();
  for (Leftover<Dim>& leftover : leftovers) {
    const auto same = before.find(place_of(leftover));
    if (same != before.end()) leftover = same->second;
  }
}

template <int Dim>
Improvement SurfaceMesher<Dim>::improve(const RefineOptions& options) {
  require_valid(options);
  State& state = *state_;
  Improvement result;
  std::map<std::uint64_t, Leftover<Dim>> before;
  for (const Leftover<Dim>& leftover : state.leftovers) before.emplace(state.place_of(leftover), leftover);
  const auto num_given = static_cast<std::uint32_t>(state.used.points.size());
  InteriorEditor<Dim> editor(state.triangulation, state.domain, state.flow,
                             state.boundary ? &*state.boundary : nullptr, num_given);
  if (options.coarsen) {
    Coarsener<Dim> coarsener(editor, options, num_vertices());
    result.coarsening = coarsener.run();
  }
  state.slivers.clear();
  if (options.slivers && result.coarsening.stop == Stop::no_candidate) {
    SliverMover<Dim> mover(editor, options, num_vertices());
    result.moving = mover.run();
    state.slivers = mover.slivers();
  }
  state.update_leftovers(before, options);
  for (const Leftover<Dim>& leftover : state.leftovers) ++result.remaining.count(leftover.reason);
  return result;
}

// Of those from `first` on, the ones that lie on a feature of this kind.
template <int Dim>
std::size_t SurfaceMesher<Dim>::State::count_vertices(Feature::Kind kind, std::size_t first) const {
  std::size_t count = 0;
  for (auto v = static_cast<std::uint32_t>(first); v < triangulation.complex().num_vertices(); ++v) {
    count += boundary->features().vertex(Vertex(v)).on.kind == kind ? 1 : 0;
  }
  return count;
}

// The vertices that were there, and the Delaunay triangulation of them, which is unique. Those that have been
// removed become copies of the first one, which are in no simplex: others may be where they were.
template <int Dim>
void SurfaceMesher<Dim>::State::restore(const typename Boundary<Dim>::Snapshot& snapshot) {
  std::vector<Point<Dim>> points(snapshot.num_vertices);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    points[v] = triangulation.point(is_removed(Vertex(v)) ? Vertex(0) : Vertex(v));
  }
  triangulation = Triangulation<Dim>(points);
  domain = Domain<Dim>(triangulation);
  flow = Flow<Dim>(triangulation);
  boundary->restore(snapshot);
  conformer.emplace(triangulation, domain, flow, *boundary, collars, rules.lambda, rules.floor, projects);
  domain.label(used.facets, boundary->walls(), seeds);
  conformer->remember_regions();
}

// The facet of the surface of which each wall is a part; -1 for a wall that peeling has put up.
template <int Dim>
std::vector<std::int64_t> SurfaceMesher<Dim>::State::parents_of(std::span<const HalfFacet> walls) const {
  std::vector<std::int64_t> parents;
  if (boundary) {
    Parents<Dim> known(*boundary, used.facets);
    for (const HalfFacet h : walls) parents.push_back(known.of(boundary->at(h)));
    return parents;
  }
  const FacetIndex<Dim> known(used.facets, triangulation.complex().num_vertices());
  for (const HalfFacet h : walls) {
    parents.push_back(-1);
    known.look_up(triangulation.complex().facet(h),
                  [&](std::size_t f) { parents.back() = static_cast<std::int64_t>(f); });
  }
  return parents;
}

// A surface all of whose facets are in the triangulation does not cross itself.
template <int Dim>
void SurfaceMesher<Dim>::State::require_no_crossing() const {
  Surface<Dim> surface;
  surface.points = used.points;
  for (const auto& facet : used.facets) {
    typename Surface<Dim>::Facet& ids = surface.facets.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) ids[k] = facet[k].index();
  }
  const std::vector<FacetPair> first = self_intersections(surface, 1);
  if (first.empty()) return;
  throw FacetError(
      first[0].first,
      "facets " + std::to_string(first[0].first) + " and " + std::to_string(first[0].second) +
          " of the surface cross, touch or overlap: cut them along their intersection, or move them apart");
}

template <int Dim>
std::vector<Leftover<Dim>> SurfaceMesher<Dim>::leftovers() const {
  return state_->in_mesh(state_->leftovers);
}

template <int Dim>
std::vector<Sliver<Dim>> SurfaceMesher<Dim>::slivers() const {
  return state_->in_mesh(state_->slivers);
}

template <int Dim>
std::size_t SurfaceMesher<Dim>::num_unused_points() const {
  return state_->unused_points;
}

// Ids of the complex to ids of the mesh, which has no removed vertices. Points of the surface are never
// removed.
template <int Dim>
std::vector<std::uint32_t> SurfaceMesher<Dim>::State::mesh_ids() const {
  std::vector<std::uint32_t> ids(triangulation.complex().num_vertices());
  std::uint32_t next = 0;
  for (std::uint32_t v = 0; v < ids.size(); ++v) ids[v] = is_removed(Vertex(v)) ? kNoPoint : next++;
  return ids;
}

// Simplices whose corners are vertices, with the points of the mesh instead.
template <int Dim>
template <class Listed>
std::vector<Listed> SurfaceMesher<Dim>::State::in_mesh(std::vector<Listed> list) const {
  const std::vector<std::uint32_t> ids = mesh_ids();
  for (Listed& listed : list) {
    for (std::uint32_t& v : listed.corners) v = ids[v];
  }
  return list;
}

template <int Dim>
QualityStatistics SurfaceMesher<Dim>::statistics(double max_ratio) const {
  QualityStatistics statistics(max_ratio);
  for (const Simplex s : state_->domain.simplices()) {
    statistics.add<Dim>(state_->triangulation.complex().corners(s));
  }
  return statistics;
}

template <int Dim>
AngleCensus SurfaceMesher<Dim>::angle_census() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  std::vector<bool> is_on_boundary(complex.num_vertices(), false);
  for (const HalfFacet h : state_->domain.boundary()) {
    for (const std::uint32_t v : facet_ids<Dim>(complex, h)) is_on_boundary[v] = true;
  }
  AngleCensus census;
  for (const Simplex s : state_->domain.simplices()) {
    const auto ids = corner_ids<Dim>(complex, s);
    const bool is_inner =
        std::any_of(ids.begin(), ids.end(), [&](std::uint32_t v) { return !is_on_boundary[v]; });
    census.add<Dim>(complex.corners(s), is_inner);
  }
  return census;
}

template <int Dim>
std::size_t SurfaceMesher<Dim>::num_vertices() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  std::vector<bool> used(complex.num_vertices(), false);
  for (const Simplex s : state_->domain.simplices()) {
    for (const std::uint32_t v : corner_ids<Dim>(complex, s)) used[v] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

template <int Dim>
std::uint64_t SurfaceMesher<Dim>::hash() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  std::vector<Point<Dim>> points(complex.num_vertices());
  for (std::uint32_t v = 0; v < points.size(); ++v) points[v] = state_->triangulation.point(Vertex(v));
  SimplexSetHash<Dim> hash(points);
  for (const Simplex s : state_->domain.simplices()) hash.add(corner_ids<Dim>(complex, s));
  return hash.value();
}

template <int Dim>
Mesh<Dim> SurfaceMesher<Dim>::mesh() const {
  const Complex<Dim>& complex = state_->triangulation.complex();
  const std::vector<std::uint32_t> id = state_->mesh_ids();
  Mesh<Dim> mesh;
  mesh.points.reserve(id.size());
  for (std::uint32_t v = 0; v < id.size(); ++v) {
    if (id[v] != kNoPoint) mesh.points.push_back(state_->triangulation.point(Vertex(v)));
  }
  typename Mesh<Dim>::Field region{"region", {}};
  for (const Simplex s : state_->domain.simplices()) {
    auto simplex = corner_ids<Dim>(complex, s);
    for (std::uint32_t& v : simplex) v = id[v];
    mesh.simplices.push_back(simplex);
    region.values.push_back(state_->domain.region(s));
  }
  mesh.simplex_fields.push_back(std::move(region));
  if (!state_->seeds.regions.empty()) {
    typename Mesh<Dim>::Field tag{"tag", {}};
    for (const std::int64_t r : mesh.simplex_fields[0].values) {
      tag.values.push_back(state_->domain.tag(static_cast<typename Domain<Dim>::Region>(r)));
    }
    mesh.simplex_fields.push_back(std::move(tag));
  }

  const std::vector<HalfFacet> walls = state_->domain.boundary();
  for (const HalfFacet h : walls) {
    auto facet = facet_ids<Dim>(complex, h);
    for (std::uint32_t& v : facet) v = id[v];
    mesh.boundary.push_back(facet);
  }
  typename Mesh<Dim>::Field parent{"parent", state_->parents_of(walls)};
  mesh.boundary_fields.push_back(std::move(parent));
  if (!state_->facet_tags.empty()) {
    typename Mesh<Dim>::Field tag{"tag", {}};
    for (const std::int64_t f : mesh.boundary_fields[0].values) {
      tag.values.push_back(f < 0 ? 0 : state_->facet_tags[static_cast<std::size_t>(f)]);
    }
    mesh.boundary_fields.push_back(std::move(tag));
  }
  return mesh;
}

template <int Dim>
const Triangulation<Dim>& SurfaceMesher<Dim>::triangulation() const {
  return state_->triangulation;
}
template <int Dim>
const Domain<Dim>& SurfaceMesher<Dim>::domain() const {
  return state_->domain;
}
template <int Dim>
std::size_t SurfaceMesher<Dim>::bytes() const {
  return state_->triangulation.complex().bytes();
}

template <int Dim>
Mesh<Dim> hull_mesh(const Triangulation<Dim>& triangulation) {
  const Complex<Dim>& complex = triangulation.complex();
  Mesh<Dim> mesh;
  for (std::uint32_t v = 0; v < complex.num_vertices(); ++v)
    mesh.points.push_back(triangulation.point(Vertex(v)));
  for (const Simplex s : complex.simplices()) {
    if (complex.is_ghost(s)) {
      mesh.boundary.push_back(facet_ids<Dim>(complex, complex.mate(Complex<Dim>::half_facet(s, Dim))));
    } else {
      mesh.simplices.push_back(corner_ids<Dim>(complex, s));
    }
  }
  return mesh;
}

template <int Dim>
Mesh<Dim> refine(const Surface<Dim>& surface, const RefineOptions& options) {
  require_valid(options);
  for (const SurfaceDefect& defect : check_surface(surface, SurfaceChecks::without_intersections)) {
    if (severity(defect.kind) == SurfaceSeverity::error) {
      throw InputError(defect.message + ": " + std::string(advice(defect.kind)));
    }
  }
  SurfaceMesher<Dim> mesher(surface);
  const BoundaryResult boundary = mesher.find_domain(options);
  if (!boundary.ok()) throw InputError(not_conformed(boundary));
  const RefineResult refined = mesher.refine(options);
  if (refined.stop != Stop::budget && refined.stop != Stop::cancelled) mesher.improve(options);
  return mesher.mesh();
}

template class SurfaceMesher<2>;
template class SurfaceMesher<3>;
template Mesh<2> hull_mesh(const Triangulation<2>&);
template Mesh<3> hull_mesh(const Triangulation<3>&);
template Mesh<2> refine(const Surface<2>&, const RefineOptions&);
template Mesh<3> refine(const Surface<3>&, const RefineOptions&);

}  // namespace sinkmesh
