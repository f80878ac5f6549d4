"""Colours as matplotlib takes them, and colour maps."""

from __future__ import annotations

import typing

from . import _displayfile
from ._displayfile import Error

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]

_LETTERS = {
    "b": (0.0, 0.0, 1.0),
    "g": (0.0, 0.5, 0.0),
    "r": (1.0, 0.0, 0.0),
    "c": (0.0, 0.75, 0.75),
    "m": (0.75, 0.0, 0.75),
    "y": (0.75, 0.75, 0.0),
    "k": (0.0, 0.0, 0.0),
    "w": (1.0, 1.0, 1.0),
}
_CYCLE = ("blue", "orange", "green", "red", "purple", "brown", "pink", "gray", "olive", "cyan")
_OF_CYCLE = (
    *("#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd"),
    *("#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf"),
)
_UNKNOWN = (0.75, 0.75, 0.75)
"""The colour of values that are nan or masked."""
_STEPS = 256
_FINE_STEPS = 4096
UNREADABLE: tuple[type[Exception], ...] = (TypeError, ValueError, ReferenceError)
"""What objects raise that are no numbers: a weak reference to nothing raises the last."""


def is_a(value: typing.Any, kind: type | tuple[type, ...]) -> bool:
    """As isinstance, of any object."""
    try:
        return isinstance(value, kind)
    except ReferenceError:
        return False


def colour(value: typing.Any, what: str = "colour") -> tuple[float, float, float]:
    """Red, green and blue of one colour.

    A name of CSS or of matplotlib's cycle, one of its letters, #rrggbb, a grey such as "0.5", or
    three or four numbers from 0 to 1; what is not opaque is refused.
    """
    if is_a(value, str):
        return _of_word(value, what)
    import numpy as np

    try:
        parts = np.asarray(value, float)
    except UNREADABLE:
        raise Error(f"{what}: expected a colour, not {type(value).__name__}") from None
    if parts.shape not in ((3,), (4,)):
        raise Error(f"{what}: expected a name or red, green and blue, not shape {parts.shape}")
    return tuple(_opaque(parts[None], what)[0].tolist())  # type: ignore[return-value]


def _of_word(word: str, what: str) -> tuple[float, float, float]:
    name = word.strip().lower()
    if name in _LETTERS:
        return _LETTERS[name]
    if name.startswith("tab:") and name[4:].replace("grey", "gray") in _CYCLE:
        name = _OF_CYCLE[_CYCLE.index(name[4:].replace("grey", "gray"))]
    elif len(name) > 1 and name[0] == "c" and name[1:].isdecimal():
        name = _OF_CYCLE[int(name[1:]) % len(_OF_CYCLE)]
    elif name.startswith("#") and len(name) in (5, 9):
        alpha = name[-1] if len(name) == 5 else name[-2:]
        if alpha.strip("f"):
            raise Error(f"{what} '{word}': expected an opaque colour: nothing is translucent")
        name = name[: -len(alpha)]
    else:
        grey = _grey(name)
        if grey is not None:
            return grey, grey, grey
    return _displayfile._colour_of(name, f"{what} '{word}'")


def _grey(word: str) -> float | None:
    try:
        grey = float(word)
    except ValueError:
        return None
    return grey if 0.0 <= grey <= 1.0 else None


def _opaque(colours: Floats, what: str) -> Floats:
    """The colours of an array (N, 3) or (N, 4)."""
    import numpy as np

    wrong = ~((colours >= 0.0) & (colours <= 1.0)).all(axis=1)
    if wrong.any():
        raise Error(f"{what}: colour {colours[wrong][0].tolist()}: expected parts from 0 to 1")
    if colours.shape[1] == 4 and (colours[:, 3] < 1.0).any():
        raise Error(f"{what}: expected opaque colours: nothing is translucent")
    return np.ascontiguousarray(colours[:, :3])


def colours(values: typing.Any, what: str = "colours") -> Floats:
    """Colours as an array (N, 3): of an array (N, 3) or (N, 4), or a sequence of colours.

    Whole numbers of one byte are parts of 255.
    """
    import numpy as np

    if is_a(values, str):
        raise Error(f"{what}: expected many colours, not '{values}'")
    if is_a(values, (list, tuple)) and any(is_a(value, str) for value in values):
        return np.array([colour(value, what) for value in values], float).reshape(-1, 3)
    try:
        array = np.asarray(values)
    except UNREADABLE:
        raise Error(f"{what}: expected an array of shape (N, 3), or a list of colours") from None
    if array.dtype == np.uint8:
        array = array / 255.0
    if array.dtype.kind not in "iuf" and array.size:
        raise Error(f"{what}: expected an array of numbers, or a list of colours")
    if array.size == 0 and array.ndim == 1:
        return np.zeros((0, 3))
    if array.ndim != 2 or array.shape[1] not in (3, 4):
        raise Error(f"{what}: expected an array of shape (N, 3) or (N, 4), not {array.shape}")
    return _opaque(array.astype(float), what)


# ---- Colour maps -------------------------------------------------------------------------


