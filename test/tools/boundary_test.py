# SPDX-License-Identifier: MIT
"""Boundary refinement in space: surfaces not Delaunay or not stable as given, regions, small angles, limits."""
import itertools
import math
import re
import unittest

import exact
import shapes
from program import TETRAHEDRON, ProgramTest, ellipsoid, off

INSERTS = ("offsink", "sink", "circumcenter")
SCHEDULES = ("incremental", "block", "parallel")

CUBE = shapes.cube()
NESTED = shapes.joined(shapes.cube(size=3), shapes.turned(shapes.cube(1, 1, 1)))
SHARED_FACET = shapes.joined(CUBE, shapes.cube(1))
SHARED_EDGE = shapes.joined(CUBE, shapes.cube(1, 1))
SHARED_CORNER = shapes.joined(CUBE, shapes.cube(1, 1, 1))
EIGHT = shapes.joined(*[shapes.cube(*corner) for corner in itertools.product((0, 1), repeat=3)])

# Without an angle below 60 degrees: nothing bad is left. Surface, volumes of its regions.
EASY = {
    "cube": (CUBE, [1]),
    "tetrahedron": (TETRAHEDRON, [1 / 6]),
    "box": (shapes.box((0, 0, 0), (1, 2, 3)), [6]),
    "beam": (shapes.box((0, 0, 0), (1, 5, 25)), [125]),
    "plate": (shapes.plate(10), [0.1]),
    "l-shape": (shapes.l_shape(), [3]),
    "grid": (shapes.box((0, 0, 0), (1, 1, 1), (6, 6, 6)), [1]),
    "grid, cut across": (shapes.box((0, 0, 0), (1, 1, 1), (6, 6, 6), other_diagonals=True), [1]),
    "uneven grid": (shapes.box((0, 0, 0), (1, 1, 1), (3, 7, 5)), [1]),
    "nested": (NESTED, [26]),
    "nested twice": (shapes.joined(shapes.cube(size=5), shapes.turned(shapes.cube(1, 1, 1, 3)),
                                   shapes.cube(2, 2, 2)), [1, 98]),
    "apart": (shapes.joined(CUBE, shapes.cube(3)), [1, 1]),
    "nearly touching": (shapes.joined(CUBE, shapes.cube(1.01)), [1, 1]),
    "sharing a facet": (SHARED_FACET, [1, 1]),
    "sharing an edge": (SHARED_EDGE, [1, 1]),
    "sharing a corner": (SHARED_CORNER, [1, 1]),
    "eight": (EIGHT, [1] * 8),
}


