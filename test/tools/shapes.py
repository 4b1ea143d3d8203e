# SPDX-License-Identifier: MIT
"""Surfaces and planar graphs for the tests of the program, made from a few numbers; no randomness without a seed.

A surface is a pair (points, facets), its facets counterclockwise seen from outside. A planar graph is a `Graph`.
"""
import dataclasses
import itertools
import math
import random

# -- space


def joined(*surfaces):
    """One surface of several; equal points become one, and so do facets with the same points."""
    ids, points, facets, seen = {}, [], [], set()
    for surface_points, surface_facets in surfaces:
        for facet in surface_facets:
            corners = []
            for v in facet:
                p = tuple(map(float, surface_points[v]))
                if p not in ids:
                    ids[p] = len(points)
                    points.append(p)
                corners.append(ids[p])
            if frozenset(corners) not in seen:
                seen.add(frozenset(corners))
                facets.append(tuple(corners))
    return points, facets


def turned(surface):
    """Inside out."""
    points, facets = surface
    return points, [(a, c, b) for a, b, c in facets]


def moved(surface, degrees=0.0, axis=(1.0, 0.7, 0.3), scale=1.0, shift=(0.0, 0.0, 0.0)):
    """Rotated about an axis through the origin, then scaled, then moved."""
    points, facets = surface
    length = math.sqrt(sum(x * x for x in axis))
    n = [x / length for x in axis]
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    result = []
    for p in points:
        along = sum(a * b for a, b in zip(n, p)) * (1 - c)
        cross = (n[1] * p[2] - n[2] * p[1], n[2] * p[0] - n[0] * p[2], n[0] * p[1] - n[1] * p[0])
        result.append(tuple(scale * (c * p[k] + s * cross[k] + along * n[k]) + shift[k] for k in range(3)))
    return result, facets


def box(low, high, cells=(1, 1, 1), other_diagonals=False):
    """Every side is a grid of rectangles; opposite sides are cut alike."""
    ids, points, facets = {}, [], []

    def vertex(index):
        if index not in ids:
            ids[index] = len(points)
            points.append(tuple(low[k] + (high[k] - low[k]) * index[k] / cells[k] for k in range(3)))
        return ids[index]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, cells[axis]):
            for i, j in itertools.product(range(cells[u]), range(cells[v])):
                corners = []
                for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    index = [0, 0, 0]
                    index[axis], index[u], index[v] = side, i + di, j + dj
                    corners.append(vertex(tuple(index)))
                a, b, c, d = corners[1:] + corners[:1] if other_diagonals else corners
                facets += [(a, b, c), (a, c, d)] if side else [(a, c, b), (a, d, c)]
    return points, facets


def cube(x=0, y=0, z=0, size=1):
    return box((x, y, z), (x + size, y + size, z + size))


def plate(k):
    """1 : k."""
    return box((0, 0, 0), (1, 1, 1 / k))


def prism(outline, height=1.0):
    """Over a polygon that is given counterclockwise and cut into a fan from its first corner."""
    n = len(outline)
    points = [(x, y, 0.0) for x, y in outline] + [(x, y, height) for x, y in outline]
    facets = []
    for i in range(1, n - 1):
        facets += [(0, i + 1, i), (n, n + i, n + i + 1)]
    for i in range(n):
        j = (i + 1) % n
        facets += [(i, j, n + j), (i, n + j, n + i)]
    return points, facets


def wedge(degrees, height=1.0):
    """A prism whose sides meet at this angle."""
    a = math.radians(degrees)
    return prism([(0.0, 0.0), (2.0, 0.0), (2 * math.cos(a), 2 * math.sin(a))], height)


def pyramid(degrees):
    """Over a square; this is the angle of its sides with the base."""
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, math.tan(math.radians(degrees)))]
    return points, [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]


def cone(n, height):
    """A pyramid over a regular polygon of radius 1, which is cut into a fan from its first corner."""
    points = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), 0.0) for i in range(n)]
    facets = [(0, i + 1, i) for i in range(1, n - 1)] + [(i, (i + 1) % n, n) for i in range(n)]
    return points + [(0.0, 0.0, float(height))], facets


def spire(degrees):
    """A pyramid over a square; this is the angle of neighbouring edges at its apex, below 90."""
    half = math.radians(degrees) / 2
    height = math.sqrt(1 / math.tan(half)**2 - 1)
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, height)]
    return points, pyramid(45)[1]


def l_shape():
    """Cut from the inner corner, from which all of it is seen."""
    return prism([(1, 1), (1, 2), (0, 2), (0, 0), (2, 0), (2, 1)])


