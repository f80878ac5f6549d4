#!/usr/bin/python3
"""Tests of program_oracle.py by scenes whose answer is known by hand."""
import sys
import unittest

sys.dont_write_bytecode = True
try:
    import numpy as np
except ImportError:
    print("python3-numpy is not installed")
    sys.exit(77)

from decimal import Decimal

import exact_view
import planes
import program_oracle
import program_reader

# By default view-plane coordinates are world coordinates, and the window is -1 to 1.
SQUARE = "polygon-abs-3 -1 -1 0  1 -1 0  1 1 0  -1 1 0"
INNER = "polygon-abs-3 -0.5 -0.5 {0}  0.5 -0.5 {0}  0.5 0.5 {0}  -0.5 0.5 {0}"


def program(*lines, before=()):
    return "\n".join(
        [
            "set-window -1 1 -1 1",
            *before,
            "set-line-style none",
            "open-segment 1",
            *lines,
            "close-segment",
        ]
    )


def inner(z):
    return INNER.format(z)


def seen(*lines, before=(), size=4, after=()):
    answer = program_oracle.item_buffer(
        "\n".join([program(*lines, before=before), *after]), size, size
    )
    return answer.ids.tolist()


def picture(text):
    """Rows from the top, one character a pixel: . is the background."""
    return [[-1 if c == "." else int(c) for c in row] for row in text.split()]


WHOLE = picture("0000 0000 0000 0000")
MIDDLE = picture("0000 0110 0110 0000")
EMPTY = picture(".... .... .... ....")


class Coverage(unittest.TestCase):
    def test_a_quarter_of_the_picture(self):
        self.assertEqual(
            seen("polygon-abs-3 -1 -1 0  0 -1 0  0 0 0  -1 0 0"), picture(".... .... 00.. 00..")
        )

    def test_even_odd_where_a_polygon_crosses_itself(self):
        outer = "-1 -1 0  1 -1 0  1 1 0  -1 1 0  -1 -1 0"
        twice_around = f"{outer}  -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0  -0.5 -0.5 0"
        self.assertEqual(seen(f"polygon-abs-3 {twice_around}"), picture("0000 0..0 0..0 0000"))

    def test_a_centre_on_a_side_is_undecided_and_on_the_left_and_the_top_it_is_covered(self):
        text = program("polygon-abs-3 -0.75 -0.75 0  0.25 -0.75 0  0.25 0.25 0  -0.75 0.25 0")
        answer = program_oracle.item_buffer(text, 4, 4)
        self.assertEqual(answer.ids.tolist(), picture(".... 00.. 00.. ...."))
        self.assertEqual(
            answer.undecided.astype(int).tolist(),
            [[0, 0, 0, 0], [1, 1, 1, 0], [1, 0, 1, 0], [1, 1, 1, 0]],
        )

    def test_hollow_polygons_and_points_in_line_cover_nothing(self):
        self.assertEqual(seen("set-fill-style hollow", SQUARE), EMPTY)
        self.assertEqual(seen("polygon-abs-3 -1 -1 0  0 0 0  1 1 0"), EMPTY)

    def test_an_edge_on_plane_covers_nothing(self):
        self.assertEqual(seen("polygon-abs-3 -1 0.1 0  1 0.1 0  1 0.1 5  -1 0.1 5"), EMPTY)


class Depth(unittest.TestCase):
    def test_the_nearer_is_seen_whichever_was_entered_first(self):
        self.assertEqual(seen(SQUARE, inner(0.5)), picture("0000 0110 0110 0000"))
        self.assertEqual(seen(inner(0.5), SQUARE), picture("1111 1001 1001 1111"))
        self.assertEqual(seen(SQUARE, inner(-0.5)), WHOLE)

    def test_planes_that_cross(self):
        tilted = "polygon-abs-3 -1 -1 -1  1 -1 1  1 1 1  -1 1 -1"  # z = x
        self.assertEqual(seen(SQUARE, tilted), picture("0011 0011 0011 0011"))

    def test_where_planes_cross_at_a_centre_it_is_undecided(self):
        tilted = "polygon-abs-3 -1 -1 -0.75  1 -1 1.25  1 1 1.25  -1 1 -0.75"  # z = x + 1/4
        answer = program_oracle.item_buffer(program(SQUARE, tilted), 4, 4)
        self.assertEqual(answer.undecided.astype(int).tolist(), [[0, 1, 0, 0]] * 4)


