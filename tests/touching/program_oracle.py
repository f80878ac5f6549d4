#!/usr/bin/python3
"""The item buffer of a drawing program by the definition, from the program's text alone.

    tests/touching/program_oracle.py PROGRAM.draw [--size WxH] [--ids IDS.npy]

README.md says how. Prints how many pixels show each polygon, and how many are undecided.
"""
import argparse
import sys

sys.dont_write_bytecode = True
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

import exact_view
import planes
import program_reader

BITS = 240  # binary places of a view's numbers
BOUND = Fraction(
    1, 10**9
)  # in pixels: nearer to a side, or to where two planes meet, is undecided
CLOSE = 1e-8  # in pixels: nearer than this doubles are not relied on
DEPTH_BOUND = Fraction(
    1, 10**13
)  # of the range of z, between planes under two matrices or in two views
STEEP = 1e11  # ranges of z a pixel: as good as edge-on
EYE = 20  # what is nearer the eye than 2^-EYE of the view plane's distance is cut away
BOX = 4096  # in pixels: polygons that go farther beyond the picture are cut


@dataclass
class Answer:
    ids: np.ndarray  # (height, width), top row first; -1 for the background
    undecided: np.ndarray  # where the numbers of a view may decide
    doubtful: list  # pairs of polygons that may lie in one plane or not


class Look:
    """A view and an image transformation: world points to pixels, in whole numbers."""

    def __init__(self, view, image, width, height, scale):
        rows = exact_view.to_pixels(view, image, width, height)
        self.rows = [[int(Fraction(x) * 2**BITS) for x in row] for row in rows]
        self.view = view
        self.scale = scale
        # What has equal numbers, whether it clips or not, is compared by the planes as entered.
        unclipped = replace(view, front_clipping=False, back_clipping=False)
        self.key = unclipped, exact_view.image_numbers(image)
        self.nearest_w = (scale << BITS) >> EYE
        self.window = None
        self.near_eye = exact_view.depth_at(view, 2.0 ** (2 - EYE)) if view.perspective else None
        frame = exact_view.picture_rows(view, image, width, height)
        self.mirrored = frame[0][0] * frame[1][1] < frame[0][1] * frame[1][0]
        if view.viewport != (0.0, 1.0, 0.0, 1.0) or image != program_reader.Image():
            x0, x1, y0, y1 = view.window
            corners = [(x0, y0, 0, 1), (x1, y0, 0, 1), (x1, y1, 0, 1), (x0, y1, 0, 1)]
            whole = [[int(Fraction(x) * 2**BITS) for x in row] for row in frame]
            self.window = [
                tuple(int(sum(a * Fraction(b) for a, b in zip(row, c))) for row in whole)
                for c in corners
            ]

    def view_point(self, p):
        return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] * self.scale for r in self.rows)


# ---- Polygons in the picture


def cut(polygon, inside):
    """What is left of a polygon where a linear function of its vertices is not negative."""
    left = []
    for k, b in enumerate(polygon):
        a = polygon[k - 1]
        at_a, at_b = inside(a), inside(b)
        if (at_a < 0) != (at_b < 0):
            left.append(tuple(x * abs(at_b) + y * abs(at_a) for x, y in zip(a, b)))
        if at_b >= 0:
            left.append(b)
    return left


def in_pixels(vertices, look, width, height):
    """The polygon's homogeneous x and y, after what is behind the eye, before the front plane,
    behind the back plane or far outside of the picture is cut away."""
    if any(v[3] < look.nearest_w for v in vertices):
        vertices = cut(vertices, lambda v: v[3] - look.nearest_w)
    if look.view.front_clipping:
        vertices = cut(vertices, lambda v: v[3] - v[2])
    if look.view.back_clipping:
        vertices = cut(vertices, lambda v: v[2])
    if any(abs(v[k]) > BOX * v[3] for v in vertices for k in (0, 1)):
        for k, size in ((0, width), (1, height)):
            vertices = cut(vertices, lambda v: v[k] + BOX * v[3])
            vertices = cut(vertices, lambda v: (BOX + size) * v[3] - v[k])
    return [(v[0], v[1], v[3]) for v in vertices]


