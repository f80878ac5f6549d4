"""Solids whose faces are polygons in whole numbers, and what is made of faces: triangles, cuts.

A face is a list of points, counterclockwise seen from outside; it is flat, and may be concave.
Points are tuples of three ints, or of Fractions once faces have been cut. Nothing here is rounded
but the corners of a ring.
"""
import itertools
import math
from collections import Counter
from fractions import Fraction


# ---- Points


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def normal(face):
    """Newell's: twice the area long."""
    total = (0, 0, 0)
    for p, q in zip(face, face[1:] + face[:1]):
        total = tuple(a + b for a, b in zip(total, cross(p, q)))
    return total


# ---- Solids. `outline` is counterclockwise in (u, v); along `axis` is the third coordinate, w, and
# (u, v, w) are (y, z, x), (z, x, y) or (x, y, z).


def on_axis(axis, u, v, w):
    return ((w, u, v), (v, w, u), (u, v, w))[axis]


def ring(sides, radius, centre=(0, 0), turn=0.0):
    """The corners of a regular polygon, rounded; `turn` in sides."""
    angles = [2 * math.pi * (k + turn) / sides for k in range(sides)]
    return [
        (centre[0] + round(radius * math.cos(a)), centre[1] + round(radius * math.sin(a)))
        for a in angles
    ]


def rectangle(left, right, low, high):
    return [(left, low), (right, low), (right, high), (left, high)]


def between(below, above, low, high, axis):
    """The sides of a solid between outlines of equal numbers of corners."""
    count = len(below)
    return [
        [
            on_axis(axis, *below[k], low),
            on_axis(axis, *below[(k + 1) % count], low),
            on_axis(axis, *above[(k + 1) % count], high),
            on_axis(axis, *above[k], high),
        ]
        for k in range(count)
    ]


def ends(below, above, low, high, axis):
    return [
        [on_axis(axis, *p, low) for p in reversed(below)],
        [on_axis(axis, *p, high) for p in above],
    ]


def prism(outline, low, high, axis=2):
    return ends(outline, outline, low, high, axis) + between(outline, outline, low, high, axis)


def box(low, high):
    return prism(rectangle(low[0], high[0], low[1], high[1]), low[2], high[2])


def tapered(outline, centre, times, low, high, axis=2):
    """A frustum: at `low` the corners are `times[0]` as far from the centre as in the outline, at
    `high` `times[1]`."""
    below, above = (
        [tuple(c + k * (x - c) for x, c in zip(p, centre)) for p in outline] for k in times
    )
    return ends(below, above, low, high, axis) + between(below, above, low, high, axis)


def prism_with_hole(outer, hole, links, low, high, axis=2):
    """Both ends are two faces, which meet in the links: pairs of a corner of the outer outline and
    one of the hole."""
    faces = between(outer, outer, low, high, axis)
    faces += [[q, p, b, a] for p, q, a, b in between(hole, hole, low, high, axis)]
    (i, j), (k, l) = links
    for first, last, here, there in ((i, k, l, j), (k, i, j, l)):
        half = cyclic(outer, first, last) + list(reversed(cyclic(hole, there, here)))
        faces += ends(half, half, low, high, axis)
    return faces


def cyclic(points, first, last):
    """From one to another, both included."""
    count = len(points)
    return [points[(first + k) % count] for k in range((last - first) % count + 1)]


def plate_with_hole(left, right, bottom, top, hole, low, high, axis=2):
    """The hole is a ring of an even number of corners, with `turn` 0: links go left and right."""
    half = len(hole) // 2
    middle = hole[0][1]
    outer = [
        (left, bottom),
        (right, bottom),
        (right, middle),
        (right, top),
        (left, top),
        (left, middle),
    ]
    return prism_with_hole(outer, hole, ((2, 0), (5, half)), low, high, axis)


# ---- Properties of a closed solid


def sides(face):
    return zip(face, face[1:] + face[:1])


def is_closed(faces):
    """Each side has its opposite, as often."""
    directed = Counter(side for face in faces for side in sides(face))
    return all(directed[q, p] == n for (p, q), n in directed.items())


