"""Meshes and surfaces as arrays."""

from __future__ import annotations

import numpy as np
import pytest

from displayfile import Error, System

VERTICES = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)], float)
QUAD_AND_TRIANGLES = [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
TRIANGLES = QUAD_AND_TRIANGLES[1:]


def usual() -> System:
    """With the usual view set, so that none is fitted and looks are those in force."""
    g = System()
    g.set_window(-1, 1, -1, 1)
    return g


def entered_one_by_one(faces) -> str:
    g = usual()
    g.open_segment(1)
    for face in faces:
        g.polygon_abs_3(VERTICES[face])
    g.close_segment()
    return g.dump()


def dump_of(vertices, faces, **options) -> str:
    g = usual()
    assert g.mesh(vertices, faces, **options) == 1
    return g.dump()


@pytest.mark.parametrize("type", [np.float64, np.float32, np.float16, int, ">f8"])
def test_vertices_of_any_type(type):
    vertices = np.round(VERTICES * 2).astype(type)
    g = usual()
    g.open_segment(1)
    for face in TRIANGLES:
        g.polygon_abs_3(vertices[face].astype(float))
    g.close_segment()
    assert dump_of(vertices, TRIANGLES) == g.dump()


def test_vertices_in_any_order_of_memory():
    expected = entered_one_by_one(TRIANGLES)
    wide = np.zeros((5, 7))
    wide[:, 2:5] = VERTICES
    unaligned = np.frombuffer(b"x" + VERTICES.tobytes(), np.uint8)[1:].view(float).reshape(5, 3)
    for vertices in (np.asfortranarray(VERTICES), wide[:, 2:5], VERTICES.tolist(), unaligned):
        assert dump_of(vertices, TRIANGLES) == expected


@pytest.mark.parametrize("type", [np.int64, np.int32, np.uint32, np.uint64, np.uint8, ">i4"])
def test_indices_of_any_type(type):
    assert dump_of(VERTICES, np.array(TRIANGLES, type)) == entered_one_by_one(TRIANGLES)


def test_faces_of_any_length():
    expected = entered_one_by_one(QUAD_AND_TRIANGLES)
    assert dump_of(VERTICES, QUAD_AND_TRIANGLES) == expected
    assert dump_of(VERTICES, tuple(map(np.array, QUAD_AND_TRIANGLES))) == expected
    corners = sum(QUAD_AND_TRIANGLES, [])
    assert dump_of(VERTICES, corners, sides=[4, 3, 3, 3, 3]) == expected
    quads = np.array([[0, 1, 2, 3]])
    assert dump_of(VERTICES, quads) == entered_one_by_one(quads)


def test_fills_and_picks():
    g, one = usual(), usual()
    colours = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.1, 0.2, 0.3]])
    g.mesh(VERTICES, TRIANGLES, fills=colours, picks=[5, 6, 7, 8], segment=4)
    one.open_segment(4)
    for face, colour, pick in zip(TRIANGLES, colours, [5, 6, 7, 8]):
        one.set_fill_style("solid", colour)
        one.set_pick_id(pick)
        one.polygon_abs_3(VERTICES[face])
    one.close_segment()
    assert g.dump() == one.dump()
    assert "fill hollow" in dump_of(VERTICES, TRIANGLES, fill="hollow")
    assert "fill solid 1 0.5 0" in dump_of(VERTICES, TRIANGLES, fill=(1, 0.5, 0))


COLOURS = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0.25, 0.5, 0.75)])


def test_colours_of_vertices():
    g = usual()
    g.open_segment(1)
    for face in QUAD_AND_TRIANGLES:
        g.set_vertex_colours(COLOURS[face])
        g.polygon_abs_3(VERTICES[face])
    g.close_segment()
    for fills in (COLOURS, ["red", "lime", "#0000ff", (1, 1, 0), (0.25, 0.5, 0.75)]):
        assert dump_of(VERTICES, QUAD_AND_TRIANGLES, fills=fills, at="vertices") == g.dump()
    # There are as many faces as vertices: fills are of faces unless at is set.
    of_faces = dump_of(VERTICES, QUAD_AND_TRIANGLES, fills=COLOURS)
    assert of_faces == dump_of(VERTICES, QUAD_AND_TRIANGLES, fills=COLOURS, at="faces")
    assert of_faces.count("polygon") == 5


