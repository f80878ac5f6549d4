"""A paper's figure: two potential surfaces that meet in a point, with axes, as vectors.

    python3 interp/python/examples/paper_figure.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

import displayfile


def sheet(sign: float, radius: float, rings: int, spokes: int = 48) -> tuple[Any, Any]:
    """The energy r²/2 ± r over a disc: points (spokes + 1, rings + 1, 3), and cells (m, 4)."""
    r, angle = np.meshgrid(np.linspace(0, radius, rings + 1), np.linspace(0, 2 * np.pi, spokes + 1))
    points = np.stack([r * np.cos(angle), r * np.sin(angle), r**2 / 2 + sign * r], axis=-1)
    number = np.arange(r.size).reshape(r.shape)
    corners = [number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]]
    # Rounded, the points are the same with every processor's cosine.
    return points.round(6), np.stack(corners, axis=-1).reshape(-1, 4)


system = displayfile.System(aspect=5 / 4)
system.set_view_up(0, 0, 1)
system.set_parallel(-2.2, -3, 1.6)  # toward the viewer
system.set_view_plane_normal(2.2, 3, -1.6)
system.set_view_reference_point(0, 0, 0.75)
system.set_window(-3.4, 2.85, -2.7, 2.3)
system.set_hidden_line_removal(True)
system.set_back_face_removal(False)  # both sides of a sheet are seen
system.set_hidden_scope("all")
system.set_light(-3, -3, 3, 0.55)

system.set_line_style("solid", 0.2, 0.2, 0.25, 0.4)
lower, cells = sheet(-1, 1.8, 18)
system.mesh(lower.reshape(-1, 3), cells, fill=(0.6, 0.75, 0.95))
upper, cells = sheet(1, 1.3, 13)
system.mesh(upper.reshape(-1, 3), cells, fill=(1, 0.82, 0.5))

system.open_segment(3)
system.set_line_style("solid", 0.75, 0.05, 0.1, 2)
spoke = 29  # a path down a spoke of one sheet, and on down the other
path = [*upper[spoke, 10:0:-1], *lower[spoke, :11]]
system.move_abs_3(path[0])
for point in path[1:]:
    system.line_abs_3(point)
system.set_line_style("solid", 0, 0, 0, 0.8)
system.set_text_style(0.036)
system.axes_3(-1.9, 1.9, -1.9, 1.9, -0.5, 2.5, "x", "y", "E")
system.close_segment()

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
system.save(folder / "paper_figure.svg", (600, 480), hidden="map")  # .pdf for LaTeX
