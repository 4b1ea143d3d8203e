# SPDX-License-Identifier: MIT
"""sinkmesh refine --slivers, --coarsen: what is moved, what is told about it."""
import pathlib
import unittest

from program import ProgramTest, ellipsoid, off, shuffled

MODELS = pathlib.Path(__file__).resolve().parent.parent / "data" / "paper"


class Slivers(ProgramTest):
    def refine(self, *arguments, status=0):
        self.succeed("refine", *arguments, "-o", self.path("out.mesh"), "--report", self.path("report.json"),
                     status=status)
        return self.report()

    def test_cuboctahedron_keeps_its_size_and_loses_its_inner_slivers(self):
        report = self.refine(MODELS / "cuboctahedron.off", "--slivers")
        refined, final, slivers = report["refined"], report["final"], report["slivers"]
        self.assertGreater(refined["angles"]["below"]["5"], 100)
        self.assertLessEqual(final["angles"]["below"]["5"], 40)
        self.assertEqual(final["angles"]["inner_below"]["10"], 0)
        self.assertLessEqual(final["simplices"], refined["simplices"])
        self.assertEqual(final["low_quality"], 0)
        self.assertEqual(final["vertices"], refined["vertices"] + slivers["inserted"] - slivers["removed"])
        self.assertLess(slivers["cost_after"], slivers["cost_before"])
        self.assertEqual(slivers["remaining"]["total"], final["angles"]["below"]["15"])
        self.assertEqual(slivers["remaining"]["total"],
                         sum(slivers["remaining"][r] for r in ("boundary_vertices", "untried", "no_better_place")))
        angles = [sliver["angle"] for sliver in slivers["list"]]
        self.assertEqual(angles, sorted(angles))
        self.assertEqual(len(angles), slivers["remaining"]["total"])
        self.assertAlmostEqual(angles[0], final["dihedral"]["min"], 9)
        for stage in (report["initial"], refined, final):
            bins = stage["angles"]["histogram"]
            self.assertEqual([b["from"] for b in bins], list(range(0, 180, 5)))
            self.assertEqual(sum(b["angles"] for b in bins), 6 * stage["simplices"])
        mesh = self.inspect(self.path("out.mesh"))
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["unstable_facets"], 0)
        self.assertEqual(mesh["hash"], report["hash"])
        self.assertEqual(mesh["quality"]["angles"], final["angles"])

    def test_the_mesh_does_not_depend_on_the_order_of_the_input(self):
        surface = ellipsoid(3)
        hashes = set()
        for variant in (surface, shuffled(surface, 1), shuffled(surface, 2)):
            report = self.refine(self.write("in.off", off(variant)), "--slivers", "--coarsen", "--ratio", "1.3")
            self.assertGreater(report["slivers"]["moved"], 0)
            hashes.add(report["hash"])
        self.assertEqual(len(hashes), 1)

    def test_coarsening_takes_sinks_away_and_leaves_off_sinks(self):
        report = self.refine(MODELS / "cuboctahedron.off", "--coarsen")
        self.assertLess(100 * report["coarsening"]["removed"], report["inserted"])
        report = self.refine(MODELS / "cuboctahedron.off", "--coarsen", "--insert", "sink")
        self.assertGreater(20 * report["coarsening"]["removed"], report["inserted"])
        self.assertEqual(report["final"]["low_quality"], 0)
        self.assertEqual(report["final"]["vertices"],
                         report["initial"]["vertices"] + report["inserted"] - report["coarsening"]["removed"])

    def test_the_plane_has_angles_too(self):
        polygon = "8 2 0 0\n" + "".join(f"{i + 1} {x} {y}\n" for i, (x, y) in enumerate(
            [(0, 0), (9, 0), (10, 4), (7, 9), (6, 3), (4, 8), (3, 3), (1, 6)]))
        polygon += "8 0\n" + "".join(f"{i + 1} {i + 1} {(i + 1) % 8 + 1}\n" for i in range(8)) + "0\n"
        report = self.refine(self.write("in.poly", polygon), "--slivers", "--min-dihedral", "35")
        self.assertIn("angles", report["final"])
        self.assertLessEqual(report["slivers"]["cost_after"], report["slivers"]["cost_before"])
        self.assertTrue(self.inspect(self.path("out.mesh"))["delaunay"])

    def test_a_run_that_a_limit_ends_moves_nothing(self):
        report = self.refine(MODELS / "cuboctahedron.off", "--slivers", "--max-vertices", "3800", status=3)
        self.assertNotIn("slivers", report)
        report = self.refine(MODELS / "cuboctahedron.off", "--slivers", "--time-limit", "0", status=3)
        self.assertEqual(report["stop"], "budget")

    def test_summary_tells_what_was_moved_and_what_is_left(self):
        text = self.succeed("refine", MODELS / "cuboctahedron.off", "-o", self.path("out.mesh"), "--slivers",
                            "--coarsen")
        for part in ("refined", "dihedral below 5", "moved", "slivers", "with all vertices on the boundary",
                     "coarsened"):
            self.assertIn(part, text)

    def test_wrong_usage(self):
        out = self.path("out.mesh")
        self.fail_with_one_line(2, "refine", MODELS / "cuboctahedron.off", "-o", out, "--min-dihedral", "10")
        self.fail_with_one_line(2, "refine", MODELS / "cuboctahedron.off", "-o", out, "--slivers", "--min-dihedral",
                                "46")
        self.fail_with_one_line(2, "refine", MODELS / "cuboctahedron.off", "-o", out, "--slivers", "--min-dihedral",
                                "0")


if __name__ == "__main__":
    unittest.main(verbosity=2)
