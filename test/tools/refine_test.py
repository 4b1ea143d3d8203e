# SPDX-License-Identifier: MIT
"""sinkmesh refine: results, reports, files."""
import itertools
import os
import unittest

from program import DATA, ProgramTest, ellipsoid, needs_data, off, shuffled

HISTORY_HEADER = ("round,vertices,simplices,low_quality,candidates,passed_boundary,inserted,"
                  "ratio_min,ratio_avg,ratio_max")


class Refine(ProgramTest):
    def setUp(self):
        super().setUp()
        self.surface = ellipsoid(3)
        self.input = self.write("in.off", off(self.surface))

    def hash_of(self, *arguments):
        self.succeed("refine", *arguments, "--report", self.path("report.json"))
        return self.report()["hash"]

    def test_report_has_every_key(self):
        self.succeed("refine", self.input, "-o", self.path("out.vtu"), "--report", self.path("report.json"))
        report = self.report()
        for key in ("program", "version", "input", "options", "initial", "final", "rounds", "candidates", "prestars",
                    "inserted", "rejected", "remaining", "separation", "peeled", "stop", "hash", "seconds",
                    "peak_memory_bytes", "boundary", "leftovers", "leftovers_total"):
            self.assertIn(key, report)
        for key in ("path", "vertices", "facets", "dimension", "duplicates", "rounded_points"):
            self.assertIn(key, report["input"])
        for key in ("ratio", "insert", "schedule", "fallback", "threads", "boundary", "small_angle", "flat"):
            self.assertIn(key, report["options"])
        self.assertEqual(set(report["boundary"]), {
            "mode", "regions", "patches", "joined_facets", "segments", "points_on_segments", "points_on_patches",
            "unconformed", "refine_points_on_segments", "refine_points_on_patches"})
        self.assertEqual(set(report["remaining"]), {
            "total", "boundary_facet", "boundary", "crossing", "separation", "omega", "small_angle", "untried"})
        for stage in ("initial", "final"):
            for key in ("vertices", "simplices", "low_quality", "ratio", "dihedral"):
                self.assertIn(key, report[stage])
            self.assertEqual(set(report[stage]["ratio"]), {"min", "avg", "max"})
            self.assertEqual(set(report[stage]["dihedral"]), {"min", "max"})
        self.assertLessEqual({"boundary", "crossing", "separation", "dependent"}, set(report["rejected"]))
        self.assertLessEqual({"read", "delaunay", "domain", "refine", "write", "total"}, set(report["seconds"]))
        self.assertRegex(report["hash"], "^[0-9a-f]{16}$")
        self.assertEqual(report["program"], "sinkmesh")
        self.assertEqual(report["stop"], "no_candidate")
        self.assertEqual(report["options"]["ratio"], 2)
        self.assertEqual(report["options"]["boundary"], "auto")
        self.assertEqual(report["options"]["flat"], 2.0**-42)
        self.assertEqual(report["input"]["vertices"], len(self.surface[0]))
        self.assertEqual(report["input"]["facets"], len(self.surface[1]))
        self.assertEqual(report["final"]["vertices"], report["initial"]["vertices"] + report["inserted"])
        self.assertEqual(report["final"]["low_quality"], report["remaining"]["total"])
        self.assertGreater(report["inserted"], 0)
        self.assertGreater(report["peak_memory_bytes"], 0)

    def test_the_mesh_is_what_the_report_says(self):
        out = self.path("out.mesh")
        self.succeed("refine", self.input, "-o", out, "--report", self.path("report.json"))
        report, mesh = self.report(), self.inspect(out)
        self.assertTrue(mesh["delaunay"])
        self.assertEqual(mesh["unstable_facets"], 0)
        self.assertEqual(mesh["hash"], report["hash"])
        for key in ("vertices", "simplices", "low_quality"):
            self.assertEqual(mesh["quality"][key], report["final"][key])

    def test_history_has_the_header_and_ends_with_the_result(self):
        for schedule in ("incremental", "block", "parallel"):
            self.succeed("refine", self.input, "-o", self.path("out.vtu"), "--schedule", schedule, "--history",
                         self.path("history.csv"), "--report", self.path("report.json"))
            lines = (self.folder / "history.csv").read_text().splitlines()
            report = self.report()
            self.assertEqual(lines[0], HISTORY_HEADER)
            rows = [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]
            self.assertEqual([int(row["round"]) for row in rows], list(range(len(rows))))
            self.assertEqual(int(rows[0]["simplices"]), report["initial"]["simplices"])
            self.assertEqual(int(rows[-1]["vertices"]), report["final"]["vertices"])
            self.assertEqual(int(rows[-1]["simplices"]), report["final"]["simplices"])
            self.assertEqual(sum(int(row["inserted"]) for row in rows), report["inserted"])
            self.assertEqual(float(rows[-1]["ratio_max"]), report["final"]["ratio"]["max"])

    def test_every_combination_meshes(self):
        points = [["offsink"], ["sink"], ["sink", "--fallback", "circumcenter"], ["circumcenter"]]
        for insert, schedule in itertools.product(points, ("incremental", "block", "parallel")):
            with self.subTest(insert=insert, schedule=schedule):
                out = self.path("out.vtu")
                self.succeed("refine", self.input, "-o", out, "--insert", *insert, "--schedule", schedule)
                self.assertTrue(self.inspect(out)["delaunay"])

    def test_literal_rounds_give_the_same_mesh(self):
        for schedule in ("block", "parallel"):
            arguments = [self.input, "-o", self.path("out.vtu"), "--insert", "sink", "--schedule", schedule]
            self.assertEqual(self.hash_of(*arguments), self.hash_of(*arguments, "--literal"))

    def test_the_order_of_the_input_does_not_matter(self):
        other = self.write("shuffled.off", off(shuffled(self.surface, seed=3)))
        for schedule in ("incremental", "block", "parallel"):
            arguments = ["-o", self.path("out.vtu"), "--schedule", schedule]
            self.assertEqual(self.hash_of(self.input, *arguments), self.hash_of(other, *arguments))

    def test_every_format_holds_the_same_mesh(self):
        hashes = set()
        for name, options in (("a.vtu", []), ("a.vtk", []), ("a.mesh", []), ("a.msh", []),
                              ("b.msh", ["--format", "msh2"]), ("a.node", [])):
            out = self.path(name)
            hashes.add(self.hash_of(self.input, "-o", out, *options))
            hashes.add(self.inspect(out)["hash"])
        self.assertEqual(len(hashes), 1)
        self.assertIn("a.ele", self.files())

    def test_standard_input_and_output(self):
        expected = self.hash_of(self.input, "-o", self.path("file.mesh"))
        text = off(self.surface).encode()
        result = self.run_program("refine", "-", "--input-format", "off", "-o", "-", "--format", "mesh", input=text)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        self.assertEqual(result.stdout, (self.folder / "file.mesh").read_bytes())
        self.assertIn(b"output", result.stderr)
        self.assertEqual(self.inspect(self.write("piped.mesh", result.stdout))["hash"], expected)
        # A format that only an input can have.
        self.succeed("refine", "-", "--format", "off", "-o", self.path("piped.vtu"), input=text)
        self.assertEqual(self.inspect(self.path("piped.vtu"))["hash"], expected)

    def test_quiet_prints_nothing(self):
        result = self.run_program("refine", self.input, "-o", self.path("out.vtu"), "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))

    def test_summary(self):
        text = self.succeed("refine", self.input, "-o", self.path("out.vtu"))
        for word in ("input", "domain", "before", "after", "tetrahedra", "r/l", "dihedral", "inserted", "time"):
            self.assertIn(word, text)

    def test_a_surface_that_is_stable_is_kept(self):
        stable = self.write("stable.off", off(ellipsoid(3, jitter=0)))
        hashes = set()
        for options in ([], ["--boundary", "auto"], ["--boundary", "fixed"]):
            text = self.succeed("refine", stable, "-o", self.path("out.vtu"), "--report", self.path("report.json"),
                                *options)
            self.assertIn("kept as given: it is stable", text)
            report = self.report()
            hashes.add(report["hash"])
            self.assertEqual(report["boundary"]["mode"], "fixed")
            self.assertEqual(report["boundary"]["regions"], 1)
            self.assertEqual(report["boundary"]["unconformed"], [])
            self.assertEqual(report["peeled"], {"simplices": 0, "facets": 0})
        self.assertEqual(len(hashes), 1)

    def test_options_of_the_boundary_are_in_the_report(self):
        self.succeed("refine", self.input, "-o", self.path("out.vtu"), "--report", self.path("report.json"),
                     "--boundary", "fixed", "--small-angle", "17", "--flat", "0")
        options = self.report()["options"]
        self.assertEqual((options["boundary"], options["small_angle"], options["flat"]), ("fixed", 17, 0))

    def test_output_may_replace_a_file(self):
        out = self.write("out.mesh", "something else")
        self.succeed("refine", self.input, "-o", out)
        self.inspect(out)

    def test_max_vertices_stops_early_with_a_valid_mesh(self):
        limit = len(self.surface[0]) + 5
        for schedule in ("incremental", "block", "parallel"):
            out = self.path("out.vtu")
            self.succeed("refine", self.input, "-o", out, "--schedule", schedule, "--max-vertices", limit, "--boundary",
                         "fixed", "--report", self.path("report.json"), status=3)
            report = self.report()
            self.assertEqual(report["stop"], "budget")
            self.assertLessEqual(report["final"]["vertices"], limit)
            self.assertTrue(self.inspect(out)["delaunay"])

    def test_files_that_cannot_be_used(self):
        good = self.input
        out = self.path("out.vtu")
        os.mkdir(self.path("folder.vtu"))
        for arguments, word in (
            ([self.path("missing.off"), "-o", out], "missing.off"),
            ([str(self.folder), "-o", out], str(self.folder)),
            ([self.path("folder.vtu"), "-o", out], "folder.vtu"),
            ([self.write("in.docx", "text"), "-o", out], "suffix"),
            ([self.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"), "-o", out], "sinkmesh delaunay"),
            ([good, "-o", self.path("no/such/out.vtu")], "out.vtu"),
            ([good, "-o", self.path("folder.vtu")], "folder"),
            ([good, "-o", out, "--report", self.path("no/such/report.json")], "report.json"),
            ([good, "-o", out, "--history", self.path("no/such/history.csv")], "history.csv"),
        ):
            with self.subTest(arguments=arguments):
                self.assertIn(word, self.fail_with_one_line(1, "refine", *arguments))
        self.assertEqual(self.files(), ["folder.vtu", "in.docx", "in.off", "points.xyz"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_a_full_disk(self):
        self.fail_with_one_line(1, "refine", self.input, "-o", "/dev/full", "--format", "vtu")
        self.fail_with_one_line(1, "refine", self.input, "-o", self.path("a.vtu"), "--report", "/dev/full")
        with open("/dev/full", "wb") as full:
            self.fail_with_one_line(1, "refine", self.input, "-o", "-", "--format", "vtu", "--quiet", stdout=full)
            self.fail_with_one_line(1, "refine", self.input, "-o", self.path("b.vtu"), stdout=full)
        self.assertFalse(os.path.isfile("/dev/full"))

    def test_a_surface_with_a_defect_is_refused_with_a_hint(self):
        points, facets = self.surface
        holed = self.write("holed.off", off((points, facets[1:])))
        message = self.fail_with_one_line(1, "refine", holed, "-o", self.path("out.vtu"))
        self.assertIn("sinkmesh inspect", message)
        self.assertEqual(self.files(), ["holed.off", "in.off"])

    @needs_data
    def test_patches_that_are_joined_too_boldly_end_with_a_line(self):
        model = DATA / "real" / "hand.off"
        for flat in ("1e-4", "3e-3"):
            message = self.fail_with_one_line(3, "refine", model, "-o", self.path("out.vtu"), "--flat", flat)
            self.assertIn("could not be divided", message)
            self.assertEqual(self.files(), ["in.off"])

    @needs_data
    def test_a_model_of_the_paper(self):
        model = DATA / "paper" / "cuboctahedron.off"
        for insert, simplices in (("sink", 16258), ("offsink", 13850)):
            with self.subTest(insert=insert):
                self.succeed("refine", model, "-o", self.path("out.vtu"), "--insert", insert, "--report",
                             self.path("report.json"))
                report = self.report()
                self.assertEqual(report["final"]["low_quality"], 0)
                self.assertLess(abs(report["final"]["simplices"] - simplices), 0.03 * simplices)
                self.assertTrue(self.inspect(self.path("out.vtu"))["delaunay"])


if __name__ == "__main__":
    unittest.main()
