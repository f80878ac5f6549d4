"""Polygons in, pieces out, against areas that are known."""

from __future__ import annotations

import numpy as np
import pytest

import displayfile
from displayfile import Error, sort, visible_lines, visible_pieces

# Two unit squares that pass through each other: of each one half is seen.
CROSSING = np.array(
    [
        [[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 1, 0]],
        [[0, 0, 1], [1, 0, 0], [1, 1, 0], [0, 1, 1]],
    ],
    float,
)


def areas(pieces) -> dict[int, float]:
    """The sum of the pieces' areas in the picture, by polygon."""
    of_items: dict[int, float] = {}
    for k, item in enumerate(pieces.item):
        p = pieces.points[pieces.first[k] : pieces.first[k + 1]]
        x, y, _ = (p - p[0]).T
        area = abs(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2
        of_items[int(item)] = of_items.get(int(item), 0.0) + area
    return of_items


def contains(polygon: np.ndarray, x: float, y: float) -> bool:
    """Whether a convex polygon holds a point."""
    a, b = polygon[:, :2], np.roll(polygon[:, :2], -1, axis=0)
    turns = (b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (b[:, 1] - a[:, 1]) * (x - a[:, 0])
    return bool((turns >= 0).all() or (turns <= 0).all())


def depth_at(polygon: np.ndarray, x: float, y: float) -> float:
    """The z of a flat polygon's plane."""
    normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0])
    return (
        polygon[0, 2]
        - (normal[0] * (x - polygon[0, 0]) + normal[1] * (y - polygon[0, 1])) / normal[2]
    )


