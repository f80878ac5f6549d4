"""Draws the picture of dask.md: a turntable's views by two workers, as a sheet.

    python3 interp/python/examples/dask_turntable.py [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib.image
import numpy as np
from distributed import Client, LocalCluster

import displayfile
import displayfile.dask

VIEWS, COLUMNS, SIDE = 24, 8, 88


def knot() -> displayfile.PicklableSystem:
    """A tube along a curve that winds three times around while it turns twice."""
    t, u = np.meshgrid(np.linspace(0, 2 * np.pi, 361), np.linspace(0, 2 * np.pi, 25))
    r = 1 + 0.45 * np.cos(3 * t)
    x, y, z = r * np.cos(2 * t), 0.45 * np.sin(3 * t), r * np.sin(2 * t)
    out = np.stack([np.cos(2 * t), np.zeros_like(t), np.sin(2 * t)], axis=-1)
    up = np.array([0.0, 1.0, 0.0])
    tube = 0.2 * (np.cos(u)[..., None] * out + np.sin(u)[..., None] * up)
    points = np.stack([x, y, z], axis=-1) + tube
    k = np.arange(points[..., 0].size).reshape(t.shape)
    quads = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], axis=-1).reshape(-1, 4)
    angle = t[:-1, :-1].ravel()
    fills = 0.5 + 0.4 * np.stack([np.cos(angle + phase) for phase in (0, 2.1, 4.2)], axis=-1)

    system = displayfile.PicklableSystem()
    system.set_perspective(0, 4, 7)
    system.set_view_plane_normal(0, -0.5, -1)
    system.set_light(-1, 2, 2, 0.3)
    system.set_line_style("none")
    system.mesh(points.reshape(-1, 3), quads, fills=fills)
    return system


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(
        cluster
    ):
        views = displayfile.dask.turntable(
            knot(), VIEWS, SIDE, fit=True, hidden="z-buffer", samples=3
        )
        rows = views.reshape(-1, COLUMNS, SIDE, SIDE, 4).transpose(0, 2, 1, 3, 4)
        sheet = rows.reshape(-1, COLUMNS * SIDE, 4).compute()
    name = folder / "dask_turntable.png"
    matplotlib.image.imsave(name, sheet[..., :3], pil_kwargs={"optimize": True})


if __name__ == "__main__":
    main()
