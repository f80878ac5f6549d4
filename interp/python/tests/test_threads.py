"""Several threads, and interrupts."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import displayfile
from displayfile import Error, System


def run_together(work, count: int = 4) -> None:
    """Runs work(k) on several threads at once, and raises what one of them raises."""
    raised: list[BaseException] = []

    def run(k: int) -> None:
        try:
            work(k)
        except BaseException as error:
            raised.append(error)

    threads = [threading.Thread(target=run, args=(k,)) for k in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if raised:
        raise raised[0]


def random_mesh(seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    return random.uniform(-1, 1, (600, 3)), np.arange(600).reshape(-1, 3)


def test_systems_of_their_own():
    expected = []
    for seed in range(4):
        g = System()
        g.mesh(*random_mesh(seed))
        expected.append(g.draw(64, hidden="z-buffer"))

    def work(k: int) -> None:
        for _ in range(5):
            g = System()
            g.mesh(*random_mesh(k))
            assert np.array_equal(g.draw(64, hidden="z-buffer"), expected[k])

    run_together(work)


def test_one_system_drawn_by_all():
    g = System()
    g.mesh(*random_mesh(0))
    expected = {method: g.draw(48, hidden=method) for method in ("z-buffer", "bsp", "map")}

    def work(k: int) -> None:
        for method in list(expected) * 3:
            assert np.array_equal(g.draw(48, hidden=method), expected[method])
            g.pick(k, k, 48)
            g.svg(48)

    run_together(work)


def test_one_system_changed_by_all():
    """Each call is whole: what does not fit between those of others is an Error."""
    g = System()
    vertices, faces = random_mesh(1)
    names: list[int] = []

    def work(k: int) -> None:
        for _ in range(20):
            try:
                names.append(g.mesh(vertices, faces, picks=np.full(len(faces), k)))
                g.set_visibility(names[-1], False)
                g.draw(8)
                g.delete_segment(names[-1])
                g.open_segment(1000 + k)
            except Error:
                pass
            try:
                g.line_abs_3(0.1, 0.2, k)
                g.close_segment()
            except Error:
                pass

    run_together(work)
    g.dump()
    if g.open_segment_name is not None:
        g.close_segment()
    g.delete_all_segments()
    assert g.segments == []


def test_arrays_that_change_meanwhile():
    vertices, faces = random_mesh(2)
    stop = threading.Event()

    def disturb() -> None:
        random = np.random.default_rng(3)
        while not stop.is_set():
            faces[random.integers(200), 0] = random.integers(-10, 10**9)
            vertices[random.integers(600), 0] = random.choice([np.nan, np.inf, 1e300, 0.5])
            faces[:] = np.arange(600).reshape(-1, 3)
            vertices[:] = 0.25

    disturbing = threading.Thread(target=disturb)
    disturbing.start()
    try:
        for _ in range(200):
            g = System()
            try:
                g.mesh(vertices, faces)
            except Error:
                assert g.segments == []
            try:
                displayfile.visible_pieces(vertices[:30].reshape(-1, 3, 3))
            except Error:
                pass
    finally:
        stop.set()
        disturbing.join()


LONG_WORK = """
import sys, time
import numpy as np
import displayfile
random = np.random.default_rng(0)
soup = random.uniform(-1, 1, (4000, 3, 3))
"""


def test_others_go_on_while_one_works():
    """The interpreter's lock is released."""
    soup = np.random.default_rng(0).uniform(-1, 1, (500, 3, 3))
    working = threading.Thread(target=lambda: displayfile.sort(soup, method="bsp"))
    turns = 0
    working.start()
    while working.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 3


