# SPDX-License-Identifier: MIT
"""The plane: polygons in, triangles out, by every command and format."""
import math
import pathlib
import re
import unittest

from program import ProgramTest

USA = pathlib.Path(__file__).parent.parent / "data" / "paper" / "usa.poly"


def squares():
    """A square with a square hole, and another one beside it, in no consistent direction; numbered from 1."""
    points, segments = [], []
    for low, side, turn in (((0, 0), 4, 1), ((1, 1), 2, 1), ((6, 0), 3, -1)):
        corners = [(low[0], low[1]), (low[0] + side, low[1]), (low[0] + side, low[1] + side), (low[0], low[1] + side)]
        first = len(points)
        for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
            points += [(x + (u - x) * k / 8, y + (v - y) * k / 8) for k in range(8)]
        ring = list(range(first, len(points)))[::turn]
        segments += list(zip(ring, ring[1:] + ring[:1]))
    lines = [f"# comment\n{len(points)} 2 0 0"]
    lines += [f"{i + 1} {x} {y}" for i, (x, y) in enumerate(points)]
    lines += [f"{len(segments)} 0"]
    lines += [f"{i + 1} {a + 1} {b + 1}" for i, (a, b) in enumerate(segments)]
    return "\n".join(lines + ["1", "1 1.5 1.5"]) + "\n"


