"""The examples write the pictures that are in the repository, and print what their page says.

Pictures are the same byte for byte; those that matplotlib writes, to antialiasing.
"""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Callable

import numpy as np
import pytest
from conftest import ROOT

FOLDER = ROOT / "interp" / "python" / "examples"
PAGE = (FOLDER / "README.md").read_text()
PROGRAMS = sorted(FOLDER.glob("*.py"))
PICTURES = {path.name for path in FOLDER.iterdir() if path.suffix in (".png", ".svg", ".pdf")}

# Dask tells of a worker that is slow to end, as it is on a busy machine.
QUIET = {"DASK_LOGGING__DISTRIBUTED": "critical"}

Run = Callable[[Path], Path]


def require_modules(program: Path) -> None:
    """Skips the test where a library that the program imports is not installed."""
    for module in re.findall(r"^(?:import|from) (\w+)", program.read_text(), re.MULTILINE):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Runs an example, once, and returns the folder with what it has written."""
    folders: dict[Path, Path] = {}

    def run_once(program: Path) -> Path:
        require_modules(program)
        if program not in folders:
            folder = tmp_path_factory.mktemp(program.stem)
            done = subprocess.run(
                [sys.executable, program, folder],
                cwd=folder,
                env={**os.environ, **QUIET},
                capture_output=True,
                text=True,
            )
            assert done.returncode == 0, done.stderr
            assert done.stderr == ""
            for line in done.stdout.splitlines():
                assert f"\n    {line}\n" in PAGE
            folders[program] = folder
        return folders[program]

    return run_once


def is_by_matplotlib(picture: Path) -> bool:
    return picture.suffix == ".png" and b"Matplotlib version" in picture.read_bytes()


def require_nearly_the_same(picture: Path, expected: Path) -> None:
    """Other versions of fonts and of the rasteriser move pixels at edges, a little."""
    image = pytest.importorskip("matplotlib.image")
    a, b = image.imread(picture), image.imread(expected)
    assert a.shape == b.shape
    off = np.abs(a - b).max(axis=2)
    assert off.mean() < 0.004
    assert (off > 0.25).mean() < 0.002


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_pictures_are_those_of_the_repository(program: Path, run: Run) -> None:
    written = sorted(run(program).iterdir())
    assert written
    for picture in written:
        expected = FOLDER / picture.name
        if is_by_matplotlib(expected):
            require_nearly_the_same(picture, expected)
        else:
            assert picture.read_bytes() == expected.read_bytes()


def test_every_picture_is_drawn_by_an_example(run: Run) -> None:
    assert {picture.name for program in PROGRAMS for picture in run(program).iterdir()} == PICTURES


def test_the_page_shows_every_example() -> None:
    assert set(re.findall(r"\[(\w+\.py)\]\(\1\)", PAGE)) == {p.name for p in PROGRAMS}
    assert set(re.findall(r"!\[[^]]+\]\(([^)]+)\)", PAGE)) == PICTURES
