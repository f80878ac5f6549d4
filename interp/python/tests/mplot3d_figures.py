"""Forty and more small figures of the kinds that mplot3d's gallery shows.

Each is a function of a figure and a fineness, which multiplies the points of its meshes in each
direction. The test judges the coarse ones; tests/bench/python/mplot3d_bench.py times fine ones.
"""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from matplotlib.colors import to_rgba_array
from matplotlib.patches import Circle, Ellipse, PathPatch, Rectangle, RegularPolygon
from matplotlib.path import Path
from mpl_toolkits.mplot3d import art3d

FIGURES: dict[str, Callable[[Any, int], None]] = {}


def listed(fill: Callable[[Any, int], None]) -> Callable[[Any, int], None]:
    FIGURES[fill.__name__] = fill
    return fill


def axes(fig: Any, elev: float, azim: float, proj: str = "persp", place: Any = 111) -> Any:
    ax = fig.add_subplot(place, projection="3d", proj_type=proj)
    ax.view_init(elev, azim)
    return ax


def grid(n: int, low: float = -2.0, high: float = 2.0) -> Any:
    return np.meshgrid(np.linspace(low, high, n), np.linspace(low, high, n))


def ball(n: int, centre: Any = (0, 0, 0), radius: float = 1.0) -> Any:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * n), np.linspace(0, np.pi, n))
    unit = np.array([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)])
    return np.reshape(centre, (3, 1, 1)) + radius * unit


def surface(ax: Any, x: Any, y: Any, z: Any, **options: Any) -> Any:
    x, y, z = np.broadcast_arrays(x, y, z)
    return ax.plot_surface(x, y, z, rstride=1, cstride=1, **options)


def add_flat(ax: Any, patch: Any, z: float, zdir: str) -> None:
    ax.add_patch(patch)
    art3d.pathpatch_2d_to_3d(patch, z=z, zdir=zdir)


# ---- Surfaces ------------------------------------------------------------------------------


@listed
def ripple(fig: Any, fine: int) -> None:
    x, y = grid(14 * fine)
    z = np.cos(3 * np.hypot(x, y))
    surface(axes(fig, 35, -60), x, y, z, cmap="coolwarm", linewidth=0, antialiased=False)


@listed
def ripple_of_one_colour(fig: Any, fine: int) -> None:
    x, y = grid(12 * fine)
    surface(axes(fig, 50, 20), x, y, np.sin(2 * x) * y, color="tab:green")


@listed
def shaded_ball(fig: Any, fine: int) -> None:
    surface(axes(fig, 20, -35, "ortho"), *ball(8 * fine), color="tab:orange")


@listed
def chequered_saddle(fig: Any, fine: int) -> None:
    n = 10 * fine
    x, y = grid(n)
    even = np.add.outer(np.arange(n), np.arange(n)) % 2 == 0
    colours = np.where(even[..., None], (0.9, 0.8, 0.1), (0.1, 0.2, 0.6))
    surface(axes(fig, 28, 130), x, y, x * x - y * y, facecolors=colours, linewidth=0)


@listed
def surface_with_a_hole(fig: Any, fine: int) -> None:
    x, y = grid(13 * fine)
    z = np.where(np.hypot(x, y) < 0.8, np.nan, np.exp(-x * x - y * y))
    surface(axes(fig, 60, -100), x, y, z, cmap="plasma")


@listed
def surface_of_revolution(fig: Any, fine: int) -> None:
    t, h = np.meshgrid(np.linspace(0, 2 * np.pi, 16 * fine), np.linspace(-1, 1, 8 * fine))
    r = 0.4 + 0.5 * h * h
    surface(axes(fig, 15, 70), r * np.cos(t), r * np.sin(t), h, cmap="viridis", linewidth=0)


@listed
def two_balls(fig: Any, fine: int) -> None:
    ax = axes(fig, 25, -50)
    surface(ax, *ball(8 * fine, (-0.4, 0, 0)), color="tab:red", linewidth=0)
    surface(ax, *ball(8 * fine, (0.4, 0.2, 0.1)), color="tab:blue", linewidth=0)


