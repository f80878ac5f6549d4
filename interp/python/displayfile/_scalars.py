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
_LETTER_WIDTH, _LINE = 0.6, 1.4  # of letters, relative to their size
_BAR_WIDTH, _TICK, _BEFORE_NUMBER = 0.025, 0.008, 0.014
_LOW, _HIGH = 0.25, 0.75
_SWATCH, _ROW = 0.024, 0.045
_EDGE = 0.02
_MOST_WIDTH = 0.4  # of a column, in pictures that are not narrower than high
_MOST_TICKS = 13


# ---- On faces and at vertices ------------------------------------------------------------


def place_of(values: Floats, at: str | None, faces: int, vertices: int) -> str:
    """Whether there is a value for each face, or for each vertex."""
    if values.ndim != 1:
        raise Error(f"values: expected an array of shape (N,), not {values.shape}")
    fitting = [
        place for place, n in (("faces", faces), ("vertices", vertices)) if len(values) == n
    ]
    if at is not None:
        _require_place(at)
        if at not in fitting:
            raise Error(f"values: {len(values)} of them for {faces} faces, {vertices} vertices")
        return at
    if len(fitting) == 2:
        raise Error(f"values: {faces} faces and as many vertices: expected at='faces' or 'vertices'")
    if not fitting:
        raise Error(f"values: {len(values)} of them for {faces} faces and {vertices} vertices")
    return fitting[0]


def _require_place(at: typing.Any) -> None:
    if not _colours.is_a(at, str):
        raise Error(f"at: expected faces or vertices, not {type(at).__name__}")
    if at not in ("faces", "vertices"):
        raise Error(f"at '{at}': expected faces or vertices")


def is_of_vertices(fills: Floats, at: str | None, vertices: typing.Any) -> bool:
    """Whether there is a colour for each vertex, and not for each face."""
    if at is None:
        return False
    _require_place(at)
    if at == "faces":
        return False
    count = len(_colours.numbers(vertices, "vertices"))
    if len(fills) != count:
        raise Error(f"fills: {len(fills)} of them for {count} vertices")
    return True


class Pieces(typing.NamedTuple):
    """What is entered of a mesh in colours of values at its vertices."""

    points: Floats
    sides: Indices
    fills: Floats
    face: Indices
    """The face that each is a part of."""
    normals: Floats | None
    """Of the points, with smooth shading."""


def pieces_of(
    triangles: Floats,
    face: Indices,
    values: Floats,
    scale: _colours.Scale,
    normals: Floats | None = None,
) -> Pieces:
    """Triangles (T, 3, 3) with values (T, 3), and normals (T, 3, 3) if there are some, cut where the
    colour changes."""
    import numpy as np

    from ._bands import bands

    if normals is not None:  # which are linear over a triangle as its points are
        triangles = np.concatenate([triangles, normals], axis=2)
    known = ~np.isnan(values).any(axis=1)
    cut = bands(triangles[known], values[known], scale.bounds)
    unknown = triangles[~known]
    points = np.concatenate([cut.points, unknown.reshape(-1, triangles.shape[2])])
    return Pieces(
        np.ascontiguousarray(points[:, :3]),
        np.concatenate([cut.sides, np.full(len(unknown), 3)]),
        scale.of_steps(np.concatenate([cut.band, np.full(len(unknown), -1)])),
        np.concatenate([face[known][cut.triangle], face[~known]]),
        None if normals is None else np.ascontiguousarray(points[:, 3:]),
    )


def normals_of(normals: typing.Any, vertices: int) -> Floats:
    """As an array (N, 3), one for each vertex."""
    import numpy as np

    array = _colours.numbers(normals, "normals")
    if array.shape != (vertices, 3):
        raise Error(f"normals: shape {array.shape}, expected ({vertices}, 3), one for each vertex")
    if not np.isfinite(array).all():
        raise Error("normals: expected finite numbers")
    return array


def runs_of(points: typing.Any, closed: bool) -> tuple[Floats, Indices]:
    """The points of a polyline without those that are unknown, and how many are in each run."""
    import numpy as np

    array = _colours.numbers(points, "points")
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"points: expected an array of shape (N, 3), not {array.shape}")
    if not _colours.is_a(closed, (bool, np.bool_)):
        raise Error(f"closed: expected True or False, not {type(closed).__name__}")
    count = len(array)
    known = ~np.isnan(array).any(axis=1)
    if closed and count:
        array, known = np.append(array, array[:1], axis=0), np.append(known, known[:1])
    ends = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(np.int8)))
    first, end = ends[::2], ends[1::2]
    long = end - first >= 2
    if not long.any():
        raise Error(f"points: {count} of them: expected 2 or more without a gap")
    kept = [array[a:b] for a, b in zip(first[long], end[long])]
    return np.concatenate(kept), (end - first)[long]


def picks_of(picks: typing.Any, faces: int) -> typing.Any:
    """One for each face: as set, or its index."""
    import numpy as np

    if picks is None:
        return np.arange(faces)
    try:
        given = np.asarray(picks)
    except _colours.UNREADABLE:
        raise Error(f"picks: expected whole numbers, not {type(picks).__name__}") from None
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


def without_nan(points: Floats) -> Floats:
    """With 0 for unknown coordinates, of points in no triangle."""
    import numpy as np

    return np.where(np.isnan(points), 0.0, points)


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
    if _colours.is_a(contours, (int, np.integer)) and not _colours.is_a(contours, bool):
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
    except _colours.UNREADABLE:
        ranges = []
    if len(ranges) != 3:
        raise Error("crop: expected ranges of x, y and z, each two numbers or None")
    for axis, limits in enumerate(ranges):
        if limits is None:
            continue
        try:
            low, high = (None if end is None else float(end) for end in limits)
        except _colours.UNREADABLE:
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


