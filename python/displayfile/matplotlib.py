"""Exact visibility for matplotlib's three-dimensional axes.

exact(ax) makes an Axes3D draw its surfaces, polygons, lines and markers with hidden surfaces
removed exactly, across artists.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib import rcParams
from matplotlib.collections import Collection, PathCollection
from matplotlib.colors import to_rgba, to_rgba_array
from matplotlib.lines import Line2D
from matplotlib.path import Path
from mpl_toolkits.mplot3d import Axes3D, art3d

from . import _matplotlib_private as private
from ._displayfile import Error
from ._polygons import sort, visible_lines

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

__all__ = ["Exact", "exact"]

_SEAM = 0.4
"""Points: the width of strokes that close the seams between pieces of an opaque polygon."""
_LIFT = 1e-6
_CURVE_PARTS = 16
_MARKER = 1e-9
"""Half the length of the line that stands for a marker, in widths of the scene."""
_CLEAR = np.zeros(4)
_METHODS = ("depth-sort", "bsp")


def exact(
    ax: Axes3D, *, method: str = "depth-sort", lift: float = _LIFT, off: bool = False
) -> Exact:
    """Make the axes draw with exact visibility, from now on.

    Polygons, lines and markers are hidden where opaque polygons are before them, whichever artist
    they are of. Those that are added later are drawn so too. method is "depth-sort" or "bsp".
    Lines and markers are taken as nearer to the viewer by lift times the depth of the scene.

    With off, and by the remove method of what is returned, the axes draw as before.
    """
    if not isinstance(ax, Axes3D):
        raise Error(f"exact: expected an Axes3D, not {type(ax).__name__}")
    if method not in _METHODS:
        raise Error(f"method '{method}': expected depth-sort or bsp")
    if not 0.0 <= lift < 1.0:
        raise Error(f"lift: {lift}: expected 0 or more, and less than 1")
    private.require_axes(ax)
    handle = getattr(vars(ax).get("draw"), "__self__", None)
    if not isinstance(handle, Exact):
        handle = Exact(ax)
    handle.method = method
    handle.lift = lift
    ax.stale = True
    if off:
        handle.remove()
    else:
        ax.draw = handle._draw
    return handle


class Exact:
    """Draws the axes that it was made for."""

    method: str
    lift: float

    def __init__(self, ax: Axes3D) -> None:
        self.ax = ax

    def remove(self) -> None:
        """Make the axes draw as before."""
        if getattr(vars(self.ax).get("draw"), "__self__", None) is self:
            del self.ax.draw
            self.ax.stale = True

    def _draw(self, renderer: Any) -> None:
        ax = self.ax
        groups: dict[float, list[Any]] = {}
        drawn: list[Any] = []
        for artist in private.children(ax):
            if not _is_taken(artist):
                drawn.append(artist)
                continue
            # Without a computed order the artists' own order is kept: each is a scene by itself.
            group = groups.setdefault(0.0 if ax.computed_zorder else artist.get_zorder(), [])
            if not group:
                drawn.append(group)
            group.append(artist)
        shown: list[Any] = []
        for entry in drawn:
            if isinstance(entry, list):
                scene = _Scene(ax, entry, self.method, self.lift)
                shown.append(scene)
                shown += [_Markers(scene, artist) for artist in entry if _is_scatter(artist)]
            else:
                shown.append(entry)
        with private.children_replaced(ax, shown):
            type(ax).draw(ax, renderer)


_SCATTERS = (art3d.Path3DCollection, art3d.Patch3DCollection)
_TAKEN = (
    art3d.Poly3DCollection,
    art3d.Line3DCollection,
    art3d.Line3D,
    art3d.Patch3D,
    *_SCATTERS,
)


def _is_scatter(artist: Any) -> bool:
    return isinstance(artist, _SCATTERS)


def _is_taken(artist: Any) -> bool:
    return (
        isinstance(artist, _TAKEN)
        and artist.get_visible()
        and not artist.get_animated()
        and not private.is_clipped_to_limits(artist)
    )


# ---- What is drawn -----------------------------------------------------------------------------


class _Style(NamedTuple):
    """What a collection has once for all of its paths."""

    clip_on: bool
    clip_box: Any
    clip_path: Any
    cap: Any
    join: Any
    hatch: Any
    sketch: Any
    effects: Any
    snap: Any
    gid: Any
    url: Any
    rasterized: Any
    agg_filter: Any

    def give(self, c: Collection) -> None:
        c.set_clip_on(self.clip_on)
        c.set_clip_box(self.clip_box)
        c.set_clip_path(self.clip_path)
        if self.cap is not None:
            c.set_capstyle(self.cap)
        if self.join is not None:
            c.set_joinstyle(self.join)
        c.set_hatch(self.hatch)
        c.set_sketch_params(*(self.sketch or (None,)))
        c.set_path_effects(self.effects)
        c.set_snap(self.snap)
        c.set_gid(self.gid)
        c.set_url(self.url)
        c.set_rasterized(self.rasterized)
        c.set_agg_filter(self.agg_filter)


def _style_of(artist: Any, cap: Any, join: Any) -> _Style:
    clip_path = artist.get_clip_path()
    if isinstance(artist, Collection):
        urls = artist.get_urls()
        url = urls[0] if len(urls) else None
    else:
        url = artist.get_url()
    return _Style(
        artist.get_clip_on(),
        artist.get_clip_box(),
        clip_path,
        cap,
        join,
        artist.get_hatch() if hasattr(artist, "get_hatch") else None,
        artist.get_sketch_params(),
        tuple(artist.get_path_effects() or ()),
        artist.get_snap(),
        artist.get_gid(),
        url,
        artist.get_rasterized(),
        artist.get_agg_filter(),
    )


class _Styles:
    """The styles and dashes of a scene, each once."""

    def __init__(self) -> None:
        self.styles: list[_Style] = []
        self._keys: list[Any] = []
        self.dashes: list[Any] = [(0, None)]

    def style(self, style: _Style) -> int:
        box = style.clip_box and tuple(style.clip_box.get_points().ravel())
        path = style.clip_path and style.clip_path.get_fully_transformed_path()
        outline = path and (path.vertices.tolist(), path.codes is not None and path.codes.tolist())
        key = (box, outline, style._replace(clip_box=None, clip_path=None))
        if key not in self._keys:
            self._keys.append(key)
            self.styles.append(style)
        return self._keys.index(key)

    def dash(self, pattern: Any) -> int:
        if pattern not in self.dashes:
            self.dashes.append(pattern)
        return self.dashes.index(pattern)


class _Paths:
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


class _Attributes(NamedTuple):
    """Of each polygon, or of each polyline."""

    face: Floats
    edge: Floats
    width: Floats
    antialiased: npt.NDArray[np.bool_]
    dash: Indices
    style: Indices

    def of(self, which: Any) -> _Attributes:
        return _Attributes(*(column[which] for column in self))


def _cycled(values: Any, n: int, *shape: int) -> Any:
    """What a collection of n has of values that may be fewer, or none."""
    array = np.asarray(values)
    if len(array) == n:
        return array
    return np.resize(array, (n, *shape)) if len(array) else np.zeros((n, *shape))


def _attributes(
    styles: _Styles,
    n: int,
    face: Any,
    edge: Any,
    width: Any,
    antialiased: Any,
    patterns: Sequence[Any],
    style: _Style,
) -> _Attributes:
    dashes = [styles.dash((p[0], None if p[1] is None else tuple(p[1]))) for p in patterns]
    return _Attributes(
        _cycled(face, n, 4),
        _cycled(edge, n, 4),
        _cycled(np.atleast_1d(width), n).astype(float),
        _cycled(np.atleast_1d(antialiased), n).astype(bool),
        _cycled(dashes or [0], n).astype(np.int64),
        np.full(n, styles.style(style)),
    )


def _joined(columns: list[_Attributes]) -> _Attributes:
    return _Attributes(*(np.concatenate(column) for column in zip(*columns)))


# ---- From artists to polygons and polylines ----------------------------------------------------


def _projected(points: Floats, matrix: Floats) -> Floats:
    """In the axes' projection, with a larger z nearer; nan for what is not before the eye.

    Each coordinate is a sum in one order, so that equal points are equal afterwards.
    """
    x, y, z = points.T
    rows = [m[0] * x + m[1] * y + m[2] * z + m[3] for m in matrix]
    w = np.where(rows[3] > 0.0, rows[3], np.nan)
    return np.column_stack([rows[0] / w, rows[1] / w, -rows[2] / w])


class _Polygons:
    """The polygons of a scene. Polygon k has the corners from first[k] to first[k + 1]."""

    def __init__(self) -> None:
        self.points: Floats = np.zeros((0, 3))
        self.sides: Indices = np.zeros(0, np.int64)
        self.bridges: dict[int, Floats] = {}
        """The sides that are not drawn, (n, 2, 2): those that join rings, or close open ones."""
        self.attributes: _Attributes | None = None
        self._points: list[Floats] = []
        self._sides: list[Indices] = []
        self._attributes: list[_Attributes] = []

    def add(self, points: Floats, sides: Indices, attributes: _Attributes) -> None:
        """Leaves out polygons of fewer than 3 corners, or with one that is not finite."""
        first = np.concatenate([[0], np.cumsum(sides)])
        bad = np.concatenate([[0], np.cumsum(~np.isfinite(points).all(axis=1))])
        good = (sides >= 3) & (bad[first[1:]] == bad[first[:-1]])
        if not good.all():
            points = points[np.repeat(good, sides)]
            attributes = attributes.of(good)
            sides = sides[good]
        self._points.append(points)
        self._sides.append(sides)
        self._attributes.append(attributes)

    def add_rings(self, rings: list[tuple[Floats, bool]], attributes: _Attributes) -> None:
        """One polygon of several rings, of which the others are holes; closed or not each."""
        rings = [(ring, closed) for ring, closed in rings if len(ring) >= 3]
        if not rings or not all(np.isfinite(ring).all() for ring, _ in rings):
            return
        outline = rings[0][0]
        bridges = [[ring[-1, :2], ring[0, :2]] for ring, closed in rings if not closed]
        if len(rings) > 1:
            anchor = outline[:1]
            loops = [np.concatenate([ring, ring[:1], anchor]) for ring, _ in rings[1:]]
            outline = np.concatenate([outline, anchor, *loops])[:-1]
            bridges += [[anchor[0, :2], ring[0, :2]] for ring, _ in rings[1:]]
        if bridges:
            self.bridges[sum(len(sides) for sides in self._sides)] = np.array(bridges)
        self.add(outline, np.array([len(outline)]), attributes)

    def finish(self) -> None:
        if not self._sides:
            return
        self.points = np.concatenate(self._points)
        self.sides = np.concatenate(self._sides)
        self.attributes = _joined(self._attributes)

    def some(self, which: npt.NDArray[np.bool_]) -> tuple[Floats, Indices]:
        return self.points[np.repeat(which, self.sides)], self.sides[which]

    def is_opaque(self) -> npt.NDArray[np.bool_]:
        return np.zeros(0, bool) if self.attributes is None else self.attributes.face[:, 3] >= 1.0


class _Lines:
    """The polylines of a scene, as segments."""

    def __init__(self) -> None:
        self.segments: Floats = np.zeros((0, 2, 3))
        self.line: Indices = np.zeros(0, np.int64)
        """The polyline of each segment."""
        self.attributes: _Attributes | None = None
        self._segments: list[Floats] = []
        self._line: list[Indices] = []
        self._attributes: list[_Attributes] = []
        self._count = 0

    def add(self, points: Floats, lengths: Indices, attributes: _Attributes) -> None:
        line = np.repeat(np.arange(len(lengths)), lengths)
        segments = np.stack([points[:-1], points[1:]], axis=1)
        good = (line[1:] == line[:-1]) & np.isfinite(segments).all(axis=(1, 2))
        self._segments.append(segments[good])
        self._line.append(line[1:][good] + self._count)
        self._attributes.append(attributes)
        self._count += len(lengths)

    def finish(self) -> None:
        if not self._line:
            return
        self.segments = np.concatenate(self._segments)
        self.line = np.concatenate(self._line)
        self.attributes = _joined(self._attributes)


def _add_polygons(artist: Any, matrix: Floats, polygons: _Polygons, styles: _Styles) -> None:
    corners, sides = private.polygons(artist)
    face, edge = private.colours(artist)
    n = len(sides)
    face = _cycled(face, n, 4)
    style = _style_of(artist, *private.cap_and_join(artist))
    attributes = _attributes(
        styles,
        n,
        face,
        edge,
        artist.get_linewidth(),
        private.antialiased(artist),
        artist.get_linestyle(),
        style,
    )
    points = _projected(corners, matrix)
    codes = private.codes(artist)
    if codes is None and private.is_closed(artist):
        polygons.add(points, sides, attributes)
        return
    for k, own in enumerate(np.split(points, np.cumsum(sides)[:-1]) if n else []):
        rings = _rings(own, None if codes is None else codes[k])
        polygons.add_rings(rings, attributes.of([k]))


def _rings(points: Floats, codes: Any) -> list[tuple[Floats, bool]]:
    """The rings of a path, (n, 3) each, and whether it closes them. Curves become polygons."""
    if codes is None:
        return [_without_repeats(points, False)]
    rings: list[tuple[Floats, bool]] = []
    ring: list[Floats] = []
    k = 0
    while k < len(codes):
        code = int(codes[k])
        degree = {Path.CURVE3: 2, Path.CURVE4: 3}.get(code, 1)
        if code in (Path.MOVETO, Path.CLOSEPOLY, Path.STOP):
            if ring:
                rings.append((np.concatenate(ring), code == Path.CLOSEPOLY))
            ring = [points[k : k + 1]] if code == Path.MOVETO else []
        elif degree == 1 or not ring:
            ring.append(points[k : k + 1])
        else:
            ring.append(_curve(np.concatenate([ring[-1][-1:], points[k : k + degree]])))
        k += degree
    if ring:
        rings.append((np.concatenate(ring), False))
    return [_without_repeats(ring, closed) for ring, closed in rings]


def _without_repeats(ring: Floats, closed: bool) -> tuple[Floats, bool]:
    """Without points like the one before; a ring that ends where it begins is closed."""
    ring = ring[np.concatenate([[True], (ring[1:] != ring[:-1]).any(axis=1)])]
    if len(ring) > 1 and (ring[0] == ring[-1]).all():
        return ring[:-1], True
    return ring, closed


def _curve(controls: Floats) -> Floats:
    """Points of a Bezier curve, without its first."""
    t = np.arange(1, _CURVE_PARTS + 1)[:, None] / _CURVE_PARTS
    while len(controls) > 1 and controls.ndim == 2:
        controls = np.repeat(controls[:, None], _CURVE_PARTS, axis=1)
    while len(controls) > 1:
        controls = controls[:-1] * (1 - t) + controls[1:] * t
    return controls[0]


def _add_patch(artist: Any, matrix: Floats, polygons: _Polygons, styles: _Styles) -> None:
    corners, codes = private.patch_points(artist)
    attributes = _attributes(
        styles,
        1,
        [artist.get_facecolor()],
        [artist.get_edgecolor()],
        artist.get_linewidth(),
        artist.get_antialiased(),
        [private.dashes(artist)],
        _style_of(artist, artist.get_capstyle(), artist.get_joinstyle()),
    )
    polygons.add_rings(_rings(_projected(corners, matrix), codes), attributes)


def _add_lines(artist: Any, matrix: Floats, lines: _Lines, styles: _Styles) -> None:
    if artist.get_array() is not None:
        artist.update_scalarmappable()
    polylines = private.polylines(artist)
    if not polylines:
        return
    attributes = _attributes(
        styles,
        len(polylines),
        [_CLEAR],
        artist.get_edgecolor(),
        artist.get_linewidth(),
        private.antialiased(artist),
        artist.get_linestyle(),
        _style_of(artist, *private.cap_and_join(artist)),
    )
    lengths = np.array([len(p) for p in polylines])
    lines.add(_projected(np.concatenate(polylines), matrix), lengths, attributes)


def _add_line(artist: Any, matrix: Floats, lines: _Lines, styles: _Styles) -> None:
    if artist.get_linestyle() in ("None", "none", " ", ""):
        return
    points = private.line_points(artist)
    pattern = private.dashes(artist)
    kind = "dash" if pattern[1] is not None else "solid"
    attributes = _attributes(
        styles,
        1,
        [_CLEAR],
        [to_rgba(artist.get_color(), artist.get_alpha())],
        artist.get_linewidth(),
        artist.get_antialiased(),
        [pattern],
        _style_of(
            artist,
            getattr(artist, f"get_{kind}_capstyle")(),
            getattr(artist, f"get_{kind}_joinstyle")(),
        ),
    )
    lines.add(_projected(points, matrix), np.array([len(points)]), attributes)


# ---- The scene ---------------------------------------------------------------------------------


class _Scene(Collection):
    """Draws the polygons and lines of several artists, and tells which markers are hidden."""

    def __init__(self, ax: Axes3D, artists: list[Any], method: str, lift: float) -> None:
        super().__init__()
        self.axes = ax
        self.set_figure(ax.figure)
        self.set_zorder(min(a.get_zorder() for a in artists))
        self.hidden: dict[Any, npt.NDArray[np.bool_]] = {}
        self.tints: dict[Any, Floats] = {}
        """Of each marker what covers it: a colour, and how much of the marker's is left."""
        self._artists, self._method, self._lift = artists, method, lift
        self._runs: list[PathCollection] = []

    def do_3d_projection(self) -> float:
        matrix = self.axes.M
        polygons, lines, styles = _Polygons(), _Lines(), _Styles()
        markers: list[Floats] = [np.zeros((0, 3))]
        marked: list[Any] = []
        for artist in self._artists:
            if isinstance(artist, art3d.Poly3DCollection):
                _add_polygons(artist, matrix, polygons, styles)
            elif isinstance(artist, art3d.Patch3D):
                _add_patch(artist, matrix, polygons, styles)
            elif isinstance(artist, art3d.Line3DCollection):
                _add_lines(artist, matrix, lines, styles)
            elif isinstance(artist, art3d.Line3D):
                _add_line(artist, matrix, lines, styles)
                if _has_markers(artist):
                    marked.append(artist)
                    markers.append(_projected(private.line_points(artist), matrix))
            else:
                marked.append(artist)
                markers.append(_projected(private.marker_points(artist), matrix))
        polygons.finish()
        lines.finish()
        paths = _Paths()
        self._find(polygons, lines, np.concatenate(markers), styles, paths)
        ends = np.cumsum([len(m) for m in markers[1:]], dtype=np.int64)
        for k, artist in enumerate(marked):
            begin = ends[k] - len(markers[k + 1])
            self.hidden[artist] = self._is_hidden[begin : ends[k]]
            self.tints[artist] = self._tint[begin : ends[k]]
        self._make_runs(paths, styles)
        return np.inf  # Drawn before all other artists whose order is computed.

    def _find(
        self, polygons: _Polygons, lines: _Lines, markers: Floats, styles: _Styles, paths: _Paths
    ) -> None:
        self._is_hidden = ~np.isfinite(markers).all(axis=1)
        self._tint = np.tile([0.0, 0.0, 0.0, 1.0], (len(markers), 1))
        whole_line = lines.segments, np.arange(len(lines.segments))
        if polygons.attributes is None:
            _add_polylines(self.axes, lines, *whole_line, styles, paths)
            return
        opaque = polygons.is_opaque()
        low, high = polygons.points.min(axis=0), polygons.points.max(axis=0)
        size = np.where(high > low, high - low, 1.0)
        raised = np.array([0.0, 0.0, size[2] * self._lift])

        # What opaque polygons hide is left out.
        shown = np.flatnonzero(~self._is_hidden)
        half = np.array([size[0] * _MARKER, 0.0, 0.0])
        places = markers[shown] + raised
        segments = np.concatenate(
            [lines.segments + raised, np.stack([places - half, places + half], axis=1)]
        )
        parts, item = _parts_seen(polygons.some(opaque), segments)
        # What is behind translucent polygons is sorted with them; what is not is drawn last.
        count = len(lines.segments)
        behind = _is_behind(polygons.some(~opaque), parts) if not opaque.all() else None
        if behind is not None:
            parts, of_parts, behind_part = behind
            item = item[of_parts]
        else:
            behind_part = np.zeros(len(item), bool)
        of_marker = item >= count
        seen = np.zeros(len(shown), bool)
        seen[item[of_marker] - count] = True
        self._is_hidden[shown[~seen]] = True

        sorted_too = np.flatnonzero(behind_part)
        pieces = sort(
            polygons.points,
            sides=polygons.sides,
            segments=parts[sorted_too] if len(sorted_too) else None,
            whole=True,
            method=self._method,
        )
        of_item = np.full(len(polygons.sides) + len(sorted_too), -1)
        of_item[len(polygons.sides) :] = item[sorted_too]
        _add_pieces(polygons, pieces, lines, of_item, paths)
        is_marker = of_item[pieces.item] >= count
        if is_marker.any():
            self._tint_markers(polygons, pieces, of_item - count, is_marker, markers, shown)
        on_top = ~behind_part & ~of_marker
        _add_polylines(self.axes, lines, parts[on_top] - raised, item[on_top], styles, paths)

    def _tint_markers(
        self,
        polygons: _Polygons,
        pieces: Any,
        of_item: Indices,
        is_marker: npt.NDArray[np.bool_],
        markers: Floats,
        shown: Indices,
    ) -> None:
        """What is drawn over each marker's place after it: only translucent polygons are."""
        assert polygons.attributes is not None
        count = len(polygons.sides)
        first = pieces.first.astype(np.int64)
        low = np.minimum.reduceat(pieces.points[:, :2], first[:-1])
        high = np.maximum.reduceat(pieces.points[:, :2], first[:-1])
        face = np.zeros((len(of_item), 4))
        face[:count] = polygons.attributes.face
        face = face[pieces.item]
        translucent = (face[:, 3] > 0.0) & (face[:, 3] < 1.0)
        done: set[int] = set()
        for k in np.flatnonzero(is_marker):
            marker = int(shown[of_item[pieces.item[k]]])
            if marker in done:
                continue
            done.add(marker)
            at = markers[marker, :2]
            over = translucent & (low <= at).all(axis=1) & (high >= at).all(axis=1)
            over[: k + 1] = False
            for j in np.flatnonzero(over):
                if Path(pieces.points[first[j] : first[j + 1], :2]).contains_point(at):
                    alpha = face[j, 3]
                    self._tint[marker] *= 1.0 - alpha
                    self._tint[marker, :3] += alpha * face[j, :3]

    def _make_runs(self, paths: _Paths, styles: _Styles) -> None:
        """One collection for each run of paths that have one style."""
        self._runs = []
        if not paths.paths:
            return
        face, edge, width, antialiased, dash, style = paths.attributes()
        starts = np.concatenate([[0], np.flatnonzero(np.diff(style)) + 1, [len(style)]])
        for begin, end in zip(starts[:-1], starts[1:]):
            part = slice(begin, end)
            widths = width[part]
            patterns: Any = "solid"
            if dash[part].any():
                scale = widths if rcParams["lines.scale_dashes"] else np.ones(len(widths))
                patterns = [
                    _unscaled(styles.dashes[d], s) for d, s in zip(dash[part].tolist(), scale)
                ]
            elif (widths == widths[0]).all():
                widths = widths[:1]
            smooth = antialiased[part]
            run = PathCollection(
                paths.paths[begin:end],
                facecolors=face[part],
                edgecolors=edge[part],
                linewidths=widths,
                linestyles=patterns,
                antialiaseds=smooth[:1] if (smooth == smooth[0]).all() else smooth,
            )
            run.axes = self.axes
            run.set_figure(self.figure)
            run.set_transform(self.axes.transData)
            styles.styles[int(style[begin])].give(run)
            self._runs.append(run)

    def draw(self, renderer: Any) -> None:
        for run in self._runs:
            run.draw(renderer)
        for artist in self._artists:
            if isinstance(artist, art3d.Line3D) and artist in self.hidden:
                self._draw_line_markers(artist, renderer)

    def _draw_line_markers(self, artist: Any, renderer: Any) -> None:
        xy = _projected(private.line_points(artist), self.axes.M)[:, :2]
        xy[self.hidden[artist]] = np.nan
        line = Line2D([], [])
        line.update_from(artist)
        line.axes = self.axes
        line.set_figure(self.figure)
        line.set_linestyle("none")
        line.set_markevery(artist.get_markevery())
        line.set_data(xy.T)
        line.draw(renderer)


