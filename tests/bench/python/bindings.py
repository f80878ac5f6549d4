"""Times the Python package beside C++: entering a mesh of triangles, drawing it, importing.

    bindings.py BINDINGS_BENCH MESH.obj [ROUNDS]

BINDINGS_BENCH is the program of that name, which does the same in C++. Both are run in turn,
each in processes of its own, and the least times are compared. Ratios are printed, and
the time that an import takes beyond that of an empty program.
"""

from __future__ import annotations

import subprocess
import sys
import time
from typing import Callable

TURNS = 5
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


def seconds_of_program(program: str) -> float:
    command = [sys.executable, "-c", program]
    return min(seconds(lambda: subprocess.run(command, check=True)) for _ in range(15))


def main() -> None:
    bench, path = sys.argv[1:3]
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 20
    of_cpp = of_python = [INFINITY] * 3
    for _ in range(TURNS):
        of_cpp = least(of_cpp, times_of([bench, path, str(rounds)]))
        of_python = least(
            of_python, times_of([sys.executable, __file__, "--python-side", path, str(rounds)])
        )
    names = ["entering arrays", "drawing 1024 x 1024, first", "drawing it again"]
    for name, python, cpp in zip(names, of_python, of_cpp):
        print(f"{name}, Python over C++: {python / cpp:.2f}")
    imported = seconds_of_program("import displayfile") - seconds_of_program("pass")
    print(f"import, warm: {imported * 1e3:.0f} ms")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--python-side"]:
        python_side(sys.argv[2], int(sys.argv[3]))
    else:
        main()
