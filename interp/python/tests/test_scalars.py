"""Colours as matplotlib takes them, meshes in colours of scalars, and what stands beside them."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from displayfile import Error, System
from displayfile._bands import bands, contours
from displayfile._colours import Scale, colour, colours, scale_of, steps_of

SQUARE = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], float)
TRIANGLES = [[0, 1, 2], [0, 2, 3]]
TABLE = np.array([(k / 7, 1 - k / 7, 0.5) for k in range(8)])


# ---- Colours -----------------------------------------------------------------------------


def test_colours_are_those_of_matplotlib():
    of = pytest.importorskip("matplotlib.colors", reason="matplotlib is not installed")
    names = [*"bgrcmykw", "red", "RebeccaPurple", "tab:blue", "tab:grey", "C0", "C13", "0.25"]
    names += ["#123456", "#abc", "#123456ff", "#abcf", "lightgray", "transparent"[:0] or "navy"]
    names += list(of.CSS4_COLORS)
    for name in names:
        assert np.abs(np.subtract(colour(name), of.to_rgb(name))).max() < 1e-12, name
    for value in ((0.1, 0.2, 0.3), [0.1, 0.2, 0.3, 1], np.array([0.1, 0.2, 0.3])):
        assert colour(value) == (0.1, 0.2, 0.3)


@pytest.mark.parametrize(
    "value",
    ["reddish", "#12", "#12345678", "#abc8", "1.5", "", (0, 0), (0, 0, 2), (0, 0, 0, 0.5), None, 3],
)
def test_colours_that_are_refused(value):
    with pytest.raises(Error):
        colour(value)
    with pytest.raises(Error):
        System().mesh(SQUARE, TRIANGLES, fills=[value, value])


def test_arrays_of_colours():
    expected = [(1, 0, 0), (0, 0, 1)]
    for value in (
        ["red", "b"],
        expected,
        np.array(expected, float),
        np.array([(255, 0, 0), (0, 0, 255)], np.uint8),
        [(1, 0, 0, 1), (0, 0, 1, 1)],
        [(1, 0, 0), "blue"],
    ):
        assert colours(value).tolist() == np.array(expected, float).tolist()
    assert colours([]).shape == (0, 3)
    for bad in ("red", 3, [1, 2], np.zeros((2, 2)), [(1, 0, 0), (1, 0)], {"a": 1}):
        with pytest.raises(Error):
            colours(bad)


def test_fills_of_meshes():
    named, given = System(), System()
    named.mesh(SQUARE, TRIANGLES, fills=["tomato", "#00f"])
    given.mesh(SQUARE, TRIANGLES, fills=[(1, 99 / 255, 71 / 255), (0, 0, 1)])
    assert named.dump() == given.dump()
    one, same = System(), System()
    one.mesh(SQUARE, TRIANGLES, fill="0.5")
    same.mesh(SQUARE, TRIANGLES, fill=(0.5, 0.5, 0.5))
    assert one.dump() == same.dump()
    assert (one.draw(8, background="navy")[0, 0] == (0, 0, 128, 255)).all()


# ---- Colour maps -------------------------------------------------------------------------


def test_colour_maps():
    matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    viridis = matplotlib.colormaps["viridis"]
    assert np.array_equal(steps_of("viridis"), viridis(np.arange(256))[:, :3])
    assert np.array_equal(steps_of(viridis), steps_of("viridis"))
    assert np.array_equal(steps_of(TABLE), TABLE)
    middles = (np.arange(4) + 0.5) / 4
    assert np.array_equal(steps_of(TABLE, middles), TABLE[[1, 3, 5, 7]])
    assert np.array_equal(steps_of(TABLE, np.array([0.0, 1.0])), TABLE[[0, -1]])
    assert len(steps_of(None)) == 256 and len(steps_of(None, middles)) == 4
    lightness = steps_of(None) @ (0.2, 0.7, 0.1)
    assert (np.diff(lightness) > 0).all()
    for bad in ("viridi", 5, [], np.zeros((2, 2))):
        with pytest.raises(Error):
            steps_of(bad)


@pytest.mark.parametrize("levels", ([0.0, 0.1, 0.5, 1.0], [-3, 1, 2, 7.5, 8], 6))
def test_bands_have_the_colours_of_contourf(levels):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    from matplotlib import pyplot

    values = np.linspace(0.0, 1.0, 50)
    bounds = levels if isinstance(levels, list) else np.linspace(0.0, 1.0, levels + 1)
    _, ax = pyplot.subplots()
    drawn = ax.contourf(*np.meshgrid(values, values), values[:, None] + 0 * values, levels=bounds)
    pyplot.close("all")
    scale = scale_of(values, "viridis", None, levels)
    assert scale.colours == pytest.approx(drawn.to_rgba(drawn.cvalues)[:, :3], abs=0.005)


def test_matplotlib_is_imported_for_its_maps_alone():
    program = """
