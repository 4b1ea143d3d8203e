# SPDX-License-Identifier: MIT
"""An independent reader, meshio, finds in every mesh format what the program wrote.

Needs meshio and numpy (Debian: python3-meshio). The Python that runs this may lack them while another one on the
machine has them; then that one takes over. Exits with 77, "skipped", if none has.
"""
import contextlib
import io
import itertools
import os
import random
import shutil
import struct
import subprocess
import sys
import unittest

SKIPPED = 77
TAKEN_OVER = "SINKMESH_MESHIO_PYTHON"  # set for the one that takes over

try:
    import meshio
    import numpy
except ImportError:
    candidates = [os.path.join(folder, "python3") for folder in os.environ.get("PATH", "").split(os.pathsep)]
    for candidate in ["/usr/bin/python3", *candidates]:
        if TAKEN_OVER in os.environ or shutil.which(candidate) is None:
            continue
        probe = subprocess.run([candidate, "-c", "import meshio, numpy"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, check=False)
        if probe.returncode == 0:
            os.execve(candidate, [candidate, "-B", *sys.argv], {**os.environ, TAKEN_OVER: candidate})
    print("SKIPPED: no python3 here has meshio and numpy; install python3-meshio (.ci/bootstrap test does)")
    sys.exit(SKIPPED)

from program import ProgramTest, ellipsoid, off  # noqa: E402

# Output, --format, whether the format holds the boundary where meshio looks for it; None: if facets have fields.
FORMATS = [("a.vtu", None, None), ("a.vtk", None, None), ("a.mesh", None, True), ("a.msh", None, True),
           ("b.msh", "msh2", True), ("a.node", None, False)]
SIMPLEX = {2: "triangle", 3: "tetra"}
FACET = {2: "line", 3: "triangle"}


def bits(points):
    """Coordinates as integers, so that equality is that of bits."""
    return numpy.ascontiguousarray(points, dtype=numpy.float64).view(numpy.uint64)


class Meshio(ProgramTest):
    def read(self, name, dim):
        """Points, simplices and boundary facets as meshio sees them."""
        path = self.path(name)
        with contextlib.redirect_stdout(io.StringIO()):  # it prints warnings
            mesh = meshio.tetgen.read(path) if name.endswith(".node") else meshio.read(path)
        simplices = [block.data for block in mesh.cells if block.type == SIMPLEX[dim]]
        facets = [block.data for block in mesh.cells if block.type == FACET[dim]]
        self.assertEqual({block.type for block in mesh.cells} - {SIMPLEX[dim], FACET[dim]}, set())
        self.assertEqual(len(simplices), 1)
        points = mesh.points
        if points.shape[1] == 3 and dim == 2:
            self.assertFalse(points[:, 2].any())
            points = points[:, :2]
        return points, simplices[0], facets[0] if facets else None

    def check(self, command, dim, points, formats=FORMATS):
        """Writes every format, reads it with meshio, compares all with the first and with the input."""
        first = boundary = None
        hashes = set()
        for name, file_format, has_boundary in formats:
            with self.subTest(name=name, format=file_format):
                options = ["--format", file_format] if file_format else []
                self.succeed(*command, "-o", self.path(name), "--report", self.path("report.json"), *options)
                # Our own reader, on the same file.
                hashes |= {self.report()["hash"], self.inspect(self.path(name))["hash"]}
                found, simplices, facets = self.read(name, dim)
                self.assertEqual(found.dtype, numpy.float64)
                self.assertEqual(bits(found)[:len(points)].tolist(), bits(points).tolist())
                self.assertEqual(len(simplices), self.report()["final"]["simplices"])
                if first is None:
                    first = bits(found), simplices
                numpy.testing.assert_array_equal(bits(found), first[0])
                numpy.testing.assert_array_equal(simplices, first[1])
                if has_boundary is not None:
                    self.assertEqual(facets is not None, has_boundary)
                if facets is not None:
                    if boundary is None:
                        boundary = facets
                    numpy.testing.assert_array_equal(facets, boundary)
        self.assertEqual(len(hashes), 1)
        return first, boundary

    def test_a_refined_mesh(self):
        points, facets = ellipsoid(3, jitter=0)  # nothing is peeled off
        surface = self.write("in.off", off((points, facets)))
        (found, simplices), boundary = self.check(["refine", surface], 3, points)
        self.assertGreater(len(found), len(points))

        # The surface is kept: the boundary is its facets, turned at most.
        def turned(facet):
            start = facet.index(min(facet))
            return tuple(facet[start:] + facet[:start])

        self.assertEqual(sorted(turned(list(f)) for f in boundary.tolist()), sorted(turned(list(f)) for f in facets))
        # Positive orientation, as the formats have it: the fourth corner is on the side of the normal.
        corners = found.view(numpy.float64)[simplices]
        edges = corners[:, 1:] - corners[:, :1]
        self.assertTrue((numpy.linalg.det(edges) > 0).all())

    def test_coordinates_that_are_hard_to_write(self):
        # Within the range of the program's grid, so that the input itself is kept (see input_gate.h).
        rng = random.Random(4)
        points = [tuple(rng.choice((1, -1)) * rng.random() * 10.0**rng.randrange(-14, 1) for _ in range(3))
                  for _ in range(300)]
        points += list(itertools.product((0.1, 1 / 3, 5e-15), repeat=3))
        path = self.write("in.xyz", "".join(" ".join(map(repr, p)) + "\n" for p in points))
        self.check(["delaunay", path], 3, points)

    def test_a_mesh_in_the_plane(self):
        rng = random.Random(6)
        points = [(rng.gauss(0, 1), rng.gauss(0, 1e-3)) for _ in range(300)]
        path = self.write("in.xyz", "".join(" ".join(map(repr, p)) + "\n" for p in points))
        # meshio takes the cells of TetGen's files for tetrahedra.
        self.check(["delaunay", path], 2, points, FORMATS[:-1])

    def test_bits_are_bits(self):
        self.assertNotEqual(bits([0.0]), bits([-0.0]))
        self.assertEqual(int(bits([0.1])[0]), struct.unpack("<Q", struct.pack("<d", 0.1))[0])


if __name__ == "__main__":
    unittest.main()
