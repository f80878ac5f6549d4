#!/usr/bin/python3
"""The visible lines of a drawing program by the definition, from the program's text alone.

    tests/touching/line_oracle.py PROGRAM.draw

Prints what is seen of each line, as a dump does: the pick identifier of the item that names it,
then the two ends over the picture. At the end stands the length of all. README.md says what is
refused.

A line is a side of a polygon whose line style is not none, or what line-abs-3 enters. Solid
polygons hide it, those of all segments together. A place on it is hidden where solid polygons that
are strictly nearer cover what is immediately left of it and what is immediately right of it.

- A side has the depth of the plane that its polygon lies in, and no polygon in that plane hides it.
- An end of a line, as entered, that is within reach of a plane lies on it. With both ends on it the
  line lies in the plane; with one, the line is wholly on the side of the other end.
- Sides of several polygons with the same two ends under one matrix are one line, which is seen
  where it is seen for one of them.

All signs are those of whole numbers. Ends of pieces are rounded down to 2^-128 of their line.
"""
import argparse
import math
import sys

sys.dont_write_bytecode = True
from dataclasses import dataclass, field, replace
from fractions import Fraction

import exact_view
import planes
import program_oracle
import program_reader

PLACES = 128  # binary places of a place along a line
ONE = 1 << PLACES
ALL = [(0, ONE)]
NEAREST = 10**6  # what is nearer the eye than this part of the view plane's distance is cut away
NEAR = 1e-11  # of the picture: nearer to a line's line, viewing may round a vertex across it
SURE = 1e-7  # of the picture: farther away, doubles tell the side
FLAT = 1e-9  # of the window: the area of a polygon that may be seen edge-on but for rounding


# ---- The program


@dataclass
class Item:
    """A polygon or a line, in the place of program.polygons that has its points. A line is entered
    there as a polygon of three vertices, of which two are equal: it has no plane."""

    is_line: bool
    is_drawn: bool
    pick: int  # its ordinal among polygons; -1 of a line


class Reader(program_reader.Reader):
    """Knows lines and line styles, too."""

    def __init__(self):
        super().__init__()
        self.items = []
        self.is_drawn = True
        self.at = (0.0, 0.0, 0.0)
        self.polygons = 0

    def line(self, text):
        words = text.split("#")[0].split()
        if words and words[0] in ROUTINES:
            ROUTINES[words[0]](self, words[1:])
        else:
            super().line(text)

    def polygon(self, *numbers):
        super().polygon(*numbers)
        self.items.append(Item(False, self.is_drawn, self.polygons))
        self.polygons += 1
        self.at = tuple(numbers[-3:])

    def move_to(self, *point):
        self.at = point

    def line_to(self, *point):
        if self.open is None:
            raise program_reader.Refused("line-abs-3: no segment is open")
        self.program.polygons.append(
            program_reader.Polygon(
                [self.at, point, point], self.in_force()[:3], self.open, False, False
            )
        )
        self.items.append(Item(True, self.is_drawn, -1))
        self.at = point


def line_style(reader, arguments):
    if arguments[:1] == ["solid"]:
        if len(program_reader.numbers(arguments[1:])) not in (3, 4):
            raise program_reader.Refused("set-line-style solid: 3 or 4 numbers are expected")
    elif arguments != ["none"]:
        raise program_reader.Refused("set-line-style: solid or none is expected")
    reader.is_drawn = arguments != ["none"]


def one_of(*known):
    """A routine that changes nothing here."""

    def check(_, arguments):
        if " ".join(arguments) not in known:
            raise program_reader.Refused(f"{' '.join(arguments)} is not known here")

    return check


ROUTINES = {
    "set-line-style": line_style,
    "set-hidden-method": one_of("franklin", "roberts", "appel"),
    "set-hidden-scope": one_of("all"),
    "move-abs-3": program_reader.with_numbers(3, Reader.move_to),
    "line-abs-3": program_reader.with_numbers(3, Reader.line_to),
    "polygon-abs-3": program_reader.with_numbers(None, Reader.polygon),
}


def read(text):
    """The Program of a text, and its items."""
    reader = Reader()
    for number, line in enumerate(text.splitlines(), 1):
        try:
            reader.line(line)
        except (program_reader.Refused, ValueError, IndexError) as error:
            raise program_reader.Refused(f"line {number}: {error}") from error
    if reader.open is not None or reader.saved:
        raise program_reader.Refused("at the end a segment is open, or a transformation is saved")
    return reader.program, reader.items


# ---- The view


