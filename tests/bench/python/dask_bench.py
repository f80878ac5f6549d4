"""How fast two workers of a Dask cluster draw, beside one, and beside bare processes.

    python3 tests/bench/python/dask_bench.py DISPLAYFILE MESH [VIEWS] [SIDE] [ROUNDS]

DISPLAYFILE is the command. Two things are drawn into PNG files by the z-buffer: a turntable of 200
views of 512 x 512 pixels, and a picture of 20000 x 20000, by rows, unless other numbers are said.
The ways alternate, so that what else the machine does is shared:

- one process of the command;
- two at the same time, half of it each: what this machine has to give;
- a cluster of one worker, a process with one thread; and one of two.

Their times are compared, by medians; and the processor time, which tells more on a busy machine, that
the worker takes, and that the scheduler and the client take beside it.
"""

from __future__ import annotations

import contextlib
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import dask
from distributed import Client, LocalCluster

import displayfile
import displayfile.dask


class Job:
    """What is drawn: by the command, in parts, and by workers."""

    def __init__(
        self,
        what: str,
        number: int,
        words: Callable[[int, int, int], list[str]],
        saved: Callable[[], Any],
    ) -> None:
        self.what, self.number, self.words, self.saved = what, number, words, saved

    def processes(self, count: int) -> None:
        """So many at the same time."""
        ends = [self.number * k // count for k in range(count + 1)]
        parts = [self.words(k, *part) for k, part in enumerate(zip(ends, ends[1:]))]
        running = [subprocess.Popen(words) for words in parts]
        if any([process.wait() for process in running]):
            raise SystemExit("the command failed")

    def workers(self, client: Client) -> None:
        if not client.compute(self.saved()).result():
            raise SystemExit("nothing was drawn")


def jobs(command: str, mesh: str, views: int, side: int, folder: Path) -> list[Job]:
    system = displayfile.PicklableSystem()
    system.import_mesh(mesh)
    draw = [command, "draw", mesh, "--hidden", "z-buffer", "--samples", "1"]
    view, wall = folder / "view.png", folder / "wall.png"

    def words_of_views(_: int, first: int, end: int) -> list[str]:
        only = ["--turntable", f"{views}", "--views", f"{first}:{end}"]
        return [*draw, "-o", f"{view}", "--size", "512x512", *only]

    def words_of_rows(part: int, first: int, end: int) -> list[str]:
        only = ["--rows", f"{first}:{end}"]
        return [*draw, "-o", f"{folder}/part-{part}.png", "--size", f"{side}x{side}", *only]

    def saved_views() -> Any:
        return displayfile.dask.save_turntable(
            system, view, views, 512, hidden="z-buffer", samples=1
        )

    def saved_rows() -> Any:
        return displayfile.dask.save(system, wall, side, hidden="z-buffer", samples=1)

    return [
        Job(f"{views} views", views, words_of_views, saved_views),
        Job(f"{side} x {side} pixels", side, words_of_rows, saved_rows),
    ]


@contextlib.contextmanager
def cluster(workers: int) -> Any:
    with LocalCluster(
        n_workers=workers, threads_per_worker=1, dashboard_address=":0"
    ) as made, Client(made, set_as_default=False) as client:
        client.run(processor_time)
        yield client


def processor_time() -> float:
    return time.process_time()


def processor_time_of_children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds(work: Callable[[], object], clock: Callable[[], float] = time.perf_counter) -> float:
    begin = clock()
    work()
    return clock() - begin


def compare(job: Job, one: Client, two: Client, rounds: int) -> None:
    ways: dict[str, Callable[[], None]] = {
        "one process": lambda: job.processes(1),
        "two processes": lambda: job.processes(2),
        "one worker": lambda: job.workers(one),
        "two workers": lambda: job.workers(two),
    }
    times: dict[str, list[float]] = {way: [] for way in ways}
    shares: dict[str, list[float]] = {"worker": [], "beside": []}
    for work in ways.values():
        work()
    for _ in range(rounds):
        for way, work in ways.items():
            times[way].append(seconds(work))
        process = seconds(lambda: job.processes(1), processor_time_of_children)
        worker = sum(one.run(processor_time).values())
        beside = seconds(lambda: job.workers(one), processor_time)
        shares["worker"].append((sum(one.run(processor_time).values()) - worker) / process)
        shares["beside"].append(beside / process)

    def ratio(of: str, over: str) -> str:
        each = sorted(a / b for a, b in zip(times[of], times[over]))
        median = statistics.median(times[of]) / statistics.median(times[over])
        return f"{median:.2f} ({each[0]:.2f} to {each[-1]:.2f})"

    print(f"{job.what}, {rounds} rounds: ratios of times, and their ranges")
    print(f"  two processes are faster than one:  {ratio('one process', 'two processes')} times")
    print(f"  two workers are faster than one:    {ratio('one worker', 'two workers')} times")
    print(f"  one worker takes, of one process:   {ratio('one worker', 'one process')}")
    print(f"  two workers take, of two processes: {ratio('two workers', 'two processes')}")
    print("  processor time, of one process of the command:")
    print(f"    one worker:           {statistics.median(shares['worker']):.2f}")
    print(f"    scheduler and client: {statistics.median(shares['beside']):.2f}")


def main() -> None:
    command, mesh = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    views, side, rounds = map(int, [*sys.argv[3:6], *("200", "20000", "5")[len(sys.argv[3:6]) :]])
    dask.config.set({"distributed.comm.timeouts.connect": "60s"})
    with tempfile.TemporaryDirectory() as folder, cluster(1) as one, cluster(2) as two:
        for job in jobs(command, mesh, views, side, Path(folder)):
            compare(job, one, two, rounds)


if __name__ == "__main__":
    main()
