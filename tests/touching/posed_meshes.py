"""An assembly and its camera in whole numbers, and both turned and moved: files of meshes.

A moved assembly is turned at random about the origin, then moved in a random direction, by 0.01 to
1,000 sizes (logarithmically; one in ten not at all), a size being the longest side of the box
around it; in doubles, which the formats round: STL, PLY and glTF to single precision, OBJ to six
significant digits.

Rounded so, what does not touch must stay clear of what does. The reach is 8 units of the largest
coordinate (design, "Touching"): 2^-24 of it in single precision; with six digits half a unit of its
sixth digit. An offset is no larger than leaves the reach a quarter of the *least feature*: the
least distance of two corners, of a corner and a side, and of polygons from planes in which they do
not lie. In single precision that is the full 1,000 sizes for features of a 500th of the size.

With six digits half a unit of the last is also at most 1e-5 sizes, a third of what single precision
rounds at 1,000 sizes: more would turn sides that are seen nearly edge-on, and so decide itself
which lines are seen. For assemblies of 300 units that is 3 sizes, of 500 and more 10 to 20.
"""
import base64
import itertools
import json
import math

import numpy as np

import solids
from touching_scenes import Source, words

FORMATS = ("stl", "ply", "gltf", "obj")
OF_TRIANGLES = ("stl", "gltf")
MOST_SIZES = 1000
LEAST_OFFSET = 0.01  # sizes
CLEAR = 4  # reaches in the least feature
REACH = 8  # units
UNIT_OF_SINGLES = 2.0**-24
MOST_UNIT_OF_DIGITS = 2.0**-17
DIGITS = 6
MOST_ROUNDED = 1e-5  # sizes, by digits
SAME = 1e-7  # features that are smaller are rounding of what touches

FROM_ABOVE = 80  # percent of the views that would be from below, where there is little to see

SETTINGS = (
    "set-back-face-removal off",
    "set-fill-style solid 1 1 1",
    "set-line-style solid 0 0 0",
)


# ---- Features


def unique_points(faces):
    """As an array, and the faces as lists of indices into it."""
    index = {}
    indexed = [[index.setdefault(tuple(p), len(index)) for p in face] for face in faces]
    return np.array([[float(x) for x in p] for p in index]), indexed


def least_between_corners(points):
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    return apart[apart > SAME].min()


def least_to_sides(points, indexed):
    pairs = {tuple(sorted(side)) for face in indexed for side in solids.sides(face)}
    least = math.inf
    for a, b in sorted(pairs):
        p, along = points[a], points[b] - points[a]
        share = np.clip((points - p) @ along / (along @ along), 0, 1)
        apart = np.linalg.norm(points - p - share[:, None] * along, axis=1)
        least = min(least, apart[apart > SAME].min())
    return least


def least_to_planes(points, indexed):
    """Of each polygon the corner that is the farthest from a plane counts."""
    corners = np.array([face + face[-1:] * (12 - len(face)) for face in indexed if len(face) <= 12])
    least, known = math.inf, set()
    for face in indexed:
        normal = np.array(solids.normal([tuple(points[k]) for k in face]))
        normal /= np.linalg.norm(normal)
        key = tuple(np.round([*normal, normal @ points[face[0]]], 9))
        if key in known:
            continue
        known.add(key)
        apart = np.abs((points - points[face[0]]) @ normal)
        farthest = apart[corners].max(axis=1)
        least = min(least, farthest[farthest > SAME].min(initial=math.inf))
    return least


def least_feature(faces):
    """Of polygons, and of the triangles of which they are made."""
    points, indexed = unique_points(faces)
    triangles = unique_points(solids.triangulated(faces)[0])
    return min(
        least_between_corners(points),
        least_to_sides(points, indexed),
        least_to_planes(points, indexed),
        least_to_planes(*triangles),
    )


def unit_of_digits(largest):
    """Half a unit of the sixth digit."""
    return 0.5 * 10.0 ** (math.floor(math.log10(largest)) + 1 - DIGITS)


def reach_of(form, largest):
    if form != "obj":
        return REACH * UNIT_OF_SINGLES * largest
    return REACH * min(unit_of_digits(largest), MOST_UNIT_OF_DIGITS * largest)


def largest_coordinate(form, feature, size):
    """With which the reach is no more than a quarter of the feature."""
    most = feature / CLEAR / REACH
    if form != "obj":
        return most / UNIT_OF_SINGLES
    return 10.0 ** (math.floor(math.log10(2 * min(most, MOST_ROUNDED * size))) + DIGITS)


# ---- Turning and moving


def random_turn(source):
    """The rows of a rotation: of a random unit quaternion."""
    while True:
        q = [source.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(x * x for x in q))
        if length > 1e-3:
            break
    w, x, y, z = (c / length for c in q)
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


