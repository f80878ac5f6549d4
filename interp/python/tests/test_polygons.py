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


@pytest.mark.parametrize("method", ["depth-sort", "bsp", "plain-bsp"])
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


def painted_last(pieces, x: float, y: float) -> int:
    """The polygon whose piece is drawn last at a place, by the even-odd rule."""
    last = -1
    for k, item in enumerate(pieces.item):
        a = pieces.points[pieces.first[k] : pieces.first[k + 1], :2]
        b = np.roll(a, -1, axis=0)
        crosses = (a[:, 1] < y) != (b[:, 1] < y)
        a, b = a[crosses], b[crosses]
        left = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0]) < x
        if np.count_nonzero(left) % 2 == 1:
            last = int(item)
    return last


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("ring", [False, True])
def test_a_closed_ring_is_cut_like_the_polygon_without_its_last_corner(whole, ring):
    flat = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], float)
    rising = np.array([(0, 0.2, -1), (2, 0.2, 1), (2, 0.8, 1), (0, 0.8, -1)])
    if ring:
        rising = np.concatenate([rising, rising[:1]])
    for polygons, number in (([flat, rising], 1), ([rising, flat], 0)):
        pieces = sort(polygons, whole=whole)
        assert painted_last(pieces, 0.5, 0.5) != number
        assert painted_last(pieces, 1.5, 0.5) == number


# Neighbours in two surfaces that pass through each other: cuts make corners that are rounded to
# one place.
FIVE_QUADS = np.array(
    [
        [
            [-0.056592109101313424, -0.034531420198526244, 0.976140949776999],
            [-0.05693235811922504, -0.024325415976193848, 0.9820098068452228],
            [-0.0500766860122244, -0.01862489528592297, 0.9727058456581802],
            [-0.04978022773489556, -0.02876852368341705, 0.9669473436023308],
        ],
        [
            [-0.04628233217461176, -0.02249883255347979, 0.9904569441239012],
            [-0.03533941668801413, -0.025858631225102877, 0.9960045658766007],
            [-0.028594449983821685, -0.02006292083819694, 0.9864348231160281],
            [-0.03947001418078983, -0.016767198402897015, 0.9809930025607217],
        ],
        [
            [-0.039117599058952505, -0.032082416668108606, 0.9722340300674394],
            [-0.03947001418078983, -0.016767198402897015, 0.9809930025607217],
            [-0.028594449983821685, -0.02006292083819694, 0.9864348231160281],
            [-0.028337735734206428, -0.035432745609827135, 0.9775788431774783],
        ],
        [
            [-0.03501909767643309, -0.04132367968129574, 0.9869767089402977],
            [-0.03544749587523067, -0.02064055235067145, 0.9990506649363063],
            [-0.02868105813046631, -0.014877575499095035, 0.9894225809454018],
            [-0.028337735734206428, -0.035432745609827135, 0.9775788431774783],
        ],
        [
            [-0.04978022773489556, -0.02876852368341705, 0.9669473436023308],
            [-0.039117599058952505, -0.032082416668108606, 0.9722340300674394],
            [-0.03947001418078983, -0.016767198402897015, 0.9809930025607217],
            [-0.05022624323830241, -0.013507639194561707, 0.9756108938882286],
        ],
    ]
)


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
@pytest.mark.parametrize("whole", [False, True])
def test_pieces_with_corners_that_were_rounded_to_one_place_keep_their_order(whole, method):
    pieces = sort(FIVE_QUADS, whole=whole, method=method)
    # There polygon 3 has the depth 0.99335, 1 has 0.98684 and 2 has 0.98376.
    assert painted_last(pieces, -0.03233124999999999, -0.020306249999999998) == 3


@pytest.mark.parametrize("stride", (2, 3, 4))
def test_cells_of_a_surface_that_hides_nothing_stay_whole(stride):
    """Steep ones of many corners too, as matplotlib makes of data with more points than cells."""
    x = np.linspace(0.0, 1.0, 8 * stride + 1)
    u, v = np.meshgrid(x, x)
    surface = np.stack([u, v, 0.4 * np.sin(9.0 * u) * np.cos(9.0 * v)], axis=-1)
    cells = []
    for i in range(0, 8 * stride, stride):
        for k in range(0, 8 * stride, stride):
            cell = surface[i : i + stride + 1, k : k + stride + 1]
            ring = [cell[0, :-1], cell[:-1, -1], cell[-1, :0:-1], cell[:0:-1, 0]]
            cells.append(np.concatenate(ring))
    pieces = sort(cells, whole=True)
    assert sorted(pieces.item.tolist()) == list(range(64))
    assert np.diff(pieces.first).tolist() == [4 * stride] * 64
    assert (pieces.sides > 0).all()


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