class Look(program_oracle.Look):
    """World points to the window, from 0 to W, and from there to the picture."""

    def __init__(self, segment, scale):
        view, image = segment.view, segment.image
        whole = replace(view, viewport=(0.0, 1.0, 0.0, 1.0))
        super().__init__(whole, program_reader.Image(), 1, 1, scale)
        unclipped = replace(view, front_clipping=False, back_clipping=False)
        self.key = unclipped, exact_view.image_numbers(image)
        self.frame = None
        if view.viewport != whole.viewport or image != program_reader.Image():
            shown = program_reader.View(window=whole.viewport, viewport=view.viewport)
            rows = exact_view.picture_rows(shown, image, 1, 1)
            self.frame = [
                [int(Fraction(x) * 2**program_oracle.BITS) for x in row] for row in rows[:2]
            ]
        nearest = (scale << program_oracle.BITS) // NEAREST
        self.inside = [
            lambda v: v[3] - nearest,
            lambda v: v[0],
            lambda v: v[3] - v[0],
            lambda v: v[1],
            lambda v: v[3] - v[1],
        ]
        if view.front_clipping:
            self.inside.append(lambda v: v[3] - v[2])
        if view.back_clipping:
            self.inside.append(lambda v: v[2])

    def picture_point(self, v):
        if self.frame is None:
            return reduced(v)
        x, y = (r[0] * v[0] + r[1] * v[1] + r[3] * v[3] for r in self.frame)
        return reduced((x, y, v[2] << program_oracle.BITS, v[3] << program_oracle.BITS))

    def clipped_polygon(self, vertices):
        for inside in self.inside:
            if any(inside(v) < 0 for v in vertices):
                vertices = [reduced(v) for v in program_oracle.cut(vertices, inside)]
        return vertices

    def clipped_line(self, p, q):
        """Its two ends, or None."""
        for inside in self.inside:
            at_p, at_q = inside(p), inside(q)
            if at_p < 0 and at_q < 0:
                return None
            if at_p < 0 or at_q < 0:
                cut = reduced(tuple(x * abs(at_q) + y * abs(at_p) for x, y in zip(p, q)))
                p, q = (cut, q) if at_p < 0 else (p, cut)
        return p, q


