"""Parts that processes of the command draw, by GNU parallel or as a job array: programs/draw-part."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT, ring

DRAW_PART = ROOT / "programs" / "draw-part"
GEARS = ROOT / "programs" / "gears.draw"
WALL = ("rows", 90, GEARS, "-o", "wall-{part}.ppm", "--size", "120x90")
JOIN = "{ printf 'P6\\n120 90\\n255\\n'; tail -qn +4 wall-*.ppm; } > wall.ppm"


@pytest.fixture
def part(tmp_path):
    """Runs draw-part in a folder of its own, with what the environment says beside."""

    def run(*words: object, **said: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [DRAW_PART, *map(str, words)],
            cwd=tmp_path,
            env=environment(**said),
            capture_output=True,
            text=True,
        )

    return run


def environment(**said: object) -> dict[str, str]:
    command = {"DISPLAYFILE": os.environ["DISPLAYFILE_COMMAND"]}
    return {**os.environ, **command, **{key: str(value) for key, value in said.items()}}


def of_slurm(number: int, first: int, last: int, count: int) -> dict[str, int]:
    return {
        "SLURM_ARRAY_TASK_ID": number,
        "SLURM_ARRAY_TASK_MIN": first,
        "SLURM_ARRAY_TASK_MAX": last,
        "SLURM_ARRAY_TASK_COUNT": count,
    }


def whole_wall(command, tmp_path: Path) -> bytes:
    assert command("draw", GEARS, "-o", "whole.ppm", "--size", "120x90").returncode == 0
    return (tmp_path / "whole.ppm").read_bytes()


def test_bands_of_an_array_are_the_whole_picture(command, part, tmp_path):
    for number in range(1, 13):
        done = part(*WALL, **of_slurm(number, 1, 12, 12))
        assert done.returncode == 0, done.stderr
    subprocess.run(["bash", "-c", JOIN], check=True, cwd=tmp_path)
    assert len(list(tmp_path.glob("wall-??.ppm"))) == 12
    assert (tmp_path / "wall.ppm").read_bytes() == whole_wall(command, tmp_path)


@pytest.mark.skipif(shutil.which("parallel") is None, reason="GNU parallel is not installed")
def test_parallel_draws_the_views_of_one_process(command, tmp_path):
    (tmp_path / "ring.obj").write_text(ring(18, 10))
    words = ("ring.obj", "--size", "80x60", "--hidden", "z-buffer")
    assert command("draw", *words, "-o", "t.png", "--turntable", 13).returncode == 0
    (tmp_path / "turn").mkdir()
    shell = (
        f"seq 0 4 | parallel --retries 3 -j 2 PARTS=5 PART={{}} '{DRAW_PART}' views 13 "
        f"{' '.join(words)} -o turn/t.png"
    )
    subprocess.run(["bash", "-c", shell], check=True, cwd=tmp_path, env=environment())
    drawn = sorted((tmp_path / "turn").iterdir())
    assert [path.name for path in drawn] == [f"t-{k:03}.png" for k in range(13)]
    for path in drawn:
        assert path.read_bytes() == (tmp_path / path.name).read_bytes()


def test_parts_that_are_done_again_are_named(command, part, tmp_path):
    """Where an array has some of the numbers alone, PARTS says how many there are in all."""
    for number in (0, 1, 2):
        assert part(*WALL, PART=number, PARTS=3).returncode == 0
    (tmp_path / "wall-1.ppm").unlink()
    refused = part(*WALL, **of_slurm(1, 1, 3, 2))
    assert refused.returncode == 2 and "expected PARTS" in refused.stderr
    assert part(*WALL, PARTS=3, **of_slurm(1, 1, 1, 1)).returncode == 0
    subprocess.run(["bash", "-c", JOIN], check=True, cwd=tmp_path)
    assert (tmp_path / "wall.ppm").read_bytes() == whole_wall(command, tmp_path)


def test_more_parts_than_rows(part, tmp_path):
    for number in range(12):
        done = part("rows", 9, *WALL[2:-1], "12x9", PART=number, PARTS=12)
        assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.iterdir())) == 9


@pytest.mark.parametrize(
    "words, said",
    [
        (WALL, {}),
        (WALL, {"PART": 0}),
        (WALL, {"PARTS": 3}),
        (WALL, {"PART": 3, "PARTS": 3}),
        (WALL, {"PART": -1, "PARTS": 3}),
        (WALL, {"PART": "a", "PARTS": 3}),
        (WALL, {"PART": "08", "PARTS": 9}),
        (("rows", "many", GEARS), {"PART": 0, "PARTS": 3}),
        (("columns", 90, GEARS), {"PART": 0, "PARTS": 3}),
        (("rows", 90), {"PART": 0, "PARTS": 3}),
        (("rows", 91, *WALL[2:]), {"PART": 2, "PARTS": 3}),
        (("views", 3, GEARS, "-o", "a.bmp"), {"PART": 0, "PARTS": 3}),
    ],
)
def test_what_is_refused(words, said, part, tmp_path):
    done = part(*words, **said)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []
