"""System: the user routines, and drawing."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import os
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Colour, _Faces, _Numbers, _Size

_MOST_POLYGONS_AS_SVG = 2000
_SIZE_IN_NOTEBOOKS = 512


class Picture(typing.NamedTuple):
    """What draw returns where ids or depth are asked for."""

    pixels: npt.NDArray[np.uint8]
    """(H, W, 4): red, green, blue and alpha, the top row first."""
    ids: npt.NDArray[np.int32] | None
    """(H, W): the pick identifier of the fill that is seen, -1 for none."""
    depth: npt.NDArray[np.float64] | None
    """(H, W): of the fill that is seen, larger is nearer; minus infinity for none."""


class Pick(typing.NamedTuple):
    """What is seen at a pixel."""

    kind: str
    """"polygon", "edge" or "line"."""
    id: int
    segment: int
    depth: float


class Pieces(typing.NamedTuple):
    """What is drawn, in order. Piece k has the points from first[k] to first[k + 1]."""

    kinds: npt.NDArray[np.uint8]
    """(K,): 0 for a solid polygon, 1 for a polygon's sides alone, 2 for a line."""
    first: npt.NDArray[np.uint32]
    """(K + 1,)."""
    points: npt.NDArray[np.float64]
    """(N, 3): x and y from 0 to 1 over the picture, y up, a larger z nearer."""
    sides: npt.NDArray[np.uint8]
    """(N,): not 0 if the side that ends at the point is drawn."""
    fills: npt.NDArray[np.float64]
    """(K, 3): colours."""
    line_kinds: npt.NDArray[np.uint8]
    """(K,): 0 for solid lines, 1 for dashed ones, 2 for none."""
    line_colours: npt.NDArray[np.float64]
    """(K, 3)."""
    line_widths: npt.NDArray[np.float64]
    """(K,): in pixels."""
    picks: npt.NDArray[np.int32]
    """(K,): pick identifiers; -1 for a line without one."""
    segments: npt.NDArray[np.int32]
    """(K,): names."""


