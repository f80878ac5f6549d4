from __future__ import annotations

import copy
import io
import pickle
from typing import Any, Callable

import numpy as np
import pytest

import displayfile

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
matplotlib.use("agg")
from matplotlib import colors, pyplot  # noqa: E402
from matplotlib.patches import Circle, PathPatch, Rectangle  # noqa: E402
from matplotlib.path import Path  # noqa: E402
from mpl_toolkits.mplot3d import art3d, proj3d  # noqa: E402

from displayfile import _matplotlib_private as private  # noqa: E402
from displayfile._matplotlib_artists import _rings  # noqa: E402
from displayfile.matplotlib import exact  # noqa: E402

SQUARE = np.meshgrid([-1.0, 1.0], [-1.0, 1.0])


@pytest.fixture(autouse=True)
def closed_figures() -> Any:
    yield
    pyplot.close("all")


def axes(**options: Any) -> Any:
    made = pyplot.figure(figsize=(4, 4), dpi=100).add_subplot(projection="3d", **options)
    made.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    made.set_axis_off()
    return made


def pixels(ax: Any) -> np.ndarray[Any, Any]:
    ax.figure.canvas.draw()
    return np.asarray(ax.figure.canvas.buffer_rgba())[:, :, :3].astype(int)


def place(ax: Any, point: Any) -> tuple[int, int]:
    """The row and column of a point's pixel."""
    x, y, _ = proj3d.proj_transform(*point, ax.get_proj())
    column, row = ax.transData.transform((x, y))
    return int(ax.figure.bbox.height - row), int(column)


def at(picture: Any, ax: Any, point: Any) -> tuple[int, ...]:
    return tuple(picture[place(ax, point)])


def rgb(colour: Any) -> tuple[int, ...]:
    return tuple(round(255 * v) for v in colors.to_rgb(colour))


def shows(picture: Any, ax: Any, point: Any, colour: str) -> bool:
    """Whether the pixel has the colour, or nearly: a seam of the surface may run through it."""
    return bool(np.abs(np.subtract(at(picture, ax, point), rgb(colour))).max() < 50)


def toward_eye(ax: Any) -> Any:
    """In an orthographic projection: the direction in which nothing moves in the picture."""
    matrix = ax.get_proj()
    direction = np.linalg.svd(matrix[:2, :3])[2][2]
    return direction if matrix[2, :3] @ direction < 0 else -direction


def differ(a: Any, b: Any) -> tuple[float, float]:
    """The mean difference, and the part of pixels that differ by more than a quarter."""
    off = np.abs(a - b).max(axis=2)
    return float(off.mean()), float((off > 64).mean())


def surface(ax: Any, x: Any, y: Any, z: Any, colour: str, **options: Any) -> Any:
    return ax.plot_surface(
        *np.broadcast_arrays(x, y, z), color=colour, shade=False, rstride=1, cstride=1, **options
    )


def rug_on_floor(shift: float) -> Any:
    """Axes with a rug in the plane of a sloping floor, and a line on the rug."""
    ax = pyplot.figure(figsize=(4, 4), dpi=100).add_subplot(projection="3d")
    ax.set_axis_off()
    floor = np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]])
    corners = np.array([floor, 0.1 + 0.6 * floor])
    z = 0.3 * corners[..., 0] + 0.7 * corners[..., 1]
    shapes = np.dstack([corners + shift, z])
    ax.add_collection3d(art3d.Poly3DCollection(shapes[:1], facecolor="blue"))
    ax.add_collection3d(art3d.Poly3DCollection(shapes[1:], facecolor="red"))
    ends = shapes[1][[0, 2]]
    ax.plot(*ends.T, color="lime", linewidth=4)
    ax.set(xlim=(shift - 1, shift + 1), ylim=(shift - 1, shift + 1), zlim=(-1, 1))
    return ax


def test_rings_of_a_path_are_closed_where_it_closes_them() -> None:
    points = np.arange(33.0).reshape(11, 3)
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    codes += [Path.MOVETO, *[Path.LINETO] * 3, Path.MOVETO, Path.CURVE3, Path.CURVE3]
    (first, closes), (second, closes_too), (curve, _) = _rings(points, codes)
    assert (first == points[:3]).all() and closes
    assert (second == points[4:8]).all() and not closes_too
    assert len(curve) > 4 and (curve[[0, -1]] == points[[8, 10]]).all()


