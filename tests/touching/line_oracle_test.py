#!/usr/bin/python3
"""Tests of line_oracle.py by scenes whose visible lines are known by hand.

Lengths are in world units: by default view-plane coordinates are world coordinates, z grows toward
the viewer, and the window is -1 to 1, so that the picture is two units wide.
"""
import math
import random
import sys
import unittest
from fractions import Fraction

sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401, what the oracle needs
except ImportError:
    print("python3-numpy is not installed")
    sys.exit(77)

import line_oracle
import planes
import program_oracle
import program_reader
import touching_scenes

LINES, NO_LINES = "set-line-style solid 0 0 0", "set-line-style none"
OBLIQUE = "set-parallel 0.5 0.5 1"  # (x, y, z) is seen at (x - z / 2, y - z / 2)


def rectangle(left, right, low, high, z):
    return (
        f"polygon-abs-3 {left} {low} {z}  {right} {low} {z}  {right} {high} {z}  {left} {high} {z}"
    )


def line(*numbers):
    return "move-abs-3 {} {} {}\nline-abs-3 {} {} {}".format(*numbers)


def box(low, high):
    (x, y, z), (a, b, c) = low, high
    faces = (
        ((x, y, z), (x, b, z), (a, b, z), (a, y, z)),
        ((x, y, c), (a, y, c), (a, b, c), (x, b, c)),
        ((x, y, z), (a, y, z), (a, y, c), (x, y, c)),
        ((x, b, z), (x, b, c), (a, b, c), (a, b, z)),
        ((x, y, z), (x, y, c), (x, b, c), (x, b, z)),
        ((a, y, z), (a, b, z), (a, b, c), (a, y, c)),
    )
    return [f"polygon-abs-3 {' '.join(str(n) for p in f for n in p)}" for f in faces]


def lines_of(*routines, before=(), after=()):
    text = ["set-window -1 1 -1 1", *before, "open-segment 1", *routines, "close-segment", *after]
    lines, doubtful = line_oracle.visible_lines("\n".join(text))
    assert not doubtful
    return lines


def pieces_of(*routines, before=(), after=()):
    """In the coordinates of the window -1 to 1."""
    return [
        tuple(2 * x - 1 for end in piece for x in end)
        for found in lines_of(*routines, before=before, after=after)
        for piece in found.pieces()
    ]


def length_of(*routines, before=(), after=()):
    return 2 * sum(found.length() for found in lines_of(*routines, before=before, after=after))


WALL = [NO_LINES, rectangle(-1, 1, -1, 1, 0), LINES]


class Seen(unittest.TestCase):
    def assert_pieces(self, pieces, *expected):
        self.assertEqual(len(pieces), len(expected), pieces)
        for piece, other in zip(pieces, expected):
            for a, b in zip(piece, other):
                self.assertAlmostEqual(a, b, delta=1e-12)


