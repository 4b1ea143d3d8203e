# SPDX-License-Identifier: MIT
"""Boundary refinement: surfaces that are not Delaunay or not stable as given, several regions, small angles."""
import itertools
import math
import pathlib
import unittest

from program import TETRAHEDRON, ProgramTest, ellipsoid, off

USA = pathlib.Path(__file__).parent.parent / "data" / "paper" / "usa.poly"
INSERTS = ("sink", "circumcenter")
SCHEDULES = ("incremental", "block", "parallel")


def joined(*surfaces):
    """One surface of several; equal points become one, and so do equal facets."""
    ids, points, facets, seen = {}, [], [], set()
    for surface_points, surface_facets in surfaces:
        for facet in surface_facets:
            new = []
            for p in (tuple(map(float, surface_points[v])) for v in facet):
                if p not in ids:
                    ids[p] = len(points)
                    points.append(p)
                new.append(ids[p])
            if frozenset(new) not in seen:
                seen.add(frozenset(new))
                facets.append(tuple(new))
    return points, facets


def turned(surface):
    points, facets = surface
    return points, [(a, c, b) for a, b, c in facets]


def box(low, high, cells=(1, 1, 1)):
    """Outward; every side a grid of rectangles, cut alike on opposite sides."""
    ids, points, facets = {}, [], []

    def vertex(index):
        if index not in ids:
            ids[index] = len(points)
            points.append(tuple(low[k] + (high[k] - low[k]) * index[k] / cells[k] for k in range(3)))
        return ids[index]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, cells[axis]):
            for i, j in itertools.product(range(cells[u]), range(cells[v])):
                corners = []
                for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    index = [0, 0, 0]
                    index[axis], index[u], index[v] = side, i + di, j + dj
                    corners.append(vertex(tuple(index)))
                a, b, c, d = corners
                facets += [(a, b, c), (a, c, d)] if side else [(a, c, b), (a, d, c)]
    return points, facets


def prism(outline):
    """Of height 1 over a polygon that is given counterclockwise and cut into fans from its first corner."""
    n = len(outline)
    points = [(x, y, 0.0) for x, y in outline] + [(x, y, 1.0) for x, y in outline]
    facets = []
    for i in range(1, n - 1):
        facets += [(0, i + 1, i), (n, n + i, n + i + 1)]
    for i in range(n):
        j = (i + 1) % n
        facets += [(i, j, n + j), (i, n + j, n + i)]
    return points, facets


def wedge(degrees):
    a = math.radians(degrees)
    return prism([(0.0, 0.0), (2.0, 0.0), (2 * math.cos(a), 2 * math.sin(a))])


CUBE = box((0, 0, 0), (1, 1, 1))
SURFACES = {  # surface, volume inside, regions
    "cube": (CUBE, 1, 1),
    "tetrahedron": (TETRAHEDRON, 1 / 6, 1),
    # Cut from the inner corner, from which all of it is seen.
    "l_shape": (prism([(1, 1), (1, 2), (0, 2), (0, 0), (2, 0), (2, 1)]), 3, 1),
    "grid": (box((0, 0, 0), (1, 1, 1), (12, 12, 12)), 1, 1),
    "plate": (box((0, 0, 0), (1, 1, 0.1)), 0.1, 1),
    "wedge": (wedge(20), 2 * math.sin(math.radians(20)), 1),
    "nested": (joined(box((0, 0, 0), (3, 3, 3)), turned(box((1, 1, 1), (2, 2, 2)))), 26, 1),
    "apart": (joined(CUBE, box((3, 0, 0), (4, 1, 1))), 2, 2),
    "sharing a facet": (joined(CUBE, box((1, 0, 0), (2, 1, 1))), 2, 2),
    "sharing an edge": (joined(CUBE, box((1, 1, 0), (2, 2, 1))), 2, 2),
}


