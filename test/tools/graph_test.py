# SPDX-License-Identifier: MIT
"""Graphs of segments in the plane, divided and refined: holes, regions, small angles."""
import itertools
import math
import pathlib
import unittest

import exact
import shapes
from program import ProgramTest

USA = pathlib.Path(__file__).parent.parent / "data" / "paper" / "usa.poly"
INSERTS = ("offsink", "sink", "circumcenter")
SCHEDULES = ("incremental", "block", "parallel")

GRAPHS = {
    "comb": shapes.comb(5),
    "fine comb": shapes.comb(6, 0.01, 1.0),
    "star": shapes.star(7, 5),
    "needles": shapes.star(5, 1),
    "blunt star": shapes.star(6, 40),
    "annulus": shapes.annulus(32, 16, 0.3),
    "thin annulus": shapes.annulus(40, 40, 0.97),
    "annulus around a small hole": shapes.annulus(60, 7, 0.02),
    "eccentric annulus": shapes.annulus(50, 30, 0.4, (0.55, 0.0)),
    "airfoils": shapes.two_airfoils(12),
    "fine airfoils": shapes.two_airfoils(40, 15),
    "four sectors": shapes.fan_square(4, False),
    "twelve sectors": shapes.fan_square(12, False),
    "sectors with loose segments": shapes.fan_square(5),
    **{f"random polygon {seed}": shapes.random_polygon(12 + 4 * seed, seed) for seed in range(10)},
}