def test_options_that_are_set_later_are_checked() -> None:
    drawn = exact(pyplot.figure().add_subplot(projection="3d"), lift=0.5)
    drawn.clip, drawn.lift, drawn.line_order = True, 0, "depth"
    drawn.halo = 2
    assert "method='depth-sort'" in repr(drawn) and "halo=2.0" in repr(drawn)
    for name, bad in (
        *(("clip", "yes"), ("method", "x"), ("lift", 1.0), ("line_order", "entry")),
        *(("halo", -1), ("cilp", True)),
    ):
        with pytest.raises(displayfile.Error):
            setattr(drawn, name, bad)
    assert (drawn.clip, drawn.lift, drawn.halo) == (True, 0.0, 2.0)
    assert copy.deepcopy(drawn.ax).draw.__self__.halo == 2.0


@pytest.mark.parametrize("proj_type", ["persp", "ortho"])
@pytest.mark.parametrize("shift", [738_000.0 / 3, 1e9])
def test_what_touches_lies_in_one_plane_on_axes_of_dates(shift: float, proj_type: str) -> None:
    for azim in (-60, 15, 130):
        pictures = []
        for off in (0.0, shift):
            ax = rug_on_floor(off)
            ax.set_proj_type(proj_type)
            ax.view_init(55, azim)
            exact(ax)
            pictures.append(pixels(ax))
        assert differ(*pictures)[1] < 0.002
        red = (np.abs(pictures[1] - rgb("red")).max(axis=2) < 50).mean()
        assert red > 0.03


@pytest.mark.parametrize("method", ["depth-sort", "bsp"])
def test_planes_that_cross_hide_each_other_where_calculation_says(method: str) -> None:
    ax = axes(proj_type="ortho")
    u, v = SQUARE
    planes = {0: "red", 1: "blue", 2: "lime"}
    surface(ax, 0.0, u, v, planes[0])
    surface(ax, u, 0.0, v, planes[1])
    surface(ax, u, v, 0.0, planes[2])
    exact(ax, method=method)
    for elev, azim in ((30, -60), (12, 50), (-35, 160)):
        ax.view_init(elev, azim)
        picture = pixels(ax)
        eye = toward_eye(ax)
        checked = 0
        for axis, colour in planes.items():
            for a, b in np.random.default_rng(axis).uniform(-0.95, 0.95, (40, 2)):
                point = np.insert([a, b], axis, 0.0)
                hidden, near_a_side = False, False
                for other in set(planes) - {axis}:
                    t = -point[other] / eye[other]
                    hit = np.abs(np.delete(point + t * eye, other)).max()
                    near_a_side |= abs(hit - 1.0) < 0.1 or abs(point[other]) < 0.1
                    hidden |= t > 0.0 and hit < 1.0
                if near_a_side:
                    continue
                assert shows(picture, ax, point, colour) is not hidden
                checked += 1
        assert checked > 40


def torus(ax: Any, colour: str, upright: bool) -> None:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 49), np.linspace(0, 2 * np.pi, 25))
    x, y = (0.5 + 0.12 * np.cos(v)) * (np.cos(u), np.sin(u))
    z = 0.12 * np.sin(v)
    surface(ax, *((x + 0.5, z, y) if upright else (x, y, z)), colour)


def test_linked_tori_pass_through_each_other_s_holes() -> None:
    ax = axes(proj_type="ortho")
    torus(ax, "red", False)
    torus(ax, "blue", True)
    exact(ax)
    ax.view_init(35, -50)
    picture = pixels(ax)
    # Points on the tori that are nearest to the eye there: of each torus one before the other.
    eye = toward_eye(ax)
    eye /= np.linalg.norm(eye)
    seen = set()
    for turn in np.linspace(0, 2 * np.pi, 24, endpoint=False):
        for upright, colour in ((False, "red"), (True, "blue")):
            c, s = 0.5 * np.cos(turn), 0.5 * np.sin(turn)
            centre = np.array([c + 0.5, 0.0, s] if upright else [c, s, 0.0])
            if not ray_meets_torus(centre, eye, not upright):
                continue
            own = ray_meets_torus(centre + 0.3 * eye, eye, upright)
            if not own:
                assert shows(picture, ax, centre, "blue" if colour == "red" else "red")
                seen.add(colour)
    assert seen == {"red", "blue"}


def ray_meets_torus(origin: Any, direction: Any, upright: bool) -> bool:
    """Whether the ray passes well within the tube."""
    p = origin + np.linspace(0.0, 3.0, 3001)[:, None] * direction
    x, y, z = (p[:, 0] - 0.5, p[:, 2], p[:, 1]) if upright else p.T
    return bool((np.hypot(np.hypot(x, y) - 0.5, z) < 0.06).any())


