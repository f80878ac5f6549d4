"""Meshes and surfaces in colours of scalars, and what stands beside a picture to read them."""

from __future__ import annotations

import typing
import warnings

from . import _colours, _displayfile
from ._displayfile import Error

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

_BAR_STEPS = 64
_LETTER = 0.026  # of the picture's height, as all lengths here
_LETTER_WIDTH = 0.6 * _LETTER
_BAR_WIDTH, _TICK, _BEFORE_NUMBER = 0.025, 0.008, 0.014
_LOW, _HIGH = 0.25, 0.75
_SWATCH, _ROW = 0.024, 0.045
_EDGE = 0.02


# ---- On faces and at vertices ------------------------------------------------------------


def place_of(values: Floats, at: str | None, faces: int, vertices: int) -> str:
    """Whether there is a value for each face, or for each vertex."""
    if values.ndim != 1:
        raise Error(f"values: expected an array of shape (N,), not {values.shape}")
    fitting = [
        place for place, n in (("faces", faces), ("vertices", vertices)) if len(values) == n
    ]
    if at is not None:
        if at not in ("faces", "vertices"):
            raise Error(f"at '{at}': expected faces or vertices")
        if at not in fitting:
            raise Error(f"values: {len(values)} of them for {faces} faces, {vertices} vertices")
        return at
    if len(fitting) == 2:
        raise Error(f"values: {faces} faces and as many vertices: expected at='faces' or 'vertices'")
    if not fitting:
        raise Error(f"values: {len(values)} of them for {faces} faces and {vertices} vertices")
    return fitting[0]


class Pieces(typing.NamedTuple):
    """What is entered of a mesh in colours of values at its vertices."""

    points: Floats
    sides: Indices
    fills: Floats
    face: Indices
    """The face that each is a part of."""


def pieces_of(
    triangles: Floats, face: Indices, values: Floats, scale: _colours.Scale
) -> Pieces:
    """Triangles (T, 3, 3) with values (T, 3), cut where the colour changes."""
    import numpy as np

    from ._bands import bands

    known = ~np.isnan(values).any(axis=1)
    cut = bands(triangles[known], values[known], scale.bounds)
    unknown = triangles[~known]
    return Pieces(
        np.concatenate([cut.points, unknown.reshape(-1, 3)]),
        np.concatenate([cut.sides, np.full(len(unknown), 3)]),
        scale.of_steps(np.concatenate([cut.band, np.full(len(unknown), -1)])),
        np.concatenate([face[known][cut.triangle], face[~known]]),
    )


def picks_of(picks: typing.Any, faces: int) -> typing.Any:
    """One for each face: as set, or its index."""
    import numpy as np

    if picks is None:
        return np.arange(faces)
    given = np.asarray(picks)
    if given.dtype.kind not in "iu" or given.shape != (faces,):
        raise Error(f"picks: expected {faces} whole numbers, one for each face")
    return given


# ---- Surfaces ----------------------------------------------------------------------------


def points_of_grid(x: typing.Any, y: typing.Any, z: typing.Any) -> tuple[Floats, Floats]:
    """The heights (m, n), and the points (m * n, 3), unknown heights as nan."""
    import numpy as np

    xs, ys, zs = (_colours.numbers(v, name) for v, name in ((x, "x"), (y, "y"), (z, "z")))
    if zs.ndim != 2 or min(zs.shape) < 2:
        raise Error(f"z: shape {zs.shape}, expected 2 points or more each way")
    if xs.ndim == 1 and ys.ndim == 1:
        xs, ys = np.meshgrid(xs, ys)
    if xs.shape != zs.shape or ys.shape != zs.shape:
        raise Error(f"x and y: expected the shape of z, {zs.shape}, or its columns and rows")
    return zs, np.stack([xs, ys, zs], axis=-1).reshape(-1, 3)


def contours_of(
    triangles: Floats, values: Floats, contours: typing.Any, limits: typing.Any
) -> Floats | None:
    """Lines (L, 2, 3) at these levels, or so many between the lowest and the highest."""
    import numpy as np

    from ._bands import contours as cut

    if contours is None:
        return None
    known = ~np.isnan(values).any(axis=1)
    low, high = _colours.limits_of(values, limits)
    if isinstance(contours, (int, np.integer)) and not isinstance(contours, bool):
        if not 1 <= contours <= 1000:
            raise Error(f"contours: {contours}: expected 1 to 1000, or their levels")
        levels = np.linspace(low, high, int(contours) + 2)[1:-1]
    else:
        levels = _colours.numbers(contours, "contours").ravel()
        if not np.isfinite(levels).all():
            raise Error("contours: expected finite levels")
    lines = cut(triangles[known], values[known], levels)
    if not len(lines):
        warnings.warn("contours: no level is between the values", stacklevel=3)
    return lines


