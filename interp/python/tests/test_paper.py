"""Sizes of files on paper and in millimetres."""

from __future__ import annotations

import io
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from displayfile import Error, System

X, Y = np.meshgrid(np.linspace(-3, 3, 12), np.linspace(-3, 3, 12))


def surface(**options: Any) -> System:
    system = System(**options)
    system.surface(X, Y, np.sin(X) * np.cos(Y))
    return system


def sheet(svg: str) -> tuple[str, str]:
    found = re.search(r'<svg [^>]*width="([\d.]+\w*)" height="([\d.]+\w*)"', svg)
    assert found is not None
    return found[1], found[2]


def picture_on(svg: str) -> tuple[float, float]:
    """Width and height of the picture on the sheet, in mm."""
    scale = re.search(r"scale\(([\d.]+)\)", svg)
    inner = re.findall(r'<svg [^>]*width="([\d.]+)" height="([\d.]+)"', svg)
    assert scale is not None and inner
    return float(inner[-1][0]) * float(scale[1]), float(inner[-1][1]) * float(scale[1])


@pytest.mark.parametrize(
    "paper, width, height",
    [("A4", 210, 297), ("A4-landscape", 297, 210), ("120x60", 120, 60)],
)
def test_a_picture_on_paper_has_its_shape(paper: str, width: int, height: int) -> None:
    svg = surface().svg(paper=paper)
    assert sheet(svg) == (f"{width}mm", f"{height}mm")
    assert picture_on(svg) == pytest.approx((width - 20, height - 20), rel=0.01)


def test_a_size_or_a_view_that_is_set_stays_on_paper() -> None:
    for svg in (
        surface().svg(300, paper="A4"),
        surface(aspect=1.0).svg(paper="A4"),
    ):
        across, down = picture_on(svg)
        assert across == pytest.approx(down)
    set_view = System()
    set_view.set_perspective(3, 2, 6)
    set_view.open_segment(1)
    set_view.box_3(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5)
    set_view.close_segment()
    across, down = picture_on(set_view.svg(paper="A4"))  # and no warning that it is stretched
    assert across == pytest.approx(down)


def test_a_size_in_millimetres(tmp_path: Path) -> None:
    system = surface()
    assert sheet(system.svg("80x60mm")) == ("80mm", "60mm")
    on_paper = system.svg("80x60mm", paper="A4")
    assert sheet(on_paper) == ("297mm", "210mm")  # the sheet is turned as the picture is
    assert picture_on(on_paper) == pytest.approx((80, 60), rel=0.001)
    system.save(tmp_path / "a.png", size="80x60mm", dpi=300)
    header = (tmp_path / "a.png").read_bytes()[16:24]
    assert struct.unpack(">II", header) == (945, 709)
    file = io.BytesIO()
    system.save(file, "80x60mm", format="pdf")
    assert re.search(rb"MediaBox \[ ?0 0 226\.7\d* 170\.0\d*", file.getvalue())


def test_the_same_as_the_command(command: Any, tmp_path: Path) -> None:
    (tmp_path / "box.draw").write_text("open-segment 1\nbox-3 0 1 0 1 0 1\nclose-segment\n")
    words = ("draw", "box.draw", "-o", "box.svg", "--size", "80x60mm", "--paper", "a5")
    assert command(*words).returncode == 0
    system = System(aspect=80 / 60)
    system.replay((tmp_path / "box.draw").read_text())
    assert sheet(system.svg("80x60mm", paper="a5")) == sheet((tmp_path / "box.svg").read_text())


def test_sizes_that_are_refused() -> None:
    system = surface()
    for size in ("80x60", "large", "80mm", "0x60mm", "nanx60mm", "80x60cm", ""):
        with pytest.raises(Error, match="size"):
            system.svg(size)
    with pytest.raises(Error, match="dpi"):
        system.png("80x60mm")
    with pytest.raises(Error, match="dpi"):
        system.png("80x60mm", dpi=0)
    with pytest.raises(Error, match="dpi"):
        system.png(paper="A4")
