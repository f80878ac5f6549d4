"""Pieces of opaque polygons without seams: each reaches across its cuts.

Where two pieces meet, antialiasing covers a pixel in two parts, and lets what is behind show through.
Therefore the piece that is drawn first is extended across the cut, within the one that is drawn
later, which covers the extension; what is drawn between them covers it too. That ends at the cut
itself if it was cut there as well, and would show. Therefore the later piece also is extended, where
the earlier one is seen beside the cut.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, NamedTuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    Bools = npt.NDArray[np.bool_]
    Floats = npt.NDArray[np.float64]
    Indices = npt.NDArray[np.int64]
    Seen = Callable[[Floats], tuple[Floats, Indices]]

_BENEATH = 1.5
"""Pixels: how far pieces are extended beneath later ones. What a side in any direction covers in
part is within that."""
_OVER = 1.0
"""Pixels: how far pieces are extended over earlier ones."""
_ASIDE = 2.0
"""How far extensions go along the cut at an acute corner, for each pixel that they may go across."""
_APART = 1e-2
"""Pixels: sides of pieces that are nearer to one line are on one cut."""


class Rings(NamedTuple):
    """Pieces as rings of points, (N, 3), in pixels and depths, larger ones nearer; piece k has those
    from first[k] to first[k + 1]."""

    points: Floats
    first: Indices
    item: Indices
    """The polygon of each piece."""
    run: Indices
    """Of each piece: pieces of one run are one path, and runs are drawn in order."""

    def following(self) -> Indices:
        """The next point of each."""
        following = np.arange(1, len(self.points) + 1)
        following[self.first[1:] - 1] = self.first[:-1]
        return following

    def normals(self) -> Floats:
        p = self.points - np.repeat(self.points[self.first[:-1]], np.diff(self.first), axis=0)
        return np.asarray(np.add.reduceat(np.cross(p, p[self.following()]), self.first[:-1]))


class Extensions(NamedTuple):
    """Points more: each after a point of a ring, those after one point in their order."""

    after: Indices
    points: Floats


def extensions(rings: Rings, is_cut: Bools, seen: Seen) -> Extensions:
    """Of pieces beyond the sides, named by the points at which they end, of which is_cut is True.
    `seen` returns the parts of segments, (n, 2, 3), that are seen, and the segment of each."""
    end = np.flatnonzero(is_cut)
    if not len(end):
        return Extensions(np.zeros(0, np.int64), np.zeros((0, 2)))
    sides = _Sides(rings)
    piece = np.searchsorted(rings.first, end, side="right") - 1
    item, run = rings.item[piece], rings.run[piece]
    one, other = _same_sides(rings.points, sides.preceding[end], end, item)
    left = np.ones(len(end), bool)
    left[one] = left[other] = False
    rest = np.flatnonzero(left)
    rest = rest[np.argsort(item[rest], kind="stable")]
    ends = np.stack([rings.points[sides.preceding[end[rest]]], rings.points[end[rest]]], axis=1)
    pairs = _on_one_line(ends[..., :2], item[rest])
    one, other = np.append(one, rest[pairs[0]]), np.append(other, rest[pairs[1]])

    swapped = run[one] > run[other]
    earlier, later = np.where(swapped, other, one), np.where(swapped, one, other)
    apart = run[earlier] < run[later]
    earlier, later = earlier[apart], later[apart]

    beneath = sides.strips(end[earlier], end[later], piece[later], _BENEATH)
    over = sides.strips(end[later], end[earlier], piece[earlier], _OVER)
    parts, of = seen(over.reached)
    all_strips = _joined(beneath, over.parts(parts, of))
    return all_strips.extensions(sides.preceding)


def _same_sides(
    points: Floats, start: Indices, end: Indices, item: Indices
) -> tuple[Indices, Indices]:
    """Which two of the sides are the same of two pieces of one polygon."""
    a, b = points[start], points[end]
    back = (a[:, 0] > b[:, 0]) | ((a[:, 0] == b[:, 0]) & (a[:, 1] > b[:, 1]))
    keys = np.column_stack([np.where(back[:, None], b, a), np.where(back[:, None], a, b), item])
    order = np.lexsort((back, *keys.T))
    same = (keys[order[1:]] == keys[order[:-1]]).all(axis=1)
    same &= back[order[1:]] != back[order[:-1]]
    at = np.flatnonzero(same)
    return order[at], order[at + 1]


def _on_one_line(sides: Floats, item: Indices) -> tuple[Indices, Indices]:
    """Which two of the sides, (n, 2, 2), in the order of their items, lie along each other in opposite
    directions: where one piece is cut once more than the other."""
    along = sides[:, 1] - sides[:, 0]
    length = np.hypot(*along.T)
    unit = along / np.maximum(length, 1e-300)[:, None]
    found = [np.zeros((0, 2), np.int64)]
    for step in range(1, len(sides)):
        i = np.flatnonzero(item[step:] == item[:-step])
        if not len(i):
            break
        j = i + step
        shorter = np.where(length[i] < length[j], i, j)
        longer = i + j - shorter
        to = sides[shorter] - sides[longer, None, 0]
        off = np.abs(to[..., 0] * unit[longer, None, 1] - to[..., 1] * unit[longer, None, 0])
        at = (to * unit[longer, None]).sum(axis=2)
        overlap = np.minimum(at.max(axis=1), length[longer]) - np.maximum(at.min(axis=1), 0.0)
        met = (off < _APART).all(axis=1) & (at[:, 1] < at[:, 0]) & (overlap > 1e-6)
        found.append(np.column_stack([i[met], j[met]]))
    pairs = np.concatenate(found)
    return pairs[:, 0], pairs[:, 1]


class _Strips(NamedTuple):
    """Strips along cuts by which pieces are extended. In the direction of the side that is extended:"""

    owner: Indices
    """The side, named by the point at which it ends."""
    length: Floats
    along: Floats
    """Its direction."""
    at: Floats
    """(n, 2): from its start, where the strip begins and ends."""
    feet: Floats
    """(n, 2, 3): on the cut."""
    reached: Floats
    """(n, 2, 3): beyond it."""

    def parts(self, parts: Floats, of: Indices) -> _Strips:
        """The strips at parts, (m, 2, 3), of what they reach."""
        whole = self.reached[of]
        span = whole[:, 1] - whole[:, 0]
        square = np.maximum((span[:, :2] ** 2).sum(axis=1), 1e-300)
        t = ((parts - whole[:, :1])[..., :2] * span[:, None, :2]).sum(axis=2) / square[:, None]
        t = np.sort(t.clip(0.0, 1.0), axis=1)
        at, feet = self.at[of], self.feet[of]
        return _Strips(
            self.owner[of],
            self.length[of],
            self.along[of],
            at[:, :1] + t * (at[:, 1:] - at[:, :1]),
            feet[:, :1] + t[..., None] * (feet[:, 1:] - feet[:, :1]),
            whole[:, :1] + t[..., None] * span[:, None],
        )

    def extensions(self, preceding: Indices) -> Extensions:
        own = np.stack([self.at[:, 0], self.length - self.at[:, 1]], axis=1) <= _APART
        points = np.stack(
            [self.feet[:, 0], self.reached[:, 0], self.reached[:, 1], self.feet[:, 1]], axis=1
        )
        kept = np.stack([~own[:, 0], *2 * [np.ones(len(own), bool)], ~own[:, 1]], axis=1)
        place = np.argsort(self.at[:, 0], kind="stable")
        place = place[np.argsort(self.owner[place], kind="stable")]
        after = np.repeat(preceding[self.owner[place]], kept[place].sum(axis=1))
        order = np.argsort(after, kind="stable")
        return Extensions(after[order], points[place][kept[place]][order, :2])


def _joined(*strips: _Strips) -> _Strips:
    return _Strips(*(np.concatenate(column) for column in zip(*strips)))


class _Sides:
    """The sides of rings, each named by the point at which it ends."""

    def __init__(self, rings: Rings) -> None:
        self.points = rings.points
        self.following = rings.following()
        self.preceding = np.empty_like(self.following)
        self.preceding[self.following] = np.arange(len(self.following))
        self.normals = rings.normals()
        self.low = np.minimum.reduceat(rings.points[:, 2], rings.first[:-1])
        self.high = np.maximum.reduceat(rings.points[:, 2], rings.first[:-1])

    def strips(self, owner: Indices, across: Indices, piece: Indices, reach: float) -> _Strips:
        """From sides into the pieces that lie across. The latter's sides go the other way."""
        own = self.points[np.stack([self.preceding[owner], owner], axis=1)]
        span = (own[:, 1] - own[:, 0])[:, :2]
        length = np.hypot(*span.T)
        along = span / np.maximum(length, 1e-300)[:, None]
        normal = self.normals[piece]
        turn = np.where(normal[:, 2] < 0.0, -1.0, 1.0)
        inward = np.column_stack([along[:, 1], -along[:, 0]]) * turn[:, None]
        flat = np.abs(normal[:, 2]) > 1e-12
        slope = -normal[:, :2] / np.where(flat, normal[:, 2], np.inf)[:, None]

        start = self.preceding[across]
        corners = self.points[np.stack([across, start], axis=1)]
        beyond = self.points[np.stack([self.following[across], self.preceding[start]], axis=1)]
        corner_at = ((corners - own[:, :1])[..., :2] * along[:, None]).sum(axis=2)
        own_at = np.stack([np.zeros(len(length)), length], axis=1)
        # From the corner of the piece across, along its next side; from one within its side straight.
        past = (corner_at - own_at) * (-1.0, 1.0)
        inside = past > _APART
        feet = np.where(inside[..., None], own, corners)
        side = np.where(inside[..., None], inward[:, None], (beyond - corners)[..., :2])
        depth = (side * inward[:, None]).sum(axis=2)
        is_reflex = depth <= 1e-9
        part = np.minimum(np.where(inside, reach, 1.0), reach / np.where(is_reflex, 1.0, depth))
        aside = np.abs((side * along[:, None]).sum(axis=2))
        part = np.minimum(part, _ASIDE * reach / np.maximum(aside, 1e-300))
        step = np.where(is_reflex[..., None], reach * inward[:, None], part[..., None] * side)
        # The piece across goes on beside a corner within its side.
        step += (np.minimum(past, reach) * inside * (-1.0, 1.0))[..., None] * along[:, None]
        rise = (step * slope[:, None]).sum(axis=2)
        rise = np.where(inside | is_reflex, rise, part * (beyond - corners)[..., 2])
        z = (feet[..., 2] + rise).clip(self.low[piece, None], self.high[piece, None])
        reached = np.concatenate([feet[..., :2] + step, z[..., None]], axis=2)
        return _Strips(owner, length, along, np.where(inside, own_at, corner_at), feet, reached)


def closed_paths(
    points: Floats, first: Indices, extended: Extensions
) -> tuple[Any, Indices, Indices]:
    """Rings with their extensions, each with its first point once more: the points of all, and where
    each begins and ends."""
    extra = np.bincount(extended.after, minlength=len(points))
    count = len(first) - 1
    piece = np.repeat(np.arange(count), np.diff(first))
    before = np.cumsum(extra) - extra
    place = np.arange(len(points)) + before + piece
    begin = place[first[:-1]]
    end = np.append(begin[1:], len(points) + len(extended.after) + count)
    made = np.empty((end[-1] if count else 0, 2))
    made[place] = points
    made[end - 1] = points[first[:-1]]
    rank = np.arange(len(extended.after)) - before[extended.after]
    made[place[extended.after] + 1 + rank] = extended.points
    return made, begin, end