def planes_of(crop: typing.Any) -> Floats:
    """The cutting planes of a box, (K, 4): a x + b y + c z + d < 0 is cut away."""
    import numpy as np

    planes: list[list[float]] = []
    if crop is None:
        return np.zeros((0, 4))
    try:
        ranges = list(crop)
    except TypeError:
        ranges = []
    if len(ranges) != 3:
        raise Error("crop: expected ranges of x, y and z, each two numbers or None")
    for axis, limits in enumerate(ranges):
        if limits is None:
            continue
        try:
            low, high = (None if end is None else float(end) for end in limits)
        except (TypeError, ValueError):
            raise Error("crop: expected ranges of x, y and z, each two numbers or None") from None
        if not all(end is None or np.isfinite(end) for end in (low, high)) or (
            low is not None and high is not None and not low < high
        ):
            raise Error(f"crop: {low} to {high}: expected finite numbers that rise")
        for end, sign in ((low, 1.0), (high, -1.0)):
            if end is not None:
                plane = [0.0, 0.0, 0.0, -sign * end]
                plane[axis] = sign
                planes.append(plane)
    return np.array(planes).reshape(-1, 4)


def triangles_of_grid(z: Floats) -> tuple[Indices, Indices]:
    """The corners of two triangles a cell, (T, 3), as surface_3 has them, and their cells; without
    those of cells with an unknown height."""
    import numpy as np

    rows, columns = z.shape
    k = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    known = ~np.isnan(z)
    cell = known[:-1, :-1] & known[:-1, 1:] & known[1:, 1:] & known[1:, :-1]
    numbers = np.flatnonzero(cell.ravel())
    two = np.stack([a, b, c, a, c, d], axis=-1)[numbers].reshape(-1, 3)
    return two, np.repeat(np.arange(len(numbers)), 2)


# ---- Beside the picture ------------------------------------------------------------------


class Beside(typing.NamedTuple):
    """What stands in a column at the picture's right: lengths are parts of the picture's height."""

    width: float
    rectangles: list[tuple[float, float, float, float]]
    """Left, right, bottom and top of each."""
    fills: list[tuple[float, float, float]]
    lines: list[tuple[float, float, float, float]]
    """From x, y to x, y."""
    texts: list[tuple[float, float, float, str]]
    """x, y, size of the letters, and the characters."""


def _frame(left: float, right: float, low: float, high: float) -> list[tuple[float, ...]]:
    corners = [(left, low), (right, low), (right, high), (left, high), (left, low)]
    return [(*a, *b) for a, b in zip(corners, corners[1:])]


def colour_bar(scale: _colours.Scale, label: str, ticks: typing.Any) -> Beside:
    low, high = scale.limits
    left, right = _EDGE, _EDGE + _BAR_WIDTH
    numbers = _ticks_of(scale, ticks)

    def at(value: float) -> float:
        return _LOW + (value - low) / (high - low) * (_HIGH - _LOW)

    bounds = [at(bound) for bound in scale.bounds.tolist()]
    lines = _frame(left, right, _LOW, _HIGH)
    lines += [(right, at(value), right + _TICK, at(value)) for value, _ in numbers]
    texts = [
        (right + _BEFORE_NUMBER, at(value) - 0.35 * _LETTER, _LETTER, text)
        for value, text in numbers
    ]
    if label:
        texts.append((left, _HIGH + _LETTER, _LETTER, label))
    return Beside(
        _width(texts),
        [(left, right, a, b) for a, b in zip(bounds, bounds[1:])],
        typing.cast("typing.Any", scale.colours.tolist()),
        typing.cast("list[tuple[float, float, float, float]]", lines),
        texts,
    )


def _ticks_of(scale: _colours.Scale, ticks: typing.Any) -> list[tuple[float, str]]:
    low, high = scale.limits
    if ticks is None:
        return _displayfile._ticks(low, high)
    values = _colours.numbers(ticks, "ticks")
    if values.ndim != 1 or not ((values >= low) & (values <= high)).all():
        raise Error(f"ticks: expected numbers from {low:g} to {high:g}")
    return [(value, _displayfile._number(value)) for value in values.tolist()]


def legend(entries: typing.Any) -> Beside:
    try:
        pairs = [(str(name), _colours.colour(value, "legend")) for name, value in entries.items()]
    except AttributeError:
        raise Error("legend: expected a dictionary of names and their colours") from None
    if not pairs:
        raise Error("legend: expected at least one name")
    top = 0.5 + 0.5 * _ROW * len(pairs)
    beside = Beside(0.0, [], [], [], [])
    for k, (name, fill) in enumerate(pairs):
        low = top - (k + 1) * _ROW + 0.5 * (_ROW - _SWATCH)
        box = (_EDGE, _EDGE + _SWATCH, low, low + _SWATCH)
        beside.rectangles.append(box)
        beside.fills.append(fill)
        beside.lines.extend(typing.cast("typing.Any", _frame(*box)))
        x = _EDGE + _SWATCH + _BEFORE_NUMBER
        beside.texts.append((x, low + 0.5 * _SWATCH - 0.35 * _LETTER, _LETTER, name))
    return beside._replace(width=_width(beside.texts))


def _width(texts: list[tuple[float, float, float, str]]) -> float:
    return max(x + _LETTER_WIDTH * len(text) for x, _, _, text in texts) + _EDGE
