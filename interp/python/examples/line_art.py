"""Line art: a spiral staircase, of which exactly those lines are drawn that are seen.

    python3 interp/python/examples/line_art.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

import displayfile

STEPS, TURN, RISE = 24, 22.5, 0.19  # how many; each one's angle in degrees, and its height
RADIUS, THICKNESS, POST = 1.4, 0.06, 0.9
RAIL = RADIUS - 0.07  # where the posts stand, too


def on_circle(radius: float, degrees: Any) -> Any:
    angle = np.radians(degrees)
    points = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    return points.round(6)  # the same with every processor's cosine


def tube(along: Any, radius: float, facets: int = 16) -> tuple[Any, list[Any]]:
    """A tube about a line of points, (n, 3): its vertices and its faces, as mesh takes them."""
    tangent = np.gradient(along, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    side = np.cross(tangent, [0, 0, 1])
    up = np.cross(side, tangent)
    angle = np.linspace(0, 2 * np.pi, facets, endpoint=False)[:, None, None]
    rings = along + radius * (np.cos(angle) * side + np.sin(angle) * up)
    number = np.arange(facets * len(along)).reshape(facets, -1)
    beside = np.roll(number, -1, axis=0)
    faces = np.stack([number[:, :-1], number[:, 1:], beside[:, 1:], beside[:, :-1]], axis=-1)
    ends = [number[:, 0], number[::-1, -1]]
    return rings.round(6).reshape(-1, 3), [*faces.reshape(-1, 4), *ends]


system = displayfile.System(aspect=5 / 7, lines="outline,crease,intersection")
system.set_view_up(0, 0, 1)
system.set_view_reference_point(0, 0, 2.5)
system.set_perspective(4.5, -12, 6.5)  # the eye; it looks toward the reference point
system.set_view_plane_normal(-4.5, 12, -4)
system.set_window(-2.5, 2.5, -3.5, 3.5)
system.set_hidden_line_removal(True)
system.set_line_style("solid", 0, 0, 0, 1)

system.open_segment(1)
system.cylinder_3(0, 0, -0.1, 1.7, 0.1, 120)
system.cylinder_3(0, 0, 0, 0.15, STEPS * RISE + 0.6, 60)
for step in range(STEPS):
    begin, z = step * TURN, (step + 1) * RISE
    arc = np.linspace(begin - 2, begin + TURN, 9)
    system.extrude_3(z - THICKNESS, z, on_circle(RADIUS, arc), on_circle(0.1, arc[::-1]))
    system.cylinder_3(on_circle(RAIL, begin + TURN / 2), z, 0.016, POST, 16)
turns = np.linspace(0, STEPS, 12 * STEPS + 1)
rail = np.column_stack([on_circle(RAIL, turns * TURN), (turns + 0.5) * RISE + POST])
system.mesh(*tube(rail, 0.03))
system.close_segment()

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
system.save(folder / "line_art.svg", (500, 700), hidden="franklin")
