"""Support planes, reach, and which polygons lie in the plane of another: "Touching" of the
definition (interp/truth/entered_truth.md), in whole numbers from the doubles as entered.

Areas, and which three vertices a polygon's plane goes through, are in doubles by the definition.
"""
import math
from dataclasses import dataclass
from fractions import Fraction

IDENTITY = tuple(tuple(float(i == j) for j in range(4)) for i in range(3))
FLATNESS = 1e-7  # farther off a plane, relative to the polygon's size, is not known here


@dataclass
class Planes:
    """Of each polygon: three world points of its plane, and which polygon's plane it lies in. None
    where it has no plane. `doubtful` says where a number of a matrix, rounded another way, could
    put a polygon into another plane."""

    points: list
    world: list  # of each polygon its vertices
    founder: list
    scale: int  # world points are whole numbers over it
    doubtful: list


@dataclass
class WorldPolygon:
    points: list  # whole numbers over a scale
    support: tuple  # three of them
    area: float
    matrix: tuple
    reach: Fraction  # its square, in world units
    normal: tuple = ()  # whole numbers
    near: tuple = ()  # normal and distance in doubles: n . x = d

    def found(self, scale):
        p, q, r = self.support
        self.normal = cross(minus(q, p), minus(r, p))
        length = math.sqrt(sum((x / scale**2) ** 2 for x in self.normal))
        if length:
            n = [x / scale**2 / length for x in self.normal]
            self.near = (n, sum(a * (b / scale) for a, b in zip(n, p)))


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def support_of(points):
    """Places of the three vertices that a polygon's plane goes through, or None."""
    if len(points) == 3:
        places = (0, 1, 2)
    else:
        from_first = [minus(v, points[0]) for v in points]
        largest = [max(map(abs, d)) for d in from_first]
        q = largest.index(max(largest))
        unit = 2.0 ** math.frexp(largest[q])[1]  # brings q's into [1/2, 1)
        from_first = [tuple(x / unit for x in d) for d in from_first]
        off = [max(map(abs, cross(from_first[q], d))) for d in from_first]
        places = (0, q, off.index(max(off)))
    exact = [tuple(map(Fraction, v)) for v in points]
    p, q, r = (exact[k] for k in places)
    if any(cross(minus(q, p), minus(r, p))):
        return places
    if len(points) == 3:
        return None
    for k, v in enumerate(exact):
        if any(cross(minus(q, p), minus(v, p))):
            return (places[0], places[1], k)
    return None


def require_flat(points):
    """Raises ValueError where the system would cut a polygon into triangles, or nearly so."""
    n = len(points)
    mean = [sum(v[k] for v in points) / n for k in range(3)]
    around = [minus(v, mean) for v in points]
    normal = [sum(axis) for axis in zip(*(cross(around[k - 1], around[k]) for k in range(n)))]
    length = math.sqrt(dot(normal, normal))
    size = max(max(v[k] for v in points) - min(v[k] for v in points) for k in range(3))
    if length and max(abs(dot(normal, v)) for v in around) / length > FLATNESS * size:
        raise ValueError("a polygon that is not flat")


def newell_area(points):
    p = points[0]
    sides = [minus(v, p) for v in points[1:]]
    total = [sum(axis) for axis in zip(*(cross(a, b) for a, b in zip(sides, sides[1:])))]
    return math.sqrt(dot(total, total)) / 2


def reach_as_entered(program):
    """A scene's reach before modelling transformations, exactly."""
    largest = max((abs(x) for p in program.polygons for v in p.points for x in v), default=0.0)
    words = {s.touching for s in program.segments.values()}
    if "off" in words and len(words) > 1:
        raise ValueError("set-touching off in some of the segments only")
    reaches = {"auto": 8 * Fraction(1, 2**52) * Fraction(largest), "off": Fraction(0)}
    return max(
        (reaches.get(w, None) if w in reaches else Fraction(float(w)) for w in words),
        default=Fraction(0),
    )