def test_a_wave_with_a_plane_and_a_line() -> None:
    ax = axes(proj_type="ortho")
    x, y = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41))
    surface(ax, x, y, 0.5 * np.sin(np.pi * x), "red")
    surface(ax, *SQUARE, 0.0, "blue")
    ax.plot([0.5, 0.5], [0.0, 0.0], [-1.0, 1.0], color="lime", lw=4)
    exact(ax)
    ax.view_init(40, -90)
    picture = pixels(ax)
    assert at(picture, ax, (0.325, 0.625, 0.5 * np.sin(0.325 * np.pi))) == rgb("red")
    assert at(picture, ax, (-0.5, 0.6, 0.0)) == rgb("blue")
    assert at(picture, ax, (0.5, 0.0, 0.8)) == rgb("lime")
    assert at(picture, ax, (0.5, 0.0, 0.4)) != rgb("lime")
    assert at(picture, ax, (0.5, 0.0, -0.2)) != rgb("lime")


def test_markers_are_hidden_where_they_are_behind() -> None:
    ax = axes()
    surface(ax, *SQUARE, 0.0, "red")
    points = np.array([[-0.5, 0, -0.4], [0.5, 0, 0.4], [0, 0.5, 0.0], [0.2, -0.5, -0.2]])
    ax.scatter(*points.T, c="blue", s=80, depthshade=False)
    ax.plot(*(points + [0.1, 0.2, 0.0]).T, "s", color="lime")
    exact(ax)
    for elev, shown in ((60, [False, True, True, False]), (-60, [True, False, True, True])):
        ax.view_init(elev, -70)
        picture = pixels(ax)
        for point, is_shown in zip(points, shown):
            assert (at(picture, ax, point) == rgb("blue")) is is_shown
            assert (at(picture, ax, point + [0.1, 0.2, 0.0]) == rgb("lime")) is is_shown


def test_markers_keep_their_own_colours_and_sizes() -> None:
    ax = axes()
    surface(ax, *SQUARE, -0.9, "white")
    points = np.random.default_rng(5).uniform(-0.8, 0.8, (3, 30))
    ax.scatter(*points, c=points[0], s=np.linspace(5, 90, 30), cmap="jet", edgecolors="k")
    plain = pixels(ax)
    exact(ax)
    mean, far = differ(pixels(ax), plain)
    assert mean == 0.0 and far == 0.0


def blended(front: Any, alpha: float, back: Any) -> Any:
    return [alpha * f + (1 - alpha) * b for f, b in zip(rgb(front), rgb(back))]


def test_translucent_polygons_hide_nothing_and_are_drawn_in_order() -> None:
    ax = axes()
    surface(ax, *SQUARE, 0.5, "red", alpha=0.5)
    surface(ax, *SQUARE, 0.0, "lime", alpha=0.5)
    surface(ax, *SQUARE, -0.5, "blue")
    ax.plot([-0.5, 0.5], [0, 0], [0.25, 0.25], "k", lw=5)
    ax.scatter([0.0], [0.5], [0.25], c="yellow", s=100, depthshade=False)
    exact(ax)
    ax.view_init(90, -90)
    picture = pixels(ax)
    both = np.array(blended("lime", 0.5, "blue")) * 0.5 + np.array(rgb("red")) * 0.5
    assert np.abs(at(picture, ax, (0.5, -0.5, 0.5)) - both).max() <= 2
    below_red = blended("red", 0.5, "black")
    assert np.abs(np.subtract(at(picture, ax, (0.25, 0.0, 0.25)), below_red)).max() <= 2
    tinted = blended("red", 0.5, "yellow")
    assert np.abs(np.subtract(at(picture, ax, (0.0, 0.5, 0.25)), tinted)).max() <= 2
    ax.view_init(-90, -90)  # From below the opaque plane hides all else.
    assert at(pixels(ax), ax, (0.5, -0.5, -0.5)) == rgb("blue")
    assert at(pixels(ax), ax, (0.25, 0.0, -0.5)) == rgb("blue")


def test_a_line_in_a_surface_stays_whole() -> None:
    ax = axes()
    x, y = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-1, 1, 21))
    z = 0.3 * np.sin(3 * x) * np.cos(3 * y)
    surface(ax, x, y, z, "white")
    ax.plot(x[10], y[10], z[10], color="blue", lw=3)
    exact(ax)
    ax.view_init(60, -70)
    picture = pixels(ax)
    for k in range(20):
        a, b = ([v[10, j] for v in (x, y, z)] for j in (k, k + 1))
        assert at(picture, ax, np.add(a, b) / 2) == rgb("blue")


