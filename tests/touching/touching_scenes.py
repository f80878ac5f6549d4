#!/usr/bin/python3
"""Drawing programs whose polygons touch, as people write them: in decimals, from random cameras.

    tests/touching/touching_scenes.py KIND [--projection parallel|perspective] [--modelled]
                                      [--seed K] [--number N]

prints program N of that kind. The same words are always the same program.
"""
import argparse
import math
import pathlib
import random
import sys
from decimal import Decimal

HERE = pathlib.Path(__file__).resolve().parent


class Source(random.Random):
    def decimal(self, low, high, places=2):
        unit = Decimal(10) ** -places
        return (
            Decimal(
                self.randint(
                    math.ceil(Decimal(str(low)) / unit), math.floor(Decimal(str(high)) / unit)
                )
            )
            * unit
        )

    def chance(self, percent):
        return self.random() * 100 < percent

    def direction(self):
        """A unit vector in floating point."""
        z, angle = self.uniform(-1, 1), self.uniform(0, 2 * math.pi)
        r = math.sqrt(1 - z * z)
        return [r * math.cos(angle), r * math.sin(angle), z]


def words(numbers):
    return " ".join(f"{x:f}" if isinstance(x, Decimal) else repr(float(x)) for x in numbers)


class Scene:
    """Lines between open-segment and close-segment, and the box of what they enter."""

    def __init__(self, source):
        self.source = source
        self.lines = []
        self.low, self.high = [math.inf] * 3, [-math.inf] * 3
        self.at = (0, 0, 0)  # where the part's own coordinates are in the scene's
        self.offset = (0, 0, 0)  # of all coordinates
        self.before = []  # lines before the first segment
        self.same_image = False  # of all segments, written in several ways

    def polygon(self, *points):
        points = [[a + b for a, b in zip(p, self.offset)] for p in points]
        for p in points:
            placed = [float(a) + float(b) for a, b in zip(p, self.at)]
            self.low = list(map(min, self.low, placed))
            self.high = list(map(max, self.high, placed))
        self.lines.append("polygon-abs-3 " + "  ".join(map(words, points)))

    def routine(self, name, *numbers):
        self.lines.append(f"{name} {words(numbers)}".strip())

    def floor(self, y, half=2):
        self.polygon((-half, y, -half), (-half, y, half), (half, y, half), (half, y, -half))

    def box(self, low, high):
        (x, y, z), (a, b, c) = low, high
        self.polygon((x, y, z), (x, b, z), (a, b, z), (a, y, z))
        self.polygon((x, y, c), (a, y, c), (a, b, c), (x, b, c))
        self.polygon((x, y, z), (a, y, z), (a, y, c), (x, y, c))
        self.polygon((x, b, z), (x, b, c), (a, b, c), (a, b, z))
        self.polygon((x, y, z), (x, y, c), (x, b, c), (x, b, z))
        self.polygon((a, y, z), (a, b, z), (a, b, c), (a, y, c))


# ---- Figures drawn in a rectangle of a plane. `place` takes two decimals to a point.


def figure(scene, place, left, right, bottom, top, places=2):
    """A rectangle, a triangle, a pentagon, or a concave polygon with decimal corners within."""
    s = scene.source

    def x(low, high):
        return left + s.decimal(low, high, 1) * (right - left)

    def y(low, high):
        return bottom + s.decimal(low, high, 1) * (top - bottom)

    shapes = [
        lambda: [(left, bottom), (right, bottom), (right, top), (left, top)],
        lambda: [(left, y(0, 0.4)), (right, y(0, 1)), (x(0, 0.6), top)],
        lambda: [
            (left, y(0.4, 0.6)),
            (x(0.1, 0.3), bottom),
            (x(0.7, 0.9), bottom),
            (right, y(0.4, 0.6)),
            (x(0.3, 0.7), top),
        ],
        lambda: [
            (left, bottom),
            (right, bottom),
            (right, top),
            (x(0.3, 0.7), y(0.2, 0.6)),
            (left, top),
        ],
    ]
    corners = [(round(a, places), round(b, places)) for a, b in s.choice(shapes)()]
    if s.chance(50):
        corners.reverse()
    scene.polygon(*(place(a, b) for a, b in corners))


