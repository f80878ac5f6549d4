"""Pictures: their arrays, options, what is refused; notebooks; what importing loads."""

from __future__ import annotations

import gc
import importlib.metadata
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import displayfile
from displayfile import Error, System


@pytest.fixture
def g() -> System:
    system = System()
    system.set_fill_style("solid", 1, 0, 0)
    system.set_line_style("none")
    system.open_segment(4)
    system.set_pick_id(9)
    system.polygon_abs_2([(-1, -1), (0, -1), (0, 1), (-1, 1)])
    system.close_segment()
    return system


def test_pixels_are_red_green_blue_alpha(g):
    pixels = g.draw((8, 4))
    assert pixels.shape == (4, 8, 4) and pixels.dtype == np.uint8
    assert (pixels[:, :4] == (255, 0, 0, 255)).all()
    assert (pixels[:, 4:] == (255, 255, 255, 255)).all()
    assert (g.draw(4, background="none")[:, 2:] == 0).all()
    assert (g.draw(4, background=(0, 0, 1))[:, 2:] == (0, 0, 255, 255)).all()


def test_ids_and_depth(g):
    pixels, ids, depth = g.draw(4, ids=True, depth=True)
    assert ids.dtype == np.int32 and depth.dtype == np.float64
    assert (ids == [[9, 9, -1, -1]] * 4).all()
    assert np.isneginf(depth[:, 2:]).all() and np.isfinite(depth[:, :2]).all()
    picture = g.draw(4, depth=True)
    assert picture.ids is None and picture.depth.shape == (4, 4)


def test_pixels_are_antialiased_unless_one_sample_is_set(g):
    usual = g.draw(5, ids=True)  # the square ends in the middle of a column
    assert (usual.pixels[:, 2] == (255, 128, 128, 255)).all()
    assert (usual.pixels[:, :2] == (255, 0, 0, 255)).all()
    assert np.array_equal(usual.pixels, g.draw(5, samples=4))
    assert np.array_equal(usual.pixels, g.draw(5, samples=None))
    one = g.draw(5, ids=True, samples=1)
    assert set(one.pixels[:, 2, 1].tolist()) <= {0, 255}
    assert np.array_equal(usual.ids, one.ids)


def test_pictures_live_by_themselves(g):
    first = g.draw(64)
    kept = first.copy()
    g.set_visibility(4, False)
    second = g.draw(64)
    assert np.array_equal(first, kept)
    assert not np.array_equal(first, second)
    first[:] = 7
    assert (g.draw(64) == 255).all()
    view = g.draw(64)[3:5]
    del g
    gc.collect()
    assert (view == 255).all() and (second == 255).all()


def test_memory_that_is_used_again_shows_nothing_old(g):
    for size in (64, 16, 128):
        g.set_visibility(4, True)
        del_me = g.draw(size)
        del del_me
        g.set_visibility(4, False)
        assert (g.draw(size) == 255).all()


def test_pick(g):
    assert g.pick(1, 1, 8) == displayfile.Pick("polygon", 9, 4, g.pick(1, 1, 8).depth)
    assert g.pick(6, 1, 8) is None
    for x, y in ((float("nan"), 0), ("left", 0), (None, 0)):
        with pytest.raises(Error):
            g.pick(x, y)
    with pytest.raises(Error):
        g.pick(1, 1, reach=-1)


def test_pick_is_what_the_picture_shows():
    g = displayfile.System()
    for name, z in ((1, 0.5), (2, -0.5)):
        g.open_segment(name)
        g.polygon_abs_3([(-1, -1, z), (1, -1, z), (1, 1, z), (-1, 1, z)])
        g.close_segment()
    for hidden in (None, "none", "back-face", "bsp", "z-buffer", "plain-z-buffer"):
        ids = g.draw(8, ids=True, hidden=hidden)[1]
        assert g.pick(3, 3, 8, hidden=hidden).id == ids[3, 3]
    assert g.pick(3, 3, 8, hidden="none").segment == 2
    assert g.pick(3, 3, 8, hidden="bsp", scope="all").segment == 1
    assert g.pick(3, 3, 8, hidden="bsp", scope="segment").segment == 2