import sys
import numpy as np
import displayfile
g = displayfile.System()
g.mesh(np.eye(3), [[0, 1, 2]], values=[1.0, 2.0, 4.0], at="vertices", levels=4)
g.surface(range(4), range(4), np.arange(16.0).reshape(4, 4), cmap="displayfile", contours=3)
g.colour_bar("u")
g.legend({"one": "tomato"})
g.draw(32)
assert not any(name.startswith("matplotlib") for name in sys.modules)
g.mesh(np.eye(3), [[0, 1, 2]], values=[1.0], cmap="magma")
print("matplotlib" in sys.modules)
"""
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout == "True\n", done.stderr


# ---- Values of faces and vertices --------------------------------------------------------


def test_values_of_faces():
    g, given = System(), System()
    g.mesh(SQUARE, TRIANGLES, values=[3.0, 5.0], cmap=TABLE, limits=(1, 9))
    assert re.findall("fill solid (.*)", g.dump()) == [
        " ".join(f"{part:.16g}" for part in TABLE[k]) for k in (2, 4)
    ]
    beyond = System()
    beyond.mesh(SQUARE, TRIANGLES, values=[-99.0, np.nan], cmap=TABLE, limits=(0, 1))
    assert "fill solid 0 1 0.5" in beyond.dump() and "fill solid 0.75 0.75 0.75" in beyond.dump()
    equal = System()
    equal.mesh(SQUARE, TRIANGLES, values=[7, 7], cmap=TABLE)
    assert len(re.findall("fill solid", equal.dump())) == 1


def shown(system: System, **options: Any) -> np.ndarray[Any, Any]:
    return np.asarray(system.draw(64, samples=1, **options))[..., :3].astype(int)


def expected_of(values: Any, scale: Scale, where: Any) -> np.ndarray[Any, Any]:
    return np.rint(255 * scale.of_steps(scale.steps(values[where]))).astype(int)


@pytest.mark.parametrize("hidden", ["z-buffer", "map", "bsp"])
@pytest.mark.parametrize("at_corners", [(0, 1, 3, -2), (0, 0, 5, 5), (1, 0, 0, 1), (0, 8, 0, 8)])
def test_values_of_vertices_are_linear_over_each_triangle(hidden, at_corners):
    """Against each pixel's own value, away from where the colour changes."""
    system = System()
    system.set_window(-1, 1, -1, 1)
    values = np.array(at_corners, float)
    system.set_line_style("none")
    system.mesh(SQUARE, TRIANGLES, values=values, cmap=TABLE, at="vertices")
    picture = shown(system, hidden=hidden)
    centre = (np.arange(64) + 0.5) / 32 - 1
    x, y = np.meshgrid(centre, -centre)
    a, b, c, d = values
    below = y < x  # the triangle 0 1 2
    u, v = (x + 1) / 2, (y + 1) / 2
    value = np.where(below, a + (b - a) * u + (c - b) * v, a + (d - a) * v + (c - d) * u)
    scale = scale_of(values, TABLE, None)
    step = (scale.limits[1] - scale.limits[0]) / 8
    part = (value - scale.limits[0]) / step
    away = (np.abs(part - np.rint(part)) > 0.05) & (np.abs(x - y) > 0.05)
    assert away.sum() > 1000
    assert np.array_equal(picture[away], expected_of(value, scale, away))