def squared_distance(x, y, a, b):
    """Of a point from a side, in rationals."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    t = ((x - a[0]) * dx + (y - a[1]) * dy) / length if length else Fraction(0)
    t = min(max(t, 0), 1)
    return (x - a[0] - t * dx) ** 2 + (y - a[1] - t * dy) ** 2


def covers(corners, x, y):
    """Even-odd, by sides with min y < y <= max y that cross at or left of x. In rationals."""
    odd = False
    for k, b in enumerate(corners):
        a = corners[k - 1]
        if a[1] > b[1]:
            a, b = b, a
        if a[1] < y <= b[1]:
            odd ^= (b[0] - a[0]) * (y - a[1]) <= (b[1] - a[1]) * (x - a[0])
    return odd


def coverage(polygon, width, height):
    """Which centres a polygon covers, and which are too near to its outline: two arrays, bottom row
    first. Doubles where a centre is safely off each side's line, else rationals."""
    empty = np.zeros((height, width), bool)
    if len(polygon) < 3:
        return empty, empty
    x, y = (np.array([v[k] / v[2] for v in polygon]) for k in (0, 1))
    if x.max() < -1 or y.max() < -1 or x.min() > width + 1 or y.min() > height + 1:
        return empty, empty
    up = y >= np.roll(y, 1)
    ax, ay = np.where(up, np.roll(x, 1), x), np.where(up, np.roll(y, 1), y)
    bx, by = np.where(up, x, np.roll(x, 1)), np.where(up, y, np.roll(y, 1))
    length = np.hypot(bx - ax, by - ay)
    point = length == 0  # also an end of the sides beside it
    length[point] = 1
    nx, ny = (by - ay) / length, -(bx - ax) / length
    cx, cy = np.arange(width) + 0.5, np.arange(height) + 0.5
    right = (
        nx[:, None, None] * (cx[None, None, :] - ax[:, None, None])
        + (ny[:, None] * (cy[None, :] - ay[:, None]))[:, :, None]
    )
    rows = (ay[:, None] < cy[None, :]) & (cy[None, :] <= by[:, None])
    covered = np.logical_xor.reduce(rows[:, :, None] & (right >= 0), axis=0)
    undecided = empty.copy()
    close = np.argwhere((np.abs(right[~point]) < CLOSE).any(axis=0))
    if len(close):
        corners = [(Fraction(v[0], v[2]), Fraction(v[1], v[2])) for v in polygon]
        for j, i in close:
            at = Fraction(2 * int(i) + 1, 2), Fraction(2 * int(j) + 1, 2)
            covered[j, i] = covers(corners, *at)
            undecided[j, i] = any(
                squared_distance(*at, corners[k - 1], corners[k]) <= BOUND**2
                for k in range(len(corners))
            )
    return covered, undecided


def signed_area(polygon):
    x, y = (np.array([v[k] / v[2] for v in polygon]) for k in (0, 1))
    return float(np.sum(np.roll(x, 1) * y - x * np.roll(y, 1))) / 2


# ---- Depth


class DepthPlane:
    """a x + b y + c z + d = 0 in whole numbers; z = A x + B y + C in doubles; x, y in pixels."""

    def __init__(self, a, b, c, d, origin):
        self.whole = a, b, c, d
        self.origin = origin  # planes of one origin are rounded alike
        self.edge_on = c == 0
        if not self.edge_on:
            self.doubles = [-n / c if abs(n) < abs(c) << 60 else 1e300 for n in (a, b, d)]
            self.edge_on = abs(self.doubles[0]) > STEEP or abs(self.doubles[1]) > STEEP

    @staticmethod
    def through(points, origin):
        (a, b, c, d), (e, f, g, h), (i, j, k, l) = points
        return DepthPlane(
            minor(b, c, d, f, g, h, j, k, l),
            -minor(a, c, d, e, g, h, i, k, l),
            minor(a, b, d, e, f, h, i, j, l),
            -minor(a, b, c, e, f, g, i, j, k),
            origin,
        )


def minor(a, b, c, d, e, f, g, h, i):
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def nearer(p, q, i, j):
    """Whether p is nearer than q at a centre, and whether that is undecided. In whole numbers."""
    a, b, c, d = p.whole
    e, f, g, h = q.whole
    x, y, rest = e * c - a * g, f * c - b * g, h * c - d * g
    twice = x * (2 * i + 1) + y * (2 * j + 1) + 2 * rest  # (z of p less z of q) times 2 c g
    slack = BOUND * (abs(x) + abs(y))
    if p.origin != q.origin:
        slack += DEPTH_BOUND * abs(c * g)
    return (twice > 0) == (c * g > 0) and twice != 0, abs(twice) <= 2 * slack


