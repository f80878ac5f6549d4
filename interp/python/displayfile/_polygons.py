"""Visibility of polygons passed as arrays, for programs that draw by their own means."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Numbers, _Polygons


class PolygonPieces(typing.NamedTuple):
    """Polygons or their pieces from back to front, as sort returns them: K with N points in
    total."""

    points: npt.NDArray[np.float64]
    """(N, 3): corners of the polygons are the very numbers that were given."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): piece k has the points from first[k] to first[k + 1]."""
    item: npt.NDArray[np.int32]
    """(K,): the index of each piece's polygon; segments are numbered after the polygons."""
    sides: npt.NDArray[np.uint8]
    """(N,): not 0 if the side that ends at the point is a side of the polygon."""
    cuts: npt.NDArray[np.bool_]
    """(N,): True if a segment, or a side of the polygon, is cut there and continues in another
    piece."""


class VisiblePieces(typing.NamedTuple):
    """The visible pieces of polygons, as visible_pieces returns them: K with N points in total."""

    points: npt.NDArray[np.float64]
    """(N, 3): corners of the polygons are the very numbers that were given."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): piece k has the points from first[k] to first[k + 1]."""
    item: npt.NDArray[np.int32]
    """(K,): the index of each piece's polygon."""


class VisibleLines(typing.NamedTuple):
    """The visible parts of lines, as visible_lines returns them."""

    points: npt.NDArray[np.float64]
    """(K, 2, 3): the two ends of each part."""
    item: npt.NDArray[np.int32]
    """(K,): the index of the polygon that each part is a side of, or of one of two that intersect
    there; or of its segment."""
    kinds: npt.NDArray[np.uint8]
    """(K,): sums of 2 outline, 4 boundary, 8 crease, 16 material, 32 intersection and 64 all if
    lines is set; otherwise 1."""
    hidden: npt.NDArray[np.bool_]
    """(K,): True for hidden parts, which hidden=True returns."""
    cuts: npt.NDArray[np.bool_]
    """(K, 2): True for each end at which the line continues: hidden, or visible if the part is
    hidden. A thick line has no cap there."""


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
    """Sort polygons from back to front, cutting them where no order exists otherwise.

    They are viewed along z: x to the right, y up, a larger z nearer to the viewer, in any range.
    The order is exact.

    Parameters
    ----------
    polygons : array_like
        An array (M, k, 3), or a sequence of arrays (k, 3), of 3 or more corners each. With sides:
        all corners, (N, 3), polygon after polygon.
    sides : array_like, optional
        An array (M,): the number of corners of each polygon.
    segments : array_like, optional
        An array (L, 2, 3) of lines to sort too. Their pieces have two points, and item is M for the
        first of them.
    whole : bool, optional
        Make pieces of a polygon adjacent, or rejoin them, where nothing that overlaps them comes
        between: where the order of other polygons required a cut, and where a polygon that is not
        planar was sorted as triangles.
    method : str, optional
        "depth-sort", "bsp", which cuts more, or "plain-bsp", the textbook's form of it.
    threads : int, optional
        Maximum number of threads, 1 to 1024.
    touching : float or str, optional
        Distance within which polygons touch, as in System.set_touching: a polygon that touches a
        plane is taken to lie in it, and of coplanar polygons the later one is nearer. "auto": from
        the precision of the numbers; "off": only what coincides exactly touches. A length is in the
        coordinates of the polygons, and at least the rounding of moving them into the unit cube:
        2e-15 of it.

    Returns
    -------
    PolygonPieces
        The pieces, in order.

    Raises
    ------
    Error
        A wrong shape or type, a polygon of fewer than 3 corners, a number that is not finite.
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
    """Find the visible pieces of polygons. They do not overlap in the picture.

    Parameters
    ----------
    polygons : array_like
        As in sort.
    sides : array_like, optional
        As in sort.
    threads : int, optional
        As in sort.
    touching : float or str, optional
        As in sort.

    Returns
    -------
    VisiblePieces
        The pieces, each without holes.

    Raises
    ------
    Error
        As in sort.
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
    """Find the visible parts of polygons' sides, or of lines among polygons.

    Parameters
    ----------
    polygons : array_like
        As in sort.
    sides : array_like, optional
        As in sort.
    segments : array_like, optional
        An array (L, 2, 3) of lines to use instead of the polygons' sides.
    lines : str, optional
        Kinds of sides, as in System, such as "outline,crease"; default: all.
    hidden : bool, optional
        Also return hidden parts.
    method : str, optional
        "franklin", "appel", "roberts" or "plain-appel", the textbook's form, which give the same
        result.
    threads : int, optional
        As in sort.
    touching : float or str, optional
        As in sort: a line whose ends touch a plane is taken to lie in it and is visible there.

    Returns
    -------
    VisibleLines
        The visible parts.

    Raises
    ------
    Error
        As in sort; or kinds that are unknown.
    """
    points, _, item, kinds, is_hidden, cuts = _displayfile._lines_of(
        polygons, sides, method, lines, hidden, threads, segments, touching
    )
    ends = cuts.view(bool).reshape(-1, 2)
    return VisibleLines(points.reshape(-1, 2, 3), item, kinds[1::2], is_hidden.view(bool), ends)