def test_pieces(g):
    pieces = g.pieces()
    assert pieces.kinds.tolist() == [0] and pieces.first.tolist() == [0, 4]
    assert pieces.picks.tolist() == [9] and pieces.segments.tolist() == [4]
    assert pieces.fills.tolist() == [[1, 0, 0]]
    assert pieces.points[:, :2].max(axis=0).tolist() == [0.5, 1]
    assert len(g.pieces(hidden="franklin").kinds) == 0  # there are no lines
    # Behind it:
    g.open_segment(5)
    g.set_pick_id(8)
    g.polygon_abs_3([(-0.9, -0.9, -0.5), (-0.1, -0.9, -0.5), (-0.1, 0.9, -0.5)])
    g.close_segment()
    assert g.pieces(hidden="map").picks.tolist() == [9]
    assert g.pieces(hidden="auto").picks.tolist() == [9]
    assert g.pieces(hidden="depth-sort").picks.tolist() == [8, 9]


def test_formats(g, tmp_path):
    assert g.png(8).startswith(b"\x89PNG")
    assert g.eps(8).startswith(b"%!PS")
    assert g.svg(8).endswith("</svg>\n")
    g.save(tmp_path / "a.png", 8)
    assert (tmp_path / "a.png").read_bytes() == g.png(8)
    g.save(tmp_path / "picture", 8, format="ppm")
    assert (tmp_path / "picture").read_bytes() == g.ppm(8)


@pytest.mark.parametrize(
    "size",
    [
        0,
        -1,
        65536,
        2**40,
        1.5,
        "8",
        None,
        (8,),
        (8, 8, 8),
        (8, 0),
        ("8", 8),
        True,
        [],
        np.zeros(0),
        {},
    ],
)
def test_sizes_that_are_refused(g, size):
    for draw in (g.draw, g.svg, g.png):
        if size is None and draw != g.draw:
            continue  # that of the paper, or the usual one
        with pytest.raises(Error):
            draw(size)


@pytest.mark.parametrize(
    "option, value",
    [
        ("hidden", "magic"),
        ("hidden", 5),
        ("hidden_lines", "dotted"),
        ("line_order", "deep"),
        ("line_order", 5),
        ("line_halo", -1),
        ("line_halo", 2),
        ("line_halo", "wide"),
        ("lines", "outline"),
        ("lines", "wavy"),
        ("scope", "world"),
        ("precision", "roundoff=2"),
        ("background", (1, 2, 3)),
        ("background", "reddish"),
        ("background", (1, 0)),
        ("background", (float("nan"), 0, 0)),
        ("samples", 0),
        ("samples", "many"),
        ("threads", 0),
        ("device", "plotter"),
        ("ids", "yes"),
    ],
)
def test_options_that_are_refused(g, option, value):
    before = g.draw(16)
    with pytest.raises(Error):
        g.draw(16, **{option: value})
    assert np.array_equal(g.draw(16), before)


def test_vector_options(g):
    assert "mm" in g.svg(8, paper="A4")
    for option, value in (
        ("paper", "A99"),
        ("seams", "glued"),
        ("vector_precision", 5.0),
        ("colour", 1),
    ):
        with pytest.raises(Error):
            g.svg(8, **{option: value})
    with pytest.raises(Error):
        g.save("picture.bmp")


