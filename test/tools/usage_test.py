# SPDX-License-Identifier: MIT
"""Help, version and wrong usage."""
import unittest

from program import TETRAHEDRON, ProgramTest, ellipsoid, off


class Usage(ProgramTest):
    def test_help_of_every_command_has_an_example(self):
        for command in ([], ["refine"], ["delaunay"], ["inspect"], ["generate"], ["reproduce"]):
            text = self.succeed(*command, "--help")
            self.assertIn("Example:\n  sinkmesh", text)

    def test_help_of_refine_names_every_option(self):
        text = self.succeed("refine", "--help")
        for option in ("--output", "--ratio", "--insert", "--reach", "--order", "--schedule", "--literal", "--fallback", "--threads",
                       "--max-vertices", "--time-limit", "--report", "--history", "--quiet", "--format", "--boundary",
                       "--small-angle", "--flat", "--min-angle"):
            self.assertIn(option, text)

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"^sinkmesh \d+\.\d+\.\d+\n$")

    def test_wrong_usage_is_one_line_with_a_hint(self):
        surface = self.write("in.off", off(TETRAHEDRON))
        out = ["-o", self.path("out.vtu")]
        for arguments in (
            [],
            ["mend"],
            ["refine"],
            ["refine", surface],
            ["refine", surface, *out, "--no-such-option"],
            ["refine", surface, *out, "--ratio", "0.9"],
            ["refine", surface, *out, "--ratio", "nan"],
            ["refine", surface, *out, "--ratio", "inf"],
            ["refine", surface, *out, "--ratio", "two"],
            ["refine", surface, *out, "--insert", "centroid"],
            ["refine", surface, *out, "--schedule", "random"],
            ["refine", surface, *out, "--fallback", "maybe"],
            ["refine", surface, *out, "--fallback", "circumcenter"],
            ["refine", surface, *out, "--fallback", "circumcenter", "--insert", "circumcenter"],
            ["refine", surface, *out, "--reach", "1.5", "--insert", "sink"],
            ["refine", surface, *out, "--literal"],
            ["refine", surface, *out, "--literal", "--insert", "sink"],
            ["refine", surface, *out, "--literal", "--schedule", "block"],
            ["refine", surface, *out, "--order", "largest"],
            ["refine", surface, *out, "--reach", "0.99"],
            ["refine", surface, *out, "--reach", "far"],
            ["refine", surface, *out, "--reach", "nan"],
            ["refine", surface, *out, "--boundary", "peel"],
            ["refine", surface, *out, "--small-angle", "0"],
            ["refine", surface, *out, "--small-angle", "60.5"],
            ["refine", surface, *out, "--small-angle", "flat"],
            ["refine", surface, *out, "--flat", "-1e-9"],
            ["refine", surface, *out, "--flat", "1"],
            ["refine", surface, *out, "--flat", "nan"],
            ["refine", surface, *out, "--min-angle", "20"],
            ["refine", surface, *out, "--threads", "0"],
            ["refine", surface, *out, "--threads", "-1"],
            ["refine", surface, *out, "--max-vertices", "-5"],
            ["refine", surface, *out, "--max-vertices", "1.5"],
            ["refine", surface, *out, "--time-limit", "-1"],
            ["refine", surface, *out, "--format", "docx"],
            ["refine", surface, *out, "--input-format", "docx"],
            ["refine", surface, "-o", self.path("out.docx")],
            ["refine", surface, "-o", self.path("out")],
            ["refine", surface, "-o", "-"],
            ["delaunay", surface],
            ["delaunay", surface, *out, "--engine", "magic"],
            ["delaunay", surface, *out, "--dimension", "4"],
            ["inspect"],
            ["inspect", "-"],
            ["generate"],
            ["generate", "star"],
            ["generate", "rotor", "-o", self.path("out.off")],
            ["generate", "star", "-o", self.path("out.docx")],
            ["generate", "star", "-o", "-"],
        ):
            with self.subTest(arguments=arguments):
                self.assertIn("--help", self.fail_with_one_line(2, *arguments))
        self.assertEqual(self.files(), ["in.off"])

    def test_an_angle_is_a_ratio_in_the_plane_only(self):
        space = self.write("in.off", off(TETRAHEDRON))
        plane = self.write("in.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n")
        out = ["-o", self.path("out.vtu")]
        for arguments, word in ((["refine", space, *out, "--min-angle", "20"], "for the plane"),
                                (["refine", plane, *out, "--min-angle", "20", "--ratio", "1"], "give one of them"),
                                (["refine", plane, *out, "--min-angle", "0"], "not above 0"),
                                (["refine", plane, *out, "--min-angle", "30.1"], "sure to end"),
                                (["refine", plane, *out, "--min-angle", "inf"], "not a finite number")):
            with self.subTest(arguments=arguments):
                self.assertIn(word, self.fail_with_one_line(2, *arguments))

    def test_unknown_suffix_of_output_lists_the_known_ones(self):
        surface = self.write("in.off", off(TETRAHEDRON))
        message = self.fail_with_one_line(2, "refine", surface, "-o", self.path("out.docx"))
        for name in ("vtu", "vtk", "msh"):
            self.assertIn(name, message)

    def test_standard_output_needs_a_format(self):
        surface = self.write("in.off", off(ellipsoid(2)))
        self.assertIn("--format", self.fail_with_one_line(2, "refine", surface, "-o", "-"))

    def test_a_report_does_not_replace_another_file(self):
        surface = self.write("in.off", off(ellipsoid(2)))
        out = self.path("out.vtu")
        for arguments in (["refine", surface, "-o", out, "--report", out],
                          ["refine", surface, "-o", out, "--history", self.path("./out.vtu")],
                          ["refine", surface, "-o", out, "--history", self.path("a"), "--report", self.path("a")],
                          ["refine", surface, "-o", self.path("b.node"), "--report", self.path("b.ele")],
                          ["delaunay", surface, "-o", out, "--report", surface],
                          ["inspect", surface, "--report", surface]):
            self.assertIn("same file", self.fail_with_one_line(2, *arguments))
        self.assertEqual(self.files(), ["in.off"])


if __name__ == "__main__":
    unittest.main()
