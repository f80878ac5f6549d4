"""Judges pictures of mplot3d's axes by casting a ray through the centre of every pixel.

It shares nothing with displayfile.matplotlib: it reads the artists' own vertices and colours, takes
the axes' projection, and finds what a ray meets. Left out are pixels near edges, lines, markers and
texts that are not hidden.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from matplotlib.colors import to_rgba
from matplotlib.path import Path
from mpl_toolkits.mplot3d import art3d

Array = np.ndarray[Any, Any]

NEAR = 1.5
"""Pixels: what is this near to an edge or a line is not judged."""
TIE = 1e-7
"""Depths that differ less are equal: then the artist added last is visible."""
STEP = 0.35
"""Pixels between the samples of an edge."""


class Face(NamedTuple):
    rings: list[Array]
    """Of points (n, 3) in pixels and depths, larger ones farther."""
    colour: Array
    margin: float
    """Half the width of the edges that are drawn, in pixels."""


class Stroke(NamedTuple):
    points: Array
    colour: Array | None
    """None if it is dashed or translucent: then only its surroundings are left out."""
    half: float


class Verdict(NamedTuple):
    judged: int
    """Pixels of polygons and lines; those of the background do not count."""
    lines: int
    wrong: int
    worst: int
    """The largest difference of a channel, of 255."""


def judge(ax: Any, picture: Array, tolerance: int = 2) -> Verdict:
    """`picture`, (height, width, 3), of axes that are switched off, on white. A channel may differ by
    the tolerance, and by one more for each translucent polygon before a pixel: each is rounded."""
    scene = _Scene(ax, *picture.shape[:2])
    expected, is_known = scene.colours()
    judged = is_known & scene.away_from_edges(expected) & scene.inside()
    strokes, is_line = scene.lines(expected)
    judged &= scene.clear
    off = np.abs(picture.astype(int) - expected).max(axis=2)
    off = np.where(judged, np.maximum(off - scene.translucent, 0), 0)
    line_off = np.abs(picture.astype(int) - strokes).max(axis=2)
    line_off = np.where(is_line & scene.inside(), line_off, 0)
    shown = judged & (scene.count > 0)
    wrong = int((off > tolerance).sum() + (line_off > tolerance).sum())
    return Verdict(int(shown.sum()), int(is_line.sum()), wrong, int(max(off.max(), line_off.max())))


class _Scene:
    def __init__(self, ax: Any, height: int, width: int) -> None:
        self.ax, self.shape = ax, (height, width)
        self.clear = np.ones(self.shape, bool)
        self.faces = [face for artist in ax.get_children() for face in self.faces_of(artist)]

    # ---- What the artists are ----------------------------------------------------------------

    def placed(self, points: Any) -> Array:
        """Points of data, (n, 3), as pixels and depths."""
        points = np.asarray(points, float).reshape(-1, 3)
        x, y, z, w = self.ax.get_proj() @ np.column_stack([points, np.ones(len(points))]).T
        xy = self.ax.transData.transform(np.column_stack([x / w, y / w]))
        return np.column_stack([xy[:, 0], self.shape[0] - xy[:, 1], z / w])

    def pixels_of(self, points: Any) -> float:
        return float(np.max(points)) * self.ax.figure.dpi / 72.0

    def faces_of(self, artist: Any) -> list[Face]:
        if isinstance(artist, art3d.Poly3DCollection):
            return self.faces_of_collection(artist)
        if isinstance(artist, art3d.Patch3D):
            points, codes = artist._segment3d, getattr(artist, "_code3d", None)
            has_edge = to_rgba(artist.get_edgecolor())[3] > 0
            margin = self.pixels_of(artist.get_linewidth()) / 2 if has_edge else 0.0
            rings = _rings(self.placed([[float(v) for v in p] for p in points]), codes)
            return [Face(rings, np.array(artist.get_facecolor()), margin)]
        return []

    def faces_of_collection(self, artist: Any) -> list[Face]:
        if artist.get_array() is not None:
            artist.update_scalarmappable()
        colours = artist._facecolors if artist.get_array() is not None else artist._facecolor3d
        edges = artist._edgecolor3d
        margin = 0.0
        if len(edges) and np.asarray(edges)[:, 3].max() > 0:
            margin = self.pixels_of(artist.get_linewidth()) / 2
        found = []
        for k, part in enumerate(artist._segslices):
            points = self.placed(artist._vec[:3, part].T)
            codes = None if artist._codes3d is None else artist._codes3d[k]
            if len(points) >= 3 and np.isfinite(points).all():
                found.append(Face(_rings(points, codes), colours[k % len(colours)], margin))
        return found

    def strokes(self) -> list[Stroke]:
        found = []
        for artist in self.ax.get_children():
            if isinstance(artist, art3d.Line3DCollection):
                colours, widths = artist.get_edgecolor(), artist.get_linewidth()
                for k, line in enumerate(artist._segments3d):
                    half = self.pixels_of(widths[k % len(widths)]) / 2
                    plain = artist.get_linestyle()[0][1] is None
                    colour = colours[k % len(colours)]
                    opaque = colour if plain and colour[3] == 1 else None
                    found.append(Stroke(self.placed(line), opaque, half))
            elif isinstance(artist, art3d.Line3D):
                points = self.placed(np.column_stack(np.broadcast_arrays(*artist._verts3d)))
                if artist.get_linestyle() not in ("None", "none", "", " "):
                    colour = to_rgba(artist.get_color())
                    opaque = np.array(colour) if artist.get_linestyle() == "-" else None
                    half = self.pixels_of(artist.get_linewidth()) / 2
                    found.append(Stroke(points, opaque, half))
                if artist.get_marker() not in ("None", "none", "", " "):
                    half = self.pixels_of(artist.get_markersize()) * 0.75 + 1
                    found += [Stroke(p[None], None, half) for p in points]
            elif isinstance(artist, art3d.Path3DCollection):
                half = self.pixels_of(np.sqrt(artist.get_sizes())) * 0.75 + 2
                points = np.column_stack([np.asarray(v, float) for v in artist._offsets3d])
                found += [Stroke(p[None], None, half) for p in self.placed(points)]
        return found

    # ---- What the rays meet ------------------------------------------------------------------

    def colours(self) -> tuple[Array, Array]:
        """What colour each pixel has, and whether that does not depend on how polygons bend."""
        ways = [self.composed(way) for way in (0, 1)]
        self.deepest = np.maximum(ways[0][1], ways[1][1])
        self.nearest = np.minimum(ways[0][2], ways[1][2])
        self.count, self.translucent = ways[0][3:]
        same = np.abs(ways[0][0] - ways[1][0]).max(axis=2) < 0.5
        return np.rint(ways[0][0]).astype(int), same

    def composed(self, way: int) -> tuple[Array, Array, Array, Array, Array]:
        """The colours, the depth of the nearest opaque polygon, that of the nearest one, how many
        each ray meets, and how many translucent ones. Bent polygons bend in one `way` of two."""
        parts = [self.met(k, face, way) for k, face in enumerate(self.faces)]
        size = self.shape[0] * self.shape[1]
        colour = np.full((size, 3), 255.0)
        deepest, nearest = np.full(size, np.inf), np.full(size, np.inf)
        count = translucent = np.zeros(size, int)
        if parts:
            pixel, depth, face = (np.concatenate(column) for column in zip(*parts))
            count = np.bincount(pixel, minlength=size)
            rgba = np.array([f.colour for f in self.faces])[face]
            opaque = rgba[:, 3] >= 1.0
            translucent = np.bincount(pixel[~opaque], minlength=size)
            np.minimum.at(nearest, pixel, depth)
            np.minimum.at(deepest, pixel[opaque], depth[opaque])
            order = np.lexsort((face, -np.rint(depth / TIE), pixel))
            pixel, rgba = pixel[order], rgba[order]
            rank = np.arange(len(pixel)) - np.searchsorted(pixel, pixel)
            for r in range(int(rank.max(initial=-1)) + 1):
                at, over = pixel[rank == r], rgba[rank == r]
                alpha = over[:, 3:]
                colour[at] += alpha * (255 * over[:, :3] - colour[at])
        maps = (values.reshape(self.shape) for values in (deepest, nearest, count, translucent))
        return colour.reshape(*self.shape, 3), *maps

    def met(self, number: int, face: Face, way: int) -> tuple[Array, Array, Array]:
        """Which pixels a face covers, and how deep it is there."""
        corners = np.concatenate(face.rings)
        low = np.maximum(np.floor(corners[:, :2].min(axis=0)).astype(int) - 1, 0)
        high = np.minimum(np.ceil(corners[:, :2].max(axis=0)).astype(int) + 1, self.shape[::-1])
        if (high <= low).any():
            return np.zeros(0, int), np.zeros(0), np.zeros(0, int)
        column, row = (
            v.ravel() for v in np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
        )
        x, y = column + 0.5, row + 0.5
        depth = np.full(len(x), np.inf)
        for rings in _flat_parts(face.rings, way):
            inside = _winding(rings, x, y) != 0
            points = np.concatenate(rings)
            plane = _plane(points)
            if plane is None:
                continue
            own = plane[0] * x + plane[1] * y + plane[2]
            if not _is_flat(points):
                own = np.full(len(x), points[:, 2].min() if way == 0 else points[:, 2].max())
            depth = np.minimum(depth, np.where(inside, own, np.inf))
        hit = np.isfinite(depth)
        pixel = row[hit] * self.shape[1] + column[hit]
        return pixel, depth[hit], np.full(len(pixel), number)

    # ---- What is left out --------------------------------------------------------------------

    def inside(self) -> Array:
        """Within the axes, which clip their artists."""
        box = self.ax.bbox
        rows, columns = np.indices(self.shape)
        y = self.shape[0] - rows
        return np.asarray(
            (columns > box.x0 + 2) & (columns < box.x1 - 3) & (y > box.y0 + 3) & (y < box.y1 - 2)
        )

    def away_from_edges(self, expected: Array) -> Array:
        away = np.ones(self.shape, bool)
        for dy, dx in _disc(NEAR):
            moved = np.roll(expected, (dy, dx), (0, 1))
            away &= (moved == expected).all(axis=2)
        deepest = _grown(np.where(np.isfinite(self.deepest), self.deepest, 1e9), 1.5)
        by_margin: dict[float, list[Array]] = {}
        for face in self.faces:
            for ring in face.rings:
                ends = np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)
                by_margin.setdefault(face.margin, []).append(ends)
        for margin, sides in by_margin.items():
            samples, _ = _samples(np.concatenate(sides))
            away &= ~self.near(samples, deepest, NEAR + margin)
        rows, columns = np.indices(self.shape)
        for text in self.ax.texts:
            # Its box is that of the text before it is placed and turned.
            reach = max(text.get_window_extent().size) + 3
            x, y, _ = self.placed(text.get_position_3d())[0]
            self.clear &= np.hypot(columns - x, rows - y) > reach
        return away

    def near(self, samples: Array, deepest: Array, reach: float) -> Array:
        """Which pixels' centres are near to samples that no opaque polygon hides."""
        at = np.floor(samples[:, :2]).astype(int)[:, ::-1]
        good = ((at >= 0) & (at < self.shape)).all(axis=1)
        at, depth = at[good], samples[good, 2]
        shown = depth <= deepest[at[:, 0], at[:, 1]] + TIE
        marks = np.zeros(self.shape, bool)
        marks[at[shown, 0], at[shown, 1]] = True
        return _grown(marks, reach + 0.7)

    def lines(self, expected: Array) -> tuple[Array, Array]:
        """The colours of lines, and the pixels that one line alone covers wholly; leaves out the
        surroundings of what is not hidden."""
        colour, covered = expected.copy(), np.zeros(self.shape, bool)
        touched = np.zeros(self.shape, int)
        deepest = _grown(np.where(np.isfinite(self.deepest), self.deepest, 1e9), 1.5)
        nearest = -_grown(-np.where(np.isfinite(self.nearest), self.nearest, 1e9), 2.5)
        for stroke in self.strokes():
            points = stroke.points[np.isfinite(stroke.points).all(axis=1)]
            if not len(points):
                continue
            sides = np.stack([points[:-1], points[1:]], axis=1)
            if len(points) == 1:
                sides = points[None, [0, 0]]
            samples, along = _samples(sides)
            close = self.near(samples, deepest, NEAR + stroke.half)
            touched += close
            core = stroke.half - 0.8
            if stroke.colour is None or core <= 0.3:
                continue
            from_end = np.minimum(along, along[-1] - along)
            for x, y, z in samples[from_end > stroke.half + NEAR]:
                row, column = int(np.floor(y)), int(np.floor(x))
                if not (0 <= row < self.shape[0] and 0 <= column < self.shape[1]):
                    continue
                in_front = z < nearest[row, column] - TIE
                if in_front and np.hypot(column + 0.5 - x, row + 0.5 - y) < core:
                    covered[row, column] = True
                    colour[row, column] = np.rint(255 * np.asarray(stroke.colour)[:3])
        is_line = covered & (touched == 1) & self.clear
        self.clear &= touched == 0
        return colour, is_line