def anywhere(s, left, right, bottom, top):
    """A rectangle within another: its four sides."""
    x, y = s.decimal(left, right - Decimal("0.3")), s.decimal(bottom, top - Decimal("0.3"))
    return x, s.decimal(x + Decimal("0.2"), right), y, s.decimal(y + Decimal("0.2"), top)


def on_face(s, low, high):
    """A place function of a random face of a box, and the face's sides; from outside."""
    axis, side = s.randrange(3), s.choice((low, high))
    first, second = [k for k in range(3) if k != axis]

    def place(a, b):
        p = [None] * 3
        p[axis], p[first], p[second] = side[axis], a, b
        return tuple(p)

    return place, low[first], high[first], low[second], high[second]


def corner(s):
    return s.decimal(-1.5, 0.8), s.decimal(-1.5, 0.8)


def sizes(s):
    return s.decimal(0.2, 0.7), s.decimal(0.2, 1), s.decimal(0.2, 0.7)


# ---- Kinds of scenes


def box_on_floor(scene):
    s = scene.source
    y = s.decimal(-1, 0)
    scene.floor(y)
    x, z = corner(s)
    wide, high, deep = sizes(s)
    scene.box((x, y, z), (x + wide, y + high, z + deep))


def stacked_boxes(scene):
    s = scene.source
    y = s.decimal(-1, 0)
    scene.floor(y)
    for _ in range(s.randint(1, 2)):
        x, z = corner(s)
        wide, high, deep = sizes(s)
        bottom = y
        for _ in range(s.randint(2, 4)):
            scene.box((x, bottom, z), (x + wide, bottom + high, z + deep))
            bottom += high
            x, z = x + s.decimal(-0.1, 0.2), z + s.decimal(-0.1, 0.2)
            high = s.decimal(0.1, 0.5)


def flush_windows(scene):
    """Walls along two axes, with windows and, in these, panes."""
    s = scene.source
    z, x = s.decimal(-1.5, 1.5), s.decimal(-1.5, 1.5)
    for place in (lambda a, b: (a, b, z), lambda a, b: (x, b, a)):
        scene.polygon(
            place(Decimal(-2), Decimal(-1)),
            place(Decimal(2), Decimal(-1)),
            place(Decimal(2), Decimal(1)),
            place(Decimal(-2), Decimal(1)),
        )
        for _ in range(s.randint(1, 4)):
            left, right, bottom, top = anywhere(
                s, Decimal("-1.9"), Decimal("1.9"), Decimal("-0.9"), Decimal("0.9")
            )
            figure(scene, place, left, right, bottom, top)
            frame = Decimal("0.05")
            if s.chance(50):
                figure(scene, place, left + frame, right - frame, bottom + frame, top - frame)


def roof_windows(scene):
    """A pitched roof of two slopes in decimals, with windows."""
    s = scene.source
    rise, foot = s.decimal(0.3, 1.2), s.decimal(-1, 0)
    for sign in (1, -1):
        place = lambda x, z: (x, foot - rise * abs(z), z)
        near, far = sorted((Decimal(0), sign * Decimal("1.7")))
        scene.polygon(
            place(Decimal(-2), near),
            place(Decimal(2), near),
            place(Decimal(2), far),
            place(Decimal(-2), far),
        )
        for _ in range(s.randint(1, 3)):
            figure(scene, place, *anywhere(s, Decimal("-1.9"), Decimal("1.9"), near, far))


