from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Callable

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def command(tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Runs the command in a folder of its own."""
    path = os.environ.get("DISPLAYFILE_COMMAND")
    if path is None:
        pytest.fail("DISPLAYFILE_COMMAND: expected the path of the command")

    def run(*words: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [path, *map(str, words)], cwd=tmp_path, capture_output=True, text=True
        )

    return run
