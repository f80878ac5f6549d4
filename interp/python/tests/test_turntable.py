"""Turntables: their views are those of the command, byte for byte; meshes seen by a camera."""

from __future__ import annotations

import base64
import re
import threading
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, ring

import displayfile
from displayfile import Error, System

SIZE = (60, 50)


@pytest.fixture
def mesh(tmp_path: Path) -> Path:
    path = tmp_path / "ring.obj"
    path.write_text(ring(18, 10))
    return path


def retained(mesh: Path, **camera: object) -> System:
    system = System(aspect=SIZE[0] / SIZE[1], retain=True)
    system.import_mesh(mesh, **camera)
    return system


CAMERAS = [
    ("", {}),
    ("--up z --eye 40,25", {"up": "z", "eye": (40, 25)}),
    ("--fov 30 --look-at 0,0.1,0", {"fov": 30, "look_at": (0, 0.1, 0), "turning": True}),
    ("--fov 40", {"fov": 40.0, "turning": True}),
    ("--parallel --eye -20,70", {"parallel": True, "eye": [-20, 70]}),
    ("--no-fit --eye 3,2,5", {"fit": False, "eye": np.array([3.0, 2.0, 5.0])}),
]


@pytest.mark.parametrize("words, camera", CAMERAS, ids=lambda of: str(of) if of else "plain")
def test_views_of_a_mesh_are_the_commands(words, camera, mesh, command, tmp_path):
    done = command("draw", mesh, "-o", "t.ppm", "--turntable", 7, "--size", "60x50", *words.split())
    assert done.returncode == 0, done.stderr
    views = retained(mesh, **camera).turntable(7, SIZE)
    assert len(views) == 7
    assert views.save(tmp_path / "p.ppm", (2, 5)) == [
        str(tmp_path / f"p-00{k}.ppm") for k in (2, 3, 4)
    ]
    for k in (2, 3, 4):
        expected = (tmp_path / f"t-00{k}.ppm").read_bytes()
        assert (tmp_path / f"p-00{k}.ppm").read_bytes() == expected
        assert views.draw(k)[..., :3].tobytes() == expected[len(b"P6\n60 50\n255\n") :]
    assert not (tmp_path / "p-001.ppm").exists()


@pytest.mark.parametrize("words, camera", CAMERAS[1:], ids=lambda of: str(of) if of else "plain")
def test_one_view_of_a_mesh_is_the_commands(words, camera, mesh, command, tmp_path):
    done = command("draw", mesh, "-o", "t.ppm", "--size", "60x50", *words.split())
    assert done.returncode == 0, done.stderr
    system = System(aspect=SIZE[0] / SIZE[1])
    system.import_mesh(mesh, **{**camera, "turning": False})
    assert system.ppm(SIZE, hidden="auto") == (tmp_path / "t.ppm").read_bytes()


@pytest.mark.parametrize("method", ["z-buffer", "bsp", "world-ray-cast", "scan-line", "franklin"])
def test_methods(method, command, tmp_path):
    program = ROOT / "programs" / "cyclic-overlap.draw"
    done = command(
        "draw", program, "-o", "t.ppm", "--turntable", 3, "--size", "60x50", "--hidden", method
    )
    assert done.returncode == 0, done.stderr
    system = System(aspect=SIZE[0] / SIZE[1], retain=True)
    system.replay_file(program)
    views = system.turntable(3, SIZE, hidden=method)
    assert views.save(tmp_path / "p.ppm") == [str(tmp_path / f"p-00{k}.ppm") for k in range(3)]
    for k in range(3):
        assert (tmp_path / f"p-00{k}.ppm").read_bytes() == (tmp_path / f"t-00{k}.ppm").read_bytes()


def test_ids_and_depth(mesh, command, tmp_path):
    done = command(
        *("draw", mesh, "-o", "t.ppm", "--turntable", 3, "--size", "60x50", "--hidden", "z-buffer"),
        *("--ids", "i.npy", "--depth", "d.npy"),
    )
    assert done.returncode == 0, done.stderr
    picture = retained(mesh).turntable(3, SIZE, hidden="z-buffer", ids=True, depth=True).draw(2)
    assert isinstance(picture, displayfile.Picture)
    assert np.array_equal(picture.ids, np.load(tmp_path / "i-002.npy"))
    assert np.array_equal(picture.depth, np.load(tmp_path / "d-002.npy"))
    alone = retained(mesh).turntable(3, SIZE, ids=True).draw(2)
    assert alone.depth is None and alone.ids.shape == (50, 60)


def test_axes_and_windows_are_what_is_said(mesh):
    system = retained(mesh)
    plain = system.turntable(5, SIZE, hidden="z-buffer").draw(1)
    about_up = system.turntable(5, SIZE, hidden="z-buffer", axis=(0, 2, 0)).draw(1)
    assert np.array_equal(plain, about_up)
    about_right = system.turntable(5, SIZE, hidden="z-buffer", axis=(1, 0, 0)).draw(1)
    assert not np.array_equal(plain, about_right)
    plank = System(retain=True)
    plank.set_window(-1, 1, -1, 1)
    plank.mesh([(0.2, 0, 0), (0.9, 0, 0.1), (0.9, 0.4, 0.1), (0.2, 0.4, 0)], [(0, 1, 2, 3)])
    whole = plank.turntable(4, 32, fit=True)
    assert all((whole.draw(k)[[0, -1]] == 255).all() for k in range(4))
    assert (whole.draw(0) != plank.turntable(4, 32).draw(0)).any()