def _has_markers(artist: Any) -> bool:
    return artist.get_marker() not in ("None", "none", " ", "", None)


def _unscaled(pattern: Any, scale: float) -> Any:
    offset, dashes = pattern
    if dashes is None:
        return "solid"
    return offset / scale, [d / scale for d in dashes]


def _parts_seen(polygons: tuple[Floats, Indices], segments: Floats) -> tuple[Floats, Indices]:
    """The parts of segments that are seen, in the order of the segments and along them."""
    points, sides = polygons
    if not len(sides) or not len(segments):
        return segments, np.arange(len(segments))
    seen = visible_lines(points, sides=sides, segments=segments)
    order = _order_along(segments, seen.points, seen.item)
    return seen.points[order], seen.item[order].astype(np.int64)


def _is_behind(
    polygons: tuple[Floats, Indices], segments: Floats
) -> tuple[Floats, Indices, npt.NDArray[np.bool_]] | None:
    """The parts of segments that polygons are before, and those that none is before."""
    points, sides = polygons
    if not len(segments):
        return None
    seen = visible_lines(points, sides=sides, segments=segments, hidden=True)
    order = _order_along(segments, seen.points, seen.item)
    return seen.points[order], seen.item[order].astype(np.int64), seen.hidden[order]


def _order_along(segments: Floats, parts: Floats, item: Any) -> Indices:
    from_start = np.abs(parts[:, 0] - segments[item, 0]).sum(axis=1)
    return np.lexsort((from_start, item))


