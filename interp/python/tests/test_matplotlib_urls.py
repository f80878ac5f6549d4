"""Links of matplotlib's artists in SVG, and what exact takes."""

from __future__ import annotations

import io
from typing import Any

import matplotlib

matplotlib.use("agg")

import displayfile
import numpy as np
import pytest
from displayfile.matplotlib import exact
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

TRIANGLES = [[(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 0, 1), (1, 0, 1), (0, 1, 1)]]


@pytest.fixture
def ax() -> Any:
    figure = pyplot.figure()
    yield figure.add_subplot(projection="3d")
    pyplot.close(figure)


def links(ax: Any) -> list[str]:
    file = io.StringIO()
    ax.figure.savefig(file, format="svg")
    parts = file.getvalue().split('<a xlink:href="')[1:]
    return [part.split('"')[0] for part in parts]


def test_links_are_kept(ax: Any) -> None:
    (line,) = ax.plot([0, 1], [0, 1], [0, 3])
    line.set_url("https://line.example/")
    faces = Poly3DCollection(TRIANGLES, urls=["https://faces.example/"])
    ax.add_collection3d(faces)
    assert "https://line.example/" in links(ax)
    exact(ax)
    assert set(links(ax)) == {"https://line.example/", "https://faces.example/"}


def test_the_link_of_a_single_path(ax: Any) -> None:
    (line,) = ax.plot([0, 1], [0, 1], [0, 3])
    line.set_url("https://line.example/")
    exact(ax)
    assert links(ax) == ["https://line.example/"]


def test_a_link_of_a_whole_collection(ax: Any) -> None:
    faces = Poly3DCollection(TRIANGLES)
    faces.set_url("https://faces.example/")
    ax.add_collection3d(faces)
    exact(ax)
    assert set(links(ax)) == {"https://faces.example/"}


def test_links_of_single_faces_are_warned_of(ax: Any) -> None:
    ax.add_collection3d(Poly3DCollection(TRIANGLES, urls=["https://a.example/", "https://b.example/"]))
    exact(ax)
    with pytest.warns(UserWarning, match="2 urls of one Poly3DCollection are left out"):
        assert links(ax) == []


def test_no_link_is_made_up(ax: Any) -> None:
    ax.plot([0, 1], [0, 1], [0, 3])
    ax.add_collection3d(Poly3DCollection(TRIANGLES))
    exact(ax)
    assert links(ax) == []


def test_what_is_not_one_axes_is_refused_with_advice() -> None:
    figure, axes = pyplot.subplots(1, 2, subplot_kw={"projection": "3d"})
    for given, advice in (
        (figure, "not Figure: call exact for each of its axes"),
        (axes, "not ndarray: call exact for each of the axes in it"),
        (list(axes), "not list: call exact for each of the axes in it"),
        (pyplot.figure().add_subplot(), "projection='3d'"),
        (None, "not NoneType$"),
    ):
        with pytest.raises(displayfile.Error, match=advice):
            exact(given)
    for one in axes.flat:
        exact(one)
    pyplot.close("all")
    assert np.size(axes) == 2