def test_colours_of_vertices_are_shaded_smoothly():
    def drawn(**colours):
        g = System()
        g.set_light(1, -2, 3)
        g.set_shading("phong")
        g.mesh(VERTICES, TRIANGLES, **colours)
        return g.draw(80).astype(int)

    nearly_grey = np.full((5, 3), 0.5)
    nearly_grey[0] += 0.02
    in_pieces = drawn(fills=nearly_grey, at="vertices")
    assert np.abs(in_pieces - drawn(fill=(0.5, 0.5, 0.5))).max() <= 6


def test_masked_numbers_are_not_known():
    heights = np.ma.array(np.arange(9.0).reshape(3, 3) / 9, mask=np.eye(3)[::-1] * [[1, 0, 0]])
    known = [np.linspace(-1, 1, 3)] * 2
    masked, hole = usual(), usual()
    masked.surface(*known, heights)
    hole.surface(*known, heights.filled(np.nan))
    assert masked.dump() == hole.dump()
    assert masked.polygons < 8
    assert dump_of(np.ma.array(VERTICES), TRIANGLES) == entered_one_by_one(TRIANGLES)
    for vertices, faces in (
        (np.ma.array(VERTICES, mask=VERTICES > 0.9), TRIANGLES),
        (VERTICES, np.ma.array(TRIANGLES, mask=np.array(TRIANGLES) == 4)),
    ):
        with pytest.raises(Error):
            dump_of(vertices, faces)


def test_normals():
    g = System()
    g.set_light(1, 1, 1)
    g.set_shading("gouraud")
    g.mesh(VERTICES, TRIANGLES, normals=VERTICES - 0.5)
    assert "intensities" in g.dump()


def test_segments():
    g = System()
    g.open_segment(7)
    assert g.mesh(VERTICES, TRIANGLES) == 7
    assert g.open_segment_name == 7
    g.close_segment()
    assert g.mesh(VERTICES, TRIANGLES) == 8
    assert g.mesh(VERTICES, TRIANGLES, segment=3) == 3
    assert g.segments == [7, 8, 3]
    assert g.open_segment_name is None


@pytest.mark.parametrize(
    "vertices, faces, options",
    [
        (VERTICES[:, :2], TRIANGLES, {}),
        (VERTICES.ravel(), TRIANGLES, {}),
        (VERTICES.astype(complex), TRIANGLES, {}),
        (VERTICES.astype(str), TRIANGLES, {}),
        ("vertices", TRIANGLES, {}),
        (None, TRIANGLES, {}),
        ([[0, 0, 0], [1, 0]], TRIANGLES, {}),
        (VERTICES * np.nan, TRIANGLES, {}),
        (VERTICES + np.inf, TRIANGLES, {}),
        (VERTICES * 1e200, TRIANGLES, {}),
        (VERTICES, [[0, 1, 5]], {}),
        (VERTICES, [[0, 1, -1]], {}),
        (VERTICES, [[0, 1, 2**32]], {}),
        (VERTICES, np.array([[0, 1, 2**64 - 1]], np.uint64), {}),
        (VERTICES, [[0, 1]], {}),
        (VERTICES, [[0, 1], [0, 1, 2]], {}),
        (VERTICES, [[0, 1, 2, 3], [0, 1, 9]], {}),
        (VERTICES, [[0.0, 1.0, 2.0]], {}),
        (VERTICES, np.zeros((2, 3), bool), {}),
        (VERTICES, np.zeros((1, 3, 3), int), {}),
        (VERTICES, [0, 1, 2], {}),
        (VERTICES, "faces", {}),
        (VERTICES, None, {}),
        (VERTICES, [[0, 1, "2"], [1, 2]], {}),
        (VERTICES, [0, 1, 2], {"sides": [4]}),
        (VERTICES, [0, 1, 2], {"sides": [2]}),
        (VERTICES, [0, 1, 2, 3], {"sides": [-3, 7]}),
        (VERTICES, TRIANGLES, {"fill": (1, 0)}),
        (VERTICES, TRIANGLES, {"fill": (1, 0, 2)}),
        (VERTICES, TRIANGLES, {"fill": "reddish"}),
        (VERTICES, TRIANGLES, {"fills": [(1, 0, 0)]}),
        (VERTICES, TRIANGLES, {"fills": np.full((4, 3), 1.5)}),
        (VERTICES, TRIANGLES, {"fill": (1, 0, 0), "fills": np.zeros((4, 3))}),
        (VERTICES, TRIANGLES, {"fills": COLOURS[:4], "at": "vertices"}),
        (VERTICES, TRIANGLES, {"fills": COLOURS, "at": "corners"}),
        (VERTICES, TRIANGLES, {"fills": 1.5 * COLOURS, "at": "vertices"}),
        (VERTICES, TRIANGLES, {"fill": (1, 0, 0), "fills": COLOURS, "at": "vertices"}),
        (VERTICES, TRIANGLES, {"at": "vertices"}),
        (VERTICES, TRIANGLES, {"picks": [1]}),
        (VERTICES, TRIANGLES, {"picks": [1, 2, 3, -4]}),
        (VERTICES, TRIANGLES, {"picks": [1, 2, 3, 2**31]}),
        (VERTICES, TRIANGLES, {"normals": VERTICES[:2]}),
        (VERTICES, TRIANGLES, {"segment": 0}),
        (VERTICES, TRIANGLES, {"segment": 9}),
        (VERTICES, TRIANGLES, {"segment": "one"}),
    ],
)
def test_what_is_refused_leaves_nothing(vertices, faces, options):
    g = System()
    g.mesh(VERTICES, TRIANGLES, segment=9)
    before = g.dump()
    with pytest.raises(Error):
        g.mesh(vertices, faces, **options)
    assert g.dump() == before
    assert g.open_segment_name is None
    assert g.mesh(VERTICES, TRIANGLES) == 10