def is_flat(face):
    n = normal(face)
    return all(dot(n, minus(p, face[0])) == 0 for p in face)


def volume(faces):
    """Six times it: of tetrahedra with the origin."""
    total = 0
    for a, b, c in (t for face in faces for t in triangles_of(face)):
        total += dot(a, cross(b, c))
    return total


def angles(faces):
    """In degrees, of faces that share a whole side, two by two: 0 where they are in one plane."""
    sharing = {}
    for face in faces:
        length = math.hypot(*normal(face))
        unit = tuple(x / length for x in normal(face))
        for p, q in sides(face):
            sign = 1 if p < q else -1
            sharing.setdefault(frozenset((p, q)), set()).add(tuple(sign * x for x in unit))
    for around in sharing.values():
        for a, b in itertools.combinations(sorted(around), 2):
            yield math.degrees(math.acos(max(-1.0, min(1.0, -dot(a, b)))))


# ---- Triangles


def flat(face):
    """Its points in the two coordinates in which it is largest, counterclockwise."""
    n = normal(face)
    axis = max(range(3), key=lambda k: abs(n[k]))
    first, second = [(1, 2), (2, 0), (0, 1)][axis]
    if n[axis] < 0:
        first, second = second, first
    return [(p[first], p[second]) for p in face]


def turn(p, q, r):
    """Above 0 to the left."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def is_ear(corners, k):
    """Nothing is in the triangle of a corner and its neighbours, sides included."""
    p, q, r = corners[k - 1], corners[k], corners[(k + 1) % len(corners)]
    if turn(p, q, r) <= 0:
        return False
    return not any(
        turn(p, q, x) >= 0 and turn(q, r, x) >= 0 and turn(r, p, x) >= 0
        for x in corners
        if x not in (p, q, r)
    )


def triangles_of(face):
    """By cutting ears off a simple polygon. None is without area."""
    if len(face) == 3:
        return [list(face)]
    points, corners, found = list(face), flat(face), []
    while len(points) > 3:
        k = next(k for k in range(len(points)) if is_ear(corners, k))
        found.append([points[k - 1], points[k], points[(k + 1) % len(points)]])
        del points[k], corners[k]
    return found + [points]


def triangulated(faces):
    """Triangles, and of each the ordinal of its face."""
    triangles, of_face = [], []
    for ordinal, face in enumerate(faces):
        for triangle in triangles_of(face):
            triangles.append(triangle)
            of_face.append(ordinal)
    return triangles, of_face


# ---- Cuts


def is_convex(face):
    corners = flat(face)
    count = len(corners)
    return all(
        turn(corners[k - 1], corners[k], corners[(k + 1) % count]) >= 0 for k in range(count)
    )


def width(face):
    """The area over the longest side: no more than the distance between parallels around it."""
    longest = max(math.dist(p, q) for p, q in sides(face))
    return math.sqrt(dot(normal(face), normal(face))) / 2 / longest


def halves(face, i, j, p, q):
    """Cut from the point p of its side i to the point q of its side j."""
    one = [p, *cyclic(face, (i + 1) % len(face), j), q]
    other = [q, *cyclic(face, (j + 1) % len(face), i), p]
    return one, other


def cut_at_random(source, faces, cuts, least):
    """The faces, after `cuts` tries to cut one in two from side to side. Ends of cuts are
    sixteenths of a side; they part the sides of no other face, so that they are T-vertices. What is
    narrower than `least` is not made. Concave faces are made triangles first."""
    faces = [
        piece for face in faces for piece in ([face] if is_convex(face) else triangles_of(face))
    ]
    for _ in range(cuts):
        at = source.randrange(len(faces))
        face = faces[at]
        i, j = source.sample(range(len(face)), 2)
        p, q = (on_side(face, k, Fraction(source.randint(2, 14), 16)) for k in (i, j))
        pieces = halves(face, i, j, p, q)
        if all(any(normal(piece)) and width(piece) >= least for piece in pieces):
            faces[at] = pieces[0]
            faces.append(pieces[1])
    return faces


def on_side(face, k, share):
    p, q = face[k], face[(k + 1) % len(face)]
    return tuple(a + share * (b - a) for a, b in zip(p, q))
