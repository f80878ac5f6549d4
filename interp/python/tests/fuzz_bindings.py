"""Calls the package as no program should, and looks whether it bears it.

    python3 interp/python/tests/fuzz_bindings.py [--seed N] [--programs N] [--minutes M] [--calls N]

A program is some calls by random_calls.py, with arguments by hostile.py. What must hold:

- A call succeeds, or raises Error, or what an argument raises by itself; nothing else is raised,
  and the process goes on.
- After a call that failed, a system is as its twin, which never saw it; after one that succeeded,
  as the twin that made the same call. Both return the same.
- What was recorded replays to the same display file.
- Where several threads call one system, each call is whole: what was recorded, in the order in
  which they came, replays to the same display file.

What fails is cut down to few calls that fail alike, and printed as a program that can be pasted. A
seed is always the same program, apart from the order in which threads come.
"""

from __future__ import annotations

import argparse
import ast
import faulthandler
import json
import os
import random
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

import hostile
import numpy as np
from random_calls import RandomCalls

import displayfile
from displayfile import Error, System

LONGEST = 300  # seconds of a process that runs programs
AT_A_TIME = 25  # programs of a process

FILES = {  # that random_calls.py names
    "some.obj": "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\no b\nf 2 3 4\nf 1 4 3\n",
    "some.draw": "open-segment 8\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\nset-light 1 1 1\n",
}

# What random_calls.py has of calls that do not fit a method: Python itself refuses them.
OF_PYTHON = (TypeError, AttributeError)
NOT_CALLED_SO = ("g.mesh()", "(x=1)", "no_routine", "8, 8, 8", "polygons()", "draw(5)", "sort()")
NOT_CALLED_SO += (
    "pick('x')",
    "unexpected keyword argument",
    "required positional argument",
    "object is not callable",
)


class Failed(Exception):
    """What must hold does not."""


def same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray):
        return isinstance(b, np.ndarray) and a.dtype == b.dtype and np.array_equal(a, b)
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    return bool(a == b)


def arguments_of(*arguments: Any, **named: Any) -> Any:
    return arguments, named


def called(text: str, system: System, **others: Any) -> Any:
    """What a call returns. An argument that Python cannot even make is handed over as its error."""
    names = {**vars(hostile), "displayfile": displayfile, "g": system, "of": arguments_of, **others}
    tree = ast.parse(text, mode="eval")
    if not isinstance(tree.body, ast.Call):
        return eval(text, names)
    function = eval(ast.unparse(tree.body.func), names)
    tree.body.func = ast.Name("of", ast.Load())
    try:
        arguments, named = eval(compile(ast.fix_missing_locations(tree), text, "eval"), names)
    except Exception as error:
        arguments, named = [error], {}
    return function(*arguments, **named)


def outcome(text: str, system: System, **others: Any) -> tuple[Any, BaseException | None]:
    """What a call returns, or else what it raises; if it may."""
    try:
        return called(text, system, **others), None
    except (Error, hostile.Hostile) as error:
        if not str(error):
            raise Failed("an error without a message") from error
        return None, error
    except OF_PYTHON as error:
        if any(part in text or part in str(error) for part in NOT_CALLED_SO):
            return None, error
        raise Failed(f"{type(error).__name__}: {error}") from error
    except Exception as error:
        raise Failed(f"{type(error).__name__}: {error}") from error


def state(system: System, with_picture: bool) -> list[Any]:
    asked = ["g.segments", "g.open_segment_name", "g.polygons", "g.aspect_ratio", "g.dump()"]
    if with_picture:
        asked += ["g.draw(12)", "g.svg(12)"]
    return [(value, str(error)) for value, error in (outcome(text, system) for text in asked)]


def finish(system: System) -> None:
    """Ends what is open, as the end of a drawing program needs it."""
    while outcome("g.discard_solid()", system)[1] is None:
        pass
    if system.open_segment_name is not None:
        if outcome("g.close_segment()", system)[1] is not None:  # its sort may be refused
            system.set_hidden_line_removal(False)
            system.close_segment()
    while outcome("g.restore_transformation_3()", system)[1] is None:
        pass


def options_of(seed: int) -> dict[str, Any]:
    """What a system is made with."""
    choose = random.Random(seed)
    options: dict[str, Any] = {}
    if choose.random() < 0.2:
        options["aspect"] = choose.choice([0.5, 4 / 3, 2])
    if choose.random() < 0.2:
        options["lines"] = choose.choice(["outline", "outline,crease", "all", "intersection"])
    if choose.random() < 0.5:
        options["retain"] = True
    return options


def require_replay(system: System, options: dict[str, Any], calls: list[str]) -> None:
    """What was recorded makes the same display file; but nothing records aspects."""
    if any("set_aspect_ratio" in call for call in calls):
        return
    finish(system)
    replayed = System(**options)
    replayed.replay(system.recording)
    if replayed.dump(hidden="none") != system.dump(hidden="none"):
        raise Failed("the recording replays to another display file")


# ---- Programs ----------------------------------------------------------------------------


