"""Systems that keep their calls: they are pickled and copied, and are the same where they are made again."""

from __future__ import annotations

import array
import collections
import copy
import ctypes
import multiprocessing
import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, ring

import displayfile
from displayfile import Error, PicklableSystem, System

PROGRAMS = sorted((ROOT / "programs").glob("*.draw"))
X = np.linspace(-1, 1, 7)


def again(system: PicklableSystem) -> PicklableSystem:
    return pickle.loads(pickle.dumps(system))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_programs(program):
    system = PicklableSystem(aspect=1.5)
    system.replay(program.read_text(), "program")
    for other in (again(system), system.calls.system()):
        assert other.dump() == system.dump()
        assert other.aspect_ratio == 1.5
        assert np.array_equal(other.draw((60, 40)), system.draw((60, 40)))


def entered(system: PicklableSystem) -> PicklableSystem:
    system.set_perspective(3, 2, 6)
    system.set_line_style("solid", 0, 0, 0, 2.0)
    system.set_line_kind_style("outline", 3, "dashed", 4, 2, 1, 0, 0)
    system.open_segment(1)
    system.set_fill_style("solid", 0.9, np.float64(0.4), 0.2)
    system.set_pick_id(7)
    system.polygon_abs_3([(-0.5, -0.5, 0), (0.5, -0.5, 0), np.array([0, 0.5, 0])])
    system.text("a note")
    system.close_segment()
    system.set_aspect_ratio(2)
    system.mesh(np.eye(4, 3), [[0, 1, 2], [3, 1, 0]], fills=np.full((2, 3), 0.5), segment=4)
    system.surface(X, X, np.outer(X, X))
    system.set_image_translation(4, 0.1, 0)
    return system


def test_all_that_is_entered():
    system = entered(PicklableSystem(lines="outline"))
    plain = entered(System(lines="outline"))
    for other in (system, again(system), copy.copy(system), copy.deepcopy(system)):
        assert type(other) is PicklableSystem
        assert other.dump() == plain.dump()
        assert np.array_equal(other.draw((80, 40)), plain.draw((80, 40)))
    assert type(system.calls.system()) is System
    assert again(again(system)).dump() == plain.dump()
    assert system.calls.nbytes > X.nbytes


def test_calls_make_a_system_that_retains():
    system = PicklableSystem()
    system.set_window(-1, 1, -1, 1)
    system.mesh(np.eye(3), [[0, 1, 2]])
    with pytest.raises(Error, match="retain=True"):
        system.calls.system().turntable(3)
    expected = again(PicklableSystem(retain=True))
    expected.set_window(-1, 1, -1, 1)
    expected.mesh(np.eye(3), [[0, 1, 2]])
    turned = system.calls.system(retain=True).turntable(3, 32)
    assert np.array_equal(turned.draw(1), expected.turntable(3, 32).draw(1))


def test_copies_go_on_by_themselves():
    system = entered(PicklableSystem())
    calls = system.calls
    assert system.calls is calls
    other = again(system)
    other.delete_segment(4)
    assert 4 in system.segments and 4 not in other.segments
    assert 4 not in again(other).segments and 4 in calls.system().segments
    assert other.calls is not calls and system.calls is calls
    system.delete_segment(4)
    assert system.calls is not calls


def test_what_is_entered_may_change_later():
    vertices, faces = np.eye(3), [[0, 1, 2]]
    system = PicklableSystem()
    system.mesh(vertices, faces)
    before = system.dump()
    vertices[:] = 0
    faces[0][0] = 2
    assert again(system).dump() == before == system.dump()


TRIANGLE = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0)


@pytest.mark.parametrize(
    "kind",
    [
        lambda numbers: array.array("d", numbers),
        lambda numbers: memoryview(array.array("d", numbers)),
        lambda numbers: (ctypes.c_double * 9)(*numbers),
        lambda numbers: collections.UserList(numbers),
        lambda numbers: collections.deque(numbers),
        np.array,
        list,
    ],
)
def test_buffers_and_sequences_may_change_later(kind):
    numbers = kind(TRIANGLE)
    system, plain = PicklableSystem(), System()
    for entered_into in (system, plain):
        entered_into.open_segment(1)
        entered_into.polygon_abs_3(numbers)
        entered_into.close_segment()
    numbers[3] = 0.25
    assert again(system).dump() == plain.dump() == system.dump()