def flush_boxes(scene):
    """Boxes side by side, whose faces lie in common planes, and one that stands partly on both."""
    s = scene.source
    (x, z), y = corner(s), s.decimal(-1, 0)
    top, back = y + s.decimal(0.3, 0.8), z + s.decimal(0.3, 0.9)
    for _ in range(s.randint(2, 4)):
        right = x + s.decimal(0.2, 0.6)
        lower = top if s.chance(60) else top - s.decimal(0.1, 0.2)
        scene.box((x, y, z), (right, lower, back if s.chance(60) else back + s.decimal(0.1, 0.3)))
        x = right
    if s.chance(50):
        scene.box((x - s.decimal(0.3, 0.6), top, z), (x, top + s.decimal(0.1, 0.4), back))


def table(scene, x, y, z, wide, deep, high):
    """Legs that stand in the plane y, and a top on them."""
    s = scene.source
    leg, thick = s.decimal(0.05, 0.12), s.decimal(0.04, 0.1)
    inset = s.decimal(0, 0.1)
    for a in (x + inset, x + wide - inset - leg):
        for c in (z + inset, z + deep - inset - leg):
            scene.box((a, y, c), (a + leg, y + high, c + leg))
    scene.box((x, y + high, z), (x + wide, y + high + thick, z + deep))


def rug(scene, y):
    s = scene.source
    points = [
        (a + s.decimal(-0.3, 0.3), y, b + s.decimal(-0.3, 0.3))
        for a, b in [
            (Decimal(x), Decimal(z))
            for x, z in (
                ("-1.3", "-0.9"),
                ("-1.1", "1.2"),
                ("0.3", "1.4"),
                ("1.5", "0.7"),
                ("1.2", "-1.1"),
            )
        ]
    ]
    scene.polygon(*points)


def table_on_rug(scene):
    s = scene.source
    y = s.decimal(-1, 0)
    scene.floor(y)
    rug(scene, y)
    table(
        scene,
        s.decimal(-1, -0.2),
        y,
        s.decimal(-1, -0.2),
        s.decimal(0.6, 1.2),
        s.decimal(0.6, 1.2),
        s.decimal(0.4, 0.9),
    )


def drawn_on_faces(scene):
    s = scene.source
    for _ in range(s.randint(1, 2)):
        x, z = corner(s)
        low = (x, s.decimal(-1, 0), z)
        high = tuple(a + s.decimal(0.4, 1.2) for a in low)
        scene.box(low, high)
        for _ in range(s.randint(3, 8)):
            place, *sides = on_face(s, low, high)
            figure(scene, place, *anywhere(s, *sides))


def decals_on_slope(scene):
    """A plane y = foot + a x + b z with decimal coefficients, and decals that may overlap."""
    s = scene.source
    foot, a, b = s.decimal(-1, 1), s.decimal(-1.5, 1.5), s.decimal(-1.5, 1.5)
    place = lambda x, z: (x, foot + a * x + b * z, z)
    one = Decimal("1.5")
    scene.polygon(place(-one, -one), place(one, -one), place(one, one), place(-one, one))
    for _ in range(s.randint(2, 6)):
        figure(scene, place, *anywhere(s, -one, one, -one, one))


def room(scene):
    """A floor with a rug and a table, walls with pictures, a pitched roof with a skylight."""
    s = scene.source
    y, top = s.decimal(-1, -0.5), s.decimal(0.4, 0.8)
    two = Decimal(2)
    scene.floor(y)
    rug(scene, y)
    for place in (lambda a, b: (a, b, -two), lambda a, b: (-two, b, a)):
        scene.polygon(place(-two, y), place(two, y), place(two, top), place(-two, top))
        for _ in range(s.randint(1, 3)):
            left, right, low, high = anywhere(
                s, Decimal("-1.9"), Decimal("1.9"), y + Decimal("0.1"), top - Decimal("0.1")
            )
            figure(scene, place, left, right, low, high)
            if s.chance(50):
                frame = Decimal("0.04")
                figure(scene, place, left + frame, right - frame, low + frame, high - frame)
    table(
        scene,
        s.decimal(-1, 0),
        y,
        s.decimal(-1, 0),
        s.decimal(0.6, 1.2),
        s.decimal(0.6, 1.2),
        s.decimal(0.4, 0.8),
    )
    pitch = s.decimal(0.2, 0.9)
    slope = lambda x, z: (x, top + pitch * (z + two), z)
    scene.polygon(
        slope(-two, -two), slope(two, -two), slope(two, Decimal(0)), slope(-two, Decimal(0))
    )
    figure(
        scene,
        slope,
        *anywhere(s, Decimal("-1.9"), Decimal("1.9"), Decimal("-1.9"), Decimal("-0.1")),
    )


