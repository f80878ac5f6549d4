from __future__ import annotations

import numpy as np
import pytest

import displayfile

SQUARE = np.array([[[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]])
THROUGH = np.array([[[-1.0, 0.5, -1.0], [3.0, 0.5, 1.0]], [[0.2, 0.2, 1.0], [0.4, 0.2, 1.0]]])


def test_segments_are_sorted_among_polygons() -> None:
    pieces = displayfile.sort(SQUARE, segments=THROUGH)
    lengths = np.diff(pieces.first)
    assert (lengths[pieces.item > 0] == 2).all()
    order = pieces.item.tolist()
    assert order.index(0) < order.index(2)
    z = pieces.points[:, 2]
    square = order.index(0)
    for k, item in enumerate(order):
        if item == 1 and z[pieces.first[k] : pieces.first[k + 1]].mean() > 0.0:
            assert k > square
    assert displayfile.sort(SQUARE[:0], segments=THROUGH).item.tolist() in ([0, 1], [1, 0])


def test_parts_of_segments_are_found() -> None:
    seen = displayfile.visible_lines(SQUARE, segments=THROUGH)
    parts = sorted(zip(seen.item.tolist(), np.sort(seen.points[:, :, 0]).tolist()))
    assert parts == [(0, [-1.0, 0.0]), (0, [1.0, 3.0]), (1, [0.2, 0.4])]
    all_parts = displayfile.visible_lines(SQUARE, segments=THROUGH, hidden=True)
    hidden = all_parts.points[all_parts.hidden]
    assert all_parts.item[all_parts.hidden].tolist() == [0]
    assert np.sort(hidden[0, :, 0]).tolist() == [0.0, 1.0]


def test_polygons_may_be_given_as_all_corners() -> None:
    polygons = [SQUARE[0], SQUARE[0, :3] + [0.2, 0.1, 0.5]]
    points = np.concatenate(polygons)
    for function in (displayfile.sort, displayfile.visible_pieces, displayfile.visible_lines):
        for a, b in zip(function(polygons), function(points, sides=[4, 3])):
            assert np.array_equal(a, b)


def test_polygons_that_nothing_separates_stay_whole() -> None:
    bent = np.array([[[0.0, 0, 0], [1, 0, 0.1], [1, 1, 0], [0, 1, 0.1]]])
    assert len(displayfile.sort(bent).item) == 2
    whole = displayfile.sort(bent, whole=True)
    assert whole.item.tolist() == [0]
    assert np.array_equal(whole.points, bent[0])
    assert (whole.sides == 1).all()
    # A sheet between its triangles keeps them apart.
    crossing = np.array([[0.0, 0.4, -0.5], [1.0, 0.4, -0.5], [1.0, 0.6, 0.5], [0.0, 0.6, 0.5]])
    pieces = displayfile.sort(np.concatenate([bent, crossing[None]]), whole=True)
    assert len(pieces.item) > 2


def random_polygons(count: int) -> np.ndarray:
    """Squares in the projection, none of them flat."""
    random = np.random.default_rng(1)
    corners = np.array([[-0.15, -0.15], [0.15, -0.15], [0.15, 0.15], [-0.15, 0.15]])
    places = random.uniform(0, 1, (count, 1, 3)) + np.zeros((1, 4, 1))
    places[:, :, :2] += corners
    places[:, :, 2] += random.uniform(-0.2, 0.2, (count, 4))
    return places


def painted(pieces: displayfile.PolygonPieces, at: np.ndarray) -> np.ndarray:
    """The item of the last piece over each point."""
    seen = np.full(len(at), -1)
    for k, item in enumerate(pieces.item):
        p = pieces.points[pieces.first[k] : pieces.first[k + 1], :2]
        q = np.roll(p, -1, axis=0) - p
        to = at[:, None] - p
        turns = q[:, 0] * to[..., 1] - q[:, 1] * to[..., 0]
        seen[(turns > 0).all(axis=1) | (turns < 0).all(axis=1)] = item
    return seen


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_whole_polygons_leave_the_picture_as_it_was(method: str) -> None:
    polygons = random_polygons(60)
    at = np.random.default_rng(3).uniform(0, 1, (4000, 2))
    in_pieces = displayfile.sort(polygons, method=method)
    whole = displayfile.sort(polygons, method=method, whole=True)
    assert len(whole.item) < len(in_pieces.item)
    assert (painted(in_pieces, at) == painted(whole, at)).mean() > 0.999


def test_errors_name_what_is_wrong() -> None:
    with pytest.raises(
        displayfile.Error, match=r"segments: expected an array of shape \(L, 2, 3\)"
    ):
        displayfile.sort(SQUARE, segments=np.zeros((2, 3)))
    with pytest.raises(displayfile.Error, match="sides: 3 corners in all, but there are 4 points"):
        displayfile.sort(SQUARE[0], sides=[3])
    with pytest.raises(displayfile.Error, match="polygon 1: 2 vertices"):
        displayfile.sort(SQUARE[0], sides=[3, 2])