def steps_of(cmap: typing.Any, at: Floats | None = None) -> Floats:
    """The colours of a colour map from its low to its high end, (N, 3).

    None is the command's own, an array (N, 3) its colours; a name is one of matplotlib's, which is
    imported for it; an object of matplotlib's is called. `at`: the colours at these places, from 0
    at its low end to 1.
    """
    import numpy as np

    if cmap is None or is_a(cmap, str) and cmap == "displayfile":
        if at is None:
            return _displayfile._height_colours(_STEPS)
        own = _displayfile._height_colours(_FINE_STEPS)
        return np.asarray(own)[_places(at, len(own))]
    if is_a(cmap, str):
        cmap = _of_matplotlib(cmap)
    if callable(cmap):
        if at is None:
            n = int(getattr(cmap, "N", _STEPS))
            at = (np.arange(n) + 0.5) / n
        return _opaque(np.asarray(cmap(at), float)[:, :3], "cmap")
    table = colours(cmap, "cmap")
    if not len(table):
        raise Error("cmap: expected at least one colour")
    return table if at is None else table[_places(at, len(table))]


def _places(at: Floats, steps: int) -> npt.NDArray[np.int64]:
    import numpy as np

    return np.asarray((at * steps).astype(np.int64).clip(0, steps - 1))


def _of_matplotlib(name: str) -> typing.Any:
    try:
        import matplotlib
    except ImportError:
        raise Error(
            f"cmap '{name}': matplotlib, which has it, is not installed: expected 'displayfile', or "
            "an array of colours"
        ) from None
    try:
        return matplotlib.colormaps[name]
    except KeyError:
        import difflib

        near = difflib.get_close_matches(name, list(matplotlib.colormaps), 1)
        hint = f" did you mean '{near[0]}'?" if near else ""
        raise Error(f"cmap '{name}':{hint} expected a colour map of matplotlib's") from None


class Scale:
    """Colours of scalars: `bounds` (N + 1,) rise, and colours[k] is from bounds[k] to bounds[k + 1].

    What lies outside has the first or the last colour. `is_banded`: the bounds are levels, and not
    steps of a colour map.
    """

    def __init__(self, bounds: Floats, colours: Floats, is_banded: bool = False) -> None:
        self.bounds = bounds
        self.colours = colours
        self.is_banded = is_banded

    @property
    def limits(self) -> tuple[float, float]:
        return float(self.bounds[0]), float(self.bounds[-1])

    def steps(self, values: Floats) -> npt.NDArray[np.int64]:
        """The number of each value's colour; -1 for nan."""
        import numpy as np

        at = np.searchsorted(self.bounds, values, side="right") - 1
        return np.where(np.isnan(values), -1, at.clip(0, len(self.colours) - 1))

    def of_steps(self, steps: npt.NDArray[np.int64]) -> Floats:
        import numpy as np

        known = self.colours[steps.clip(0)]
        return np.where((steps < 0)[:, None], _UNKNOWN, known)


def scale_of(
    values: Floats,
    cmap: typing.Any,
    limits: typing.Any,
    levels: typing.Any = None,
) -> Scale:
    """The scale for these values: `levels` is a number of bands, or their bounds, instead of as many
    colours as the map has. A band has the colour of its middle, as in matplotlib's contourf."""
    import numpy as np

    if np.isinf(values).any():
        raise Error("values: expected finite numbers, or nan where there is none")
    low, high = limits_of(values, limits)
    if levels is None:
        table = steps_of(cmap)
        return Scale(np.linspace(low, high, len(table) + 1), table)
    bounds = bounds_of(levels, low, high)
    # Halves first: the sum of two large bounds may be none.
    middles = 0.5 * bounds[1:] + 0.5 * bounds[:-1]
    colours = steps_of(cmap, (middles - bounds[0]) / (bounds[-1] - bounds[0]))
    return Scale(bounds, colours, is_banded=True)


def bounds_of(levels: typing.Any, low: float, high: float) -> Floats:
    """`levels` rising numbers, or as many bands between low and high."""
    import numpy as np

    if is_a(levels, (int, np.integer)) and not is_a(levels, bool):
        if not 1 <= levels <= 1000:
            raise Error(f"levels: {levels}: expected 1 to 1000, or their bounds")
        return np.linspace(low, high, int(levels) + 1)
    bounds = numbers(levels, "levels")
    if bounds.ndim != 1 or len(bounds) < 2 or not (np.diff(bounds) > 0.0).all():
        raise Error("levels: expected a number of them, or at least 2 rising bounds")
    if not np.isfinite(bounds).all():
        raise Error("levels: expected finite bounds")
    return bounds


def limits_of(values: Floats, limits: typing.Any) -> tuple[float, float]:
    import numpy as np

    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
    if limits is not None:
        try:
            first, last = limits
        except UNREADABLE:
            raise Error("limits: expected the lowest and the highest value") from None
        low = low if first is None else float(numbers(first, "limits"))
        high = high if last is None else float(numbers(last, "limits"))
        if not (np.isfinite([low, high]).all() and low < high):
            raise Error(f"limits: {low:g} to {high:g}: expected finite numbers that rise")
    if not low < high:  # all values are equal: they have the colour in the middle
        size = max(abs(low), 1.0)
        return low - 0.5 * size, low + 0.5 * size
    return low, high


def numbers(values: typing.Any, what: str) -> Floats:
    """As an array of doubles: masked ones are nan."""
    import numpy as np

    if is_a(values, str):
        raise Error(f"{what}: expected numbers, not '{values}'")
    try:
        if is_a(values, np.ma.MaskedArray):
            masked: typing.Any = values.astype(float)
            return np.asarray(masked.filled(np.nan))
        array = np.asarray(values)
        if array.dtype.kind not in "iufb" or array.dtype.kind == "b":
            raise TypeError
        return array.astype(float)
    except UNREADABLE:
        raise Error(f"{what}: expected numbers, not {type(values).__name__}") from None