def rug_draw(scene):
    """The polygons of rug.draw: a rug on a floor, a box on it, windows in the box."""
    for line in (HERE / "rug.draw").read_text(encoding="utf-8").splitlines():
        if line.startswith("polygon-abs-3"):
            numbers = list(map(Decimal, line.split()[1:]))
            scene.polygon(*(tuple(numbers[k : k + 3]) for k in range(0, len(numbers), 3)))


def placed_parts(scene):
    """Boxes in coordinates of their own, each placed under a transformation of its own, stacked or
    side by side, with a figure in the part's coordinates on a face, or in the scene's on its top.
    """
    s = scene.source
    y = s.decimal(-1, 0)
    scene.floor(y)
    x, z = corner(s)
    for _ in range(s.randint(2, 4)):
        wide, high, deep = sizes(s)
        turned = s.chance(40)
        scene.routine("save-transformation-3")
        scale = Decimal(1)
        if s.chance(30):
            scale = s.decimal(0.5, 1.5, 1)
            scene.routine("scale-3", scale * s.choice((1, 1, -1)), scale, scale)
            high *= scale
        if turned:
            scene.routine("rotate-y-3", s.decimal(-180, 180))
        scene.routine("translate-3", x, y, z)
        scene.at = tuple(float(a) for a in (x, y, z))
        low, far = (Decimal(0),) * 3, (wide, high / scale, deep)
        scene.box(low, far)
        place, *sides = on_face(s, low, far)
        figure(scene, place, *sides)
        scene.at = (0, 0, 0)
        scene.routine("restore-transformation-3")
        top = y + high
        if s.chance(50):
            figure(
                scene,
                lambda a, b: (a, top, b),
                x,
                x + s.decimal(0.2, 0.6),
                z,
                z + s.decimal(0.2, 0.6),
            )
        if turned or s.chance(50):
            y = top
        else:
            x += wide * scale


def tiles(scene):
    """A floor or a wall of equal tiles, and figures on it that go across their joints."""
    s = scene.source
    at = s.decimal(-1, 1)
    place = s.choice((lambda a, b: (a, at, b), lambda a, b: (a, b, at), lambda a, b: (at, a, b)))
    step, n = s.decimal(0.4, 1), s.randint(2, 4)
    for i in range(n):
        for j in range(n):
            a, b = step * i - 1, step * j - 1
            scene.polygon(
                place(a, b), place(a + step, b), place(a + step, b + step), place(a, b + step)
            )
    end = step * n - 1
    for _ in range(s.randint(2, 5)):
        figure(scene, place, *anywhere(s, Decimal(-1), end, Decimal(-1), end))


def panelled_slope(scene):
    """Panels side by side on a slope in decimals, and figures that go across their joints. Where the
    largest panel's plane, continued, is farther than the reach, panels have planes of their own."""
    s = scene.source
    foot, a, b = s.decimal(-1, 1), s.decimal(-1.5, 1.5), s.decimal(-1.5, 1.5)
    place = lambda x, z: (x, foot + a * x + b * z, z)
    x, near, far = Decimal("-1.5"), s.decimal(-1.5, -1), s.decimal(1, 1.5)
    scene.offset = tuple(s.choice((-1, 1)) * s.decimal(2, 90, 1) for _ in range(3))
    most = s.choice((0.05, 0.2, 0.9))
    for _ in range(s.randint(6, 14)):
        right = x + s.decimal(0.02, most)
        scene.polygon(place(x, near), place(right, near), place(right, far), place(x, far))
        x = right
    x = max(x, Decimal("-0.5"))
    for _ in range(s.randint(2, 5)):
        figure(scene, place, *anywhere(s, Decimal("-1.5"), x, near, far))