@listed
def wave_and_plane(fig: Any, fine: int) -> None:
    ax = axes(fig, 40, -70, "ortho")
    x, y = grid(12 * fine)
    surface(ax, x, y, np.sin(2 * x), cmap="viridis", linewidth=0)
    surface(ax, *grid(2), 0.2, color="lightgray", shade=False)


@listed
def three_planes(fig: Any, fine: int) -> None:
    ax = axes(fig, 22, 35)
    u, v = grid(3 * fine, -1, 1)
    surface(ax, u, v, 0 * u, color="gold", shade=False)
    surface(ax, u, 0 * u, v, color="teal", shade=False)
    surface(ax, 0 * u, u, v, color="crimson", shade=False)


@listed
def translucent_surface_over_opaque(fig: Any, fine: int) -> None:
    ax = axes(fig, 45, -120)
    x, y = grid(9 * fine)
    surface(ax, x, y, 0.5 * np.sin(x) * np.sin(y), color="tab:blue", linewidth=0)
    surface(ax, *grid(2), 0.9, color="orange", alpha=0.5, shade=False, linewidth=0)


# ---- Wireframes ----------------------------------------------------------------------------


@listed
def wireframe(fig: Any, fine: int) -> None:
    x, y = grid(12 * fine)
    axes(fig, 30, -60).plot_wireframe(x, y, np.cos(x) * np.sin(2 * y), rcount=12, ccount=12)


@listed
def wireframe_round_a_ball(fig: Any, fine: int) -> None:
    ax = axes(fig, 10, 15)
    surface(ax, *ball(8 * fine), color="tab:cyan", linewidth=0)
    ax.plot_wireframe(*ball(8 * fine, radius=1.3), color="k", linewidth=0.6, rcount=8, ccount=8)


@listed
def wireframe_in_one_direction(fig: Any, fine: int) -> None:
    ax = axes(fig, 40, 45, "ortho")
    x, y = grid(12 * fine)
    surface(ax, *grid(2), 0.0, color="lightyellow", shade=False)
    ax.plot_wireframe(x, y, np.sin(2 * x) + 0.2 * y, rstride=0, cstride=fine, color="tab:red")


# ---- Triangles -----------------------------------------------------------------------------


def disc(n: int) -> Any:
    t, r = np.meshgrid(np.linspace(0, 2 * np.pi, 4 * n, endpoint=False), np.linspace(0.1, 1, n))
    return (r * np.cos(t)).ravel(), (r * np.sin(t)).ravel()


@listed
def triangles_of_a_saddle(fig: Any, fine: int) -> None:
    x, y = disc(5 * fine)
    axes(fig, 35, -45).plot_trisurf(x, y, np.sin(-2 * x * y), cmap="magma", linewidth=0.2)


@listed
def triangles_of_a_moebius_strip(fig: Any, fine: int) -> None:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 16 * fine), np.linspace(-0.4, 0.4, 4))
    r = 1 + v * np.cos(u / 2)
    points = [a.ravel() for a in (r * np.cos(u), r * np.sin(u), v * np.sin(u / 2))]
    n = 16 * fine
    k = (np.arange(3)[:, None] * n + np.arange(n - 1)).ravel()
    halves = [k, k + 1, k + n], [k + 1, k + n + 1, k + n]
    triangles = np.concatenate([np.column_stack(half) for half in halves])
    ax = axes(fig, 50, -80)
    ax.plot_trisurf(*points, triangles=triangles, cmap="Spectral", linewidth=0)


@listed
def triangles_through_a_plane(fig: Any, fine: int) -> None:
    ax = axes(fig, 30, 200)
    x, y = disc(5 * fine)
    ax.plot_trisurf(x, y, x * x + y * y - 0.4, color="tab:purple", linewidth=0)
    surface(ax, *grid(2, -1, 1), 0.0, color="khaki", shade=False)


# ---- Voxels and bars -----------------------------------------------------------------------


@listed
def voxels(fig: Any, fine: int) -> None:
    x, y, z = np.indices((4 * fine, 4 * fine, 4 * fine))
    cubes = (x < 2 * fine) & (y < 2 * fine) & (z < 2 * fine) | (x + y + z > 8 * fine)
    axes(fig, 30, -60).voxels(cubes, facecolors="tab:olive", edgecolor="k", linewidth=0.5)