class Touching(unittest.TestCase):
    def test_in_one_plane_the_one_entered_later_is_seen(self):
        self.assertEqual(seen(SQUARE, inner(0)), picture("0000 0110 0110 0000"))
        self.assertEqual(seen(inner(0), SQUARE), picture("1111 1111 1111 1111"))

    def test_within_reach_it_is_seen_though_it_is_behind(self):
        # The largest coordinate is 1: the reach is 2^-49, about 1.8e-15.
        self.assertEqual(seen(SQUARE, inner("-1.7e-15")), picture("0000 0110 0110 0000"))
        self.assertEqual(seen(SQUARE, inner("-1.8e-15")), WHOLE)
        self.assertEqual(seen(inner("1.7e-15"), SQUARE), picture("1111 1111 1111 1111"))
        self.assertEqual(seen(inner("1.8e-15"), SQUARE), picture("1111 1001 1001 1111"))

    def test_the_largest_coordinate_and_the_longest_column_make_the_reach(self):
        far = "polygon-abs-3 0 0 -16  1 0 -16  0 1 -16"
        self.assertEqual(seen(SQUARE, inner("-2.8e-14"), far), picture("0000 0110 0110 0000"))
        self.assertEqual(seen(SQUARE, inner("-2.9e-14"), far), WHOLE)
        squeezed = ["scale-3 1 1 0.0625"]  # columns x and y keep their length, z is a sixteenth
        self.assertEqual(
            seen(SQUARE, inner("-2.8e-14"), before=squeezed), picture("0000 0110 0110 0000")
        )
        self.assertEqual(seen(SQUARE, inner("-2.9e-14"), before=squeezed), WHOLE)

    def test_a_length_and_off(self):
        self.assertEqual(
            seen(SQUARE, inner("-0.009"), before=["set-touching 0.01"]),
            picture("0000 0110 0110 0000"),
        )
        self.assertEqual(seen(SQUARE, inner("-0.011"), before=["set-touching 0.01"]), WHOLE)
        self.assertEqual(seen(SQUARE, inner("-1e-300"), before=["set-touching off"]), WHOLE)
        self.assertEqual(
            seen(SQUARE, inner(0), before=["set-touching off"]), picture("0000 0110 0110 0000")
        )

    def test_a_plane_is_that_of_the_largest_and_reach_does_not_add_up(self):
        before = ["set-touching 0.01"]
        second = "polygon-abs-3 -0.9 -0.9 -0.008  0.9 -0.9 -0.008  0.9 0.9 -0.008  -0.9 0.9 -0.008"
        # The third is within reach of the second's own plane, but not of the first's.
        self.assertEqual(
            seen(SQUARE, second, inner(-0.016), before=before), picture("1111 1111 1111 1111")
        )

    def test_the_plane_of_the_largest_is_its_plane_for_all_others(self):
        # The second lies 0.009 before the first and has its plane: the third is nearer.
        before = ["set-touching 0.01"]
        third = "polygon-abs-3 -1 -1 0.005  0 -1 0.005  0 0.004 0.017  -1 0.004 0.017"
        expected = picture("0000 0110 2210 2200")
        self.assertEqual(seen(SQUARE, inner(0.009), third, before=before), expected)

    def test_under_two_matrices(self):
        moved = [
            "save-transformation-3",
            "translate-3 0 0 -0.3",
            INNER.format(0.3),
            "restore-transformation-3",
        ]
        self.assertEqual(seen(SQUARE, *moved), picture("0000 0110 0110 0000"))

    def test_of_two_reaches_the_larger_counts(self):
        # 1e-14 behind: the reach is 1.8e-15 under no matrix, 2.8e-14 under one that stretches by 16.
        stretched = [
            "save-transformation-3",
            "scale-3 16 1 1",
            inner("-1e-14"),
            "restore-transformation-3",
        ]
        self.assertEqual(seen(SQUARE, *stretched), picture("0000 1111 1111 0000"))
        self.assertEqual(seen(*stretched, SQUARE), picture("1111 1111 1111 1111"))

    def test_planes_under_two_matrices_that_nearly_coincide_are_undecided(self):
        for distance, count in (("4e-14", 4), ("4e-12", 0)):
            text = program(SQUARE, f"translate-3 0 0 {distance}", inner(0))
            self.assertEqual(program_oracle.item_buffer(text, 4, 4).undecided.sum(), count)

    def test_what_a_number_of_a_matrix_could_decide_is_doubtful(self):
        near = ["translate-3 0 0 1.6e-15", inner(0)]
        text = program(SQUARE, *near)
        self.assertEqual(len(program_oracle.item_buffer(text, 4, 4).doubtful), 2)
        self.assertEqual(program_oracle.item_buffer(program(SQUARE, inner(0)), 4, 4).doubtful, [])

    def test_at_the_reach_exactly_it_touches_and_is_not_doubtful(self):
        for z, expected in (
            (-(2.0**-49), "0000 0110 0110 0000"),
            (-1.7763568394002509e-15, None),
        ):
            answer = program_oracle.item_buffer(program(SQUARE, inner(repr(z))), 4, 4)
            self.assertEqual(answer.ids.tolist(), picture(expected) if expected else WHOLE)
            self.assertEqual(answer.doubtful, [])

    def test_one_view_that_clips_or_not_and_one_image_in_other_words_are_one(self):
        again = ["close-segment", "set-front-plane-clipping on", "open-segment 2", inner(0)]
        for after in ([], ["set-image-centre 2 0.3 0.4"], ["set-image-rotation 2 -360"]):
            answer = program_oracle.item_buffer("\n".join([program(SQUARE, *again), *after]), 4, 4)
            self.assertEqual(answer.ids.tolist(), picture("0000 0110 0110 0000"))
            self.assertFalse(answer.undecided.any())

    def test_between_two_views_planes_are_compared_in_the_picture(self):
        again = [
            "close-segment",
            "set-view-plane-normal 0 0 -2",
            "open-segment 2",
        ]  # the same view in other numbers
        answer = program_oracle.item_buffer(program(SQUARE, *again, inner(0)), 4, 4)
        self.assertEqual(
            answer.undecided.astype(int).tolist(),
            [[0, 0, 0, 0], [0, 1, 1, 0], [0, 1, 1, 0], [0, 0, 0, 0]],
        )
        shifted = ["close-segment", "set-view-reference-point 0 0 -0.5", "open-segment 2"]
        self.assertEqual(seen(SQUARE, *shifted, inner(0)), picture("0000 0110 0110 0000"))


