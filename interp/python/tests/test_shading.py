"""Smooth shading of arrays without normals; lines through points, and contours in a style."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from displayfile import Error, PicklableSystem, System

X, Y = np.meshgrid(np.linspace(-2, 2, 9), np.linspace(-2, 2, 9))
DOME = 4.0 - 0.5 * (X**2 + Y**2)
NORMALS = np.stack([X, Y, np.ones_like(X)], axis=-1)
"""Of the paraboloid that the points are on."""
LIGHT = (1.0, 0.5, 0.7)


def lit(shading: str | None, crease: float | None = None) -> System:
    system = System()
    if shading is not None:
        system.set_shading(shading)
    if crease is not None:
        system.set_crease_angle(crease)
    system.set_light(*LIGHT, 0.1)
    system.set_line_style("none")
    system.set_fill_style("solid", "white")
    system.set_background(0, 0, 1)
    system.look(eye=(0, 90), parallel=True)
    return system


def picture(system: System) -> Any:
    return system.draw(120, samples=1)[..., :3].astype(int)


def steps(pixels: Any) -> int:
    """The largest difference of neighbours in a row within the middle of the picture."""
    middle = pixels[30:90, 30:90, 0]
    return int(np.abs(np.diff(middle, axis=1)).max())


def faces() -> tuple[Any, Any]:
    points = np.stack([X, Y, DOME], axis=-1).reshape(-1, 3)
    k = np.arange(81).reshape(9, 9)
    quads = np.stack([k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]], axis=-1).reshape(-1, 4)
    return points, quads


def enter_even(system: System, **options: Any) -> None:
    system.surface(X, Y, DOME, **options)


def enter_uneven(system: System, **options: Any) -> None:
    system.surface(X + 0.01 * (X > 0.4), Y, DOME, **options)


def enter_mesh(system: System, **options: Any) -> None:
    points, quads = faces()
    if options.get("values") is not None:
        options["values"] = options["values"].ravel()
    system.mesh(points, quads, **options)


ENTER = [enter_even, enter_uneven, enter_mesh]
IN_COLOURS = {"values": X, "cmap": [(1, 1, 1), (1, 1, 1)], "limits": (-9, 9)}


@pytest.mark.parametrize("enter", ENTER)
@pytest.mark.parametrize("shading", ["gouraud", "phong"])
@pytest.mark.parametrize("options", [{}, IN_COLOURS])
def test_shading_is_smooth_without_normals(enter: Any, shading: str, options: Any) -> None:
    flat, smooth = lit(None), lit(shading)
    enter(flat, **options)
    enter(smooth, **options)
    before, after = picture(flat), picture(smooth)
    assert steps(before) > 12 and steps(after) < 9
    # They are those of the surface on which the points are, nearly.
    intensity = 0.1 + 0.9 * (NORMALS @ LIGHT) / np.linalg.norm(NORMALS, axis=-1) / np.linalg.norm(
        LIGHT
    )
    centre = after[55:65, 55:65, 0].mean()
    assert centre == pytest.approx(255 * intensity[4, 4], abs=6)


@pytest.mark.parametrize("enter", ENTER)
def test_flat_shading_is_as_it_was(enter: Any) -> None:
    plain, flat = lit(None), lit("flat")
    enter(plain)
    enter(flat)
    assert plain.dump() == flat.dump()


@pytest.mark.parametrize("enter", ENTER)
def test_a_crease_angle_keeps_edges(enter: Any) -> None:
    by_facets, whole = lit("gouraud", 0.0), lit(None)
    enter(by_facets)
    enter(whole)
    assert (picture(by_facets) == picture(whole)).all()
    wide = lit("gouraud", 60.0)
    enter(wide)
    smooth = lit("gouraud")
    enter(smooth)
    assert (picture(wide) == picture(smooth)).all()


def test_a_ridge_is_sharp_with_a_crease_angle_and_the_roof_smooth() -> None:
    roof = 2.0 - np.abs(X)
    sharp, round_ = lit("gouraud", 30.0), lit("gouraud")
    for system in (sharp, round_):
        system.surface(X, Y, roof)
    assert steps(picture(sharp)) > 100
    assert steps(picture(round_)) < 20


def test_holes_leave_the_normals_beside_them() -> None:
    holed = DOME.copy()
    holed[4, 4] = np.nan
    for shading in ("gouraud", "phong"):
        whole, with_hole = lit(shading), lit(shading)
        whole.surface(X, Y, DOME)
        with_hole.surface(X, Y, holed)
        a, b = picture(whole), picture(with_hole)
        corner = np.s_[8:20, 8:20]
        assert (a[corner] == b[corner]).all()
        assert (b == (0, 0, 255)).all(axis=2)[58:62, 58:62].all()


def test_a_mirrored_surface_is_lit_from_the_other_side() -> None:
    system, mirrored = lit("gouraud"), lit("gouraud")
    system.surface(X, Y, DOME)
    mirrored.set_light(-LIGHT[0], LIGHT[1], LIGHT[2], 0.1)
    mirrored.scale_3(-1, 1, 1)
    mirrored.surface(X, Y, DOME)
    a, b = picture(system), picture(mirrored)[:, ::-1]
    assert np.abs(a[20:100, 20:100] - b[20:100, 20:100]).max() <= 8


def test_normals_go_with_values() -> None:
    points, quads = faces()
    for given in (IN_COLOURS, {**IN_COLOURS, "values": np.arange(64.0), "at": "faces"}):
        values = given["values"].ravel()
        by_own, by_given = lit("gouraud"), lit("gouraud")
        by_own.mesh(points, quads, **{**given, "values": values})
        by_given.mesh(
            points, quads, normals=NORMALS.reshape(-1, 3), **{**given, "values": values}
        )
        assert steps(picture(by_given)) < 9
        assert np.abs(picture(by_own) - picture(by_given))[20:100, 20:100].max() < 12
    tilted = lit("gouraud")
    level = points * (1, 1, 0.1)  # no face is turned away from the light
    in_colours = {**IN_COLOURS, "values": X.ravel()}
    tilted.mesh(level, quads, normals=np.tile(LIGHT, (81, 1)), **in_colours)
    assert (picture(tilted)[30:90, 30:90, 0] >= 254).all()
    for wrong in (NORMALS[:1].reshape(-1, 3), "up", np.full((81, 3), np.nan)):
        with pytest.raises(Error, match="normals"):
            System().mesh(points, quads, values=X.ravel(), normals=wrong)


def test_normals_make_no_polygon_without_area() -> None:
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 1, 0)]
    counts = []
    for normals in (None, [(0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 0)]):
        system = lit("gouraud")
        system.mesh(
            points, [(0, 1, 2), (0, 2, 3)], values=[0.0, 1.0, 0.3, 0.3], levels=2, normals=normals
        )
        counts.append(system.pieces().picks.max())
    assert counts == [0, 0]


def test_what_is_smooth_is_recorded_noted_and_pickled() -> None:
    system = PicklableSystem()
    system.record()
    system.set_shading("gouraud")
    system.set_light(*LIGHT, 0.1)
    system.surface(X, Y, DOME)
    system.mesh(*faces())
    system.polyline([(0, 0, 5), (1, 0, 5), (1, 1, 5)], colour="red")
    again = System()
    again.replay(system.recording)
    assert again.dump() == system.dump() == system.calls.system().dump()


# ---- Lines -------------------------------------------------------------------------------


def lines_of(system: System) -> list[list[list[float]]]:
    return [
        system.pieces().points[a:b].round(6).tolist()
        for a, b, kind in zip(
            system.pieces().first, system.pieces().first[1:], system.pieces().kinds
        )
        if kind == 2
    ]


def test_a_polyline_is_as_moves_and_lines() -> None:
    t = np.linspace(0, 20, 50)
    helix = np.stack([np.cos(t), np.sin(t), 0.1 * t], axis=-1)
    system, by_hand = System(), System()
    name = system.polyline(helix)
    by_hand.look()
    by_hand.open_segment(name)
    by_hand.move_abs_3(*helix[0])
    for point in helix[1:]:
        by_hand.line_abs_3(*point)
    by_hand.close_segment()
    assert (system.draw(100) == by_hand.draw(100)).all()
    closed = System()
    closed.polyline(helix, closed=True)
    assert len(lines_of(closed)) == len(lines_of(system)) + 1


def test_a_polyline_has_its_colour_and_width_and_the_style_stays() -> None:
    system = System()
    system.set_line_style("solid", "blue", 2)
    system.polyline([(0, 0, 0), (1, 0, 0)], colour="red", width=5)
    system.polyline([(0, 0, 1), (1, 0, 1)])
    drawing = system.pieces()
    assert drawing.line_colours.tolist() == [[1, 0, 0], [0, 0, 1]]
    assert drawing.line_widths.tolist() == [5, 2]
    quiet = System()
    quiet.set_line_style("none")  # of the sides of polygons
    quiet.polyline([(0, 0, 0), (1, 0, 0)])
    assert quiet.pieces().line_colours.tolist() == [[0, 0, 0]]


def test_a_gap_parts_a_polyline() -> None:
    gap = [np.nan, 0, 0]
    system = System()
    system.polyline([(0, 0, 0), (1, 0, 0), gap, (9, 9, 9), gap, (2, 0, 0), (3, 0, 1), (3, 1, 1)])
    assert len(lines_of(system)) == 3
    open_, closed = System(), System()
    open_.polyline([(0, 0, 0), (1, 0, 0), gap, (1, 1, 0), (0, 1, 0)])
    closed.polyline([(0, 0, 0), (1, 0, 0), gap, (1, 1, 0), (0, 1, 0)], closed=True)
    assert (len(lines_of(open_)), len(lines_of(closed))) == (2, 3)


@pytest.mark.parametrize(
    "points",
    [[], [(0, 0, 0)], [(0, 0), (1, 1)], "line", [(0, 0, np.inf), (1, 1, 1)], [[np.nan] * 3] * 4],
)
def test_what_is_no_polyline_is_refused(points: Any) -> None:
    system = System()
    with pytest.raises(Error):
        system.polyline(points)
    assert system.segments == []


def test_contours_have_a_style_without_a_grid() -> None:
    system = System()
    system.surface(X, Y, DOME, contours=[2.0, 3.0], contour_colour="red", contour_width=2)
    drawing = system.pieces()
    lines = drawing.kinds == 2
    assert lines.any() and (drawing.line_colours[lines] == (1, 0, 0)).all()
    assert (drawing.line_widths[lines] == 2).all()
    assert (drawing.line_kinds[~lines] == 2).all()  # no grid
    filled = System()
    filled.surface(X, Y, DOME, levels=4, contours=3, contour_colour="red", contour_width=3)
    drawing = filled.pieces()
    lines = drawing.kinds == 2
    assert lines.any() and (drawing.line_colours[lines] == (1, 0, 0)).all()
    assert (drawing.line_widths[lines] == 3).all()
    quiet, plain = System(), System()
    quiet.set_line_style("none")
    for each in (quiet, plain):
        each.surface(X, Y, DOME, contours=[2.0, 3.0])
    assert quiet.dump() == plain.dump()
    with pytest.raises(Error, match="contour_colour: expected it with contours"):
        System().surface(X, Y, DOME, contour_colour="red")
    with pytest.raises(Error, match="contour_width: expected it with contours"):
        System().surface(X, Y, DOME, contour_width=2)
    with pytest.raises(Error, match="contour_colour"):
        System().surface(X, Y, DOME, contours=3, contour_colour="reddish")
