"""Interfaces that are expected: open files, notebooks, types, meshes of other packages."""

from __future__ import annotations

import importlib.util
import io
import subprocess
import sys
import textwrap
import typing
import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import displayfile
from displayfile import Error, Picture, System, _literals

CUBE = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
SIDES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


@pytest.fixture
def cube() -> System:
    system = System()
    system.mesh(CUBE, SIDES)
    return system


# ---- Files -------------------------------------------------------------------------------


def test_pictures_are_written_to_open_files(cube, tmp_path):
    for format in ("png", "svg", "pdf", "eps", "ppm"):
        file = io.BytesIO()
        cube.save(file, 40, format=format)
        cube.save(tmp_path / f"a.{format}", 40)
        written = (tmp_path / f"a.{format}").read_bytes()
        assert file.getvalue() == written or format == "pdf" and len(file.getvalue()) == len(written)
    drawn_by_a_pen = io.BytesIO()
    cube.save(drawn_by_a_pen, 40, format="dxf", pens=True)
    cube.save(tmp_path / "a.dxf", 40, pens=True)
    assert drawn_by_a_pen.getvalue() == (tmp_path / "a.dxf").read_bytes()
    with pytest.raises(Error, match="lines for pens"):
        cube.save(tmp_path / "a.dxf", 40)
    by_default = io.BytesIO()
    cube.save(by_default, 40)
    assert by_default.getvalue() == cube.png(40)
    with open(tmp_path / "named.svg", "wb") as named:
        cube.save(named, 40)
    assert (tmp_path / "named.svg").read_text() == cube.svg(40)
    text = io.StringIO()
    cube.save(text, 40, format="svg")
    assert text.getvalue() == cube.svg(40)
    for file, format in ((io.StringIO(), "png"), (io.BytesIO(), "bmp")):
        with pytest.raises(Error):
            cube.save(file, 40, format=format)
        assert not file.getvalue()


def test_dpi(cube):
    plain, dense = io.BytesIO(), io.BytesIO()
    cube.save(plain, 40, format="png")
    cube.save(dense, 40, format="png", dpi=300)
    assert b"pHYs" in dense.getvalue() and b"pHYs" not in plain.getvalue()
    for dpi in (0, "high", -1):
        with pytest.raises(Error):
            cube.save(io.BytesIO(), 40, dpi=dpi)


# ---- Notebooks ---------------------------------------------------------------------------


def test_a_picture_shows_itself(cube):
    picture = cube.draw((30, 20), ids=True)
    assert repr(picture) == "<Picture: 30 x 20 pixels, ids>"
    assert picture._repr_png_() == cube.png((30, 20))
    clear = cube.draw((30, 20), depth=True, background="none")
    assert clear._repr_png_() == cube.png((30, 20), background="none")
    pixels, ids, depth = picture
    assert depth is None and ids is picture.ids


def test_systems_are_shown_as_one_of_both_and_small():
    few, many = System(), System()
    few.mesh(CUBE, SIDES)
    assert few._repr_svg_().startswith("<svg") and few._repr_png_() is None
    many.surface(*np.meshgrid(np.arange(60.0), np.arange(60.0)), np.random.rand(60, 60))
    assert many._repr_svg_() is None and many._repr_png_().startswith(b"\x89PNG")
    large = System()
    points = np.random.default_rng(0).uniform(-1, 1, (1800, 3, 3))
    large.set_line_style("solid", 0, 0, 0)
    fills = np.random.default_rng(1).uniform(0, 1, (1800, 3))
    large.mesh(points.reshape(-1, 3), np.arange(5400).reshape(-1, 3), fills=fills)
    assert large._repr_svg_() is None and large._repr_png_().startswith(b"\x89PNG")


# ---- Types -------------------------------------------------------------------------------