@pytest.mark.parametrize("proj_type", ["ortho", "persp"])
def test_lines_in_faces_are_whole_without_a_lift(proj_type: str) -> None:
    """On a floor, in a slope, along the sides of voxels, with coordinates in decimals."""
    x, y = np.meshgrid(np.linspace(0, 0.9, 4), np.linspace(0, 1.2, 5))
    spiral = np.linspace(0, 12, 60)
    u, v = 0.45 + 0.03 * spiral * np.cos(spiral), 0.6 + 0.04 * spiral * np.sin(spiral)
    inside = (u > 0) & (u < 0.9) & (v > 0) & (v < 1.2)
    u, v = u[inside], v[inside]
    for elev, azim in ((30, -60), (12, 50), (60, 160), (20, -130)):
        pictures = []
        for with_faces in (True, False):
            ax = axes(proj_type=proj_type)
            ax.view_init(elev, azim)
            ax.set(xlim=(0, 0.9), ylim=(0, 1.2), zlim=(0, 0.7))
            if with_faces:
                ax.plot_surface(x, y, 0.1 + 0.3 * x + 0.17 * y, color="yellow", shade=False)
            ax.plot(u, v, 0.1 + 0.3 * u + 0.17 * v, color="black", linewidth=2)
            exact(ax)
            pictures.append(pixels(ax).max(axis=2) < 60)
        assert pictures[1].sum() > 200
        assert (pictures[0] & pictures[1]).sum() > 0.98 * pictures[1].sum()


def crossing_lines(**options: Any) -> Any:
    """The red line, drawn later, is behind the blue one."""
    ax = axes()
    ax.view_init(90, -90)
    ax.plot([-0.8, 0.8], [0.1, 0.1], [0.5, 0.5], color="blue", linewidth=6)
    ax.plot([0.1, 0.1], [-0.8, 0.8], [-0.5, -0.5], color="red", linewidth=6)
    exact(ax, **options)
    return ax


def test_of_lines_that_cross_the_nearer_one_is_over_the_farther_one() -> None:
    for options, colour in [({}, "red"), ({"line_order": "depth"}, "blue")]:
        ax = crossing_lines(**options)
        # Where they cross in the picture: the nearer one's middle is over the other somewhere.
        picture = pixels(ax)
        red = (picture == rgb("red")).all(axis=2)
        blue = (picture == rgb("blue")).all(axis=2)
        column = int(np.median(np.flatnonzero(red.any(axis=0))))
        row = int(np.median(np.flatnonzero(blue.any(axis=1))))
        assert (red if colour == "red" else blue)[row, column]


def test_a_halo_leaves_a_gap_in_the_farther_line() -> None:
    ax = crossing_lines(line_order="depth", halo=4.0)
    picture = pixels(ax)
    red = (picture == rgb("red")).all(axis=2)
    blue = (picture == rgb("blue")).all(axis=2)
    column = int(np.median(np.flatnonzero(red.any(axis=0))))
    rows = np.flatnonzero(red[:, column])
    gap = np.diff(rows).max() - 1
    # 4 points on both sides of a line of 6, and the pixels at its ends that are partly covered.
    assert abs(gap - (2 * 4 + 6) * 100 / 72) <= 3
    assert blue[:, column].sum() >= 6


def test_a_surface_beside_lines_keeps_their_order() -> None:
    ax = crossing_lines(line_order="depth")
    ax.plot_surface(*SQUARE, np.full((2, 2), -0.9), color="white", shade=False)
    picture = pixels(ax)
    blue = (picture == rgb("blue")).all(axis=2)
    rows = np.flatnonzero(blue.any(axis=1))
    row = int(np.median(rows))
    columns = np.flatnonzero(blue[row])
    assert (np.diff(columns) == 1).all()  # not interrupted


def test_dashes_go_on_behind_what_hides_a_part() -> None:
    ax = axes()
    ax.view_init(90, -90)
    ax.plot([-1, 1], [0.3, 0.3], [0, 0], "k--", lw=3)
    plain = pixels(ax)
    surface(ax, *np.array(SQUARE) * 0.2 + 0.3, 0.5, "red")
    exact(ax)
    picture = pixels(ax)
    is_red = (picture == rgb("red")).all(axis=2)
    near = np.pad(is_red, 3)
    away = ~np.any([np.roll(near, (i, j), (0, 1)) for i in (-3, 0, 3) for j in (-3, 0, 3)], axis=0)
    away = away[3:-3, 3:-3]
    assert is_red.any() and differ(picture * away[..., None], plain * away[..., None])[1] < 2e-4


def sphere(ax: Any) -> None:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 41), np.linspace(0, np.pi, 21))
    ax.plot_surface(np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v), color="tab:red")


def bars(ax: Any) -> None:
    x, y = np.meshgrid([-0.9, -0.2, 0.5], [-0.9, -0.2, 0.5])
    height = np.linspace(0.1, 0.5, 9)
    ax.bar3d(x.ravel(), y.ravel(), -1.0, 0.2, 0.2, height, color="tab:blue", edgecolor="k")


