"""From pieces of polygons and lines to paths in the order in which they are drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.path import Path

from . import _matplotlib_private as private
from ._matplotlib_artists import Lines, Polygons, Styles

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt
    from mpl_toolkits.mplot3d import Axes3D

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

_SEAM = 0.4
"""Points: the width of strokes that close the seams between pieces of an opaque polygon."""


class Paths:
    """Paths in the order in which they are drawn, with all that each has."""

    def __init__(self) -> None:
        self.paths: list[Path] = []
        self.parts: list[tuple[Any, ...]] = []

    def add(self, paths: Sequence[Path], *attributes: Any) -> None:
        """attributes are face, edge, width, antialiased, dash and style: arrays of one each."""
        self.paths += paths
        self.parts.append(attributes)

    def attributes(self) -> list[Any]:
        return [np.concatenate(column) for column in zip(*self.parts)]


def add_pieces(
    polygons: Polygons, pieces: Any, lines: Lines, of_item: Indices, styles: Styles, paths: Paths
) -> None:
    """Pieces in their order: those of one polygon that follow one another are one path."""
    assert polygons.attributes is not None
    count = len(polygons.sides)
    first = pieces.first.astype(np.int64)
    item = pieces.item.astype(np.int64)
    lengths = np.diff(first)
    is_line = item >= count

    # Each piece with its first point once more, which closes it.
    closed_first = first[:-1] + np.arange(len(item))
    source = np.arange(first[-1] + len(item)) - np.repeat(np.arange(len(item)), lengths + 1)
    source[closed_first + lengths] = first[:-1]
    xy = pieces.points[source, :2]
    codes = np.full(len(xy), Path.LINETO, Path.code_type)
    codes[closed_first] = Path.MOVETO
    codes[closed_first + lengths] = Path.CLOSEPOLY

    run = np.flatnonzero(np.concatenate([[True], item[1:] != item[:-1]]))
    run_end = np.append(run[1:], len(item))
    of_run = item[run]
    all_own = np.minimum.reduceat(pieces.sides, first[:-1]) > 0
    is_whole = (np.bincount(item, minlength=len(of_item))[of_run] == 1) & all_own[run]
    for k in polygons.bridges:
        is_whole[of_run == k] = False
    line_run = is_line[run]

    a = polygons.attributes.of(np.where(line_run, 0, of_run))
    face, edge, width = a.face.copy(), a.edge.copy(), a.width.copy()
    has_edge = (edge[:, 3] > 0.0) & (width > 0.0)
    like_face = (edge == face).all(axis=1)
    is_opaque = face[:, 3] >= 1.0
    cut = ~is_whole & ~line_run
    # Strokes in the face's own colour close the seams between pieces of opaque polygons.
    one_path = cut & is_opaque & like_face & has_edge
    edged = cut & has_edge & ~one_path
    seamed = cut & is_opaque & ~one_path & a.antialiased
    dash = np.where(cut, 0, a.dash)
    edge[cut & ~one_path] = 0.0
    width[one_path] = np.maximum(width[one_path], _SEAM)

    begin = closed_first[run]
    end = (closed_first + lengths + 1)[run_end - 1]
    made = private.paths(xy, codes, begin, end)
    extra_of: list[int] = []
    is_seam: list[bool] = []
    for r in np.flatnonzero(line_run).tolist():
        made[r] = Path(pieces.points[first[run[r]] : first[run[r]] + 2, :2])
    edges: list[Path] = []
    is_side = ~_on_bridges(pieces, first, item, polygons)
    is_own = pieces.sides > 0
    for wanted, drawn, seam in ((seamed, is_side & ~is_own, True), (edged, is_side & is_own, False)):
        if not wanted.any():
            continue
        points, side_codes, begins = _sides(pieces, first, drawn)
        b, e = begins[run], begins[run_end]
        chosen = np.flatnonzero(wanted & (b < e))
        extra_of += chosen.tolist()
        is_seam += [seam] * len(chosen)
        edges += private.paths(points, side_codes, b[chosen], e[chosen])

    columns = [face, edge, width, a.antialiased, dash, a.style]
    if line_run.any():
        assert lines.attributes is not None
        segment = of_item[of_run[line_run]]
        is_marker = segment >= len(lines.segments)
        whose = lines.attributes.of(lines.line[np.where(is_marker, 0, segment)])
        for column, values in zip(columns, whose):
            column[line_run] = values
        columns[1][np.flatnonzero(line_run)[is_marker]] = 0.0
    if edges:
        extra, seam_too = np.array(extra_of), np.array(is_seam)
        own = a.of(extra)
        own_edge = np.where(seam_too[:, None], own.face, own.edge)
        own_width = np.where(seam_too, _SEAM, own.width)
        own_dash = np.where(seam_too, 0, own.dash)
        added = [np.zeros((len(extra), 4)), own_edge, own_width, own.antialiased, own_dash]
        order = np.argsort(np.concatenate([np.arange(len(made)), extra + 0.5]), kind="stable")
        columns = [
            np.concatenate([c, new])[order]
            for c, new in zip(columns, [*added, styles.unhatched(own.style)])
        ]
        made += edges
        made = [made[k] for k in order.tolist()]
    paths.add(made, *columns)


def _sides(
    pieces: Any, first: Indices, drawn: npt.NDArray[np.bool_]
) -> tuple[Floats, npt.NDArray[Any], Indices]:
    """The sides that are drawn of all pieces, each to a point of its piece, as points and codes of
    paths, and where those of each piece begin."""
    lengths = np.diff(first)
    undrawn = np.flatnonzero(~drawn)
    piece = np.repeat(np.arange(len(lengths)), lengths)[undrawn]
    some, where = np.unique(piece, return_index=True)
    is_whole = np.ones(len(lengths), bool)
    is_whole[some] = False
    begin = np.zeros(len(lengths), int)  # at a side that is not drawn, if there is one
    begin[some] = undrawn[where] - first[some]
    has_any = np.logical_or.reduceat(drawn, first[:-1])
    sizes = np.where(has_any, lengths + is_whole, 0)
    begins = np.concatenate([[0], np.cumsum(sizes)])
    of = np.repeat(np.arange(len(lengths)), sizes)
    place = np.arange(begins[-1]) - begins[of]
    source = first[of] + (begin[of] + place) % lengths[of]
    codes = np.where(drawn[source], Path.LINETO, Path.MOVETO).astype(Path.code_type)
    codes[place == 0] = Path.MOVETO
    codes[place == lengths[of]] = Path.CLOSEPOLY
    return pieces.points[source, :2], codes, begins


def _on_bridges(
    pieces: Any, first: Indices, item: Indices, polygons: Polygons
) -> npt.NDArray[np.bool_]:
    """Which sides lie on bridges between a polygon and its holes, which are not drawn."""
    found = np.zeros(first[-1], bool)
    for k, bridges in polygons.bridges.items():
        for i in np.flatnonzero(item == k).tolist():
            p = pieces.points[first[i] : first[i + 1], :2]
            sides = np.stack([np.roll(p, 1, axis=0), p], axis=1)
            found[first[i] : first[i + 1]] = _lies_on(sides, bridges)
    return found


def _lies_on(segments: Floats, lines: Floats) -> npt.NDArray[np.bool_]:
    """Whether each segment, (n, 2, 2), lies on one of the lines, (m, 2, 2), to rounding."""
    along = (lines[:, 1] - lines[:, 0])[None, None]
    to = segments[:, :, None] - lines[None, None, :, 0]
    length = np.maximum(np.abs(along).sum(axis=3), 1e-300)
    off = np.abs(to[..., 0] * along[..., 1] - to[..., 1] * along[..., 0]) / length
    t = (to * along).sum(axis=3) / np.maximum((along * along).sum(axis=3), 1e-300)
    return ((off < 1e-9) & (t > -1e-9) & (t < 1 + 1e-9)).all(axis=1).any(axis=1)  # type: ignore[no-any-return]


def add_polylines(
    ax: Axes3D, lines: Lines, parts: Floats, item: Indices, styles: Styles, paths: Paths
) -> None:
    """Parts of segments, in the order of the segments: those that join are one path."""
    if lines.attributes is None or not len(item):
        return
    line = lines.line[item]
    joins = (line[1:] == line[:-1]) & (np.diff(item) <= 1)
    joins &= np.abs(parts[1:, 0, :2] - parts[:-1, 1, :2]).max(axis=1) < 1e-12
    begin = np.flatnonzero(np.concatenate([[True], ~joins]))
    end = np.append(begin[1:], len(item))
    made = [
        Path(np.concatenate([parts[b : b + 1, 0, :2], parts[b:e, 1, :2]]))
        for b, e in zip(begin.tolist(), end.tolist())
    ]
    whose = lines.attributes.of(line[begin])
    dash = whose.dash.copy()
    if dash.any():
        lengths = _lengths_on_paper(ax, lines)
        unit = 72.0 / ax.figure.dpi
        corner = ax.transData.transform(lines.segments[item[begin], 0, :2])
        start = ax.transData.transform(parts[begin, 0, :2])
        from_start = lengths[item[begin]] + np.hypot(*(start - corner).T) * unit
        for k in np.flatnonzero(dash).tolist():
            offset, dashes = styles.dashes[dash[k]]
            styles.dashes.append((offset + float(from_start[k]), dashes))
            dash[k] = len(styles.dashes) - 1
    paths.add(made, *whose._replace(dash=dash))


def _lengths_on_paper(ax: Axes3D, lines: Lines) -> Floats:
    """For each segment how long its polyline is before it, in points."""
    ends = ax.transData.transform(lines.segments[:, :, :2].reshape(-1, 2)).reshape(-1, 2, 2)
    length = np.hypot(*(ends[:, 1] - ends[:, 0]).T) * 72.0 / ax.figure.dpi
    before = np.concatenate([[0.0], np.cumsum(length)[:-1]])
    starts = np.flatnonzero(np.concatenate([[True], lines.line[1:] != lines.line[:-1]]))
    lengths: Floats = before - np.repeat(
        before[starts], np.diff(np.append(starts, len(lines.line)))
    )
    return lengths
