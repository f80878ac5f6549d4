"""A scene of several artists, drawn in the place of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import rcParams
from matplotlib.collections import Collection, PathCollection
from matplotlib.colors import to_rgba_array
from matplotlib.lines import Line2D
from matplotlib.path import Path
from mpl_toolkits.mplot3d import Axes3D, art3d

from . import _displayfile
from . import _matplotlib_private as private
from ._matplotlib_artists import (
    Lines,
    Polygons,
    Styles,
    add_line,
    add_lines,
    add_patch,
    add_polygons,
    cycled,
    projected,
    rounding_of_projected,
    style_of,
)
from ._matplotlib_crop import Crop
from ._matplotlib_ends import with_cut_corners
from ._matplotlib_paths import Paths, add_pieces, add_polylines
from ._polygons import sort, visible_lines

if TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

_CELLS = 64
"""Of a grid over the picture, in each direction."""
_MARKER = 1e-9
_NEARER = 1e-6
"""Half the length of the line that stands for a marker, in widths of the scene."""

_SCATTERS = (art3d.Path3DCollection, art3d.Patch3DCollection)
_TAKEN = (
    art3d.Poly3DCollection,
    art3d.Line3DCollection,
    art3d.Line3D,
    art3d.Patch3D,
    *_SCATTERS,
)


def is_scatter(artist: Any) -> bool:
    return isinstance(artist, _SCATTERS)


def is_taken(artist: Any) -> bool:
    return (
        isinstance(artist, _TAKEN)
        and artist.get_visible()
        and not artist.get_animated()
        and not private.is_clipped_to_limits(artist)
    )


class Scene(Collection):  # type: ignore[misc]
    """Draws the polygons and lines of several artists, and tells which markers are hidden."""

    def __init__(
        self,
        ax: Axes3D,
        artists: list[Any],
        method: str,
        lift: float,
        line_order: str,
        halo: float,
        clip: bool,
    ) -> None:
        super().__init__()
        self.axes = ax
        self.set_figure(ax.figure)
        self.set_zorder(min(a.get_zorder() for a in artists))
        self.hidden: dict[Any, npt.NDArray[np.bool_]] = {}
        self.tints: dict[Any, Floats] = {}
        """What covers each marker: a colour, and how much of the marker's is left."""
        self._artists, self._method, self._lift = artists, method, lift
        self._by_depth, self._halo = line_order == "depth", halo
        self._clip = clip
        self._runs: list[PathCollection] = []

    def do_3d_projection(self) -> float:
        matrix = self.axes.M
        limits = np.reshape(self.axes.get_w_lims(), (3, 2))
        crop = Crop(limits) if self._clip else None
        polygons, lines, styles = Polygons(), Lines(), Styles()
        markers: list[Floats] = [np.zeros((0, 3))]
        marked: list[Any] = []
        for artist in self._artists:
            if isinstance(artist, art3d.Poly3DCollection):
                add_polygons(artist, matrix, polygons, styles, crop)
            elif isinstance(artist, art3d.Patch3D):
                private.project_patch(artist)
                add_patch(artist, matrix, polygons, styles, crop)
            elif isinstance(artist, art3d.Line3DCollection):
                add_lines(artist, matrix, lines, styles, crop)
            elif isinstance(artist, art3d.Line3D):
                add_line(artist, matrix, lines, styles, crop)
                if _has_markers(artist):
                    marked.append(artist)
                    markers.append(_places(private.line_points(artist), matrix, crop))
            else:
                marked.append(artist)
                markers.append(_places(private.marker_points(artist), matrix, crop))
        polygons.finish()
        lines.finish()
        paths = Paths()
        self._find(polygons, lines, np.concatenate(markers), styles, paths)
        ends = np.cumsum([len(m) for m in markers[1:]], dtype=np.int64)
        for k, artist in enumerate(marked):
            begin = ends[k] - len(markers[k + 1])
            self.hidden[artist] = self._is_hidden[begin : ends[k]]
            self.tints[artist] = self._tint[begin : ends[k]]
        self._make_runs(paths, styles)
        return np.inf  # Drawn before all other artists whose order is computed.

    def _find(
        self, polygons: Polygons, lines: Lines, markers: Floats, styles: Styles, paths: Paths
    ) -> None:
        self._is_hidden = ~np.isfinite(markers).all(axis=1)
        self._tint = np.tile([0.0, 0.0, 0.0, 1.0], (len(markers), 1))
        whole_line = lines.segments, np.arange(len(lines.segments))
        if polygons.attributes is None:
            uncut = np.zeros((len(lines.segments), 2), bool)
            drawn = self._in_line_order(lines, *whole_line, uncut)
            add_polylines(self.axes, lines, *drawn, styles, paths)
            return
        opaque = polygons.is_opaque()
        low, high = polygons.points.min(axis=0), polygons.points.max(axis=0)
        size = np.where(high > low, high - low, 1.0)
        raised = np.array([0.0, 0.0, size[2] * self._lift])
        limits = np.reshape(self.axes.get_w_lims(), (3, 2))
        touching = 16 * rounding_of_projected(limits, self.axes.M)

        # What opaque polygons hide is left out.
        shown = np.flatnonzero(~self._is_hidden)
        half = np.array([size[0] * _MARKER, 0.0, 0.0])
        # A marker's place is a line as short as that, which must not dip into a surface.
        places = markers[shown] + np.maximum(raised, [0.0, 0.0, size[2] * _NEARER])
        segments = np.concatenate(
            [lines.segments + raised, np.stack([places - half, places + half], axis=1)]
        )
        parts, item, cuts = _parts_seen(polygons.some(opaque), segments, touching)
        # What is behind translucent polygons is sorted with them; what is not is drawn last.
        count = len(lines.segments)
        is_line = item < count
        cuts[is_line] = with_cut_corners(lines, item[is_line], cuts[is_line])
        behind = _is_behind(polygons.some(~opaque), parts, touching) if not opaque.all() else None
        if behind is not None:
            parts, of_parts, behind_part, more_cuts = behind
            item, cuts = item[of_parts], cuts[of_parts] | more_cuts
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
            touching=touching,
        )

        def beside(parts: Floats) -> tuple[Floats, Indices]:
            nearer = np.array([0.0, 0.0, size[2] * _NEARER])
            near = polygons.some(_near(polygons, parts[..., :2]))
            seen, of, _ = _parts_seen(near, parts + nearer, touching)
            return seen, of

        of_item = np.full(len(polygons.sides) + len(sorted_too), -1)
        of_item[len(polygons.sides) :] = item[sorted_too]
        add_pieces(
            self.axes, polygons, pieces, lines, of_item, cuts[sorted_too], styles, paths, beside
        )
        is_marker = of_item[pieces.item] >= count
        if is_marker.any():
            self._tint_markers(polygons, pieces, of_item - count, is_marker, markers, shown)
        on_top = ~behind_part & ~of_marker
        drawn = self._in_line_order(lines, parts[on_top] - raised, item[on_top], cuts[on_top])
        add_polylines(self.axes, lines, *drawn, styles, paths)

    def _in_line_order(
        self, lines: Lines, parts: Floats, item: Indices, cuts: npt.NDArray[np.bool_]
    ) -> tuple[Floats, Indices, npt.NDArray[np.bool_]]:
        """Parts of segments, of which each is one, and their cut ends, in the order of drawing."""
        if not self._by_depth or lines.attributes is None or len(item) < 2:
            return parts, item, cuts
        line = lines.line[item]
        corners = self.axes.transData.transform([(0.0, 0.0), (1.0, 1.0)])
        pixels_of_point = self.axes.figure.dpi / 72.0
        limits = np.reshape(self.axes.get_w_lims(), (3, 2))
        of, points, cut = _displayfile._segments_by_depth(
            parts,
            lines.attributes.width[line] * pixels_of_point,
            line,
            np.abs(corners[1] - corners[0]),
            self._halo * pixels_of_point,
            16 * rounding_of_projected(limits, self.axes.M),
        )
        points = points.reshape(-1, 2, 3)
        is_end = points == parts[of]
        own = cuts[of] & is_end.all(axis=2)
        return points, item[of], cut.reshape(-1, 2).astype(bool) | own

    def _tint_markers(
        self,
        polygons: Polygons,
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

    def _make_runs(self, paths: Paths, styles: Styles) -> None:
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
        xy = projected(private.line_points(artist), self.axes.M)[:, :2]
        xy[self.hidden[artist]] = np.nan
        line = Line2D([], [])
        line.update_from(artist)
        line.axes = self.axes
        line.set_figure(self.figure)
        line.set_linestyle("none")
        line.set_markevery(artist.get_markevery())
        line.set_data(xy.T)
        line.draw(renderer)


def _places(points: Floats, matrix: Floats, crop: Crop | None) -> Floats:
    return projected(points if crop is None else crop.markers(points), matrix)


def _has_markers(artist: Any) -> bool:
    return artist.get_marker() not in ("None", "none", " ", "", None)


def _unscaled(pattern: Any, scale: float) -> Any:
    offset, dashes = pattern
    if dashes is None:
        return "solid"
    return offset / scale, [d / scale for d in dashes]


def _near(polygons: Polygons, segments: Floats) -> npt.NDArray[np.bool_]:
    """Which polygons' extents meet those of segments, (n, 2, 2), on a grid of cells."""
    if not len(segments):
        return np.zeros(len(polygons.sides), bool)
    first = np.cumsum(polygons.sides) - polygons.sides
    xy = polygons.points[:, :2]
    low, high = xy.min(axis=0), xy.max(axis=0)
    scale = _CELLS / np.where(high > low, high - low, 1.0)

    def cells(points: Floats) -> Indices:
        return np.asarray(((points - low) * scale).clip(0, _CELLS - 1), np.int64)

    changes = np.zeros((_CELLS + 1, _CELLS + 1), np.int64)
    (x0, y0), (x1, y1) = cells(segments.min(axis=1)).T, cells(segments.max(axis=1)).T + 1
    for x, y, sign in ((x0, y0, 1), (x1, y1, 1), (x0, y1, -1), (x1, y0, -1)):
        np.add.at(changes, (x, y), sign)
    is_met = changes.cumsum(axis=0).cumsum(axis=1)[:-1, :-1] > 0
    sums = np.zeros((_CELLS + 1, _CELLS + 1), np.int64)
    sums[1:, 1:] = is_met.cumsum(axis=0).cumsum(axis=1)
    x0, y0 = cells(np.minimum.reduceat(xy, first)).T
    x1, y1 = cells(np.maximum.reduceat(xy, first)).T + 1
    return np.asarray(sums[x1, y1] - sums[x0, y1] - sums[x1, y0] + sums[x0, y0] > 0)


def _parts_seen(
    polygons: tuple[Floats, Indices], segments: Floats, touching: float
) -> tuple[Floats, Indices, npt.NDArray[np.bool_]]:
    """The parts of segments that are seen, in the order of the segments and along them, of which each
    is a part, and which of its ends are cut."""
    points, sides = polygons
    if not len(sides) or not len(segments):
        return segments, np.arange(len(segments)), np.zeros((len(segments), 2), bool)
    seen = visible_lines(points, sides=sides, segments=segments, touching=touching)
    order = _order_along(segments, seen.points, seen.item)
    return seen.points[order], seen.item[order].astype(np.int64), seen.cuts[order]


def _is_behind(
    polygons: tuple[Floats, Indices], segments: Floats, touching: float
) -> tuple[Floats, Indices, npt.NDArray[np.bool_], npt.NDArray[np.bool_]] | None:
    """The parts of segments that polygons are before, and those that none is before; likewise."""
    points, sides = polygons
    if not len(segments):
        return None
    seen = visible_lines(points, sides=sides, segments=segments, hidden=True, touching=touching)
    order = _order_along(segments, seen.points, seen.item)
    item = seen.item[order].astype(np.int64)
    return seen.points[order], item, seen.hidden[order], seen.cuts[order]


def _order_along(segments: Floats, parts: Floats, item: Any) -> Indices:
    from_start = np.abs(parts[:, 0] - segments[item, 0]).sum(axis=1)
    return np.asarray(np.lexsort((from_start, item)))


class Markers(Collection):  # type: ignore[misc]
    """Stands for a scatter while the axes are drawn, without the markers that are hidden."""

    def __init__(self, scene: Scene, artist: Any) -> None:
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
            offsets=private.drawn_offsets(artist),
            offset_transform=artist.get_offset_transform(),
        )
        copy.axes = self.axes
        copy.set_figure(self.figure)
        copy.set_transform(artist.get_transform())
        if hasattr(artist, "get_sizes"):
            copy.set_sizes(artist.get_sizes(), self.figure.dpi)
        style_of(artist, *private.cap_and_join(artist)).give(copy)
        if len(artist.get_urls()) > 1:
            copy.set_urls(artist.get_urls())
        copy.draw(renderer)


def _tinted(colours: Any, tint: Floats) -> Floats:
    rgba = to_rgba_array(colours)
    if not len(rgba):
        return rgba  # type: ignore[no-any-return]
    rgba = cycled(rgba, len(tint), 4).copy()
    rgba[:, :3] = tint[:, :3] + tint[:, 3:] * rgba[:, :3]
    return rgba.clip(0.0, 1.0)  # type: ignore[no-any-return]
