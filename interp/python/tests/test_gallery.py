"""Pictures of the gallery's programs are those of the command, byte for byte."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

import displayfile

PROGRAMS = sorted((ROOT / "programs").glob("*.draw"))
WIDTH, HEIGHT = 240, 180


def replayed(program: Path) -> displayfile.System:
    system = displayfile.System(aspect=WIDTH / HEIGHT)
    system.replay_file(program)
    return system


def pixels_of_ppm(path: Path) -> np.ndarray:
    header = f"P6\n{WIDTH} {HEIGHT}\n255\n".encode()
    data = path.read_bytes()
    assert data.startswith(header)
    return np.frombuffer(data[len(header) :], np.uint8).reshape(HEIGHT, WIDTH, 3)


def test_there_is_a_gallery():
    assert len(PROGRAMS) > 20


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_pixels(program, command, tmp_path):
    system = replayed(program)
    size = f"{WIDTH}x{HEIGHT}"
    done = command("draw", program, "-o", "a.ppm", "--size", size)
    assert done.returncode == 0, done.stderr
    pixels = system.draw((WIDTH, HEIGHT))
    assert np.array_equal(pixels[..., :3], pixels_of_ppm(tmp_path / "a.ppm"))
    assert (pixels[..., 3] == 255).all()
    assert system.ppm((WIDTH, HEIGHT)) == (tmp_path / "a.ppm").read_bytes()


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_ids_and_depth(program, command, tmp_path):
    system = replayed(program)
    size = f"{WIDTH}x{HEIGHT}"
    done = command(
        "draw", program, "-o", "a.ppm", "--size", size, "--ids", "i.npy", "--depth", "d.npy"
    )
    if done.returncode != 0:
        assert done.returncode == 2 and "item buffers and depths are of fills" in done.stderr
        with pytest.raises(displayfile.Error) as refused:
            system.draw((WIDTH, HEIGHT), ids=True, depth=True)
        assert str(refused.value) in done.stderr
        return
    picture = system.draw((WIDTH, HEIGHT), ids=True, depth=True)
    assert np.array_equal(picture.ids, np.load(tmp_path / "i.npy"))
    assert np.array_equal(picture.depth, np.load(tmp_path / "d.npy"))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_vectors(program, command, tmp_path):
    system = replayed(program)
    for format in ("svg", "eps"):
        done = command(
            "draw", program, "-o", f"a.{format}", "--size", f"{WIDTH}x{HEIGHT}", "--quiet"
        )
        assert done.returncode == 0, done.stderr
        system.save(tmp_path / f"b.{format}", (WIDTH, HEIGHT))
        expected = (tmp_path / f"a.{format}").read_bytes()
        assert (tmp_path / f"b.{format}").read_bytes() == expected
    assert system.svg((WIDTH, HEIGHT)).encode() == (tmp_path / "a.svg").read_bytes()
    assert system.pdf((WIDTH, HEIGHT)).startswith(b"%PDF-")


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.stem)
def test_dump(program, command):
    system = displayfile.System()
    system.replay_file(program)
    assert system.dump() == command("dump", program).stdout


@pytest.mark.parametrize("method", ["map", "franklin", "z-buffer", "bsp"])
def test_methods(method, command, tmp_path):
    program = ROOT / "programs" / "cyclic-overlap.draw"
    system = replayed(program)
    size = f"{WIDTH}x{HEIGHT}"
    for name in ("a.ppm", "a.svg"):
        done = command("draw", program, "-o", name, "--size", size, "--hidden", method)
        assert done.returncode == 0, done.stderr
    assert system.ppm((WIDTH, HEIGHT), hidden=method) == (tmp_path / "a.ppm").read_bytes()
    svg = system.svg((WIDTH, HEIGHT), hidden=method)
    assert svg.encode() == (tmp_path / "a.svg").read_bytes()


def test_lines_of_a_mesh(command, tmp_path):
    mesh = tmp_path / "m.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 1 2 3\nf 1 3 4\n")
    done = command("draw", mesh, "-o", "a.svg", "--size", "200x200", "--hidden", "auto")
    assert done.returncode == 0, done.stderr
    system = displayfile.System()
    assert system.import_mesh(mesh) == []
    svg = system.svg(200, hidden="auto")
    assert svg.encode() == (tmp_path / "a.svg").read_bytes()


@pytest.mark.parametrize("program", PROGRAMS[::4], ids=lambda program: program.stem)
def test_rows_are_those_of_the_picture(program):
    system = replayed(program)
    whole = system.draw((WIDTH, HEIGHT))
    parts = [system.draw((WIDTH, HEIGHT), rows=rows) for rows in ((0, 50), (50, 51), (51, HEIGHT))]
    assert np.array_equal(np.concatenate(parts), whole)
    for rows in ((3, 3), (-1, 5), (0, HEIGHT + 1), (1,), "all"):
        with pytest.raises(displayfile.Error):
            system.draw((WIDTH, HEIGHT), rows=rows)


AC3D = """AC3Db
MATERIAL "" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0
OBJECT world
kids 1
OBJECT poly
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x20
mat 0
refs 3
0 0 0
1 0 0
2 0 0
kids 0
"""


def test_formats_that_a_library_reads(command, tmp_path):
    """The program that reads them is part of the package."""
    mesh = tmp_path / "m.ac"
    mesh.write_text(AC3D)
    done = command("draw", mesh, "-o", "a.ppm", "--size", "64x64")
    system = displayfile.System()
    if done.returncode != 0:
        assert "built without the import library" in done.stderr
        with pytest.raises(displayfile.Error) as refused:
            system.import_mesh(mesh)
        assert str(refused.value) in done.stderr
        pytest.skip("no import library")
    system.import_mesh(mesh)
    assert system.ppm(64, hidden="auto") == (tmp_path / "a.ppm").read_bytes()
