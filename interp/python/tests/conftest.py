from __future__ import annotations

import math
import os
import subprocess
from pathlib import Path
from typing import Callable

import pytest

ROOT = Path(__file__).resolve().parents[3]


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A test that is skipped is a failure: what it needs is a package that tests/run installs. Where
    a system does not offer it, DISPLAYFILE_MAY_SKIP is set."""
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    skipped = reporter.stats.get("skipped", []) if reporter is not None else []
    if not skipped or os.environ.get("DISPLAYFILE_MAY_SKIP"):
        return
    reasons = sorted({report.longrepr[2] for report in skipped if isinstance(report.longrepr, tuple)})
    reporter.write_line("")
    reporter.write_line(
        f"{len(skipped)} skipped: expected none, or DISPLAYFILE_MAY_SKIP to be set: {reasons}"
    )
    session.exitstatus = pytest.ExitCode.TESTS_FAILED


def ring(around: int, across: int) -> str:
    """A closed ring of so many quads around and across, as an OBJ file has it."""
    lines = []
    for k in range(around):
        for j in range(across):
            a, b = 2 * math.pi * k / around, 2 * math.pi * j / across
            r = 1 + 0.4 * math.cos(b)
            lines.append(f"v {r * math.cos(a)!r} {0.4 * math.sin(b)!r} {r * math.sin(a)!r}")
    for k in range(around):
        for j in range(across):
            next_k, next_j = (k + 1) % around, (j + 1) % across
            corners = (k, j), (k, next_j), (next_k, next_j), (next_k, j)
            lines.append("f " + " ".join(str(of * across + at + 1) for of, at in corners))
    return "\n".join(lines) + "\n"


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
