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

    @needs_data
    def test_real_points(self):
        path = DATA / "real" / "points" / "kitten.xyz"
        self.assertEqual(self.triangulate(path)["hash"], self.triangulate(path, "--engine", "flips")["hash"])
        self.assertTrue(self.inspect(self.path("out.vtu"))["delaunay"])


if __name__ == "__main__":
    unittest.main()