def bowl(ax: Any) -> None:
    turn, radius = np.meshgrid(np.linspace(0, 2 * np.pi, 24, endpoint=False), [0.3, 0.6, 0.9])
    x, y = (radius * np.cos(turn)).ravel(), (radius * np.sin(turn)).ravel()
    ax.plot_trisurf(x, y, x * x + y * y - 0.5, cmap="viridis", linewidth=0.2)
    ax.view_init(70, -60)


def wave(ax: Any) -> None:
    x, y = np.meshgrid(np.linspace(-1, 1, 31), np.linspace(-1, 1, 31))
    ax.plot_surface(x, y, 0.3 * np.sin(4 * x) * np.cos(3 * y), cmap="coolwarm", linewidth=0)


def wires(ax: Any) -> None:
    x, y = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-1, 1, 21))
    ax.plot_wireframe(x, y, 0.3 * np.sin(4 * x) * np.cos(3 * y))
    ax.plot(np.linspace(-1, 1, 50), np.sin(np.linspace(0, 9, 50)), 0.8, "r-.")


def filled_contours(ax: Any) -> None:
    x, y = np.meshgrid(np.linspace(-1, 1, 31), np.linspace(-1, 1, 31))
    ax.contourf(x, y, np.sin(5 * x) * np.cos(5 * y), zdir="z", offset=-0.5)


def flat_bars(ax: Any) -> None:
    for k in range(3):
        ax.bar([-0.8, -0.3, 0.2, 0.7], [0.3, 0.8, 0.6, 0.4], zs=k / 3, zdir="y", width=0.2)


def patches(ax: Any) -> None:
    hole = Path([[0, 0.4], [0.4, 0], [0, -0.4], [-0.4, 0], [0, 0.4]], closed=True)
    outline = Path([[-0.8, -0.8], [0.8, -0.8], [0.8, 0.8], [-0.8, 0.8], [0, 0]], closed=True)
    ring = Path.make_compound_path(outline, hole)
    for patch, z in ((PathPatch(ring, fc="orange"), 0.0), (Circle((0, 0), 0.2), 0.5)):
        ax.add_patch(patch)
        art3d.pathpatch_2d_to_3d(patch, z=z, zdir="x")


@pytest.mark.parametrize(
    ("fill", "most", "most_far"),
    [
        (sphere, 0.5, 0.002),
        (bars, 0.5, 0.002),
        (bowl, 0.5, 0.002),
        (wave, 0.5, 0.002),
        (wires, 0.5, 0.002),
        (filled_contours, 1.0, 0.005),  # They are drawn without antialiasing.
        (flat_bars, 0.5, 0.002),
        (patches, 0.5, 0.002),
    ],
)
def test_scenes_without_faults_are_drawn_as_before(
    fill: Callable[[Any], None], most: float, most_far: float
) -> None:
    ax = axes()
    ax.set_axis_on()
    fill(ax)
    plain = pixels(ax)
    exact(ax)
    mean, far = differ(pixels(ax), plain)
    assert mean <= most
    assert far <= most_far


def test_what_is_drawn_beside_the_axes_artists_stays() -> None:
    ax = axes()
    drawn = surface(ax, *SQUARE, 0.0, "red", label="plane")
    mapped = ax.plot_surface(*SQUARE, np.full((2, 2), 0.5), cmap="viridis")
    scatter = ax.scatter([0], [0], [0.8], c="blue", label="point")
    line = ax.plot([0, 1], [0, 1], [0, 1], "lime", label="line")[0]
    ax.text(0, 0, 0, "text")
    exact(ax)
    bar = ax.figure.colorbar(mapped)
    limits = ax.get_xlim(), ax.get_ylim(), ax.get_zlim()
    ax.figure.canvas.draw()
    legend = ax.legend(handles=[scatter, line])
    ax.figure.canvas.draw()
    handles = getattr(legend, "legend_handles", None) or legend.legendHandles
    assert tuple(handles[0].get_facecolor()[0][:3]) == colors.to_rgb("blue")
    assert colors.to_rgb(handles[1].get_color()) == colors.to_rgb("lime")
    assert all(h.get_visible() for h in handles)
    assert bar.mappable is mapped
    assert limits == (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())
    assert all(a.get_visible() for a in (drawn, mapped, scatter, line))
    assert drawn in ax.collections and line in ax.lines
    assert ax.get_tightbbox(ax.figure.canvas.get_renderer()) is not None