@listed
def voxels_of_a_ball_in_colours(fig: Any, fine: int) -> None:
    n = 5 * fine
    at = np.indices((n, n, n))
    filled = ((at - (n - 1) / 2) ** 2).sum(axis=0) < (n / 2) ** 2
    colours = np.moveaxis(at / n, 0, -1)
    axes(fig, 20, 40, "ortho").voxels(filled, facecolors=colours, linewidth=0)


@listed
def translucent_voxels(fig: Any, fine: int) -> None:
    n = 2 * fine
    cubes = np.add.reduce(np.indices((n, n, n))) % 2 == 0
    axes(fig, 25, -130).voxels(cubes, facecolors="#1f77b480", linewidth=0)


@listed
def histogram_of_bars(fig: Any, fine: int) -> None:
    x, y = (v.ravel() for v in np.meshgrid(np.arange(4 * fine), np.arange(4 * fine)))
    height = 2 + np.sin(x) * np.cos(y)
    axes(fig, 35, -50).bar3d(x, y, 0 * x, 0.7, 0.7, height, color="c", edgecolor="k")


@listed
def bars_that_touch(fig: Any, fine: int) -> None:
    x, y = (v.ravel() for v in np.meshgrid(np.arange(4 * fine), np.arange(4 * fine)))
    colours = np.column_stack([x, y, 0 * x + 2]) / (4 * fine)
    axes(fig, 30, 120).bar3d(x, y, 0 * x, 1, 1, 1 + x * y / fine, color=colours, linewidth=0)


@listed
def flat_bars_in_rows(fig: Any, fine: int) -> None:
    ax = axes(fig, 25, -75)
    for row, colour in enumerate("rgby"):
        height = 1 + np.cos(np.arange(6 * fine) + row)
        ax.bar(np.arange(6 * fine), height, zs=row, zdir="y", color=colour, width=0.7)


# ---- Points and lines ----------------------------------------------------------------------


@listed
def scatter_in_and_round_a_ball(fig: Any, fine: int) -> None:
    ax = axes(fig, 20, -60)
    surface(ax, *ball(8 * fine), color="lightblue", linewidth=0)
    points = np.random.default_rng(1).normal(size=(3, 20 * fine))
    ax.scatter(*points, c="darkred", s=12, depthshade=False)


@listed
def scatter_of_two_kinds(fig: Any, fine: int) -> None:
    ax = axes(fig, 15, 30, "ortho")
    for seed, marker in ((2, "o"), (3, "^")):
        points = np.random.default_rng(seed).uniform(-1, 1, (3, 25 * fine))
        ax.scatter(*points, marker=marker, s=15)
    surface(ax, *grid(2, -1, 1), 0.0, color="wheat", shade=False)


@listed
def curve_round_a_column(fig: Any, fine: int) -> None:
    ax = axes(fig, 20, -40)
    t, h = np.meshgrid(np.linspace(0, 2 * np.pi, 16 * fine), np.linspace(-1, 1, 3))
    surface(ax, 0.5 * np.cos(t), 0.5 * np.sin(t), h, color="silver", linewidth=0)
    along = np.linspace(-4 * np.pi, 4 * np.pi, 120 * fine)
    ax.plot(np.cos(along), np.sin(along), along / 13, color="navy", linewidth=4)


@listed
def arrows_and_a_ball(fig: Any, fine: int) -> None:
    ax = axes(fig, 30, 60)
    x, y, z = np.meshgrid(*3 * [np.linspace(-1, 1, 2 + fine)])
    surface(ax, *ball(7 * fine, radius=0.7), color="salmon", linewidth=0)
    ax.quiver(x, y, z, y, -x, 0.2 * z + 0.1, length=0.5, linewidth=1.5)


@listed
def stems_on_a_plate(fig: Any, fine: int) -> None:
    ax = axes(fig, 15, -60)
    t = np.linspace(0, 2 * np.pi, 12 * fine)
    ax.stem(np.cos(t), np.sin(t), 1 + np.cos(t), bottom=-0.5)
    surface(ax, *grid(2, -1.2, 1.2), 0.5, color="palegreen", shade=False)