class Hiding(Seen):
    def test_half_behind_a_rectangle(self):
        hider = [NO_LINES, rectangle(0, 0.5, -0.5, 0.5, 1), LINES]
        self.assert_pieces(
            pieces_of(*hider, line(-1, 0, 0, 1, 0, 0)), (-1, 0, 0, 0), (0.5, 0, 1, 0)
        )

    def test_a_line_that_passes_through(self):
        self.assert_pieces(pieces_of(*WALL, line(-0.5, 0, 0.5, 0.5, 0, -0.5)), (-0.5, 0, 0, 0))
        self.assert_pieces(pieces_of(*WALL, line(-0.5, 0, -0.25, 0.5, 0, 0.75)), (-0.25, 0, 0.5, 0))

    def test_on_the_outline_of_what_lies_before_it(self):
        hider = [NO_LINES, rectangle(0, 1, -1, 1, 1), LINES]
        self.assert_pieces(pieces_of(*hider, line(0, -0.5, 0, 0, 0.5, 0)), (0, -0.5, 0, 0.5))
        self.assert_pieces(pieces_of(*hider, line("1e-300", -0.5, 0, "1e-300", 0.5, 0)))

    def test_right_behind_a_side_that_two_share(self):
        pair = [NO_LINES, rectangle(-1, 0, -1, 1, 1), rectangle(0, 1, -1, 1, 1), LINES]
        self.assert_pieces(pieces_of(*pair, line(0, -0.5, 0, 0, 0.5, 0)))
        steps = [NO_LINES, rectangle(-1, 0, -1, 0.25, 1), rectangle(0, 1, -0.25, 1, 2), LINES]
        self.assert_pieces(
            pieces_of(*steps, line(0, -0.5, 0, 0, 0.5, 0)), (0, -0.5, 0, -0.25), (0, 0.25, 0, 0.5)
        )

    def test_even_odd(self):
        outer = "-1 -1 1  1 -1 1  1 1 1  -1 1 1  -1 -1 1"
        inner = "-0.5 -0.5 1  0.5 -0.5 1  0.5 0.5 1  -0.5 0.5 1  -0.5 -0.5 1"
        frame = [NO_LINES, f"polygon-abs-3 {outer}  {inner}", LINES]
        self.assert_pieces(pieces_of(*frame, line(-1, 0.1, 0, 1, 0.1, 0)), (-0.5, 0.1, 0.5, 0.1))

    def test_hollow_polygons_hide_nothing_and_have_sides(self):
        hollow = ["set-fill-style hollow", rectangle(-0.5, 0.5, -0.5, 0.5, 0.5)]
        solid = ["set-fill-style solid 1 1 1", rectangle(-0.25, 0.25, -0.25, 0.25, 0)]
        self.assertAlmostEqual(length_of(*hollow, *solid), 4 + 2)
        self.assertAlmostEqual(length_of(*hollow[1:], *solid), 4)

    def test_sides_that_two_share_are_one_line(self):
        pair = [rectangle(-1, 0, -0.5, 0.5, 0), rectangle(0, 0.5, -0.5, 0.5, 0)]
        self.assertEqual(len(lines_of(*pair)), 7)
        self.assertAlmostEqual(length_of(*pair), 4 + 3 - 1)

    def test_in_perspective(self):
        before = ["set-perspective 0 0 2"]
        hider = [NO_LINES, rectangle(-0.25, 0.25, -0.25, 0.25, 0), LINES]
        self.assert_pieces(
            pieces_of(*hider, line(-1, 0, -2, 1, 0, -2), before=before),
            (-0.5, 0, -0.25, 0),
            (0.25, 0, 0.5, 0),
        )
        # It goes through z = 0 in the middle of its length, and is seen from there on.
        wide = [NO_LINES, rectangle(-9, 9, -9, 9, 0), LINES]
        self.assert_pieces(pieces_of(*wide, line(-1, 0, -1, 1, 0, 1), before=before), (0, 0, 1, 0))


