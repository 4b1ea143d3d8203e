# SPDX-License-Identifier: MIT
"""An exact look at a mesh of the program, in the plane or in space: whole numbers of any size, no code of it."""
import itertools
import pathlib

FLAT = 1e-9  # volume to longest edge cubed


class Mesh:
    """From a MEDIT file: `simplices` and `facets` are pairs of corners and a reference."""

    def __init__(self, path):
        words = iter(pathlib.Path(path).read_text().split())
        found = {"Tetrahedra": [], "Triangles": [], "Edges": []}
        sizes = {}
        for word in words:
            if word == "Dimension":
                self.dim = int(next(words))
                sizes = {"Vertices": self.dim + 1, "Tetrahedra": 5, "Triangles": 4, "Edges": 3}
            elif word in sizes:
                found[word] = [[next(words) for _ in range(sizes[word])] for _ in range(int(next(words)))]
        self.points = [tuple(map(float, row[:-1])) for row in found["Vertices"]]

        def cells(name):
            rows = [list(map(int, row)) for row in found[name]]
            return [(tuple(v - 1 for v in row[:-1]), row[-1]) for row in rows]

        names = ("Triangles", "Edges") if self.dim == 2 else ("Tetrahedra", "Triangles")
        self.simplices, self.facets = cells(names[0]), cells(names[1])
        # Coordinates are whole multiples of 2^-bits.
        bits = max(x.as_integer_ratio()[1].bit_length() - 1 for p in self.points for x in p)
        self.unit = 2**bits
        self.whole = [tuple(int(n * (self.unit // d)) for n, d in map(float.as_integer_ratio, p)) for p in self.points]

    def volume(self, corners):
        """Rounded; areas in the plane."""
        numerator = orientation([self.whole[v] for v in corners])
        return numerator / self.unit**self.dim / (2 if self.dim == 2 else 6)

    def volumes(self):
        """By region."""
        result = {}
        for corners, region in self.simplices:
            result[region] = result.get(region, 0) + self.volume(corners)
        return result

    def flat(self, given):
        """Simplices without volume, but for rounding, that have a corner which was not given."""
        result = []
        for corners, _ in self.simplices:
            longest2 = max(distance2(self.points[a], self.points[b]) for a, b in itertools.combinations(corners, 2))
            if self.volume(corners) < FLAT * longest2**(self.dim / 2) and any(v >= given for v in corners):
                result.append(corners)
        return result

    def defects(self):
        """What keeps it from being a Delaunay mesh with a stable boundary, one line each."""
        found = []
        if len(set(self.whole)) < len(self.whole):
            found.append("two vertices are equal")
        listed = {frozenset(corners) for corners, _ in self.facets}
        sides = {}
        for corners, region in self.simplices:
            if orientation([self.whole[v] for v in corners]) <= 0:
                found.append(f"{corners} is turned")
            for v in corners:
                sides.setdefault(frozenset(corners) - {v}, []).append((v, corners, region))
        for facet in listed - set(sides):
            found.append(f"facet {tuple(facet)} is at no simplex")
        for facet, at in sides.items():
            name = tuple(sorted(facet))
            if len(at) > 2:
                found.append(f"{name} is at {len(at)} simplices")
            elif (len(at) == 1 or at[0][2] != at[1][2]) and facet not in listed:
                found.append(f"{name} is on the boundary, and not listed")
            if len(at) == 2:
                (_, corners, _), (apex, _, _) = at
                if in_sphere([self.whole[v] for v in corners], self.whole[apex]) > 0:
                    found.append(f"{apex} is inside the sphere of {corners}")
            if facet in listed:
                for apex, _, _ in at:
                    if diametral_power([self.whole[v] for v in name], self.whole[apex]) < 0:
                        found.append(f"{name} is unstable: {apex}")
        return found


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def distance2(p, q):
    return dot(minus(p, q), minus(p, q))


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1)**k * rows[0][k] * determinant([row[:k] + row[k + 1:] for row in rows[1:]])
               for k in range(len(rows)) if rows[0][k])


def orientation(corners):
    """Positive for (0, e1, e2) and (0, e1, e2, e3)."""
    return determinant([minus(p, corners[0]) for p in corners[1:]])


def in_sphere(corners, x):
    """Positive strictly inside, for positively oriented corners."""
    rows = [minus(p, x) for p in corners]
    sign = 1 if len(x) == 2 else -1
    return sign * determinant([row + [dot(row, row)] for row in rows])


def diametral_power(facet, x):
    """Negative strictly inside the smallest sphere through the facet."""
    if len(facet) == 2:
        return dot(minus(facet[0], x), minus(facet[1], x))
    u, v, w = (minus(p, facet[0]) for p in (*facet[1:], x))
    uu, uv, vv = dot(u, u), dot(u, v), dot(v, v)
    return dot(w, w) * (uu * vv - uv * uv) - vv * (uu - uv) * dot(w, u) - uu * (vv - uv) * dot(w, v)