def within_length(scene):
    """A rug that is off the floor, and windows that are off the walls of a box, by less than a
    length within which polygons touch."""
    s = scene.source
    scene.before = ["set-touching 0.001"]
    y = s.decimal(-1, 0)

    def off():
        return s.decimal(-0.0009, 0.0009, 5)

    scene.floor(y)
    lifted = y + off()
    rug(scene, lifted)
    x, z = corner(s)
    low = (x, y + off(), z)
    high = tuple(a + s.decimal(0.4, 1.2) for a in low)
    scene.box(low, high)
    for _ in range(s.randint(2, 5)):
        axis, side = s.randrange(3), s.choice((low, high))
        first, second = [k for k in range(3) if k != axis]

        def place(a, b):
            p = [side[axis] + off()] * 3
            p[first], p[second] = a, b
            return tuple(p)

        left, right, bottom, top = anywhere(s, low[first], high[first], low[second], high[second])
        scene.polygon(place(left, bottom), place(right, bottom), place(left, top))


def barely_apart(scene):
    """Polygons that lie before others by little, but more than their reach, in any order."""
    s = scene.source
    y = s.decimal(-1, 0)
    layers = []
    for k in range(s.randint(2, 4)):
        y += Decimal(s.randint(1, 99)) * Decimal(10) ** -s.randint(8, 13)
        half = Decimal(2) - k * Decimal("0.3")
        layers.append(
            [
                (a * half + s.decimal(-0.2, 0.2), y, b * half + s.decimal(-0.2, 0.2))
                for a, b in ((-1, -1), (-1, 1), (1, 1), (1, -1))
            ]
        )
    s.shuffle(layers)
    for layer in layers:
        scene.polygon(*layer)


def about_the_reach(scene):
    """Layers on a floor that are some units of the last place of the largest coordinate apart, of
    which 16 are the reach."""
    s = scene.source
    scene.offset = (0, 0, 0)
    scene.floor(s.decimal(-1, 0))
    y = scene.low[1]
    for k in range(s.randint(2, 5)):
        layer = y + s.choice((-1, 1)) * s.choice((1, 3, 6, 9, 12, 15, 17, 20, 24)) * 2.0**-52
        half = 1.8 - 0.2 * k
        scene.polygon(
            (-half, layer, -half + s.uniform(-0.3, 0.3)),
            (-half + s.uniform(-0.3, 0.3), layer, half),
            (half, layer, half + s.uniform(-0.3, 0.3)),
            (half + s.uniform(-0.3, 0.3), layer, -half),
        )


def tiny_angles(scene):
    """Triangles that pass through a slope and through each other at angles of 1e-14 to 1e-6. The
    slope is one triangle: of two of one area, apart by rounding, either could be the plane of both."""
    s = scene.source
    scene.offset = (0, 0, 0)
    low, along, across = (float(s.decimal(-1, 1, 3)) for _ in range(3))

    def slope(x, z):
        return low + along * x + across * z

    triangles = [[(x, slope(x, z), z) for x, z in ((-2, -2), (-2, 6), (6, -2))]]
    for _ in range(s.randint(2, 4)):
        tilt = 10.0 ** -s.uniform(6, 14)
        a, b, c = (s.uniform(-1, 1) for _ in range(3))
        corners = [(s.uniform(-1.5, 1.5), s.uniform(-1.5, 1.5)) for _ in range(3)]
        triangles.append(
            [(x, slope(x, z) + tilt * (a * x + b * z + c / 2), z) for x, z in corners]
        )
    s.shuffle(triangles)
    for triangle in triangles:
        scene.polygon(*triangle)


