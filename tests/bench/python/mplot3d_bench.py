"""How long savefig takes of figures like those of mplot3d's gallery: exact, over plain.

    python3 tests/bench/python/mplot3d_bench.py [--runs N] [--fine N] [--format png] [NAME...]

The figures are those that interp/python/tests/test_mplot3d_figures.py judges, with --fine times the
points in each direction, 3 if it is not set: meshes as fine as the gallery's. Each is saved both ways
in turn, after a first time of each; the ratio is that of the medians of processor time. Prints the
ratio of each figure, their geometric mean and the worst.
"""

from __future__ import annotations

import argparse
import io
import statistics
import sys
import time
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt

from displayfile.matplotlib import exact

sys.dont_write_bytecode = True
sys.path.append(str(Path(__file__).resolve().parents[3] / "interp" / "python" / "tests"))
from mplot3d_figures import FIGURES  # noqa: E402


def figure(name: str, fine: int, is_exact: bool) -> Any:
    made = plt.figure()
    FIGURES[name](made, fine)
    if is_exact:
        for ax in made.axes:
            exact(ax)
    return made


def seconds(made: Any, format: str) -> float:
    begin = time.process_time()
    made.savefig(io.BytesIO(), format=format)
    return time.process_time() - begin


def ratio(name: str, fine: int, format: str, runs: int) -> float:
    figures = figure(name, fine, False), figure(name, fine, True)
    for made in figures:
        seconds(made, format)
    times = [[seconds(made, format) for made in figures] for _ in range(runs)]
    plain, by_exact = (statistics.median(column) for column in zip(*times))
    plt.close("all")
    return by_exact / plain


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--fine", type=int, default=3)
    parser.add_argument("--format", default="png")
    parser.add_argument("names", nargs="*", default=list(FIGURES))
    options = parser.parse_args()
    ratios = {}
    for name in options.names:
        ratios[name] = ratio(name, options.fine, options.format, options.runs)
        print(f"{name:36} {ratios[name]:5.2f}", flush=True)
    worst = max(ratios, key=lambda name: ratios[name])
    print(f"{'geometric mean':36} {statistics.geometric_mean(ratios.values()):5.2f}")
    print(f"{'worst: ' + worst:36} {ratios[worst]:5.2f}")


if __name__ == "__main__":
    main()
