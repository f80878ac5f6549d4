"""Pictures by bands of rows, and turntables, on the workers of a Dask cluster.

What is returned is Dask's own, and computed when it is asked for: by the workers of the
distributed.Client that there is, or else on this machine. Every pixel is that of System.draw, and
of Turntable.draw, bit for bit. The scene is sent to each worker once.
"""

from __future__ import annotations

import contextlib
import functools
import itertools
import operator
import os
import threading
import typing
import uuid
import weakref

from ._displayfile import Error, _numbered
from ._picture import Picture
from ._calls import Calls, PicklableSystem

try:
    import dask.array
    from dask.base import tokenize
    from dask.delayed import Delayed
    from dask.highlevelgraph import HighLevelGraph
    from dask.sizeof import sizeof
except ImportError:
    raise Error("displayfile.dask needs Dask: expected the package dask, python3-dask of Debian")

if typing.TYPE_CHECKING:
    from ._displayfile import _Path, _Size

__all__ = ["draw", "save", "save_turntable", "turntable"]

# What one task draws, where it is not said: so many bytes of pixels at most, and no more than one
# of so many parts of the whole.
_MOST_BYTES = 1 << 26
_PARTS = 32

_Range = tuple[int, int]


def draw(
    system: PicklableSystem,
    size: _Size = 512,
    *,
    band: int | None = None,
    ids: bool = False,
    depth: bool = False,
    **options: typing.Any,
) -> typing.Any:
    """Make a picture whose bands of rows are drawn when they are asked for.

    Args:
        system: What is drawn, as it is now.
        size: As in System.draw.
        band: How many rows one task draws. If it is not said, at most 64 MiB of pixels and at most a
            32nd of the picture.
        ids: Draw the item buffer too.
        depth: Draw the depths too.
        options: Those of System.draw but rows.

    Returns:
        A dask.array (H, W, 4), uint8, in bands; or with ids or depth a Picture of such arrays. A slice
        asks for the bands that it touches alone.

    Raises:
        Error: A system that cannot be sent, or what System.draw would refuse, but for what is only
            known as it is drawn.
    """
    options = _checked(system, {"ids": ids, "depth": depth, **options})
    width, bands = _bands(system, None, size, band, options)
    task = functools.partial(_drawn_band, size, options)
    return _pictures("displayfile-draw", task, system, bands, (width,), ids, depth)


def turntable(
    system: PicklableSystem,
    views: int,
    size: _Size = 512,
    *,
    block: int | None = None,
    ids: bool = False,
    depth: bool = False,
    **options: typing.Any,
) -> typing.Any:
    """Make the views of System.turntable, which are drawn when they are asked for.

    Args:
        system: What turns, as it is now.
        views: As in System.turntable.
        size: As in System.draw.
        block: How many views one task draws; if it is not said, as many as draw does of rows.
        ids: Draw the item buffers too.
        depth: Draw the depths too.
        options: Those of System.turntable.

    Returns:
        A dask.array (views, H, W, 4), uint8, in blocks of views; or with ids or depth a Picture of such
        arrays.

    Raises:
        Error: As draw does, of what System.turntable would refuse.
    """
    options = _checked(system, {"ids": ids, "depth": depth, **options})
    (height, width), blocks = _blocks(system, None, views, size, block, options)
    task = functools.partial(_drawn_block, _Turned(views, size, options))
    return _pictures("displayfile-turntable", task, system, blocks, (height, width), ids, depth)


def save(
    system: PicklableSystem,
    path: _Path,
    size: _Size = 512,
    *,
    band: int | None = None,
    **options: typing.Any,
) -> Delayed:
    """Have workers draw a picture's bands into files: wall-000.ppm and so on for wall.ppm.

    Each file appears whole or not at all.

    Args:
        system: What is drawn, as it is now.
        path: Where to, without the number, in a folder that all workers see; its name ends in .png
            or .ppm.
        size: As in System.draw.
        band: As in draw.
        options: Those of System.draw but rows, ids and depth.

    Returns:
        A Delayed; computed it is the names of the files, from the top.

    Raises:
        Error: As draw does; or an unknown format.
    """
    options = _checked(system, options)
    path = _for_workers(path)
    _, bands = _bands(system, path, size, band, options)
    files = [_numbered(path, k, len(bands)) for k in range(len(bands))]
    task = functools.partial(_saved_band, size, options)
    return _names("displayfile-save", task, system, list(zip(files, bands)))