def test_lines_are_selected_when_the_system_is_made():
    def cube(system: System) -> System:
        system.box_3(*[-0.5, 0.5] * 3) if system.open_segment_name else None
        return system

    g = System(lines="outline")
    g.set_perspective(3, 2, 6)
    g.open_segment(1)
    cube(g).close_segment()
    all_lines = System()
    all_lines.set_perspective(3, 2, 6)
    all_lines.open_segment(1)
    cube(all_lines).close_segment()
    assert g.svg(64, hidden="franklin", lines="outline") != all_lines.svg(64, hidden="franklin")
    with pytest.raises(Error):
        all_lines.svg(64, lines="outline")
    with pytest.raises(Error):
        System(lines="outlines")


def test_aspects():
    g = System(aspect=2)
    assert g.aspect_ratio == 2
    for aspect in (0, -1, float("inf"), "wide", None):
        with pytest.raises(Error):
            g.set_aspect_ratio(aspect)
    g.open_segment(1)
    with pytest.raises(Error):
        g.set_aspect_ratio(1)
    assert g.to_device((0, 0, 0))[:2] == (0.5, 0.5)
    with pytest.raises(Error):
        g.to_device((0, 0))


@pytest.mark.parametrize("path", [None, 5, "a\0.svg", ["a.svg"], object(), "a\ud800.svg"])
def test_paths_that_are_refused(g, path):
    for call in (g.save, g.replay_file, g.import_mesh):
        with pytest.raises(Error):
            call(path)


# ---- Notebooks and importing -------------------------------------------------------------


def test_notebooks(g):
    assert System()._repr_svg_() is None and System()._repr_png_() is None
    assert g._repr_svg_().startswith("<svg") and g._repr_png_() is None
    many = System()
    many.surface(np.linspace(-1, 1, 60), np.linspace(-1, 1, 60), np.zeros((60, 60)))
    assert many._repr_svg_() is None and many._repr_png_().startswith(b"\x89PNG")


def maps_after(program: str) -> str:
    code = f"{program}\nprint(open('/proc/self/maps').read())"
    return subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    ).stdout


@pytest.mark.skipif(sys.platform != "linux", reason="there is no /proc")
def test_importing_loads_little():
    maps = maps_after("import displayfile")
    for library in ("OSMesa", "LLVM", "assimp", "qpdf", "cairo", "numpy"):
        assert library not in maps
    drawn = maps_after(
        "import displayfile\ng = displayfile.System()\ng.open_segment(1)\n"
        "g.polygon_abs_3([(0,0,0),(1,0,0),(0,1,0)])\ng.close_segment()\ng.draw(16)\ng.svg(16)"
    )
    for library in ("OSMesa", "LLVM", "assimp", "qpdf"):
        assert library not in drawn


def test_the_version_is_the_commands(command):
    assert displayfile.__version__ in command("--version").stdout


def test_the_licence_is_that_of_the_package_and_of_the_module_in_it():
    folder = Path(displayfile.__file__).parent
    licence = importlib.metadata.metadata("displayfile")["License"]
    assert licence == ("MIT AND GPL-3.0-or-later" if any(folder.glob("displayfile-solids.so.*")) else "MIT")


def test_a_picture_of_another_shape_is_told(tmp_path):
    def drawn(aspect=None, window=None, fit=None):
        system = System(aspect=aspect)
        if fit:
            system.set_window_fit(fit)
        if window:
            system.set_window(*window)
        system.open_segment(1)
        system.polygon_abs_2([(0, 0), (1, 0), (0, 1)])
        system.close_segment()
        return system

    for draw in (
        lambda s: s.draw((640, 480)),
        lambda s: s.svg((640, 480)),
        lambda s: s.png((640, 480)),
    ):
        with pytest.warns(UserWarning, match=r"1.33 times as wide.*set_aspect_ratio\(1.333\)"):
            draw(drawn())
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="times as wide"):
            drawn().save(tmp_path / "stretched.png", (640, 480))
        assert not list(tmp_path.iterdir())
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        drawn().draw(100)
        drawn(aspect=640 / 480).draw((640, 480))
        drawn(aspect=1.333).draw((640, 480))
        drawn(window=(0, 4, 0, 3)).draw((640, 480))
        drawn(fit="stretch").draw((640, 480))


