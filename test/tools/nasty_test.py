# SPDX-License-Identifier: MIT
"""Every nasty input: a valid mesh, or one line that says what is wrong. Never a signal, a hang, half a file."""
import unittest

from program import DATA, ProgramTest, needs_data

NASTY = DATA / "real" / "nasty"
SECONDS = 5

# What no program should mesh without a word.
REFUSED = {
    "open_surface", "real_holes_open", "duplicate_vertices", "degenerate_triangles", "t_junction", "nonmanifold_edge",
    "duplicate_faces", "self_intersecting", "real_camel_selfint", "real_cow_duplicate_selfint", "nan_coordinate",
    "inf_coordinate", "truncated", "empty", "header_only", "index_out_of_range", "negative_index", "words_for_numbers",
    "not_a_mesh", "flat_closed_surface", "schoenhardt", "collinear_points", "coplanar_points",
    "coplanar_tilted_points", "identical_points", "three_points"
}


@needs_data
class Nasty(ProgramTest):
    def check(self, path, *command):
        out = self.folder / "out.vtu"
        report = self.folder / "report.json"
        result = self.run_program(*command, path, "-o", out, "--report", report, timeout=SECONDS)
        message = result.stderr.decode()
        self.assertIn(result.returncode, (0, 1), message)
        if result.returncode == 1:
            self.assertEqual(message.count("\n"), 1, message)
            self.assertTrue(message.startswith(str(path)), message)
            self.assertTrue(message.isascii())
            self.assertEqual(result.stdout, b"")
            self.assertEqual(self.files(), [])
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


if __name__ == "__main__":
    unittest.main()