def world_polygons(program):
    """The polygons' vertices under their matrices, exactly, and the scale of the whole numbers."""
    reach = reach_as_entered(program)
    exact = {}
    fractions = []
    for polygon in program.polygons:
        require_flat(polygon.points)
        m = exact.setdefault(polygon.matrix, [[Fraction(x) for x in row] for row in polygon.matrix])
        fractions.append(
            [
                tuple(dot(row, v) + row[3] for row in m)
                for v in (tuple(map(Fraction, v)) for v in polygon.points)
            ]
        )
    scale = max((x.denominator for p in fractions for v in p for x in v), default=1)
    polygons = []
    for polygon, points in zip(program.polygons, fractions):
        places = support_of(polygon.points)
        whole = [tuple(int(x * scale) for x in v) for v in points]
        column = max(sum(row[k] ** 2 for row in exact[polygon.matrix]) for k in range(3))
        area = newell_area([tuple(map(float, v)) for v in points])
        world = WorldPolygon(
            whole,
            places and tuple(whole[k] for k in places),
            area,
            polygon.matrix,
            reach**2 * column,
        )
        if places:
            world.found(scale)
        polygons.append(world)
    return polygons, scale


def farthest(polygon, plane, scale):
    """The square of a polygon's greatest distance from a plane over the square of the reach between
    them; None where doubles show that it is far more than 1."""
    reach = max(polygon.reach, plane.reach)
    far = 1e-9 + 4 * math.sqrt(reach)
    n, d = plane.near
    size = 1.0 + abs(d)
    for v in polygon.points:
        x = (v[0] / scale, v[1] / scale, v[2] / scale)
        if abs(dot(n, x) - d) > far * (size + max(map(abs, x))):
            return None
    length = dot(plane.normal, plane.normal)
    most = max(dot(plane.normal, minus(v, plane.support[0])) ** 2 for v in polygon.points)
    if reach == 0:
        return Fraction(2) if most else Fraction(0)
    return Fraction(most, length * scale**2) / reach


def is_doubtful(ratio, polygon, plane):
    """Whether rounding a matrix another way could take it to the other side of the reach. Under one
    matrix a distance changes by its own rounding; under two, by a part of the reach."""
    if polygon.matrix == plane.matrix == IDENTITY:
        return False
    if polygon.matrix == plane.matrix:
        return abs(ratio - 1) < Fraction(1, 10**6)
    return Fraction(1, 2) < ratio < 2


def in_order(polygons, order, scale, doubtful):
    founder = [None] * len(polygons)
    founded = []
    for k in order:
        polygon = polygons[k]
        if not polygon.support or not any(polygon.normal):
            continue
        founder[k] = k
        for f in founded:
            ratio = farthest(polygon, polygons[f], scale)
            if ratio is None:
                continue
            if is_doubtful(ratio, polygon, polygons[f]):
                doubtful.append((k, f))
            if ratio <= 1:
                founder[k] = f
                break
        if founder[k] == k:
            founded.append(k)
    return founder


def groups(founder):
    """The same partition has the same groups, whichever polygons founded them."""
    members = {}
    for k, f in enumerate(founder):
        members.setdefault(f, []).append(k)
    return sorted(members.values())


def find(program):
    """The Planes of a program."""
    polygons, scale = world_polygons(program)
    areas = [float(f"{p.area:.11g}") for p in polygons]  # equal but for rounding
    order = sorted(range(len(polygons)), key=lambda k: (-polygons[k].area, k))
    doubtful = []
    founder = in_order(polygons, order, scale, doubtful)
    reverse = sorted(range(len(polygons)), key=lambda k: (-areas[k], -k))
    if groups(in_order(polygons, reverse, scale, doubtful)) != groups(founder):
        doubtful.append("areas that are equal but for rounding")
    points = [polygons[f].support if f is not None else None for f in founder]
    return Planes(points, [p.points for p in polygons], founder, scale, doubtful)