def test_artists_that_come_and_go_are_followed() -> None:
    ax = axes()
    ax.view_init(90, -90)
    exact(ax)
    pixels(ax)
    surface(ax, *SQUARE, 0.0, "red")
    above = surface(ax, *SQUARE, 0.5, "blue")
    assert at(pixels(ax), ax, (0, 0, 0)) == rgb("blue")
    above.set_visible(False)
    assert at(pixels(ax), ax, (0, 0, 0)) == rgb("red")
    above.set_visible(True)
    above.remove()
    assert at(pixels(ax), ax, (0, 0, 0)) == rgb("red")


def test_it_can_be_called_again_and_taken_back() -> None:
    ax = axes()
    ax.view_init(40, -60)
    surface(ax, *SQUARE, 0.0, "red")
    surface(ax, SQUARE[0], 0.0, SQUARE[1], "blue")
    plain = pixels(ax)
    handle = exact(ax)
    drawn = pixels(ax)
    assert (drawn != plain).any()
    assert exact(ax) is handle
    assert (pixels(ax) == drawn).all()
    handle.remove()
    handle.remove()
    assert (pixels(ax) == plain).all()
    exact(ax)
    assert (pixels(ax) == drawn).all()
    exact(ax, off=True)
    assert (pixels(ax) == plain).all()


def test_a_given_order_is_kept() -> None:
    ax = axes(computed_zorder=False)
    ax.view_init(90, -90)
    surface(ax, *SQUARE, 0.5, "blue", zorder=1)
    surface(ax, *SQUARE, 0.0, "red", zorder=2)
    exact(ax)
    assert at(pixels(ax), ax, (0, 0, 0)) == rgb("red")


@pytest.mark.parametrize("ring", [False, True])
def test_a_closed_ring_hides_as_much_as_its_corners_do(ring: bool) -> None:
    flat = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], float)
    rising = np.array([(0, 0.2, -1), (2, 0.2, 1), (2, 0.8, 1), (0, 0.8, -1)])
    if ring:
        rising = np.concatenate([rising, rising[:1]])
    figure = pyplot.figure(figsize=(3, 3), dpi=100)
    ax = figure.add_axes([0, 0, 1, 1], projection="3d", proj_type="ortho")
    ax.set_axis_off()
    ax.view_init(90, -90)
    for corners, colour in ((flat, "yellow"), (rising, "blue")):
        ax.add_collection3d(art3d.Poly3DCollection([corners], facecolor=colour, linewidth=0))
    ax.set(xlim=(0, 2), ylim=(0, 1), zlim=(-1, 1))
    exact(ax)
    picture = pixels(ax)
    blue, yellow = ((picture == rgb(c)).all(axis=2).sum() for c in ("blue", "yellow"))
    assert blue / (blue + yellow) == pytest.approx(0.3, abs=0.01)


def nearest_faces(ax: Any, faces: Any) -> np.ndarray[Any, Any]:
    """For each pixel's centre the number of the nearest quadrilateral there; -1 for none."""
    width, height = (int(v) for v in ax.figure.bbox.size)
    found, depth = np.full((height, width), -1), np.full((height, width), np.inf)
    columns, rows = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    for number, corners in enumerate(faces):
        x, y, z = proj3d.proj_transform(*np.transpose(corners), ax.get_proj())
        x, y = ax.transData.transform(np.column_stack([x, y])).T
        y = height - y
        for a, b, c in ((0, 1, 2), (0, 2, 3)):
            area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])
            if abs(area) < 1e-9:
                continue
            u = ((columns - x[a]) * (y[c] - y[a]) - (rows - y[a]) * (x[c] - x[a])) / area
            v = ((x[b] - x[a]) * (rows - y[a]) - (y[b] - y[a]) * (columns - x[a])) / area
            at = z[a] + u * (z[b] - z[a]) + v * (z[c] - z[a])
            nearer = (u >= 0) & (v >= 0) & (u + v <= 1) & (at < depth - 1e-12)
            found[nearer], depth[nearer] = number, at[nearer]
    return found