class Graphs(ProgramTest):
    def refine(self, source, *options):
        self.succeed("refine", source, "-o", self.path("out.mesh"), "--report", self.path("report.json"), *options)
        return self.report()

    def refine_graph(self, graph, *options):
        """Without markers, so that references of edges are their segments."""
        report = self.refine(self.write("in.poly", graph.poly()), "--boundary", "refine", "--small-angle", 60, *options)
        self.check_mesh(report)
        self.check_segments(graph, exact.Mesh(self.path("out.mesh")))
        self.check_leftovers(graph, report)
        return report

    def check_mesh(self, report):
        inspected = self.inspect(self.path("out.mesh"))
        self.assertTrue(inspected["delaunay"])
        self.assertEqual(inspected["unstable_facets"], 0)
        self.assertEqual(inspected["hash"], report["hash"])
        self.assertEqual(report["stop"], "no_candidate")
        self.assertEqual(exact.Mesh(self.path("out.mesh")).defects(), [])

    def check_segments(self, graph, mesh):
        """Every segment is a path of edges that lie on it; what is between them has the right area."""
        given = [tuple(map(float, p)) for p in graph.points]
        self.assertEqual(mesh.points[:len(given)], given)
        rounding = 2 * math.ulp(max(abs(x) for p in given for x in p))
        pieces = {}
        for corners, reference in mesh.facets:
            pieces.setdefault(reference, []).append(corners)
        self.assertEqual(sorted(pieces), list(range(1, len(graph.segments) + 1)))
        for reference, edges in pieces.items():
            a, b = (given[v] for v in graph.segments[reference - 1])
            along = exact.minus(b, a)
            length = math.hypot(*along)

            def place(v, a=a, along=along, length=length):
                way = exact.minus(mesh.points[v], a)
                self.assertLessEqual(abs(way[0] * along[1] - way[1] * along[0]) / length, rounding)
                return exact.dot(way, along) / length

            edges = sorted((sorted(edge, key=place) for edge in edges), key=lambda edge: place(edge[0]))
            self.assertEqual((edges[0][0], edges[-1][1]) in (graph.segments[reference - 1],
                                                             graph.segments[reference - 1][::-1]), True)
            for edge, after in itertools.pairwise(edges):
                self.assertEqual(edge[1], after[0])
        self.assertAlmostEqual(sum(mesh.volumes().values()), graph.area, delta=1e-9 * graph.area)

    def check_leftovers(self, graph, report):
        """Only at angles of the graph below 60 degrees, each with the two segments and their corner."""
        self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
        self.assertEqual(report["leftovers_total"], report["remaining"]["total"])
        self.assertEqual(report["remaining"]["total"], report["remaining"]["small_angle"])
        for leftover in report["leftovers"]:
            self.assertGreaterEqual(leftover["ratio"], 1)
            (corner,) = leftover["common"]["corner"]
            rays = []
            for name in ("first", "second"):
                segment = leftover[name]["segment"]
                self.assertIn(corner, segment)
                rays.append(exact.minus(graph.points[sum(segment) - corner], graph.points[corner]))
            cosine = exact.dot(*rays) / (math.hypot(*rays[0]) * math.hypot(*rays[1]))
            self.assertGreater(cosine, 0.5 - 1e-9)

    def test_what_is_left_is_at_small_angles(self):
        for name, graph in GRAPHS.items():
            with self.subTest(name=name):
                report = self.refine_graph(graph)
                if name in ("comb", "fine comb", "annulus", "thin annulus", "four sectors"):
                    self.assertEqual(report["remaining"]["total"], 0)

    def test_what_is_given_with_a_graph_is_not_divided_in_vain(self):
        """A triangle at the tip has the angle of the tip, whatever is inserted: nothing is done for it."""
        sharp = {f"triangle of {degrees} degrees": shapes.polygon(shapes.sector(1, degrees))
                 for degrees in (0.5, 2, 5, 20, 29)}
        sharp.update({f"star of {spikes}": shapes.star(spikes, 5) for spikes in (5, 20, 60)})
        sharp["fan"] = shapes.sectors(30, 3)
        for name, graph in sharp.items():
            with self.subTest(name=name):
                source = self.write("in.poly", graph.poly())
                fixed = self.refine(source, "--boundary", "fixed")
                self.check_leftovers(graph, fixed)
                self.assertEqual(fixed["peeled"]["simplices"], 0)
                self.assertGreater(fixed["remaining"]["total"], 0)
                for insert in INSERTS:
                    divided = self.refine_graph(graph, "--insert", insert)
                    self.assertLessEqual(divided["remaining"]["total"], fixed["remaining"]["total"])

    def test_every_combination(self):
        for insert, schedule in itertools.product(INSERTS, SCHEDULES):
            for name in ("comb", "airfoils", "random polygon 2"):
                with self.subTest(name=name, insert=insert, schedule=schedule):
                    self.refine_graph(GRAPHS[name], "--insert", insert, "--schedule", schedule)

    def test_sinks_need_fewer_points(self):
        vertices = {
            insert: sum(self.refine_graph(graph, "--insert", insert)["final"]["vertices"] for graph in GRAPHS.values())
            for insert in INSERTS
        }
        self.assertLess(vertices["sink"], vertices["circumcenter"])

    def test_the_outline_of_the_usa(self):
        for insert, schedule in itertools.product(INSERTS, SCHEDULES):
            with self.subTest(insert=insert, schedule=schedule):
                report = self.refine(str(USA), "--boundary", "refine", "--small-angle", 60, "--insert", insert,
                                     "--schedule", schedule)
                self.check_mesh(report)
                self.assertEqual(report["remaining"]["total"], report["remaining"]["small_angle"])
                for leftover in report["leftovers"]:
                    self.assertIsNotNone(leftover["common"])

    def test_holes_regions_and_walls(self):
        graph = shapes.divided_square()
        source = self.write("in.poly", graph.poly())
        report = self.refine(source)
        self.check_mesh(report)
        self.assertEqual(report["boundary"]["regions"], 2)
        self.assertEqual(report["remaining"]["total"], 0)
        mesh = exact.Mesh(self.path("out.mesh"))
        self.assertEqual(sorted(round(area, 9) for area in mesh.volumes().values()), [32, 36])
        # References of edges are the markers of their segments.
        self.assertEqual({tag for _, tag in mesh.facets}, {1, 2, 3})
        length = sum(abs(mesh.points[a][1] - mesh.points[b][1]) for (a, b), tag in mesh.facets if tag == 3)
        self.assertAlmostEqual(length, 4, delta=1e-12)
        self.succeed("refine", source, "-o", self.path("out.vtu"))
        for name in (b"region", b"tag", b"parent"):
            self.assertIn(b'Name="' + name + b'"', (self.folder / "out.vtu").read_bytes())

    def test_a_smaller_angle_needs_fewer_points(self):
        source = self.write("in.poly", shapes.divided_square().poly())
        vertices = []
        for degrees in (10, 20, 30):
            report = self.refine(source, "--min-angle", degrees)
            self.assertGreaterEqual(report["final"]["angle"]["min"], degrees - 1e-9)
            vertices.append(report["final"]["vertices"])
        self.assertEqual(vertices, sorted(vertices))


if __name__ == "__main__":
    unittest.main()