def schoenhardt(degrees=30.0):
    """A prism over a triangle, twisted: its sides are bent inwards, and no four of its corners span a part of it."""
    bottom = [(math.cos(math.radians(a)), math.sin(math.radians(a)), 0.0) for a in (0, 120, 240)]
    top = [(math.cos(math.radians(a)), math.sin(math.radians(a)), 1.0)
           for a in (degrees, 120 + degrees, 240 + degrees)]
    facets = [(0, 2, 1), (3, 4, 5)]
    for i in range(3):
        j = (i + 1) % 3
        facets += [(i, j, 3 + i), (j, 3 + j, 3 + i)]
    # Twisted against the diagonals, which then are the long ones.
    return bottom + top, facets


# -- the plane


@dataclasses.dataclass
class Graph:
    """Segments in the plane, with Triangle's seeds."""
    points: list
    segments: list
    markers: list = None
    holes: list = dataclasses.field(default_factory=list)
    regions: list = dataclasses.field(default_factory=list)  # x, y, tag
    area: float = None  # of what is inside

    def poly(self):
        columns = 0 if self.markers is None else 1
        lines = [f"{len(self.points)} 2 0 0"]
        lines += [f"{i} {float(x)!r} {float(y)!r}" for i, (x, y) in enumerate(self.points)]
        lines += [f"{len(self.segments)} {columns}"]
        lines += [f"{i} {a} {b}" + (f" {self.markers[i]}" if columns else "") for i, (a, b) in enumerate(self.segments)]
        lines += [str(len(self.holes))] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(self.holes)]
        lines += [str(len(self.regions))] + [f"{i} {x!r} {y!r} {tag}" for i, (x, y, tag) in enumerate(self.regions)]
        return "\n".join(lines) + "\n"


def ring(first, count):
    return [(first + i, first + (i + 1) % count) for i in range(count)]


def area_of(polygon):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(polygon, polygon[1:] + polygon[:1])) / 2


def polygon(points):
    points = [tuple(map(float, p)) for p in points]
    return Graph(points, ring(0, len(points)), area=abs(area_of(points)))


def comb(teeth, width=0.1, length=2.0):
    """Narrow teeth, with gaps as narrow between them."""
    points = [(0, -1), ((2 * teeth - 1) * width, -1)]
    for i in range(teeth - 1, -1, -1):
        points += [((2 * i + 1) * width, length), (2 * i * width, length)]
        if i > 0:
            points += [(2 * i * width, 0), ((2 * i - 1) * width, 0)]
    return polygon(points)


def star(spikes, degrees, turn=0.1):
    """Spikes with this angle at their tips."""
    half = math.radians(degrees) / 2
    step = math.pi / spikes
    # From a tip at distance 1, at half the angle to the axis, to where the sides of neighbouring spikes meet.
    inner = math.sin(half) / math.sin(half + step)
    points = []
    for i in range(spikes):
        for radius, angle in ((1, 2 * i * step), (inner, (2 * i + 1) * step)):
            points.append((radius * math.cos(angle + turn), radius * math.sin(angle + turn)))
    return polygon(points)


def sector(count, degrees):
    """The center of a circle, and points on it: so many sectors of this angle."""
    angles = [math.radians(i * degrees) for i in range(count + 1)]
    return [(0.0, 0.0), *((math.cos(a), math.sin(a)) for a in angles)]


def sectors(count, degrees):
    """With a wall between each two."""
    graph = polygon(sector(count, degrees))
    graph.segments += [(0, i) for i in range(2, count + 1)]
    a = math.radians(degrees) / 2
    graph.regions = [(math.cos(a) / 2, math.sin(a) / 2, 1)]
    return graph


def circle(count, radius, turn=0.0, center=(0.0, 0.0)):
    return [(center[0] + radius * math.cos(2 * math.pi * i / count + turn),
             center[1] + radius * math.sin(2 * math.pi * i / count + turn)) for i in range(count)]


def annulus(outer, inner, radius, center=(0.0, 0.0)):
    """Between a ring of `outer` corners and radius 1 and a smaller one inside it."""
    big, small = circle(outer, 1.0), circle(inner, radius, 0.2, center)
    return Graph(big + small, ring(0, outer) + ring(outer, inner), holes=[center], area=area_of(big) - area_of(small))


