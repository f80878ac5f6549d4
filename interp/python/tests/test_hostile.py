"""Arguments that are not what they seem; and the calls of fuzz_bindings.py, for a few seconds."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import hostile
import numpy as np
import pytest

import displayfile
from displayfile import Error, System

TRIANGLE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]


@pytest.fixture
def g() -> System:
    system = System()
    system.open_segment(1)
    return system


def dump_of(enter: Any) -> str:
    g = System()
    enter(g)
    return g.dump()


def test_a_system_without_its_init_is_refused() -> None:
    class Forgetful(System):
        def __new__(cls) -> Any:
            return object.__new__(cls)

        def __init__(self) -> None:
            pass

    for call in (System.dump, System.close_segment, System.draw, lambda g: g.segments):
        with pytest.raises(Error, match="__init__"):
            call(System.__new__(System))
    with pytest.raises(TypeError):  # which pybind11 says
        Forgetful()


def test_parts_of_a_sequence_that_are_made_as_they_are_asked_for() -> None:
    """Nobody else holds them while they are read."""
    faces = [[0, 1, 2], [0, 1, 2, 3], [1, 2, 3]] * 50
    vertices = [*TRIANGLE, (1.0, 1.0, 0.0)]
    expected = dump_of(lambda g: g.mesh(vertices, faces))
    assert dump_of(lambda g: g.mesh(vertices, hostile.Fresh(faces))) == expected
    polygons = [TRIANGLE, vertices] * 50
    for function in (displayfile.sort, displayfile.visible_pieces):
        for a, b in zip(function(hostile.Fresh(polygons)), function(polygons)):
            assert np.array_equal(a, b)


@pytest.mark.parametrize(
    "call",
    [
        "g.move_abs_3(0, 0, decimal.Decimal('sNaN'))",
        "g.move_abs_3(0, 0, int)",
        "g.move_abs_3(0, 0, Wrong())",
        "g.move_abs_3(0, 0, dead())",
        "g.move_abs_3(range(10**12))",
        "g.set_aspect_ratio(Wrong())",
        "g.draw(Wrong())",
        "g.draw(shrinking([8, 8]))",
        "g.svg(8, **{'\\ud800': 1})",
        "g.mesh(Wrong(), [])",
        "g.mesh([[Wrong()] * 3] * 3, [[0, 1, 2]])",
        "g.mesh([(0, 0, 0)] * 3, [(0, 1, 2), Wrong()])",
        "g.mesh(released([(0, 0, 0)] * 3), [(0, 1, 2)])",
        "g.set_light(released([1.0, 2.0, 3.0]))",
        "g.draw(memoryview(np.zeros((2, 2))))",
    ],
)
def test_what_cannot_be_read_is_an_error(g: System, call: str) -> None:
    before = g.dump()
    with pytest.raises(Error):
        eval(call, {**vars(hostile), "g": g})
    assert g.dump() == before


@pytest.mark.parametrize("raised", [hostile.Hostile, KeyboardInterrupt, ZeroDivisionError])
def test_what_an_argument_raises_by_itself_comes_through(
    g: System, raised: type[BaseException]
) -> None:
    def raise_it(*_: Any) -> Any:
        raise raised

    number, array, sequence = (
        type("Raising", (), dict.fromkeys(names, raise_it))()
        for names in (["__float__"], ["__array__"], ["__len__", "__getitem__"])
    )
    for call in (
        lambda: g.move_abs_3(number, 0, 0),
        lambda: g.set_aspect_ratio(number),
        lambda: g.mesh(array, [[0, 1, 2]]),
        lambda: g.mesh(TRIANGLE, array),
        lambda: g.surface([0, 1], [0, 1], array),
        lambda: displayfile.sort(array),
        lambda: displayfile.sort(sequence),
        lambda: g.draw(sequence),
    ):
        with pytest.raises(raised):
            call()


def test_what_becomes_an_array_is_taken_as_one() -> None:
    """Such as tensors and tables of other libraries, even where they are sequences too."""
    polygons = np.array([TRIANGLE, np.add(TRIANGLE, (0.25, 0.25, 0.5))])
    alike = hostile.as_array(polygons)
    tensor = hostile.as_array(polygons, __len__=hostile.raise_hostile, __getitem__=None)
    for function in (displayfile.sort, displayfile.visible_pieces):
        for other in (alike, tensor, memoryview(polygons)):
            for a, b in zip(function(other), function(polygons)):
                assert np.array_equal(a, b)
    faces = hostile.as_array([[0, 1, 2]], __len__=hostile.raise_hostile, __getitem__=None)
    expected = dump_of(lambda g: g.mesh(TRIANGLE, [[0, 1, 2]]))
    assert dump_of(lambda g: g.mesh(TRIANGLE, faces)) == expected


def test_an_error_knows_what_was_raised(g: System) -> None:
    with pytest.raises(Error) as refused:
        g.mesh([(0, 0, 0), (1, 0)], [])
    assert isinstance(refused.value.__cause__, ValueError)


def test_a_program_is_carried_out_whole_or_not_at_all(tmp_path: Path) -> None:
    g, other = System(), System()
    for system in (g, other):
        system.mesh(TRIANGLE, [[0, 1, 2]])
        system.open_segment(2)
        system.polygon_abs_3(TRIANGLE)
    program = "set-fill-style hollow\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\nfly 1\n"
    path = tmp_path / "p.draw"
    path.write_text(program)
    for replay in (lambda: g.replay(program), lambda: g.replay_file(path)):
        with pytest.raises(Error, match=":4:1: "):
            replay()
        assert g.open_segment_name == 2
        assert g.dump() == other.dump()
        assert np.array_equal(g.draw(16), other.draw(16))
    for system in (g, other):
        system.polygon_abs_3(TRIANGLE)
        system.close_segment()
    assert g.dump() == other.dump()


def test_what_is_recorded_replays() -> None:
    g = System()
    g.set_window(-1, 1, -1, 1)
    g.set_fill_style("hollow")
    g.record()
    assert g.recording == ""
    g.set_fill_style("solid", 1, 0, 0.1)
    g.mesh(TRIANGLE, [[0, 1, 2]])
    with pytest.raises(Error):
        g.mesh(TRIANGLE, [[0, 1, 3]])
    with pytest.raises(Error):
        g.replay("set-pick-id 5\nfly")
    g.record(False)
    g.set_fill_style("hollow")
    assert g.recording.startswith("set-fill-style solid 1 0 0.1\nopen-segment 1\n")
    assert g.recording.count("\n") == 4
    again = System()
    again.replay(g.recording)
    assert again.dump() == g.dump()


def test_random_calls() -> None:
    program = Path(__file__).with_name("fuzz_bindings.py")
    done = subprocess.run(
        [sys.executable, program, "--programs", "40"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "40 programs" in done.stdout


# ---- Arrays that are none, and references to nothing -------------------------------------


@pytest.mark.parametrize(
    "call",
    [
        "g.surface(X, X, [dead()], contours=2)",
        "g.surface(X, X, dead(), contours=2)",
        "g.mesh(POINTS, FACE, values=dead())",
        "g.mesh(POINTS, FACE, values=[dead()])",
        "g.mesh(POINTS, FACE, fills=dead())",
        "g.mesh(POINTS, FACE, fills=[dead()])",
        "g.mesh(POINTS, FACE, fills=['red', dead()])",
        "g.mesh(POINTS, FACE, fill=dead())",
        "g.polyline(dead())",
        "g.polyline([dead()])",
        "g.polyline(as_array([(0, 0, 0)]))",
        "g.polyline(POINTS, colour=dead())",
        "g.polyline(POINTS, closed=dead())",
        "g.mesh(POINTS, FACE, values=[1], limits=dead())",
        "g.mesh(POINTS, FACE, values=[1], levels=dead())",
        "g.mesh(POINTS, FACE, values=[1], cmap=dead())",
        "g.mesh(POINTS, FACE, values=[1], at=dead())",
        "g.mesh(POINTS, FACE, fills=POINTS, at=dead())",
        "g.mesh(dead(), FACE, fills=POINTS, at='vertices')",
        "g.surface(X, X, FLAT, crop=dead())",
        "g.surface(X, X, FLAT, crop=(dead(), None, None))",
        "g.surface(X, X, FLAT, contours=dead())",
        "g.surface(X, X, FLAT, contours=2, contour_colour=dead())",
        "g.mesh(POINTS, FACE, values=[1, 2, 4], at='vertices', picks=dead())",
        "g.mesh(POINTS, FACE, values=[1, 2, 4], at='vertices', normals=dead())",
        "g.colour_bar(dead())",
        "g.colour_bar('a', ticks=dead())",
        "g.colour_bar('a', letters=dead())",
        "g.legend(dead())",
        "g.legend({'a': dead()})",
        "g.from_trimesh(dead())",
        "g.from_meshio(dead())",
        "g.from_pyvista(dead())",
    ],
)
def test_what_is_no_array_is_refused(call):
    names = {**vars(hostile), "POINTS": np.eye(3), "FACE": [[0, 1, 2]]}
    names |= {"X": [1, 2], "FLAT": np.zeros((2, 2)), "g": System()}
    names["g"].mesh(np.eye(3), [[0, 1, 2]], values=[1], at="faces")
    with pytest.raises(Error):
        eval(call, names)
