"""Texts of axes, colour bars and legends are within the picture."""

from __future__ import annotations

import re
import warnings
from typing import Any, Callable, Iterator, NamedTuple

import numpy as np
import pytest
from displayfile import Error, System

X, Y = np.meshgrid(np.linspace(-3, 3, 12), np.linspace(-3, 3, 12))
Z = np.sin(X) * np.cos(Y)
ADVANCE = 0.6
"""Of a letter in a usual font without serifs, relative to its size; about."""


class Text(NamedTuple):
    """Letters in a picture, in pixels, y down."""

    characters: str
    left: float
    right: float
    top: float
    bottom: float


def texts_of(svg: str) -> Iterator[Text]:
    sizes = {
        name: (float(size), anchor)
        for name, size, anchor in re.findall(
            r"\.(t\d+-\w+)\{[^}]*font-size:([\d.]+)px;text-anchor:(\w+)\}", svg
        )
    }
    for kind, x, y, characters in re.findall(
        r'<text class="([\w-]+)" x="([-\d.]+)" y="([-\d.]+)">([^<]*)</text>', svg
    ):
        size, anchor = sizes[kind]
        width = ADVANCE * size * len(characters)
        left = float(x) - {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * width
        yield Text(characters, left, left + width, float(y) - 0.7 * size, float(y))


def assert_within(svg: str, size: tuple[int, int], least: int) -> None:
    texts = list(texts_of(svg))
    assert len(texts) >= least
    for text in texts:
        assert text.left >= 0.0 and text.right <= size[0], text
        assert text.top >= 0.0 and text.bottom <= size[1], text


def with_axes(*, look_first: bool = False, **camera: Any) -> System:
    system = System()
    if look_first:
        system.look(**camera)
    system.surface(X, Y, Z)
    system.open_segment(50)
    system.axes_3(-3, 3, -3, 3, -1, 1, "easting, m", "northing", "height, m")
    system.close_segment()
    if not look_first:
        system.look(**camera)
    return system


SIZES = ((600, 400), (400, 400), (300, 500))
CAMERAS: tuple[dict[str, Any], ...] = (
    {},
    {"eye": (30, 35)},
    {"eye": (-60, 30)},
    {"eye": (140, 10), "parallel": True},
    {"eye": (30, 35), "look_at": (0, 0, 0)},
    {"eye": (30, 35), "fov": 40},
    {"eye": (20, 30, 15)},
)


@pytest.mark.parametrize("camera", CAMERAS)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("look_first", [False, True])
def test_a_fitted_view_has_room_for_texts(
    camera: dict[str, Any], size: tuple[int, int], look_first: bool
) -> None:
    system = with_axes(look_first=look_first, **camera)
    assert_within(system.svg(size), size, 4)


def test_a_view_of_views_has_room_for_texts(tmp_path: Any) -> None:
    views = with_axes(eye=(30, 35)).views((500, 400))
    for azimuth in (-150, -60, 30, 120):
        views.save(tmp_path / "view.svg", (azimuth, 25))
        assert_within((tmp_path / "view.svg").read_text(), (500, 400), 4)


def test_without_texts_the_fit_is_as_before_and_short_texts_take_little() -> None:
    def width_of(system: System) -> int:
        seen = (system.draw((400, 400))[..., :3] != 255).any(axis=2).any(axis=0)
        return int(seen.sum())

    bare, named = System(), System()
    for system in (bare, named):
        system.look(eye=(0, 0), parallel=True)
        system.mesh([(0, 0, 0), (4, 0, 0), (4, 0, 2), (0, 0, 2)], [(0, 1, 2, 3)], fill="red")
    named.open_segment(9)
    named.move_abs_3(2, 0, 1)
    named.text("inside")
    named.close_segment()
    assert width_of(bare) == width_of(named) == pytest.approx(360, abs=2)


def test_texts_that_no_picture_holds_leave_the_scene_its_size() -> None:
    for camera in ({}, {"look_at": (2, 0, 2)}):
        system = System()
        system.look(eye=(0, 0), parallel=True, **camera)
        system.mesh([(0, 0, 0), (4, 0, 0), (4, 0, 4), (0, 0, 4)], [(0, 1, 2, 3)], fill="red")
        before = system.draw((400, 400))
        system.open_segment(9)
        system.move_abs_3(4, 0, 1)
        system.text("x" * 300)
        system.close_segment()
        after = system.draw((400, 400))
        assert (before[200:, :100] == after[200:, :100]).all()


# ---- Columns beside the scene ------------------------------------------------------------


def with_bar(label: str = "", size: tuple[int, int] = (600, 400), **options: Any) -> str:
    system = System()
    system.surface(X, Y, Z, **options.pop("surface", {"cmap": None, "limits": (-1, 1)}))
    system.colour_bar(label, **options)
    return system.svg(size)


LONG = "a long label of the height in metres above the level of the sea"


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("label", ["height", LONG])
def test_a_bar_has_room_for_its_texts(size: tuple[int, int], label: str) -> None:
    svg = with_bar(label, size)
    assert_within(svg, size, 4)
    rows = [text.characters for text in texts_of(svg) if text.characters[0].isalpha()]
    assert " ".join(reversed(rows)) == label


def test_a_legend_has_room_for_its_names() -> None:
    system = System()
    system.surface(X, Y, Z)
    system.legend({"observed in north": "red", "computed": "blue"})
    for size in SIZES:
        assert_within(system.svg(size), size, 2)


def test_letters_have_the_size_that_is_set() -> None:
    svg = with_bar("height", letters=9 / 288, size=(400, 288))
    assert set(re.findall(r"font-size:([\d.]+)px", svg)) == {"9"}
    system = System()
    system.surface(X, Y, Z)
    system.legend({"a": "red"}, letters=0.05)
    assert "font-size:20px" in system.svg((400, 400))
    large = System()
    large.surface(X, Y, Z)
    large.legend({"a": "red", "b": "blue", "c": "lime"}, letters=0.08)
    lines = [text.bottom for text in texts_of(large.svg((400, 400)))]
    assert np.diff(lines) == pytest.approx([1.4 * 32, 1.4 * 32], abs=0.01)
    for wrong in (0, -1, 2, float("nan"), "9pt", [0.03]):
        with pytest.raises(Error, match="letters"):
            with_bar("height", letters=wrong)
        with pytest.raises(Error, match="letters"):
            system.legend({"a": "red"}, letters=wrong)  # type: ignore[arg-type]


def test_a_word_that_is_too_long_is_warned_of() -> None:
    with pytest.warns(UserWarning, match="colour_bar: 'Donau.*' is wider than its column"):
        with_bar("Donaudampfschifffahrtsgesellschaft")
    with pytest.raises(Error, match="label has .* rows"):
        with_bar("word " * 100)


def numbers_of(svg: str) -> list[str]:
    return [t.characters.replace("\u2212", "-") for t in texts_of(svg)]


def test_ticks_of_levels_are_at_their_bounds() -> None:
    given = [-1, -0.5, 0.125, 0.25, 1]
    svg = with_bar(surface={"levels": given})
    # The number of 0.25 would touch that of 0.125.
    assert numbers_of(svg) == ["-1", "-0.5", "0.125", "1"]
    levels = numbers_of(with_bar(surface={"levels": 4, "limits": (0.0, 1.0)}))
    assert levels == ["0", "0.25", "0.5", "0.75", "1"]
    third = numbers_of(with_bar(surface={"levels": 3, "limits": (0.0, 1.0)}))
    assert third == ["0", "0.333", "0.667", "1"]
    many = numbers_of(with_bar(surface={"levels": 100, "limits": (0.0, 100.0)}))
    assert many == [str(k) for k in range(0, 100, 9)]
    small = numbers_of(with_bar(surface={"levels": [0, 1e-9, 2e-9], "values": 1e-9 * Z}))
    assert small == ["0", "1e-09", "2e-09"]
    assert numbers_of(with_bar(surface={"levels": given}, ticks=[0.5])) == ["0.5"]


def test_ticks_of_levels_stand_where_the_colours_change() -> None:
    system = System()
    system.surface(X, Y, Z, levels=[-1, 0, 0.5, 1])
    system.colour_bar()
    drawing = system.pieces()
    column = [
        drawing.points[a:b]
        for a, b, kind in zip(drawing.first, drawing.first[1:], drawing.kinds)
        if kind == 2
    ]
    ticks = sorted(
        line[0, 1] for line in column if len(line) == 2 and line[0, 1] == line[1, 1]
    )
    boxes = [
        drawing.points[a:b]
        for a, b, kind in zip(drawing.first, drawing.first[1:], drawing.kinds)
        if kind != 2 and all(len(set(drawing.points[a:b, k].tolist())) == 2 for k in (0, 1))
    ]
    assert len(boxes) == 3
    bounds = {float(y) for box in boxes for y in box[:, 1]}
    assert bounds and bounds <= set(map(float, ticks))


def warned_of(draw: Callable[[], object]) -> list[str]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        draw()
    return [str(warning.message) for warning in caught]


# ---- Segments that are open --------------------------------------------------------------


def test_an_open_segment_that_a_camera_does_not_show_is_named() -> None:
    system = System()
    system.look()
    system.open_segment(7)
    system.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    expected = "segment 7 is open, and not in the picture.*expected close_segment"
    for draw in (lambda: system.draw(50), lambda: system.svg(50), lambda: system.png(50)):
        (message,) = warned_of(draw)
        assert re.search(expected, message)
    system.close_segment()
    assert warned_of(lambda: system.draw(50)) == []
    system.open_segment(8)  # nothing is in it yet
    assert warned_of(lambda: system.draw(50)) == []
    system.move_abs_3(0, 0, 0)
    system.text("name")
    (message,) = warned_of(lambda: system.svg(50))
    assert "segment 8 is open" in message


def test_an_open_segment_is_shown_without_a_camera() -> None:
    system = System()
    system.open_segment(7)
    system.set_fill_style("solid", "red")
    system.polygon_abs_3([(-1, -1, 0), (1, -1, 0), (0, 1, 0)])
    assert warned_of(lambda: system.draw(50)) == []
    assert (system.draw(50)[25, 25, :3] == (255, 0, 0)).all()