def crossing(a, b, c, d):
    """Whether the closed segments ab and cd meet in more than a common end. Coordinates are small integers."""

    def side(p, q, r):
        x = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        return (x > 0) - (x < 0)

    def within(p, q, r):
        return min(p[0], q[0]) <= r[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= r[1] <= max(p[1], q[1])

    signs = side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)
    if 0 not in signs:
        return signs[0] != signs[1] and signs[2] != signs[3]
    ends = {a, b} & {c, d}
    return any(sign == 0 and r not in ends and within(p, q, r)
               for sign, (p, q, r) in zip(signs, ((a, b, c), (a, b, d), (c, d, a), (c, d, b))))


def random_polygon(corners, seed, size=1000):
    """Simple: crossings of a random one are undone, which makes it shorter each time."""
    rng = random.Random(seed)
    order = []
    while len(order) < corners:
        p = (rng.randrange(size), rng.randrange(size))
        if p not in order:
            order.append(p)
    again = True
    while again:
        again = False
        for i, j in itertools.combinations(range(corners), 2):
            if crossing(order[i], order[(i + 1) % corners], order[j], order[(j + 1) % corners]):
                order[i + 1:j + 1] = order[i + 1:j + 1][::-1]
                again = True
        if again and len(set(order)) < corners:
            break
    return polygon(order)


def airfoil(count, thickness=0.12, degrees=0.0, shift=(0.0, 0.0)):
    """A symmetric one of NACA's four-digit series, closed at the trailing edge; counterclockwise."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    upper = []
    for i in range(count + 1):
        x = (1 - math.cos(math.pi * i / count)) / 2
        y = 5 * thickness * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        upper.append((x, y if 0 < i < count else 0.0))
    outline = upper[::-1] + [(x, -y) for x, y in upper[1:-1]]
    return [(c * x + s * y + shift[0], c * y - s * x + shift[1]) for x, y in outline]


def two_airfoils(count, degrees=10.0):
    """A wing and its flap, cut out of a box."""
    wing = airfoil(count, 0.12, degrees / 2)
    flap = [(1.02 + 0.3 * x, -0.12 + 0.3 * y) for x, y in airfoil(max(count // 2, 4), 0.1, 2 * degrees)]
    frame = [(-3.0, -3.0), (5.0, -3.0), (5.0, 3.0), (-3.0, 3.0)]
    points, segments, holes = frame + wing + flap, ring(0, 4), []
    for outline, first in ((wing, 4), (flap, 4 + len(wing))):
        segments += ring(first, len(outline))
        n = len(outline)
        # Between the middles of both sides.
        a, b = outline[n // 4], outline[n - n // 4]
        holes.append(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2))
    return Graph(points, segments, holes=holes, area=48.0 - area_of(wing) - area_of(flap))


def divided_square():
    """A rectangle with a square hole, and a wall through what is left of it: two regions."""
    outer = [(0, 0), (6, 0), (12, 0), (12, 6), (6, 6), (0, 6)]
    inner = [(6, 2), (8, 2), (8, 4), (6, 4)]
    return Graph(outer + inner, ring(0, 6) + ring(6, 4) + [(1, 6), (9, 4)], [1] * 6 + [2] * 4 + [3] * 2,
                 holes=[(7, 3)], regions=[(1, 1, 10), (11, 1, 20)], area=68.0)


def fan_square(walls, loose=True):
    """A square divided into sectors by walls from its middle; in each a loose segment with two free ends."""
    points = [(0.0, 0.0)]
    for i in range(walls):
        a = 2 * math.pi * i / walls + 0.05
        reach = 1 / max(abs(math.cos(a)), abs(math.sin(a)))
        points.append((reach * math.cos(a), reach * math.sin(a)))
    # Corners of the square go between the ends of the walls, by direction; ends lie on the square exactly.
    points = [points[0]] + [tuple(math.copysign(1.0, x) if abs(abs(x) - 1) < 1e-12 else x for x in p)
                            for p in points[1:]]
    border = sorted(points[1:] + [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)],
                    key=lambda p: math.atan2(p[1], p[0]) % (2 * math.pi))
    ids = {p: i + 1 for i, p in enumerate(border)}
    segments = ring(1, len(border)) + [(0, ids[p]) for p in points[1:]]
    points_out = [points[0]] + border
    regions = []
    for i in range(walls):
        a = 2 * math.pi * (i + 0.5) / walls + 0.05
        regions.append((0.7 * math.cos(a), 0.7 * math.sin(a), 10 + i))
        if loose:
            segments.append((len(points_out), len(points_out) + 1))
            points_out += [(0.5 * math.cos(a), 0.5 * math.sin(a)), (0.8 * math.cos(a + 0.1), 0.8 * math.sin(a + 0.1))]
    return Graph(points_out, segments, regions=regions, area=4.0)