def test_the_words_of_options_are_those_that_there_are():
    assert list(typing.get_args(_literals.Method)) == displayfile.methods()
    system = System()
    system.mesh(CUBE, SIDES)
    for format in typing.get_args(_literals.Format):
        system.save(io.BytesIO(), 8, format=format, pens=format == "dxf")
    for word in typing.get_args(_literals.Axis):
        system.look(up=word)
    for option, words in (
        ("hidden_lines", _literals.HiddenLines),
        ("line_order", _literals.LineOrder),
        ("scope", _literals.Scope),
    ):
        for word in typing.get_args(words):
            system.draw(8, hidden="franklin", **{option: word})


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")
def test_type_checkers_find_what_is_wrong(tmp_path):
    good = """
        import io
        import numpy as np
        import displayfile
        g = displayfile.System()
        g.mesh(np.eye(3), [[0, 1, 2]], fills=["red"])
        g.mesh(np.eye(3), np.array([[0, 1, 2]]), fill=(1, 0, 0), picks=[3])
        g.mesh(np.eye(3), [[0, 1, 2]], values=np.zeros(1), limits=(0, None), cmap="viridis")
        g.sphere_3(0, 0, 0, radius=1.0, facets=20)
        g.sphere_3((0, 0, 0), 1.0, 20)
        g.set_light(1, 1, 1)
        ids = g.draw((8, 8), ids=True).ids
        shape = g.draw(8).shape
        g.save(io.BytesIO(), format="png", dpi=300)
        g.save("a.svg", hidden="map")
    """
    bad = {
        'g.draw(8, hidden="zbuffer")': "hidden",
        'g.save("a.png", dpi="x")': "dpi",
        "g.mesh(np.eye(3), [[0, 1, 2]], fills=3)": "fills",
        'g.save("a", format="bmp")': "format",
        "g.draw(8).ids": "ids",
        'g.look(up="w")': "up",
        'g.svg(hidden="zbuffer")': "hidden",
        'g.sphere_3(0, 0, 0, radius="a", facets=20)': "radius",
        "g.sphere_3(0, 0, 0, 1.0, 20, width=3)": "sphere_3",
    }
    source = textwrap.dedent(good) + "\n".join(bad) + "\n"
    (tmp_path / "program.py").write_text(source)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path / "cache"), "program.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    first = textwrap.dedent(good).count("\n") + 1
    found = {int(line.split(":")[1]) for line in done.stdout.splitlines() if "error:" in line}
    assert found == set(range(first, first + len(bad))), done.stdout


# ---- Routines ----------------------------------------------------------------------------


def test_routines_take_their_arguments_by_name():
    by_name, by_place = System(), System()
    for system in (by_name, by_place):
        system.set_window(-2, 2, -2, 2)
        system.open_segment(1)
    by_name.sphere_3(x=0, y=0.5, z=0, radius=1, facets=8)
    by_place.sphere_3(0, 0.5, 0, 1, 8)
    by_name.cylinder_3(0, 0, 0, radius=0.5, height=1, facets=6)
    by_place.cylinder_3(0, 0, 0, 0.5, 1, 6)
    by_name.cone_3((0, 0, 0), radius=0.5, height=1, facets=6, top_radius=0.2)
    by_place.cone_3(0, 0, 0, 0.5, 1, 6, 0.2)
    by_name.set_light(1, 1, 1, ambient=0.5)
    by_place.set_light(1, 1, 1, 0.5)
    by_name.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    by_place.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    for system in (by_name, by_place):
        system.close_segment()
    by_name.set_visibility(name=1, on=False)
    by_place.set_visibility(1, False)
    assert by_name.dump() == by_place.dump()


@pytest.mark.parametrize(
    "call",
    [
        "g.sphere_3(0, 0, 0, 1, radius=1, facets=8)",
        "g.sphere_3(0, 0, 0, radius=1)",
        "g.sphere_3(0, 0, 0, 1, 8, width=2)",
        "g.sphere_3(0, 0, 0, radius=1, facet=8)",
        "g.polygon_abs_3(points=[(0, 0, 0), (1, 0, 0), (0, 1, 0)])",
        "g.cone_3(0, 0, 0, 1, 1, top_radius=0)",
        "g.close_segment(name=1)",
    ],
)
def test_names_that_are_refused(call):
    g = System()
    g.open_segment(1)
    before = g.dump()
    with pytest.raises(Error):
        eval(call, {"g": g})
    assert g.dump() == before


# ---- Meshes of other packages ------------------------------------------------------------


def entered(method: str, mesh: Any, **options: Any) -> str:
    system = System()
    getattr(system, method)(mesh, **options)
    return system.dump()


def expected(faces: Any, **options: Any) -> str:
    system = System()
    system.mesh(CUBE, faces, **options)
    return system.dump()


QUADS = np.array(SIDES)
HALVES = np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])


def test_trimesh():
    bare = SimpleNamespace(vertices=CUBE, faces=HALVES)
    assert entered("from_trimesh", bare) == expected(HALVES)
    colours = np.array([(k * 20, 255 - k, 7, 255) for k in range(12)], np.uint8)
    of_faces = SimpleNamespace(kind="face", face_colors=colours)
    mesh = SimpleNamespace(vertices=CUBE, faces=HALVES, visual=of_faces)
    assert entered("from_trimesh", mesh) == expected(HALVES, fills=colours[:, :3] / 255.0)
    assert entered("from_trimesh", mesh, fill="red") == expected(HALVES, fill=(1, 0, 0))
    mesh.visual = SimpleNamespace(kind="texture")
    with pytest.warns(UserWarning, match="texture"):
        assert entered("from_trimesh", mesh) == expected(HALVES)


