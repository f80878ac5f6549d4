"""A first drawing: shapes on a table, their shadows, and a picture of pixels.

    python3 interp/python/examples/first_drawing.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path

import displayfile

system = displayfile.System(aspect=3 / 2)
system.set_view_up(0, 0, 1)
system.set_view_plane_normal(-5, 9, -5.5)  # from the eye toward the scene
system.set_perspective(5, -9, 6)
system.set_view_reference_point(0.2, 0, 0.5)
system.set_window(-3.3, 3.3, -2.2, 2.2)
system.set_light(-4, -2, 9, 0.5)  # toward the light; 0.5 of it comes from all around
system.set_hidden_line_removal(True)
system.set_back_face_removal(False)  # what is turned away casts shadows too
system.set_line_style("none")
system.set_shading("phong")
system.set_shadows(True)

system.open_segment(1)
system.set_fill_style("solid", 1, 1, 1)
system.polygon_abs_3([(-30, -30, 0), (30, -30, 0), (30, 30, 0), (-30, 30, 0)])
system.set_fill_style("solid", 0.85, 0.33, 0.24)
system.torus_3(-1.3, 0.4, 0.35, 1.1, 0.35, 120)
system.set_fill_style("solid", 0.25, 0.45, 0.72)
system.sphere_3(0.5, -1, 0.7, 0.7, 120)
system.set_fill_style("solid", 0.93, 0.7, 0.25)
system.cone_3(1.6, 1.4, 0, 0.8, 2, 120)
system.close_segment()

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
system.save(folder / "first_drawing.png", (720, 480))