def interrupted(program: str, expected: int, begin: str = LONG_WORK) -> str:
    process = subprocess.Popen(
        [sys.executable, "-c", begin + program], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    try:
        out, _ = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        raise
    assert process.returncode == expected
    return out


def test_an_interrupt_stops_long_work():
    out = interrupted(
        """
g = displayfile.System()
vertices, faces = soup.reshape(-1, 3), np.arange(12000).reshape(-1, 3)
g.mesh(vertices, faces)
before = g.dump()
print("begun", flush=True)
try:
    for _ in range(100): g.svg(64, hidden="bsp"); g.set_visibility(1, True)
except KeyboardInterrupt:
    print("stopped", g.dump() == before, g.draw(8).shape)
""",
        0,
    )
    assert out == "stopped True (8, 8, 4)\n"


def test_an_interrupt_stops_a_sort():
    assert (
        interrupted(
            """
print("begun", flush=True)
try:
    for _ in range(100): displayfile.sort(soup, method="bsp")
except KeyboardInterrupt:
    print("stopped")
""",
            0,
        )
        == "stopped\n"
    )


IMPORT_ON_ANOTHER_THREAD = """
import threading
importing = threading.Thread(target=lambda: __import__("displayfile"))
importing.start()
importing.join()
"""


def test_an_interrupt_stops_work_where_another_thread_was_first_to_import():
    out = interrupted(
        """
print("begun", flush=True)
begun = time.perf_counter()
try:
    with displayfile.limits(seconds=6):
        displayfile.sort(soup, method="bsp")
except KeyboardInterrupt:
    print("stopped" if time.perf_counter() - begun < 4 else "late")
""",
        0,
        IMPORT_ON_ANOTHER_THREAD + LONG_WORK,
    )
    assert out == "stopped\n"


WORK_ON_ANOTHER_THREAD = """
import os, threading
g, small = displayfile.System(), displayfile.System(retain=True)
g.mesh(soup.reshape(-1, 3), np.arange(12000).reshape(-1, 3))
small.mesh(soup[:200].reshape(-1, 3), np.arange(600).reshape(-1, 3))
turned = small.turntable(3, 2048, samples=16)
noting = displayfile.PicklableSystem()
noting.set_window(-1, 1, -1, 1)  # it is sorted as the segment is closed
noting.set_hidden_line_removal(True)
noting.set_hidden_method("bsp")
noting.open_segment(1)
noting.mesh(soup.reshape(-1, 3), np.arange(12000).reshape(-1, 3))
def work(long):
    while True:
        try:
            with displayfile.limits(seconds=6):
                long()
        except displayfile.LimitReached:
            pass
def ended_by(call):
    begun = time.perf_counter()
    try:
        call()
    except (displayfile.LimitReached, KeyboardInterrupt) as ended:
        return type(ended).__name__, time.perf_counter() - begun < 3
"""


@pytest.mark.parametrize(
    ("long", "call"),
    [
        ('lambda: g.svg(16, hidden="bsp")', "g.dump"),
        ("lambda: turned.draw(0)", "lambda: turned.draw(1)"),
        ("noting.close_segment", "lambda: noting.set_pick_id(3)"),
    ],
)
def test_a_limit_and_an_interrupt_end_the_wait_for_another_thread(long, call):
    out = interrupted(
        f"""
threading.Thread(target=work, args=({long},), daemon=True).start()
time.sleep(0.5)
with displayfile.limits(seconds=0.2):
    limited = ended_by({call})
print("begun", flush=True)
print(*limited, *ended_by({call}), flush=True)
os._exit(0)
""",
        0,
        LONG_WORK + WORK_ON_ANOTHER_THREAD,
    )
    assert out == "LimitReached True KeyboardInterrupt True\n"


def test_an_interrupt_of_a_program_that_is_replayed_is_no_error():
    out = interrupted(
        """
system = displayfile.System()
program = "open-segment 1\\n" + "polygon-abs-2 0 0 1 0 0 1\\n" * 3000000 + "close-segment\\n"
print("begun", flush=True)
try:
    system.replay(program)
except KeyboardInterrupt as interrupt:
    print("stopped", system.segments, interrupt.__context__)
""",
        0,
    )
    assert out == "stopped [] None\n"  # programs are carried out whole or not at all


def test_a_handler_that_goes_on():
    """Python's own way: where a handler raises nothing, the call is carried out all the same."""
    assert (
        interrupted(
            """
import signal
told = []
signal.signal(signal.SIGINT, lambda *_: told.append(1))
print("begun", flush=True)
begin = time.perf_counter()
while not told or time.perf_counter() - begin < 1:
    assert len(displayfile.sort(soup[:400], method="bsp").item) >= 400
print("told", len(told))
""",
            0,
        )
        == "told 1\n"
    )