# ---- From pieces to paths ----------------------------------------------------------------------


def _add_pieces(
    polygons: _Polygons, pieces: Any, lines: _Lines, of_item: Indices, paths: _Paths
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
    slices = zip(begin.tolist(), end.tolist())
    made = [Path(xy[b:e], codes[b:e]) for b, e in slices]
    extra_of: list[int] = []
    is_seam: list[bool] = []
    for r in np.flatnonzero(line_run).tolist():
        made[r] = Path(pieces.points[first[run[r]] : first[run[r]] + 2, :2])
    edges: list[Path] = []
    for wanted, seam in ((seamed, True), (edged, False)):
        for r in np.flatnonzero(wanted).tolist():
            bridges = polygons.bridges.get(int(of_run[r]))
            path = _sides_of(pieces, first, run[r], run_end[r], bridges, seam)
            if path is not None:
                extra_of.append(r)
                is_seam.append(seam)
                edges.append(path)

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
            np.concatenate([c, new])[order] for c, new in zip(columns, [*added, own.style])
        ]
        made += edges
        made = [made[k] for k in order.tolist()]
    paths.add(made, *columns)


def _sides_of(
    pieces: Any, first: Indices, begin: int, end: int, bridges: Floats | None, seam: bool
) -> Path | None:
    """The polygon's own sides of some of its pieces, in one path, or those that cuts made."""
    points: list[Floats] = []
    codes: list[npt.NDArray[Any]] = []
    for k in range(begin, end):
        p = pieces.points[first[k] : first[k + 1], :2]
        drawn = (pieces.sides[first[k] : first[k + 1]] > 0) != seam
        if bridges is not None:
            drawn &= ~_lies_on(np.stack([np.roll(p, 1, axis=0), p], axis=1), bridges)
        if not drawn.any():
            continue
        if drawn.all():
            points += [p, p[:1]]
            codes.append(np.full(len(p) + 1, Path.LINETO, Path.code_type))
            codes[-1][-1] = Path.CLOSEPOLY
        else:
            turn = -int(np.flatnonzero(~drawn)[0])
            points.append(np.roll(p, turn, axis=0))
            codes.append(np.where(np.roll(drawn, turn), Path.LINETO, Path.MOVETO))
        codes[-1][0] = Path.MOVETO
    return Path(np.concatenate(points), np.concatenate(codes)) if points else None


