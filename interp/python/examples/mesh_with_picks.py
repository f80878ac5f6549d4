"""A mesh with picks: where a landscape is clicked at, a pin; and what is seen from there in colours.

    python3 interp/python/examples/mesh_with_picks.py [FOLDER]
"""

from __future__ import annotations

import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import displayfile

SIZE = (900, 540)
CLICK = (475, 190)  # a pixel, from the upper left corner
COLOURS = [(0.3, 0.65, 0.45), (0.75, 0.85, 0.5), (1, 0.9, 0.55), (0.9, 0.6, 0.35), (1, 0.95, 0.9)]


def landscape(n: int = 181) -> tuple[Any, Any]:
    """Hills over a square: vertices (n * n, 3), and cells of four of them, (m, 4)."""
    random = np.random.default_rng(14)
    x, y = np.meshgrid(*[np.linspace(-2, 2, n)] * 2)
    z = np.zeros_like(x)
    for _ in range(70):
        width = random.uniform(0.15, 0.7)
        x0, y0 = random.uniform(-2, 2, 2)
        height = width * random.uniform(-0.3, 0.5)
        z += height * np.exp(-((x - x0) ** 2 + (y - y0) ** 2) / width**2)
    number = np.arange(n * n).reshape(n, n)
    corners = [number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]]
    # Rounded, they are the same with every processor's exponential function.
    vertices = np.stack([x, y, z], axis=-1).round(6)
    return vertices.reshape(-1, 3), np.stack(corners, axis=-1).reshape(-1, 4)


def viewed(fills: Any) -> displayfile.System:
    """The landscape in the picture's view."""
    system = displayfile.System(aspect=SIZE[0] / SIZE[1])
    system.set_view_up(0, 0, 1)
    system.set_perspective(-2, -9, 7)
    system.set_view_plane_normal(2, 9, -7)
    system.set_window(-2.5, 2.9, -1.84, 1.4)
    system.set_light(-3, 1, 4, 0.45)
    system.set_line_style("none")
    system.mesh(vertices, cells, fills=fills)
    return system


def seen_from(eye: Any) -> Any:
    """The cells that are seen from a place: on the six sides of a cube around it."""
    seen: list[Any] = []
    for toward in [*np.eye(3), *-np.eye(3)]:
        system = displayfile.System()
        system.set_perspective(eye)
        system.set_view_reference_point(eye + toward)
        system.set_view_plane_normal(toward)
        system.set_view_up(np.roll(toward, 1))
        system.set_view_depth(-0.999, 4)  # from the reference point: just before the eye
        system.mesh(vertices, cells)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a side may show the sky alone
            ids = system.draw(2048, hidden="z-buffer", ids=True, samples=1).ids
        seen.append(ids[ids >= 0])
    return np.unique(np.concatenate(seen))


vertices, cells = landscape()
heights = vertices[cells, 2].mean(axis=1).round(6)
fills = np.full((len(cells), 3), 0.85)

pick = viewed(fills).pick(*CLICK, SIZE)
assert pick is not None  # CLICK is on the landscape
place = vertices[cells[pick.id]].mean(axis=0)
seen = seen_from(place + (0, 0, 0.04))
scale = np.linspace(heights.min(), heights.max(), len(COLOURS))
for channel in range(3):
    fills[seen, channel] = np.interp(heights[seen], scale, [c[channel] for c in COLOURS])

system = viewed(fills)
system.open_segment(2)
system.set_fill_style("solid", 1, 0.15, 0.2)
system.set_shading("gouraud")
system.cylinder_3(place, 0.014, 0.3, 24)
system.sphere_3(place + (0, 0, 0.3), 0.075, 48)
system.close_segment()

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
system.save(folder / "mesh_with_picks.png", SIZE, hidden="z-buffer")
print(f"cell {pick.id}, height {heights[pick.id]:.3f}: {len(seen)} of {len(cells)} cells are seen")