NO_TURN = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Motion:
    def __init__(self, turn=NO_TURN, offset=(0.0, 0.0, 0.0)):
        self.turn, self.offset = turn, offset

    def direction(self, d):
        return [sum(a * float(b) for a, b in zip(row, d)) for row in self.turn]

    def point(self, p):
        return [a + b for a, b in zip(self.direction(p), self.offset)]


# ---- Cameras

AXIS_VIEWS = {  # the direction of sight, and what is up
    "front": ((0, 1, 0), (0, 0, 1)),
    "top": ((0, 0, -1), (0, 1, 0)),
    "side": ((-1, 0, 0), (0, 0, 1)),
    "isometric": ((-1, 1, -1), (0, 0, 1)),
}


class Camera:
    """Of a ball, from outside."""

    def __init__(self, source, low, high, perspective, axis_view=None):
        self.middle = [(a + b) / 2 for a, b in zip(low, high)]
        self.radius = radius = math.dist(low, high) / 2
        if axis_view:
            self.into, self.up = AXIS_VIEWS[axis_view]
        else:
            self.into, self.up = source.direction(), source.direction()
            if self.into[2] > 0 and source.chance(FROM_ABOVE):
                self.into[2] *= -1
            while abs(solids.dot(self.into, self.up)) > 0.9:
                self.up = source.direction()
        self.eye, self.half = None, 1.02 * radius
        self.toward = [-x for x in self.into]
        if perspective:
            away = source.uniform(1.3, 4) * radius
            self.eye = [m - away * x for m, x in zip(self.middle, self.into)]
            self.half *= away / math.sqrt(away * away - radius * radius)
        elif not axis_view and source.chance(25):
            self.toward = [a + 0.4 * b for a, b in zip(self.toward, source.direction())]
            self.half *= 1.4

    def sides(self, motion, points, faces):
        """The sign of each face that is moved so: 1 if it faces the viewer."""
        normals = [np.array(solids.normal([tuple(points[k]) for k in face])) for face in faces]
        if not self.eye:
            return np.sign(np.array(normals) @ np.array(motion.direction(self.toward)))
        eye = np.array(motion.point(self.eye))
        return np.sign([n @ (eye - points[face[0]]) for n, face in zip(normals, faces)])

    def lines(self, motion):
        """A drawing program that sets the view, moved as the scene is."""
        if self.eye:
            projection = f"set-perspective {words(motion.point(self.eye))}"
        else:
            projection = f"set-parallel {words(motion.direction(self.toward))}"
        half, radius = self.half, 1.02 * self.radius
        return [
            f"set-view-reference-point {words(motion.point(self.middle))}",
            f"set-view-plane-normal {words(motion.direction(self.into))}",
            f"set-view-up {words(motion.direction(self.up))}",
            projection,
            f"set-window {words([-half, half, -half, half])}",
            f"set-view-depth {words([-radius, radius])}",
            *SETTINGS,
        ]


# ---- Planes


def support(points):
    """The unit normal of the support plane, and a point of it (design, section 4)."""
    p = points[0]
    q = points[np.abs(points - p).max(axis=1).argmax()]
    r = points[np.abs(np.cross(q - p, points - p)).max(axis=1).argmax()]
    normal = np.cross(q - p, r - p)
    return normal / np.linalg.norm(normal), p


def planes(polygons, reach):
    """For each polygon the first, in order of falling area, from whose plane it is no farther than
    the reach, or else itself."""
    area = [np.linalg.norm(sum(np.cross(*side) for side in solids.sides(list(p)))) for p in polygons]
    founders, plane = [], [0] * len(polygons)
    for k in sorted(range(len(polygons)), key=lambda k: -area[k]):
        for founder, (normal, through) in founders:
            if np.abs((polygons[k] - through) @ normal).max() <= reach:
                plane[k] = founder
                break
        else:
            plane[k] = k
            founders.append((k, support(polygons[k])))
    return plane


# ---- Files


def program_of(faces):
    """Polygons in one segment."""
    polygons = [
        "polygon-abs-3 " + "  ".join(words(map(float, p)) for p in face) for face in faces
    ]
    return "\n".join(["open-segment 1", *polygons, "close-segment"]) + "\n"


def stl(points, faces):
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    facets = np.zeros(len(faces), facet)
    facets["corners"] = points[np.array(faces)]
    return b"binary".ljust(80) + np.uint32(len(faces)).tobytes() + facets.tobytes()


def ply(points, faces):
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    lists = [bytes([len(face)]) + np.array(face, "<i4").tobytes() for face in faces]
    return header.encode() + points.astype("<f4").tobytes() + b"".join(lists)


def gltf(points, faces):
    positions, indices = points.astype("<f4"), np.array(faces, "<u4")
    data = positions.tobytes() + indices.tobytes()
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": len(positions),
                "type": "VEC3",
                "min": positions.min(axis=0).tolist(),
                "max": positions.max(axis=0).tolist(),
            },
            {"bufferView": 1, "componentType": 5125, "count": indices.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": positions.nbytes},
            {"buffer": 0, "byteOffset": positions.nbytes, "byteLength": indices.nbytes},
        ],
        "buffers": [
            {
                "byteLength": len(data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
            }
        ],
    }
    return json.dumps(scene).encode()


