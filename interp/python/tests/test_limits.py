"""What work may use at most; pens."""

from __future__ import annotations

import asyncio
import threading
from typing import Any, Iterator

import numpy as np
import pytest

import displayfile
from displayfile import Error, LimitReached, System, limits

SOUP = np.random.default_rng(4).uniform(-1, 1, (120, 3, 3))


def soup(**options: Any) -> System:
    g = System(**options)
    g.mesh(SOUP.reshape(-1, 3), np.arange(360).reshape(-1, 3))
    return g


@pytest.mark.parametrize(
    "limit", [{"pieces": 130}, {"comparisons": 2}, {"bytes": 1000}, {"seconds": 0}]
)
def test_work_stops_at_a_limit(limit: dict[str, Any]) -> None:
    for call in (
        lambda g: g.svg(16, hidden="bsp"),
        lambda g: g.pieces(hidden="bsp"),
        lambda g: displayfile.sort(SOUP, method="bsp"),
    ):
        expected = call(soup())
        g = soup()
        with limits(**limit), pytest.raises(LimitReached, match="limit"):
            call(g)
        assert g.dump() == soup().dump()
        with limits(pieces=10**6, comparisons=10**9, bytes=10**9, seconds=1e9):
            again = call(g)
        if isinstance(expected, tuple):
            assert all(map(np.array_equal, again, expected))
        else:
            assert again == expected


def test_comparisons_are_those_of_the_whole_block() -> None:
    with limits(comparisons=10**6):
        with pytest.raises(LimitReached, match="comparisons"):
            for _ in range(10**4):
                displayfile.sort(SOUP, method="bsp")


def test_the_innermost_block_counts() -> None:
    g = soup()
    with limits(pieces=1):
        with limits(pieces=10**6):
            g.svg(16, hidden="bsp")
        with pytest.raises(LimitReached):
            soup().svg(16, hidden="bsp")
    soup().svg(16, hidden="bsp")


def test_limits_are_those_of_a_thread() -> None:
    done: list[str] = []
    with limits(pieces=1):
        thread = threading.Thread(target=lambda: done.append(soup().svg(16, hidden="bsp")))
        thread.start()
        thread.join()
    assert done


def is_limited() -> bool:
    try:
        soup().svg(16, hidden="bsp")
    except LimitReached:
        return True
    return False


def test_the_block_that_ends_is_the_one_that_ends() -> None:
    def block(pieces: int) -> Iterator[None]:
        with limits(pieces=pieces):
            yield

    narrow, wide = block(1), block(10**6)
    next(narrow)
    next(wide)
    next(narrow, None)
    assert not is_limited()
    narrow = block(1)
    next(narrow)
    next(wide, None)
    assert is_limited()
    next(narrow, None)
    assert not is_limited()


def test_limits_are_those_of_a_task() -> None:
    async def limited(begun: asyncio.Event, end: asyncio.Event) -> None:
        with shared:
            begun.set()
            await end.wait()
            assert is_limited()
            begun_within = asyncio.ensure_future(is_limited_later())
            await asyncio.sleep(0)
            assert await begun_within
            outlives = asyncio.ensure_future(is_limited_later())
        assert not await outlives
        assert not is_limited()

    async def is_limited_later() -> bool:
        await asyncio.sleep(0)
        return is_limited()

    async def all_tasks() -> None:
        begun, end = asyncio.Event(), asyncio.Event()
        tasks = [asyncio.ensure_future(limited(begun, end)) for _ in range(2)]
        await begun.wait()
        assert not is_limited()
        end.set()
        for task in tasks:
            await task

    shared = limits(pieces=1)
    asyncio.run(all_tasks())


def test_limits_end_where_they_began() -> None:
    block = limits(pieces=1)
    with pytest.raises(Error, match="expected to end in the thread and the context"):
        block.__exit__(None, None, None)
    with block, block:
        assert is_limited()
    assert not is_limited()


