"""A system that can be sent to another process as the calls that entered its contents.

System.recording is a drawing program. It has a mesh polygon by polygon, without the aspect ratio of
pictures and the up axis of a fitted view. Calls have arrays and paths, as they were passed.
"""

from __future__ import annotations

import contextlib
import functools
import os
import threading
import typing

from . import _displayfile
from ._displayfile import Error
from ._system import System

_ENTERING = (
    *_displayfile.user_routines(),
    *("look", "mesh", "surface", "polyline", "colour_bar", "legend"),
    *("replay", "replay_file", "import_mesh", "set_aspect_ratio", "record"),
)
_OF_FILES = ("import_mesh", "replay_file")
_DEEPEST = 32  # nesting of sequences
_BETWEEN_ASKING = 0.02  # seconds, whether a limit ends the wait for another thread


class _Call(typing.NamedTuple):
    routine: str
    arguments: tuple[typing.Any, ...]
    said: dict[str, typing.Any]


class Calls:
    """The calls that entered a system's contents. It can be pickled.

    It has the paths of files, not their contents: files are read again.
    """

    def __init__(self, said: dict[str, typing.Any], calls: tuple[_Call, ...]) -> None:
        """Called by PicklableSystem.calls."""
        self._said = said
        self._calls = calls

    def system(self, *, retain: bool | None = None) -> System:
        """Make a system and repeat the calls.

        Parameters
        ----------
        retain : bool, optional
            As in System; default: as in the original system.

        Returns
        -------
        System
            The system.

        Raises
        ------
        Error
            A file has changed.
        """
        said = self._said if retain is None else {**self._said, "retain": retain}
        return self._entered_into(System(**said))

    def _entered_into(self, system: System) -> System:
        # A subclass may have routines of its own under these names, which call them.
        kind = PicklableSystem if isinstance(system, PicklableSystem) else System
        for routine, arguments, said in self._calls:
            getattr(kind, routine)(system, *arguments, **said)
        return system

    @property
    def nbytes(self) -> int:
        """The size of its arrays and texts in bytes."""
        return sum(
            _bytes_of(call.arguments) + _bytes_of(tuple(call.said.values())) for call in self._calls
        )


class PicklableSystem(System):
    """A System that can be pickled and copied: it keeps the calls that entered its contents.

    Arrays, buffers and sequences that are entered are copied. Files of meshes and programs are read
    again, by their paths, when it is unpickled.
    """

    def __init__(
        self,
        *,
        aspect: float | None = None,
        lines: str | None = None,
        retain: bool = False,
    ) -> None:
        """Make an empty system.

        Parameters
        ----------
        aspect : float, optional
            As in System.
        lines : str, optional
            As in System.
        retain : bool, optional
            As in System.
        """
        super().__init__(aspect=aspect, lines=lines, retain=retain)
        self._said = {"aspect": aspect, "lines": lines, "retain": retain}
        self._noted: list[_Call] = []
        self._calls: Calls | None = None
        self._in_turn = threading.RLock()
        self._is_known = True

    @property
    def calls(self) -> Calls:
        """The calls so far: the same object until more is entered."""
        with self._turn():
            if not self._is_known:
                raise Error("a call was interrupted: it is not known whether it entered anything")
            if self._calls is None or len(self._calls._calls) != len(self._noted):
                self._calls = Calls(self._said, tuple(self._noted))
            return self._calls

    @contextlib.contextmanager
    def _turn(self) -> typing.Iterator[None]:
        """Wait until no other thread enters anything; limits and interrupts end the wait."""
        while not self._in_turn.acquire(timeout=_BETWEEN_ASKING):
            _displayfile._ask_limits()
        try:
            yield
        finally:
            self._in_turn.release()

    def __reduce__(self) -> tuple[typing.Any, ...]:
        return _again, (type(self), self._said, self.calls)

    def _note(self, routine: str, arguments: typing.Any, said: typing.Any) -> typing.Any:
        """Call the routine of System with copies of mutable arguments, and note the call."""
        if routine in _OF_FILES:
            arguments = (*map(_absolute, arguments[:1]), *arguments[1:])
            said = {name: _absolute(v) if name == "path" else v for name, v in said.items()}
        call = _Call(routine, _kept(arguments), {name: _kept(v) for name, v in said.items()})
        with self._turn():
            was_known, self._is_known = self._is_known, False
            try:
                returned = getattr(System, routine)(self, *call.arguments, **call.said)
            except Exception:  # nothing was entered
                self._is_known = was_known
                raise
            self._noted.append(call)
            self._is_known = was_known
            return returned


def _again(kind: type[PicklableSystem], said: dict[str, typing.Any], calls: Calls) -> System:
    return calls._entered_into(kind(**said))


def _noting(routine: str) -> typing.Any:
    @functools.wraps(getattr(System, routine))
    def note(self: PicklableSystem, *arguments: typing.Any, **said: typing.Any) -> typing.Any:
        return self._note(routine, arguments, said)

    return note


for _routine in _ENTERING:
    setattr(PicklableSystem, _routine, _noting(_routine))


def _kept(value: typing.Any, depth: int = 0) -> typing.Any:
    """The argument, with mutable parts copied. Too deep nesting is refused later."""
    if value is None or isinstance(value, (str, bytes, int, float)):
        return value
    # Unreadable values are passed on and refused by the routine.
    with contextlib.suppress(TypeError, ValueError, OverflowError, BufferError, ReferenceError):
        if hasattr(value, "__array__") or _is_buffer(value):
            return _array(value)
        if _is_sequence(value) and depth < _DEEPEST:
            return tuple(_kept(part, depth + 1) for part in value)
    return value


def _array(value: typing.Any) -> typing.Any:
    """A copy that keeps masks."""
    import numpy as np

    return value.copy() if isinstance(value, np.ma.MaskedArray) else np.array(value)


def _is_buffer(value: typing.Any) -> bool:
    """Whether it supports the buffer protocol, as array.array and ctypes arrays do."""
    try:
        memoryview(value).release()
    except TypeError:
        return False
    return True


def _is_sequence(value: typing.Any) -> bool:
    kind = type(value)
    return hasattr(kind, "__len__") and hasattr(kind, "__getitem__") and not isinstance(value, dict)


def _absolute(path: typing.Any) -> typing.Any:
    """The absolute path. Invalid paths are refused later."""
    try:
        return path if os.fspath(path) in ("-", b"-") else os.path.abspath(path)
    except (TypeError, ValueError):
        return path


def _bytes_of(value: typing.Any) -> int:
    if isinstance(value, tuple):
        return sum(map(_bytes_of, value))
    if isinstance(value, str):
        return len(value)
    return int(getattr(value, "nbytes", 8))