@listed
def error_bars_on_a_plate(fig: Any, fine: int) -> None:
    ax = axes(fig, 40, 20)
    t = np.linspace(-1, 1, 7 * fine)
    ax.errorbar(t, t**2, np.sin(3 * t), zerr=0.3, yerr=0.2, fmt="s", markersize=3)
    surface(ax, *grid(2, -1, 1), 0.0, color="thistle", shade=False)


# ---- Contours ------------------------------------------------------------------------------


@listed
def contours_in_space(fig: Any, fine: int) -> None:
    x, y = grid(12 * fine)
    ax = axes(fig, 45, -60)
    surface(ax, *grid(2), 0.1, color="linen", shade=False)
    ax.contour(x, y, np.cos(x) * np.cos(y), levels=6, cmap="coolwarm", linewidths=2)


@listed
def contours_on_a_wall(fig: Any, fine: int) -> None:
    x, y = grid(12 * fine)
    z = np.cos(x) * np.cos(y)
    ax = axes(fig, 30, -50)
    surface(ax, x, y, z, cmap="Blues", linewidth=0)
    ax.contour(x, y, z, zdir="z", offset=-1.5, levels=5, colors="k")
    ax.set_zlim(-1.5, 1)


def contours_on_walls(ax: Any, x: Any, y: Any, z: Any) -> None:
    for wall, offset in (("z", -1.5), ("x", -3), ("y", 3)):
        ax.contourf(x, y, z, zdir=wall, offset=offset, levels=8, cmap="coolwarm")
    ax.set(xlim=(-3, 3), ylim=(-3, 3), zlim=(-1.5, 1.2))


@listed
def filled_contours_on_walls(fig: Any, fine: int) -> None:
    x, y = grid(14 * fine)
    z = np.sin(x) * np.cos(y)
    ax = axes(fig, 30, -45)
    surface(ax, x, y, z, color="royalblue", linewidth=0)
    contours_on_walls(ax, x, y, z)


@listed
def patches_between_filled_contours(fig: Any, fine: int) -> None:
    """Patches of 4 x 4 cells, which are not flat, translucent and with edges."""
    x, y = grid(16 * fine + 1)
    z = np.sin(x) * np.cos(y)
    ax = axes(fig, 30, -60)
    ax.plot_surface(x, y, z, rstride=4, cstride=4, edgecolor="royalblue", lw=0.5, alpha=0.3)
    contours_on_walls(ax, x, y, z)


@listed
def opaque_patches_through_a_plane(fig: Any, fine: int) -> None:
    """From above: how patches are folded that are seen from the side is not defined."""
    x, y = grid(12 * fine + 1)
    ax = axes(fig, 75, 60)
    ax.plot_surface(x, y, np.cos(x) * np.cos(y), rstride=3, cstride=3, color="tab:olive")
    surface(ax, *grid(2), 0.1, color="lavender", shade=False)


@listed
def filled_contours_at_their_heights(fig: Any, fine: int) -> None:
    x, y = grid(14 * fine)
    axes(fig, 55, 30).contourf(x, y, np.sin(x) * np.cos(y), levels=6, cmap="viridis")


@listed
def filled_contours_of_triangles(fig: Any, fine: int) -> None:
    x, y = disc(5 * fine)
    axes(fig, 40, -30, "ortho").tricontourf(x, y, np.sin(3 * x) * y, levels=6, cmap="cividis")


# ---- Polygons and patches ------------------------------------------------------------------


@listed
def graphs_as_polygons(fig: Any, fine: int) -> None:
    ax = axes(fig, 20, -70)
    x = np.linspace(0, 10, 15 * fine)
    graphs = [
        np.column_stack([[0, *x, 10], np.full(len(x) + 2, row), [0, *(1 + np.sin(x + row)), 0]])
        for row in range(4)
    ]
    colours = to_rgba_array(list("rgby"))
    ax.add_collection3d(art3d.Poly3DCollection(graphs, facecolors=colours, alpha=0.7))
    ax.set(xlim=(0, 10), ylim=(-1, 4), zlim=(0, 2))


@listed
def patches_on_walls(fig: Any, fine: int) -> None:
    ax = axes(fig, 30, 40)
    add_flat(ax, Circle((1, 1), 0.8, color="tab:red"), 0.0, "x")
    add_flat(ax, Rectangle((0.3, 0.2), 1.2, 1.5, color="tab:green"), 1.0, "y")
    add_flat(ax, RegularPolygon((1, 1), 5, radius=0.7, color="tab:blue"), 0.5, "z")
    add_flat(ax, Ellipse((1, 1), 1.6, 0.5, color="tab:pink"), 1.2, "x")
    ax.set(xlim=(0, 2), ylim=(0, 2), zlim=(0, 2))


