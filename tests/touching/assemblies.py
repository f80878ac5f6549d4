#!/usr/bin/python3
"""Assemblies of parts that touch, in whole numbers, and solids whose faces are cut at random.

    tests/touching/assemblies.py KIND FOLDER [--seed K] [--number N] [--format FORMAT] [--axis]

writes into FOLDER what judge_assemblies compares in view N of a kind: whole.draw and
whole-view.draw, moved.FORMAT and moved-view.draw. Of t-vertices, `whole` is the clean solid. The
same words always write the same files.
"""
import argparse
import math
import pathlib
import sys
from dataclasses import dataclass, field

sys.dont_write_bytecode = True
import posed_meshes
import solids
from solids import box, plate_with_hole, prism, rectangle, ring, tapered
from touching_scenes import Source

GRID = 4  # boxes have their corners on it, so that what does not touch is some units apart


@dataclass
class Part:
    name: str
    faces: list
    closed: bool = True


@dataclass
class Assembly:
    """Parts in order of entry. Figures in faces are parts that are not closed."""

    source: Source
    parts: list = field(default_factory=list)

    def add(self, name, faces, closed=True):
        self.parts.append(Part(name, faces, closed))

    def box(self, name, low, high):
        self.add(name, box(low, high))

    def faces(self):
        return [face for part in self.parts for face in part.faces]

    def between(self, low, high, step=GRID):
        """A random multiple of the step."""
        return step * self.source.randint(-(-low // step), high // step)


# ---- Kinds of assemblies


def plates(a):
    """Blocks on a plate: within it, flush with its sides, over its edge, beside each other, through
    each other, on each other."""
    s = a.source
    wide, deep, thick = a.between(200, 400), a.between(160, 300), a.between(8, 32)
    a.box("plate", (0, 0, 0), (wide, deep, thick))
    low, high = (0, 0, 0), (0, 0, thick)
    for k in range(s.randint(4, 8)):
        w, d, h = a.between(24, 100), a.between(24, 100), a.between(8, 80)
        places = [(a.between(8, wide - w), a.between(8, deep - d), thick)]
        places.append((s.choice((0, wide - w)), s.choice((0, a.between(8, 56), deep - d)), thick))
        places.append((wide - w // 8 * 4, a.between(-12, 40), thick))
        if k:
            places.append((high[0], low[1] + s.choice((0, 8, -12)), low[2]))
            places.append((low[0] + 12, low[1] - 8, low[2]))
            places.append((low[0] + s.choice((0, 8)), low[1] + s.choice((0, 8)), high[2]))
        low = s.choice(places)
        high = (low[0] + w, low[1] + d, low[2] + h)
        a.box(f"block {k}", low, high)


def bolt(a, name, centre, shank, depth, top):
    """A shank that fills its hole, and a head on the face `top`."""
    a.add(f"{name}, shank", prism(shank, top - depth, top))
    radius = max(abs(x - centre[0]) for x, _ in shank)
    if a.source.chance(50):
        a.add(f"{name}, washer", prism(ring(8, radius + 12, centre, 0.5), top, top + 4))
        top += 4
    a.add(f"{name}, head", prism(ring(6, radius + 8, centre), top, top + 12))


def bracket(a):
    """On a floor and at a wall, an angle of two plates with holes, ribs in its corner, bolts."""
    s = a.source
    wide, deep, high, thick = (
        a.between(160, 280),
        a.between(140, 200),
        a.between(120, 240),
        a.between(12, 20),
    )
    around = a.between(20, 60)
    a.box("floor", (-around, -16, -16), (wide + around, deep + around, 0))
    a.box("wall", (-around, -16, 0), (wide + around, 0, high + around))
    a.box("leg at the wall", (0, 0, 0), (wide, thick, high))
    middle = wide // 8 * 4
    for k, (left, right) in enumerate(((0, middle), (middle, wide))):
        centre = ((left + right) // 2, thick + (deep - thick) * 5 // 8)
        hole = ring(8, a.between(8, 16), centre)
        a.add(f"leg {k}", plate_with_hole(left, right, thick, deep, hole, 0, thick))
        if s.chance(80):
            bolt(a, f"bolt {k}", centre, hole, thick, thick)
    along, up = (deep - thick) // 3, a.between(60, high - thick)
    for k, x in enumerate((0, middle - thick // 2, wide - thick)):
        corner = [(thick, thick), (thick + along, thick), (thick, thick + up)]
        a.add(f"rib {k}", prism(corner, x, x + thick, axis=0))


def toothed(teeth, module, centre, turn):
    """The outline of a gear, rounded; `turn` in radians."""
    outline = []
    for k in range(teeth):
        for share, radius in ((-0.3, -1.1), (-0.13, 0.8), (0.13, 0.8), (0.3, -1.1)):
            angle = turn + 2 * math.pi * (k + share) / teeth
            r = module * (teeth / 2 + radius)
            outline.append(
                (round(centre[0] + r * math.cos(angle)), round(centre[1] + r * math.sin(angle)))
            )
    return outline


def gear(outline, shaft):
    """Around a shaft of an even number of corners; its ends are two faces each."""
    middle = tuple(sum(x) / len(shaft) for x in zip(*shaft))

    def nearest(corner):
        angles = [
            math.remainder(
                math.atan2(p[1] - middle[1], p[0] - middle[0])
                - math.atan2(corner[1] - middle[1], corner[0] - middle[0]),
                2 * math.pi,
            )
            for p in outline
        ]
        return min(range(len(outline)), key=lambda k: abs(angles[k]))

    half = len(shaft) // 2
    links = ((nearest(shaft[0]), 0), (nearest(shaft[half]), half))
    return lambda low, high: solids.prism_with_hole(outline, shaft, links, low, high)


def gears(a):
    """Gears that mesh, on washers, around shafts that stand in a plate, or with the shafts through
    them; a bar on the shafts."""
    s = a.source
    module, thick = 12, a.between(12, 24)
    centre, turn, before = (0, 0), s.uniform(0, 1), None
    wheels, plate = [], [0, 0, 0, 0]
    for k in range(s.randint(2, 4)):
        teeth = s.choice((8, 9, 10, 12))
        if k:
            ahead = s.uniform(-0.5, 0.5)
            apart = module * (before + teeth) / 2
            share = ((ahead - turn) / (2 * math.pi / before)) % 1
            turn = ahead + math.pi + (share + 0.5) * 2 * math.pi / teeth
            centre = (
                centre[0] + round(apart * math.cos(ahead)),
                centre[1] + round(apart * math.sin(ahead)),
            )
        wheels.append((teeth, centre, turn))
        radius = GRID * math.ceil(module * (teeth / 2 + 1) / GRID)
        plate = [
            min(plate[0], centre[0] - radius),
            max(plate[1], centre[0] + radius),
            min(plate[2], centre[1] - radius),
            max(plate[3], centre[1] + radius),
        ]
        before = teeth
    a.add("plate", prism(rectangle(*plate), -thick, 0))
    top = 4 + thick + a.between(8, 24)
    for k, (teeth, centre, turn) in enumerate(wheels):
        shaft = ring(8, 16, centre)
        a.add(f"washer {k}", prism(ring(8, 26, centre, 0.5), 0, 4))
        outline = toothed(teeth, module, centre, turn)
        if s.chance(60):
            a.add(f"gear {k}", gear(outline, shaft)(4, 4 + thick))
        else:
            a.add(f"gear {k}, pierced", prism(outline, 4, 4 + thick))
        a.add(f"shaft {k}", prism(shaft, 4, top))
    if s.chance(60):
        (x, y), (u, v) = wheels[0][1], wheels[1][1]
        a.box("bar", (x - 8, min(y, v) - 8, top), (u + 8, max(y, v) + 8, top + 12))


def bricks(a):
    """Courses of bricks, each by half a brick off the one below: a wall with an opening under a
    lintel, and often a second wall at its end; on a slab."""
    s = a.source
    length, thick, high = a.between(48, 72, 8), a.between(20, 32), a.between(16, 24)
    courses, count = s.randint(4, 6), s.randint(3, 4)
    whole = length * count
    a.box("slab", (-20, -40, -12), (whole + 20, thick + 2 * length + 20, 0))
    gap = (length, 2 * length) if s.chance(60) else (0, 0)
    for course in range(courses):
        z = high * course
        marks = list(range(0, whole + 1, length))
        if course % 2:
            marks = [0, *range(length // 2, whole, length), whole]
        is_open = gap[1] > 0 and 1 <= course <= courses - 3
        is_above = gap[1] > 0 and course == courses - 2
        for x, end in zip(marks, marks[1:]):
            lintel = (gap[0] - length // 2, gap[1] + length // 2)
            clipped = [(x, end)]
            for low, top in ([gap] if is_open else []) + ([lintel] if is_above else []):
                clipped = [
                    (p, q)
                    for u, v in clipped
                    for p, q in ((u, min(v, low)), (max(u, top), v))
                    if p < q
                ]
            for p, q in clipped:
                a.box(f"brick {course}/{p}", (p, 0, z), (q, thick, z + high))
        if is_above:
            a.box("lintel", (lintel[0], 0, z), (lintel[1], thick, z + high))
    if s.chance(60):
        for course in range(s.randint(2, courses)):
            y = thick + (length // 2 if course % 2 else 0)
            if course % 2:
                a.box(
                    f"half {course}",
                    (0, thick, high * course),
                    (thick, y, high * (course + 1)),
                )
            a.box(
                f"side {course}",
                (0, y, high * course),
                (thick, y + length, high * (course + 1)),
            )


def furniture(a, name, at, wide, deep, high):
    """Four legs, and a top on them."""
    x, y, z = at
    leg, thick, inset = a.between(8, 16), a.between(8, 12), a.source.choice((0, 4, 8))
    for u in (x + inset, x + wide - inset - leg):
        for v in (y + inset, y + deep - inset - leg):
            a.box(f"{name}, leg", (u, v, z), (u + leg, v + leg, z + high))
    a.box(f"{name}, top", (x, y, z + high), (x + wide, y + deep, z + high + thick))
    return z + high + thick


def table_in_room(a):
    """A floor and two walls, as slabs or as faces; a rug, a table on it or beside it with things on
    it, a stool, skirting, a picture at a wall."""
    s = a.source
    wide, deep, high = a.between(320, 480), a.between(280, 400), a.between(200, 280)
    if s.chance(50):
        a.add("floor", [[(0, 0, 0), (wide, 0, 0), (wide, deep, 0), (0, deep, 0)]], False)
        a.add("wall", [[(0, deep, 0), (wide, deep, 0), (wide, deep, high), (0, deep, high)]], False)
        a.add("side", [[(0, 0, 0), (0, deep, 0), (0, deep, high), (0, 0, high)]], False)
    else:
        a.box("floor", (-12, 0, -12), (wide, deep + 12, 0))
        a.box("wall", (0, deep, 0), (wide, deep + 12, high))
        a.box("side", (-12, 0, 0), (0, deep + 12, high))
    rug = 2 if s.chance(70) else 0
    if rug:
        a.box("rug", (40, 28, 0), (wide - 60, deep - 48, rug))
    x, y = a.between(60, 100), a.between(48, 80)
    within = s.chance(50)
    top = furniture(a, "table", (x, y, rug if within else 0), 160, 120, a.between(88, 120))
    a.box("book", (x + 20, y + 16, top), (x + 60, y + 72, top + 8))
    a.box("second book", (x + 24, y + 20, top + 8), (x + 56, y + 72, top + 14))
    a.add("vase", tapered(ring(8, 8, (x + 110, y + 60)), (x + 110, y + 60), (1, 2), top, top + 36))
    furniture(a, "stool", (wide - 72, deep - 80, 0), 48, 48, a.between(48, 64))
    a.box("skirting", (0, deep - 4, 0), (wide, deep, 16))
    a.box("picture", (0, 100, 120), (4, 200, 180))


def pump(a):
    """About 20 parts: a motor on saddles, a housing of 16 sides between flanges, a shaft through
    both, pipes, bolts on a flange, on a plate with feet."""
    s = a.source
    thick, axle = a.between(12, 20), a.between(80, 100)
    z = thick + axle  # of the shaft's middle
    a.box("plate", (-180, -80, 0), (200, 80, thick))
    for k, (x, y) in enumerate(((-180, -80), (160, -80), (-180, 48), (160, 48))):
        a.box(f"foot {k}", (x, y, -16), (x + 40, y + 32, 0))
    motor = ring(8, a.between(48, 64), (0, z), 0.5)
    below = min(v for _, v in motor)
    a.add("motor", prism(motor, -160, -28, axis=0))
    for k, x in enumerate((-148, -72)):
        a.box(f"saddle {k}", (x, -20, thick), (x + 28, 20, below))
    a.box("terminals", (-120, -24, 2 * z - below), (-64, 24, 2 * z - below + 28))
    a.add("shaft", prism(ring(6, 12, (0, z)), -28, a.between(24, 60), axis=0))
    a.add("coupling", prism(ring(8, 24, (0, z)), -16, 8, axis=0))
    housing, flange = ring(16, 60, (0, z), 0.5), ring(16, 76, (0, z), 0.5)
    a.add("flange at the motor", prism(flange, 24, 36, axis=0))
    a.add("housing", prism(housing, 36, 96, axis=0))
    a.add("flange", prism(flange, 96, 108, axis=0))
    a.add("cover", tapered(ring(16, 28, (0, z), 0.5), (0, z), (2, 1), 108, 132, axis=0))
    a.add("inlet", prism(ring(8, 20, (0, z), 0.5), 132, 180, axis=0))
    a.add("flange of the inlet", prism(ring(8, 36, (0, z), 0.5), 180, 192, axis=0))
    bolts = s.choice((4, 6, 8))
    for k in range(bolts):
        angle = 2 * math.pi * (k + 0.5) / bolts
        at = (round(65 * math.cos(angle)), z + round(65 * math.sin(angle)))
        a.add(f"bolt {k}", prism(ring(6, 7, at), 108, 116, axis=0))
    outlet = ring(8, 20, (66, 0), 0.5)
    up = z + a.between(80, 100)
    a.add("outlet", prism(outlet, z + 40, up))
    a.add("flange of the outlet", prism(ring(8, 36, (66, 0), 0.5), up, up + 12))
    a.box("stand", (52, -28, thick), (80, 28, min(v for _, v in housing)))


# ---- Kinds with figures in faces. Faces to draw on are parallelograms whose sides are of STEPS
# equal parts in whole numbers.

STEPS = 16


class Panel:
    """A parallelogram, with whole-number places (i, j) up to STEPS on it."""

    def __init__(self, face):
        origin, first, _, last = face
        self.origin = origin
        self.u, self.v = (solids.minus(p, origin) for p in (first, last))
        assert all(x % STEPS == 0 for x in self.u + self.v)

    def figure(self, points):
        return [
            tuple(
                o + i * (x // STEPS) + j * (y // STEPS)
                for o, x, y in zip(self.origin, self.u, self.v)
            )
            for i, j in points
        ]


def panels_of(faces):
    """The faces with four corners, which must be parallelograms."""
    return [Panel(face) for face in faces if len(face) == 4]


def drawn_on(a):
    """A slab, and on it one or two blocks, houses with pitched roofs, or wedges: the panels."""
    s = a.source
    a.box("slab", (-160, -160, -16), (480, 320, 0))
    panels = [Panel([(-160, -160, 0), (480, -160, 0), (480, 320, 0), (-160, 320, 0)])]
    x = a.between(-100, 40)
    for k in range(s.randint(1, 2)):
        wide, half = a.between(96, 160, STEPS), a.between(48, 96, STEPS)
        high = a.between(80, 160, STEPS)
        y, ridge = a.between(-80, 80), high + a.between(48, 112, STEPS)
        shape, profile = s.choice(
            (
                ("block", [(2 * half, high), (0, high)]),
                ("house", [(2 * half, high), (half, ridge), (0, high)]),
                ("wedge", [(0, high)]),
            )
        )
        outline = [(y + u, v) for u, v in [(0, 0), (2 * half, 0), *profile]]
        faces = prism(outline, x, x + wide, axis=0)
        a.add(f"{shape} {k}", faces)
        panels += panels_of(faces)
        x += wide + s.choice((0, 32))
    return panels


def figure(s, left, right, low, high):
    """A rectangle, triangle, pentagon or arrow from side to side of a rectangle at least 3 wide."""
    middle, waist = (left + right) // 2, (low + high) // 2
    return s.choice(
        (
            rectangle(left, right, low, high),
            [(left, low), (right, low), (middle, high)],
            [(left, low), (middle, low), (right, waist), (middle, high), (left, high)],
            [(left, low), (right, low), (right, high), (middle, waist), (left, high)],
        )
    )


def within(s, left, right, low, high):
    """A rectangle in another, at least 3 wide."""
    x, y = s.randint(left, right - 3), s.randint(low, high - 3)
    return x, s.randint(x + 3, right), y, s.randint(y + 3, high)


def decals(a):
    """Figures in faces, of which some lie over others."""
    s = a.source
    for panel in drawn_on(a):
        for k in range(s.randint(1, 4)):
            points = figure(s, *within(s, 0, STEPS, 0, STEPS))
            a.add(f"decal {k}", [panel.figure(points)], False)


def windows(a):
    """Windows in walls and roofs: a frame, in it one pane or two."""
    s = a.source
    for panel in drawn_on(a):
        for k in range(s.randint(0, 2)):
            left, low = s.choice((1, 6, 11)), s.randint(1, 8)
            high = low + s.randint(4, 7)
            a.add(f"frame {k}", [panel.figure(rectangle(left, left + 4, low, high))], False)
            middle = s.randint(low + 1, high - 1)  # of two panes, or at an end of one
            for bottom, top in ((low + 1, middle), (middle, high - 1)):
                if bottom < top:
                    pane = rectangle(left + 1, left + 3, bottom, top)
                    a.add(f"pane {k}", [panel.figure(pane)], False)


LETTERS = {  # outlines, counterclockwise, 3 wide and 5 high
    "L": [(0, 0), (3, 0), (3, 1), (1, 1), (1, 5), (0, 5)],
    "T": [(1, 0), (2, 0), (2, 4), (3, 4), (3, 5), (0, 5), (0, 4), (1, 4)],
    "H": [(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0)]
    + [(3, 5), (2, 5), (2, 3), (1, 3), (1, 5), (0, 5)],
    "E": [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2)]
    + [(3, 3), (1, 3), (1, 4), (3, 4), (3, 5), (0, 5)],
    "U": [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 5), (0, 5)],
    "V": [(1, 0), (2, 0), (3, 5), (2, 5), (1, 2), (1, 5), (0, 5)],
    "F": [(0, 0), (1, 0), (1, 2), (2, 2), (2, 3), (1, 3), (1, 4), (3, 4), (3, 5), (0, 5)],
}


def labels(a):
    """Words of letters, often on a plate of their own, on two lines."""
    s = a.source
    for panel in drawn_on(a):
        for low in s.sample((1, 9), s.randint(0, 2)):
            if s.chance(60):
                a.add("label", [panel.figure(rectangle(0, 16, low - 1, low + 6))], False)
            for k in range(s.randint(2, 4)):
                outline = LETTERS[s.choice(sorted(LETTERS))]
                points = [(4 * k + x, low + y) for x, y in outline]
                a.add("letter", [panel.figure(points)], False)


# ---- Solids whose faces are cut


def one_solid(a):
    """An angle, a channel, a tee, a plate with a hole, a gear, a frustum, a block."""
    s = a.source
    w, t, h = a.between(120, 240), a.between(24, 40), a.between(60, 160)
    angle = [(0, 0), (w, 0), (w, t), (t, t), (t, w), (0, w)]
    channel = [(0, 0), (w, 0), (w, w), (w - t, w), (w - t, t), (t, t), (t, w), (0, w)]
    tee = [(0, 0), (3 * t, 0), (3 * t, t), (2 * t, t), (2 * t, w), (t, w), (t, t), (0, t)]
    axis = s.randrange(3)
    makers = {
        "angle": lambda: prism(angle, 0, h, axis),
        "channel": lambda: prism(channel, 0, h, axis),
        "tee": lambda: prism(tee, 0, h, axis),
        "plate": lambda: plate_with_hole(0, w, 0, h, ring(8, 20, (w // 2, h // 2)), 0, t, axis),
        "gear": lambda: prism(toothed(8, 20, (0, 0), s.uniform(0, 1)), 0, t, axis),
        "frustum": lambda: tapered(ring(8, 60), (0, 0), (2, 1), 0, h, axis),
        "block": lambda: box((0, 0, 0), (w, h, t)),
    }
    name = s.choice(list(makers))
    a.add(name, makers[name]())


LEAST_WIDTH = 4  # of what is cut off

ASSEMBLIES = {
    f.__name__.replace("_", "-"): f for f in (plates, bracket, gears, bricks, table_in_room, pump)
}
IN_FACES = {f.__name__: f for f in (decals, windows, labels)}
CUT = {"t-vertices": one_solid}
KINDS = {**ASSEMBLIES, **IN_FACES, **CUT}

LEAST_FEATURE = 1e-3  # of the size: what is finer is made anew
CREASE, NEAR_A_CREASE = 30, 0.5  # degrees
ATTEMPTS = 100


def is_fair(faces):
    """No feature is fine, and no angle nearly one that decides whether a side is a crease."""
    size = max(max(x) - min(x) for x in zip(*(p for face in faces for p in face)))
    if any(abs(angle - CREASE) < NEAR_A_CREASE for angle in solids.angles(faces)):
        return False
    return posed_meshes.least_feature(faces) >= LEAST_FEATURE * size


def assembly(kind, seed, number):
    for attempt in range(ATTEMPTS):
        made = Assembly(Source(f"{seed}/{kind}/{number}/{attempt}"))
        KINDS[kind](made)
        if is_fair(made.faces()):
            return made
    raise ValueError(f"{kind}: no fair assembly in {ATTEMPTS}")


def cut_faces(seed, number, made):
    """Those of an assembly, cut."""
    source = Source(f"{seed}/cuts/{number}")
    return solids.cut_at_random(source, made.faces(), source.randint(5, 60), LEAST_WIDTH)


# ---- The command


def main():
    parser = argparse.ArgumentParser(description="Writes an assembly, and the same moved.")
    add = parser.add_argument
    add("kind", choices=KINDS)
    add("folder", metavar="FOLDER", type=pathlib.Path)
    add("--seed", default="1")
    add("--number", type=int, default=0)
    add("--format", choices=posed_meshes.FORMATS, default="stl")
    add("--axis", action="store_true", help="a view along an axis, or an isometric one")
    options = parser.parse_args()
    made = assembly(options.kind, options.seed, options.number)
    entered = moved = made.faces()
    if options.kind in CUT:
        moved = cut_faces(options.seed, options.number, made)
    posed = posed_meshes.Posed(
        f"{options.seed}/{options.kind}", options.number, entered, moved, options.axis
    )
    options.folder.mkdir(parents=True, exist_ok=True)
    posed.write_whole(options.folder, options.format)
    print(posed.write_moved(options.folder, options.format))


if __name__ == "__main__":
    main()
