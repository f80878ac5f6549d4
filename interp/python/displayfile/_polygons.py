"""Polygons in, pieces out: for programs that draw by themselves."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Numbers, _Polygons


class PolygonPieces(typing.NamedTuple):
    """Pieces of polygons. Piece k has the points from first[k] to first[k + 1]."""

    points: npt.NDArray[np.float64]
    """(N, 3): corners of the polygons are the very numbers that were given."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): where each piece begins in points."""
    item: npt.NDArray[np.int32]
    """(K,): the polygon that each piece is of."""
    sides: npt.NDArray[np.uint8]
    """(N,): not 0 if the side that ends at the point is one of the polygon's own."""


class VisiblePieces(typing.NamedTuple):
    """Pieces of polygons that are seen. Piece k has the points from first[k] to first[k + 1]."""

    points: npt.NDArray[np.float64]
    first: npt.NDArray[np.uint32]
    item: npt.NDArray[np.int32]


class VisibleLines(typing.NamedTuple):
    """Line segments that are seen, two points each."""

    points: npt.NDArray[np.float64]
    """(K, 2, 3)."""
    item: npt.NDArray[np.int32]
    """(K,): the polygon that each line is a side of, or one of two that intersect there."""
    kinds: npt.NDArray[np.uint8]
    """(K,): sums of 2 outline, 4 boundary, 8 crease, 16 material, 32 intersection and 64 all,
    if kinds of lines were asked for; else 1."""
    hidden: npt.NDArray[np.bool_]
    """(K,): True where the line is hidden, if hidden lines were asked for."""


def sort(
    polygons: _Polygons,
    *,
    sides: _Numbers | None = None,
    segments: _Numbers | None = None,
    whole: bool = False,
    method: str = "depth-sort",
    threads: int = 1,
) -> PolygonPieces:
    """Put polygons in order from back to front, cut where there is no order otherwise.

    polygons is an array (M, k, 3) or a sequence of arrays (k, 3): x to the right, y up, a larger
    z nearer to the viewer, in any range. With sides, an array (M,) of numbers of corners, it is
    the array (N, 3) of all corners, one polygon after another. method is "depth-sort" or "bsp". The
    order is exact.

    segments is an array (L, 2, 3) of lines that are sorted too: their pieces have two points, and
    item is M for the first of them. With whole the pieces of a polygon follow one another, or are
    one piece again, where nothing that overlaps them comes between: cuts that the order of others
    asked for, and those of polygons that are not flat, which are sorted as triangles.
    """
    if method == "map":
        raise _displayfile.Error("method 'map': expected depth-sort or bsp, or visible_pieces")
    points, first, item, own, _ = _displayfile._pieces_of(
        polygons, sides, method, threads, segments, whole
    )
    return PolygonPieces(points, first, item, own)


def visible_pieces(
    polygons: _Polygons, *, sides: _Numbers | None = None, threads: int = 1
) -> VisiblePieces:
    """Find the pieces of polygons that are seen. They do not overlap in the picture.

    polygons is as for sort.
    """
    points, first, item, _, _ = _displayfile._pieces_of(
        polygons, sides, "map", threads, None, False
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
) -> VisibleLines:
    """Find where the sides of polygons are seen, or segments.

    polygons is as for sort. segments is an array (L, 2, 3) of lines, which are looked at in place
    of sides; item is then the segment. lines selects kinds of sides, such as "outline,crease":
    those of the option --lines. With hidden the parts that are hidden are returned too. method is
    "franklin", "appel" or "roberts", which find the same.
    """
    points, _, item, kinds, is_hidden = _displayfile._lines_of(
        polygons, sides, method, lines, hidden, threads, segments
    )
    return VisibleLines(points.reshape(-1, 2, 3), item, kinds[1::2], is_hidden.view(bool))