def test_meshio():
    cells = [SimpleNamespace(type="quad", data=QUADS), SimpleNamespace(type="triangle", data=HALVES)]
    mesh = SimpleNamespace(points=CUBE, cells=cells)
    assert entered("from_meshio", mesh) == expected([*SIDES, *HALVES.tolist()])
    lines = SimpleNamespace(type="line", data=QUADS[:, :2])
    data = {"p": [np.arange(6.0), np.full(6, 99.0), np.arange(6.0, 18.0)]}
    mixed = SimpleNamespace(
        points=CUBE, cells=[cells[0], lines, cells[1]], point_data={}, cell_data=data
    )
    with pytest.warns(UserWarning, match="6 cells of type line"):
        coloured = entered("from_meshio", mixed, values="p")
    assert coloured == expected([*SIDES, *HALVES.tolist()], values=np.arange(18.0))
    quadratic = [SimpleNamespace(type="quad8", data=np.c_[QUADS, QUADS])]
    assert entered("from_meshio", SimpleNamespace(points=CUBE, cells=quadratic)) == expected(QUADS)
    lines = SimpleNamespace(type="line", data=QUADS[:, :2])
    with pytest.warns(UserWarning, match="6 cells of type line"):
        entered("from_meshio", SimpleNamespace(points=CUBE, cells=[*cells, lines]))
    flat = SimpleNamespace(points=CUBE[:, :2], cells=cells)
    assert "polygon" in entered("from_meshio", flat)
    with pytest.raises(Error, match="no faces"):
        entered("from_meshio", SimpleNamespace(points=CUBE, cells=[lines]))


def test_pyvista():
    padded = np.concatenate([[4, *face] for face in SIDES])
    mesh = SimpleNamespace(points=CUBE.astype(np.float32), faces=padded, n_lines=0, n_verts=0)
    assert entered("from_pyvista", mesh) == expected(QUADS)
    values = np.arange(8.0)
    assert entered("from_pyvista", mesh, values=values) == expected(QUADS, values=values)
    mesh.point_data, mesh.cell_data = {"T": values}, {"p": np.arange(6.0)}
    assert entered("from_pyvista", mesh, values="T") == expected(QUADS, values=values)
    assert entered("from_pyvista", mesh, values="p") == expected(QUADS, values=np.arange(6.0))
    with pytest.raises(Error, match="values 'q': expected an array, or the name of .*: p, T"):
        entered("from_pyvista", mesh, values="q")
    grid = SimpleNamespace(extract_surface=lambda: mesh)
    assert entered("from_pyvista", grid) == expected(QUADS)
    mesh.n_lines = 3
    with pytest.warns(UserWarning, match="3 lines"):
        entered("from_pyvista", mesh)
    with pytest.raises(Error):
        entered("from_pyvista", SimpleNamespace(points=CUBE, faces=padded[:-1]))


def test_a_mesh_that_no_camera_shows_is_warned_of():
    def with_a_line(begin: str = "") -> System:
        system = System()
        if begin:
            system.replay(begin)
        system.replay("open-segment 9\nline-abs-3 1 0 0\nclose-segment")
        return system

    late = with_a_line()
    with pytest.warns(UserWarning, match="no view is set"):
        late.mesh(CUBE, SIDES)
    with pytest.warns(UserWarning, match="no view is set"):
        with_a_line().surface([0, 1], [0, 1], np.eye(2), contours=2)
    with pytest.raises(Error, match="segments already"):
        late.look()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        late.mesh(CUBE, SIDES)  # once
        with_a_line("set-window -1 1 -1 1").mesh(CUBE, SIDES)
        seen = System()
        seen.look()
        seen.replay("open-segment 9\nline-abs-3 1 0 0\nclose-segment")
        seen.mesh(CUBE, SIDES)
        System().mesh(CUBE, SIDES)


@pytest.mark.parametrize("method", ["from_trimesh", "from_meshio", "from_pyvista"])
def test_other_objects_are_refused(method):
    for bad in (None, 5, CUBE, SimpleNamespace(points=CUBE), "mesh"):
        system = System()
        with pytest.raises(Error):
            getattr(system, method)(bad)
        assert system.segments == []


def test_the_types_of_routines_have_their_names():
    import ast
    import inspect

    stub = Path(displayfile.__file__).with_name("_displayfile.pyi").read_text()
    of_system = next(
        node
        for node in ast.parse(stub).body
        if isinstance(node, ast.ClassDef) and node.name == "System"
    )
    typed: dict[str, list[str]] = {}
    for node in of_system.body:
        if isinstance(node, ast.FunctionDef):
            typed.setdefault(node.name, [argument.arg for argument in node.args.args[1:]])
    for name in displayfile.user_routines():
        parameters = inspect.signature(getattr(System, name)).parameters.values()
        names = [p.name for p in parameters if p.kind is not p.VAR_POSITIONAL]
        assert typed[name] == names, name