def test_colours_in_vectors_are_those_of_pixels():
    system = System()
    rng = np.random.default_rng(1)
    points = rng.uniform(-1, 1, (9, 3))
    faces = rng.permuted(np.tile(np.arange(9), (6, 1)), axis=1)[:, :3]
    system.mesh(points, faces, values=rng.uniform(0, 1, 9), at="vertices", levels=12)
    pixels = {tuple(c) for c in shown(system).reshape(-1, 3)}
    in_svg = {
        tuple(int(c[k : k + 2], 16) for k in (0, 2, 4))
        for c in re.findall(r"fill:\s*#([0-9a-f]{6})", system.svg(64))
    }
    assert pixels <= in_svg | {(255, 255, 255)}


def test_faces_of_values_are_not_lit_unless_a_light_was_set():
    def colours_of(system: System) -> set[str]:
        system.mesh(SQUARE, TRIANGLES, values=[0.0, 1.0], cmap=TABLE)
        return set(re.findall("fill solid .*", system.dump()))

    own = {"fill solid 0 1 0.5", "fill solid 1 0 0.5"}
    assert colours_of(System()) == own
    after = System()
    after.mesh(SQUARE + 3, TRIANGLES)  # which is lit
    assert own < colours_of(after)
    lit = System()
    lit.set_light(1, 1, 1)
    assert not own & colours_of(lit)
    late = System()
    late.mesh(SQUARE, TRIANGLES, values=[0.0, 1.0], cmap=TABLE)
    late.look(eye=(100, 50))
    late.mesh(SQUARE + 3, TRIANGLES)
    assert own < set(re.findall("fill solid .*", late.dump()))


def test_sides_of_faces_in_pieces_are_those_of_the_faces():
    """What is cut for its colours has no sides but the faces' own."""
    system = System()
    system.set_window(-1.2, 1.2, -1.2, 1.2)
    system.set_line_style("solid", 0, 0, 0, 1)
    system.mesh(SQUARE, [[0, 1, 2, 3]], values=[0, 1, 2, 3], at="vertices", cmap=TABLE)
    lines = [k for k in system.pieces(hidden="franklin").kinds if k == 2]
    plain = System()
    plain.set_window(-1.2, 1.2, -1.2, 1.2)
    plain.mesh(SQUARE, [[0, 1, 2, 3]])
    assert len(lines) == len(plain.pieces(hidden="franklin").kinds) == 4


def test_picks_of_faces_in_pieces():
    system = System()
    values = [0, 1, 3, 2]
    system.mesh(SQUARE, TRIANGLES, values=values, at="vertices", picks=[7, 4])
    assert set(np.unique(system.draw(40, ids=True).ids)) == {-1, 4, 7}
    by_index = System()
    by_index.mesh(SQUARE, TRIANGLES, values=values, at="vertices")
    assert set(np.unique(by_index.draw(40, ids=True).ids)) == {-1, 0, 1}


