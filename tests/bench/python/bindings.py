"""Times the Python package beside C++: a mesh of triangles, new views, importing.

    bindings.py BINDINGS_BENCH MESH.obj [ROUNDS]    # entering and drawing the mesh, and the rest
    bindings.py BINDINGS_BENCH                      # new views and importing
    bindings.py                                     # importing

BINDINGS_BENCH is the program of that name, which does the same in C++. Both are run in turn,
each in processes of its own, and the least times are compared. A new view, as a slider makes it, is
System.views.draw of 200,000 triangles at 800 x 800 pixels, over a draw of C++'s Renderer alone. An
import is compared with that of NumPy, each beyond an empty program, in processor time. Ratios are
printed.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import time
from typing import Callable

TURNS = 5
CELLS = "316"  # in each direction: 200,000 triangles
VIEWS = "25"
INFINITY = float("inf")


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def read_triangles(path: str) -> tuple:
    import numpy as np

    vertices, faces = [], []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return np.array(vertices), np.array(faces)


def python_side(path: str, rounds: int) -> None:
    import displayfile

    vertices, faces = read_triangles(path)
    low, high = vertices.min(axis=0), vertices.max(axis=0)

    def enter(system: displayfile.System) -> None:
        system.set_line_style("none")
        system.set_light(1, 1, 1)
        system.open_segment(1)
        system.mesh(vertices, faces)
        system.close_segment()

    entering = anew = again = INFINITY
    for _ in range(rounds):
        system = displayfile.System()
        system.set_window(low[0], high[0], low[1], high[1])
        entering = min(entering, seconds(lambda: enter(system)))
        anew = min(anew, seconds(lambda: system.draw(1024, hidden="z-buffer", samples=1)))
        for _ in range(3):
            again = min(again, seconds(lambda: system.draw(1024, hidden="z-buffer", samples=1)))
    print(entering, anew, again)


def times_of(command: list[str]) -> list[float]:
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


def least(one: list[float], other: list[float]) -> list[float]:
    return [min(a, b) for a, b in zip(one, other)]


def new_views(cells: int, rounds: int) -> None:
    """The median seconds of a view of a wave of cells x cells squares, in two triangles each."""
    import numpy as np

    import displayfile

    x, y = np.meshgrid(*2 * [np.linspace(-2, 2, cells + 1)])
    vertices = np.stack([x, y, 0.4 * np.sin(5 * x) * np.cos(4 * y)], axis=-1).reshape(-1, 3)
    k = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    halves = np.c_[k, k + 1, k + cells + 2], np.c_[k, k + cells + 2, k + cells + 1]
    system = displayfile.System()
    system.set_line_style("none")
    system.set_light(1, 1, 1)
    system.mesh(vertices, np.stack(halves, axis=1).reshape(-1, 3))
    views = system.views(800, hidden="z-buffer", samples=1)
    times = sorted(seconds(lambda: views.draw((7 * k, 30))) for k in range(rounds))
    print(times[rounds // 2])


def seconds_of_program(program: str) -> float:
    """The least processor time of a process, with what it loads in memory."""
    least_time = INFINITY
    for _ in range(15):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", program], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        least_time = min(least_time, spent)
    return least_time


def compare_mesh(bench: str, path: str, rounds: str) -> None:
    of_cpp = of_python = [INFINITY] * 3
    for _ in range(TURNS):
        of_cpp = least(of_cpp, times_of([bench, path, rounds]))
        of_python = least(
            of_python, times_of([sys.executable, __file__, "--python-side", path, rounds])
        )
    names = ["entering arrays", "drawing 1024 x 1024, first", "drawing it again"]
    for name, python, cpp in zip(names, of_python, of_cpp):
        print(f"{name}, Python over C++: {python / cpp:.2f}")


def compare_views(bench: str) -> None:
    of_cpp = of_python = [INFINITY]
    for _ in range(TURNS):
        of_cpp = least(of_cpp, times_of([bench, "--views", CELLS, VIEWS]))
        of_python = least(
            of_python, times_of([sys.executable, __file__, "--views", CELLS, VIEWS])
        )
    print(f"a new view, Python over C++: {of_python[0] / of_cpp[0]:.2f}")


def main() -> None:
    if len(sys.argv) > 2:
        compare_mesh(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else "20")
    if len(sys.argv) > 1:
        compare_views(sys.argv[1])
    empty = seconds_of_program("pass")
    ours, numpy = (seconds_of_program(f"import {name}") for name in ("displayfile", "numpy"))
    print(f"import, over that of NumPy: {(ours - empty) / (numpy - empty):.2f}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--python-side"]:
        python_side(sys.argv[2], int(sys.argv[3]))
    elif sys.argv[1:2] == ["--views"]:
        new_views(int(sys.argv[2]), int(sys.argv[3]))
    else:
        main()
