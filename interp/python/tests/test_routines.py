"""Every user routine under its name; what is refused leaves the state as it was."""

from __future__ import annotations

import fractions
import os
from pathlib import Path

import numpy as np
import pytest

import displayfile
from displayfile import Error, System


@pytest.fixture
def g() -> System:
    system = System()
    system.open_segment(1)
    return system


def entered(g: System) -> str:
    g.close_segment()
    return g.dump()


def test_every_routine_is_a_method():
    names = displayfile.user_routines()
    assert len(names) > 70
    for name in names:
        assert "Arguments: " in getattr(System, name).__doc__ or name
    assert "open_segment" in names and "polygon_abs_3" in names


def test_arguments_may_be_numbers_sequences_or_arrays():
    corners = [(0.1 + 0.2, 0.0, 1 / 3), (0.5, 0.0, 0.0), (0.25, 1e-300, 0.5)]
    dumps = set()
    for arguments in (
        corners,
        [np.array(corners)],
        [corners],
        [np.array(corners).T.copy().T],
        [np.float64(x) for corner in corners for x in corner],
        [x for corner in corners for x in corner],
    ):
        g = System()
        g.open_segment(1)
        g.polygon_abs_3(*arguments)
        dumps.add(entered(g))
    assert len(dumps) == 1


def test_direct_and_written_numbers_are_the_same():
    by_call, by_text = System(), System()
    by_call.open_segment(1)
    by_call.move_abs_3(0.1, np.float32(0.1), 1)
    by_call.line_abs_3(1 / 3, fractions.Fraction(1, 7), True is True and 5e-324)
    by_call.line_abs_3([0.5, 0.5, 0.5])
    third, seventh, single = repr(1 / 3), repr(1 / 7), repr(float(np.float32(0.1)))
    by_text.replay(
        f"open-segment 1\nmove-abs-3 0.1 {single} 1\nline-abs-3 {third} {seventh} 5e-324\n"
        "line-abs-3 0.5 0.5 0.5\nclose-segment\n"
    )
    assert entered(by_call) == by_text.dump()


def test_words_switches_and_texts(g):
    g.set_fill_style("solid", 1, 0.5, 0)
    g.set_shadows(np.bool_(True))
    g.set_shadows("off")
    g.set_hidden_line_removal(True)
    g.set_text_style(0.05, "centre", "always")
    g.move_abs_2(0, 0)
    g.text('say "what" \\ and # more')
    assert 'say \\"what\\" \\\\ and # more' in entered(g)


def test_names_of_axes(g):
    g.axes_3(0, 1, 0, 1, 0, 1, "time, s", 'a "b"', "z")
    assert "time, s" in entered(g)


def test_annotation(g):
    g.leader_3(0, 0, 0, "a leader")
    g.balloon_3(0, 0, 0, 7, "Shaft", 10, -5)
    g.linear_dimension_3("x", 0, 0, 0, 0.5, 0.25, 0, 0, 0.5, 0)
    g.angle_dimension_3(0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0.25)
    g.title('"one"')
    g.parts_list()
    dump = entered(g)
    for text in ('"a leader"', '"7" "Shaft"', '"0.5"', '"90°"', '"\\"one\\""', "annotation list"):
        assert text in dump


@pytest.mark.parametrize(
    "call",
    [
        lambda g: g.open_segment(2),
        lambda g: g.open_segment("two"),
        lambda g: g.close_segment(1),
        lambda g: g.delete_segment(1),
        lambda g: g.polygon_abs_3([(0, 0, 0), (1, 0, 0)]),
        lambda g: g.polygon_abs_3([(0, 0), (1, 0), (1, 1), (0, 1)]),
        lambda g: g.polygon_abs_3([(0, 0, 0), (1, 0, 0), (1, float("nan"), 0)]),
        lambda g: g.polygon_abs_3([(0, 0, 0), (1, 0, 0), (1, "1", "x")]),
        lambda g: g.polygon_abs_3(np.array([[0, 0, 0], [1, 0, 0], [np.inf, 1, 0]])),
        lambda g: g.polygon_abs_3(np.zeros((3, 3), complex)),
        lambda g: g.polygon_abs_3(np.array([["a"] * 3] * 3)),
        lambda g: g.polygon_abs_3({}),
        lambda g: g.polygon_abs_3(None),
        lambda g: g.line_abs_3(1e200, 0, 0),
        lambda g: g.line_abs_3(10**400, 0, 0),
        lambda g: g.line_abs_3(0, 0),
        lambda g: g.balloon_3(0, 0, 0, 0),
        lambda g: g.leader_3(0, 0, 0),
        lambda g: g.set_annotation_size(0, "mm"),
        lambda g: g.set_dimension_text("H7"),
        lambda g: g.move_abs_3(object(), 0, 0),
        lambda g: g.move_abs_3(1j, 0, 0),
        lambda g: g.set_fill_style("solid", 2, 0, 0),
        lambda g: g.set_fill_style("liquid"),
        lambda g: g.set_view_up(0, 1, 0),
        lambda g: g.set_pick_id(1.5),
        lambda g: g.set_pick_id(2**40),
        lambda g: g.restore_transformation_3(),
        lambda g: g.text("two\nlines"),
        lambda g: g.text("\ud800"),
        lambda g: g.text(5),
        lambda g: g.surface_3(0, 1, 2, 0, 1, 2, [[0, 0], [0]]),
        lambda g: g.polygon_abs_3(np.zeros((6, 2))),
        lambda g: g.polygon_abs_3([(0, 0), (1, 0), (0, 1)]),
        lambda g: g.polygon_abs_3((0, 0), (1, 0), (0, 1)),
        lambda g: g.polygon_abs_2(np.ones((4, 3))),
        lambda g: g.end_solid(),
        lambda g: g.sphere_3(0, 0, 0, -1, 8),
    ],
)
def test_what_is_refused_changes_nothing(g, call):
    g.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    with pytest.raises(Error) as refused:
        call(g)
    assert str(refused.value)
    assert refused.value.file is None
    assert g.open_segment_name == 1
    assert g.polygons == 1
    other = System()
    other.open_segment(1)
    other.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    assert entered(g) == entered(other)