@pytest.mark.parametrize(
    "options",
    [
        {"values": [1.0]},
        {"values": [1.0, 2.0, 3.0]},
        {"values": "high"},
        {"values": [[1.0, 2.0]]},
        {"values": [1.0, 2.0], "at": "edges"},
        {"values": [1.0, 2.0], "at": "vertices"},
        {"values": [1.0, 2.0], "fill": "red"},
        {"values": [1.0, 2.0], "fills": ["red", "red"]},
        {"values": [1.0, 2.0], "cmap": "no such map"},
        {"values": [1.0, 2.0], "limits": (2, 1)},
        {"values": [1.0, 2.0], "limits": 3},
        {"values": [1.0, 2.0], "limits": (0, np.inf)},
        {"values": [1.0, np.inf]},
        {"values": [-np.inf, 2.0, 1.0, 0.0], "levels": 3},
        {"values": [1.0, 2.0], "levels": 0},
        {"values": [1.0, 2.0], "levels": [2, 1]},
        {"values": [0, 1, 2, 3], "picks": [1]},
        {"cmap": "viridis"},
        {"limits": (0, 1)},
        {"levels": 4},
        {"at": "faces"},
    ],
)
def test_values_that_are_refused(options):
    system = System()
    with pytest.raises(Error):
        system.mesh(SQUARE, TRIANGLES, **options)
    assert system.segments == []


def test_as_many_faces_as_vertices():
    pyramid = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    with pytest.raises(Error, match="at="):
        System().mesh(pyramid, faces, values=[1, 2, 3, 4])
    of_faces = System()
    of_faces.mesh(pyramid, faces, values=[1, 2, 3, 4], at="faces")
    assert of_faces.polygons == 4


# ---- Bands -------------------------------------------------------------------------------


def area(points: Any, sides: Any) -> float:
    total = 0.0
    for p in np.split(points, np.cumsum(sides)[:-1]):
        total += 0.5 * np.linalg.norm(
            sum((np.cross(p[k] - p[0], p[k + 1] - p[0]) for k in range(1, len(p) - 1)), np.zeros(3))
        )
    return total


def test_bands_tile_their_triangles():
    rng = np.random.default_rng(5)
    for _ in range(200):
        triangle = rng.uniform(-1, 1, (1, 3, 3))
        values = rng.choice([0, 0.25, 0.5, 1, 1.5, 2, 3, 3.5], (1, 3)).astype(float)
        bounds = np.array([0.25, 0.5, 1, 2, 3])
        cut = bands(triangle, values, bounds)
        assert area(cut.points, cut.sides) == pytest.approx(area(triangle[0], [3]), rel=1e-9)
        normal = np.cross(*(triangle[0, 1:] - triangle[0, 0]))
        whole = np.linalg.lstsq(
            np.c_[triangle[0] @ np.c_[normal, triangle[0, 1] - triangle[0, 0]], np.ones(3)],
            values[0],
            rcond=None,
        )
        assert whole is not None
        for p, band in zip(np.split(cut.points, np.cumsum(cut.sides)[:-1]), cut.band):
            assert np.cross(p[1] - p[0], p[2] - p[1]) @ normal > -1e-12
            basis = np.c_[triangle[0].T]
            weights = np.linalg.lstsq(
                np.r_[basis, np.ones((1, 3))], np.r_[p.mean(axis=0), 1], rcond=None
            )[0]
            value = weights @ values[0]
            low = -np.inf if band == 0 else bounds[band]
            high = np.inf if band == len(bounds) - 2 else bounds[band + 1]
            assert low - 1e-9 <= value <= high + 1e-9


def test_neighbours_have_the_same_points_on_their_side():
    rng = np.random.default_rng(6)
    for _ in range(100):
        a, b, c, d = rng.standard_normal((4, 3))
        u, v, w, x = rng.uniform(0, 10, 4)
        bounds = np.arange(11.0)
        first = bands(np.array([[a, b, c]]), np.array([[u, v, w]]), bounds)
        second = bands(np.array([[b, a, d]]), np.array([[v, u, x]]), bounds)

        def on_side(points: Any) -> set[tuple[float, ...]]:
            along = np.cross(points - a, b - a)
            return {tuple(p) for p in points[np.abs(along).max(axis=1) < 1e-12].tolist()}

        assert on_side(first.points) == on_side(second.points)