def away_from_edges(numbers: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Whether all pixels within two of one have its number."""
    same = np.ones(numbers.shape, bool)
    for axis in (0, 1):
        for step in (-2, -1, 1, 2):
            same &= np.roll(numbers, step, axis) == numbers
    return same


def test_of_bars_that_touch_the_nearest_are_seen() -> None:
    figure = pyplot.figure(figsize=(4, 4), dpi=100)
    ax = figure.add_axes([0, 0, 1, 1], projection="3d")
    ax.set_axis_off()
    ax.view_init(30, -60)
    x, y = (v.ravel() for v in np.meshgrid(np.arange(8), np.arange(8)))
    colour = np.random.default_rng(3).random((64, 3)) * 0.8 + 0.1
    ax.bar3d(x, y, 0 * x, 1, 1, x + y, color=colour, shade=False, linewidth=0, antialiased=False)
    exact(ax)
    picture = pixels(ax)
    base = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    faces, bar = [], []
    for k in range(64):
        foot = np.column_stack([base + (x[k], y[k]), np.zeros(4)])
        top = foot + (0, 0, x[k] + y[k])
        sides = [[foot[i - 1], foot[i], top[i], top[i - 1]] for i in range(4)]
        faces += [foot, top, *sides]
        bar += 6 * [k]
    nearest = nearest_faces(ax, faces)
    nearest = np.where(nearest < 0, -1, np.array(bar)[nearest])
    expected = np.where(nearest[..., None] < 0, 255, np.round(255 * colour[nearest]))
    judged = away_from_edges(nearest)
    assert judged.sum() > 50_000 and (nearest[judged] >= 0).sum() > 30_000
    assert (np.abs(picture - expected).max(axis=2)[judged] <= 6).all()


@pytest.mark.parametrize("format", ["svg", "pdf", "png"])
def test_all_formats_are_written(format: str) -> None:
    ax = axes()
    ax.set_axis_on()
    for fill in (sphere, bars, wires, wave, filled_contours, patches):
        fill(ax)
    ax.scatter([0], [0], [0])
    exact(ax)
    file = io.BytesIO()
    ax.figure.savefig(file, format=format, bbox_inches="tight")
    assert len(file.getvalue()) > 10_000


def test_what_cannot_be_drawn_is_left_out() -> None:
    ax = axes()
    x, y = np.meshgrid(np.linspace(-1, 1, 5), np.linspace(-1, 1, 5))
    z = 0.0 * x
    z[0, 0] = np.nan
    surface(ax, x, y, z, "red")
    surface(ax, 0.0 * x, 0.0 * y, z + 1.0, "blue")  # All corners in one point.
    ax.plot([0, np.nan, 1, 1], [0, 1, 1, 0], [0.5, 0.5, 0.5, 0.5], "k", lw=4)
    ax.plot([], [], [])
    ax.scatter([0, np.nan], [0, 0], [0, 0])
    ax.add_collection3d(art3d.Line3DCollection([]))
    exact(ax)
    ax.view_init(90, -90)
    picture = pixels(ax)
    assert at(picture, ax, (0.5, 0.25, 0)) == rgb("red")
    assert at(picture, ax, (-0.9, -0.9, 0)) == rgb("white")
    assert at(picture, ax, (1, 0.4, 0.5)) == rgb("black")


GRID = np.meshgrid(np.linspace(-1, 1, 5), np.linspace(-1, 1, 5))
NO_HEIGHTS = np.full((5, 5), np.nan)
POINT = np.zeros((4, 3))


def add_patch(ax: Any, patch: Any) -> None:
    ax.add_patch(patch)
    art3d.patch_2d_to_3d(patch)


@pytest.mark.parametrize(
    "fill",
    [
        lambda ax: None,
        lambda ax: ax.plot_surface(*GRID, NO_HEIGHTS),
        lambda ax: ax.plot_surface(*GRID, NO_HEIGHTS, cmap="viridis"),
        lambda ax: ax.plot_surface(*GRID, NO_HEIGHTS, alpha=0.5),
        lambda ax: ax.plot_surface(*GRID, np.full((5, 5), np.inf)),
        lambda ax: ax.plot_surface(*GRID, np.ma.masked_all((5, 5))),
        lambda ax: ax.plot_wireframe(*GRID, NO_HEIGHTS),
        lambda ax: ax.plot_trisurf(*(v.ravel() for v in GRID), NO_HEIGHTS.ravel()),
        lambda ax: ax.contour(*GRID, 0 * GRID[0]),
        lambda ax: ax.contour(*GRID, NO_HEIGHTS),
        lambda ax: ax.contourf(*GRID, GRID[0], levels=[5, 6, 7]),
        lambda ax: ax.bar([0, 1, 2], [1, 2, 3]),
        lambda ax: ax.bar([0, 1, 2], [1, 2, 3], zs=1, zdir="y"),
        lambda ax: ax.bar([], []),
        lambda ax: ax.bar3d([0, 1], 0, 0, 1, 1, [1, 2]),
        lambda ax: ax.bar3d([0, 1], 0, 0, 1, 1, [np.nan, np.nan]),
        lambda ax: ax.scatter([], [], []),
        lambda ax: ax.scatter([np.nan], [np.nan], [np.nan]),
        lambda ax: ax.plot([], [], [], "o-"),
        lambda ax: ax.plot(3 * [np.nan], 3 * [np.nan], 3 * [np.nan], "o--"),
        lambda ax: ax.plot([0], [0], [0], "--"),
        lambda ax: ax.quiver([], [], [], [], [], []),
        lambda ax: ax.quiver(0, 0, 0, 0, 0, 0),
        lambda ax: ax.text(0, 0, 0, "text"),
        lambda ax: ax.voxels(np.zeros((2, 2, 2), bool)),
        lambda ax: ax.add_collection3d(art3d.Poly3DCollection([])),
        lambda ax: ax.add_collection3d(art3d.Poly3DCollection([NO_HEIGHTS[:3, :3]])),
        lambda ax: ax.add_collection3d(art3d.Poly3DCollection([NO_HEIGHTS[:3, :3]], closed=False)),
        lambda ax: ax.add_collection3d(art3d.Poly3DCollection([POINT])),
        lambda ax: ax.add_collection3d(art3d.Poly3DCollection([POINT[:2]])),
        lambda ax: ax.add_collection3d(art3d.Line3DCollection([])),
        lambda ax: ax.add_collection3d(art3d.Line3DCollection([NO_HEIGHTS[:3, :3]])),
        lambda ax: add_patch(ax, Rectangle((0, 0), 1, 1)),
        lambda ax: add_patch(ax, Rectangle((0, 0), 0, 0)),
        lambda ax: surface(ax, *SQUARE, 0.0, "red").set_visible(False),
    ],
)
def test_axes_with_little_or_nothing_to_draw_are_drawn_as_before(
    fill: Callable[[Any], Any],
) -> None:
    ax = axes()
    ax.set_axis_on()
    fill(ax)
    exact(ax)
    ax.figure.savefig(io.BytesIO(), format="svg", bbox_inches="tight")
    drawn = pixels(ax)
    exact(ax, off=True)
    mean, far = differ(drawn, pixels(ax))
    assert mean <= 0.5 and far <= 0.002


@pytest.mark.parametrize("format", ["png", "svg", "pdf"])
@pytest.mark.parametrize("computed_zorder", [True, False])
def test_bars_alone_are_saved(format: str, computed_zorder: bool) -> None:
    ax = axes(computed_zorder=computed_zorder)
    ax.bar([0, 1, 2], [1, 2, 3])
    ax.plot_surface(*GRID, NO_HEIGHTS, zorder=7)
    exact(ax)
    file = io.BytesIO()
    ax.figure.savefig(file, format=format, bbox_inches="tight")
    assert file.getvalue()


def test_surfaces_in_one_plane_are_saved() -> None:
    ax = axes()
    ax.contourf(*GRID, 0 * GRID[0])
    ax.bar3d([0, 1], 0, 0, 1, 1, [0, 0])
    exact(ax)
    ax.figure.savefig(io.BytesIO(), format="svg", bbox_inches="tight")


def test_lines_and_markers_are_drawn_beside_a_surface_without_heights() -> None:
    ax = axes(proj_type="ortho")
    ax.view_init(90, -90)
    ax.plot_surface(*GRID, NO_HEIGHTS)
    ax.plot([-1, 1], [0.5, 0.5], [0, 0], "blue", lw=4)
    ax.scatter([0], [0], [0], c="red", s=100, alpha=1)
    exact(ax)
    picture = pixels(ax)
    assert at(picture, ax, (0.5, 0.5, 0)) == rgb("blue")
    assert at(picture, ax, (0, 0, 0)) == rgb("red")


def test_copies_and_pickles_do_no_harm() -> None:
    ax = axes()
    surface(ax, *SQUARE, 0.0, "red")
    exact(ax)
    pixels(ax)
    for copied in (pickle.loads(pickle.dumps(ax.figure)), copy.copy(ax.figure)):
        copied.savefig(io.BytesIO())
    pixels(ax)


def test_errors_say_what_is_wrong() -> None:
    for options, words in [
        ({"line_order": "deep"}, "line_order 'deep': expected entry or depth"),
        ({"halo": 2.0}, "halo: 2.0 with line_order 'entry'"),
        ({"line_order": "depth", "halo": -1.0}, "halo: -1.0: expected 0 to 10000 points"),
        ({"line_order": "depth", "halo": float("nan")}, "halo: nan"),
    ]:
        with pytest.raises(displayfile.Error, match=words):
            exact(axes(), **options)
    flat = pyplot.figure().add_subplot()
    with pytest.raises(displayfile.Error, match="exact: expected an Axes3D, not "):
        exact(flat)
    ax = axes()
    with pytest.raises(displayfile.Error, match="method 'map': expected depth-sort or bsp"):
        exact(ax, method="map")
    with pytest.raises(displayfile.Error, match="lift: -1"):
        exact(ax, lift=-1)
    with pytest.raises(
        displayfile.Error, match=r"matplotlib \d.*: Rectangle has no attribute '_no'"
    ):
        private._require(Rectangle((0, 0), 1, 1), "_no")