def _lies_on(segments: Floats, lines: Floats) -> npt.NDArray[np.bool_]:
    """Whether each segment, (n, 2, 2), lies on one of the lines, (m, 2, 2), to rounding."""
    along = (lines[:, 1] - lines[:, 0])[None, None]
    to = segments[:, :, None] - lines[None, None, :, 0]
    length = np.maximum(np.abs(along).sum(axis=3), 1e-300)
    off = np.abs(to[..., 0] * along[..., 1] - to[..., 1] * along[..., 0]) / length
    t = (to * along).sum(axis=3) / np.maximum((along * along).sum(axis=3), 1e-300)
    return ((off < 1e-9) & (t > -1e-9) & (t < 1 + 1e-9)).all(axis=1).any(axis=1)  # type: ignore


def _add_polylines(
    ax: Axes3D, lines: _Lines, parts: Floats, item: Indices, styles: _Styles, paths: _Paths
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


def _lengths_on_paper(ax: Axes3D, lines: _Lines) -> Floats:
    """For each segment how long its polyline is before it, in points."""
    ends = ax.transData.transform(lines.segments[:, :, :2].reshape(-1, 2)).reshape(-1, 2, 2)
    length = np.hypot(*(ends[:, 1] - ends[:, 0]).T) * 72.0 / ax.figure.dpi
    before = np.concatenate([[0.0], np.cumsum(length)[:-1]])
    starts = np.flatnonzero(np.concatenate([[True], lines.line[1:] != lines.line[:-1]]))
    lengths: Floats = before - np.repeat(
        before[starts], np.diff(np.append(starts, len(lines.line)))
    )
    return lengths


# ---- Markers -----------------------------------------------------------------------------------


class _Markers(Collection):
    """Stands for a scatter while the axes are drawn, without the markers that are hidden."""

    def __init__(self, scene: _Scene, artist: Any) -> None:
        super().__init__()
        self.axes = scene.axes
        self.set_figure(scene.figure)
        self.set_zorder(artist.get_zorder())
        self.set_rasterized(artist.get_rasterized())
        self._scene, self._artist = scene, artist

    def do_3d_projection(self) -> float:
        depth: float = self._artist.do_3d_projection()
        private.hide_markers(self._artist, self._scene.hidden[self._artist])
        return depth

    def draw(self, renderer: Any) -> None:
        tint = private.in_order(self._artist, self._scene.tints[self._artist])
        if (tint[:, 3] == 1.0).all():
            self._artist.draw(renderer)
            return
        artist = self._artist
        artist.update_scalarmappable()
        copy = PathCollection(
            artist.get_paths(),
            facecolors=_tinted(artist.get_facecolor(), tint),
            edgecolors=_tinted(artist.get_edgecolor(), tint),
            linewidths=artist.get_linewidth(),
            linestyles=artist.get_linestyle(),
            antialiaseds=private.antialiased(artist),
            offsets=artist.get_offsets(),
            offset_transform=artist.get_offset_transform(),
        )
        copy.axes = self.axes
        copy.set_figure(self.figure)
        copy.set_transform(artist.get_transform())
        if hasattr(artist, "get_sizes"):
            copy.set_sizes(artist.get_sizes(), self.figure.dpi)
        _style_of(artist, *private.cap_and_join(artist)).give(copy)
        copy.draw(renderer)


def _tinted(colours: Any, tint: Floats) -> Floats:
    rgba = to_rgba_array(colours)
    if not len(rgba):
        return rgba  # type: ignore[no-any-return]
    rgba = _cycled(rgba, len(tint), 4).copy()
    rgba[:, :3] = tint[:, :3] + tint[:, 3:] * rgba[:, :3]
    return rgba.clip(0.0, 1.0)  # type: ignore[no-any-return]
