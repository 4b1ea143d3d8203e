# SPDX-License-Identifier: MIT
"""sinkmesh inspect: surfaces and meshes, good and broken."""
import unittest

from program import TETRAHEDRON, ProgramTest, ellipsoid, off

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]


def medit(points, tetrahedra):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += [" ".join(map(str, p)) + " 0" for p in points]
    lines += ["Tetrahedra", str(len(tetrahedra))]
    lines += [" ".join(str(v + 1) for v in t) + " 0" for t in tetrahedra]
    return "\n".join(lines + ["End", ""])


class Inspect(ProgramTest):
    def look(self, path, status):
        text = self.succeed("inspect", path, "--report", self.path("inspect.json"), status=status)
        return text, self.report("inspect.json")

    def test_a_good_surface(self):
        text, report = self.look(self.write("in.off", off(ellipsoid(3))), 0)
        self.assertIn("1 part", text)
        self.assertEqual(report["input"]["kind"], "surface")
        self.assertEqual(report["defects"], [])
        self.assertEqual(report["missing_facets"], 0)

    def test_whether_a_surface_is_stable(self):
        text, report = self.look(self.write("stable.off", off(ellipsoid(3, jitter=0))), 0)
        self.assertTrue(report["stable"])
        self.assertIn("refine keeps the surface as it is", text)
        text, report = self.look(self.write("corner.off", off(TETRAHEDRON)), 0)
        self.assertFalse(report["stable"])
        self.assertEqual(report["missing_facets"], 0)
        self.assertGreater(report["unstable_facets"], 0)
        self.assertIn("--boundary fixed peels off 1 tetrahedron", text)
        # A pyramid on a rhombus that is cut along its long diagonal.
        points = [(0, 0, 0), (2, -1, 0), (4, 0, 0), (2, 1, 0), (2, 0, 3)]
        facets = [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
        text, report = self.look(self.write("rhombus.off", off((points, facets))), 0)
        self.assertFalse(report["stable"])
        self.assertEqual(report["first_missing_facets"], [0, 1])
        self.assertIn("--boundary fixed refuses the surface", text)

    def test_every_defect_of_a_surface_is_listed(self):
        points, facets = ellipsoid(1)
        far_away = len(facets) // 2
        broken = facets[1:far_away] + facets[far_away + 1:]
        text, report = self.look(self.write("in.off", off((points, broken))), 1)
        self.assertGreaterEqual(len(report["defects"]), 2)
        for defect in report["defects"]:
            self.assertIn(defect["message"], text)

    def test_a_good_mesh(self):
        path = self.write("in.mesh", medit(POINTS, [(0, 1, 2, 3), (4, 1, 3, 2)]))
        text, report = self.look(path, 0)
        self.assertEqual(report["input"]["kind"], "mesh")
        self.assertTrue(report["valid"])
        self.assertTrue(report["delaunay"])
        self.assertEqual(report["quality"]["simplices"], 2)
        self.assertEqual(report["boundary_facets"], 6)
        self.assertEqual(sum(b["simplices"] for b in report["quality"]["histogram"]), 2)
        for word in ("Delaunay", "sink", "r/l", "dihedral", "boundary"):
            self.assertIn(word, text)

    def test_a_mesh_that_is_valid_but_not_delaunay(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.3, 0.3, 0.1), (0.3, 0.3, -0.1)]
        path = self.write("in.mesh", medit(points, [(0, 1, 2, 3), (0, 2, 1, 4)]))
        report = self.look(path, 0)[1]
        self.assertTrue(report["valid"])
        self.assertFalse(report["delaunay"])
        self.assertEqual(report["facets_not_delaunay"], 1)

    def test_defects_of_meshes(self):
        for name, tetrahedra in (("inverted", [(1, 0, 2, 3)]), ("same side", [(0, 1, 2, 3), (0, 1, 2, 4)]),
                                 ("twice", [(0, 1, 2, 3), (0, 1, 2, 3)])):
            with self.subTest(name=name):
                text, report = self.look(self.write("in.mesh", medit(POINTS, tetrahedra)), 1)
                self.assertFalse(report["valid"])
                self.assertTrue(report["defects"])
                self.assertIn(report["defects"][0]["message"], text)

    def test_standard_input(self):
        self.succeed("inspect", "-", "--format", "off", input=off(TETRAHEDRON).encode())

    def test_what_it_cannot_look_at(self):
        for arguments in ([self.path("missing.off")], [str(self.folder)], [self.write("a.xyz", "0 0 0\n1 1 1\n")],
                          [self.write("a.docx", "text")], [self.write("a.mesh", "text")]):
            with self.subTest(arguments=arguments):
                self.fail_with_one_line(1, "inspect", *arguments)


if __name__ == "__main__":
    unittest.main()
