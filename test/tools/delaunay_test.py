# SPDX-License-Identifier: MIT
"""sinkmesh delaunay: points in, their triangulation out."""
import itertools
import random
import unittest

from program import DATA, ProgramTest, ellipsoid, needs_data, off


def xyz(points):
    return "".join(" ".join(repr(float(x)) for x in p) + "\n" for p in points)


class Delaunay(ProgramTest):
    def triangulate(self, path, *options, out="out.vtu"):
        self.succeed("delaunay", path, "-o", self.path(out), "--report", self.path("report.json"), *options)
        return self.report()

    def test_a_grid_fills_its_hull(self):
        path = self.write("grid.xyz", xyz(itertools.product(range(5), repeat=3)))
        report = self.triangulate(path)
        self.assertEqual(report["final"]["vertices"], 125)
        self.assertEqual(report["final"]["hull_facets"], 6 * 16 * 2)
        mesh = self.inspect(self.path("out.vtu"))
        self.assertTrue(mesh["delaunay"])
        self.assertGreater(mesh["cospherical_facets"], 0)

    def test_order_and_engine_do_not_matter(self):
        rng = random.Random(5)
        clouds = [[tuple(rng.random() for _ in range(3)) for _ in range(2000)],
                  list(itertools.product(range(8), repeat=3))]
        for points in clouds:
            hashes = set()
            for engine in ("star", "flips"):
                rng.shuffle(points)
                report = self.triangulate(self.write("points.xyz", xyz(points)), "--engine", engine)
                hashes |= {report["hash"], self.inspect(self.path("out.vtu"))["hash"]}
            self.assertEqual(len(hashes), 1)

    def test_duplicates_are_counted(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 0, 0)]
        path = self.write("points.xyz", xyz(points))
        report = self.triangulate(path)
        self.assertEqual(report["input"]["duplicates"], 2)
        self.assertEqual(report["final"]["simplices"], 1)
        self.assertIn("copies", self.succeed("delaunay", path, "-o", self.path("out.vtu")))

    def test_rounded_points_are_counted(self):
        points = [(0, 0, 0), (1e40, 0, 0), (0, 1e40, 0), (0, 0, 1e40), (1e-40, 1, 1)]
        report = self.triangulate(self.write("points.xyz", xyz(points)))
        self.assertEqual(report["input"]["rounded_points"], 1)

    def test_vertices_of_a_surface(self):
        report = self.triangulate(self.write("in.off", off(ellipsoid(2))), out="out.mesh")
        self.assertEqual(report["final"]["vertices"], 66)
        self.assertTrue(self.inspect(self.path("out.mesh"))["delaunay"])

    def test_points_in_the_plane(self):
        rng = random.Random(2)
        points = [(rng.random(), rng.random()) for _ in range(500)]
        report = self.triangulate(self.write("plane.csv", "x,y\n" + xyz(points).replace(" ", ",")))
        self.assertEqual(report["input"]["dimension"], 2)
        mesh = self.inspect(self.path("out.vtu"))
        self.assertEqual(mesh["input"]["dimension"], 2)
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["hash"], report["hash"])

    def test_dimension_can_be_chosen(self):
        path = self.write("heights.xyz", xyz((x, y, x * x + 3 * y * y) for x in range(4) for y in range(4)))
        self.assertEqual(self.triangulate(path)["input"]["dimension"], 3)
        self.assertEqual(self.triangulate(path, "--dimension", "2")["input"]["dimension"], 2)

    def test_points_that_span_nothing_are_refused_with_one_line(self):
        for name, points in (("plane", [(x, y, 0.25) for x in range(4) for y in range(4)]),
                             ("line", [(x, 2 * x, 3 * x) for x in range(9)]), ("one", [(1, 2, 3)] * 7),
                             ("few", [(0, 0, 0), (1, 0, 0), (0, 1, 0)])):
            with self.subTest(name=name):
                path = self.write(name + ".xyz", xyz(points))
                self.fail_with_one_line(1, "delaunay", path, "-o", self.path("out.vtu"))
                self.assertNotIn("out.vtu", self.files())

    def test_standard_streams(self):
        points = xyz(itertools.product(range(3), repeat=3)).encode()
        result = self.run_program("delaunay", "-", "--input-format", "xyz", "-o", "-", "--format", "msh", input=points)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        self.inspect(self.write("out.msh", result.stdout))

    def flow_of(self, dimension, count, seed):
        """The cells of a triangulation of random points: corners and the three numbers that --flow adds."""
        rng = random.Random(seed)
        points = [tuple(rng.random() for _ in range(dimension)) for _ in range(count)]
        path = self.write("points.xyz", xyz(points))
        report = self.triangulate(path, "--flow", "--dimension", str(dimension), out="out.node")
        cells = [tuple(map(int, line.split()[1:]))
                 for line in (self.folder / "out.ele").read_text().splitlines()[1:] if line and line[0] != "#"]
        base = min(min(cell[:dimension + 1]) for cell in cells)
        return report, [([points[v - base] for v in cell[:dimension + 1]], *cell[dimension + 1:]) for cell in cells]

    def test_flow_in_the_plane_gives_each_triangle_one_watershed(self):
        report, cells = self.flow_of(2, 500, 7)
        sinks = 0
        for (a, b, c), watershed, sink, count in cells:
            corners = ((a, b, c), (b, c, a), (c, a, b))
            acute = all(sum((q[k] - p[k]) * (r[k] - p[k]) for k in range(2)) > 0 for p, q, r in corners)
            self.assertEqual(sink >= 0, acute)
            self.assertEqual(count, 1 if watershed >= 0 else 0)
            if sink >= 0:
                self.assertEqual((watershed, sink), (sinks, sinks))
                sinks += 1
        self.assertGreater(sinks, 300)
        self.assertEqual(report["flow"]["sinks"], sinks)
        self.assertEqual(report["flow"]["to_omega_only"], sum(cell[1] < 0 for cell in cells))

    def test_flow_in_space_follows_shared_facets(self):
        report, cells = self.flow_of(3, 300, 8)
        self.assertEqual({cell[2] for cell in cells} - {-1}, set(range(report["flow"]["sinks"])))
        self.assertTrue(all((cell[1] >= 0) == (cell[3] > 0) for cell in cells))
        self.assertGreater(max(cell[3] for cell in cells), 1)
        by_facet = {}
        for cell in cells:
            for facet in itertools.combinations(sorted(cell[0]), 3):
                by_facet.setdefault(facet, []).append(cell)
        # A watershed is connected: a cell that is no sink has a neighbour of the same label.
        for cell in cells:
            if cell[1] >= 0 and cell[2] < 0:
                labels = [other[1] for facet in itertools.combinations(sorted(cell[0]), 3)
                          for other in by_facet[facet] if other is not cell]
                self.assertIn(cell[1], labels)

    def test_flow_is_cell_data_of_every_format(self):
        path = self.write("grid.xyz", xyz(itertools.product(range(4), repeat=3)))
        self.triangulate(path, "--flow", out="out.vtu")
        content = (self.folder / "out.vtu").read_bytes()
        for name in (b"watershed", b"sink", b"sinks"):
            self.assertIn(b'Name="' + name + b'"', content)
        for out in ("out.vtk", "out.mesh", "out.msh"):
            self.triangulate(path, "--flow", out=out)
            self.inspect(self.path(out))

    def test_without_flow_there_is_no_cell_data(self):
        path = self.write("grid.xyz", xyz(itertools.product(range(3), repeat=3)))
        self.assertNotIn("flow", self.triangulate(path))
        self.assertNotIn(b"watershed", (self.folder / "out.vtu").read_bytes())

    @needs_data
    def test_real_points(self):
        path = DATA / "real" / "points" / "kitten.xyz"
        self.assertEqual(self.triangulate(path)["hash"], self.triangulate(path, "--engine", "flips")["hash"])
        self.assertTrue(self.inspect(self.path("out.vtu"))["delaunay"])


if __name__ == "__main__":
    unittest.main()
