"""Arguments that a program may hand over without meaning it, and some that it would have to mean.

The names here are those that random_calls.py writes, so that a failing sequence can be pasted.
"""

from __future__ import annotations

import array
import collections
import ctypes
import decimal
import fractions
import os
import pathlib
import weakref
from typing import Any, Callable

import numpy as np

from displayfile import Error, limits

nan, inf = float("nan"), float("inf")

__all__ = [
    "Fresh", "Hostile", "Wrong", "array", "as_array", "asked", "clearing", "collections", "ctypes",
    "dead", "decimal", "fortran", "fractions", "generator", "inf", "liar", "limited", "nan", "np", "odd_float",
    "odd_int", "odd_list", "odd_str", "os", "pathlib", "raising", "read_only", "released",
    "shrinking", "strided", "swapped", "unaligned", "view_drawn", "views_saved",
]  # fmt: skip


class Hostile(Exception):
    """What an argument raises by itself. It comes through, or an Error stands in its place."""

    def __str__(self) -> str:
        return "raised by an argument"


class Wrong:
    """Answers what Python's protocols do not allow, which Python then says in its own words."""

    def __float__(self) -> Any:
        return "no number"

    def __len__(self) -> int:
        return -3

    def __index__(self) -> Any:
        return 1.5

    def __fspath__(self) -> Any:
        return 5


# ---- Sequences ---------------------------------------------------------------------------


class Fresh:
    """A sequence whose parts are made as they are asked for, and are nobody else's."""

    def __init__(self, parts: Any) -> None:
        self.parts = parts

    def __len__(self) -> int:
        return len(self.parts)

    def __getitem__(self, index: int) -> Any:
        part = self.parts[index]
        return list(part) if isinstance(part, (list, tuple)) else part


def shrinking(parts: list[Any]) -> Any:
    """A sequence that has one part fewer whenever its length was asked for."""

    class Shrinking(Fresh):
        def __len__(self) -> int:
            length = len(self.parts)
            self.parts = self.parts[:-1]
            return length

    return Shrinking(list(parts))


def clearing(*numbers: float) -> list[Any]:
    """A list that is empty as soon as its first number is read."""
    parts: list[Any] = []

    class Clears:
        def __float__(self) -> float:
            parts.clear()
            return 0.5

    parts += [Clears(), *numbers]
    return parts


def generator(parts: Any) -> Any:
    return (part for part in parts)


def odd_list(parts: Any) -> Any:
    methods = dict.fromkeys(("__len__", "__getitem__", "__iter__"), raise_hostile)
    return type("OddList", (list,), methods)(parts)


# ---- Things that raise, and that call back ---------------------------------------------------


def raise_hostile(*_: Any) -> Any:
    raise Hostile


def raising(*names: str) -> Any:
    """An object that has these attributes, or methods, each of which raises."""
    members = {
        name: raise_hostile if name.startswith("__") else property(raise_hostile) for name in names
    }
    return type("Raising", (), members)()


def asked(call: Callable[[], Any], value: Any) -> Any:
    """A number, a sequence and an array all at once, which calls something before it answers."""

    def ask() -> None:
        try:
            call()
        except Error:
            pass

    class Asked:
        def __float__(self) -> float:
            ask()
            return float(value if np.ndim(value) == 0 else np.ravel(value)[0])

        def __array__(self, dtype: Any = None) -> Any:
            ask()
            return np.array(value, dtype)

        def __len__(self) -> int:
            ask()
            return len(value)

        def __getitem__(self, index: int) -> Any:
            ask()
            return value[index]

    if np.ndim(value) == 0:
        del Asked.__len__, Asked.__getitem__, Asked.__array__
    return Asked()


def liar(value: Any) -> Any:
    """Says that it is one number of NumPy's, and is not."""

    class Liar:
        dtype = "float64"
        ndim = 0

        def item(self) -> Any:
            return self if value is None else value

    return Liar()


def limited(call: Callable[..., Any], *arguments: Any, most: Any = {}, **named: Any) -> Any:
    with limits(**most):
        return call(*arguments, **named)


def unlimited(call: Callable[..., Any], *arguments: Any, most: Any = {}, **named: Any) -> Any:
    return call(*arguments, **named)


def dead() -> Any:
    """A weak reference to nothing any more, which raises whatever is asked of it."""
    return weakref.proxy(type("Gone", (), {})())


# ---- Numbers and words -------------------------------------------------------------------


def odd_float(value: float) -> Any:
    methods = dict.fromkeys(("__float__", "__eq__", "__lt__", "__hash__"), raise_hostile)
    return type("OddFloat", (float,), methods)(value)


def odd_int(value: int) -> Any:
    methods = dict.fromkeys(("__index__", "__int__", "__float__", "__eq__"), raise_hostile)
    return type("OddInt", (int,), methods)(value)


def odd_str(value: str) -> Any:
    methods = dict.fromkeys(("__str__", "__len__", "encode", "__iter__"), raise_hostile)
    return type("OddStr", (str,), methods)(value)


# ---- Arrays ------------------------------------------------------------------------------


def swapped(values: Any) -> Any:
    """In the other order of bytes."""
    a = np.array(values)
    return a.byteswap().view(a.dtype.newbyteorder())


def fortran(values: Any) -> Any:
    return np.asfortranarray(values)


def strided(values: Any) -> Any:
    """Every second row and column of more, from the last to the first."""
    a = np.array(values)
    wide = np.zeros([2 * n for n in a.shape], a.dtype)
    every = tuple(slice(None, None, -2) for _ in a.shape)
    wide[every] = a
    return wide[every]


def unaligned(values: Any) -> Any:
    a = np.ascontiguousarray(values)
    raw = np.frombuffer(b"x" + a.tobytes(), np.uint8)[1:]
    return raw.view(a.dtype).reshape(a.shape)


def read_only(values: Any) -> Any:
    a = np.array(values)
    a.flags.writeable = False
    return a


def as_array(values: Any, **what: Any) -> Any:
    """An object that becomes an array when it is asked to, by the members that are given."""
    a = np.array(values)
    members = {"__array__": lambda self, dtype=None: a if dtype is None else a.astype(dtype)}
    return type("AsArray", (), {**members, **what})()


def released(values: Any) -> Any:
    """A view of memory that it gave back."""
    view = memoryview(np.array(values))
    view.release()
    return view


# ---- Two calls in one ------------------------------------------------------------------------


def view_drawn(system: Any, view: Any, *turned: Any, **named: Any) -> Any:
    return system.turntable(*turned, **named).draw(view)


def views_saved(system: Any, path: Any, views: Any, *turned: Any, **named: Any) -> Any:
    return system.turntable(*turned, **named).save(path, views)
