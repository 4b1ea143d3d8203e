# SPDX-License-Identifier: MIT
"""sinkmesh generate: the paper's models, from the generator to the refined mesh."""
import unittest

from program import ProgramTest

# Triangles in the paper, genus.
SPACE = {"cuboctahedron": (7496, 0), "paraboloid": (6272, 0), "star": (53508, 0), "head": (67940, 1)}


class Generate(ProgramTest):
    def test_models_in_space_can_be_refined_as_they_are(self):
        for name, (triangles, genus) in SPACE.items():
            with self.subTest(name=name):
                surface = self.path(name + ".off")
                self.succeed("generate", name, "-o", surface, "--triangles", triangles // 10 + 1)
                report = self.inspect(surface)
                self.assertAlmostEqual(report["facets"] / (triangles / 10), 1, delta=0.02)
                self.assertEqual(report["genus"], genus)
                self.assertEqual(report["notes"], [])
                self.assertEqual(report["missing_facets"], 0)
                self.assertEqual(report["unstable_facets"], 0)
                self.assertEqual(report["peeled"], {"simplices": 0, "facets": 0})

                mesh = self.path(name + ".vtu")
                self.succeed("refine", surface, "-o", mesh, "--report", self.path("report.json"))
                final = self.report()["final"]
                self.assertGreater(final["vertices"], report["vertices"])
                self.assertLess(final["low_quality"], 0.05 * final["simplices"])
                self.assertTrue(self.inspect(mesh)["delaunay"])

    def test_the_paper_decides_the_size(self):
        text = self.succeed("generate", "paraboloid", "-o", self.path("a.off"))
        self.assertIn("6,272 triangles", text)
        self.assertEqual(self.inspect(self.path("a.off"))["facets"], 6272)

    def test_usa_is_a_polygon(self):
        for triangles in (23, 229, 500):
            path = self.path(f"{triangles}.poly")
            self.succeed("generate", "usa", "-o", path, "--triangles", triangles)
            report = self.inspect(path)
            self.assertEqual(report["facets"], triangles + 2)
            self.assertEqual(report["inside"]["simplices"], triangles)
            self.assertEqual(report["peeled"], {"simplices": 0, "facets": 0})

    def test_every_format_holds_the_same_surface(self):
        facts = []
        for suffix in ("off", "obj", "stl", "ply"):
            path = self.path("model." + suffix)
            self.succeed("generate", "paraboloid", "-o", path, "--triangles", 700, "--quiet")
            report = self.inspect(path)
            facts.append((report["vertices"], report["facets"], report["signed_volume"], report["box"]))
        self.assertAlmostEqual(facts[0][1], 700, delta=14)
        for other in facts[1:]:
            self.assertEqual(other[:2], facts[0][:2])
            self.assertEqual(other[3], facts[0][3])
            self.assertAlmostEqual(other[2], facts[0][2], places=12)

    def test_every_run_gives_the_same_bytes(self):
        for name, triangles in (("usa", 229), ("cuboctahedron", 1000), ("head", 6794)):
            arguments = ["generate", name, "-o", "-", "--format", "poly" if name == "usa" else "off"]
            arguments += ["--triangles", triangles]
            self.assertEqual(self.succeed(*arguments), self.succeed(*arguments))

    def test_quiet(self):
        self.assertEqual(self.succeed("generate", "usa", "-o", self.path("a.poly"), "-q"), "")

    def test_sizes_out_of_range(self):
        for name, (triangles, _) in (*SPACE.items(), ("usa", (229, 0))):
            for wrong in (-triangles, 0, triangles // 10 - 1, triangles * 10 + 1, 10**30, "many", 1.5):
                with self.subTest(name=name, triangles=wrong):
                    suffix = "poly" if name == "usa" else "off"
                    output = self.path("out." + suffix)
                    message = self.fail_with_one_line(2, "generate", name, "-o", output, "--triangles", wrong)
                    if isinstance(wrong, int) and abs(wrong) < 10**9:
                        self.assertIn(str(triangles * 10), message)
        self.assertEqual(self.files(), [])

    def test_a_model_of_the_other_dimension_than_the_format(self):
        self.assertIn(".poly", self.fail_with_one_line(2, "generate", "usa", "-o", self.path("usa.off")))
        self.assertIn(".off", self.fail_with_one_line(2, "generate", "star", "-o", self.path("star.poly")))

    def test_an_output_that_cannot_be_written(self):
        self.fail_with_one_line(1, "generate", "star", "-o", self.path("missing/star.off"))


if __name__ == "__main__":
    unittest.main()
