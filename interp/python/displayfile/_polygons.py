"""Polygons in, pieces out: for programs that draw by themselves."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Numbers, _Polygons


class PolygonPieces(typing.NamedTuple):
    """Polygons or pieces of them from back to front, as sort returns them: K of N points in all."""

    points: npt.NDArray[np.float64]
    """(N, 3): corners of the polygons are the very numbers that were given."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): piece k has the points from first[k] to first[k + 1]."""
    item: npt.NDArray[np.int32]
    """(K,): which of the polygons each piece is of; segments are counted after them."""
    sides: npt.NDArray[np.uint8]
    """(N,): not 0 if the side that ends at the point is one of the polygon's own."""
    cuts: npt.NDArray[np.bool_]
    """(N,): True if a segment, or a side of the polygon's own, is cut there, of which the rest is in
    another piece."""


class VisiblePieces(typing.NamedTuple):
    """What is seen of polygons, as visible_pieces returns it: K pieces of N points in all."""

    points: npt.NDArray[np.float64]
    """(N, 3): corners of the polygons are the very numbers that were given."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): piece k has the points from first[k] to first[k + 1]."""
    item: npt.NDArray[np.int32]
    """(K,): which of the polygons each piece is of."""


class VisibleLines(typing.NamedTuple):
    """Where lines are seen, as visible_lines returns it."""

    points: npt.NDArray[np.float64]
    """(K, 2, 3): the two ends of each."""
    item: npt.NDArray[np.int32]
    """(K,): which of the polygons each is a side of, or one of two that intersect there; or which of
    the segments."""
    kinds: npt.NDArray[np.uint8]
    """(K,): sums of 2 outline, 4 boundary, 8 crease, 16 material, 32 intersection and 64 all,
    if kinds of lines were asked for; else 1."""
    hidden: npt.NDArray[np.bool_]
    """(K,): True where the line is hidden, if hidden lines were asked for."""
    cuts: npt.NDArray[np.bool_]
    """(K, 2): True for each end at which the line goes on, hidden; or seen, where it is hidden. A
    thick line has no cap there."""


def sort(
    polygons: _Polygons,
    *,
    sides: _Numbers | None = None,
    segments: _Numbers | None = None,
    whole: bool = False,
    method: str = "depth-sort",
    threads: int = 1,
    touching: float | str = "auto",
) -> PolygonPieces:
    """Put polygons in order from back to front, cut where there is no order otherwise.

    They are seen along z: x to the right, y up, a larger z nearer to the viewer, in any range. The
    order is exact.

    Args:
        polygons: An array (M, k, 3), or a sequence of arrays (k, 3), of 3 or more corners each. With
            sides, all corners, (N, 3), one polygon after another.
        sides: An array (M,): how many corners each polygon has.
        segments: An array (L, 2, 3) of lines that are sorted too. Their pieces have two points, and
            item is M for the first of them.
        whole: Let the pieces of a polygon follow one another, or be one piece again, where nothing
            that overlaps them comes between: where the order of others asked for a cut, and where a
            polygon that is not flat was sorted as triangles.
        method: "depth-sort", "bsp", which cuts more, or "plain-bsp", the textbook's form of it.
        threads: How many may work, 1 to 1024.
        touching: Within which distance polygons touch, as set_touching of System: what touches a
            plane lies in it, and of polygons in one plane the later one is nearer. "auto" is by the
            precision of the numbers, "off" is what coincides exactly. A length in the coordinates
            given counts as no less than what moving them into the unit cube rounds: 2e-15 of it.

    Returns:
        The pieces, in order.

    Raises:
        Error: Another shape or type, a polygon of fewer than 3 corners, a number that is not finite.
    """
    if method == "map":
        raise _displayfile.Error("method 'map': expected depth-sort, bsp or plain-bsp, or visible_pieces")
    points, first, item, own, _, cuts = _displayfile._pieces_of(
        polygons, sides, method, threads, segments, whole, touching
    )
    return PolygonPieces(points, first, item, own, cuts.view(bool))


def visible_pieces(
    polygons: _Polygons,
    *,
    sides: _Numbers | None = None,
    threads: int = 1,
    touching: float | str = "auto",
) -> VisiblePieces:
    """Find the pieces of polygons that are seen. They do not overlap in the picture.

    Args:
        polygons: As in sort.
        sides: As in sort.
        threads: As in sort.
        touching: As in sort.

    Returns:
        The pieces, each without holes.

    Raises:
        Error: As in sort.
    """
    points, first, item, *_ = _displayfile._pieces_of(
        polygons, sides, "map", threads, None, False, touching
    )
    return VisiblePieces(points, first, item)


def visible_lines(
    polygons: _Polygons,
    *,
    sides: _Numbers | None = None,
    segments: _Numbers | None = None,
    lines: str | None = None,
    hidden: bool = False,
    method: str = "franklin",
    threads: int = 1,
    touching: float | str = "auto",
) -> VisibleLines:
    """Find where the sides of polygons are seen, or where lines among polygons are.

    Args:
        polygons: As in sort.
        sides: As in sort.
        segments: An array (L, 2, 3) of lines, which are looked at in place of the polygons' sides.
        lines: Kinds of sides, as System has them, such as "outline,crease"; all if none is said.
        hidden: Return the parts that are hidden, too.
        method: "franklin", "appel", "roberts" or "plain-appel", the textbook's form, which find the
            same.
        threads: As in sort.
        touching: As in sort: a line whose ends touch a plane lies in it, and is seen there.

    Returns:
        The parts that are seen.

    Raises:
        Error: As in sort; or kinds that are unknown.
    """
    points, _, item, kinds, is_hidden, cuts = _displayfile._lines_of(
        polygons, sides, method, lines, hidden, threads, segments, touching
    )
    ends = cuts.view(bool).reshape(-1, 2)
    return VisibleLines(points.reshape(-1, 2, 3), item, kinds[1::2], is_hidden.view(bool), ends)
