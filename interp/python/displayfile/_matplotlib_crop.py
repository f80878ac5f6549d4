"""What lies within a box, in data coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    Bools = npt.NDArray[np.bool_]
    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]


class Cropped(NamedTuple):
    """Polygons that are left of others."""

    points: Floats
    """(N, 3)"""
    sides: Indices
    """(K,)"""
    of: Indices
    """(K,): the polygon that each is left of."""
    is_cut: Bools
    """(N,): whether the side that ends at the point was made by cropping."""


class Crop:
    """Crops at the limits, (3, 2), of a box."""

    def __init__(self, limits: Floats) -> None:
        self._limits = np.sort(np.asarray(limits, float), axis=1)

    def markers(self, points: Floats) -> Floats:
        """The points, with nan for those outside of the box."""
        outside = (points < self._limits[:, 0]) | (points > self._limits[:, 1])
        return np.where(outside.any(axis=1)[:, None], np.nan, points)

    def segments(self, segments: Floats) -> tuple[Floats, Bools]:
        """What is left of segments, (n, 2, 3), by Liang and Barsky; and of which nothing is."""
        start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
        low, high = np.zeros(len(segments)), np.ones(len(segments))
        is_outside = np.zeros(len(segments), bool)
        first, last = segments[:, 0].copy(), segments[:, 1].copy()
        for axis in range(3):
            for limit, sign in zip(self._limits[axis], (1.0, -1.0)):
                from_plane = sign * (start[:, axis] - limit)
                rise = sign * along[:, axis]
                is_outside |= (from_plane < 0.0) & (from_plane + rise < 0.0)
                crosses = (from_plane < 0.0) != (from_plane + rise < 0.0)
                at = np.where(crosses, -from_plane / np.where(crosses, rise, 1.0), 0.0)
                enters = crosses & (from_plane < 0.0) & (at > low)
                leaves = crosses & (from_plane >= 0.0) & (at < high)
                low, high = np.where(enters, at, low), np.where(leaves, at, high)
                for chosen, end in ((enters, first), (leaves, last)):
                    end[chosen] = start[chosen] + at[chosen, None] * along[chosen]
                    end[chosen, axis] = limit
        return np.stack([first, last], axis=1), is_outside | (low > high)

    def polygons(self, points: Floats, sides: Indices) -> Cropped:
        """What is left of polygons, by Sutherland and Hodgman. Those with a corner that is not
        finite are left as they are."""
        of = np.arange(len(sides))
        is_cut = np.zeros(len(points), bool)
        if not len(sides):
            return Cropped(points, sides, of, is_cut)
        first = np.concatenate([[0], np.cumsum(sides)])[:-1]
        finite = np.isfinite(points).all(axis=1)
        below, above = points < self._limits[:, 0], points > self._limits[:, 1]
        beyond = np.concatenate([below, above], axis=1) & finite[:, None]
        used = sides > 0
        any_beyond, all_beyond = np.zeros((2, len(sides)), bool)
        starts = first[used]
        any_beyond[used] = np.logical_or.reduceat(beyond, starts).any(axis=1)
        all_beyond[used] = np.logical_and.reduceat(beyond, starts).any(axis=1)
        all_finite = np.ones(len(sides), bool)
        all_finite[used] = np.logical_and.reduceat(finite, starts)
        cut = any_beyond & ~all_beyond & all_finite
        whole = ~(any_beyond & all_finite)
        kept_points = [points[np.repeat(whole, sides)]]
        kept_sides, kept_of = [sides[whole]], [of[whole]]
        kept_cuts = [np.zeros(len(kept_points[0]), bool)]
        for k in np.flatnonzero(cut).tolist():
            left, is_new = self._polygon(points[first[k] : first[k] + sides[k]])
            if len(left) >= 3:
                kept_points.append(left)
                kept_cuts.append(is_new)
                kept_sides.append(np.array([len(left)], np.int64))
                kept_of.append(np.array([k], np.int64))
        count, of = np.concatenate(kept_sides), np.concatenate(kept_of)
        return _in_order(
            Cropped(np.concatenate(kept_points), count, of, np.concatenate(kept_cuts))
        )

    def _polygon(self, corners: Floats) -> tuple[Floats, Bools]:
        is_new = np.zeros(len(corners), bool)
        for axis in range(3):
            for limit, sign in zip(self._limits[axis], (1.0, -1.0)):
                height = sign * (corners[:, axis] - limit)
                inside = height >= 0.0
                if inside.all():
                    continue
                made: list[Floats] = []
                new: list[bool] = []
                for k in range(len(corners)):
                    if inside[k] != inside[k - 1]:
                        # From the end within, so that neighbours have the same point.
                        a, b = (k - 1, k) if inside[k - 1] else (k, k - 1)
                        part = height[a] / (height[a] - height[b])
                        at = corners[a] + part * (corners[b] - corners[a])
                        at[axis] = limit
                        made.append(at)
                        new.append(True if inside[k] else bool(is_new[k]))
                    if inside[k]:
                        made.append(corners[k])
                        new.append(bool(is_new[k]))
                if not made:
                    return corners[:0], is_new[:0]
                corners, is_new = np.array(made), np.array(new)
        return corners, is_new


def _in_order(cropped: Cropped) -> Cropped:
    """In the order of the polygons that they are left of."""
    order = np.argsort(cropped.of, kind="stable")
    first = np.concatenate([[0], np.cumsum(cropped.sides)])[:-1]
    sides = cropped.sides[order]
    source = np.repeat(first[order] - np.concatenate([[0], np.cumsum(sides)])[:-1], sides)
    source = source + np.arange(len(cropped.points))
    return Cropped(cropped.points[source], sides, cropped.of[order], cropped.is_cut[source])