class Painter:
    """What is seen at each centre, polygon by polygon in order of entry."""

    def __init__(self, width, height):
        self.seen = np.full((height, width), -1, np.int32)  # row of `planes`
        self.undecided = np.zeros((height, width), bool)
        self.planes = []
        self.keys = []  # of one plane in one view

    def paint(self, plane, key, covered, doubt, near_eye):
        """Enters a polygon. Nearer than `near_eye` what the eye's clipping cuts could be seen."""
        self.planes.append(plane)
        self.keys.append(key)
        j, i = np.nonzero(covered | doubt)
        unsure = doubt[j, i]
        if near_eye is not None:
            a, b, c = plane.doubles
            unsure = unsure | (a * (i + 0.5) + b * (j + 0.5) + c > near_eye)
        in_front, close = self.compare_with_seen(plane, key, self.seen[j, i], i, j)
        self.undecided[j, i] |= close | (unsure & in_front)
        wins = in_front & covered[j, i]
        self.seen[j[wins], i[wins]] = len(self.planes) - 1

    def compare_with_seen(self, plane, key, before, i, j):
        in_front, close = np.ones(len(i), bool), np.zeros(len(i), bool)
        same = np.array([k == key for k in self.keys[:-1]] + [True])  # -1 is the background
        others = np.nonzero(~same[before])[0]
        in_front[others], close[others] = self.compare(plane, before[others], i[others], j[others])
        return in_front, close

    def compare(self, plane, others, i, j):
        """Whether it is nearer than others of self.planes, by centre; and what is undecided."""
        if len(i) == 0:
            return np.zeros(0, bool), np.zeros(0, bool)
        table = np.array([p.doubles for p in self.planes])
        a, b, c = (table[others, k] for k in range(3))
        pa, pb, pc = plane.doubles
        x, y = i + 0.5, j + 0.5
        difference = (pa * x + pb * y + pc) - (a * x + b * y + c)
        rounding = (
            abs(pa) * x + abs(pb) * y + abs(pc) + np.abs(a) * x + np.abs(b) * y + np.abs(c)
        ) * 2.0**-49
        margin = rounding + CLOSE * (np.abs(pa - a) + np.abs(pb - b)) + 1e-12
        in_front, close = difference > 0, np.zeros(len(i), bool)
        for k in np.nonzero(np.abs(difference) <= margin)[0]:
            in_front[k], close[k] = nearer(plane, self.planes[others[k]], int(i[k]), int(j[k]))
        return in_front, close


# ---- A program


def looks_of(program, width, height, scale):
    """Of each segment its Look."""
    return {
        name: Look(s.view, s.image, width, height, scale) for name, s in program.segments.items()
    }


def item_buffer(text, width, height):
    """The Answer for a drawing program's text."""
    program = program_reader.read(text)
    if width != height and not program.shape_was_set:
        raise program_reader.Refused("without a window of its own a picture is square here")
    found = planes.find(program)
    looks = looks_of(program, width, height, found.scale)
    windows = {
        id(k): coverage([(v[0], v[1], v[3]) for v in k.window], width, height)
        for k in looks.values()
        if k.window
    }
    in_picture = {}
    painter = Painter(width, height)
    picks = []
    for number, polygon in enumerate(program.polygons):
        if found.points[number] is None or not polygon.solid:
            continue
        look = looks[polygon.segment]
        corners = in_pixels([look.view_point(v) for v in found.world[number]], look, width, height)
        covered, doubt = coverage(corners, width, height)
        if id(look) in windows:
            inside, near = windows[id(look)]
            doubt = (doubt & (inside | near)) | (covered & near)
            covered = covered & inside
        if not (covered | doubt).any():
            continue
        if polygon.without_back:
            area = signed_area(corners)
            if abs(area) < 1e-6:
                painter.undecided |= covered | doubt
            if (area < 0) != look.mirrored:
                continue
        key = found.founder[number], look.key
        if key not in in_picture:
            origin = program.polygons[key[0]].matrix, look.key
            points = [look.view_point(v) for v in found.points[number]]
            in_picture[key] = DepthPlane.through(points, origin)
        plane = in_picture[key]
        if plane.edge_on:
            painter.undecided |= covered | doubt
            continue
        painter.paint(plane, key, covered, doubt, look.near_eye)
        picks.append(number)
    ids = np.array(picks + [-1], np.int32)[painter.seen]
    return Answer(ids[::-1], painter.undecided[::-1], found.doubtful)


def main():
    parser = argparse.ArgumentParser(
        description="The item buffer of a drawing program, by the definition."
    )
    parser.add_argument("program")
    parser.add_argument("--size", default="64x64", metavar="WxH")
    parser.add_argument("--ids", metavar="IDS.npy")
    options = parser.parse_args()
    width, height = map(int, options.size.split("x"))
    with open(options.program, encoding="utf-8") as file:
        try:
            answer = item_buffer(file.read(), width, height)
        except (program_reader.Refused, ValueError) as error:
            sys.exit(f"{options.program}: {error}")
    for pick, pixels in zip(*np.unique(answer.ids, return_counts=True)):
        print(f"{pick:4} {pixels}")
    print(f"undecided: {answer.undecided.sum()} pixels, {len(answer.doubtful)} pairs of polygons")
    if options.ids:
        np.save(options.ids, answer.ids)


if __name__ == "__main__":
    main()
