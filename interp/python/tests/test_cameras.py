"""Cameras that follow what is entered, and views of a scene from any eye."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from conftest import ring

import displayfile
from displayfile import Error, LimitReached, PicklableSystem, Picture, System, limits

CUBE = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
SIDES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
COLOURS = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1)]


def cubes(*places: Any, size: float = 1.0, **options: Any) -> System:
    system = System(**options)
    for place in places:
        system.mesh(size * CUBE + place, SIDES)
    return system


def box_of(system: System, size: Any = 100) -> tuple[int, int, int, int]:
    """The columns and rows that show something: first and last."""
    seen = (system.draw(size)[..., :3] != 255).any(axis=2)
    columns, rows = np.flatnonzero(seen.any(axis=0)), np.flatnonzero(seen.any(axis=1))
    return columns[0], columns[-1], rows[0], rows[-1]


@pytest.mark.parametrize("place, size", [((0, 0, 0), 1.0), ((1e6, -3e5, 7), 50.0), ((0, 0, 0), 1e-7)])
def test_a_mesh_of_any_size_anywhere_fills_the_picture(place, size):
    first, last, top, bottom = box_of(cubes(place, size=size))
    assert max(last - first, bottom - top) >= 85
    assert first > 0 and top > 0 and last < 99 and bottom < 99


def test_all_that_is_entered_is_seen_in_whatever_order():
    near, far = (0, 0, 0), (40, 0, 3)
    for order in ((near, far), (far, near)):
        system = cubes(*order)
        ids = system.draw(400, ids=True).ids
        assert len(np.unique(ids)) >= 7  # three sides of each, and the background
    system = cubes(near)
    before = system.draw(60)
    system.mesh(CUBE + far, SIDES, segment=7)
    assert (system.draw(60) != before).any()
    system.delete_segment(7)
    assert np.array_equal(system.draw(60), before)


def test_the_camera_may_be_set_before_or_after():
    after = cubes((0, 0, 0), (3, 0, 0))
    after.draw(30)
    after.look(eye=(100, 35), fov=30)
    before = System()
    before.look(eye=(100, 35), fov=30)
    for place in ((0, 0, 0), (3, 0, 0)):
        before.mesh(CUBE + place, SIDES)
    assert np.array_equal(after.draw(80), before.draw(80))
    assert after.dump() == before.dump()


def test_cameras_are_those_of_imported_meshes(tmp_path):
    (tmp_path / "ring.obj").write_text(ring(12, 8))
    lines = (tmp_path / "ring.obj").read_text().splitlines()
    vertices = [list(map(float, line.split()[1:])) for line in lines if line[0] == "v"]
    faces = [[int(k) - 1 for k in line.split()[1:]] for line in lines if line[0] == "f"]
    for camera in (
        {"up": "y"},
        {"up": "z", "eye": (-40, 65)},
        {"up": "x", "eye": (2, 3, 4)},
        {"up": "y", "fov": 40, "eye": (10, 20)},
        {"up": "y", "parallel": True},
        {"up": "-z", "look_at": (0.1, 0.2, 0.3)},
        {"up": "y", "fit": False, "eye": (3, 2, 5)},
    ):
        imported, entered = System(aspect=1.5), System(aspect=1.5)
        imported.set_back_face_removal(False)
        imported.import_mesh(tmp_path / "ring.obj", **camera)
        entered.look(**camera)
        entered.mesh(vertices, faces)
        assert np.array_equal(entered.draw((90, 60)), imported.draw((90, 60)))


def test_pictures_of_any_shape_are_not_stretched():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system = cubes((0, 0, 0))
        wide, high = box_of(system, (300, 100)), box_of(system, (100, 300))
        square = box_of(system, 100)

    def shape(box: tuple[int, int, int, int]) -> float:
        return (box[1] - box[0]) / (box[3] - box[2])

    assert shape(wide) == pytest.approx(shape(square), rel=0.05)
    assert shape(high) == pytest.approx(shape(square), rel=0.05)
    set_by_hand = cubes((0, 0, 0), aspect=1)
    with pytest.warns(UserWarning, match="times as wide"):
        set_by_hand.draw((300, 100))


def test_views_that_are_set_hold():
    def entered(system: System) -> str:
        system.mesh(CUBE, SIDES)
        return system.dump()

    plain = System()
    plain.set_window(-1, 1, -1, 1)
    assert "line-style none" not in entered(plain)
    later = cubes((0, 0, 0))
    fitted = later.dump()
    later.set_perspective(3, 2, 6)
    later.mesh(CUBE, SIDES)
    assert later.dump().startswith(fitted.removesuffix("end\n"))
    with pytest.raises(Error, match="view was set"):
        later.look()
    with pytest.raises(Error):
        later.set_window(1, 0, 0, 1)


def test_subplots():
    system = System()
    system.set_viewport(0, 0.5, 0, 1)
    system.mesh(CUBE, SIDES, fill="red")
    system.set_viewport(0.5, 1, 0, 1)
    system.look(eye=(80, 10))
    system.mesh(1000 * CUBE, SIDES, fill="blue")
    picture = system.draw((200, 100), samples=1).astype(int)
    red, blue = picture[..., 0] > picture[..., 2], picture[..., 2] > picture[..., 0]
    assert red.sum() > 2000 and blue.sum() > 2000
    assert not red[:, 100:].any() and not blue[:, :100].any()


def test_routines_are_followed_too():
    system = System()
    system.look(eye=(20, 30))
    system.open_segment(1)
    system.box_3(100, 110, 0, 5, 0, 5)
    system.set_line_style("solid", 0, 0, 0)
    system.axes_3(100, 110, 0, 5, 0, 5)
    system.close_segment()
    first, last, top, bottom = box_of(system)
    assert last - first > 70 and first > 0 and last < 99


def test_a_mesh_may_be_entered_into_an_open_segment():
    system = System()
    system.open_segment(3)
    assert system.mesh(CUBE + 50, SIDES) == 3
    system.close_segment()
    assert np.array_equal(system.draw(50), cubes((50, 50, 50)).draw(50))
    mixed = System()
    mixed.open_segment(1)
    mixed.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    before = mixed.dump()
    mixed.mesh(CUBE, SIDES)
    assert mixed.dump().startswith(before.removesuffix("end\n"))


def test_what_is_recorded_makes_the_same():
    system = System()
    system.record()
    system.mesh(CUBE, SIDES, fills=COLOURS)
    system.look(eye=(50, 50), fov=25)
    system.mesh(CUBE + 3, SIDES, fill="tan")
    system.legend({"tan": "tan"})
    again = System()
    again.replay(system.recording)
    assert again.dump() == system.dump()
    system.set_viewport(0, 0.5, 0, 0.5)
    system.mesh(CUBE - 7, SIDES)
    again = System()
    again.replay(system.recording)
    assert again.dump() == system.dump()


def test_calls_are_noted():
    system = PicklableSystem()
    system.look(eye=(40, 10))
    system.mesh(CUBE, SIDES, values=np.arange(6.0))
    system.colour_bar("v")
    assert system.calls.system().dump() == system.dump()


@pytest.mark.parametrize(
    "camera",
    [
        {"eye": (1, 2, 3, 4)},
        {"eye": (0, 91)},
        {"eye": "left"},
        {"up": "w"},
        {"fov": 0},
        {"fov": 180},
        {"fov": 20, "parallel": True},
        {"parallel": "yes"},
        {"look_at": (0, 0)},
        {"eye": (0.5, 0.5, 0.5)},
        {"eye": (0, 0, 0), "look_at": (0, 0, 0)},
    ],
)
def test_cameras_that_are_refused_change_nothing(camera):
    system = cubes((0, 0, 0))
    before = system.dump()
    with pytest.raises(Error):
        system.look(**camera)
    assert system.dump() == before
    with pytest.raises(Error):
        system.views(20).draw(**camera)


def test_cameras_where_there_can_be_none():
    system = System()
    system.open_segment(1)
    with pytest.raises(Error, match="open"):
        system.look()
    system.close_segment()
    with pytest.raises(Error):
        system.look()  # what is there was not retained
    with pytest.raises(Error):
        system.views()
    retained = System(retain=True)
    retained.open_segment(1)
    retained.box_3(10, 20, 0, 1, 0, 1)
    retained.close_segment()
    retained.look()
    assert box_of(retained)[1] - box_of(retained)[0] > 80


def test_a_mesh_that_is_refused_begins_nothing():
    system = System()
    with pytest.raises(Error):
        system.mesh(CUBE * 1e200, SIDES)
    with limits(bytes=0), pytest.raises((Error, LimitReached)):
        system.surface(range(3), range(3), np.zeros((3, 3)))
    assert system.segments == []
    plain = System()
    for other in (system, plain):
        other.open_segment(1)
        other.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
        other.close_segment()
    assert system.dump() == plain.dump()


# ---- Views -------------------------------------------------------------------------------

EYES = [(0, 0), (30, 20), (-120, 70), (200, -40), (10, 90)]


@pytest.mark.parametrize("hidden", [None, "z-buffer", "scan-line", "bsp"])
def test_views_are_what_the_system_would_draw(hidden):
    system = cubes((0, 0, 0), (1.5, 0, 0))
    views = system.views((60, 40), hidden=hidden)
    for eye in EYES:
        system.look(eye=eye)
        drawn, expected = views.draw(eye), system.draw((60, 40), hidden=hidden)
        off = np.abs(drawn.astype(int) - expected.astype(int)).max(axis=2)
        assert (off > 2).sum() == 0, eye  # the light is turned, and rounded


def test_views_have_the_camera_of_look_where_they_set_none():
    system = cubes((0, 0, 0))
    system.look(eye=(70, 15), fov=20)
    views = system.views(50)
    assert np.array_equal(views.draw(), system.draw(50))
    system.look(eye=(10, 15), fov=20)
    assert np.array_equal(views.draw((10, 15)), system.draw(50))
    system.look(eye=(10, 15), parallel=True)
    assert np.array_equal(views.draw((10, 15), parallel=True), system.draw(50))


def test_views_are_of_what_the_system_had(tmp_path):
    system = cubes((0, 0, 0))
    views = system.views(40, ids=True)
    before = views.draw((5, 5))
    assert isinstance(before, Picture) and isinstance(views.picture((5, 5)), Picture)
    system.mesh(CUBE + 9, SIDES)
    assert np.array_equal(views.draw((5, 5)).ids, before.ids)
    views.save(tmp_path / "view.svg", (5, 5))
    assert (tmp_path / "view.svg").read_text().endswith("</svg>\n")
    with pytest.raises(Error):
        views.save(tmp_path / "view.bmp", (5, 5))
    with pytest.raises(TypeError):
        views.draw((5, 5), fast=True)


def test_lights_of_views():
    system = cubes((0, 0, 0))
    views = system.views(40)
    assert len({tuple(views.draw(eye)[20, 20]) for eye in ((0, 0), (180, 0))}) == 1  # it turns along
    lit = System()
    lit.set_light(0, -1, 0)
    lit.mesh(CUBE, SIDES)
    views = lit.views(40)
    assert views.draw((0, 0))[20, 20, 0] > views.draw((180, 0))[20, 20, 0] + 50


def test_what_stands_beside_is_not_in_views():
    system = cubes((0, 0, 0))
    system.legend({"one": "red"})
    with pytest.warns(UserWarning, match="legends"):
        views = system.views(60)
    assert (views.draw()[:, 52:] == 255).all()


def test_a_turntable_of_what_a_camera_follows():
    system = cubes((5, 5, 5))
    turned = system.turntable(4, 60)
    for k in range(4):
        seen = (turned.draw(k)[..., :3] != 255).any(axis=2)
        assert seen.sum() > 500 and not seen[[0, -1]].any() and not seen[:, [0, -1]].any()


def test_names():
    assert repr(System()) == "<System: 0 segments, 0 polygons>"
    assert repr(cubes((0, 0, 0))) == "<System: 1 segment, 6 polygons, seen by a camera>"
    assert displayfile.Views is type(cubes((0, 0, 0)).views(8))