def colour_bar(scale: _colours.Scale, label: str, ticks: typing.Any, letters: typing.Any) -> Beside:
    if not _colours.is_a(label, str):
        raise Error(f"label: expected a text, not {type(label).__name__}")
    low, high = scale.limits
    left, right = _EDGE, _EDGE + _BAR_WIDTH
    size = _size_of(letters)

    def at(value: float) -> float:
        return _LOW + (value - low) / (high - low) * (_HIGH - _LOW)

    numbers = [(at(value), text) for value, text in _ticks_of(scale, ticks, size)]
    bounds = [at(bound) for bound in scale.bounds.tolist()]
    lines = _frame(left, right, _LOW, _HIGH)
    lines += [(right, y, right + _TICK, y) for y, _ in numbers]
    texts = [(right + _BEFORE_NUMBER, y - 0.35 * size, size, text) for y, text in numbers]
    rows = _in_rows(label, size)
    above = _HIGH + size
    texts += [
        (left, above + _LINE * size * k, size, row) for k, row in enumerate(reversed(rows))
    ]
    if above + _LINE * size * len(rows) > 1.0:
        raise Error(f"colour_bar: the label has {len(rows)} rows: expected a shorter one")
    return Beside(
        _width(texts, "colour_bar"),
        [(left, right, a, b) for a, b in zip(bounds, bounds[1:])],
        typing.cast("typing.Any", scale.colours.tolist()),
        typing.cast("list[tuple[float, float, float, float]]", lines),
        texts,
    )


def _size_of(letters: typing.Any) -> float:
    if letters is None:
        return _LETTER
    size = _colours.numbers(letters, "letters")
    if size.ndim != 0 or not 0.001 <= size <= 0.1:
        raise Error(
            f"letters: {letters!r}: expected their size as a part of the picture's height, 0.001 to "
            "0.1, such as 9 / 288 for 9 points where the picture is 288 points high"
        )
    return float(size)


def _in_rows(label: str, size: float) -> list[str]:
    """The label in rows that the widest column has room for; words are not broken."""
    import textwrap

    most = int((_MOST_WIDTH - 2.0 * _EDGE) / (_LETTER_WIDTH * size))
    return textwrap.wrap(label, max(1, most), break_long_words=False, break_on_hyphens=False)


def _ticks_of(scale: _colours.Scale, ticks: typing.Any, size: float) -> list[tuple[float, str]]:
    low, high = scale.limits
    if ticks is None:
        if scale.is_banded:
            return _ticks_at_bounds(scale.bounds, size)
        return _displayfile._ticks(low, high)
    values = _colours.numbers(ticks, "ticks")
    if values.ndim != 1 or not ((values >= low) & (values <= high)).all():
        raise Error(f"ticks: expected numbers from {low:g} to {high:g}")
    return [(value, _displayfile._number(value)) for value in values.tolist()]


def _ticks_at_bounds(bounds: Floats, size: float) -> list[tuple[float, str]]:
    """Ticks at the bounds of bands, at every second or third of many; and no number where it would
    touch the one below."""
    import numpy as np

    every = -(-(len(bounds) - 1) // (_MOST_TICKS - 1))
    kept = bounds[::every]
    apart = (kept - kept[0]) / (bounds[-1] - bounds[0]) * (_HIGH - _LOW)
    least_step = float(np.diff(kept).min()) if len(kept) > 1 else float(bounds[-1] - bounds[0])
    ticks: list[tuple[float, str]] = []
    last = -np.inf
    for value, place in zip(kept.tolist(), apart.tolist()):
        has_room = place - last >= _LINE * size
        ticks.append((value, _rounded(value, least_step) if has_room else ""))
        last = place if has_room else last
    return ticks


def _rounded(value: float, step: float) -> str:
    """The number to a hundredth of a step, and no more digits than it has."""
    import math

    decimals = 2 - math.floor(math.log10(step))
    return _displayfile._number(float(round(value, decimals)))


def legend(entries: typing.Any, letters: typing.Any) -> Beside:
    size = _size_of(letters)
    row = max(_ROW, _LINE * size)
    try:
        pairs = [(str(name), _colours.colour(value, "legend")) for name, value in entries.items()]
    except (AttributeError, ReferenceError):
        raise Error("legend: expected a dictionary of names and their colours") from None
    if not pairs:
        raise Error("legend: expected at least one name")
    top = 0.5 + 0.5 * row * len(pairs)
    beside = Beside(0.0, [], [], [], [])
    for k, (name, fill) in enumerate(pairs):
        low = top - (k + 1) * row + 0.5 * (row - _SWATCH)
        box = (_EDGE, _EDGE + _SWATCH, low, low + _SWATCH)
        beside.rectangles.append(box)
        beside.fills.append(fill)
        beside.lines.extend(typing.cast("typing.Any", _frame(*box)))
        x = _EDGE + _SWATCH + _BEFORE_NUMBER
        beside.texts.append((x, low + 0.5 * _SWATCH - 0.35 * size, size, name))
    return beside._replace(width=_width(beside.texts, "legend"))


def _width(texts: list[tuple[float, float, float, str]], what: str) -> float:
    wide = {x + _LETTER_WIDTH * size * len(text): text for x, _, size, text in texts}
    widest = max(wide, default=0.0)
    if widest + _EDGE > _MOST_WIDTH:
        warnings.warn(
            f"{what}: '{wide[widest]}' is wider than its column: expected shorter words, or smaller "
            "letters",
            stacklevel=4,
        )
    return max(widest, _EDGE + _BAR_WIDTH) + _EDGE