def save_turntable(
    system: PicklableSystem,
    path: _Path,
    views: int,
    size: _Size = 512,
    *,
    block: int | None = None,
    **options: typing.Any,
) -> Delayed:
    """Have workers draw the views of System.turntable into files, as Turntable.save numbers them.

    Each file appears whole or not at all.

    Args:
        system: What turns, as it is now.
        path: Where to, without the number, in a folder that all workers see.
        views: As in System.turntable.
        size: As in System.draw.
        block: As in turntable.
        options: Those of System.turntable but ids and depth.

    Returns:
        A Delayed; computed it is the names of the files.

    Raises:
        Error: As turntable does; or an unknown format.
    """
    options = _checked(system, options)
    path = _for_workers(path)
    _, blocks = _blocks(system, path, views, size, block, options)
    task = functools.partial(_saved_block, _Turned(views, size, options), path)
    return _names("displayfile-save-turntable", task, system, blocks)


# ---- What one task draws ---------------------------------------------------------------------


class _Turned(typing.NamedTuple):
    """How a turntable is made."""

    views: int
    size: _Size
    options: dict[str, typing.Any]


def _for_workers(path: _Path) -> str:
    """They are in other folders."""
    try:
        return os.path.abspath(os.fsdecode(path))
    except TypeError:
        raise Error(f"path: expected a path, not {type(path).__name__}") from None


def _bands(
    system: PicklableSystem,
    path: _Path | None,
    size: _Size,
    band: int | None,
    options: dict[str, typing.Any],
) -> tuple[int, list[_Range]]:
    """The picture's width, and its rows shared out. What draw would refuse is refused here."""
    if "rows" in options:
        raise Error("rows: expected a slice of the picture that is returned, or a band")
    width, height = system._require_drawn(path, size, rows=(0, 1), **options)
    return width, _shared_out(height, 4 * width, band, "band")


def _blocks(
    system: PicklableSystem,
    path: _Path | None,
    views: int,
    size: _Size,
    block: int | None,
    options: dict[str, typing.Any],
) -> tuple[tuple[int, int], list[_Range]]:
    """The pictures' height and width, and the views shared out; refuses likewise."""
    drawn = {key: value for key, value in options.items() if key not in ("axis", "fit")}
    width, height = system._require_drawn(path, size, **drawn)
    system._require_turned(views, size, options.get("axis"), options.get("fit"), **drawn)
    if drawn.get("rows") is not None:
        height = drawn["rows"][1] - drawn["rows"][0]
    return (height, width), _shared_out(int(views), 4 * width * height, block, "block")