def medit_mesh(path):
    """Points, and (corners, reference) of tetrahedra or triangles and of facets, from a MEDIT file of the program."""
    words = iter(pathlib.Path(path).read_text().split())
    found = {}
    sizes = {}
    for word in words:
        if word == "Dimension":
            dim = int(next(words))
            sizes = {"Vertices": dim + 1, "Tetrahedra": 5, "Triangles": 4, "Edges": 3}
        elif word in sizes:
            found[word] = [[next(words) for _ in range(sizes[word])] for _ in range(int(next(words)))]
    points = [tuple(map(float, row[:dim])) for row in found["Vertices"]]

    def cells(name):
        rows = [list(map(int, row)) for row in found[name]]
        return [(tuple(v - 1 for v in row[:-1]), row[-1]) for row in rows]

    names = ("Triangles", "Edges") if dim == 2 else ("Tetrahedra", "Triangles")
    return points, cells(names[0]), cells(names[1])


def volume(points, corners):
    p = points[corners[0]]
    rows = [[q - o for q, o in zip(points[v], p)] for v in corners[1:]]
    if len(rows) == 2:
        return (rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]) / 2
    (a, b, c), (d, e, f), (g, h, i) = rows
    return (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) / 6


def poly(points, segments, markers=None, holes=(), regions=()):
    lines = [f"{len(points)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points)]
    lines += [f"{len(segments)} {0 if markers is None else 1}"]
    for i, (a, b) in enumerate(segments):
        lines += [f"{i} {a} {b}" + ("" if markers is None else f" {markers[i]}")]
    lines += [str(len(holes))] + [f"{i} {x} {y}" for i, (x, y) in enumerate(holes)]
    lines += [str(len(regions))] + [f"{i} {x} {y} {tag}" for i, (x, y, tag) in enumerate(regions)]
    return "\n".join(lines) + "\n"


def ring(corners, first):
    n = len(corners)
    return [(first + i, first + (i + 1) % n) for i in range(n)]


def divided_square():
    """A square with a square hole, and a wall through what is left of it: two regions."""
    outer = [(0, 0), (6, 0), (12, 0), (12, 6), (6, 6), (0, 6)]
    inner = [(6, 2), (8, 2), (8, 4), (6, 4)]
    segments = ring(outer, 0) + ring(inner, 6) + [(1, 6), (9, 4)]
    markers = [1] * 6 + [2] * 4 + [3] * 2
    return poly(outer + inner, segments, markers, holes=[(7, 3)], regions=[(1, 1, 10), (11, 1, 20)])


class Boundary(ProgramTest):
    def refine(self, source, *options, out="out.mesh", status=0):
        self.succeed("refine", source, "-o", self.path(out), "--report", self.path("report.json"), *options,
                     status=status)
        return self.report()

    def check(self, report, out="out.mesh"):
        """The mesh is valid, Delaunay, stable, and what the report says; what is bad is listed."""
        mesh = self.inspect(self.path(out))
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["unstable_facets"], 0)
        self.assertEqual(mesh["hash"], report["hash"])
        self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
        self.assertEqual(report["leftovers_total"], report["remaining"]["total"])
        self.assertEqual(len(report["leftovers"]), min(report["leftovers_total"], 1000))
        for leftover in report["leftovers"]:
            self.assertGreater(leftover["ratio"], report["options"]["ratio"])
            if leftover["reason"] == "small_angle":
                self.assertIsNotNone(leftover["common"])
        if report["boundary"]["mode"] == "refine":
            self.assertEqual(report["peeled"], {"simplices": 0, "facets": 0})
        return mesh

    def check_volume(self, expected, regions=None):
        """Of the MEDIT file; returns the volumes by region."""
        points, simplices, facets = medit_mesh(self.path("out.mesh"))
        by_region = {}
        for corners, region in simplices:
            self.assertGreater(volume(points, corners), 0)
            by_region[region] = by_region.get(region, 0) + volume(points, corners)
        self.assertAlmostEqual(sum(by_region.values()), expected, delta=1e-9 * expected)
        if regions is not None:
            self.assertEqual(sorted(by_region), list(range(1, regions + 1)))
        return by_region, points, facets

    def test_every_surface_gets_a_conforming_mesh(self):
        for name, (surface, expected, regions) in SURFACES.items():
            with self.subTest(name=name):
                report = self.refine(self.write("in.off", off(surface)))
                mesh = self.check(report)
                self.assertEqual(report["boundary"]["mode"], "refine")
                self.assertEqual(report["boundary"]["regions"], regions)
                self.assertEqual(report["boundary"]["unconformed"], [])
                self.assertEqual(report["stop"], "no_candidate")
                _, points, facets = self.check_volume(expected, regions)
                self.assertEqual(points[:len(surface[0])], [tuple(map(float, p)) for p in surface[0]])
                # References of facets are their parents, counted from 1, and lie in their planes.
                self.assertEqual({parent for _, parent in facets} - set(range(1, len(surface[1]) + 1)), set())
                self.assertGreaterEqual(len(facets), mesh["boundary_facets"])

    def test_nothing_bad_is_left_where_no_angle_is_small(self):
        for name in ("cube", "l_shape", "grid", "nested", "apart", "sharing a facet"):
            with self.subTest(name=name):
                report = self.refine(self.write("in.off", off(SURFACES[name][0])))
                self.assertEqual(report["remaining"]["total"], 0)

    def test_every_combination_conforms(self):
        source = self.write("in.off", off(SURFACES["l_shape"][0]))
        for insert, schedule in itertools.product(INSERTS, SCHEDULES):
            with self.subTest(insert=insert, schedule=schedule):
                self.check(self.refine(source, "--insert", insert, "--schedule", schedule))
                self.check_volume(3, 1)

    def test_the_facet_between_two_cubes_is_listed_once(self):
        surface = SURFACES["sharing a facet"][0]
        self.refine(self.write("in.off", off(surface)))
        by_region, points, facets = self.check_volume(2, 2)
        for value in by_region.values():
            self.assertAlmostEqual(value, 1, delta=1e-9)
        between = [f for f, _ in facets if all(points[v][0] == 1 for v in f)]
        self.assertEqual(len(between), len({frozenset(f) for f in between}))
        area = 0
        for a, b, c in between:
            (_, u1, v1), (_, u2, v2), (_, u3, v3) = points[a], points[b], points[c]
            area += abs((u2 - u1) * (v3 - v1) - (u3 - u1) * (v2 - v1)) / 2
        self.assertAlmostEqual(area, 1, delta=1e-9)

    def test_a_grid_needs_no_point_to_conform(self):
        report = self.refine(self.write("in.off", off(SURFACES["grid"][0])))
        self.assertEqual(report["boundary"]["patches"], 6)
        self.assertEqual(report["boundary"]["joined_facets"], 12 * 144 - 6)
        self.assertEqual(report["boundary"]["segments"], 12 * 12)
        self.assertEqual(report["boundary"]["points_on_segments"], 0)
        self.assertEqual(report["boundary"]["points_on_patches"], 0)

    def test_what_is_left_at_a_small_angle_names_it(self):
        report = self.refine(self.write("in.off", off(wedge(5))))
        self.check(report)
        for leftover in report["leftovers"]:
            self.assertEqual(leftover["reason"], "small_angle")
            self.assertIn(next(iter(leftover["common"])), ("corner", "segment"))

    def test_a_stable_surface_is_kept_unless_asked(self):
        surface = ellipsoid(3, jitter=0)
        source = self.write("in.off", off(surface))
        kept = self.refine(source)
        self.assertEqual(kept["boundary"]["mode"], "fixed")
        self.check(kept)
        divided = self.refine(source, "--boundary", "refine")
        self.assertEqual(divided["boundary"]["mode"], "refine")
        self.check(divided)
        self.assertLessEqual(divided["remaining"]["total"], kept["remaining"]["total"])

    def test_fixed_refuses_what_is_not_delaunay(self):
        points = [(0, 0, 0), (2, -1, 0), (4, 0, 0), (2, 1, 0), (2, 0, 3)]
        facets = [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
        source = self.write("in.off", off((points, facets)))
        message = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu"), "--boundary", "fixed")
        self.assertIn("2 of 6 facets", message)
        self.check(self.refine(source))
        self.check_volume(4, 1)

    def test_a_limit_while_conforming_leaves_no_mesh(self):
        # Needs some ten thousand points on it before it is stable.
        source = self.write("in.off", off(box((0, 0, 0), (1, 1, 0.01))))
        (self.folder / "out.vtu").write_text("before")
        for limit in (["--time-limit", "0"], ["--max-vertices", "500"]):
            with self.subTest(limit=limit):
                message = self.fail_with_one_line(3, "refine", source, "-o", self.path("out.vtu"), "--report",
                                                  self.path("report.json"), "--history", self.path("h.csv"), *limit)
                self.assertRegex(message, r"in\.off: the limit was reached .*: no mesh is written; raise --max-vertices")
                self.assertEqual((self.folder / "out.vtu").read_text(), "before")
                self.assertNotIn("h.csv", self.files())
                report = self.report()
                self.assertIsNone(report["final"])
                self.assertIsNone(report["hash"])
                self.assertEqual(report["stop"], "budget")

    def test_order_and_orientation_do_not_matter(self):
        points, facets = SURFACES["l_shape"][0]
        hashes = set()
        for turn in (facets, facets[::-1], [(b, c, a) for a, b, c in facets], turned((points, facets))[1]):
            hashes.add(self.refine(self.write("in.off", off((points, turn))))["hash"])
        self.assertEqual(len(hashes), 1)

    def test_every_format_holds_regions_and_parents(self):
        source = self.write("in.off", off(SURFACES["sharing a facet"][0]))
        hashes = set()
        for out in ("a.vtu", "a.vtk", "a.mesh", "a.msh", "a.node"):
            report = self.refine(source, out=out)
            hashes |= {report["hash"], self.inspect(self.path(out))["hash"]}
        self.assertEqual(len(hashes), 1)
        content = (self.folder / "a.vtu").read_bytes()
        for name in (b"region", b"parent"):
            self.assertIn(b'Name="' + name + b'"', content)
        self.assertTrue((self.folder / "a.face").read_text().split("\n")[0].endswith(" 1"))

    def test_holes_regions_and_walls_in_the_plane(self):
        source = self.write("in.poly", divided_square())
        report = self.refine(source)
        self.check(report)
        self.assertEqual(report["boundary"]["regions"], 2)
        self.assertEqual(report["remaining"]["total"], 0)
        by_region, points, edges = self.check_volume(12 * 6 - 4, 2)
        self.assertEqual(sorted(round(a, 9) for a in by_region.values()), [32, 36])
        # References of edges are the markers of their segments.
        self.assertEqual({tag for _, tag in edges}, {1, 2, 3})
        length = sum(abs(points[a][1] - points[b][1]) for (a, b), tag in edges if tag == 3)
        self.assertAlmostEqual(length, 4, delta=1e-12)
        self.refine(source, out="out.vtu")
        for name in (b"region", b"tag", b"parent"):
            self.assertIn(b'Name="' + name + b'"', (self.folder / "out.vtu").read_bytes())

    def test_a_smaller_angle_needs_fewer_points(self):
        source = self.write("in.poly", divided_square())
        vertices = []
        for degrees in (10, 20, 30):
            report = self.refine(source, "--min-angle", degrees)
            self.assertGreaterEqual(report["final"]["angle"]["min"], degrees - 1e-9)
            vertices.append(report["final"]["vertices"])
        self.assertEqual(vertices, sorted(vertices))

    def test_the_outline_of_the_usa_without_bad_triangles(self):
        for insert, schedule in itertools.product(INSERTS, SCHEDULES):
            with self.subTest(insert=insert, schedule=schedule):
                report = self.refine(str(USA), "--boundary", "refine", "--insert", insert, "--schedule", schedule)
                self.check(report)
                for leftover in report["leftovers"]:
                    self.assertEqual(leftover["reason"], "small_angle")


if __name__ == "__main__":
    unittest.main()