def test_empty_meshes():
    g = System()
    assert g.mesh(np.zeros((0, 3)), np.zeros((0, 3), int)) == 1
    assert g.mesh(VERTICES, []) == 2
    assert g.polygons == 0


# ---- Surfaces ----------------------------------------------------------------------------

X, Y = np.linspace(-1, 1, 5), np.linspace(0, 1, 4)
Z = np.sin(X)[None, :] * Y[:, None]


def test_a_surface_over_an_even_grid():
    g, routine = usual(), usual()
    g.surface(X, Y, Z)
    routine.open_segment(1)
    routine.surface_3(-1, 1, 5, 0, 1, 4, Z)
    routine.close_segment()
    expected = routine.dump()
    assert g.dump() == expected
    for x, y, z in (
        (*np.meshgrid(X, Y), Z),
        (X[::-1], Y, Z[:, ::-1]),
        (X, Y[::-1], Z[::-1]),
        (X.tolist(), Y.tolist(), Z.tolist()),
    ):
        other = usual()
        other.surface(x, y, z)
        assert other.dump() == expected


def test_a_surface_over_an_uneven_grid():
    x = X**3
    g, mesh = usual(), usual()
    g.surface(x, Y, Z)
    points = np.stack([*np.meshgrid(x, Y), Z], axis=-1).reshape(-1, 3)
    k = np.arange(20).reshape(4, 5)
    cells = np.stack([k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]], axis=-1).reshape(-1, 4)
    mesh.mesh(points, cells)
    assert g.dump() == mesh.dump()


def test_a_surface_over_points_anywhere():
    r, a = np.meshgrid(np.linspace(0.2, 1, 4), np.linspace(0, 2 * np.pi, 9))
    g = System()
    g.surface(r * np.cos(a), r * np.sin(a), r)
    assert g.polygons == 3 * 8


def test_holes():
    holed = Z.copy()
    holed[1, 1] = np.nan
    for x in (X, X**3):
        whole, with_hole = System(), System()
        whole.surface(x, Y, Z)
        with_hole.surface(x, Y, holed)
        assert 0 < with_hole.polygons < whole.polygons


@pytest.mark.parametrize(
    "x, y, z",
    [
        (X, Y, Z.T),
        (X[:-1], Y, Z),
        (X, Y, Z[0]),
        (X[:1], Y[:1], Z[:1, :1]),
        (X, np.meshgrid(X, Y)[1], Z),
        (X * np.nan, Y, Z),
        (X, Y, Z + np.inf),
        (X, Y, "z"),
        ("x", Y, Z),
        (X, Y, Z.astype(complex)),
        (X * 1e200, Y, Z),
    ],
)
def test_surfaces_that_are_refused(x, y, z):
    g = System()
    with pytest.raises(Error):
        g.surface(x, y, z)
    assert g.segments == []
    assert g.open_segment_name is None
