"""Figures like those of mplot3d's gallery, and random polygons, against a ray caster."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402
from mpl_toolkits.mplot3d import art3d  # noqa: E402
from mplot3d_figures import FIGURES  # noqa: E402
from ray_caster import Verdict, judge  # noqa: E402

from displayfile.matplotlib import exact  # noqa: E402


@pytest.fixture(autouse=True)
def closed_figures() -> Any:
    yield
    pyplot.close("all")


def figure() -> Any:
    return pyplot.figure(figsize=(3.2, 3.2), dpi=100)


def picture_of(fig: Any, **options: Any) -> Any:
    for ax in fig.axes:
        ax.set_axis_off()
        exact(ax, **options)
    fig.canvas.draw()
    return np.asarray(fig.canvas.buffer_rgba())[..., :3].copy()


def judged(name: str) -> list[Verdict]:
    fig = figure()
    FIGURES[name](fig, 1)
    picture = picture_of(fig)
    return [judge(ax, picture) for ax in fig.axes]


def test_there_are_forty_figures() -> None:
    assert len(FIGURES) >= 40


@pytest.mark.parametrize("name", FIGURES)
def test_no_pixel_away_from_edges_is_wrong(name: str) -> None:
    verdicts = judged(name)
    assert sum(v.wrong for v in verdicts) == 0, verdicts
    # There was something to judge: of wires alone there is nothing but their edges.
    assert name == "wireframe" or sum(v.judged for v in verdicts) > 1500


def test_lines_are_judged_too() -> None:
    for name in ("curve_round_a_column", "contours_in_space", "surface_of_logarithms"):
        assert judged(name)[0].lines > 100


def random_polygons(seed: int, sides: int) -> Any:
    """Convex polygons that pass through each other, in cycles too."""
    rng = np.random.default_rng(seed)
    polygons = []
    for _ in range(12):
        turns = np.sort(rng.uniform(0, 2 * np.pi, sides))
        frame = np.linalg.qr(rng.normal(size=(3, 3)))[0][:2]
        middle = rng.uniform(-0.4, 0.4, 3)
        ring = np.column_stack([np.cos(turns), np.sin(turns)]) @ frame
        polygons.append(middle + ring * rng.uniform(0.4, 1))
    return polygons, np.column_stack([rng.random((12, 3)), np.ones(12)])


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
@pytest.mark.parametrize("sides", [3, 4, 6])
@pytest.mark.parametrize("edges", ["none", "black", "face"])
def test_polygons_in_pieces_have_no_seams(method: str, sides: int, edges: str) -> None:
    for seed in range(3):
        fig = figure()
        ax = fig.add_subplot(projection="3d", proj_type=("persp", "ortho")[seed % 2])
        polygons, colours = random_polygons(seed, sides)
        edge = {"none": "none", "black": "k", "face": colours}[edges]
        shown = art3d.Poly3DCollection(polygons, facecolor=colours, edgecolor=edge)
        ax.add_collection3d(shown)
        ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
        # Where several cuts meet in a pixel it may be off by as much.
        verdict = judge(ax, picture_of(fig, method=method), tolerance=6)
        assert verdict.wrong == 0 and verdict.judged > 1000, verdict


def test_the_judge_finds_a_polygon_that_was_moved() -> None:
    fig = figure()
    FIGURES["three_planes"](fig, 1)
    picture = picture_of(fig)
    (ax,) = fig.axes
    assert judge(ax, picture).wrong == 0
    plane = next(a for a in ax.get_children() if isinstance(a, art3d.Poly3DCollection))
    plane._vec[2] += 0.1
    assert judge(ax, picture).wrong > 100


def test_the_judge_finds_a_line_that_is_not_hidden() -> None:
    fig = figure()
    FIGURES["curve_round_a_column"](fig, 1)
    (ax,) = fig.axes
    column, curve = ax.get_children()[:2]
    ax.set_axis_off()
    column.set_zorder(1)
    curve.set_zorder(2)
    ax.computed_zorder = False
    fig.canvas.draw()
    assert judge(ax, np.asarray(fig.canvas.buffer_rgba())[..., :3]).wrong > 50


def test_the_judge_finds_what_matplotlib_itself_draws_wrong() -> None:
    wrong = 0
    for name in ("two_balls", "three_planes", "wave_and_plane", "patches_on_walls"):
        fig = figure()
        FIGURES[name](fig, 1)
        for ax in fig.axes:
            ax.set_axis_off()
        fig.canvas.draw()
        wrong += judge(fig.axes[0], np.asarray(fig.canvas.buffer_rgba())[..., :3]).wrong
    assert wrong > 1000