class SupportPlane(unittest.TestCase):
    def test_first_farthest_and_largest(self):
        self.assertEqual(
            planes.support_of([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 1.0, 0.0)]),
            (0, 2, 3),
        )
        self.assertEqual(
            planes.support_of([(0.0, 0.0, 0.0), (2.0, 1.0, 0.0), (2.0, 0.0, 0.0), (0.0, 3.0, 1.0)]),
            (0, 3, 1),
        )
        self.assertEqual(
            planes.support_of([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]),
            (0, 1, 2),
        )

    def test_in_line_by_doubles_alone(self):
        far = 2.0**60  # of which 2 is lost in a difference
        points = [
            (far, far, 0.0),
            (0.0, 0.0, 0.0),
            (1.0, 1.0, 0.0),
            (1.0, 2.0, 0.0),
            (3.0, 5.0, 0.0),
        ]
        self.assertEqual(planes.support_of(points), (0, 1, 3))
        self.assertIsNone(
            planes.support_of([(0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (2.0, 2.0, 2.0), (3.0, 3.0, 3.0)])
        )

    def test_products_that_would_overflow(self):
        points = [(0.0, 0.0, 0.0), (2e200, 0.0, 0.0), (0.0, 1e200, 0.0), (0.0, 1.5e200, 0.0)]
        self.assertEqual(planes.support_of(points), (0, 1, 3))


class Views(unittest.TestCase):
    def test_from_the_right_what_is_far_along_z_is_on_the_left(self):
        left = "polygon-abs-3 0 -1 0  0 -1 1  0 1 1  0 1 0"
        self.assertEqual(
            seen(left, before=["set-view-plane-normal -2 0 0", "set-parallel 1 0 0"]),
            picture("00.. 00.. 00.. 00.."),
        )

    def test_view_up(self):
        top = "polygon-abs-3 -1 0 0  1 0 0  1 1 0  -1 1 0"
        self.assertEqual(seen(top, before=["set-view-up 0 0.5 7"]), picture("0000 0000 .... ...."))
        self.assertEqual(seen(top, before=["set-view-up 1 0 0"]), picture("00.. 00.. 00.. 00.."))

    def test_perspective_halves_what_is_twice_as_far(self):
        self.assertEqual(
            seen(
                "polygon-abs-3 -1 -1 -4  1 -1 -4  1 1 -4  -1 1 -4", before=["set-perspective 0 0 4"]
            ),
            picture(".... .00. .00. ...."),
        )

    def test_perspective_from_aside(self):
        # From (4, 0, 4) the square at z = -4 is seen from x = 1.5 to 2.5.
        before = ["set-perspective 4 0 4", "set-window 1 3 -1 1"]
        self.assertEqual(
            seen("polygon-abs-3 -1 -1 -4  1 -1 -4  1 1 -4  -1 1 -4", before=before),
            picture(".... .00. .00. ...."),
        )

    def test_oblique(self):
        # What is 1 before the view plane is moved by (-0.5, 0).
        self.assertEqual(
            seen("polygon-abs-3 0 -1 1  1 -1 1  1 1 1  0 1 1", before=["set-parallel 1 0 2"]),
            picture(".00. .00. .00. .00."),
        )

    def test_view_distance_moves_the_view_plane_into_the_scene(self):
        # The view plane z = -2 is 6 from the eye: the square at z = -2 keeps its size.
        before = ["set-view-distance 2", "set-perspective 0 0 4"]
        self.assertEqual(seen(inner(-2), before=before), picture(".... .00. .00. ...."))

    def test_what_is_behind_the_eye_is_not_seen(self):
        behind = "polygon-abs-3 -1 -1 9  1 -1 9  1 1 9  -1 1 9"
        self.assertEqual(seen(behind, before=["set-perspective 0 0 4"]), EMPTY)
        # A floor 1 below the eye, on both sides of it: y = -4 / (4 - z) in the picture.
        floor = "polygon-abs-3 -50 -1 -4  50 -1 -4  50 -1 100  -50 -1 100"
        self.assertEqual(
            seen(floor, before=["set-perspective 0 0 4"]), picture(".... .... .... 0000")
        )

    def test_front_and_back_plane(self):
        tilted = "polygon-abs-3 -1 -1 -1  1 -1 1  1 1 1  -1 1 -1"  # z = x
        depth = ["set-view-depth -0.5 0.5"]
        front, back = ["set-front-plane-clipping on"], ["set-back-plane-clipping on"]
        self.assertEqual(seen(tilted, before=depth), WHOLE)
        self.assertEqual(seen(tilted, before=depth + front), picture("000. 000. 000. 000."))
        self.assertEqual(seen(tilted, before=depth + back), picture(".000 .000 .000 .000"))

    def test_front_plane_in_perspective(self):
        # z = 2 x meets the front plane z = 1 at x = 0.5, which is at 2/3 in the picture.
        before = ["set-perspective 0 0 4", "set-view-depth -1 1", "set-front-plane-clipping on"]
        tilted = "polygon-abs-3 0 -1 0  1 -1 2  1 1 2  0 1 0"
        answer = program_oracle.item_buffer(program(tilted, before=before), 8, 8)
        self.assertEqual(answer.ids[3].tolist(), [-1, -1, -1, -1, 0, 0, 0, -1])

    def test_windows_and_viewports(self):
        small = ["set-window -0.5 0.5 -0.5 0.5", "set-viewport 0 0.5 0 0.5"]
        self.assertEqual(seen(SQUARE, before=small), picture(".... .... 00.. 00.."))
        self.assertEqual(
            seen(SQUARE, before=["set-viewport 0.5 1 0 1"]), picture("..00 ..00 ..00 ..00")
        )
        self.assertEqual(
            seen(SQUARE, before=["set-window 0 2 0 2"]), picture(".... .... 00.. 00..")
        )

    def test_image_transformations(self):
        left = "polygon-abs-3 -1 -1 0  0 -1 0  0 1 0  -1 1 0"
        self.assertEqual(
            seen(left, after=["set-image-translation 1 0.25 0"]), picture(".00. .00. .00. .00.")
        )
        self.assertEqual(
            seen(left, after=["set-image-scale 1 1 0.5"]), picture(".... .... 00.. 00..")
        )
        about = ["set-image-centre 1 0.5 0.5", "set-image-rotation 1 90"]
        corner = "polygon-abs-3 -1 -1 0  0 -1 0  0 0 0  -1 0 0"
        self.assertEqual(seen(corner, after=about), picture(".... .... ..00 ..00"))
        self.assertEqual(seen(left, after=about), picture(".... .... 0000 0000"))
        first_scaled = [
            "set-image-centre 1 0.5 0.5",
            "set-image-scale 1 1 0.5",
            "set-image-rotation 1 90",
        ]
        self.assertEqual(seen(left, after=first_scaled), picture(".... .... .00. .00."))

    def test_modelling_transformations_act_in_order(self):
        moved = [
            "translate-3 -0.5 0 0",
            "rotate-z-3 90",
        ]  # to the left, and then around to the bottom
        turned = ["rotate-z-3 90", "translate-3 -0.5 0 0"]
        strip = "polygon-abs-3 0 -1 0  0.5 -1 0  0.5 1 0  0 1 0"
        self.assertEqual(seen(strip, before=moved), picture(".... .... 0000 ...."))
        self.assertEqual(seen(strip, before=turned), picture(".... 000. .... ...."))
        saved = [
            "rotate-z-3 90",
            "save-transformation-3",
            "translate-3 -0.5 0 0",
            strip,
            "restore-transformation-3",
        ]
        self.assertEqual(seen(*saved), picture(".... .... 0000 ...."))
        for axis, low in (
            ("x", "0 -1 -1  0 1 -1  0 1 1  0 -1 1"),
            ("y", "-1 0 -1  1 0 -1  1 0 1  -1 0 1"),
        ):
            other = {"x": "y", "y": "x"}[axis]
            self.assertEqual(seen(f"polygon-abs-3 {low}"), EMPTY)
            self.assertEqual(seen(f"rotate-{other}-3 90", f"polygon-abs-3 {low}"), WHOLE)

    def test_rotations_are_counterclockwise(self):
        for axis, points, expected in (
            ("x", "-1 0 0  1 0 0  1 0 1  -1 0 1", ".... .... 0000 0000"),  # z to -y
            ("y", "0 -1 0  0 1 0  0 1 1  0 -1 1", "..00 ..00 ..00 ..00"),  # z to x
            ("z", "0 -1 0  1 -1 0  1 1 0  0 1 0", "0000 0000 .... ...."),  # x to y
        ):
            rotated = [f"rotate-{axis}-3 90", f"polygon-abs-3 {points}"]
            self.assertEqual(seen(*rotated), picture(expected))

    def test_back_faces(self):
        on = "set-back-face-removal on"
        clockwise = "polygon-abs-3 -1 -1 0  -1 1 0  1 1 0  1 -1 0"
        self.assertEqual(seen(on, SQUARE), WHOLE)
        self.assertEqual(seen(on, clockwise), EMPTY)
        self.assertEqual(seen("set-hidden-line-removal on", clockwise), EMPTY)
        self.assertEqual(
            seen(on, clockwise, after=["set-image-centre 1 0.5 0.5", "set-image-scale 1 -1 1"]),
            EMPTY,
        )

    def test_sines_and_square_roots_have_60_digits(self):
        sine, cosine = exact_view.sine_and_cosine(30.0)
        self.assertLess(abs(sine - Decimal("0.5")), Decimal("1e-60"))
        self.assertLess(
            abs(exact_view.sine_and_cosine(-765.0)[1] - Decimal("0.5").sqrt()), Decimal("1e-25")
        )
        self.assertLess(
            abs(exact_view.sine_and_cosine(45.0)[0] - exact_view.sine_and_cosine(45.0)[1]),
            Decimal("1e-60"),
        )
        with exact_view.decimal.localcontext(exact_view.CONTEXT):
            self.assertLess(abs(sine * sine + cosine * cosine - 1), Decimal("1e-60"))
        self.assertEqual(exact_view.sine_and_cosine(270.0), (Decimal(-1), Decimal(0)))


class Refusals(unittest.TestCase):
    def test_what_is_not_known_is_named(self):
        for line in (
            "box-3 0 1 0 1 0 1",
            "set-pick-id 4",
            "set-line-style solid 0 0 0",
            "set-visibility 1 off",
            "translate-3 0 nan 0",
            "polygon-abs-3 0 0 0  1 0 0",
            "translate-3 1 2",
            "set-back-face-removal yes",
            "open-segment 1",
        ):
            with self.assertRaisesRegex(program_reader.Refused, "line 4: "):
                seen(line)

    def test_polygons_that_are_not_flat(self):
        with self.assertRaisesRegex(ValueError, "not flat"):
            seen("polygon-abs-3 0 0 0  1 0 0  1 1 0.1  0 1 0")

    def test_an_open_segment_at_the_end(self):
        with self.assertRaises(program_reader.Refused):
            program_oracle.item_buffer("open-segment 1\n", 4, 4)


if __name__ == "__main__":
    unittest.main()