def random_triangles(count: int, seed: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    return random.uniform(-40, 60, (count, 3, 3))


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_a_sort_tiles_each_polygon(method):
    pieces = sort(CROSSING, method=method)
    assert len(pieces.item) == 3
    assert areas(pieces) == {0: 1.0, 1: 1.0}
    assert len(pieces.sides) == len(pieces.points) == pieces.first[-1]
    cuts = np.count_nonzero(pieces.sides == 0)
    assert cuts == 2  # one polygon is cut, into two pieces that share a side


def test_visible_pieces_tile_what_is_seen():
    pieces = visible_pieces(CROSSING)
    assert areas(pieces) == {0: 0.5, 1: 0.5}


def test_a_hidden_polygon_has_no_pieces():
    behind = CROSSING[0] * [0.5, 0.5, 0] + [0.25, 0.25, -5]
    front = CROSSING[0] * [1, 1, 0] + [0, 0, 3]
    pieces = visible_pieces([behind, front])
    assert areas(pieces) == {1: 1.0}


def cycle() -> list[np.ndarray]:
    """Three long triangles, each before the next: there is no order without a cut."""
    triangles = []
    for k in range(3):
        turn = 2 * np.pi * k / 3
        c, s = np.cos(turn), np.sin(turn)
        points = np.array([[-1, -0.5, 0], [1, -0.6, 1], [1, -0.4, 1]], float)
        rotation = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        triangles.append(points @ rotation)
    return triangles


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_a_cycle_is_cut(method):
    pieces = sort(cycle(), method=method)
    assert len(pieces.item) > 3
    assert np.allclose(list(areas(pieces).values()), 0.2)


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_random_polygons_in_order(method):
    """At any place what is drawn last is what is nearest."""
    triangles = random_triangles(30, 1)
    pieces = sort(triangles, method=method)
    for x, y in np.random.default_rng(2).uniform(-30, 50, (300, 2)):
        nearest, seen = None, None
        for k, triangle in enumerate(triangles):
            if contains(triangle, x, y):
                z = depth_at(triangle, x, y)
                if nearest is None or z > nearest[0]:
                    nearest = (z, k)
        for k, item in enumerate(pieces.item):
            if contains(pieces.points[pieces.first[k] : pieces.first[k + 1]], x, y):
                seen = item
        assert seen == (None if nearest is None else nearest[1])


def test_corners_are_given_back_as_they_were():
    triangles = random_triangles(30, 3)
    given = {tuple(p) for p in triangles.reshape(-1, 3)}
    for pieces in (sort(triangles), sort(triangles, method="bsp")):
        kept = {tuple(p) for p in pieces.points}
        assert given <= kept


@pytest.mark.parametrize("scale, shift", [(1e90, 0), (1e-90, 0), (1, 1e6), (2.0**-40, -3)])
def test_any_range(scale, shift):
    pieces = visible_pieces(CROSSING * scale + shift)
    assert np.allclose(np.array(list(areas(pieces).values())) / scale / scale, 0.5)


def test_flat_ranges():
    edge_on = np.array([[[0, 0, 0], [1, 0, 0], [1, 0, 1]]], float)
    assert len(visible_pieces(edge_on).item) == 0
    level = CROSSING * [1, 1, 0] + [0, 0, 7]
    assert areas(visible_pieces(level)) == {1: 1.0}  # of equal depths the later is seen


def test_polygons_of_any_length():
    triangle = [[0.0, 0, 1], [1, 0, 1], [0, 1, 1]]
    pieces = visible_pieces(
        [CROSSING[0], triangle, [[0, 0, 9], [0.5, 0, 9], [0.5, 0.5, 9], [0, 0.5, 9]]]
    )
    assert sum(areas(pieces).values()) == pytest.approx(1.0)


def test_nothing_in_nothing_out():
    assert len(sort([]).item) == 0
    assert sort([]).first.tolist() == [0]
    assert len(visible_pieces(np.zeros((0, 3, 3))).points) == 0
    assert visible_lines([]).points.shape == (0, 2, 3)


def test_visible_lines():
    back = CROSSING[0] * [1, 1, 0]
    front = back * 0.5 + [0.25, -0.25, 1]  # hides the middle of the lower side
    lines = visible_lines([back, front])
    length = np.linalg.norm(lines.points[:, 1] - lines.points[:, 0], axis=1)
    assert np.sum(length[lines.item == 1]) == pytest.approx(2.0)
    assert np.sum(length[lines.item == 0]) == pytest.approx(3.5)
    assert not lines.hidden.any()
    both = visible_lines([back, front], hidden=True)
    length = np.linalg.norm(both.points[:, 1] - both.points[:, 0], axis=1)
    assert np.sum(length[both.hidden]) == pytest.approx(0.5)


def test_kinds_of_lines():
    lines = visible_lines(CROSSING, lines="boundary,intersection")
    assert sorted(set(lines.kinds.tolist())) == [4, 32]
    crossing = lines.points[lines.kinds == 32]
    assert np.allclose(np.sort(crossing[0, :, 1]), [0, 1])
    assert np.allclose(crossing[0, :, 0], 0.5)


@pytest.mark.parametrize("method", ["appel", "roberts"])
def test_methods_of_lines_agree(method):
    triangles = random_triangles(20, 5)
    one, other = visible_lines(triangles), visible_lines(triangles, method=method)
    assert np.array_equal(one.points, other.points)
    assert np.array_equal(one.item, other.item)


def test_threads_change_nothing():
    triangles = random_triangles(60, 7)
    for find in (sort, visible_pieces, visible_lines):
        one, two = find(triangles), find(triangles, threads=2)
        assert all(np.array_equal(a, b) for a, b in zip(one, two))


@pytest.mark.parametrize("find", [sort, visible_pieces, visible_lines])
@pytest.mark.parametrize(
    "polygons",
    [
        None,
        "polygons",
        5,
        {},
        CROSSING[0],
        CROSSING[..., :2],
        CROSSING[:, :2],
        CROSSING * np.nan,
        CROSSING + np.inf,
        CROSSING * 1e200,
        CROSSING.astype(complex),
        CROSSING.astype(object),
        [CROSSING[0], None],
        [CROSSING[0], CROSSING[0][:2]],
        [CROSSING[0], [[0, 0, 0], [1, 0]]],
        [CROSSING[0], "square"],
    ],
)
def test_what_is_refused(find, polygons):
    with pytest.raises(Error):
        find(polygons)


def test_options_that_are_refused():
    for method in ("map", "franklin", "z-buffer", "auto", "bubble", 5, None):
        with pytest.raises(Error):
            sort(CROSSING, method=method)
    for method in ("bsp", "perimeter", "colour-rule", "map"):
        with pytest.raises(Error):
            visible_lines(CROSSING, method=method)
    for threads in (0, -1, 1025, 1.5, "two", 2**40, True):
        with pytest.raises(Error):
            sort(CROSSING, threads=threads)
    for lines in ("", "outlines", "crease=500", 3):
        with pytest.raises(Error):
            visible_lines(CROSSING, lines=lines)
    with pytest.raises(Error):
        visible_lines(CROSSING, hidden="perhaps")
    assert "map" in displayfile.methods()