def _shared_out(number: int, bytes_of_one: int, most: int | None, what: str) -> list[_Range]:
    """Ranges of `most` each, but for the last."""
    if most is None:
        most = max(1, min(_MOST_BYTES // bytes_of_one, -(-number // _PARTS)))
    try:
        step = 0 if isinstance(most, bool) else operator.index(most)
    except TypeError:
        step = 0
    if step < 1:
        raise Error(f"{what} {most}: expected a whole number, 1 or more")
    return [(first, min(first + step, number)) for first in range(0, number, step)]


def _checked(system: typing.Any, options: dict[str, typing.Any]) -> dict[str, typing.Any]:
    if not isinstance(system, PicklableSystem):
        raise Error(
            "a system is sent to workers by its calls: expected a PicklableSystem, not "
            f"{type(system).__name__}"
        )
    return system._checked(options)


# ---- On the workers --------------------------------------------------------------------------


class _Scene:
    """Calls, and the systems and turntables that were made by them where it is.

    They are kept from task to task, one for each thread that draws at the same time.
    """

    def __init__(self, calls: Calls, key: str) -> None:
        self.calls = calls
        self.key = key
        self._ready: dict[typing.Any, list[typing.Any]] = {}
        self._in_turn = threading.Lock()

    def __reduce__(self) -> tuple[typing.Any, ...]:
        return _Scene, (self.calls, self.key)

    @contextlib.contextmanager
    def ready(self, key: str, make: typing.Callable[[], typing.Any]) -> typing.Iterator[typing.Any]:
        with self._in_turn:
            free = self._ready.setdefault(key, [])
            made = free.pop() if free else None
        if made is None:
            made = make()
        try:
            yield made
        finally:
            with self._in_turn:
                free.append(made)

    def system(self) -> typing.Any:
        return self.ready("system", self.calls.system)

    def turntable(self, turned: _Turned) -> typing.Any:
        def make() -> typing.Any:
            system = self.calls.system(retain=True)
            return system.turntable(turned.views, turned.size, **turned.options)

        return self.ready(tokenize(*turned), make)


@sizeof.register(_Scene)  # type: ignore[misc]
def _size_of(scene: _Scene) -> int:
    return scene.calls.nbytes


def _drawn_band(
    size: _Size, options: dict[str, typing.Any], scene: _Scene, rows: _Range
) -> typing.Any:
    with scene.system() as system:
        return system.draw(size, rows=rows, **options)


def _saved_band(
    size: _Size, options: dict[str, typing.Any], scene: _Scene, saved: tuple[str, _Range]
) -> list[str]:
    file, rows = saved
    with scene.system() as system:
        system.save(file, size, rows=rows, **options)
    return [file]


def _drawn_block(turned: _Turned, scene: _Scene, views: _Range) -> typing.Any:
    import numpy as np

    with scene.turntable(turned) as turntable:
        drawn = [turntable.draw(view) for view in range(*views)]
    if not isinstance(drawn[0], Picture):
        return np.stack(drawn)
    parts: typing.Any = (None if part[0] is None else np.stack(part) for part in zip(*drawn))
    return Picture(*parts)


def _saved_block(turned: _Turned, path: str, scene: _Scene, views: _Range) -> list[str]:
    with scene.turntable(turned) as turntable:
        saved: list[str] = turntable.save(path, views)
    return saved


# ---- Graphs ----------------------------------------------------------------------------------

_scenes: weakref.WeakKeyDictionary[Calls, _Scene] = weakref.WeakKeyDictionary()


def _scene_of(system: PicklableSystem) -> Delayed:
    """It stays one as long as nothing is entered into the system."""
    calls = system.calls
    scene = _scenes.setdefault(calls, _Scene(calls, f"displayfile-scene-{uuid.uuid4().hex}"))
    graph = HighLevelGraph.from_collections(scene.key, {scene.key: scene}, dependencies=[])
    return Delayed(scene.key, graph)


def _graph(
    name: str,
    task: typing.Any,
    system: PicklableSystem,
    parts: typing.Sequence[typing.Any],
    zeros: tuple[int, ...] = (),
) -> tuple[str, HighLevelGraph]:
    """A task for each part, under its number, and that of the scene."""
    scene = _scene_of(system)
    name = f"{name}-{uuid.uuid4().hex}"
    tasks = {(name, k, *zeros): (task, scene.key, part) for k, part in enumerate(parts)}
    return name, HighLevelGraph.from_collections(name, tasks, dependencies=[scene])


def _pictures(
    name: str,
    task: typing.Any,
    system: PicklableSystem,
    parts: list[_Range],
    shape: tuple[int, ...],
    ids: bool,
    depth: bool,
) -> typing.Any:
    """Pixels, ids and depths as arrays: parts of the first axis, whole in the others."""
    chunks = (tuple(end - first for first, end in parts), *((side,) for side in shape))
    zeros = (0,) * len(shape)
    if not (ids or depth):
        name, graph = _graph(name, task, system, parts, (*zeros, 0))
        return dask.array.Array(graph, name, (*chunks, (4,)), dtype="uint8")
    name, graph = _graph(name, task, system, parts)
    members = itertools.count()

    def member(asked: bool, own_chunks: typing.Any, dtype: str) -> typing.Any:
        number = next(members)
        if not asked:
            return None
        own = f"{name}-{number}"
        own_zeros = (0,) * (len(own_chunks) - 1)
        tasks = {
            (own, k, *own_zeros): (operator.itemgetter(number), (name, k))
            for k in range(len(parts))
        }
        layers = {**graph.layers, own: tasks}
        own_graph = HighLevelGraph(layers, {**graph.dependencies, own: {name}})
        return dask.array.Array(own_graph, own, own_chunks, dtype=dtype)

    return Picture(
        member(True, (*chunks, (4,)), "uint8"),
        member(ids, chunks, "int32"),
        member(depth, chunks, "float64"),
    )


def _names(
    name: str, task: typing.Any, system: PicklableSystem, parts: typing.Sequence[typing.Any]
) -> Delayed:
    """The lists that the tasks return, one after another."""
    name, graph = _graph(name, task, system, parts)
    own = f"{name}-names"
    all_names = {own: (_joined, [(name, k) for k in range(len(parts))])}
    layers = {**graph.layers, own: all_names}
    return Delayed(own, HighLevelGraph(layers, {**graph.dependencies, own: {name}}))


def _joined(lists: list[list[str]]) -> list[str]:
    return list(itertools.chain.from_iterable(lists))
