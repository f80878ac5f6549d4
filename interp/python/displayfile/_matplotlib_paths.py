"""From pieces of polygons and lines to paths in the order in which they are drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.path import Path

from . import _matplotlib_private as private
from ._matplotlib_artists import Attributes, Lines, Polygons, Styles, joined
from ._matplotlib_ends import ended
from ._matplotlib_seams import Rings, closed_paths, extensions

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt
    from mpl_toolkits.mplot3d import Axes3D

    from ._matplotlib_seams import Seen

    Bools = npt.NDArray[np.bool_]
    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

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
    ax: Axes3D,
    polygons: Polygons,
    pieces: Any,
    lines: Lines,
    of_item: Indices,
    cuts: Bools,
    styles: Styles,
    paths: Paths,
    seen: Seen,
) -> None:
    """Pieces in their order: those of one polygon that follow one another are one path. After the
    polygons' items come those of segments, whose ends are cut if cuts, (n, 2), are True. `seen`
    returns the parts of segments that no polygon hides, and the segment of each."""
    assert polygons.attributes is not None
    count = len(polygons.sides)
    first = pieces.first.astype(np.int64)
    item = pieces.item.astype(np.int64)
    lengths = np.diff(first)
    is_line = item >= count

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
    is_opaque = face[:, 3] >= 1.0
    cut = ~is_whole & ~line_run
    edged = cut & has_edge
    dash = np.where(cut, 0, a.dash)
    edge[cut] = 0.0

    is_side = ~_on_bridges(pieces, first, item, polygons)
    is_own = pieces.sides > 0
    run_of = np.repeat(np.arange(len(run)), run_end - run)
    is_joined = np.repeat((cut & is_opaque)[run_of], lengths)
    pixels = np.append(_pixels(ax), 1.0)
    rings = Rings(pieces.points * pixels, first, item, run_of)

    def parts_seen(segments: Floats) -> tuple[Floats, Indices]:
        parts, of = seen(segments / pixels)
        return parts * pixels, of

    extended = extensions(rings, is_joined & ~(is_own & is_side), parts_seen)
    extended = extended._replace(points=extended.points / pixels[:2])
    xy, closed_first, closed_end = closed_paths(pieces.points[:, :2], first, extended)
    codes = np.full(len(xy), Path.LINETO, Path.code_type)
    codes[closed_first] = Path.MOVETO
    codes[closed_end - 1] = Path.CLOSEPOLY
    made = private.paths(xy, codes, closed_first[run], closed_end[run_end - 1])

    looks = Attributes(face, edge, width, a.antialiased, dash, a.style)
    place = np.arange(len(made), dtype=float)
    if edged.any():
        points, side_codes, begins = _sides(pieces, first, is_side & is_own)
        edge_begin, edge_end = begins[run], begins[run_end]
        chosen = np.flatnonzero(edged & (edge_begin < edge_end))
        own = a.of(chosen)
        own = own._replace(face=np.zeros((len(chosen), 4)), style=styles.unhatched(own.style))
        made += private.paths(points, side_codes, edge_begin[chosen], edge_end[chosen])
        looks, place = joined([looks, own]), np.append(place, chosen + 0.5)
    if line_run.any():
        kept = np.append(~line_run, np.ones(len(made) - len(line_run), bool))
        made = [path for path, keep in zip(made, kept.tolist()) if keep]
        looks, place = looks.of(kept), place[kept]
    which = np.flatnonzero(is_line & (of_item[item] < len(lines.segments)))
    if len(which):
        of_piece = cuts[item[which] - count]
        drawn, of_drawn, own = _line_pieces(ax, pieces, which, of_item, of_piece, lines, styles)
        made, looks = made + drawn, joined([looks, own])
        place = np.append(place, run_of[which[of_drawn]])
    order = np.argsort(place, kind="stable")
    paths.add([made[k] for k in order.tolist()], *looks.of(order))


def _pixels(ax: Axes3D) -> Floats:
    """The pixels of a unit in x and y."""
    corners = ax.transData.transform([(0.0, 0.0), (1.0, 1.0)])
    return np.asarray(np.maximum(np.abs(corners[1] - corners[0]), 1e-300))


def _line_pieces(
    ax: Axes3D,
    pieces: Any,
    which: Indices,
    of_item: Indices,
    cuts: Bools,
    lines: Lines,
    styles: Styles,
) -> tuple[list[Path], Indices, Attributes]:
    """Pieces of lines as paths, of which of the pieces each is one, and what it looks like. cuts, (n, 2),
    are those of the ends of the lines."""
    assert lines.attributes is not None
    looks = lines.attributes.of(lines.line[of_item[pieces.item[which]]])
    ends = pieces.first[which].astype(np.int64)[:, None] + [0, 1]
    return _ended(ax, list(pieces.points[ends, :2]), pieces.cuts[ends] | cuts, looks, styles)


def _ended(
    ax: Axes3D, polylines: list[Floats], cuts: Bools, looks: Attributes, styles: Styles
) -> tuple[list[Path], Indices, Attributes]:
    """Polylines as paths that end where they are cut, of which polyline each is a part, and what it
    looks like."""
    made: list[Path] = []
    of: list[int] = []
    butt: list[bool] = []
    for k, points in enumerate(polylines):
        cap = styles.styles[int(looks.style[k])].cap
        is_plain = bool(looks.dash[k] == 0 and looks.edge[k, 3] >= 1.0)
        parts = ended(ax, points, cuts[k], float(looks.width[k]), cap, is_plain)
        made += [Path(part) for part, _ in parts]
        of += [k] * len(parts)
        butt += [is_butt for _, is_butt in parts]
    whose = np.array(of, np.int64)
    looks = looks.of(whose)
    for k in np.flatnonzero(butt).tolist():
        looks.style[k] = styles.butt(int(looks.style[k]))
    return made, whose, looks


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
    ax: Axes3D,
    lines: Lines,
    parts: Floats,
    item: Indices,
    cuts: Bools,
    styles: Styles,
    paths: Paths,
) -> None:
    """Parts of segments, in the order of the segments: those that join are one path. Their ends are
    cut where cuts, (n, 2), are True."""
    if lines.attributes is None or not len(item):
        return
    line = lines.line[item]
    joins = (line[1:] == line[:-1]) & (np.diff(item) <= 1)
    joins &= np.abs(parts[1:, 0, :2] - parts[:-1, 1, :2]).max(axis=1) < 1e-12
    begin = np.flatnonzero(np.concatenate([[True], ~joins]))
    end = np.append(begin[1:], len(item))
    polylines = [
        np.concatenate([parts[b : b + 1, 0, :2], parts[b:e, 1, :2]])
        for b, e in zip(begin.tolist(), end.tolist())
    ]
    looks = lines.attributes.of(line[begin])
    cut_ends = np.column_stack([cuts[begin, 0], cuts[end - 1, 1]])
    made, of, looks = _ended(ax, polylines, cut_ends, looks, styles)
    dash = looks.dash.copy()
    if dash.any():
        lengths = _lengths_on_paper(ax, lines)
        unit = 72.0 / ax.figure.dpi
        first = item[begin][of]
        corner = ax.transData.transform(lines.segments[first, 0, :2])
        start = ax.transData.transform([path.vertices[0] for path in made])
        from_start = lengths[first] + np.hypot(*(start - corner).T) * unit
        for k in np.flatnonzero(dash).tolist():
            offset, dashes = styles.dashes[dash[k]]
            styles.dashes.append((offset + float(from_start[k]), dashes))
            dash[k] = len(styles.dashes) - 1
    paths.add(made, *looks._replace(dash=dash))


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
