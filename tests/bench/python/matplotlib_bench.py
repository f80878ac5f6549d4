"""How long savefig takes of surfaces and filled contours: drawn exactly, over as matplotlib draws them.

    python3 tests/bench/python/matplotlib_bench.py [RUNS]

Prints for each picture and format the median seconds of both and their ratio. The runs of both
alternate, so that what else the machine does is shared.
"""

from __future__ import annotations

import io
import statistics
import sys
import time
from typing import Any, Callable

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

from displayfile.matplotlib import exact


def wave(ax: Any) -> None:
    """100 by 100 quads, coloured by height."""
    x, y = np.meshgrid(np.linspace(-1, 1, 101), np.linspace(-1, 1, 101))
    ax.plot_surface(x, y, np.sin(4 * x) * np.cos(4 * y), cmap="viridis", rstride=1, cstride=1)


def wave_of_one_colour(ax: Any) -> None:
    """The same, shaded, with edges in the colours of faces."""
    x, y = np.meshgrid(np.linspace(-1, 1, 101), np.linspace(-1, 1, 101))
    ax.plot_surface(x, y, np.sin(4 * x) * np.cos(4 * y), color="tab:blue", rstride=1, cstride=1)


def two_waves(ax: Any) -> None:
    """Two surfaces of 5,000 quads that pass through each other."""
    x, y = np.meshgrid(np.linspace(-1, 1, 101), np.linspace(-1, 1, 51))
    ax.plot_surface(x, y, np.sin(4 * x), color="tab:blue", rstride=1, cstride=1)
    ax.plot_surface(x, y, np.cos(4 * y), color="tab:orange", rstride=1, cstride=1)


def contours_on_walls(ax: Any) -> None:
    """Filled contours of ten levels, from 100 by 100 points, on three walls round a surface."""
    x, y = np.meshgrid(np.linspace(-3, 3, 100), np.linspace(-3, 3, 100))
    z = np.sin(x) * np.cos(y)
    ax.plot_surface(x, y, z, rstride=4, cstride=4)
    for wall, offset in (("z", -1.5), ("x", -3.5), ("y", 3.5)):
        ax.contourf(x, y, z, zdir=wall, offset=offset, levels=10)
    ax.set(xlim=(-4, 4), ylim=(-4, 4), zlim=(-1.6, 1.2))


def figure(fill: Callable[[Any], None], is_exact: bool) -> Any:
    made = plt.figure()
    ax = made.add_subplot(projection="3d")
    fill(ax)
    if is_exact:
        exact(ax)
    return made


def seconds(made: Any, format: str) -> float:
    begin = time.perf_counter()
    made.savefig(io.BytesIO(), format=format)
    return time.perf_counter() - begin


def main() -> None:
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    print(f"{'picture':20} {'format':6} {'plain s':>8} {'exact s':>8} {'ratio':>6}")
    for fill in (wave, wave_of_one_colour, two_waves, contours_on_walls):
        figures = figure(fill, False), figure(fill, True)
        for format in ("png", "svg", "pdf"):
            for made in figures:
                seconds(made, format)
            times = [[seconds(made, format) for made in figures] for _ in range(runs)]
            plain, by_exact = (statistics.median(column) for column in zip(*times))
            ratio = by_exact / plain
            print(f"{fill.__name__:20} {format:6} {plain:8.3f} {by_exact:8.3f} {ratio:6.2f}")


if __name__ == "__main__":
    main()