def test_what_shows_nothing_is_warned_of_with_the_reason(tmp_path):
    def drawn(triangle, retain=False, line_style="none", view=False):
        system = System(retain=retain)
        if view:
            system.set_window(-1, 1, -1, 1)
        system.set_line_style(*line_style.split())
        system.open_segment(1)
        system.polygon_abs_3(triangle)
        system.close_segment()
        return system

    edge_on = [(0.1, 0, 0), (0.1, 0.5, 0), (0.1, 0, 0.5)]
    small = [(0.001, 0.001, 0), (0.003, 0.001, 0), (0.001, 0.003, 0)]
    right = [(5, 0, 0), (6, 0, 0), (5, 1, 0)]
    draws = [
        lambda s: s.draw(100),
        lambda s: s.draw(100, samples=2, ids=True),
        lambda s: s.png(100),
        lambda s: s.save(tmp_path / "t.ppm", 100),
    ]
    draws_vectors = [lambda s: s.svg(100), lambda s: s.save(tmp_path / "t.svg", 100)]
    for draw in draws + draws_vectors:
        with pytest.warns(UserWarning, match="^nothing is seen: no polygon or line was entered$"):
            draw(System())
        with pytest.warns(UserWarning, match="nothing is seen: the only .* is seen edge-on"):
            draw(drawn(edge_on))
        with pytest.warns(UserWarning, match="nothing that was entered is inside.*: look()"):
            draw(drawn(right))
        with pytest.warns(UserWarning, match="nothing that was entered is inside.*viewer$"):
            draw(drawn(right, view=True))
        with pytest.warns(UserWarning, match="nothing is seen: the only .* right of the window"):
            draw(drawn(right, retain=True))
    for draw in draws:
        with pytest.warns(UserWarning, match="nothing is seen: the only .* smaller or thinner"):
            draw(drawn(small))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for draw in draws_vectors:
            draw(drawn(small))
        for draw in draws + draws_vectors:
            draw(drawn(edge_on, line_style="solid 0 0 0 1"))
    with pytest.warns(UserWarning) as told:
        drawn(edge_on).draw(10)
    assert [Path(w.filename).name for w in told] == [Path(__file__).name]


def test_hidden_lines_that_nothing_finds_are_refused_or_warned_of():
    def drawn(z):
        system = System()
        system.set_hidden_line_removal(False)
        system.open_segment(1)
        system.polygon_abs_3([(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)])
        system.move_abs_3(-0.9, 0.1, z)
        system.line_abs_3(0.9, 0.3, z)
        system.close_segment()
        return system

    for hidden in (None, "none", "back-face"):
        options = {"hidden": hidden, "hidden_lines": "dashed"}
        for call in (lambda s: s.draw(64, **options), lambda s: s.svg(64, **options)):
            with pytest.raises(Error, match="hidden lines are not found by"):
                call(drawn(-1))
            call(drawn(1))
        for call in (lambda s: s.dump(**options), lambda s: s.pieces(**options)):
            with pytest.raises(Error, match="hidden lines need a method that sorts"):
                call(drawn(-1))
            call(drawn(1))
        behind = drawn(-1)
        behind.set_hidden_lines("dashed")
        with pytest.warns(UserWarning, match="hidden lines are not found by"):
            behind.draw(64, hidden=hidden)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        behind.draw(64, hidden="z-buffer")
        behind.svg(64, hidden="map")


@pytest.mark.parametrize("size", [0, -1, (0, 480), (640, 0), (-640, 480), (640, -480), (10**6, 1)])
def test_a_size_of_no_picture_is_an_error_alone(g, tmp_path, size):
    calls = (g.draw, g.svg, g.pdf, g.png, lambda size: g.save(tmp_path / "a.svg", size=size))
    for draw in calls:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with pytest.raises(Error, match="size"):
                draw(size)
    assert not list(tmp_path.iterdir())