def _flat_parts(rings: list[Array], way: int) -> list[list[Array]]:
    """The triangles of a bent quadrilateral, by either diagonal. Of other bent polygons it is not
    known how they bend, only between which depths."""
    corners = np.concatenate(rings)
    if len(corners) != 4 or _is_flat(corners):
        return [rings]
    triangles = ((0, 1, 2), (0, 2, 3)) if way == 0 else ((1, 2, 3), (1, 3, 0))
    return [[corners[list(three)]] for three in triangles]


def _is_flat(corners: Array) -> bool:
    plane = _plane(corners)
    if plane is None:
        return True
    off = corners[:, :2] @ plane[:2] + plane[2] - corners[:, 2]
    return bool(np.abs(off).max() < TIE)


def _plane(corners: Array) -> Array | None:
    """Depth as a linear function of the pixel; None for polygons seen edge-on."""
    middle = corners.mean(axis=0)
    apart = corners - middle
    if np.linalg.svd(apart[:, :2], compute_uv=False)[-1] < 1e-6:
        return None
    slope = np.linalg.lstsq(apart[:, :2], apart[:, 2], rcond=None)[0]
    return np.append(slope, middle[2] - slope @ middle[:2])


def _winding(rings: list[Array], x: Array, y: Array) -> Array:
    number = np.zeros(len(x), int)
    for ring in rings:
        for a, b in zip(ring, np.roll(ring, -1, axis=0)):
            side = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])
            number += (a[1] <= y) & (b[1] > y) & (side > 0)
            number -= (a[1] > y) & (b[1] <= y) & (side < 0)
    return number


