"""Meshes of other packages, by what they have: none of them is imported."""

from __future__ import annotations

import typing

from . import _colours
from ._displayfile import Error

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

_SIDES = {"triangle": 3, "quad": 4, "triangle6": 3, "quad8": 4, "quad9": 4, "triangle7": 3}
"""Cells of meshio that are faces: how many of their points are corners, which come first."""


class Faces(typing.NamedTuple):
    """What System.mesh takes."""

    vertices: typing.Any
    faces: typing.Any
    sides: typing.Any
    fills: typing.Any
    left_out: list[str]
    arrays: dict[str, typing.Any] = {}
    """Data of its points and its faces, by name."""


def of_trimesh(mesh: typing.Any) -> Faces:
    """A trimesh.Trimesh: vertices, faces, and the colours of faces if it has some of its own."""
    vertices, faces = _members(mesh, "trimesh.Trimesh", "vertices", "faces")
    visual = getattr(mesh, "visual", None)
    kind = getattr(visual, "kind", None)
    fills = getattr(visual, "face_colors", None) if kind in ("face", "vertex") else None
    left_out = []
    if kind == "vertex":
        left_out.append("colours of vertices: faces have the mean of theirs")
    if kind == "texture":
        left_out.append("its texture")
    arrays = _arrays(mesh, "vertex_attributes", "face_attributes")
    return Faces(vertices, faces, None, _opaque_colours(fills, left_out), left_out, arrays)


def of_meshio(mesh: typing.Any) -> Faces:
    """A meshio.Mesh: its triangles and quadrilaterals, and its polygons."""
    import numpy as np

    points, cells = _members(mesh, "meshio.Mesh", "points", "cells")
    corners, sides, left_out, drawn = [], [], [], []
    for number, block in enumerate(cells):
        kind, data = block.type, np.asarray(block.data)
        n = _SIDES.get(kind, data.shape[-1] if kind.startswith("polygon") else 0)
        if not n:
            left_out.append(f"{len(data)} cells of type {kind}")
            continue
        drawn.append(number)
        corners.append(data[:, :n].ravel())
        sides.append(np.full(len(data), n))
    if not corners:
        raise Error(f"from_meshio: no faces: it has {', '.join(left_out) or 'no cells'}")
    arrays = {
        name: np.concatenate([np.asarray(blocks[k]) for k in drawn])
        for name, blocks in _arrays(mesh, "cell_data").items()
    }
    arrays.update(_arrays(mesh, "point_data"))
    vertices, all_corners = _in_space(points), np.concatenate(corners)
    return Faces(vertices, all_corners, np.concatenate(sides), None, left_out, arrays)


def of_pyvista(mesh: typing.Any) -> Faces:
    """A pyvista.PolyData; of other data sets the surface that they extract."""
    import numpy as np

    if not _has(mesh, "faces") and _has(mesh, "extract_surface"):
        mesh = mesh.extract_surface()
    points, padded = _members(mesh, "pyvista.PolyData", "points", "faces")
    padded = np.asarray(padded).ravel()
    left_out = [
        f"{getattr(mesh, count)} {name}"
        for count, name in (("n_lines", "lines"), ("n_strips", "strips"), ("n_verts", "points"))
        if getattr(mesh, count, 0)
    ]
    sides = []
    at = 0
    while at < len(padded):  # a count before the corners of each face
        sides.append(int(padded[at]))
        at += sides[-1] + 1
    if at != len(padded):
        raise Error("from_pyvista: faces: expected the number of corners before each face's")
    counts = np.array(sides, np.int64)
    is_corner = np.ones(len(padded), bool)
    is_corner[np.concatenate([[0], np.cumsum(counts + 1)[:-1]]).astype(int)[: len(counts)]] = False
    arrays = _arrays(mesh, "cell_data", "point_data")
    return Faces(points, padded[is_corner], counts, None, left_out, arrays)


def _has(mesh: typing.Any, name: str) -> bool:
    """As hasattr, of a weak reference to nothing too."""
    try:
        return hasattr(mesh, name)
    except ReferenceError:
        return False


def _members(mesh: typing.Any, kind: str, *names: str) -> list[typing.Any]:
    missing = [name for name in names if not _has(mesh, name) or getattr(mesh, name) is None]
    if missing:
        raise Error(f"expected a {kind}, with {' and '.join(names)}, not {type(mesh).__name__}")
    return [getattr(mesh, name) for name in names]


def array_of(found: Faces, name: str) -> typing.Any:
    """Data of points or faces."""
    if name not in found.arrays:
        names = ", ".join(found.arrays) or "none: it has no data"
        raise Error(f"values '{name}': expected an array, or the name of one of the mesh's: {names}")
    return found.arrays[name]


def _arrays(mesh: typing.Any, *sources: str) -> dict[str, typing.Any]:
    """The arrays of these dictionaries of a mesh, where it has them; of one name, the last."""
    found: dict[str, typing.Any] = {}
    for source in sources:
        arrays = getattr(mesh, source, None)
        if arrays is not None:
            found.update({str(name): arrays[name] for name in arrays.keys()})
    return found


def _in_space(points: typing.Any) -> typing.Any:
    import numpy as np

    points = np.asarray(points)
    if points.ndim == 2 and points.shape[1] == 2:
        return np.column_stack([points, np.zeros(len(points))])
    return points


def _opaque_colours(colours: typing.Any, left_out: list[str]) -> typing.Any:
    import numpy as np

    if colours is None:
        return None
    array = np.asarray(colours)
    if array.ndim == 2 and array.shape[1] == 4:
        if array.size and array[:, 3].min() < (255 if array.dtype == np.uint8 else 1.0):
            left_out.append("transparency")
        array = array[:, :3]
    return _colours.colours(array, "colours")