class Touching(Seen):
    def test_a_box_on_a_floor_has_nine_whole_edges(self):
        edges = 3 * 0.5 + 3 * 0.5 + 3 * 0.5 * math.sqrt(0.5)
        floor = "polygon-abs-3 -8 0 -8  -8 0 8  8 0 8  8 0 -8"
        stands = box((0, 0, 0), (0.5, 0.5, 0.5))
        self.assertAlmostEqual(length_of(floor, *stands, before=[OBLIQUE]), edges)
        self.assertAlmostEqual(length_of(*stands, floor, before=[OBLIQUE]), edges)
        sinks = box((0, -0.25, 0), (0.5, 0.25, 0.5))  # of which half is below the floor
        # Three uprights are half as long, and two lower edges are below the floor.
        self.assertAlmostEqual(
            length_of(floor, *sinks, before=[OBLIQUE]),
            edges - 3 * 0.25 - 0.5 - 0.5 * math.sqrt(0.5),
        )

    def test_a_box_on_a_floor_in_decimals_that_is_turned(self):
        turned = ["rotate-x-3 10", "rotate-y-3 -20", "rotate-z-3 30", "translate-3 0.1 0.2 0.3"]
        floor = "polygon-abs-3 -8 -0.3 -8  -8 -0.3 8  8 -0.3 8  8 -0.3 -8"
        stands = box((0.1, -0.3, 0.1), (0.3, 0.1, 0.4))
        lines = lines_of(NO_LINES, floor, LINES, *stands, before=[OBLIQUE, *turned])
        self.assertEqual(sum(f.length() > 0.01 for f in lines), 9)
        for found in lines:
            if found.length() > 0:
                self.assertEqual(found.seen, line_oracle.ALL)

    def test_a_line_in_a_face(self):
        across = (-0.5, -0.5, 0.5, 0.5)
        self.assert_pieces(pieces_of(*WALL, line(-0.5, -0.5, 0, 0.5, 0.5, 0)), across)
        # The largest coordinate is 1: the reach is 2^-49, about 1.8e-15.
        near, far = "-1.7e-15", "-1.8e-15"
        self.assert_pieces(pieces_of(*WALL, line(-0.5, -0.5, near, 0.5, 0.5, near)), across)
        self.assert_pieces(pieces_of(*WALL, line(-0.5, -0.5, far, 0.5, 0.5, far)))

    def test_the_coordinates_of_lines_count_for_the_reach(self):
        far = line(-0.5, -0.5, "-2.8e-14", 16, 16, "-2.8e-14")
        self.assert_pieces(pieces_of(*WALL, far), (-0.5, -0.5, 1, 1))
        farther = line(-0.5, -0.5, "-2.9e-14", 16, 16, "-2.9e-14")
        self.assert_pieces(pieces_of(*WALL, farther))

    def test_the_outline_of_a_rug_on_a_floor(self):
        rug = rectangle(-0.5, 0.5, -0.5, 0.5, 0)
        self.assertAlmostEqual(length_of(*WALL, rug), 4)
        self.assertAlmostEqual(length_of(rug, NO_LINES, rectangle(-1, 1, -1, 1, 0)), 4)
        below = rectangle(-0.5, 0.5, -0.5, 0.5, "-1.8e-15")
        self.assertAlmostEqual(length_of(*WALL, below), 0)

    def test_one_end_within_reach(self):
        before = ["set-touching 0.01"]

        def seen(*numbers):
            return pieces_of(*WALL, line(*numbers), before=before)

        whole = (-0.5, 0, 0.5, 0)
        self.assert_pieces(seen(-0.5, 0, -0.009, 0.5, 0, 0.5), whole)
        self.assert_pieces(seen(-0.5, 0, 0.009, 0.5, 0, -0.5))
        self.assert_pieces(seen(-0.5, 0, -0.5, 0.5, 0, 0.009))
        crossing = -0.5 + 0.011 / 0.511
        self.assert_pieces(seen(-0.5, 0, -0.011, 0.5, 0, 0.5), (crossing, 0, 0.5, 0))
        self.assert_pieces(seen(-0.5, 0, 0.011, 0.5, 0, -0.5), (-0.5, 0, crossing, 0))

    def test_a_side_has_the_depth_of_the_plane_that_its_polygon_lies_in(self):
        before = ["set-touching 0.01"]
        sunk = rectangle(-0.5, 0.5, -0.5, 0.5, -0.008)
        self.assertAlmostEqual(length_of(*WALL, sunk, before=before), 4)
        # It comes before the wall's plane at x = 0.0004; before the sides as entered it all is.
        steep = "polygon-abs-3 0 -1 -0.004  1 -1 9.996  1 1 9.996  0 1 -0.004"  # z = 10 x - 0.004
        self.assertAlmostEqual(
            length_of(*WALL, sunk, NO_LINES, steep, before=before), 1 + 2 * 0.5004
        )

    def test_touching_off(self):
        before = ["set-touching off"]
        self.assert_pieces(
            pieces_of(*WALL, line(-0.5, 0, "-1e-300", 0.5, 0, "-1e-300"), before=before)
        )
        self.assert_pieces(
            pieces_of(*WALL, line(-0.5, 0, 0, 0.5, 0, 0), before=before), (-0.5, 0, 0.5, 0)
        )


