"""Lines that something hides in part end there, whatever their caps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
matplotlib.use("agg")
from matplotlib import colors, pyplot  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

from displayfile.matplotlib import exact  # noqa: E402

WIDTH = 12.0  # 17 pixels, about


@pytest.fixture(autouse=True)
def closed_figures() -> Any:
    yield
    pyplot.close("all")


def axes_with_a_wall(colour: str = "yellow", alpha: float = 1.0) -> Any:
    """Seen from the front, a wall up to z = 0; up and z are the same."""
    ax = pyplot.figure(figsize=(4, 4), dpi=100).add_axes((0, 0, 1, 1), projection="3d")
    ax.set_axis_off()
    ax.set_proj_type("ortho")
    ax.view_init(0, -90)
    wall = [(-1, -1, -1), (1, -1, -1), (1, -1, 0), (-1, -1, 0)]
    ax.add_collection3d(
        Poly3DCollection(
            [wall], facecolor=(*colors.to_rgb(colour), alpha), linewidth=0, antialiased=False
        )
    )
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    return ax


def pixels(ax: Any) -> Any:
    exact(ax)
    ax.figure.canvas.draw()
    return np.asarray(ax.figure.canvas.buffer_rgba())[:, :, :3]


def is_colour(picture: Any, colour: str) -> Any:
    return (picture == np.round(np.multiply(colors.to_rgb(colour), 255))).all(axis=2)


def top_of_wall(picture: Any) -> int:
    return int(np.flatnonzero(is_colour(picture, "yellow").any(axis=1))[0])


@pytest.mark.parametrize("cap", [None, "butt", "projecting", "round"])
def test_a_thick_line_ends_at_what_hides_the_rest(cap: str | None) -> None:
    ax = axes_with_a_wall()
    caps: Any = {"solid_capstyle": cap} if cap else {}
    ax.plot([0, 0], [1, 1], [-0.8, 0.8], color="red", lw=WIDTH, antialiased=False, **caps)
    picture = pixels(ax)
    red, top = is_colour(picture, "red"), top_of_wall(picture)
    assert red[top:].any(axis=1).sum() <= 1
    assert 15 <= red[top - 2].sum() <= 18, "it is as wide there as elsewhere"
    rows = np.flatnonzero(red.any(axis=1))
    ax = axes_with_a_wall()
    ax.plot([0, 0], [-2, -2], [-0.8, 0.8], color="red", lw=WIDTH, antialiased=False, **caps)
    whole = np.flatnonzero(is_colour(pixels(ax), "red").any(axis=1))
    assert rows[0] == whole[0], "its own end has the cap that it had"


@pytest.mark.parametrize("cap", ["projecting", "round"])
def test_a_line_that_is_hidden_at_both_ends(cap: str) -> None:
    ax = axes_with_a_wall()
    ax.add_collection3d(
        Poly3DCollection(
            [[(-1, -1, 0.4), (1, -1, 0.4), (1, -1, 1), (-1, -1, 1)]],
            facecolor="yellow",
            linewidth=0,
            antialiased=False,
        )
    )
    ax.plot(
        [0, 0], [1, 1], [-0.8, 0.8], color="red", lw=WIDTH, antialiased=False, solid_capstyle=cap
    )
    picture = pixels(ax)
    red, wall = is_colour(picture, "red"), is_colour(picture, "yellow")
    gap = np.flatnonzero(~wall[:, 100] & (np.cumsum(wall[:, 100]) > 0))[:-1]
    gap = gap[gap < np.flatnonzero(wall[:, 100])[-1]]
    rows = np.flatnonzero(red.any(axis=1))
    assert abs(rows[0] - gap[0]) <= 1 and abs(rows[-1] - gap[-1]) <= 1
    assert 15 <= red[gap[2]].sum() <= 18 and 15 <= red[gap[-3]].sum() <= 18


def test_a_point_of_a_polyline_at_the_edge_of_what_hides_the_next_segment() -> None:
    ax = axes_with_a_wall()
    z = np.linspace(-0.8, 0.8, 17)
    assert 0.0 in z.round(12)
    z = z.round(12)
    ax.plot(0 * z, 0 * z + 1, z, color="red", lw=WIDTH, antialiased=False)
    picture = pixels(ax)
    assert is_colour(picture, "red")[top_of_wall(picture) :].any(axis=1).sum() <= 1


@pytest.mark.parametrize("cap", ["projecting", "round"])
def test_dashes_end_at_what_hides_the_rest(cap: str) -> None:
    for offset in range(0, 24, 3):
        ax = axes_with_a_wall()
        ax.plot(
            [0, 0],
            [1, 1],
            [0.8, -0.8],
            color="red",
            lw=WIDTH,
            antialiased=False,
            linestyle=(offset / WIDTH, (1.0, 1.0)),
            dash_capstyle=cap,
        )
        picture = pixels(ax)
        red = is_colour(picture, "red")
        assert red.any() and red[top_of_wall(picture) :].any(axis=1).sum() <= 1


def test_markers_alone_behind_what_is_translucent() -> None:
    ax = axes_with_a_wall("blue", 0.5)
    ax.scatter([0.0], [1.0], [-0.5], s=400, c="red", depthshade=False)
    picture = pixels(ax)
    assert (np.abs(picture - np.array([127.5, 0.0, 127.5])) <= 1.0).all(axis=2).sum() > 300


@pytest.mark.parametrize("cap", ["projecting", "round"])
def test_a_line_goes_on_behind_what_is_translucent(cap: str) -> None:
    """There is no gap, and before the pane no cap reaches over it."""
    ax = axes_with_a_wall("blue", 0.5)
    ax.plot(
        [0, 0], [1, 1], [-0.8, 0.8], color="red", lw=WIDTH, antialiased=False, solid_capstyle=cap
    )
    picture = pixels(ax)
    red = is_colour(picture, "red")
    blended = (np.abs(picture - np.array([127.5, 0.0, 127.5])) <= 1.0).all(axis=2)
    top, bottom = np.flatnonzero(blended.any(axis=1))[[0, -1]]
    assert red[top:].any(axis=1).sum() <= 1
    column = int(np.flatnonzero(red[top - 40]).mean())
    on_axis = picture[np.flatnonzero(red.any(axis=1))[0] : bottom, column]
    assert len(on_axis) > 100 and on_axis[:, 1].max() < 60
