"""Colours of data in SVG and PDF, drawn by other programs, against pixels, away from edges."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

from displayfile import System

image = pytest.importorskip("matplotlib.image", reason="matplotlib is not installed")

SIZE = (400, 400)
Array = np.ndarray[Any, Any]


def grid(n: int) -> tuple[Array, Array, Array]:
    x, y = np.meshgrid(np.linspace(-2, 2, n), np.linspace(-2, 2, n))
    return x, y, np.sin(2 * x) * np.cos(y)


def mesh_of(n: int) -> tuple[Array, Array]:
    """The points of a wave, and its triangles."""
    k = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.c_[k, k + 1, k + n + 1], np.c_[k, k + n + 1, k + n]])
    return np.stack(grid(n), axis=-1).reshape(-1, 3), faces


def values_of_faces(system: System) -> None:
    points, faces = mesh_of(15)
    system.mesh(points, faces, values=points[faces, 2].mean(axis=1), cmap="viridis", at="faces")


def values_of_vertices(system: System) -> None:
    points, faces = mesh_of(9)
    system.mesh(points, faces, values=points[:, 2], cmap="plasma", at="vertices")


def surface_of_values(system: System) -> None:
    x, y, z = grid(12)
    system.surface(x, y, z, values=x * y, cmap="coolwarm")


def surface_in_bands(system: System) -> None:
    x, y, z = grid(16)
    system.surface(x, y, z, levels=9, cmap="inferno")


def free_colours_of_faces(system: System) -> None:
    points, faces = mesh_of(15)
    system.mesh(points, faces, fills=np.random.default_rng(4).random((len(faces), 3)))


def free_colours_by_subdivision(system: System) -> None:
    """A colour for each corner: triangles are halved until one colour each is near enough."""
    points, faces = mesh_of(4)
    colours = np.random.default_rng(5).random((len(points), 3))
    corners = np.concatenate([points, colours], axis=1)[faces]
    for _ in range(4):
        middles = (corners + np.roll(corners, -1, axis=1)) / 2
        outer = [[corners[:, k], middles[:, k], middles[:, k - 1]] for k in range(3)]
        corners = np.concatenate([*(np.stack(three, axis=1) for three in outer), middles])
    numbers = np.arange(3 * len(corners)).reshape(-1, 3)
    fills, face = corners[..., 3:].mean(axis=1), np.arange(len(corners)) % len(faces)
    system.mesh(corners[..., :3].reshape(-1, 3), numbers, fills=fills, picks=face)


def colours_of_vertices(system: System) -> None:
    points, faces = mesh_of(9)
    colours = np.stack([points[:, 0], points[:, 1], 2 * points[:, 2]], axis=1) * 0.06 + 0.5
    system.mesh(points, faces, fills=colours, at="vertices")


def drawn_by_others(system: System, format: str, folder: Path) -> Array:
    file = folder / f"figure.{format}"
    system.save(file, SIZE)
    picture = folder / "figure.png"
    if format == "svg":
        command = ["rsvg-convert", "-o", str(picture), str(file)]
    else:
        command = ["pdftocairo", "-png", "-r", "72", "-singlefile", str(file), str(folder / "figure")]
    subprocess.run(command, check=True)
    return np.rint(255 * image.imread(picture)[..., :3]).astype(int)


def around(values: Array) -> Array:
    """The values at a pixel and its eight neighbours."""
    steps = (-1, 0, 1)
    return np.stack([np.roll(values, (dy, dx), (0, 1)) for dy in steps for dx in steps])


@pytest.mark.parametrize("format", ["svg", "pdf"])
@pytest.mark.parametrize(
    ("enter", "most", "least"),
    [
        (values_of_faces, 1, 5000),
        (values_of_vertices, 1, 200),
        (surface_of_values, 1, 200),
        (surface_in_bands, 1, 5000),
        (free_colours_of_faces, 1, 5000),
        (free_colours_by_subdivision, 2, 1000),
        (colours_of_vertices, 1, 1000),
    ],
)
def test_colours_in_vectors_are_those_in_pixels(
    enter: Callable[[System], None], most: int, least: int, format: str, tmp_path: Path
) -> None:
    system = System()
    system.set_line_style("none")
    enter(system)
    system.look(eye=(25, 50))
    picture = system.draw(SIZE, ids=True, samples=4)
    pixels = np.asarray(picture.pixels)[..., :3].astype(int)
    vectors = drawn_by_others(system, format, tmp_path)
    within_face = (around(picture.ids) == picture.ids).all(axis=0) & (picture.ids >= 0)
    low, high = around(pixels).min(axis=0), around(pixels).max(axis=0)
    is_even = within_face & (low == high).all(axis=2)
    off = np.abs(vectors - pixels).max(axis=2)
    assert is_even.sum() > least
    assert off[is_even].max() <= most
    # Every step of a map is an edge too: there a pixel has a colour between those around it.
    is_ramp = within_face & (high - low <= 8).all(axis=2)
    beyond = np.maximum(low - vectors, vectors - high).max(axis=2)
    assert is_ramp.sum() > 10_000
    assert beyond[is_ramp].max() <= most
