"""exact(ax, clip=True): nothing is drawn outside of the axes' limits; options of other types."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from displayfile import Error

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
matplotlib.use("agg")
from displayfile._matplotlib_crop import Crop  # noqa: E402
from displayfile.matplotlib import exact  # noqa: E402
from mpl_toolkits.mplot3d import art3d  # noqa: E402
from test_matplotlib import at, axes, closed_figures, pixels, rgb, surface  # noqa: E402, F401

GRID = np.meshgrid(np.linspace(-2, 2, 41), np.linspace(-2, 2, 41))


def drawn(ax: Any) -> Any:
    """Which pixels are not white, in a figure that is wider than the axes' own clipping."""
    for artist in ax.get_children():
        artist.set_clip_on(False)
    return pixels(ax).min(axis=2) < 250


def within(ax: Any) -> Any:
    """The pixels of the box of the limits: those of a solid one."""
    box = axes()
    box.set_proj_type(ax.get_proj_type() if hasattr(ax, "get_proj_type") else "persp")
    box.view_init(ax.elev, ax.azim)
    box.bar3d(-1, -1, -1, 2, 2, 2, color="black", shade=False)
    exact(box)
    return drawn(box)


def fill_surface(ax: Any) -> None:
    ax.plot_surface(*GRID, GRID[0] ** 2 - GRID[1] ** 2, color="red", edgecolor="black")


def fill_lines(ax: Any) -> None:
    t = np.linspace(0, 20, 400)
    ax.plot(1.6 * np.cos(t), 1.6 * np.sin(t), t / 5 - 2, "b", lw=1)
    ax.plot_wireframe(*GRID, 2 * np.sin(GRID[0]), lw=0.5)


def fill_contours(ax: Any) -> None:
    ax.contourf(*GRID, GRID[0] * GRID[1], zdir="z", offset=0, levels=7)


@pytest.mark.parametrize("fill", [fill_surface, fill_lines, fill_contours])
def test_nothing_is_drawn_outside_of_the_limits(fill: Any) -> None:
    ax = axes()
    fill(ax)
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    exact(ax)
    box = within(ax)
    beyond = box | np.roll(box, 3, 0) | np.roll(box, -3, 0) | np.roll(box, 3, 1) | np.roll(box, -3, 1)
    assert (drawn(ax) & ~beyond).sum() > 100
    exact(ax, clip=True)
    cropped = drawn(ax)
    assert (cropped & ~beyond).sum() == 0
    assert cropped.sum() > 100
    exact(ax)
    assert (drawn(ax) & ~beyond).sum() > 100


def test_what_is_within_stays_as_it_was() -> None:
    ax = axes()
    surface(ax, *np.meshgrid([-1.0, 0.0, 1.0], [-1.0, 1.0]), 0.0, "red", edgecolor="black")
    ax.plot([-1, 1], [0, 0], [0.5, 0.5], "b")
    exact(ax)
    before = pixels(ax)
    exact(ax, clip=True)
    assert np.array_equal(pixels(ax), before)


def test_markers_outside_are_left_out() -> None:
    ax = axes()
    ax.scatter([0, 1.5], [0, 0], [0, 0], c="blue", s=80, depthshade=False, clip_on=False)
    ax.plot([0, 0], [0.5, 0.5], [0.5, 1.4], "o", color="red", ms=9, clip_on=False)
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    exact(ax, clip=True)
    picture = pixels(ax)
    assert at(picture, ax, (0, 0, 0)) == rgb("blue")
    assert at(picture, ax, (0, 0.5, 0.5)) == rgb("red")
    assert at(picture, ax, (1.5, 0, 0)) == at(picture, ax, (0, 0.5, 1.4)) == rgb("white")


def test_sides_made_by_cropping_are_not_drawn() -> None:
    ax = axes()
    corners = [[(-3, -3, 0), (3, -3, 0), (3, 3, 0), (-3, 3, 0)]]
    ax.add_collection3d(art3d.Poly3DCollection(corners, facecolor="red", edgecolor="black", lw=4))
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    exact(ax, clip=True)
    assert (pixels(ax).max(axis=2) < 60).sum() == 0


def test_neighbours_are_cropped_at_the_same_point() -> None:
    crop = Crop(np.array([[-1.0, 1.0], [-1.0, 1.0], [0.1, 1.0]]))
    rng = np.random.default_rng(3)
    for _ in range(200):
        a, b, c, d = rng.uniform(-1, 1, (4, 3))
        left = crop.polygons(np.array([a, b, c, b, a, d]), np.array([3, 3]))
        if (a[2] < 0.1) == (b[2] < 0.1):
            continue
        part = (max(a[2], b[2]) - 0.1) / abs(a[2] - b[2])
        high, low = (a, b) if a[2] > b[2] else (b, a)
        near = high + part * (low - high)
        found = [
            p
            for k in (0, 1)
            for p in np.split(left.points, np.cumsum(left.sides)[:-1])[k].tolist()
            if np.abs(p - near).max() < 1e-9
        ]
        assert len(found) == 2 and found[0] == found[1]


def test_segments_are_cropped() -> None:
    crop = Crop(np.array([[-1.0, 1.0]] * 3))
    segments = np.array(
        [
            [(-2.5, 0, 0), (0, 2.5, 0)],  # past a corner
            [(-2, 0.5, 0), (2, 0.5, 0)],
            [(0, 0, 0), (0.5, 0.5, 0.5)],
            [(0, 0, 0), (0, 0, 4)],
            [(2, 0, 0), (3, 0, 0)],
        ],
        float,
    )
    left, is_outside = crop.segments(segments)
    assert is_outside.tolist() == [True, False, False, False, True]
    assert left[1].tolist() == [[-1, 0.5, 0], [1, 0.5, 0]]
    assert left[2].tolist() == segments[2].tolist()
    assert left[3].tolist() == [[0, 0, 0], [0, 0, 1]]


@pytest.mark.parametrize(
    "option, value",
    [
        *((name, bad) for name in ("lift", "halo") for bad in ("a", None, [1], 1j, True, np.nan)),
        *((name, bad) for name in ("clip", "off") for bad in (1, None, "yes", np.zeros(2))),
        *((name, bad) for name in ("method", "line_order") for bad in (3, None, [1], np.zeros(2))),
    ],
)
def test_options_of_other_types_are_errors(option: str, value: Any) -> None:
    ax = axes()
    with pytest.raises(Error):
        exact(ax, **{option: value})
    assert "draw" not in vars(ax)