class Views(Seen):
    def test_no_line_is_drawn_where_the_window_cuts(self):
        # Of two sides a half is left, one side is whole, and the fourth is beyond the window.
        self.assertAlmostEqual(length_of(rectangle(0.5, 1.5, -0.5, 0.5, 0)), 0.5 + 0.5 + 1)

    def test_no_line_is_drawn_where_front_and_back_planes_cut(self):
        before = [
            "set-view-depth -0.5 0.25",
            "set-front-plane-clipping on",
            "set-back-plane-clipping on",
        ]
        slope = "polygon-abs-3 -1 -0.5 -1  1 -0.5 1  1 0.5 1  -1 0.5 -1"  # z = x
        self.assertAlmostEqual(length_of(slope, before=before), 2 * 0.75)

    def test_back_faces_go_with_their_sides(self):
        front = "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0 0.5 0"
        back = "polygon-abs-3 -0.5 -0.5 0  0 0.5 0  0.5 -0.5 0"
        self.assertEqual(len(lines_of(front, before=["set-back-face-removal on"])), 3)
        self.assertEqual(len(lines_of(back, before=["set-hidden-line-removal on"])), 0)
        self.assertEqual(len(lines_of(back)), 3)

    def test_sides_of_an_edge_on_polygon_have_the_depth_of_their_ends(self):
        before = ["set-parallel 0 0.5 1"]  # (x, y, z) is seen at (x, y - z / 2)
        edge_on = "polygon-abs-3 0 -0.5 -1  0 -0.5 1  0 0.5 1  0 0.5 -1"
        # Each is 1 long in the picture. That at z = 1 is seen, that at z = -1 is not, and of the
        # others the half before the wall.
        lines = lines_of(*WALL, edge_on, before=before)
        self.assertEqual(len(lines), 4)
        lengths = sorted(2 * found.length() for found in lines)
        for length, expected in zip(lengths, (0, 0.5, 0.5, 1)):
            self.assertAlmostEqual(length, expected)

    def test_an_image_transformation_and_a_viewport(self):
        before, after = ["set-viewport 0 0.5 0 0.5"], ["set-image-translation 1 0.25 0"]
        hider = [NO_LINES, rectangle(0, 0.5, -0.5, 0.5, 1), LINES]
        found = lines_of(*hider, line(-1, 0, 0, 1, 0, 0), before=before, after=after)
        pieces = [tuple(x for end in p for x in end) for p in found[0].pieces()]
        self.assert_pieces(pieces, (0.25, 0.25, 0.5, 0.25), (0.625, 0.25, 0.75, 0.25))

    def test_segments_hide_each_other(self):
        second = ["close-segment", "open-segment 2", line(-1, 0, 0, 1, 0, 0)]
        hider = [NO_LINES, rectangle(0, 1, -0.5, 0.5, 1), LINES]
        self.assert_pieces(pieces_of(*hider, *second), (-1, 0, 0, 0))

    def test_what_is_on_a_line_but_for_rounding_is_undecided(self):
        hider = [NO_LINES, rectangle("1e-13", 1, -0.25, 0.25, 1), LINES]
        found = lines_of(*hider, line(0, -0.5, 0, 0, 0.5, 0))[0]
        self.assertAlmostEqual(2 * found.length(), 1)
        self.assertAlmostEqual(2 * found.length(found.maybe), 1)
        self.assertAlmostEqual(2 * found.length(found.surely), 0.5)

    def test_what_is_not_known_is_refused(self):
        for routine in ("set-line-style dashed 0 0 0", "set-lines crease", "line-abs-3 0 0"):
            with self.assertRaises(program_reader.Refused):
                lines_of(routine)


BESIDE = Fraction(1, 2**400)  # of a line's length: so far beside it points are judged


def mixed(p, q, share):
    """A point of the picture: x, y and z in rationals."""
    p, q = ([Fraction(v[k], v[3]) for k in range(3)] for v in (p, q))
    return [a + share * (b - a) for a, b in zip(p, q)]