def run_with_a_twin(calls: list[str], options: dict[str, Any]) -> None:
    system, twin = System(**options), System(**options)
    system.record()
    # Where calls are recorded, solids that planes cut are cut as wholes, from world coordinates: the
    # same picture but for rounding.
    if any("set_cutting_plane" in text for text in calls):
        twin.record()
    for number, text in enumerate(calls):
        value, error = outcome(text, system)
        # What an argument called meanwhile was done, even if the call was refused.
        if error is None or "asked(" in text:
            others = {"limited": hostile.unlimited} if error is None else {}
            of_twin, error_of_twin = outcome(text, twin, **others)
            if str(error) != str(error_of_twin):
                raise Failed(f"{error!r}, and of the twin: {error_of_twin!r}")
            if not same(value, of_twin):
                raise Failed(f"{value!r}, and of the twin: {of_twin!r}")
        pictured = number % 16 == 0 or number + 1 == len(calls)
        for a, b in zip(state(system, pictured), state(twin, pictured)):
            if not same(a, b):
                raise Failed(f"the state: {a!r}, and of the twin: {b!r}")
    require_replay(system, options, calls)


def run_on_threads(calls: list[str], options: dict[str, Any], threads: int = 3) -> None:
    system = System(**options)
    system.record()
    failed: list[BaseException] = []

    def run(part: list[str]) -> None:
        try:
            for text in part:
                outcome(text, system)
        except BaseException as error:
            failed.append(error)

    running = [threading.Thread(target=run, args=(calls[k::threads],)) for k in range(threads)]
    for thread in running:
        thread.start()
    for thread in running:
        thread.join()
    if failed:
        raise failed[0]
    require_replay(system, options, calls)


def run(seed: int, calls: list[str]) -> None:
    """Every fourth program is made by several threads."""
    (run_on_threads if seed % 4 == 3 else run_with_a_twin)(calls, options_of(seed))


# ---- Processes of their own ------------------------------------------------------------------


def run_programs(tasks: list[tuple[int, list[str]]]) -> None:
    """Tells before each program which one it is: the process may not live to tell it afterwards."""
    faulthandler.enable()
    for seed, calls in tasks:
        print(seed, flush=True)
        try:
            run(seed, calls)
        except Failed as error:
            sys.exit(f"{type(error).__name__}: {error}")


def in_a_process(tasks: list[tuple[int, list[str]]]) -> tuple[int, str] | None:
    """Runs programs in a process and a folder of their own: which one failed, and what it said."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tasks").write_text(json.dumps(tasks))
        for name, text in FILES.items():
            (Path(folder) / name).write_text(text)
        command = [sys.executable, __file__, "--tasks", "tasks"]
        process = subprocess.Popen(
            command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        try:
            begun, said = process.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            process.kill()
            begun, said = process.communicate()
            said = f"no end in {LONGEST} seconds\n{said}"
        if process.returncode == 0:
            return None
        seed = int(begun.split()[-1]) if begun else tasks[0][0]
        return seed, f"{said}(status {process.returncode})"


def kind_of(said: str) -> str:
    """What two failures have in common that are alike."""
    return ":".join(said.split(":")[:2])[:60]


def fewer(seed: int, calls: list[str], said: str) -> list[str]:
    """Leaves out what can be left out of a program that still fails alike."""
    part = len(calls) // 2
    while part > 0:
        at = 0
        while at < len(calls):
            shorter = calls[:at] + calls[at + part :]
            failure = in_a_process([(seed, shorter)])
            if failure is not None and kind_of(failure[1]) == kind_of(said):
                calls, said = shorter, failure[1]
            else:
                at += part
        part //= 2
    return calls


def pasted(seed: int, calls: list[str]) -> str:
    options = ", ".join(f"{name}={value!r}" for name, value in options_of(seed).items())
    lines = "".join(f"    {call!r},\n" for call in calls)
    return (
        "import displayfile\nfrom hostile import *\n\n"
        f"g = displayfile.System({options})\ng.record()\nfor call in [\n{lines}]:\n"
        "    try:\n        print(call, eval(call))\n"
        "    except Exception as error:\n        print(call, repr(error))\n"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--seed", type=int, default=1, help="of the first program [1]")
    parser.add_argument("--programs", type=int, default=100, help="how many [100]")
    parser.add_argument("--minutes", type=float, help="as many as these take, in their place")
    parser.add_argument("--calls", type=int, default=60, help="of each, about [60]")
    parser.add_argument("--tasks", help=argparse.SUPPRESS)
    said = parser.parse_args()
    if said.tasks:
        run_programs(json.loads(Path(said.tasks).read_text()))
        return 0
    begin, done = time.monotonic(), 0
    while (
        done < said.programs
        if said.minutes is None
        else time.monotonic() - begin < 60 * said.minutes
    ):
        count = AT_A_TIME if said.minutes is not None else min(AT_A_TIME, said.programs - done)
        seeds = range(said.seed + done, said.seed + done + count)
        programs = {seed: RandomCalls(seed).program(said.calls) for seed in seeds}
        failure = in_a_process(list(programs.items()))
        if failure is not None:
            seed, why = failure
            print(f"The program of --seed {seed} --calls {said.calls} fails:\n{why}\n")
            if os.environ.get("DISPLAYFILE_FUZZ_WHOLE") is None:
                print(pasted(seed, fewer(seed, programs[seed], why)))
            return 1
        done += count
    print(f"{done} programs, none of which failed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