def bent_rugs(scene):
    """Polygons of four to seven sides close to a floor, each vertex off by 1e-12 to 1e-7, or one
    alone: they count as flat, and three of their vertices are their plane."""
    s = scene.source
    scene.offset = (0, 0, 0)
    y = float(s.decimal(-1, 1))
    polygons = [[(-2, y, -2), (-2, y, 2), (2, y, 2), (2, y, -2)]]
    for _ in range(s.randint(2, 4)):
        bend, size = 10.0 ** -s.uniform(7, 12), s.uniform(0.4, 1.2)
        x, z, sides = s.uniform(-0.8, 0.8), s.uniform(-0.8, 0.8), s.randint(4, 7)
        angles = [2 * math.pi * (k + 0.3) / sides for k in range(sides)]
        of_all = s.random() < 0.5
        off = [bend * s.uniform(-1, 1) if of_all or k == 0 else 0.0 for k in range(sides)]
        s.shuffle(off)
        polygons.append(
            [
                (x + size * math.cos(a), y + up, z + size * math.sin(a))
                for a, up in zip(angles, off)
            ]
        )
    s.shuffle(polygons)
    for polygon in polygons:
        scene.polygon(*polygon)


def same_image(scene):
    """A rug on a floor and a box on it, in segments whose image transformations are one, in other
    words."""
    scene.same_image = True
    s = scene.source
    y = s.decimal(-1, 0)
    scene.floor(y)
    rug(scene, y)
    x, z = corner(s)
    wide, high, deep = sizes(s)
    scene.box((x, y, z), (x + wide, y + high, z + deep))


def image_in_other_words(s, names):
    """Lines of one image transformation for all the segments, by other numbers for each."""
    x, y = s.decimal(0, 0.5), s.decimal(0, 0.5)
    angle = s.randint(-720, 720) * Decimal("0.25")  # a double, to which 360 is added exactly
    turns = s.chance(60)
    lines = []
    for name in names:
        if turns:
            lines.append(f"set-image-rotation {name} {angle + 360 * s.randint(-1, 1):f}")
        else:  # nothing but the centre, which moves nothing
            lines.append(f"set-image-centre {name} {words([s.decimal(0, 1), s.decimal(0, 1)])}")
        if turns:
            lines.append(f"set-image-translation {name} {words([x, y])}")
    return lines


KINDS = {
    f.__name__.replace("_", "-"): f
    for f in (
        box_on_floor,
        stacked_boxes,
        flush_windows,
        roof_windows,
        flush_boxes,
        table_on_rug,
        drawn_on_faces,
        decals_on_slope,
        room,
        rug_draw,
        placed_parts,
        tiles,
        panelled_slope,
        within_length,
        barely_apart,
        about_the_reach,
        tiny_angles,
        bent_rugs,
        same_image,
    )
}


# ---- Cameras


def rounded(s, numbers, least=1):
    """As decimals of a few places, or in full."""
    places = s.choice((least, 2, 3, 4, None))
    return [x if places is None else Decimal(f"{x:.{places}f}") for x in numbers]


