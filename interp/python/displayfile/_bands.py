"""Triangles cut where a scalar on them, linear over each, passes a bound."""

from __future__ import annotations

import typing

import numpy as np

if typing.TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]


class Bands(typing.NamedTuple):
    """Polygons that tile the triangles, each between two neighbouring bounds."""

    points: Floats
    """(N, D)"""
    sides: Indices
    """(K,): the number of corners of each."""
    triangle: Indices
    """(K,): the triangle that it is a part of."""
    band: Indices
    """(K,): k from bounds[k] to bounds[k + 1]; the first and the last have what lies beyond, too."""


def bands(points: Floats, values: Floats, bounds: Floats) -> Bands:
    """Cut triangles, (T, 3, D), with values at their corners, (T, 3), at the inner bounds.

    A point is three coordinates, and more numbers that are linear over each triangle.

    A point on a side of two triangles is the same number for both: it is found from the side's end
    of the lower value, and an end that lies on a bound is the point.
    """
    order = np.argsort(values, axis=1, kind="stable")
    t = np.take_along_axis(values, order, axis=1)
    p = np.take_along_axis(points, order[:, :, None], axis=1)
    turned = np.isin(order @ np.array([9, 3, 1]), [0 * 9 + 2 * 3 + 1, 1 * 9 + 2, 2 * 9 + 1 * 3])
    last = len(bounds) - 2
    first_band = (np.searchsorted(bounds, t[:, 0], side="right") - 1).clip(0, last)
    last_band = (np.searchsorted(bounds, t[:, 2], side="left") - 1).clip(first_band, last)
    count = last_band - first_band + 1
    triangle = np.repeat(np.arange(len(t)), count)
    within = np.arange(len(triangle)) - np.repeat(np.cumsum(count) - count, count)
    band = first_band[triangle] + within
    t, p, turned = t[triangle], p[triangle], turned[triangle]
    is_first, is_last = within == 0, within == count[triangle] - 1
    low, high = bounds[band], bounds[band + 1]
    middle = t[:, 1]
    corners = np.stack(
        [
            np.where(is_first[:, None], p[:, 0], _crossing(p, t, 0, 2, low)),
            np.where(is_first[:, None], p[:, 0], _on_short_way(p, t, low)),
            p[:, 1],
            np.where(is_last[:, None], p[:, 2], _on_short_way(p, t, high)),
            np.where(is_last[:, None], p[:, 2], _crossing(p, t, 0, 2, high)),
        ],
        axis=1,
    )
    is_corner = np.ones((len(triangle), 5), bool)
    is_corner[:, 2] = (is_first | (middle > low)) & (is_last | (middle < high))
    corners[turned] = corners[turned][:, ::-1]
    is_corner[turned] = is_corner[turned][:, ::-1]
    return _without_repeats(corners, is_corner, triangle, band)


def _crossing(p: Floats, t: Floats, a: int, b: int, level: Floats) -> Floats:
    """Where the side from corner a to b is at the level."""
    rise = t[:, b] - t[:, a]
    part = (level - t[:, a]) / np.where(rise > 0.0, rise, 1.0)
    at = p[:, a] + part[:, None] * (p[:, b] - p[:, a])
    at = np.where((level == t[:, b])[:, None], p[:, b], at)
    return np.where((level == t[:, a])[:, None], p[:, a], at)


def _on_short_way(p: Floats, t: Floats, level: Floats) -> Floats:
    """The same on the two sides over the middle corner."""
    is_low = level < t[:, 1]
    return np.where(is_low[:, None], _crossing(p, t, 0, 1, level), _crossing(p, t, 1, 2, level))


def _without_repeats(corners: Floats, is_corner: npt.NDArray[np.bool_], triangle: Indices, band: Indices) -> Bands:
    """Without corners that are like the one before; and without polygons that have no area left."""
    before = np.roll(corners, 1, axis=1)
    for k in range(5):  # the one before may be left out itself
        previous = corners[:, k - 1]
        missing = ~is_corner[:, k - 1]
        previous = np.where(missing[:, None], corners[:, k - 2], previous)
        before[:, k] = previous
    is_corner &= (corners != before)[..., :3].any(axis=2)
    sides = is_corner.sum(axis=1)
    kept = sides >= 3
    return Bands(
        corners[kept][is_corner[kept]], sides[kept], triangle[kept], band[kept].astype(np.int64)
    )


def contours(points: Floats, values: Floats, levels: Floats) -> Floats:
    """The lines on triangles where the value is at a level, (L, 2, 3).

    A corner at a level counts as above it.
    """
    lines = [np.zeros((0, 2, 3))]
    order = np.argsort(values, axis=1, kind="stable")
    t = np.take_along_axis(values, order, axis=1)
    p = np.take_along_axis(points, order[:, :, None], axis=1)
    for level in levels:
        crossed = (t[:, 0] < level) & (t[:, 2] >= level)
        at = np.full(int(crossed.sum()), level)
        long, short = _crossing(p[crossed], t[crossed], 0, 2, at), _on_short_way(
            p[crossed], t[crossed], at
        )
        ends = np.stack([long, short], axis=1)
        lines.append(ends[(long != short).any(axis=1)])
    return np.concatenate(lines)