def rug_on_floor(shift: float, gap: float = 0.0) -> np.ndarray:
    """A rug on a sloping floor, in decimals: at most in the doubles' last digits in its plane."""
    floor = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    corners = np.array([floor, 0.2 + 0.4 * floor, 0.3 + 0.1 * floor]) + shift
    z = 0.3 * corners[..., 0] + 0.7 * corners[..., 1]
    z[1:] += gap
    return np.dstack([corners, z])


@pytest.mark.parametrize("shift", [0.1, 1e3 / 3, 1e6 / 3, -1e8 / 3])
def test_what_touches_lies_in_one_plane(shift):
    scene = rug_on_floor(shift)
    shown = areas(visible_pieces(scene))
    assert shown == pytest.approx({0: 0.84, 1: 0.15, 2: 0.01}, rel=1e-6)
    lines = visible_lines(scene)
    length = np.linalg.norm((lines.points[:, 1] - lines.points[:, 0])[:, :2], axis=1)
    assert np.sum(length) == pytest.approx(4 + 1.6 + 0.4, rel=1e-6)
    for method in ("depth-sort", "bsp"):
        assert painted_last(sort(scene, method=method), shift + 0.25, shift + 0.25) == 1
        assert painted_last(sort(scene, method=method), shift + 0.35, shift + 0.35) == 2


@pytest.mark.parametrize("given", [lambda scene: scene, list])
def test_what_touches_in_single_precision_lies_in_one_plane(given):
    scene = rug_on_floor(1e3 / 3).astype(np.float32)
    expected = pytest.approx({0: 0.84, 1: 0.15, 2: 0.01}, rel=1e-2)
    assert areas(visible_pieces(given(scene))) == expected
    assert areas(visible_pieces(given(scene.astype(float)))) != expected


def test_touching_is_set():
    scene = rug_on_floor(0.0, -1e-3)
    for find in (visible_pieces, sort, visible_lines):
        find(scene, touching=1e-2)
    assert set(areas(visible_pieces(scene)).keys()) == {0}
    assert set(areas(visible_pieces(scene, touching="off")).keys()) == {0}
    assert set(areas(visible_pieces(scene, touching=1e-2)).keys()) == {0, 1, 2}
    assert set(visible_lines(scene).item.tolist()) == {0}
    assert set(visible_lines(scene, touching=1e-2).item.tolist()) == {0, 1, 2}
    assert painted_last(sort(scene), 0.25, 0.25) == 0
    assert painted_last(sort(scene, touching=1e-2), 0.25, 0.25) == 1


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


def test_methods_that_are_refused_name_those_that_are_not():
    with pytest.raises(Error, match="'z-buffer': expected depth-sort, bsp or plain-bsp$"):
        sort(CROSSING, method="z-buffer")
    with pytest.raises(Error, match="expected depth-sort, bsp or plain-bsp, or visible_pieces$"):
        sort(CROSSING, method="map")
    with pytest.raises(Error, match="'bsp': expected franklin, appel, roberts or plain-appel$"):
        visible_lines(CROSSING, method="bsp")
    for method in ("franklin", "appel", "roberts", "plain-appel"):
        assert len(visible_lines(CROSSING, method=method).item) > 0


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


def test_the_cuts_of_lines():
    wall = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
    lines = [[[0.5, -1, 0], [0.5, 2, 0]], [[-1, 2, 0], [0, 2, 0]]]
    seen = visible_lines([wall], segments=lines)
    assert seen.points[:, :, 1].tolist() == [[-1, 0], [1, 2], [2, 2]]
    assert seen.cuts.tolist() == [[False, True], [True, False], [False, False]]
    all_parts = visible_lines([wall], segments=lines, hidden=True)
    (middle,) = all_parts.cuts[all_parts.hidden]
    assert middle.tolist() == [True, True]


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_the_cuts_of_a_sort(method):
    pieces = sort(CROSSING, segments=[[[0.1, 0.5, -1], [0.9, 0.5, 2]]], method=method)
    assert len(pieces.cuts) == len(pieces.points)
    assert np.allclose(pieces.points[pieces.cuts, 0], 0.5)
    for k, item in enumerate(pieces.item):
        own = slice(pieces.first[k], pieces.first[k + 1])
        given = [[0.1, 0.5, -1], [0.9, 0.5, 2]] if item == 2 else CROSSING[item]
        is_given = [any((p == q).all() for q in np.array(given)) for p in pieces.points[own]]
        assert (~pieces.cuts[own] | ~np.array(is_given)).all()
    assert pieces.cuts.sum() >= 6


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
    for find in (sort, visible_pieces, visible_lines):
        for touching in (0, -1.0, "near", np.nan, None, True, 1e200):
            with pytest.raises(Error):
                find(CROSSING, touching=touching)
    assert "map" in displayfile.methods()