class Boundary(ProgramTest):
    def refine(self, source, *options, out="out.mesh", status=0):
        self.succeed("refine", source, "-o", self.path(out), "--report", self.path("report.json"), *options,
                     status=status)
        return self.report()

    def refine_surface(self, surface, *options, status=0):
        return self.refine(self.write("in.off", off(surface)), *options, status=status)

    def check(self, surface, report, volumes=None):
        """The mesh is what it shall be, by `inspect` and by an exact look, and what the report says."""
        inspected = self.inspect(self.path("out.mesh"))
        self.assertTrue(inspected["delaunay"])
        self.assertEqual(inspected["unstable_facets"], 0)
        self.assertEqual(inspected["hash"], report["hash"])
        self.assertEqual(report["stop"], "no_candidate")
        self.assertEqual(report["boundary"]["unconformed"], [])
        self.assertEqual(report["peeled"], {"simplices": 0, "facets": 0})
        self.check_leftovers(report)
        mesh = exact.Mesh(self.path("out.mesh"))
        self.assertEqual(mesh.defects(), [])
        given = [tuple(map(float, p)) for p in surface[0]]
        self.assertEqual(mesh.points[:len(given)], given)
        self.assertEqual(mesh.flat(len(given)), [])
        if volumes is not None:
            found = mesh.volumes()
            self.assertEqual(sorted(found), list(range(1, len(volumes) + 1)))
            self.assertEqual(report["boundary"]["regions"], len(volumes))
            for one, other in zip(sorted(found.values()), sorted(volumes)):
                self.assertAlmostEqual(one, other, delta=1e-9 * other)
        self.check_parents(surface, mesh)
        return mesh

    def check_leftovers(self, report):
        self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
        self.assertEqual(report["leftovers_total"], report["remaining"]["total"])
        self.assertEqual(len(report["leftovers"]), min(report["leftovers_total"], 1000))
        for leftover in report["leftovers"]:
            self.assertGreater(leftover["ratio"], report["options"]["ratio"])
        if report["leftovers_total"] <= 1000:
            for reason, count in report["remaining"].items():
                if reason != "total":
                    self.assertEqual(sum(left["reason"] == reason for left in report["leftovers"]), count)

    def check_parents(self, surface, mesh):
        """References of facets are their parents, counted from 1: the pieces lie on these and have their area."""
        points, facets = surface
        size = max(abs(x) for p in points for x in p)
        flat = 2.0**-42 * math.dist([min(p[k] for p in points) for k in range(3)],
                                    [max(p[k] for p in points) for k in range(3)])
        tolerance = 2 * flat + 2 * math.ulp(size)
        normals = []
        total = 0
        for facet in facets:
            n = normal(*(points[v] for v in facet))
            length = math.hypot(*n)
            total += length / 2
            normals.append([x / length for x in n])
        area = 0
        for corners, reference in mesh.facets:
            self.assertTrue(1 <= reference <= len(facets))
            origin = points[facets[reference - 1][0]]
            for v in corners:
                height = exact.dot(normals[reference - 1], exact.minus(mesh.points[v], origin))
                self.assertLessEqual(abs(height), tolerance)
            area += math.hypot(*normal(*(mesh.points[v] for v in corners))) / 2
        self.assertAlmostEqual(area, total, delta=1e-9 * total)

    def test_the_exact_look_sees_what_is_broken(self):
        self.refine_surface(EASY["nested"][0])
        broken = {
            "is inside the sphere": lambda mesh: mesh.whole.append(mesh.whole.pop()[:2] + (2 * mesh.unit + 1, )),
            "is turned": lambda mesh: mesh.simplices.append((turned(mesh.simplices[0][0]), 1)),
            "not listed": lambda mesh: mesh.facets.pop(),
            "is at no simplex": lambda mesh: mesh.facets.append(((0, 1, len(mesh.points) - 1), 1)),
            "are equal": lambda mesh: mesh.whole.append(mesh.whole[0]),
        }
        for message, change in broken.items():
            mesh = exact.Mesh(self.path("out.mesh"))
            change(mesh)
            self.assertIn(message, "\n".join(mesh.defects()) + "\n")
        # The corner of a cube: its circumcenter lies beyond the fourth facet.
        points, _ = TETRAHEDRON
        self.assertLess(exact.diametral_power(points[1:], points[0]), 0)
        self.assertEqual(exact.diametral_power(points[:3], points[3]), 1)

    def test_nothing_bad_is_left_where_no_angle_is_small(self):
        for name, (surface, volumes) in EASY.items():
            with self.subTest(name=name):
                report = self.refine_surface(surface)
                self.check(surface, report, volumes)
                self.assertEqual(report["remaining"]["total"], 0)

    def test_a_rotation_changes_none_of_it(self):
        for name in ("cube", "plate", "beam", "l-shape", "nested", "sharing a facet", "sharing a corner"):
            with self.subTest(name=name):
                surface, volumes = EASY[name]
                surface = shapes.moved(surface, 37.3, scale=0.01, shift=(5, 6, 7))
                report = self.refine_surface(surface)
                self.check(surface, report, [v * 1e-6 for v in volumes])
                self.assertEqual(report["remaining"]["total"], 0)

    def test_every_combination_conforms(self):
        for insert, schedule in itertools.product(INSERTS, SCHEDULES):
            for name in ("l-shape", "eight"):
                with self.subTest(name=name, insert=insert, schedule=schedule):
                    surface, volumes = EASY[name]
                    report = self.refine_surface(surface, "--insert", insert, "--schedule", schedule)
                    self.check(surface, report, volumes)
                    self.assertEqual(report["remaining"]["total"], 0)

    def test_small_angles_end_with_reasons(self):
        bodies = ((shapes.wedge, (1, 10, 50, 89)), (shapes.pyramid, (2, 20, 45, 80)), (shapes.spire, (2, 15, 40, 89)),
                  (shapes.schoenhardt, (-10, -30)))
        for body, angles in bodies:
            for degrees, turn in itertools.product(angles, (0, 33)):
                surface = shapes.moved(body(degrees), turn)
                with self.subTest(body=body.__name__, degrees=degrees, turn=turn):
                    report = self.refine_surface(surface)
                    self.check(surface, report)
                    remaining = report["remaining"]
                    # Beside a facet that is itself a needle there is nothing to be done; and where points on the
                    # boundary would leave more behind than they mend, it stays undivided.
                    reasons = ["small_angle", "boundary_facet"]
                    if report["boundary"]["refine_points_on_segments"] == 0:
                        reasons.append("boundary")
                    self.assertEqual(remaining["total"], sum(remaining[reason] for reason in reasons))
                    for leftover in report["leftovers"]:
                        if leftover["reason"] == "small_angle":
                            self.assertIsNotNone(leftover["common"])
                            self.assertIn(next(iter(leftover["common"])), ("corner", "segment"))

    def test_the_facet_between_two_cubes_is_listed_once(self):
        report = self.refine_surface(SHARED_FACET)
        mesh = self.check(SHARED_FACET, report, [1, 1])
        between = [corners for corners, _ in mesh.facets if all(mesh.points[v][0] == 1 for v in corners)]
        self.assertEqual(len(between), len({frozenset(corners) for corners in between}))
        area = sum(math.hypot(*normal(*(mesh.points[v] for v in corners))) / 2 for corners in between)
        self.assertAlmostEqual(area, 1, delta=1e-12)

    def test_a_grid_needs_no_point_to_conform(self):
        boundary = self.refine_surface(shapes.box((0, 0, 0), (1, 1, 1), (12, 12, 12)))["boundary"]
        self.assertEqual(boundary["patches"], 6)
        self.assertEqual(boundary["joined_facets"], 12 * 144 - 6)
        self.assertEqual(boundary["segments"], 12 * 12)
        self.assertEqual(boundary["points_on_segments"], 0)
        self.assertEqual(boundary["points_on_patches"], 0)

    def test_a_stable_surface_is_kept_unless_asked(self):
        surface = ellipsoid(3, jitter=0)
        kept = self.refine_surface(surface)
        self.assertEqual(kept["boundary"]["mode"], "fixed")
        self.check(surface, kept)
        divided = self.refine_surface(surface, "--boundary", "refine")
        self.assertEqual(divided["boundary"]["mode"], "refine")
        self.check(surface, divided)
        self.assertLessEqual(divided["remaining"]["total"], kept["remaining"]["total"])

    def test_dividing_leaves_no_more_than_what_is_given(self):
        """Needles over a triangle, acute ones, so that they are stable: their tips are of low quality whatever is done."""
        triangle = [(math.cos(a), math.sin(a), 0) for a in (0, 2, 4)]
        for height, both in itertools.product((8, 15, 40), (False, True)):
            points = [*triangle, (0, 0, height), (0, 0, -height)][:5 if both else 4]
            sides = [(0, 1, 3), (1, 2, 3), (2, 0, 3)]
            below = [(b, a, 4) for a, b, _ in sides] if both else [(0, 2, 1)]
            surface = points, sides + below
            with self.subTest(height=height, both=both):
                fixed = self.refine_surface(surface, "--boundary", "fixed")
                self.assertEqual(fixed["peeled"]["simplices"], 0)
                self.assertGreater(fixed["remaining"]["total"], 0)
                divided = self.refine_surface(surface, "--boundary", "refine")
                self.check(surface, divided)
                self.assertLessEqual(divided["remaining"]["total"], fixed["remaining"]["total"])

    def test_fixed_refuses_what_is_not_delaunay(self):
        points = [(0, 0, 0), (2, -1, 0), (4, 0, 0), (2, 1, 0), (2, 0, 3)]
        surface = points, [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
        source = self.write("in.off", off(surface))
        message = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu"), "--boundary", "fixed")
        self.assertIn("2 of 6 facets", message)
        self.check(surface, self.refine(source), [4])

    def test_a_limit_while_conforming_leaves_no_mesh(self):
        # Two sheets, so near to each other that each needs thousands of points before it is stable.
        surface = shapes.joined(shapes.cube(size=10), shapes.turned(shapes.cube(0.1, 0.1, 0.1, 9.8)))
        source = self.write("in.off", off(surface))
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

    def test_a_limit_after_conforming_leaves_a_valid_mesh(self):
        report = self.refine_surface(shapes.plate(100), "--max-vertices", 1000, status=3)
        self.assertEqual(report["stop"], "budget")
        self.check_leftovers(report)
        mesh = exact.Mesh(self.path("out.mesh"))
        self.assertEqual(mesh.defects(), [])
        self.assertLessEqual(len(mesh.points), 1000)
        self.assertAlmostEqual(mesh.volumes()[1], 0.01, delta=1e-12)

    def test_a_limit_loses_little(self):
        """What is divided for quality is kept, and what remains is told of what is written."""
        for limit in (1000, 2000, 4000):
            report = self.refine_surface(shapes.plate(100), "--max-vertices", limit, status=3)
            self.assertGreater(report["final"]["vertices"], limit * 31 / 32 - 300)
            self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
            self.assertEqual(report["remaining"]["untried"], report["remaining"]["total"])

    def test_an_early_end_is_told_even_if_quiet(self):
        source = self.write("in.off", off(shapes.plate(100)))
        line = self.fail_with_one_line(3, "refine", source, "-o", self.path("out.mesh"), "-q", "--max-vertices", 1000)
        self.assertRegex(line, r"in\.off: stopped early, at the limit that was set; the mesh is Delaunay and stable")
        self.assertTrue((self.folder / "out.mesh").exists())

    def test_facets_in_one_plane_up_to_rounding_are_one_unless_told_otherwise(self):
        # A prism over a triangle, turned.
        points = [(0, 0, 0), (0.8375315159647386, 0.45011488802449345, -0.3097378687608354),
                  (0.29114249725571784, 1.1400727598283114, -0.7845190555934007),
                  (0, 0.5668815773286727, 0.8237992942976803),
                  (0.8375315159647386, 1.0169964653531662, 0.5140614255368449),
                  (0.29114249725571784, 1.7069543371569842, 0.039280238704279546)]
        surface = (points, [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)])
        joined = self.refine_surface(surface)
        self.check(surface, joined)
        self.assertEqual(joined["boundary"]["joined_facets"], 3)
        single = self.refine_surface(surface, "--flat", 0)
        self.check(surface, single)
        self.assertEqual(single["boundary"]["joined_facets"], 0)
        self.assertGreater(single["final"]["vertices"], joined["final"]["vertices"])

    def test_webs_of_small_angles_conform(self):
        """Facets of 5 to 8 degrees above each other; images of points next to segments, and short arcs on collars."""
        for surface in (
            ([(669, 521, 5), (563, 495, 27.7), (907, 449, 91.5), (825, 755, 72.8), (587, 863, 92.9),
              (980, 921, 97.9), (321, 207, 91.4)],
             [(0, 1, 2), (1, 3, 2), (0, 1, 3), (0, 3, 2), (4, 1, 3), (0, 4, 3), (0, 5, 4), (5, 4, 3),
              (0, 5, 3), (6, 4, 1), (6, 1, 3), (6, 4, 3)]),
            ([(5, 0, 3), (4, 1, 5), (5, 0, 4), (5, 3, 1), (1, 0, 0), (3, 1, 1), (0, 5, 1), (0, 4, 2)],
             [(0, 1, 2), (1, 3, 2), (0, 1, 3), (0, 3, 2), (4, 0, 3), (4, 0, 5), (4, 5, 3), (6, 7, 1),
              (6, 7, 3), (7, 1, 3), (6, 1, 3), (4, 1, 2), (4, 5, 1), (4, 5, 2), (5, 1, 2), (0, 5, 2),
              (5, 1, 3), (7, 4, 1), (7, 5, 1), (6, 7, 4), (6, 7, 5), (6, 4, 5)]),
        ):
            report = self.refine_surface(surface)
            self.check(surface, report)
            self.assertGreater(report["boundary"]["points_on_segments"], 0)

    def test_rings_of_points_around_a_tip_do_not_breed(self):
        """Nearly cocircular corners have to be divided, which once went on, ring by ring, to the tip."""
        for n in (8, 12, 16, 24):
            with self.subTest(n=n):
                surface = shapes.moved(shapes.cone(n, 5), 33)
                report = self.refine_surface(surface)
                self.check(surface, report)
                self.assertLess(report["final"]["vertices"], 30 * n)

    def test_dividing_leaves_no_more_than_it_found(self):
        for degrees in (2, 5, 10):
            report = self.refine_surface(shapes.wedge(degrees))
            self.assertLessEqual(report["final"]["low_quality"], report["initial"]["low_quality"])
            self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])

    def test_pieces_of_an_aligned_plate_stay_aligned(self):
        """Equal tiles, as large as the bound lets them be: six tetrahedra each, of one shape."""
        for k, insert in itertools.product((10, 30), INSERTS):
            report = self.refine_surface(shapes.plate(k), "--insert", insert)
            self.assertLess(report["final"]["simplices"], k * k)
            self.assertAlmostEqual(report["final"]["ratio"]["min"], report["final"]["ratio"]["max"], delta=1e-9)

    def test_unused_points_are_left_out(self):
        """A loose vertex, on the surface or in it, would lie in circumspheres."""
        points, facets = shapes.plate(10)
        self.refine_surface((points, facets))
        made = exact.Mesh(self.path("out.mesh"))
        loose = [(-1.0, 0.0, 0.0), *made.points[len(points)::3], (-1.0, 0.0, 0.0), *points[:2]]
        first = len(loose) // 2
        moved = [tuple(v + first for v in facet) for facet in facets]
        report = self.refine_surface(([*loose[:first], *points, *loose[first:]], moved))
        mesh = exact.Mesh(self.path("out.mesh"))
        self.assertEqual((mesh.points, mesh.simplices), (made.points, made.simplices))
        self.assertEqual(report["input"]["unused_points"], len(loose))
        told = self.succeed("refine", self.path("in.off"), "-o", self.path("out.mesh"))
        self.assertIn(f"{len(loose)} vertices belong to no facet: left out", told)

    def test_facets_that_cannot_be_divided_are_found_in_the_file(self):
        crossing = shapes.joined(shapes.cube(), shapes.cube(0.5, 0.5, 0.5))
        flat = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.3, 0.3, 1e-12)], TETRAHEDRON[1])
        for surface, words in ((crossing, "cross, touch or overlap"), (flat, "less than a thousandth of a degree")):
            source = self.write("in.off", off(surface))
            message = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.mesh"))
            line, facet = re.match(r".*in\.off:(\d+): facets (\d+) and \d+ of the surface ", message).groups()
            self.assertEqual(int(line), 3 + len(surface[0]) + int(facet))
            self.assertIn(words, message)
        told = self.succeed("inspect", source)
        self.assertIn(f"refine refuses the surface: facets {facet} and", told)
        self.assertNotIn("refine divides", told)

    def test_order_and_orientation_do_not_matter(self):
        points, facets = EASY["l-shape"][0]
        hashes = set()
        for turn in (facets, facets[::-1], [(b, c, a) for a, b, c in facets], shapes.turned((points, facets))[1]):
            hashes.add(self.refine_surface((points, turn))["hash"])
        self.assertEqual(len(hashes), 1)

    def test_every_format_holds_regions_and_parents(self):
        source = self.write("in.off", off(SHARED_FACET))
        hashes = set()
        for out in ("a.vtu", "a.vtk", "a.mesh", "a.msh", "a.node"):
            report = self.refine(source, out=out)
            hashes |= {report["hash"], self.inspect(self.path(out))["hash"]}
        self.assertEqual(len(hashes), 1)
        content = (self.folder / "a.vtu").read_bytes()
        for name in (b"region", b"parent"):
            self.assertIn(b'Name="' + name + b'"', content)
        self.assertTrue((self.folder / "a.face").read_text().split("\n")[0].endswith(" 1"))


def normal(a, b, c):
    """Twice as long as the area."""
    u, v = exact.minus(b, a), exact.minus(c, a)
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def turned(corners):
    return (corners[1], corners[0], *corners[2:])


if __name__ == "__main__":
    unittest.main()