def test_holes_of_masked_arrays_stay():
    heights = np.ma.masked_greater(np.add.outer(X, X), 1)
    system, plain = PicklableSystem(), System()
    for entered_into in (system, plain):
        entered_into.surface(X, X, heights)
    heights.mask[:] = False
    assert again(system).dump() == plain.dump() == system.dump()
    assert 0 < system.polygons < 2 * (len(X) - 1) ** 2


def test_sequences_that_hold_themselves():
    endless: list[object] = [0]
    endless.append(endless)
    system = PicklableSystem()
    system.open_segment(1)
    with pytest.raises(Error, match="too deep"):
        system.polygon_abs_3(endless)
    assert len(system.calls._calls) == 1


def test_what_fails_is_not_kept():
    system = entered(PicklableSystem())
    before = system.dump()
    with pytest.raises(Error):
        system.polygon_abs_3((0, 0, 0))
    with pytest.raises(Error):
        system.open_segment(1)
    with pytest.raises(Error):
        system.mesh(np.eye(3), [[0, 1, 7]])
    assert again(system).dump() == before


def test_a_program_that_fails_in_the_middle_is_not_kept(tmp_path):
    bad = "set-window 0 2 0 2\nopen-segment 3\npolygon-abs-2 0 0 1 0 0 1\nclose-segment\nnonsense\n"
    (tmp_path / "bad.draw").write_text(bad)
    for enter in (
        lambda system: system.replay(bad),
        lambda system: system.replay_file(tmp_path / "bad.draw"),
    ):
        system = PicklableSystem()
        with pytest.raises(Error):
            enter(system)
        assert again(system).dump() == system.dump()
        assert again(system).to_device((1, 1, 0)) == system.to_device((1, 1, 0))


def test_open_segments():
    system = PicklableSystem()
    system.open_segment(2)
    system.polygon_abs_2([(0, 0), (1, 0), (0, 1)])
    other = again(system)
    assert other.open_segment_name == 2
    system.close_segment()
    other.close_segment()
    assert other.dump() == system.dump()


def test_files_are_found_from_other_folders(tmp_path, monkeypatch):
    (tmp_path / "ring.obj").write_text(ring(6, 5))
    (tmp_path / "view.draw").write_text("set-shading gouraud\n")
    monkeypatch.chdir(tmp_path)
    system = PicklableSystem()
    system.replay_file("view.draw")
    system.import_mesh(path=Path("ring.obj"), eye=(10, 20))
    sent = pickle.dumps(system)
    monkeypatch.chdir("/")
    assert pickle.loads(sent).dump() == system.dump()
    (tmp_path / "ring.obj").unlink()
    with pytest.raises(Error, match="ring.obj"):
        pickle.loads(sent)


@pytest.mark.parametrize("path", [None, 5, "a\0.obj"])
def test_paths_that_are_refused(path):
    system = PicklableSystem()
    for enter in (system.import_mesh, system.replay_file):
        with pytest.raises(Error):
            enter(path)
    with pytest.raises(TypeError):
        system.import_mesh()
    assert again(system).segments == []


def dump_of(system: System) -> str:
    return system.dump()


def test_other_processes():
    system = entered(PicklableSystem())
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(dump_of, (system,)) == system.dump()


def test_a_system_without_its_calls_is_not_pickled():
    for send in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(Error, match="expected a PicklableSystem"):
            send(System())


def test_subclasses():
    own = entered(Own())
    other = again(own)
    assert type(other) is Own and other.dump() == own.dump()
    assert len(other.calls._calls) == len(own.calls._calls)


class Own(PicklableSystem):
    def close_segment(self) -> None:
        self.set_pick_id(3)
        super().close_segment()


def test_signatures_are_those_of_a_system():
    for routine in displayfile.user_routines():
        assert getattr(PicklableSystem, routine).__doc__ == getattr(System, routine).__doc__
    assert PicklableSystem.import_mesh.__doc__ == System.import_mesh.__doc__


@pytest.mark.parametrize("routine", ["replay", "polygon_abs_2"])
def test_what_was_interrupted_is_not_known(routine, monkeypatch):
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    system = PicklableSystem()
    system.open_segment(1)
    with monkeypatch.context() as patched, pytest.raises(KeyboardInterrupt):
        patched.setattr(System, routine, interrupted)
        getattr(system, routine)("open-segment 2")
    system.close_segment()
    with pytest.raises(Error, match="a call was interrupted"):
        pickle.dumps(system)
