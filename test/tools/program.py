# SPDX-License-Identifier: MIT
"""Runs the built program, in a temporary folder, on small surfaces made here."""
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["SINKMESH_PROGRAM"]
DATA = pathlib.Path(os.environ.get("SINKMESH_TEST_DATA", "no such folder"))


def needs_data(test):
    """For tests on files that are not part of the project."""
    return unittest.skipUnless(DATA.is_dir(), "SINKMESH_TEST_DATA is not a folder")(test)


def ellipsoid(levels, axes=(1.0, 0.8, 0.6), jitter=0.01):
    """A subdivided octahedron on an ellipsoid, moved a little so that nothing is cospherical."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    facets = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                m = [points[a][k] + points[b][k] for k in range(3)]
                length = math.sqrt(sum(x * x for x in m))
                points.append(tuple(x / length for x in m))
                middles[key] = len(points) - 1
            return middles[key]

        finer = []
        for a, b, c in facets:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        facets = finer
    rng = random.Random(1)
    stretched = []
    for p in points:
        stretch = 1 + jitter * (rng.random() - 0.5)
        stretched.append(tuple(p[k] * axes[k] * stretch for k in range(3)))
    return stretched, facets


TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def shuffled(surface, seed):
    """The same surface with points and facets in another order, and facets turned."""
    points, facets = surface
    rng = random.Random(seed)
    order = list(range(len(points)))
    rng.shuffle(order)
    new_id = {old: new for new, old in enumerate(order)}
    turned = []
    for facet in facets:
        turn = rng.randrange(3)
        ids = [new_id[v] for v in facet]
        turned.append(tuple(ids[turn:] + ids[:turn]))
    rng.shuffle(turned)
    return [points[old] for old in order], turned


def off(surface):
    points, facets = surface
    lines = ["OFF", f"{len(points)} {len(facets)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in points]
    lines += [" ".join(["3"] + [str(v) for v in f]) for f in facets]
    return "\n".join(lines) + "\n"


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content)
        return str(path)

    def files(self):
        return sorted(entry.name for entry in self.folder.iterdir())

    def run_program(self, *arguments, input=None, timeout=300, stdout=subprocess.PIPE):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            input=input,
            stdin=subprocess.DEVNULL if input is None else None,
            stdout=stdout,
            stderr=subprocess.PIPE,
            timeout=timeout,
            check=False,
        )

    def succeed(self, *arguments, status=0, **options):
        """Runs the program; returns what it wrote to standard output."""
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, status, result.stderr.decode())
        return result.stdout.decode() if result.stdout is not None else ""

    def fail_with_one_line(self, status, *arguments, **options):
        """Runs the program, which must fail with one line on standard error and nothing on standard output."""
        result = self.run_program(*arguments, **options)
        message = result.stderr.decode()
        self.assertEqual(result.returncode, status, message)
        self.assertEqual(message.count("\n"), 1, message)
        self.assertTrue(message.endswith("\n"), message)
        if result.stdout is not None:
            self.assertEqual(result.stdout, b"")
        return message

    def report(self, name="report.json"):
        return json.loads((self.folder / name).read_text())

    def inspect(self, path):
        """The report of `inspect` on a mesh without defects."""
        self.succeed("inspect", path, "--report", self.path("inspect.json"))
        report = self.report("inspect.json")
        self.assertTrue(report["valid"])
        return report