@listed
def patch_with_a_hole(fig: Any, fine: int) -> None:
    ax = axes(fig, 35, -110)
    outer = Path([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, 0)], closed=True)
    inner = Path([(-0.5, 0), (0, 0.5), (0.5, 0), (0, -0.5), (0, 0)], closed=True)
    add_flat(ax, PathPatch(Path.make_compound_path(outer, inner), color="orange"), 0.0, "z")
    surface(ax, *ball(6 * fine, (0, 0, 0.1), 0.4), color="steelblue", linewidth=0)
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))


@listed
def ring_of_overlapping_beams(fig: Any, fine: int) -> None:
    ax = axes(fig, 80, 10)
    turns = np.linspace(0, 2 * np.pi, 5, endpoint=False)
    beams = []
    for t in turns:
        along, across = np.array([np.cos(t), np.sin(t)]), np.array([-np.sin(t), np.cos(t)])
        corners = (-1, -0.15), (-1, 0.15), (1, 0.15), (1, -0.15)
        ends = [(across * s + along * (0.6 + d), s) for s, d in corners]
        beams.append([(*xy, 0.3 * z) for xy, z in ends])
    colours = to_rgba_array(list("rgbcm"))
    ax.add_collection3d(art3d.Poly3DCollection(beams, facecolors=colours, linewidth=0))
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))


@listed
def polyhedra_with_edges(fig: Any, fine: int) -> None:
    ax = axes(fig, 20, 25)
    corners = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], float)
    for sign, colour in ((1, "tab:orange"), (-1, "tab:cyan")):
        faces = [sign * np.delete(corners, k, axis=0) for k in range(4)]
        ax.add_collection3d(art3d.Poly3DCollection(faces, facecolor=colour, edgecolor="k"))
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))


# ---- Several kinds, and several axes -------------------------------------------------------


@listed
def words_and_a_surface(fig: Any, fine: int) -> None:
    ax = axes(fig, 30, -120)
    x, y = grid(10 * fine)
    surface(ax, x, y, np.exp(-x * x - y * y), cmap="YlGn", linewidth=0)
    ax.text(0, 0, 1.2, "top", ha="center")
    ax.text(-2, 2, 0, "along x", "x", fontsize=7)
    ax.invert_zaxis()


@listed
def subplots_of_four_views(fig: Any, fine: int) -> None:
    x, y = grid(7 * fine)
    for place, (elev, azim) in zip((221, 222, 223, 224), ((90, -90), (0, 0), (0, 90), (35, 215))):
        ax = axes(fig, elev, azim, "ortho", place)
        surface(ax, x, y, np.cos(2 * x) * 0.5, cmap="twilight", linewidth=0)
        surface(ax, *grid(2), 0.1, color="gray", shade=False, alpha=0.6)


@listed
def inverted_axes_with_all_kinds(fig: Any, fine: int) -> None:
    ax = axes(fig, -25, -60)
    x, y = grid(9 * fine)
    surface(ax, x, y, 0.3 * np.sin(3 * x), color="tab:brown", linewidth=0)
    ax.bar3d([-1.5, 0, 1], [-1, 0.5, 1], -1, 0.5, 0.5, 1.8, color="gold")
    ax.plot([-2, 2], [-2, 2], [-0.6, 0.6], color="lime", linewidth=3)
    ax.scatter([0, 1], [1, -1], [0.8, -0.8], s=20)
    ax.set(ylim=(2, -2), zlim=(1, -1))


@listed
def surface_of_logarithms(fig: Any, fine: int) -> None:
    ax = axes(fig, 30, 150)
    x, y = np.meshgrid(np.geomspace(1, 1e4, 9 * fine), np.linspace(0, 5, 9 * fine))
    surface(ax, np.log10(x), y, np.log10(x) * np.cos(y), cmap="inferno", linewidth=0)
    ax.plot([0, 4], [0, 5], [2, -2], color="deepskyblue", linewidth=3)