def plus(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def direction_of_sight(s):
    """Into the scene. One in ten is along an axis, or level with one."""
    d = s.direction()
    if s.chance(10):
        d[s.randrange(3)] = 0.0
        if s.chance(50):
            d = s.choice(([1, 0, 0], [0, -1, 0], [0, 0, -1], [-1, 0, 0], [0, 1, 0], [0, 0, 1]))
    length = math.sqrt(sum(x * x for x in d))
    return [x / length for x in d]


def view_up(s, into):
    """Any direction that is not nearly along the line of sight."""
    while True:
        up = [
            float(x) for x in s.choice(([0, 1, 0], [1, 0, 0], [0, 0, 1], rounded(s, s.direction())))
        ]
        length = math.sqrt(sum(x * x for x in up)) or 1
        if length > 0.5 and abs(sum(a * b for a, b in zip(up, into))) < 0.9 * length:
            return up


def window(s, half, varied):
    if not varied or s.chance(40):
        return [-half, half, -half, half]
    half *= s.uniform(0.3, 1)
    x, y = s.uniform(-0.5, 0.5) * half, s.uniform(-0.5, 0.5) * half
    return [x - half, x + half * s.uniform(0.7, 1.3), y - half, y + half * s.uniform(0.7, 1.3)]


def height_of_eye(s, eye, unit, levels):
    """An axis, and how far to move the eye along it into the plane of a floor or a wall, or nearly."""
    axis = min(range(3), key=lambda k: abs(unit[k]))
    if not levels or s.chance(75):
        return axis, 0
    beside = s.choice((0, 0, 1e-2, 1e-3, 1e-4, -1e-3))
    return axis, s.choice(levels)[axis] + beside - float(eye[axis])


def camera(s, middle, radius, levels, perspective, varied, again=False):
    """Lines that set a view of a ball, from outside, or in perspective also from within."""
    into = direction_of_sight(s)
    while not any(normal := [float(x) for x in rounded(s, plus([0, 0, 0], into, radius))]):
        pass
    length = math.sqrt(sum(x * x for x in normal))
    unit = [x / length for x in normal]
    lines = [f"set-view-plane-normal {words(normal)}", f"set-view-up {words(view_up(s, unit))}"]
    aside = s.direction() if s.chance(50) else [0, 0, 0]
    target = rounded(s, middle)
    eye_depth, half = -math.inf, 0.8 * radius
    if not perspective:
        lines.append(
            f"set-parallel {words(rounded(s, plus([-x for x in normal], aside, 0.3 * length)))}"
        )
    else:
        if s.chance(60):
            away = plus([float(x) for x in target], unit, -s.uniform(1.2, 4) * radius)
            eye = rounded(s, plus(away, aside, 0.2 * radius))
        else:
            within = plus([float(x) for x in target], s.direction(), 0.7 * radius * s.random())
            eye = rounded(s, within)
            target = rounded(s, plus([float(x) for x in eye], unit, radius))
        axis, up = height_of_eye(s, eye, unit, levels)
        if up:
            eye[axis], target[axis] = float(eye[axis]) + up, float(target[axis]) + up
        lines.append(f"set-perspective {words(eye)}")
        eye_depth = sum(n * (float(e) - float(t)) for n, e, t in zip(unit, eye, target))
    lines.append(f"set-view-reference-point {words(target)}")
    if varied and s.chance(30):
        lines.append(f"set-view-distance {words(rounded(s, [s.uniform(-0.3, 0.3) * radius]))}")
    lines.append(f"set-window {words(rounded(s, window(s, half, varied), 2))}")
    return lines + depth_of_view(s, radius, eye_depth, varied, again)


def depth_of_view(s, radius, eye_depth, varied, again):
    """Lines that set front and back planes, which clip or not. Without any the front plane is 1
    before the reference point; it must be behind the eye."""
    clipped = varied and s.chance(40)
    if not clipped and not again and eye_depth < -1.1 and s.chance(50):
        return []
    front = max(-2 * radius, 0.6 * eye_depth)
    if clipped:
        front *= s.uniform(0, 1)
    back = s.uniform(0.1, 1) * radius if clipped else 4 * radius
    lines = [f"set-view-depth {words(rounded(s, [front, back], 2))}"]
    return lines + ["set-front-plane-clipping on", "set-back-plane-clipping on"] * clipped


# ---- Programs


def turned(s, middle):
    """Lines of three rotations and a translation, and where they take a point."""
    x, y, z = middle
    lines = []
    for axis in "xyz":
        angle = s.decimal(-180, 180)
        lines.append(f"rotate-{axis}-3 {angle:f}")
        c, n = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        if axis == "x":
            y, z = c * y - n * z, n * y + c * z
        elif axis == "y":
            x, z = c * x + n * z, c * z - n * x
        else:
            x, y = c * x - n * y, n * x + c * y
    t = [s.decimal(-1, 1) for _ in range(3)]
    return lines + [f"translate-3 {words(t)}"], [a + float(b) for a, b in zip((x, y, z), t)]


def image_transformation(s, name):
    lines = []
    if s.chance(50):
        lines.append(f"set-image-centre {name} {words([s.decimal(0, 1), s.decimal(0, 1)])}")
    if s.chance(60):
        y = s.decimal(0.4, 1.5)
        lines.append(
            f"set-image-scale {name} {words([s.decimal(0.4, 1.5), y * s.choice((1, 1, 1, -1))])}"
        )
    if s.chance(60):
        lines.append(f"set-image-rotation {name} {s.decimal(-180, 180):f}")
    if s.chance(60):
        lines.append(
            f"set-image-translation {name} {words([s.decimal(-0.4, 0.4), s.decimal(-0.4, 0.4)])}"
        )
    return lines


def viewport(s):
    x, y = s.decimal(0, 0.4), s.decimal(0, 0.4)
    return f"set-viewport {words([x, x + s.decimal(0.3, 0.6), y, y + s.decimal(0.3, 0.6)])}"


def in_segments(s, lines):
    """Parts of the lines, one or several, not parted while a transformation is saved."""
    parts, saved = [[]], 0
    for line in lines:
        if not saved and parts[-1] and s.chance(15):
            parts.append([])
        parts[-1].append(line)
        saved += line.startswith("save-") - line.startswith("restore-")
    return parts


def make_scene(kind, s, varied):
    scene = Scene(s)
    if varied and s.chance(20):
        scene.offset = tuple(s.decimal(-1000, 1000) for _ in range(3))
    KINDS[kind](scene)
    return scene


def program(kind, perspective, modelled, seed, number):
    """The text of a program. One in three is varied: windows, viewports, segments, image
    transformations, offsets, clipping, two views."""
    s = Source(f"{seed}/{kind}/{perspective}/{modelled}/{number}")
    varied = number % 3 == 2
    scene = make_scene(kind, s, varied)
    middle = [(a + b) / 2 for a, b in zip(scene.low, scene.high)]
    radius = math.dist(scene.low, scene.high) / 2
    model, levels = [], [scene.low, scene.high]
    if modelled:
        model, middle = turned(s, middle)
    if modelled or scene.before:  # within a length, a floor in the eye's plane is all undecided
        levels = []
    look = camera(s, middle, radius, levels, perspective, varied)
    lines = [*look, "set-line-style none", *scene.before]
    if varied and s.chance(40):
        lines.append(viewport(s))
    if varied and s.chance(25):
        lines.append("set-back-face-removal on")
    several = scene.same_image or (varied and s.chance(60))
    parts = in_segments(s, scene.lines) if several else [scene.lines]
    lines += model
    for name, part in enumerate(parts, 1):
        lines += [f"open-segment {name}", *part, "close-segment"]
    if varied and s.chance(15):  # the scene once more, in another view
        lines += [
            *camera(s, middle, radius, levels, perspective, varied, True),
            viewport(s),
            f"open-segment {len(parts) + 1}",
            *scene.lines,
            "close-segment",
        ]
        parts.append([])
    if scene.same_image:
        lines += image_in_other_words(s, range(1, len(parts) + 1))
    elif varied and s.chance(35):
        same = s.chance(50)  # of all segments, or of each its own
        image = image_transformation(s, "NAME")
        for name in range(1, len(parts) + 1):
            lines += [l.replace("NAME", str(name)) for l in image]
            image = image if same else image_transformation(s, "NAME")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Prints a drawing program whose polygons touch.")
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("--projection", choices=("parallel", "perspective"), default="perspective")
    parser.add_argument("--modelled", action="store_true")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--number", type=int, default=0)
    options = parser.parse_args()
    sys.stdout.write(
        program(
            options.kind,
            options.projection == "perspective",
            options.modelled,
            options.seed,
            options.number,
        )
    )


if __name__ == "__main__":
    main()