def obj(points, faces):
    lines = ["v " + " ".join(f"{x:.{DIGITS}g}" for x in p) for p in points]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces]
    return ("\n".join(lines) + "\n").encode()


WRITERS = {"stl": stl, "ply": ply, "gltf": gltf, "obj": obj}


def rounded(form, points):
    """As they are read back."""
    if form == "obj":
        return np.array([[float(f"{x:.{DIGITS}g}") for x in p] for p in points])
    return points if form == "draw" else points.astype("<f4").astype(float)


class Posed:
    """View `number` of an assembly: the faces `entered`, seen by a camera, and the faces `moved`,
    which are the same or what was cut of them, turned and moved."""

    def __init__(self, seed, number, entered, moved, axis=False):
        self.source = Source(f"{seed}/pose/{number}")
        self.entered, self.moved = entered, moved
        self.points = unique_points(entered)[0]
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        self.size = float(max(high - low))
        self.turn, self.toward = random_turn(self.source), self.source.direction()
        self.share = 0.0 if number % 10 == 9 else self.source.uniform(0, 1)
        self.feature = float(min(least_feature(entered), least_feature(moved)))
        self.axis_view = list(AXIS_VIEWS)[number % 4] if axis else None
        perspective = not axis and number % 2 == 1
        self.camera = Camera(self.source, low, high, perspective, self.axis_view)

    def most_offset(self, form):
        """In the coordinates' unit."""
        own = float(np.abs(self.points).max()) * math.sqrt(3)
        most = largest_coordinate(form, self.feature, self.size) - own
        return max(0.0, min(most, MOST_SIZES * self.size))

    def motion(self, form):
        """The motion of a format's file; a drawing program is not moved."""
        if form == "draw":
            return Motion()
        least, most = LEAST_OFFSET * self.size, self.most_offset(form)
        length = 0.0
        if self.share and most > least:
            length = least * (most / least) ** self.share
        return Motion(self.turn, [length * x for x in self.toward])

    def reach(self, form):
        """In the unit of the coordinates."""
        if form == "draw":
            return REACH * 2.0**-52 * float(np.abs(self.points).max())
        motion = self.motion(form)
        return reach_of(form, max(abs(x) for p in self.points for x in motion.point(p)))

    def is_clear(self, form):
        return CLEAR * self.reach(form) <= self.feature * (1 + 1e-9)

    def turned(self, form):
        """Whether rounding decides which way some face is seen: from before it or from behind."""
        motion = self.motion(form)
        points, indexed = unique_points(self.faces_for(form, self.moved)[0])
        moved = rounded(form, np.array([motion.point(p) for p in points]))
        sides = (
            self.camera.sides(Motion(), points, indexed),
            self.camera.sides(motion, moved, indexed),
        )
        return bool((sides[0] != sides[1]).any())

    def is_beyond(self, form):
        """Whether polygons that meet in one plane in whole numbers are, rounded, in two: farther
        apart than the reach."""
        points, indexed = unique_points(self.faces_for(form, self.moved)[0])
        motion = self.motion(form)
        moved = rounded(form, np.array([motion.point(p) for p in points]))
        whole = [points[face] for face in indexed]
        together = planes(whole, SAME)
        found = planes([moved[face] for face in indexed], self.reach(form))
        low, high = (np.array([bound(p, axis=0) for p in whole]) for bound in (np.min, np.max))
        return any(
            together[a] == together[b] and (low[a] <= high[b]).all() and (low[b] <= high[a]).all()
            for a, b in itertools.combinations(range(len(whole)), 2)
            if found[a] != found[b]
        )

    def faces_for(self, form, faces):
        """The polygons entered for a format, and for each the ordinal of its face."""
        if form in OF_TRIANGLES:
            return solids.triangulated(faces)
        return faces, list(range(len(faces)))

    def write_whole(self, folder, form):
        """Writes whole-view.draw and whole.draw; returns their paths."""
        view, scene = folder / "whole-view.draw", folder / "whole.draw"
        view.write_text("\n".join(self.camera.lines(Motion())) + "\n")
        scene.write_text(program_of(self.faces_for(form, self.entered)[0]))
        return view, scene

    def write_moved(self, folder, form, faces=None):
        """Writes moved-view.draw and moved.FORM, of these faces or those that are moved; returns
        their paths."""
        faces = self.faces_for(form, self.moved if faces is None else faces)[0]
        motion = self.motion(form)
        view, scene = folder / "moved-view.draw", folder / f"moved.{form}"
        view.write_text("\n".join(self.camera.lines(motion)) + "\n")
        if form == "draw":
            scene.write_text(program_of(faces))
        else:
            points, indexed = unique_points(faces)
            points = np.array([motion.point(p) for p in points])
            scene.write_bytes(WRITERS[form](points, indexed))
        return view, scene
