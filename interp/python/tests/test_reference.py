"""The reference page is what the docstrings say, and all of them say something."""

from __future__ import annotations

import inspect

import pytest

pytest.importorskip("matplotlib", reason="matplotlib is not installed")
pytest.importorskip("distributed", reason="distributed is not installed")

import displayfile  # noqa: E402
import write_reference  # noqa: E402
from displayfile import System  # noqa: E402


def test_the_page_is_written_from_the_docstrings() -> None:
    expected = write_reference.page()
    assert write_reference.PAGE.read_text() == expected, "run write_reference.py"


def test_the_page_has_all_that_is_public() -> None:
    page = write_reference.page()
    for name in displayfile.__all__:
        assert name.startswith("__") or f"### {name}\n" in page or f"## {name}\n" in page
    for name in dir(System):
        assert name.startswith("_") or f"### {name}\n" in page or f"| `{name}` |" in page


def test_help_shows_arguments_and_meanings() -> None:
    assert str(inspect.signature(System.rotate_x_3)) == "(angle)"
    assert str(inspect.signature(System.sphere_3)) == "(x, y, z, radius, facets)"
    assert str(inspect.signature(System.cone_3)).endswith("facets, top_radius=None)")
    assert str(inspect.signature(System.polygon_abs_3)) == "(*arguments)"
    for name in displayfile.user_routines():
        docstring = inspect.getdoc(getattr(System, name))
        assert docstring is not None
        assert "Arguments: " in docstring or "No arguments." in docstring
        assert "-3" not in docstring.split("Arguments:")[0]  # names are Python's