def test_a_corner_at_a_bound_is_a_corner_of_the_pieces():
    rng = np.random.default_rng(8)
    for _ in range(300):
        triangle = rng.standard_normal((1, 3, 3))
        values = rng.permuted(np.array([[0.0, 2.0, 4.0]]), axis=1)
        points = bands(triangle, values, np.arange(5.0)).points
        for corner in triangle[0]:
            near = np.abs(points - corner).max(axis=1) < 1e-9
            assert near.any() and (points[near] == corner).all()


def test_a_contour_through_a_corner_alone_is_no_line():
    triangles = np.random.default_rng(9).standard_normal((300, 3, 3))
    values = np.tile([0.0, 1.0, 3.0], (300, 1))
    assert len(contours(triangles, values, np.array([3.0]))) == 0
    assert len(contours(triangles, values, np.array([1.0]))) == 300


def test_contours_are_on_the_surface():
    rng = np.random.default_rng(7)
    triangles, values = rng.uniform(-1, 1, (50, 3, 3)), rng.uniform(0, 1, (50, 3))
    lines = contours(triangles, values, np.array([0.3, 0.6]))
    assert len(lines) > 20
    crossed = [((v < level).any() and (v >= level).any()) for level in (0.3, 0.6) for v in values]
    assert len(lines) == sum(crossed)


# ---- Surfaces ----------------------------------------------------------------------------

X, Y = np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 7))
Z = X * Y


def test_contours_that_are_nowhere_are_warned_of():
    system = System()
    with pytest.warns(UserWarning, match="contours: no level is between the values"):
        system.surface(X, Y, Z, contours=[5.0])


def test_filled_contours_and_contours_of_a_surface():
    system = System()
    system.surface(X, Y, Z, levels=5, contours=4, cmap=TABLE)
    system.look(eye=(0, 90), parallel=True)
    fills = set(re.findall("fill solid .*", system.dump()))
    assert len(fills) == 5
    kinds = system.pieces(hidden="map").kinds
    assert (kinds == 2).sum() > 20
    whole = np.diff(system.pieces(hidden="franklin").points.reshape(-1, 2, 3), axis=1)
    flat = System()
    flat.surface(X, Y, Z, contours=[-0.6, -0.2, 0.2, 0.6])
    flat.look(eye=(0, 90), parallel=True)
    expected = np.diff(flat.pieces(hidden="franklin").points.reshape(-1, 2, 3), axis=1)
    length = [np.hypot(*w[:, 0, :2].T).sum() for w in (whole, expected)]
    assert length[0] == pytest.approx(length[1], rel=1e-6)  # no part is hidden by the pieces


@pytest.mark.parametrize("coloured", [{}, {"cmap": TABLE}])
def test_surfaces_are_cropped(coloured):
    system = System()
    system.surface(X, Y, X**2 - Y**2, crop=((-0.5, 0.7), None, (None, 0.3)), **coloured)
    points = system.pieces(hidden="none").points
    box = System()
    box.mesh(
        [(x, y, z) for x in (-0.5, 0.7) for y in (-1, 1) for z in (-1, 0.3)],
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]],
    )
    for one in (system, box):
        one.look(eye=(0, 0), parallel=True, fit=False)
    cropped, within = (
        one.pieces(hidden="none").points[:, [0, 1]] for one in (system, box)
    )
    assert (cropped.min(axis=0) >= within.min(axis=0) - 1e-12).all()
    assert (cropped.max(axis=0) <= within.max(axis=0) + 1e-12).all()
    assert cropped[:, 0].min() == pytest.approx(within[:, 0].min())
    assert len(points)
    after = System()
    after.surface(X, Y, Z, crop=(None, None, (0, None)))
    after.open_segment(9)
    after.box_3(-2, 2, -2, 2, -2, 2)  # which nothing cuts
    after.close_segment()
    assert after.polygons > 6