def test_a_sequence_within_itself_is_refused(g):
    endless: list = []
    endless.append(endless)
    with pytest.raises(Error):
        g.polygon_abs_3(endless)
    with pytest.raises(Error):
        g.set_light(endless)


def test_what_an_argument_raises_comes_through(g):
    class Number:
        def __float__(self) -> float:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        g.move_abs_3(Number(), 0, 0)


def test_an_argument_may_use_the_system(g):
    class Number:
        def __float__(self) -> float:
            g.set_pick_id(3)
            return 0.5

    g.move_abs_3(Number(), 0, 0)


def test_errors_know_their_place(tmp_path):
    with pytest.raises(Error) as refused:
        System().replay("open-segment 1\n  set-light 1 2 x\n", "lamp")
    error = refused.value
    assert (error.file, error.line, error.column) == ("lamp", 2, 17)
    assert str(error).startswith("lamp:2:17: ")
    path = tmp_path / "a:3.draw"
    path.write_text("close-segment\n")
    with pytest.raises(Error) as refused:
        System().replay_file(path)
    assert (refused.value.file, refused.value.line, refused.value.column) == (str(path), 1, 1)
    with pytest.raises(Error) as refused:
        System().replay_file(tmp_path / "none.draw")
    assert refused.value.file is None
    mesh = tmp_path / "m.obj"
    mesh.write_text("v 0 0 0\nf 1 2 3\n")
    with pytest.raises(Error) as refused:
        System().import_mesh(mesh)
    assert (refused.value.file, refused.value.line) == (str(mesh), 2)


def test_names_and_files_that_are_not_utf_8(tmp_path):
    folder = os.fsencode(tmp_path)
    path = folder + b"/caf\xe9.draw"
    for call in (
        lambda: System().replay_file(path),
        lambda: System().import_mesh(folder + b"/\xff.obj"),
        lambda: System().save(folder + b"/none\xff/a.svg"),
        lambda: displayfile.PicklableSystem().replay_file(path),
    ):
        with pytest.raises(Error, match="[\udce9\udcff]") as refused:
            call()
        assert refused.value.file is None
    for content in (b"nonsense\n", b"nonsense\xff\n"):
        with open(path, "wb") as file:
            file.write(content)
        with pytest.raises(Error) as refused:
            System().replay_file(path)
        assert os.fsencode(refused.value.file) == path
    mesh = folder + b"/\xff.obj"
    with open(mesh, "wb") as file:
        file.write(b"mtllib \xff.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    System().import_mesh(mesh)


@pytest.mark.parametrize("kind", [System, displayfile.PicklableSystem])
@pytest.mark.parametrize("path", ["-", b"-", Path("-")])
def test_standard_input_and_output_are_no_files(kind, path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    g = kind(retain=True)
    g.mesh(np.eye(3), [[0, 1, 2]])
    for call in (
        g.replay_file,
        g.import_mesh,
        g.save,
        lambda path: g.save(path, 8, format="svg"),
        g.turntable(2, 8).save,
    ):
        with pytest.raises(Error, match="path: -: expected a file's name"):
            call(path)
    (tmp_path / "-").write_text("set-pick-id 3\n")
    g.replay_file("./-")


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("routine", ["polygon_abs_3", "line_abs_3", "move_abs_3"])
def test_masked_numbers_are_not_drawn(g, kind, routine):
    points = np.ma.array(np.eye(3, dtype=kind), mask=[[0, 0, 0], [0, 0, 0], [1, 0, 0]])
    before = g.dump()
    with pytest.raises(Error, match="expected a finite number, not 'nan'"):
        getattr(g, routine)(points if routine == "polygon_abs_3" else points[2])
    assert g.dump() == before
    getattr(g, routine)(points.filled(0) if routine == "polygon_abs_3" else points[1])


def test_error_is_an_exception_of_ours():
    assert issubclass(Error, Exception)
    assert Error("x").line is None
    assert Error.__module__ == "displayfile"