def reduced(v):
    common = math.gcd(*v)
    return tuple(x // common for x in v) if common > 1 else v


def side_of_area(polygon):
    """The sign of the area of what is seen of a polygon, and whether rounding may decide it."""
    corners = [(v[0], v[1], v[3]) for v in polygon]
    area = program_oracle.signed_area(corners)
    if abs(area) < FLAT:
        x, y = ([Fraction(v[k], v[2]) for v in corners] for k in (0, 1))
        exact = sum(x[k - 1] * y[k] - x[k] * y[k - 1] for k in range(len(corners)))
        return (exact > 0) - (exact < 0), True
    return (1 if area > 0 else -1), False


# ---- Parts of a line: lists of (from, to), in order and apart


def union(parts):
    joined = []
    for start, end in sorted(parts):
        if start >= end:
            continue
        if joined and start <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(end, joined[-1][1])
        else:
            joined.append((start, end))
    return joined


def both(a, b):
    return union((max(p[0], q[0]), min(p[1], q[1])) for p in a for q in b)


def without(a, b):
    """What b leaves of a."""
    left = []
    for start, end in a:
        for p, q in b:
            if q <= start or p >= end:
                continue
            if p > start:
                left.append((start, p))
            start = max(start, q)
        if start < end:
            left.append((start, end))
    return left


def total(parts):
    return sum(end - start for start, end in parts)


# ---- What hides


def plane_in_picture(points, look):
    """The coefficients of a plane in the picture, so that they give what is nearer a positive
    number; None if it is seen edge-on."""
    through = [look.picture_point(look.view_point(p)) for p in points]
    plane = program_oracle.DepthPlane.through(through, None)
    if plane.edge_on:
        return None
    sign = 1 if plane.whole[2] > 0 else -1
    return reduced(tuple(sign * x for x in plane.whole))


def value(plane, v):
    return plane[0] * v[0] + plane[1] * v[1] + plane[2] * v[2] + plane[3] * v[3]


def line_of(a, b):
    """The line through two points of the picture: what is left of it gives a positive number."""
    return (
        a[1] * b[3] - a[3] * b[1],
        a[3] * b[0] - a[0] * b[3],
        a[0] * b[1] - a[1] * b[0],
    )


def on_line(line, v):
    return line[0] * v[0] + line[1] * v[1] + line[2] * v[3]


@dataclass
class Shown:
    """A polygon or a line of which something is in the picture."""

    number: int
    look: Look
    world: planes.WorldPolygon  # its own
    plane_of: planes.WorldPolygon  # what gives its plane, or None
    plane: tuple  # in the picture, or None
    corners: list  # clipped, in the picture
    solid: bool
    spots: list = field(default_factory=list)  # the corners in doubles
    lines: dict = field(default_factory=dict)  # the lines of its sides
    box: tuple = ()

    def __post_init__(self):
        self.spots = [(v[0] / v[3], v[1] / v[3]) for v in self.corners]
        x, y = zip(*self.spots)
        self.box = min(x), max(x), min(y), max(y)

    def line(self, k):
        if k not in self.lines:
            self.lines[k] = line_of(self.corners[k - 1], self.corners[k])
        return self.lines[k]


class Stretch:
    """What is left of a line after clipping, in the picture. Both ends have one W, so that places
    on it are shares of its projection. Its depth is a sharer's."""

    def __init__(self, p, q, plane):
        if plane is not None:
            p, q = at_depth(p, plane), at_depth(q, plane)
        self.p = reduced(tuple(x * q[3] for x in p))
        self.q = reduced(tuple(x * p[3] for x in q))
        if self.p[3] != self.q[3]:
            w = self.p[3]
            self.p = tuple(x * self.q[3] for x in self.p)
            self.q = tuple(x * w for x in self.q)
        self.line = line_of(self.p, self.q)
        self.ends = [(v[0] / v[3], v[1] / v[3]) for v in (self.p, self.q)]
        (a, b), (c, d) = self.ends
        self.length = math.hypot(c - a, d - b)
        self.box = min(a, c), max(a, c), min(b, d), max(b, d)

    def sides(self, hider):
        """Of each corner on which side of the line it is, and whether rounding may decide that."""
        (x, y), (c, d) = self.ends
        dx, dy = (c - x) / self.length, (d - y) / self.length
        sides, close = [], []
        for corner, (a, b) in zip(hider.corners, hider.spots):
            off = dx * (b - y) - dy * (a - x)
            away = max(1.0, math.hypot(a - x, b - y) / self.length)
            if abs(off) > SURE * away:
                sides.append(1 if off > 0 else -1)
                close.append(False)
            else:
                exact = on_line(self.line, corner)
                sides.append((exact > 0) - (exact < 0))
                close.append(exact != 0 and abs(off) <= NEAR * away)
        return sides, close

    def covered(self, hider, sides, left):
        """Where a polygon covers what is immediately left of the line, or right of it."""
        places = []
        for k, side in enumerate(sides):
            before = sides[k - 1]
            if (before > 0) != (side > 0) if left else (before < 0) != (side < 0):
                line = hider.line(k)
                at_p, at_q = on_line(line, self.p), on_line(line, self.q)
                places.append((at_p << PLACES) // (at_p - at_q))
        places = [min(max(p, 0), ONE) for p in sorted(places)]
        return union(zip(places[::2], places[1::2]))

    def behind(self, plane):
        """Where it is strictly behind a plane."""
        at_p, at_q = value(plane, self.p), value(plane, self.q)
        if at_p >= 0 and at_q >= 0:
            return []
        if at_p <= 0 and at_q <= 0:
            return ALL
        place = (at_p << PLACES) // (at_p - at_q)
        return union([(0, place) if at_p < 0 else (place, ONE)])


def at_depth(v, plane):
    """A point with the depth that a plane has there."""
    a, b, c, d = plane
    return (c * v[0], c * v[1], -(a * v[0] + b * v[1] + d * v[3]), c * v[3])


# ---- A scene


@dataclass
class Line:
    """What is seen of a line, in shares of its projection. Where viewing may round a vertex of the
    picture across the line, `surely` and `maybe` are less and more than `seen`."""

    pick: int
    corner: int
    start: tuple  # x and y over the picture, after clipping
    end: tuple
    seen: list
    surely: list
    maybe: list

    def length(self, parts=None):
        parts = self.seen if parts is None else parts
        return math.dist(self.start, self.end) * (total(parts) / ONE)

    def pieces(self, parts=None):
        """Pairs of points."""
        parts = self.seen if parts is None else parts
        return [(self.at(a / ONE), self.at(b / ONE)) for a, b in parts]

    def at(self, share):
        if share == 1:
            return self.end
        return tuple(a + share * (b - a) for a, b in zip(self.start, self.end))


class Scene:
    def __init__(self, text):
        self.program, self.items = read(text)
        self.found = planes.find(self.program)
        self.worlds, self.scale = planes.world_polygons(self.program)
        self.doubtful = list(self.found.doubtful)
        self.looks = {n: Look(s, self.scale) for n, s in self.program.segments.items()}
        self.touches = {}
        self.planes_in_picture = {}
        self.shown = [s for s in map(self.show, range(len(self.items))) if s]
        self.hiders = [s for s in self.shown if s.solid and s.plane]

    def show(self, number):
        """The Shown of an item, or None."""
        polygon, world = self.program.polygons[number], self.worlds[number]
        look = self.looks[polygon.segment]
        if self.items[number].is_line:
            left = look.clipped_line(*(look.view_point(v) for v in world.points[:2]))
            if left is None:
                return None
            corners = list(map(look.picture_point, left))
            return Shown(number, look, world, None, None, corners, False)
        left = look.clipped_polygon([look.view_point(v) for v in world.points])
        if not left:
            return None
        if polygon.without_back:
            side, unsure = side_of_area(left)
            if unsure:
                self.doubtful.append(f"polygon {number} may be seen from behind")
            if side <= 0:
                return None
        plane_of, plane = self.plane_for(number, look)
        corners = list(map(look.picture_point, left))
        return Shown(number, look, world, plane_of, plane, corners, polygon.solid)

    def plane_for(self, number, look):
        """The plane that the polygon lies in, or its own if that is seen edge-on, or none."""
        for k in (self.found.founder[number], number):
            if k is None or not self.worlds[k].support:
                continue
            key = k, look.key
            if key not in self.planes_in_picture:
                self.planes_in_picture[key] = plane_in_picture(self.worlds[k].support, look)
            if self.planes_in_picture[key]:
                return self.worlds[k], self.planes_in_picture[key]
        return None, None

    def lines(self):
        """The Lines, in order of entry."""
        lines = map(self.line, self.groups().values())
        return [line for line in lines if line]

    def groups(self):
        """Of each line that may be drawn its sharers: (Shown, vertex it starts at, corner)."""
        groups = {}
        for shown in self.shown:
            polygon = self.program.polygons[shown.number]
            if self.items[shown.number].is_line:
                groups[shown.number] = [(shown, 0, 1)]
                continue
            for k, point in enumerate(polygon.points):
                ends = frozenset((tuple(polygon.points[k - 1]), tuple(point)))
                key = shown.look.key, polygon.matrix, ends
                groups.setdefault(key, []).append((shown, (k or len(polygon.points)) - 1, k))
        return groups

    def line(self, sharers):
        """The Line, or None where nothing is drawn."""
        if not any(self.items[shown.number].is_drawn for shown, _, _ in sharers):
            return None
        shown, a, b = sharers[0]
        look = shown.look
        left = look.clipped_line(*(look.view_point(shown.world.points[k]) for k in (a, b)))
        if left is None:
            return None
        p, q = map(look.picture_point, left)
        if not any(line_of(p, q)):
            return None
        hidden = None
        for sharer, a, b in sharers:
            stretch = Stretch(p, q, sharer.plane)
            if not stretch.length:
                return None
            ends = [sharer.world.points[k] for k in (a, b)]
            now = self.hidden_parts(sharer, ends, stretch)
            hidden = now if hidden is None else [both(*pair) for pair in zip(hidden, now)]
        least = both(both(hidden[0], hidden[1]), hidden[2])
        most = union(hidden[0] + hidden[1] + hidden[2])
        seen, surely, maybe = (without(ALL, parts) for parts in (hidden[0], most, least))
        pick = self.items[shown.number].pick
        return Line(pick, sharers[0][2], *stretch.ends, seen, surely, maybe)

    def hidden_parts(self, sharer, ends, stretch):
        """What is hidden, as it is, and with all vertices that may be on either side of it left of
        the line, and right of it."""
        left, right = [[], [], []], [[], [], []]
        for hider in self.hiders:
            if not boxes_meet(hider.box, stretch.box):
                continue
            behind = self.behind(sharer, ends, stretch, hider)
            if not behind:
                continue
            sides, close = stretch.sides(hider)
            for k, moved in enumerate((0, 1, -1)):
                if k and not any(close):
                    left[k] += left_parts
                    right[k] += right_parts
                    continue
                now = [moved or s if c else s for s, c in zip(sides, close)]
                left_parts = both(stretch.covered(hider, now, True), behind)
                right_parts = both(stretch.covered(hider, now, False), behind)
                left[k] += left_parts
                right[k] += right_parts
        return [both(union(a), union(b)) for a, b in zip(left, right)]

    def behind(self, sharer, ends, stretch, hider):
        """Where the line is behind a polygon's plane."""
        if sharer.look.key != hider.look.key:
            return stretch.behind(hider.plane)
        founder = self.found.founder
        if founder[sharer.number] == founder[hider.number]:
            return []
        touch = [self.touch(v, sharer.world, hider.plane_of) for v in ends]
        if all(touch):
            return []
        if not any(touch):
            return stretch.behind(hider.plane)
        look = sharer.look
        other = look.picture_point(look.view_point(ends[touch.index(False)]))
        if sharer.plane is not None:
            other = at_depth(other, sharer.plane)
        return ALL if value(hider.plane, other) < 0 else []

    def touch(self, v, world, plane):
        """Whether a vertex of a polygon is within reach of a plane."""
        key = v, world.reach, id(plane)
        if key not in self.touches:
            self.touches[key] = self.is_within_reach(v, world, plane)
        return self.touches[key]

    def is_within_reach(self, v, world, plane):
        normal, distance = plane.near
        x = [a / self.scale for a in v]
        size = 1.0 + abs(distance) + max(map(abs, x))
        far = (1e-9 + 4 * math.sqrt(max(world.reach, plane.reach))) * size
        if abs(planes.dot(normal, x) - distance) > far:
            return False
        off = planes.dot(plane.normal, planes.minus(v, plane.support[0])) ** 2
        over = planes.dot(plane.normal, plane.normal) * self.scale**2
        reach = max(world.reach, plane.reach)
        if reach == 0:
            return off == 0
        ratio = Fraction(off, over) / reach
        if planes.is_doubtful(ratio, world, plane):
            self.doubtful.append("an end may touch a plane")
        return ratio <= 1


def boxes_meet(a, b, margin=1e-6):
    return (
        a[0] <= b[1] + margin
        and b[0] <= a[1] + margin
        and a[2] <= b[3] + margin
        and b[2] <= a[3] + margin
    )


def visible_lines(text):
    """The Lines of a drawing program's text, and what is doubtful about it."""
    scene = Scene(text)
    lines = scene.lines()
    return lines, scene.doubtful


# ---- Lines held against others


def is_on(points, line, near):
    """Whether two points are on a line through two others, but for rounding."""
    (x, y), (c, d) = line
    length = math.hypot(c - x, d - y)
    if not length:
        return False
    return all(abs((c - x) * (b - y) - (d - y) * (a - x)) <= near * length for a, b in points)


def left_of(piece, others, near):
    """What pieces that lie on the same line leave of a piece, longer than `near`: pieces."""
    (x, y), (c, d) = piece
    length = math.hypot(c - x, d - y)
    if length <= near:
        return []
    dx, dy = (c - x) / length, (d - y) / length
    parts = []
    low, high = min(x, c) - near, max(x, c) + near
    for other in others:
        (a, b), (e, f) = other
        if max(a, e) < low or min(a, e) > high:
            continue
        if is_on(other, piece, near) or is_on(piece, other, near):
            places = [(p - x) * dx + (q - y) * dy for p, q in other]
            parts.append((min(places), max(places)))
    left = without([(0.0, length)], union(parts))
    return [((x + p * dx, y + p * dy), (x + q * dx, y + q * dy)) for p, q in left if q - p > near]


def length_without(pieces, others, near=1e-9):
    """How long the parts of pieces are that others do not cover, each place of a line counted
    once."""
    counted = []
    for piece in pieces:
        for part in left_of(piece, others, near):
            counted += left_of(part, list(counted), near)
    return sum(math.dist(*piece) for piece in counted), counted


def main():
    parser = argparse.ArgumentParser(
        description="The visible lines of a drawing program, by the definition."
    )
    parser.add_argument("program")
    options = parser.parse_args()
    with open(options.program, encoding="utf-8") as file:
        try:
            lines, doubtful = visible_lines(file.read())
        except (program_reader.Refused, ValueError) as error:
            sys.exit(f"{options.program}: {error}")
    for line in lines:
        for (a, b), (c, d) in line.pieces():
            print(f"pick {line.pick}  {a!r} {b!r}  {c!r} {d!r}")
    seen = sum(line.length() for line in lines)
    undecided = sum(line.length(line.maybe) - line.length(line.surely) for line in lines)
    print(f"length {seen:.12f}, undecided {undecided:.12f}, doubtful {len(doubtful)}")


if __name__ == "__main__":
    main()