class System(_displayfile.System):
    """A graphics system: segments of lines and polygons, and how they are viewed and drawn.

    Every user routine of drawing programs is a method, with underscores for hyphens. Arguments
    are numbers, words, True and False for on and off, and sequences or arrays of them.

    Every method raises Error for a call that cannot be carried out; the state is then what it
    was before the call. Several threads may call one system: their calls come one after another.
    """

    def __init__(self, *, aspect: float | None = None, lines: str | None = None) -> None:
        """Make an empty system.

        aspect is the width over the height of its pictures, if they are not square. lines
        selects which sides of polygons are drawn as lines, in place of what set_lines says:
        kinds such as "outline,crease", as the command's option --lines has them.
        """
        super().__init__()
        if aspect is not None:
            self._set_aspect_ratio(aspect)
        if lines is not None:
            self._replace_lines(lines)

    # ---- What is entered -----------------------------------------------------------------

    def mesh(
        self,
        vertices: _Numbers,
        faces: _Faces,
        *,
        sides: _Numbers | None = None,
        segment: int | None = None,
        fill: _Colour | typing.Literal["hollow"] | None = None,
        fills: _Numbers | None = None,
        picks: _Numbers | None = None,
        normals: _Numbers | None = None,
    ) -> int:
        """Enter many polygons at once, and return the name of their segment.

        vertices is (N, 3); faces an array (M, k) of indices into it, or a sequence of sequences
        of any lengths. With sides, an array (M,) of numbers of corners, faces is the array of
        all corners, one face after another.

        They go into the open segment; if none is open, or segment is given, into one of their
        own, which is closed again. fill is the colour of all faces; fills (M, 3) and picks (M,)
        are those of each; normals (N, 3) those of vertices, for smooth shading.
        """
        return self._mesh(vertices, faces, sides, segment, fill, fills, picks, normals)

    def surface(self, x: _Numbers, y: _Numbers, z: _Numbers, *, segment: int | None = None) -> int:
        """Enter the surface of heights z, (m, n), and return the name of its segment.

        x (n,) and y (m,) are those of columns and rows; or all three are (m, n), as meshgrid
        makes them. Where x and y stand at even steps it is surface_3's, otherwise polygons of
        four sides. A height that is nan leaves a hole. Segments are as for mesh.
        """
        return self._surface(x, y, z, segment)

    def replay(self, text: str, name: str = "program") -> None:
        """Carry out a drawing program. Errors have the name, the line and the column."""
        self._replay(text, name)

    def replay_file(self, path: str | os.PathLike[str]) -> None:
        """Carry out the drawing program in a file."""
        self._replay_file(path)

    def import_mesh(
        self, path: str | os.PathLike[str], *, colour: _Colour | None = None
    ) -> list[str]:
        """Read a mesh and enter it, seen whole unless a window was set before.

        Returns what is not drawn of it, a sentence each.
        """
        return self._import_mesh(path, colour)

    # ---- Pictures ------------------------------------------------------------------------

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: typing.Literal[False] = ...,
        depth: typing.Literal[False] = ...,
        hidden: str | None = ...,
        lines: str | None = ...,
        hidden_lines: str | None = ...,
        scope: str | None = ...,
        precision: str | None = ...,
        background: _Colour | typing.Literal["none"] | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int = ...,
        threads: int = ...,
        device: str | None = ...,
    ) -> npt.NDArray[np.uint8]:
        ...

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: bool = ...,
        depth: bool = ...,
        hidden: str | None = ...,
        lines: str | None = ...,
        hidden_lines: str | None = ...,
        scope: str | None = ...,
        precision: str | None = ...,
        background: _Colour | typing.Literal["none"] | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int = ...,
        threads: int = ...,
        device: str | None = ...,
    ) -> typing.Any:
        ...

    def draw(
        self,
        size: _Size = 512,
        *,
        ids: bool = False,
        depth: bool = False,
        hidden: str | None = None,
        lines: str | None = None,
        hidden_lines: str | None = None,
        scope: str | None = None,
        precision: str | None = None,
        background: _Colour | typing.Literal["none"] | None = None,
        rows: tuple[int, int] | None = None,
        samples: int = 1,
        threads: int = 1,
        device: str | None = None,
    ) -> typing.Any:
        """Draw into memory: an array (H, W, 4) of uint8, the top row first.

        size is (width, height), or one number for both. With ids or depth it is a Picture.
        hidden is a method, one of methods(). hidden_lines is "dashed" to draw lines where they
        are hidden, too. rows, (first, end) from the top, draws only those of the picture, as they
        are in the whole of it. lines says which kinds of sides are lines, such as "outline,crease":
        since they are selected as segments are closed, an Error if the system selects others.
        Anything that is None is as the system's routines say.
        """
        self._require_lines(lines)
        pixels, of_ids, of_depth = self._draw(
            size,
            ids=ids,
            depth=depth,
            hidden=hidden,
            hidden_lines=hidden_lines,
            scope=scope,
            precision=precision,
            background=background,
            rows=rows,
            samples=samples,
            threads=threads,
            device=device,
        )
        return Picture(pixels, of_ids, of_depth) if ids or depth else pixels

    def svg(self, size: _Size = 512, **options: typing.Any) -> str:
        """The picture as SVG. Options are those of save."""
        return self._draw_as("svg", size, **self._checked(options)).decode()

    def pdf(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """The picture as PDF. Options are those of save."""
        return self._draw_as("pdf", size, **self._checked(options))

    def eps(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """The picture as EPS. Options are those of save."""
        return self._draw_as("eps", size, **self._checked(options))

    def png(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """The picture as PNG. Options are those of save."""
        return self._draw_as("png", size, **self._checked(options))

    def ppm(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """The picture as PPM. Options are those of save."""
        return self._draw_as("ppm", size, **self._checked(options))

    def save(
        self,
        path: str | os.PathLike[str],
        size: _Size = 512,
        *,
        format: str | None = None,
        **options: typing.Any,
    ) -> None:
        """Draw into a file, in the format that its name ends in.

        It appears whole or not at all. Options are those of draw but for ids and depth, and for
        vectors paper, seams, vector_precision and pick_ids.
        """
        self._save(path, format, size, **self._checked(options))

    def dump(self, **options: typing.Any) -> str:
        """The instructions of all segments, as the command's dump has them. Options are save's."""
        return self._dump(**self._checked(options))

    def pieces(self, **options: typing.Any) -> Pieces:
        """What is drawn in vectors, in order, as arrays. Options are those of save."""
        return Pieces(*self._pieces(**self._checked(options)))

    def pick(
        self, x: float, y: float, size: _Size = 512, *, reach: float = 0.0, threads: int = 1
    ) -> Pick | None:
        """Tell what is seen at a pixel, x and y from the upper left corner of the picture.

        Lines and edges are picked within reach pixels.
        """
        picked = self._pick(x, y, reach, size, threads=threads)
        return None if picked is None else Pick(*picked)

    # ---- For notebooks -------------------------------------------------------------------

    def _repr_svg_(self) -> str | None:
        if self._is_empty() or self._polygons() > _MOST_POLYGONS_AS_SVG:
            return None
        try:
            return self.svg(self._size_in_notebooks())
        except _displayfile.Error:
            return None

    def _repr_png_(self) -> bytes | None:
        if self._is_empty() or self._polygons() <= _MOST_POLYGONS_AS_SVG:
            return None
        try:
            return self.png(self._size_in_notebooks())
        except _displayfile.Error:
            return None

    def _size_in_notebooks(self) -> tuple[int, int]:
        aspect = self._aspect_ratio()
        width = _SIZE_IN_NOTEBOOKS * min(1.0, aspect)
        height = _SIZE_IN_NOTEBOOKS / max(1.0, aspect)
        return max(1, round(width)), max(1, round(height))

    # ---- What may be asked ---------------------------------------------------------------

    @property
    def segments(self) -> list[int]:
        """The names of all segments, in order of creation."""
        return self._segments()

    @property
    def open_segment_name(self) -> int | None:
        """The name of the open segment; None if none is."""
        return self._open_segment_name() or None

    @property
    def polygons(self) -> int:
        """The number of polygons in the display file."""
        return self._polygons()

    @property
    def aspect_ratio(self) -> float:
        """The width over the height of the pictures that segments are viewed for."""
        return self._aspect_ratio()

    def set_aspect_ratio(self, aspect: float) -> None:
        """Set it for the segments that are opened from now on."""
        self._set_aspect_ratio(aspect)

    def set_threads(self, threads: int) -> None:
        """Set the number of threads of close_segment's sort, whose result is the same for any."""
        self._set_threads(threads)

    def to_device(self, point: _Numbers) -> tuple[float, float, float] | None:
        """Where a point of the model is in the view in force: x and y from 0 to 1, y up.

        None if it is not before the eye.
        """
        return self._to_device(point)

    # ---- Options -------------------------------------------------------------------------

    def _checked(self, options: dict[str, typing.Any]) -> dict[str, typing.Any]:
        self._require_lines(options.pop("lines", None))
        return options
