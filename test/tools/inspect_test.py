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
        self.assertIn("yes: it bounds a solid", text)

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

    def test_self_intersections_are_listed(self):
        points, facets = ellipsoid(2)
        second = [(x + 0.9, y + 0.1, z + 0.1) for x, y, z in points]
        n = len(points)
        both = (points + second, facets + [tuple(v + n for v in facet) for facet in facets])
        text, report = self.look(self.write("in.off", off(both)), 1)
        self.assertFalse(report["valid"])
        self.assertGreater(len(report["defects"]), 10)
        for defect in report["defects"]:
            self.assertEqual(defect["kind"], "self-intersection")
            self.assertEqual(defect["severity"], "error")
            first, last = defect["facets"]
            self.assertLess(first, len(facets))
            self.assertGreaterEqual(last, len(facets))
            self.assertEqual(defect["vertices"], sorted(both[1][first] + both[1][last]))
            self.assertIn(defect["message"], text)
        self.assertEqual(text.count("move the facets apart"), 1)

    def test_parts_that_touch_are_a_note(self):
        points, facets = ellipsoid(0, jitter=0)
        second = [(2 + x, y, z) for x, y, z in points]
        second[1] = (5, 5, 5)  # the other part's vertex 0 takes its place
        ids = [0 if v == 1 else len(points) + v for v in range(len(points))]
        both = (points + second, facets + [tuple(ids[v] for v in facet) for facet in facets])
        text, report = self.look(self.write("in.off", off(both)), 0)
        self.assertEqual([n["kind"] for n in report["notes"]], ["non-manifold vertex", "unused vertex"])
        self.assertTrue(report["valid"])
        self.assertTrue(report["closed"])
        self.assertFalse(report["manifold"])
        self.assertIn("yes: its facets meet at common edges and vertices only", text)

    def test_a_wall_between_regions_is_a_note(self):
        # Two tetrahedra and the facet between them.
        points = [(1, 0, 0), (-1, 1, 0), (-1, -1, 0), (0, 0, 1), (0, 0, -1)]
        facets = [(0, 1, 2)] + [(a, b, top) for top in (3, 4) for a, b in ((0, 1), (1, 2), (2, 0))]
        report = self.look(self.write("in.off", off((points, facets))), 0)[1]
        self.assertEqual([(n["kind"], n["severity"]) for n in report["notes"]], [("non-manifold edge", "note")] * 3)
        self.assertTrue(report["closed"])
        self.assertEqual(report["defects"], [])

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
