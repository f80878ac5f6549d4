"""Ends of lines: where something hides the rest of a line, no cap reaches over it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt
    from mpl_toolkits.mplot3d import Axes3D

    from ._matplotlib_artists import Lines

    Floats = npt.NDArray[np.float64]
    Bools = npt.NDArray[np.bool_]
    Indices = npt.NDArray[np.int64]


def with_cut_corners(lines: Lines, item: Indices, cuts: Bools) -> Bools:
    """The cuts of parts of segments, in the order of the segments and along them; an end of a segment
    at which its polyline goes on is one, too, if the next segment is not seen there."""
    if len(lines.segments) < 2 or not len(item):
        return cuts
    continues = np.zeros(len(lines.segments) + 1, bool)
    continues[1:-1] = (lines.line[1:] == lines.line[:-1]) & (
        lines.segments[1:, 0] == lines.segments[:-1, 1]
    ).all(axis=1)
    meets = np.zeros(len(item) + 1, bool)
    meets[1:-1] = (item[1:] == item[:-1] + 1) & ~cuts[1:, 0] & ~cuts[:-1, 1]
    hidden_before = continues[item] & ~meets[:-1]
    hidden_after = continues[item + 1] & ~meets[1:]
    return np.asarray(cuts | np.column_stack([hidden_before, hidden_after]))


def ended(
    ax: Axes3D, points: Floats, cuts: Bools, width: float, cap: Any, is_plain: bool
) -> list[tuple[Floats, bool]]:
    """A polyline, and its ends that are cut, as polylines to be drawn, each with the style's caps or,
    if True, butt ones.

    It is shorter by half a width where it is cut, so that the cap ends at the cut, as a projecting one
    does exactly. A gap that a round cap leaves is drawn once more with a butt cap, if the line is plain:
    neither dashed nor translucent.
    """
    if not cuts.any() or cap in (None, "butt"):  # None is drawn as butt
        return [(points, False)]
    there = ax.transData
    xy = there.transform(points)
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(xy, axis=0).T))])
    half, length = 0.5 * width * ax.figure.dpi / 72.0, at[-1]
    begin, end = half * cuts[0], length - half * cuts[1]
    if begin >= end:
        return [(points, True)]
    stretches = [(begin, end, False)]
    if cap == "round" and is_plain:
        stretches += [(0.0, begin, True)] * bool(cuts[0]) + [(end, length, True)] * bool(cuts[1])
    back = there.inverted()
    return [(back.transform(_stretch(xy, at, a, b)), butt) for a, b, butt in stretches]


def _stretch(points: Floats, at: Floats, begin: float, end: float) -> Floats:
    """A polyline from one of its lengths to another; `at` are those of its points."""
    ends = [[np.interp(t, at, column) for column in points.T] for t in (begin, end)]
    inside = points[(at > begin) & (at < end)]
    return np.concatenate([ends[:1], inside, ends[1:]])
