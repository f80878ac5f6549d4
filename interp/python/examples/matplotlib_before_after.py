"""Draws the pictures of matplotlib.md: as matplotlib draws them, and exactly.

    python3 interp/python/examples/matplotlib_before_after.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, Callable

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path as Outline
from mpl_toolkits.mplot3d import art3d

from displayfile.matplotlib import exact


def triangles_in_two_collections(ax: Any) -> None:
    """Issue 3894: the green triangle lies above the red one, in a collection of its own."""
    red = [[-90, -60, 40], [60, -80, 40], [-10, 90, 40]]
    blue = [[95, -110, 40], [120, -60, 40], [70, -75, 40]]
    green = [[-100, 40, 65], [20, -70, 65], [90, 70, 65]]
    ax.add_collection3d(art3d.Poly3DCollection([red, blue], facecolors=["tab:red", "tab:blue"]))
    ax.add_collection3d(art3d.Poly3DCollection([green], facecolors="tab:green"))
    ax.set(xlim=(-120, 120), ylim=(-120, 120), zlim=(0, 100))


def wave_behind_a_screen(ax: Any) -> None:
    """Issue 9499: a screen stands before a wave, both patches."""
    y = np.linspace(-15, 15, 600)
    z = 6 * np.cos(y / 5) * np.sin(3 * y)
    wave = PathPatch(Outline(np.column_stack([y, z])), facecolor="tab:orange", linewidth=0.8)
    screen = Rectangle((-7, -8), 13, 16, facecolor="0.65", edgecolor="black")
    for patch, x in ((wave, 0), (screen, 5)):
        ax.add_patch(patch)
        art3d.pathpatch_2d_to_3d(patch, z=x, zdir="x")
    ax.set(xlim=(-16, 16), ylim=(-16, 16), zlim=(-16, 16))
    ax.view_init(12, 50)


def surfaces_that_cross(ax: Any) -> None:
    """Issue 29060: two surfaces pass through each other; here with a line and markers."""
    x, y = np.meshgrid(np.linspace(-1, 1, 31), np.linspace(-1, 1, 31))
    edges = {"edgecolor": "black", "linewidth": 0.2, "rstride": 2, "cstride": 2}
    ax.plot_surface(x, y, 0.5 * np.sin(3 * x) * np.cos(2 * y), color="tab:blue", **edges)
    ax.plot_surface(x, y, 0.7 * y, color="tab:orange", **edges)
    t = np.linspace(0, 6 * np.pi, 300)
    ax.plot(0.6 * np.cos(t), 0.6 * np.sin(t), t / (3 * np.pi) - 1, color="black", linewidth=2)
    t = t[::20]
    ax.scatter(
        0.8 * np.cos(t), 0.8 * np.sin(t), t / (3 * np.pi) - 1, color="red", s=25, depthshade=False
    )


SCENES: dict[int, Callable[[Any], None]] = {
    3894: triangles_in_two_collections,
    9499: wave_behind_a_screen,
    29060: surfaces_that_cross,
}


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    plt.rcParams["font.size"] = 8
    for issue, fill in SCENES.items():
        figure = plt.figure(figsize=(7, 3.3))
        for k, title in enumerate(("matplotlib", "exact(ax)")):
            ax = figure.add_subplot(1, 2, k + 1, projection="3d", title=title)
            fill(ax)
        exact(ax)
        figure.subplots_adjust(left=0.03, right=0.97, bottom=0.03, top=0.93, wspace=0.05)
        figure.savefig(folder / f"matplotlib_{issue}.png", dpi=110)


if __name__ == "__main__":
    main()