class Plane(ProgramTest):
    def refine(self, source, *arguments, out="out.vtu"):
        self.succeed("refine", source, "-o", self.path(out), "--report", self.path("report.json"), *arguments)
        return self.report()

    def test_the_outline_of_the_usa_is_refined_in_every_schedule(self):
        hashes = {}
        for insert in ("sink", "circumcenter"):
            for schedule in ("incremental", "block", "parallel"):
                report = self.refine(str(USA), "--ratio", "1", "--insert", insert, "--schedule", schedule,
                                     out="out.mesh")
                mesh = self.inspect(self.path("out.mesh"))
                self.assertEqual(report["initial"]["simplices"], 229)
                self.assertEqual(report["peeled"]["simplices"], 0)
                self.assertEqual(report["stop"], "no_candidate")
                self.assertTrue(mesh["delaunay"])
                self.assertEqual(mesh["unstable_facets"], 0)
                self.assertEqual(mesh["boundary_facets"], 231)
                self.assertEqual(mesh["hash"], report["hash"])
                self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
                self.assertLess(report["final"]["low_quality"], 0.1 * report["final"]["simplices"])
                hashes[insert, schedule] = report["hash"]
            for schedule in ("block", "parallel"):
                literal = self.refine(str(USA), "--ratio", "1", "--insert", insert, "--schedule", schedule, "--literal")
                self.assertEqual(literal["hash"], hashes[insert, schedule])
        self.assertEqual(len(set(hashes.values())), 6)

    def test_each_sink_adds_two_triangles(self):
        for sinks in (4, 12, 15):
            self.succeed("refine", str(USA), "-o", self.path("out.vtu"), "--ratio", "1", "--max-vertices",
                         str(231 + sinks), "--report", self.path("report.json"), status=3)
            self.assertEqual(self.report()["final"]["simplices"], 229 + 2 * sinks)

    def test_a_ratio_an_angle_and_the_default_are_one(self):
        default = self.refine(str(USA))
        self.assertEqual(default["options"]["ratio"], 1)
        for arguments in (["--ratio", "1"], ["--min-angle", "30"]):
            report = self.refine(str(USA), *arguments)
            self.assertEqual(report["options"]["ratio"], 1)
            self.assertEqual(report["hash"], default["hash"])
        report = self.refine(str(USA), "--min-angle", "20")
        self.assertAlmostEqual(report["options"]["ratio"], 0.5 / math.sin(math.radians(20)), places=14)
        self.assertNotEqual(report["hash"], default["hash"])
        self.assertEqual(self.inspect(self.path("out.vtu"))["options"]["ratio"], 1)

    def test_holes_and_components_are_found_by_parity(self):
        source = self.write("squares.poly", squares())
        report = self.refine(source, "--ratio", "1.2")
        self.assertEqual(report["input"]["dimension"], 2)
        self.assertEqual(set(report["final"]["angle"]), {"min", "max"})
        mesh = self.inspect(self.path("out.vtu"))
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["components"], 2)
        self.assertEqual(mesh["boundary_facets"], 96)
        self.assertEqual(self.inspect(source)["components"], 3)

    def test_every_format_holds_the_same_mesh(self):
        hashes = set()
        for out in ("a.vtu", "a.vtk", "a.mesh", "a.msh", "a.node"):
            report = self.refine(str(USA), "--ratio", "1", out=out)
            hashes |= {report["hash"], self.inspect(self.path(out))["hash"]}
        self.assertEqual(len(hashes), 1)

    def test_svg_draws_every_edge_once_and_the_boundary_again(self):
        report = self.refine(str(USA), "--ratio", "1", out="a.svg")
        text = (self.folder / "a.svg").read_text()
        paths = re.findall(r'<path [^>]*d="([^"]*)"', text)
        self.assertEqual(len(paths), 2)
        edges = (3 * report["final"]["simplices"] + 231) // 2
        self.assertEqual([path.count("M") for path in paths], [edges, 231])
        numbers = [float(x) for x in re.findall(r"-?[0-9.]+", paths[0])]
        self.assertLessEqual(max(numbers), 1000)
        self.assertGreaterEqual(min(numbers), 0)

    def test_svg_is_for_the_plane_only(self):
        line = self.fail_with_one_line(2, "delaunay", self.write("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"), "-o", self.path("a.svg"))
        self.assertIn("svg", line)

    def test_open_polygon_is_refused_and_its_ends_are_listed(self):
        source = self.write("open.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n")
        self.assertIn("open.poly:", self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu")))
        self.assertFalse((self.folder / "out.vtu").exists())
        text = self.succeed("inspect", source, "--report", self.path("report.json"), status=1)
        report = self.report()
        self.assertFalse(report["closed"])
        self.assertFalse(report["valid"])
        self.assertIn("valid       no", text)
        self.assertEqual([(note["kind"], note["severity"], note["vertices"], note["line"]) for note in report["notes"]],
                         [("dangling end", "note", [0], 7), ("dangling end", "note", [3], 9)])
        self.assertIn("belongs to facet 2 only [line 9]", text)

    def test_segments_that_cross_are_listed(self):
        # A square and its diagonals, which cross; then the same with a vertex where they do.
        square = "1 1 2\n2 2 3\n3 3 4\n4 4 1\n"
        source = self.write("crossed.poly", f"4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n6 0\n{square}5 1 3\n6 2 4\n")
        text = self.succeed("inspect", source, "--report", self.path("report.json"), status=1)
        defects = self.report()["defects"]
        self.assertEqual([(d["kind"], d["facets"], d["line"]) for d in defects], [("self-intersection", [4, 5], 11)])
        self.assertIn(defects[0]["message"], text)
        source = self.write("divided.poly", f"5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 2 2\n8 0\n{square}"
                            "5 1 5\n6 5 3\n7 2 5\n8 5 4\n")
        self.succeed("inspect", source, "--report", self.path("report.json"))
        report = self.report()
        self.assertNotIn("self-intersection", [d["kind"] for d in report["defects"]])
        self.assertEqual([(n["kind"], n["vertices"]) for n in report["notes"]],
                         [("non-manifold edge", [v]) for v in range(5)])

    def test_regions_without_whole_numbers_are_refused(self):
        source = self.write("squares.poly", squares() + "1\n1 0.5 0.5 2.5\n")
        line = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu"))
        self.assertRegex(line, r"squares\.poly:\d+: the attribute of this region is 2\.5: ")

    def test_seeds_that_cannot_be_are_told_by_number_and_line(self):
        square = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n"
        for seeds, words in (("2\n1 0.5 0.5\n2 5 5\n", r":13: hole 1 \(5, 5\) is not enclosed by the surface: "),
                             ("1\n1 0.5 0\n", r":12: hole 0 \(0\.5, 0\) lies on the surface: "),
                             ("0\n1\n1 0 0 7\n", r":13: region 0 \(0, 0\) lies on the surface: "),
                             ("0\n3\n1 .5 .5 7\n2 .5 .25 7\n3 .25 .25 8\n",
                              r":15: region 2 \(0\.25, 0\.25\) has the attribute 8, but lies in one region with a point that "
                              r"has 7: remove one of them$")):
            with self.subTest(seeds=seeds):
                source = self.write("in.poly", square + seeds)
                line = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu"))
                self.assertRegex(line, r"in\.poly" + words)
                told = self.succeed("inspect", source, "--report", self.path("report.json"), status=1)
                number, message = line[line.index(".poly:") + 6:].strip().split(": ", 1)
                self.assertIn(f"error       {message} [line {number}]", told)
                self.assertNotIn("valid       yes", told)
                self.assertEqual([defect["kind"] for defect in self.report()["defects"]], ["bounds nothing"])

    def test_an_edge_at_the_floor_is_no_small_angle(self):
        source = self.write("in.poly", "5 2 0 0\n1 0 0\n2 1e-9 0\n3 1 0\n4 1 1\n5 0 1\n5 0\n"
                            "1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 1\n")
        report = self.refine(source, "--boundary", "refine")
        self.assertGreater(report["remaining"]["total"], 0)
        self.assertEqual(report["remaining"]["separation"], report["remaining"]["total"])

    def test_points_that_rounding_puts_on_a_line(self):
        source = self.write("in.poly", "4 2 0 0\n1 0 0\n2 1e-200 0\n3 1e-200 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n")
        line = self.fail_with_one_line(1, "refine", source, "-o", self.path("out.vtu"))
        self.assertIn("all points are collinear (2 distinct, now that 2 had to be rounded: coordinates differ too much", line)

    def test_flips_and_stars_agree_on_degenerate_points(self):
        ring = "\n".join(f"{x} {y}" for x, y in [(5, 0), (3, 4), (4, 3), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3),
                                                 (-3, -4), (0, -5), (3, -4), (4, -3), (0, 0)])
        grid = "\n".join(f"{x} {y}" for x in range(12) for y in range(12))
        line = "\n".join(f"{x} 0" for x in range(50)) + "\n0 1"
        for points in (ring, grid, line):
            source = self.write("p.xyz", points + "\n")
            hashes = set()
            for engine in ("star", "flips"):
                self.succeed("delaunay", source, "-o", self.path("out.vtu"), "--engine", engine, "--report",
                             self.path("report.json"))
                hashes.add(self.report()["hash"])
            self.assertEqual(len(hashes), 1)


if __name__ == "__main__":
    unittest.main()
