# SPDX-License-Identifier: MIT
"""Every nasty input: a valid mesh, or one line that says what is wrong. Never a signal, a hang, half a file."""
import re
import unittest

from program import DATA, ProgramTest, needs_data

NASTY = DATA / "real" / "nasty"
SECONDS = 5

# What no program should mesh without a word.
REFUSED = {
    "open_surface", "real_holes_open", "duplicate_vertices", "degenerate_triangles", "t_junction", "nonmanifold_edge",
    "duplicate_faces", "self_intersecting", "real_camel_selfint", "real_cow_duplicate_selfint", "nan_coordinate",
    "inf_coordinate", "truncated", "empty", "header_only", "index_out_of_range", "negative_index", "words_for_numbers",
    "not_a_mesh", "flat_closed_surface", "collinear_points", "coplanar_points",
    "coplanar_tilted_points", "identical_points", "three_points"
}

# What refine says of them: the line, if it has one, what is wrong there, and what to do.
MESSAGES = {
    "open_surface": r":\d+: edge of .* belongs to facet \d+ only; close the hole",
    "real_holes_open": r":\d+: edge of .* belongs to facet \d+ only; close the hole",
    "duplicate_vertices": r":3: vertex 0 .* has the same coordinates as vertex 1197; merge the vertices",
    "degenerate_triangles": r":3590: facet 2390 has a vertex twice: .*; remove the facet",
    "nonmanifold_edge": r":3591: edge of .* belongs to facet 2390 only; close the hole",
    "duplicate_faces": r":1222: facets 22, 2392 have the same vertices: .*; remove",
    "nan_coordinate": r":80: 'nan' is not finite .*: repair or remove it",
    "inf_coordinate": r":36: '-inf' is not finite .*: repair or remove it",
    "truncated": r":2176: the file ends inside facet 976: it is truncated; get the complete file",
    "empty": r":1: the file is empty: an OFF file starts with the line OFF",
    "header_only": r":2: the file ends where the number of vertices was expected: it is truncated",
    "index_out_of_range": r":1250: vertex 1197 does not exist: .*; correct the index",
    "negative_index": r":1209: vertex -1 does not exist: .*; correct the index",
    "words_for_numbers": r":15: 'abc' is not a number: .*; correct the file",
    "wrong_counts": r":1200: vertex 1197 has 4 numbers instead of 3; are the counts on line 2 right\?",
    "not_a_mesh": r":1: not an OFF file: .*; name the right --format",
    "coplanar_points": r": holds points, and refine needs a closed surface .*; sinkmesh delaunay takes points",
}
# And delaunay.
POINT_MESSAGES = {
    "collinear_points": r": all points are collinear \(150 distinct\): add points off the line",
    "coplanar_points": r": all points are coplanar \(400 distinct\): add points off the plane.*--dimension 2",
    "coplanar_tilted_points": r": all points are coplanar \(400 distinct\): add points off the plane",
    "identical_points": r": all points are equal \(1 distinct\): add different points",
    "three_points": r": all points are coplanar \(3 distinct\): add points off the plane",
}
# Pairs of facets that inspect finds to intersect, where it finds any.
SELF_INTERSECTIONS = {
    "self_intersecting": 251,
    "real_camel_selfint": 20,
    "real_cow_duplicate_selfint": 89,
    "nonmanifold_edge": 4,
}


@needs_data
class Nasty(ProgramTest):
    def check(self, path, *command):
        out = self.folder / "out.vtu"
        report = self.folder / "report.json"
        result = self.run_program(*command, path, "-o", out, "--report", report, timeout=SECONDS)
        message = result.stderr.decode()
        self.assertIn(result.returncode, (0, 1, 3), message)
        if result.returncode != 0:
            # One line: the file, what is wrong, and, after a colon, semicolon or comma, what to do about it.
            self.assertRegex(message, rf"\A{re.escape(str(path))}(:\d+)?: [^\n]+[:;,?][^\n]+\n\Z")
            self.assertTrue(message.isascii())
            expected = (MESSAGES if command == ("refine",) else POINT_MESSAGES).get(path.stem)
            if expected is not None:
                self.assertRegex(message, re.escape(path.name) + expected)
            self.assertEqual(result.stdout, b"")
            # A surface that could not be conformed has a report, but no mesh.
            self.assertEqual(self.files(), ["report.json"] if result.returncode == 3 else [])
            report.unlink(missing_ok=True)
        else:
            self.assertEqual(message, "")
            self.assertTrue(self.inspect(out)["delaunay"])
            for name in self.files():
                (self.folder / name).unlink()
        return result.returncode

    def test_the_corpus_is_there(self):
        self.assertGreaterEqual(len(list(NASTY.iterdir())), 39)

    def test_refine(self):
        for path in sorted(NASTY.iterdir()):
            with self.subTest(path=path.name):
                status = self.check(path, "refine")
                if path.stem in REFUSED or path.suffix == ".xyz":
                    self.assertEqual(status, 1)
                self.assertFalse(status == 0 and path.stem in MESSAGES)

    def test_delaunay(self):
        for path in sorted(NASTY.iterdir()):
            with self.subTest(path=path.name):
                status = self.check(path, "delaunay")
                if path.suffix == ".xyz":
                    self.assertEqual(status, 1 if path.stem in REFUSED else 0)

    def test_inspect(self):
        for path in sorted(NASTY.iterdir()):
            with self.subTest(path=path.name):
                result = self.run_program("inspect", path, timeout=SECONDS)
                self.assertIn(result.returncode, (0, 1))
                if result.returncode == 0:
                    self.assertEqual(result.stderr, b"")
                    self.assertNotEqual(result.stdout, b"")
                else:  # defects on standard output, or one line on standard error
                    self.assertNotEqual(result.stdout == b"", result.stderr == b"")
                    self.assertLessEqual(result.stderr.count(b"\n"), 1)
                    if result.stderr:
                        self.assertTrue(result.stderr.decode().startswith(str(path)))
                        self.assertTrue(result.stderr.endswith(b"\n"))
                self.assertEqual(self.files(), [])

    def test_inspect_counts_self_intersections(self):
        for path in sorted(NASTY.glob("*.off")):
            with self.subTest(path=path.name):
                result = self.run_program("inspect", path, "--report", self.path("report.json"), timeout=SECONDS)
                if result.stderr:
                    continue  # not a surface
                pairs = [d for d in self.report()["defects"] if d["kind"] == "self-intersection"]
                self.assertEqual(len(pairs), SELF_INTERSECTIONS.get(path.stem, 0))


if __name__ == "__main__":
    unittest.main()