class Naive(unittest.TestCase):
    """The definition a second time, at places taken at random: two points really beside the line,
    coverage by rows as for pixel centres, no parameters along the line, and no order of crossings.
    """

    def is_nearer(self, scene, hider, sharer, ends, point):
        """Whether the plane of a polygon is strictly nearer than the line."""
        if scene.found.founder[hider.number] == scene.found.founder[sharer.number]:
            return False
        touch = []
        for k in ends:
            away = planes.minus(sharer.world.points[k], hider.plane_of.support[0])
            off = planes.dot(hider.plane_of.normal, away) ** 2
            over = planes.dot(hider.plane_of.normal, hider.plane_of.normal) * scene.scale**2
            touch.append(Fraction(off, over) <= max(sharer.world.reach, hider.plane_of.reach))
        if all(touch):
            return False
        if any(touch):
            other = sharer.world.points[ends[touch.index(False)]]
            off = sharer.look.picture_point(sharer.look.view_point(other))
        else:
            off = (*point, 1)
        return line_oracle.value(hider.plane, off) < 0

    def is_seen(self, scene, sharer, ends, left, share):
        p, q = map(sharer.look.picture_point, left)
        x, y, z = mixed(p, q, share)
        if sharer.plane:
            a, b, c, d = sharer.plane
            z = -(a * x + b * y + d) / Fraction(c)
        along = [b - a for a, b in zip(mixed(p, q, 0), mixed(p, q, 1))]
        for side in (BESIDE, -BESIDE):
            at = x - side * along[1], y + side * along[0]
            for hider in scene.hiders:
                corners = [(Fraction(v[0], v[3]), Fraction(v[1], v[3])) for v in hider.corners]
                if program_oracle.covers(corners, *at) and self.is_nearer(
                    scene, hider, sharer, ends, (x, y, z)
                ):
                    break
            else:
                return True
        return False

    def judge(self, text, source, places):
        """How many places were judged, and how many of these are seen."""
        scene = line_oracle.Scene(text.replace(NO_LINES, LINES))
        judged = seen = 0
        for sharers in scene.groups().values():
            found = scene.line(sharers)
            if found is None or found.surely != found.maybe:
                continue
            shown, a, b = sharers[0]
            left = shown.look.clipped_line(
                *(shown.look.view_point(shown.world.points[k]) for k in (a, b))
            )
            for _ in range(places):
                place = source.getrandbits(line_oracle.PLACES)
                share = Fraction(place, line_oracle.ONE)
                expected = any(self.is_seen(scene, s, (i, j), left, share) for s, i, j in sharers)
                claimed = any(start < place < end for start, end in found.seen)
                self.assertEqual(claimed, expected, (found.pick, found.corner, float(share)))
                judged, seen = judged + 1, seen + expected
        return judged, seen

    def test_scenes_that_touch(self):
        source = random.Random(1)
        judged = seen = 0
        for kind in ("box-on-floor", "flush-boxes", "drawn-on-faces", "roof-windows"):
            for number in (0, 1):
                for modelled in (False, True):
                    text = touching_scenes.program(kind, number == 1, modelled, "test", number)
                    now = self.judge(text, source, 2)
                    judged, seen = judged + now[0], seen + now[1]
        self.assertGreater(judged, 500)
        self.assertGreater(seen, judged / 4)
        self.assertLess(seen, judged * 3 / 4)


class Comparison(unittest.TestCase):
    def test_pieces_on_one_line_count_together(self):
        whole, half = [((0.0, 0.0), (1.0, 1.0))], [((0.5, 0.5), (0.0, 0.0))]
        length, parts = line_oracle.length_without(whole, half)
        self.assertAlmostEqual(length, math.sqrt(0.5))
        self.assertEqual(len(parts), 1)
        self.assertEqual(line_oracle.length_without(half, whole), (0, []))
        rest = [((1.0, 1.0), (0.5, 0.5 + 1e-12))]
        self.assertEqual(line_oracle.length_without(whole, half + rest), (0, []))

    def test_a_place_counts_once(self):
        pieces = [((0.0, 0.0), (1.0, 0.0)), ((0.75, 0.0), (0.25, 0.0))]
        self.assertAlmostEqual(line_oracle.length_without(pieces, [])[0], 1)

    def test_lines_beside_it_cover_nothing(self):
        piece, beside = [((0.0, 0.0), (1.0, 0.0))], [((0.0, 0.0), (1.0, 1e-6))]
        self.assertAlmostEqual(line_oracle.length_without(piece, beside)[0], 1)


if __name__ == "__main__":
    unittest.main()
