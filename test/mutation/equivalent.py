# SPDX-License-Identifier: MIT
"""Faults that no test can notice, each with the argument why it changes no result."""

# (file, the line above, the line, the line with the fault) -> argument
ARGUMENTS = {
    ("predicates/detail/expansion.cpp", "void Expansion::compress() {",
     "if (terms_.size() < 2) return;", "if (terms_.size() <= 2) return;"):
        "one term or two of sum() are strongly nonoverlapping, which is all that is promised; compressing only shortens them",
    ("predicates/staged.h", "struct Filter {",
     "double error = 0;  ///< of the rounded value", "double error = (0 + 1);  ///< of the rounded value"):
        "the only constructor of Predicates calls update(), which sets it in all filters before one is read; there are no "
        "other filters",
    ("predicates/staged.cpp", "const int bits = P::kDegree * granularity;",
     "unit = bits <= 1022 ? std::ldexp(1.0, -bits) : 0;", "unit = bits <= (1022 + 1) ? std::ldexp(1.0, -bits) : 0;"):
        "behind the gate the granularity is at most 121, and 8 times that is 968",
    ("predicates/input_gate.cpp", "static_assert(kGridBits == 121);",
     "if (std::abs(x) >= 0x1p-69) return x;", ""):
        "the shorter way: what it returns is a multiple of 2^-121, which the line below gives back unless 2^121 x overflows; "
        "no coordinate is anywhere near 2^900",
    ("predicates/circumcenter.cpp", "// next lines.",
     "const double error = 0x1p-99 * std::abs(q.head) + 0x1p-51 * (std::abs(rest) + std::abs(z.tail));",
     "const double error = 0x1p-99 * std::abs(q.head) + (0x1p-51 / 8) * (std::abs(rest) + std::abs(z.tail));"):
        "a wrong result would need a center beyond the middle T between two doubles, a power of two from z.head, and "
        "z.tail + error rounded to T. Where that is near, |rest| and |z.tail| are T or nearly, so that 2^-54 of their sum is "
        "the rounding of rest, at most 2^-53 T, and half the distance from T to the next double; and 2^-99 |q|, with |q| >= T, "
        "is twice what the quotient may be off, and far more than the rounding of the bound",
    ("core/complex.h", "detail::PodArray<std::uint32_t> free_;",
     "std::uint32_t stamp_ = 0;", "std::uint32_t stamp_ = (0 + 1);"):
        "a stamp only has to be none that a scratch word holds, and these are 0 at first: the first one is 2 instead of 1",
    ("refine/domain.cpp", "}",
     "std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });",
     "std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] <= key[b]; });"):
        "no two keys are equal: they hold the hash of a simplex, and no simplex is in two cells",
    ("refine/boundary.cpp", "bool Boundary<Dim>::has_edge(Vertex u, Vertex v) {",
     "if constexpr (Dim == 3) {", "if constexpr (Dim == (3 + 1)) {"):
        "the shorter way: an edge of a sub-facet that is in the complex is found by the walk as well",
    ("refine/boundary_features.cpp", "Plane Plane::through(const Point3& a, const Point3& b, const Point3& c) {",
     "if (b < a || c < a) return b < c ? through(b, c, a) : through(c, a, b);",
     "if (b < a || c <= a) return b < c ? through(b, c, a) : through(c, a, b);"):
        "the corners of a facet are distinct points",
    ("refine/boundary_features.cpp",
     "if (!is_short(nearest) && is_short(corner) && nearest->common.kind == Kind::segment &&",
     "is_acute(a, b, nearest->common.id)) {", "is_acute(b, a, nearest->common.id)) {"):
        "an angle is that from the other side, to the last bit: a and b only meet in products, which commute",
    ("refine/steiner_inserter.h", "std::vector<std::uint8_t> notes_;  // low quality, and the verdict on the point",
     "std::uint32_t births_ = 0;", "std::uint32_t births_ = (0 + 1);"):
        "births only have to differ, and to grow: the first one is 2 instead of 1",
    ("refine/steiner_inserter.cpp", "const Vertex q = complex().corner(s, j);",
     "if (squared_distance(complex().point(p), complex().point(q)) <= shortest2) visit(p, q);",
     "if (squared_distance(complex().point(p), complex().point(q)) <= shortest2) visit(q, p);"):
        "it is the same edge; in a rung only its two features change places, whose order means nothing",
    ("refine/patch_triangulation.cpp",
     "auto PatchTriangulation::walk(SubFacet f, const Point2& x) const -> std::optional<Location> {",
     "for (std::size_t steps = 0; steps <= boundary_->sub_facets().size(); ++steps) {",
     "for (std::size_t steps = 0; steps < boundary_->sub_facets().size(); ++steps) {"):
        "each step depends on the sub-facet only: a walk that ends meets none twice, and one that meets one twice never ends",
    ("refine/patch_triangulation.cpp",
     "auto PatchTriangulation::walk(SubFacet f, const Point2& x) const -> std::optional<Location> {",
     "for (std::size_t steps = 0; steps <= boundary_->sub_facets().size(); ++steps) {",
     "for (std::size_t steps = (0 + 1); steps <= boundary_->sub_facets().size(); ++steps) {"):
        "as above: so many steps as there are sub-facets are enough",
    ("refine/patch_triangulation.cpp",
     "const bool is_old_bad = is_encroached(a, b, c, d) || is_encroached(b, a, d, c);",
     "if (!is_old_bad && !boundary_->is_missing(first) && !boundary_->is_missing(second)) return false;", ""):
        "the shorter way: the lines below let an edge that is not bad go only where a sub-facet is missing",
    ("refine/patches.cpp", "for (int pass = 0; pass < kPasses && has_changed; ++pass) {",
     "has_changed = false;", "has_changed = true;"):
        "only more passes: after one that changes nothing the others change nothing",
    ("refine/sphere_set.cpp", "}",
     "if (num_cells > static_cast<double>(level.cells.size())) {  // a large sphere among small ones",
     "if (num_cells >= static_cast<double>(level.cells.size())) {  // a large sphere among small ones"):
        "two ways to the same answer: the cells that only one of them visits hold spheres that are far away",
}


def argument(fault):
    return ARGUMENTS.get((fault.file, fault.above, fault.before, fault.after))