def test_a_turntable_is_of_what_the_system_had(mesh):
    system = retained(mesh)
    views = system.turntable(4, SIZE, hidden="z-buffer")
    trees = system.turntable(4, SIZE)
    before = [views.draw(k) for k in range(4)], [trees.draw(k) for k in range(4)]
    system.set_visibility(1, False)
    system.delete_all_segments()
    del system
    assert all(np.array_equal(views.draw(k), before[0][k]) for k in range(4))
    assert all(np.array_equal(trees.draw(k), before[1][k]) for k in range(4))


def test_what_is_refused_does_not_turn(mesh):
    system = retained(mesh)
    before = system.turntable(4, SIZE, hidden="z-buffer").draw(1)
    with pytest.raises(Error):
        system.replay("open-segment 7\npolygon-abs-3 0 0 0 5 0 0 0 5 0\nclose-segment\nnonsense\n")
    assert np.array_equal(system.turntable(4, SIZE, hidden="z-buffer").draw(1), before)


def test_threads_draw_in_turn(mesh):
    views = retained(mesh).turntable(8, SIZE, hidden="z-buffer")
    expected = [views.draw(k) for k in range(8)]
    same: list[bool] = []

    def work(first: int) -> None:
        for k in range(first, first + 16):
            same.append(np.array_equal(views.draw(k % 8), expected[k % 8]))

    threads = [threading.Thread(target=work, args=(first,)) for first in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(same) == 64 and all(same)


def test_what_is_refused(mesh, tmp_path):
    system = retained(mesh)
    for said in (
        {"views": 0},
        {"views": 10001},
        {"views": 2.5},
        {"views": 3, "size": 0},
        {"views": 3, "hidden": "depth-sort"},
        {"views": 3, "hidden": "magic"},
        {"views": 3, "axis": (0, 0, 0)},
        {"views": 3, "axis": (0, 1)},
        {"views": 3, "fit": "well"},
        {"views": 3, "lines": "outline"},
        {"views": 3, "colour": 1},
    ):
        with pytest.raises(Error):
            system.turntable(**said)
    views = system.turntable(3, SIZE)
    for view in (-1, 3, "0", 0.5):
        with pytest.raises(Error):
            views.draw(view)
    for path, only in (
        ("t.bmp", None),
        ("nowhere/t.png", None),
        ("t.png", (2, 2)),
        ("t.png", (0, 4)),
        ("t.png", (-1, 2)),
        ("t.png", ("0", 2)),
        ("t.png", (0, 1, 2)),
        ("t.png", 2),
    ):
        with pytest.raises(Error):
            views.save(tmp_path / path, only)
    assert list(tmp_path.iterdir()) == [mesh]
    with pytest.raises(Error, match=r"System\(retain=True\)"):
        System().turntable(3)
    system.open_segment(9)
    with pytest.raises(Error, match="segment 9 is open"):
        system.turntable(3)
    other = retained(mesh)
    other.set_window(0, 1, 0, 1)
    other.mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    with pytest.raises(Error, match="different views"):
        other.turntable(3)


@pytest.mark.parametrize(
    "camera",
    [
        {"eye": (1, 95)},
        {"eye": 3},
        {"eye": "front"},
        {"eye": (1, 2, 3, 4)},
        {"look_at": (1, 2)},
        {"up": "w"},
        {"up": 3},
        {"fov": 0},
        {"fov": 180},
        {"fov": "wide"},
        {"fov": 30, "parallel": True},
        {"parallel": "maybe"},
        {"fit": 2},
    ],
)
def test_cameras_that_are_refused(camera, mesh):
    system = System()
    with pytest.raises(Error):
        system.import_mesh(mesh, **camera)
    assert system.segments == []


def test_a_camera_needs_a_view_that_nobody_set(mesh):
    system = System()
    system.set_perspective(3, 2, 6)
    with pytest.raises(Error, match="view was not set before"):
        system.import_mesh(mesh, eye=(30, 20, 5))
    system.import_mesh(mesh)
    assert system.segments == [1]


def test_draws_surfaces_in_curves() -> None:
    system = System(retain=True)
    system.set_perspective(3, 4, 6)
    system.set_window(-3, 3, -3, 3)
    system.rotate_x_3(-90)
    system.open_segment(1)
    system.surface_3(-1, 1, 3, -1, 1, 3, 0, 0.1, 0, 0.2, 0.5, 0.1, 0, 0.3, 0)
    system.close_segment()
    turned = system.turntable(3, 100, hidden="perimeter")
    assert np.array_equal(turned.draw(0), system.draw(100, hidden="perimeter"))


# ---- In notebooks ------------------------------------------------------------------------


def test_a_notebook_turns_it_by_a_slider(mesh):
    table = retained(mesh).turntable(5, SIZE)
    page = table._repr_html_()
    images = re.findall(r'<img [^>]*src="data:image/png;base64,([^"]*)"([^>]*)>', page)
    assert len(images) == 5
    assert ["display:none" in style for _, style in images] == [False, True, True, True, True]
    for view, (data, _) in enumerate(images):
        expected = displayfile._displayfile._png_of(table.draw(view))
        assert base64.b64decode(data) == expected
    assert table._repr_png_() == displayfile._displayfile._png_of(table.draw(0))
    assert re.search(r'<input type="range" min="0" max="4" value="0"', page)


def test_a_notebook_does_not_hold_views_that_are_large(mesh, monkeypatch):
    table = retained(mesh).turntable(5, SIZE)
    size = sum(len(displayfile._displayfile._png_of(table.draw(k))) for k in range(5))
    for most, is_shown in ((size, True), (size - 1, False)):
        monkeypatch.setattr(displayfile._turntable, "_MOST_BYTES", most)
        assert (table._repr_html_() is not None) == is_shown