def test_a_segment_that_cannot_be_sorted_leaves_nothing() -> None:
    g, other = System(), System()
    for system in (g, other):
        system.set_window(-1, 1, -1, 1)  # no view is fitted when it is drawn
        system.set_hidden_line_removal(True)
        system.set_back_face_removal(False)
        system.set_hidden_method("bsp")
    g.record()
    vertices, faces = SOUP.reshape(-1, 3), np.arange(360).reshape(-1, 3)
    program = "open-segment 1\n" + "".join(
        f"polygon-abs-3 {' '.join(map(repr, triangle.ravel().tolist()))}\n" for triangle in SOUP
    )
    with limits(pieces=130):
        with pytest.raises(LimitReached):
            g.mesh(vertices, faces)
        with pytest.raises(LimitReached) as refused:
            g.replay(program + "close-segment\n", "soup")
    assert (refused.value.file, refused.value.line) == ("soup", 122)
    assert g.segments == [] and g.recording == ""
    for system in (g, other):  # with the ordinals from the first on
        system.open_segment(1)
        system.mesh(vertices, faces)
    with limits(pieces=130), pytest.raises(LimitReached):
        g.close_segment()
    assert g.open_segment_name == 1
    assert g.dump() == other.dump()
    for system in (g, other):
        system.close_segment()
        system.surface([0, 1], [0, 1], [[0, 0], [0, 0]])
    assert g.dump() == other.dump()


@pytest.mark.parametrize(
    "limit",
    [
        {"pieces": -1},
        {"pieces": 2**64},
        {"bytes": 1.5},
        {"seconds": -1},
        {"seconds": float("nan")},
    ]
    + [{"comparisons": "many"}, {"seconds": None, "pieces": True}],
)
def test_limits_that_are_refused(limit: dict[str, Any]) -> None:
    with pytest.raises(Error) as refused:
        limits(**limit)
    assert not isinstance(refused.value, LimitReached)


# ---- Pens --------------------------------------------------------------------------------


def cube() -> System:
    g = System()
    g.set_perspective(3, 2, 6)
    g.set_hidden_line_removal(True)
    g.open_segment(1)
    g.box_3(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5)
    g.close_segment()
    return g


def test_pens_are_the_command_s(command: Any, tmp_path: Any) -> None:
    g = cube()
    g.record()
    program = (
        "set-perspective 3 2 6\nset-hidden-line-removal on\nopen-segment 1\n"
        "box-3 -0.5 0.5 -0.5 0.5 -0.5 0.5\nclose-segment\n"
    )
    (tmp_path / "cube.draw").write_text(program)
    for words, options in [
        (["--pens"], {"pens": True}),
        (
            ["--pens", "--paper", "A5", "--margin", "20"],
            {"pens": True, "paper": "A5", "margin": 20},
        ),
        (["--hatch", "2", "--hidden", "map"], {"hatch": 2.0, "hidden": "map"}),
        (
            ["--hatch", "2,30,cross,width=0.5,#ff0000", "--hidden", "map"],
            {
                "hatch": dict(spacing=2, angle=30, cross=True, width=0.5, colour=(1, 0, 0)),
                "hidden": "map",
            },
        ),
    ]:
        done = command("draw", "cube.draw", "-o", "a.svg", "--size", "200x200", "--quiet", *words)
        assert done.returncode == 0, done.stderr
        assert g.svg(200, **options).encode() == (tmp_path / "a.svg").read_bytes()


@pytest.mark.parametrize(
    "options",
    [
        {"margin": 3},
        {"hatch": 0.01},
        {"hatch": {"spacing": 1, "depth": 2}},
        {"hatch": {"colour": (2, 0, 0)}},
        {"hatch": {5: 1}},
        {"pens": "yes"},
        {"pens": True, "hidden": "z-buffer"},
        {"paper": "A4", "margin": 1e9},
    ],
)
def test_pens_that_are_refused(options: dict[str, Any]) -> None:
    with pytest.raises(Error):
        cube().svg(100, **options)