@pytest.mark.parametrize(
    "options",
    [
        {"crop": 3},
        {"crop": (None, None)},
        {"crop": ((1, 0), None, None)},
        {"crop": ((0, np.nan), None, None)},
        {"crop": ("ab", None, None)},
        {"values": Z[:3]},
        {"contours": 0},
        {"contours": [np.nan]},
        {"contours": "many"},
        {"levels": -1},
    ],
)
def test_surfaces_that_are_refused(options):
    system = System()
    with pytest.raises(Error):
        system.surface(X, Y, Z, **options)
    assert system.segments == []


def test_surfaces_with_holes_in_colours():
    holed = Z.copy()
    holed[3, 4] = np.nan
    system, whole = System(), System()
    system.surface(X, Y, holed, cmap=TABLE, contours=3)
    whole.surface(X, Y, Z, cmap=TABLE, contours=3)
    assert 0 < system.polygons < whole.polygons


# ---- Beside the picture ------------------------------------------------------------------


def test_a_colour_bar_has_the_colours_and_the_numbers():
    system = System()
    system.mesh(SQUARE, TRIANGLES, values=[0.0, 80.0], cmap=TABLE)
    system.colour_bar("heat")
    for size in ((200, 100), (100, 100), (80, 160)):
        picture = system.draw(size, samples=1)[..., :3]
        column = picture[:, int(size[0] * 0.6) :].reshape(-1, 3)
        seen = {tuple(c) for c in column.tolist()}
        assert {tuple(np.rint(255 * c).astype(int).tolist()) for c in TABLE} <= seen
    text = system.svg((400, 300))
    for label in ("heat", ">0<", ">40<", ">80<"):
        assert label in text
    other = System()
    other.mesh(SQUARE, TRIANGLES, values=[0.0, 80.0], cmap=TABLE)
    other.colour_bar(ticks=[10, 25])
    assert ">25<" in other.svg(300) and ">40<" not in other.svg(300)


def test_a_bar_stays_where_the_camera_moves():
    system = System()
    system.mesh(SQUARE, TRIANGLES, values=[0.0, 1.0], cmap=TABLE)
    system.colour_bar()
    before = system.draw((200, 150))
    system.look(eye=(80, 60))
    after = system.draw((200, 150))
    assert np.array_equal(before[:, 180:], after[:, 180:])
    assert not np.array_equal(before[:, :160], after[:, :160])


def test_a_bar_is_not_lit_and_not_hidden():
    system = System()
    system.set_light(1, 0, 0, 0)
    system.set_shadows(True)
    system.mesh(SQUARE, TRIANGLES, values=[0.0, 1.0], cmap=TABLE)
    system.colour_bar()
    seen = {tuple(c) for c in system.draw(200, samples=1)[:, 170:, :3].reshape(-1, 3).tolist()}
    assert {tuple(np.rint(255 * c).astype(int).tolist()) for c in TABLE} <= seen
    by_hand = System()
    by_hand.set_window(-0.1, 0.1, -0.1, 0.1)
    by_hand.mesh(SQUARE + (0, 0, 0.9), TRIANGLES, fill="red")
    by_hand.legend({"green": "lime"})
    assert (0, 255, 0) in {tuple(c) for c in by_hand.draw(200)[..., :3].reshape(-1, 3).tolist()}


def test_what_is_refused_beside():
    system = System()
    with pytest.raises(Error, match="no values"):
        system.colour_bar()
    system.mesh(SQUARE, TRIANGLES, values=[0.0, 1.0])
    for ticks in ([2], "many", [np.nan]):
        with pytest.raises(Error):
            system.colour_bar(ticks=ticks)
    for entries in ({}, [], {"a": "reddish"}, None):
        with pytest.raises(Error):
            system.legend(entries)
    system.open_segment(5)
    with pytest.raises(Error):
        system.legend({"a": "red"})
    system.close_segment()
    system.translate_3(1, 0, 0)
    with pytest.raises(Error, match="modelling"):
        system.legend({"a": "red"})
    system.create_transformation_3()
    with pytest.raises(Error, match="room"):
        for _ in range(9):
            system.legend({"a": "red"})