def _rings(points: Array, codes: Any) -> list[Array]:
    """The rings of a path; its curves become polygons."""
    if codes is None:
        return [points]
    rings: list[list[Array]] = []
    k = 0
    while k < len(codes):
        code = codes[k]
        if code == Path.MOVETO:
            rings.append([points[k]])
        elif code == Path.LINETO:
            rings[-1].append(points[k])
        elif code in (Path.CURVE3, Path.CURVE4):
            degree = 2 if code == Path.CURVE3 else 3
            controls = np.array([rings[-1][-1], *points[k : k + degree]])
            for t in np.linspace(0, 1, 25)[1:]:
                at = controls
                while len(at) > 1:
                    at = (1 - t) * at[:-1] + t * at[1:]
                rings[-1].append(at[0])
            k += degree - 1
        k += 1
    return [np.array(ring) for ring in rings if len(ring) >= 3]


def _samples(sides: Array) -> tuple[Array, Array]:
    """Points along lines, (n, 2, 3), and how far along all of them each is."""
    length = np.hypot(*(sides[:, 1] - sides[:, 0])[:, :2].T)
    count = np.minimum(np.ceil(length / STEP).astype(int) + 1, 4000)
    of = np.repeat(np.arange(len(sides)), count)
    k = np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)
    t = k / np.maximum(count[of] - 1, 1)
    points = sides[of, 0] + t[:, None] * (sides[of, 1] - sides[of, 0])
    return points, (np.cumsum(length) - length)[of] + t * length[of]


def _disc(radius: float) -> list[tuple[int, int]]:
    r = int(np.ceil(radius))
    steps = range(-r, r + 1)
    return [(i, j) for i in steps for j in steps if i * i + j * j <= radius * radius + 1e-9]


def _grown(values: Array, radius: float) -> Array:
    """The largest value within the radius, in pixels."""
    grown = values.copy()
    for dy, dx in _disc(radius):
        grown = np.maximum(grown, np.roll(values, (dy, dx), (0, 1)))
    return grown
