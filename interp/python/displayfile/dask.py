"""Pictures by bands of rows, and turntables, on the workers of a Dask cluster.

Functions return Dask objects, which are computed on demand by the workers of the current
distributed.Client, or else on this machine. Every pixel is that of System.draw or Turntable.draw,
bit for bit. The scene is sent to each worker once.
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

# The default size of a task: at most these bytes of pixels and this part of the whole.
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
    """Make a picture whose bands of rows are drawn on demand.

    Parameters
    ----------
    system : PicklableSystem
        The system to draw, in its present state.
    size : int or (int, int), optional
        As in System.draw.
    band : int, optional
        Number of rows that one task draws; default: at most 64 MiB of pixels and at most a 32nd of
        the picture.
    ids : bool, optional
        Also draw the item buffer.
    depth : bool, optional
        Also draw the depths.
    **options
        Those of System.draw except rows.

    Returns
    -------
    object
        A dask.array (H, W, 4), uint8, in bands; with ids or depth, a Picture of such arrays. A
        slice computes only the bands that it touches.

    Raises
    ------
    Error
        A system that cannot be sent, or arguments that System.draw refuses, except for errors that
        occur during drawing.
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
    """Make the views of System.turntable, drawn on demand.

    Parameters
    ----------
    system : PicklableSystem
        The system to rotate, in its present state.
    views : int
        As in System.turntable.
    size : int or (int, int), optional
        As in System.draw.
    block : int, optional
        Number of views that one task draws; default: limited as band in draw.
    ids : bool, optional
        Also draw the item buffers.
    depth : bool, optional
        Also draw the depths.
    **options
        Those of System.turntable.

    Returns
    -------
    object
        A dask.array (views, H, W, 4), uint8, in blocks of views; with ids or depth, a Picture of
        such arrays.

    Raises
    ------
    Error
        As in draw, for arguments that System.turntable refuses.
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
    """Make workers draw a picture's bands into files: wall-000.ppm and so on for wall.ppm.

    Each file is written completely or not at all.

    Parameters
    ----------
    system : PicklableSystem
        The system to draw, in its present state.
    path : path_like
        The file name without the number, in a folder that all workers can access; it ends in .png
        or .ppm.
    size : int or (int, int), optional
        As in System.draw.
    band : int, optional
        As in draw.
    **options
        Those of System.draw except rows, ids and depth.

    Returns
    -------
    Delayed
        A Delayed of the names of the files, from the top.

    Raises
    ------
    Error
        As in draw; or an unknown format.
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
    """Make workers draw the views of System.turntable into files, numbered as by Turntable.save.

    Each file is written completely or not at all.

    Parameters
    ----------
    system : PicklableSystem
        The system to rotate, in its present state.
    path : path_like
        The file name without the number, in a folder that all workers can access.
    views : int
        As in System.turntable.
    size : int or (int, int), optional
        As in System.draw.
    block : int, optional
        As in turntable.
    **options
        Those of System.turntable except ids and depth.

    Returns
    -------
    Delayed
        A Delayed of the names of the files.

    Raises
    ------
    Error
        As in turntable; or an unknown format.
    """
    options = _checked(system, options)
    path = _for_workers(path)
    _, blocks = _blocks(system, path, views, size, block, options)
    task = functools.partial(_saved_block, _Turned(views, size, options), path)
    return _names("displayfile-save-turntable", task, system, blocks)


# ---- What one task draws ---------------------------------------------------------------------


class _Turned(typing.NamedTuple):
    """Arguments of System.turntable."""

    views: int
    size: _Size
    options: dict[str, typing.Any]


def _for_workers(path: _Path) -> str:
    """The absolute path: workers run in other folders."""
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
    """The picture's width, and its rows in bands. Raises the Errors of draw."""
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
    """The pictures' height and width, and the views in blocks. Raises the Errors of turntable."""
    drawn = {key: value for key, value in options.items() if key not in ("axis", "fit")}
    width, height = system._require_drawn(path, size, **drawn)
    system._require_turned(views, size, options.get("axis"), options.get("fit"), **drawn)
    if drawn.get("rows") is not None:
        height = drawn["rows"][1] - drawn["rows"][0]
    return (height, width), _shared_out(int(views), 4 * width * height, block, "block")


def _shared_out(number: int, bytes_of_one: int, most: int | None, what: str) -> list[_Range]:
    """Ranges of `most` each, except for the last."""
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
            "a system is sent to workers as its calls: expected a PicklableSystem, not "
            f"{type(system).__name__}"
        )
    return system._checked(options)


# ---- On the workers --------------------------------------------------------------------------


class _Scene:
    """Calls, and the systems and turntables made from them in this process.

    They are kept between tasks, one for each concurrent thread.
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
    """The system's scene, the same one until more is entered."""
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
    """A graph of one task per part, under its number, and the scene's task."""
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
    """Pixels, ids and depths as arrays, chunked along the first axis only."""
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
    """The concatenated lists that the tasks return."""
    name, graph = _graph(name, task, system, parts)
    own = f"{name}-names"
    all_names = {own: (_joined, [(name, k) for k in range(len(parts))])}
    layers = {**graph.layers, own: all_names}
    return Delayed(own, HighLevelGraph(layers, {**graph.dependencies, own: {name}}))


def _joined(lists: list[list[str]]) -> list[str]:
    return list(itertools.chain.from_iterable(lists))
