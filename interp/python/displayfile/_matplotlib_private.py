"""All that touches private attributes of matplotlib. They are checked as this is imported."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.patches import Rectangle
from matplotlib.path import Path
from mpl_toolkits.mplot3d import art3d

from ._displayfile import Error

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt


def _require(thing: object, *names: str) -> None:
    for name in names:
        if not hasattr(thing, name):
            raise Error(
                f"matplotlib {matplotlib.__version__}: {type(thing).__name__} has no attribute "
                f"'{name}', which displayfile.matplotlib reads"
            )


def _check() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    polygons = art3d.Poly3DCollection([corners], facecolors="r", edgecolors="k")
    _require(polygons, "_facecolor3d", "_edgecolor3d", "_codes3d", "_closed")
    _require(polygons, "_antialiaseds", "_capstyle", "_joinstyle", "_hatch_color")
    _require(polygons, "_face_is_mapped", "_edge_is_mapped", "_facecolors", "_edgecolors")
    if not hasattr(polygons, "_vec"):  # since 3.10
        _require(polygons, "_faces", "_invalid_vertices")
    else:
        _require(polygons, "_segslices")
    _require(art3d.Line3DCollection([corners]), "_segments3d")
    _require(art3d.Line3D([0], [0], [0]), "_verts3d", "_dash_pattern")
    _require(Path([[0.0, 0.0]]), "_fast_from_codes_and_verts")
    patch = Rectangle((0, 0), 1, 1)
    art3d.patch_2d_to_3d(patch)
    _require(patch, "_segment3d", "_dash_pattern", "_hatch_color")


_check()


def require_axes(axes: Any) -> None:
    _require(axes, "_children")


@contextlib.contextmanager
def children_replaced(axes: Any, children: list[Any]) -> Iterator[None]:
    """While it lasts the axes draw these artists."""
    kept = axes._children
    axes._children = children
    try:
        yield
    finally:
        axes._children = kept


def children(axes: Any) -> list[Any]:
    return list(axes._children)


def is_clipped_to_limits(artist: Any) -> bool:
    """Whether it was made with axlim_clip=True (since 3.10)."""
    return bool(getattr(artist, "_axlim_clip", False))


def _filled(values: Any) -> npt.NDArray[np.float64]:
    """nan where they are masked."""
    masked: Any = np.ma
    return np.asarray(masked.filled(masked.asarray(values, float), np.nan))


def antialiased(collection: Any) -> Any:
    return collection._antialiaseds


def hatch_colour(artist: Any) -> Any:
    return artist._hatch_color


def set_hatch_colour(collection: Any, colour: Any) -> None:
    collection._hatch_color = colour


def cap_and_join(collection: Any) -> tuple[Any, Any]:
    """The styles' names; None where none is set, for which the getters of 3.6 fail."""
    cap, join = collection._capstyle, collection._joinstyle
    return cap and cap.name, join and join.name


def polygons(artist: Any) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """The corners of a Poly3DCollection, (N, 3), and the number of them of each polygon."""
    if hasattr(artist, "_vec"):
        points = np.ascontiguousarray(np.asarray(artist._vec, float)[:3].T)
        slices = artist._segslices
        sides = np.fromiter((s.stop - s.start for s in slices), np.int64, len(slices))
        return points, sides
    faces = np.asarray(artist._faces, float).reshape(len(artist._faces), -1, 3)
    valid = ~np.broadcast_to(artist._invalid_vertices, faces.shape[:2])
    return faces[valid], valid.sum(axis=1)


def paths(
    points: npt.NDArray[np.float64],
    codes: npt.NDArray[Any],
    begins: npt.NDArray[np.int64],
    ends: npt.NDArray[np.int64],
) -> list[Path]:
    """A path of each stretch of the points; none of them is masked. Its constructor would check each
    and look up what is the same for all."""
    example = Path([[0.0, 0.0]])
    make = Path._fast_from_codes_and_verts
    return [
        make(points[begin:end], codes[begin:end], example)
        for begin, end in zip(begins.tolist(), ends.tolist())
    ]


def codes(artist: Any) -> Any:
    """The path codes of each polygon of a Poly3DCollection; None if they have none."""
    return artist._codes3d


def is_closed(artist: Any) -> bool:
    return bool(artist._closed)


def colours(artist: Any) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """The colours of faces and of edges of a Poly3DCollection, in the order of its polygons."""
    if artist.get_array() is not None:
        artist.update_scalarmappable()
        if artist._face_is_mapped:
            artist._facecolor3d = artist._facecolors
        if artist._edge_is_mapped:
            artist._edgecolor3d = artist._edgecolors
    return artist._facecolor3d, artist._edgecolor3d


def polylines(artist: Any) -> list[npt.NDArray[np.float64]]:
    """The lines of a Line3DCollection, (n, 3) each."""
    return [np.asarray(s, float).reshape(-1, 3) for s in artist._segments3d]


def line_points(artist: Any) -> npt.NDArray[np.float64]:
    """The points of a Line3D, (n, 3); nan where they are masked."""
    arrays = [_filled(v) for v in artist._verts3d]
    return np.column_stack(np.broadcast_arrays(*arrays)).reshape(-1, 3)


def patch_points(artist: Any) -> tuple[npt.NDArray[np.float64], Any]:
    """The points of a Patch3D, (n, 3), and their path codes; None for a closed polygon's corners."""
    points = np.array([[float(v) for v in p] for p in artist._segment3d]).reshape(-1, 3)
    return points, getattr(artist, "_code3d", None)


def project_patch(artist: Any) -> None:
    """Sets the outline in the picture of a Patch3D, which a tight bounding box reads. One without
    points has none."""
    if len(artist._segment3d):
        artist.do_3d_projection()


def dashes(artist: Any) -> tuple[float, Any]:
    """The offset and dashes, in points, of a Line3D or Patch3D."""
    return artist._dash_pattern  # type: ignore[no-any-return]


def marker_points(artist: Any) -> npt.NDArray[np.float64]:
    """The places of the markers of a Path3DCollection or Patch3DCollection, (n, 3)."""
    _require(artist, "_offsets3d")
    arrays = [_filled(v) for v in artist._offsets3d]
    return np.column_stack(np.broadcast_arrays(*arrays)).reshape(-1, 3)


def hide_markers(artist: Any, hidden: npt.NDArray[np.bool_]) -> None:
    """Takes hidden markers away until the next projection, which was just made."""
    _require(artist, "_z_markers_idx")
    offsets = _filled(drawn_offsets(artist)).copy()
    offsets[in_order(artist, hidden)] = np.nan
    if getattr(artist, "_offset_zordered", None) is not None:  # since 3.8
        artist._offset_zordered = offsets
    else:
        artist.set_offsets(offsets)


def drawn_offsets(artist: Any) -> Any:
    """The places of the markers in the picture, in the order in which they are drawn."""
    ordered = getattr(artist, "_offset_zordered", None)
    return artist.get_offsets() if ordered is None else ordered


def in_order(artist: Any, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Values of the markers in the order in which they are drawn, since the last projection."""
    order = artist._z_markers_idx
    ordered: npt.NDArray[Any] = values if isinstance(order, slice) else values[order]
    return ordered
