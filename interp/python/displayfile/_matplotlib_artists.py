"""From matplotlib's artists to the polygons and lines of a scene, in the axes' projection."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.collections import Collection, PathCollection
from matplotlib.colors import to_rgba
from matplotlib.path import Path

from . import _matplotlib_private as private

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from ._matplotlib_crop import Crop

    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]

_CURVE_PARTS = 16
_CLEAR = np.zeros(4)


class Style(NamedTuple):
    """What a collection has once for all of its paths."""

    clip_on: bool
    clip_box: Any
    clip_path: Any
    cap: Any
    join: Any
    hatch: Any
    hatch_colour: Any
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
        if self.hatch:
            c.set_hatch(self.hatch)
            private.set_hatch_colour(c, self.hatch_colour)
        c.set_sketch_params(*(self.sketch or (None,)))
        c.set_path_effects(self.effects)
        c.set_snap(self.snap)
        c.set_gid(self.gid)
        if self.url is not None:
            # One alone is not written of a single path, nor one that set_url sets.
            c.set_urls([self.url, self.url])
        c.set_rasterized(self.rasterized)
        c.set_agg_filter(self.agg_filter)


def style_of(artist: Any, cap: Any, join: Any) -> Style:
    hatch = artist.get_hatch() if hasattr(artist, "get_hatch") else None
    return Style(
        artist.get_clip_on(),
        artist.get_clip_box(),
        artist.get_clip_path(),
        cap,
        join,
        hatch,
        private.hatch_colour(artist) if hatch else None,
        artist.get_sketch_params(),
        tuple(artist.get_path_effects() or ()),
        artist.get_snap(),
        artist.get_gid(),
        _url_of(artist),
        artist.get_rasterized(),
        artist.get_agg_filter(),
    )


def _url_of(artist: Any) -> Any:
    """Of all its parts: a collection may have several, of which a part keeps none."""
    if not isinstance(artist, Collection):
        return artist.get_url()
    urls = {url for url in artist.get_urls() if url is not None}
    if len(urls) > 1 and not isinstance(artist, PathCollection):
        warnings.warn(
            f"exact: {len(urls)} urls of one {type(artist).__name__} are left out: expected set_url, "
            "or artists of their own",
            stacklevel=2,
        )
        return None
    return urls.pop() if len(urls) == 1 else artist.get_url()


class Styles:
    """The styles and dashes of a scene, each once."""

    def __init__(self) -> None:
        self.styles: list[Style] = []
        self._keys: list[Any] = []
        self.dashes: list[Any] = [(0, None)]

    def style(self, style: Style) -> int:
        box = style.clip_box and tuple(style.clip_box.get_points().ravel())
        path = style.clip_path and style.clip_path.get_fully_transformed_path()
        outline = path and (path.vertices.tolist(), path.codes is not None and path.codes.tolist())
        key = (box, outline, style._replace(clip_box=None, clip_path=None))
        if key not in self._keys:
            self._keys.append(key)
            self.styles.append(style)
        return self._keys.index(key)

    def unhatched(self, which: Indices) -> Indices:
        """The same styles without hatching: of strokes."""
        same = [self.style(s._replace(hatch=None, hatch_colour=None)) for s in self.styles[:]]
        return np.array(same, np.int64)[which]

    def butt(self, which: int) -> int:
        """The same style without caps."""
        return self.style(self.styles[which]._replace(cap="butt"))

    def dash(self, pattern: Any) -> int:
        if pattern not in self.dashes:
            self.dashes.append(pattern)
        return self.dashes.index(pattern)


class Attributes(NamedTuple):
    """What each polygon, or each polyline, looks like."""

    face: Floats
    edge: Floats
    width: Floats
    antialiased: npt.NDArray[np.bool_]
    dash: Indices
    style: Indices

    def of(self, which: Any) -> Attributes:
        return Attributes(*(column[which] for column in self))


def cycled(values: Any, n: int, *shape: int) -> Any:
    """What a collection of n has of values that may be fewer, or none."""
    array = np.asarray(values)
    if len(array) == n:
        return array
    return np.resize(array, (n, *shape)) if len(array) else np.zeros((n, *shape))


def _attributes(
    styles: Styles,
    n: int,
    face: Any,
    edge: Any,
    width: Any,
    antialiased: Any,
    patterns: Sequence[Any],
    style: Style,
) -> Attributes:
    dashes = [styles.dash((p[0], None if p[1] is None else tuple(p[1]))) for p in patterns]
    return Attributes(
        cycled(face, n, 4),
        cycled(edge, n, 4),
        cycled(np.atleast_1d(width), n).astype(float),
        cycled(np.atleast_1d(antialiased), n).astype(bool),
        cycled(dashes or [0], n).astype(np.int64),
        np.full(n, styles.style(style)),
    )


def joined(columns: list[Attributes]) -> Attributes:
    return Attributes(*(np.concatenate(column) for column in zip(*columns)))


def projected(points: Floats, matrix: Floats) -> Floats:
    """In the axes' projection, with a larger z nearer; nan for what is not before the eye.

    Each coordinate is a sum in one order, so that equal points are equal afterwards.
    """
    x, y, z = points.T
    rows = [m[0] * x + m[1] * y + m[2] * z + m[3] for m in matrix]
    w = np.where(rows[3] > 0.0, rows[3], np.nan)
    return np.column_stack([rows[0] / w, rows[1] / w, -rows[2] / w])


def rounding_of_projected(limits: Floats, matrix: Floats) -> float:
    """How far projected moves points within the axes' limits (3, 2), about: as much as the terms of
    its sums are rounded. That is much on axes of dates, whose numbers are large against a picture.
    """
    magnitude = np.abs(matrix[:, :3]) @ np.abs(limits).max(axis=1) + np.abs(matrix[:, 3])
    w = abs(matrix[3, :3] @ limits.mean(axis=1) + matrix[3, 3])
    return float(4 * 2.0**-53 * (magnitude[:3].max() + magnitude[3]) / w)


class Polygons:
    """The polygons of a scene. Polygon k has the corners from first[k] to first[k + 1]."""

    def __init__(self) -> None:
        self.points: Floats = np.zeros((0, 3))
        self.sides: Indices = np.zeros(0, np.int64)
        self.bridges: dict[int, Floats] = {}
        """The sides that are not drawn, (n, 2, 2): those that join rings, or close open ones."""
        self.attributes: Attributes | None = None
        self._points: list[Floats] = []
        self._sides: list[Indices] = []
        self._attributes: list[Attributes] = []

    def add(
        self,
        points: Floats,
        sides: Indices,
        attributes: Attributes,
        is_cut: npt.NDArray[np.bool_] | None = None,
    ) -> None:
        """Leaves out polygons of fewer than 3 corners, or with one that is not finite. Sides that
        end at a point of which is_cut is True are not drawn."""
        first = np.concatenate([[0], np.cumsum(sides)])
        bad = np.concatenate([[0], np.cumsum(~np.isfinite(points).all(axis=1))])
        good = (sides >= 3) & (bad[first[1:]] == bad[first[:-1]])
        if not good.all():
            kept = np.repeat(good, sides)
            points = points[kept]
            is_cut = None if is_cut is None else is_cut[kept]
            attributes = attributes.of(good)
            sides = sides[good]
        if is_cut is not None and is_cut.any():
            self._hide_sides(points, sides, is_cut)
        self._points.append(points)
        self._sides.append(sides)
        self._attributes.append(attributes)

    def _hide_sides(
        self, points: Floats, sides: Indices, is_cut: npt.NDArray[np.bool_]
    ) -> None:
        count = sum(len(of) for of in self._sides)
        first = np.concatenate([[0], np.cumsum(sides)])
        for k in np.unique(np.repeat(np.arange(len(sides)), sides)[is_cut]).tolist():
            own = points[first[k] : first[k + 1], :2]
            ends = np.stack([np.roll(own, 1, axis=0), own], axis=1)
            self.bridges[count + k] = ends[is_cut[first[k] : first[k + 1]]]

    def add_rings(
        self,
        rings: list[tuple[Floats, bool]],
        attributes: Attributes,
        cuts: list[Floats] | None = None,
    ) -> None:
        """One polygon of several rings, of which the others are holes; closed or not each. `cuts`,
        (n, 2, 2) each, are sides that are not drawn."""
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
        bridges += [side for of_ring in cuts or [] for side in of_ring]
        if bridges:
            self.bridges[sum(len(sides) for sides in self._sides)] = np.array(bridges)
        self.add(outline, np.array([len(outline)]), attributes)

    def finish(self) -> None:
        """Joins all that was added. Where no polygon is left, attributes stays None."""
        if not any(len(sides) for sides in self._sides):
            return
        self.points = np.concatenate(self._points)
        self.sides = np.concatenate(self._sides)
        self.attributes = joined(self._attributes)

    def some(self, which: npt.NDArray[np.bool_]) -> tuple[Floats, Indices]:
        return self.points[np.repeat(which, self.sides)], self.sides[which]

    def is_opaque(self) -> npt.NDArray[np.bool_]:
        return np.zeros(0, bool) if self.attributes is None else self.attributes.face[:, 3] >= 1.0


class Lines:
    """The polylines of a scene, as segments."""

    def __init__(self) -> None:
        self.segments: Floats = np.zeros((0, 2, 3))
        self.line: Indices = np.zeros(0, np.int64)
        """The polyline of each segment."""
        self.attributes: Attributes | None = None
        self._segments: list[Floats] = []
        self._line: list[Indices] = []
        self._attributes: list[Attributes] = []
        self._count = 0

    def add(
        self,
        points: Floats,
        lengths: Indices,
        attributes: Attributes,
        matrix: Floats,
        crop: Crop | None,
    ) -> None:
        """Polylines in data coordinates."""
        line = np.repeat(np.arange(len(lengths)), lengths)
        segments = np.stack([points[:-1], points[1:]], axis=1)
        good = line[1:] == line[:-1]
        if crop is not None:
            segments, is_outside = crop.segments(segments)
            good &= ~is_outside
        segments = projected(segments.reshape(-1, 3), matrix).reshape(-1, 2, 3)
        good &= np.isfinite(segments).all(axis=(1, 2))
        self._segments.append(segments[good])
        self._line.append(line[1:][good] + self._count)
        self._attributes.append(attributes)
        self._count += len(lengths)

    def finish(self) -> None:
        if not self._line:
            return
        self.segments = np.concatenate(self._segments)
        self.line = np.concatenate(self._line)
        self.attributes = joined(self._attributes)


def add_polygons(
    artist: Any, matrix: Floats, polygons: Polygons, styles: Styles, crop: Crop | None
) -> None:
    corners, sides = private.polygons(artist)
    face, edge = private.colours(artist)
    n = len(sides)
    face = cycled(face, n, 4)
    style = style_of(artist, *private.cap_and_join(artist))
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
    codes = private.codes(artist)
    if codes is None and private.is_closed(artist):
        if crop is None:
            polygons.add(projected(corners, matrix), sides, attributes)
            return
        left = crop.polygons(corners, sides)
        points = projected(left.points, matrix)
        polygons.add(points, left.sides, attributes.of(left.of), left.is_cut)
        return
    for k, own in enumerate(np.split(corners, np.cumsum(sides)[:-1]) if n else []):
        of_own = None if codes is None else codes[k]
        _add_rings(own, of_own, matrix, polygons, attributes.of([k]), crop)


def _add_rings(
    points: Floats,
    codes: Any,
    matrix: Floats,
    polygons: Polygons,
    attributes: Attributes,
    crop: Crop | None,
) -> None:
    """The rings of a path in data coordinates."""
    if crop is None:
        polygons.add_rings(_rings(projected(points, matrix), codes), attributes)
        return
    rings: list[tuple[Floats, bool]] = []
    cuts: list[Floats] = []
    for ring, closed in _rings(points, codes):
        left = crop.polygons(ring, np.array([len(ring)]))
        if len(left.sides):
            own = projected(left.points, matrix)
            rings.append((own, closed))
            cuts.append(np.stack([np.roll(own, 1, axis=0), own], axis=1)[left.is_cut, :, :2])
    polygons.add_rings(rings, attributes, cuts)


def _rings(points: Floats, codes: Any) -> list[tuple[Floats, bool]]:
    """The rings of a path, (n, 3) each, and whether it closes them. Curves become polygons."""
    if codes is None:
        return [_without_repeats(points, False)]
    codes = np.asarray(codes)
    rings: list[tuple[Floats, bool]] = []
    first = 0
    ends = np.flatnonzero(np.isin(codes, (Path.MOVETO, Path.CLOSEPOLY, Path.STOP)))
    for end in [*ends.tolist(), len(codes)]:
        code = codes[end] if end < len(codes) else Path.STOP
        if first < end:
            ring = _straightened(points[first:end], codes[first:end])
            rings.append(_without_repeats(ring, bool(code == Path.CLOSEPOLY)))
        first = end if code == Path.MOVETO else end + 1
    return rings


def _straightened(points: Floats, codes: Any) -> Floats:
    """A ring whose curves are polygons."""
    if not np.isin(codes, (Path.CURVE3, Path.CURVE4)).any():
        return points
    ring: list[Floats] = []
    k = 0
    while k < len(codes):
        degree = {Path.CURVE3: 2, Path.CURVE4: 3}.get(int(codes[k]), 1)
        if degree == 1 or not ring:
            ring.append(points[k : k + 1])
        else:
            ring.append(_curve(np.concatenate([ring[-1][-1:], points[k : k + degree]])))
        k += degree
    return np.concatenate(ring)


def _without_repeats(ring: Floats, closed: bool) -> tuple[Floats, bool]:
    """Without points like the one before; a ring that ends where it begins is closed."""
    if not len(ring):
        return ring, closed
    ring = ring[np.concatenate([[True], (ring[1:] != ring[:-1]).any(axis=1)])]
    if len(ring) > 1 and (ring[0] == ring[-1]).all():
        return ring[:-1], True
    return ring, closed


def _curve(controls: Floats) -> Floats:
    """Points of a Bezier curve, without its first."""
    t: Any = np.arange(1, _CURVE_PARTS + 1)[:, None] / _CURVE_PARTS
    points: Floats = np.repeat(controls[:, None], _CURVE_PARTS, axis=1)
    while len(points) > 1:
        points = points[:-1] * (1.0 - t) + points[1:] * t
    return np.asarray(points[0])


def add_patch(
    artist: Any, matrix: Floats, polygons: Polygons, styles: Styles, crop: Crop | None
) -> None:
    corners, codes = private.patch_points(artist)
    attributes = _attributes(
        styles,
        1,
        [artist.get_facecolor()],
        [artist.get_edgecolor()],
        artist.get_linewidth(),
        artist.get_antialiased(),
        [private.dashes(artist)],
        style_of(artist, artist.get_capstyle(), artist.get_joinstyle()),
    )
    _add_rings(corners, codes, matrix, polygons, attributes, crop)


def add_lines(
    artist: Any, matrix: Floats, lines: Lines, styles: Styles, crop: Crop | None
) -> None:
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
        style_of(artist, *private.cap_and_join(artist)),
    )
    lengths = np.array([len(p) for p in polylines])
    lines.add(np.concatenate(polylines), lengths, attributes, matrix, crop)


def add_line(
    artist: Any, matrix: Floats, lines: Lines, styles: Styles, crop: Crop | None
) -> None:
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
        style_of(
            artist,
            getattr(artist, f"get_{kind}_capstyle")(),
            getattr(artist, f"get_{kind}_joinstyle")(),
        ),
    )
    lines.add(points, np.array([len(points)]), attributes, matrix, crop)
