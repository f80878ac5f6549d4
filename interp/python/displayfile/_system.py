"""System: the user routines, and drawing."""

from __future__ import annotations

import typing

from . import _displayfile
from ._picture import Picture
from ._turntable import Turntable

if typing.TYPE_CHECKING:
    import os
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Colour, _Faces, _Numbers, _Size

_MOST_POLYGONS_AS_SVG = 2000
_SIZE_IN_NOTEBOOKS = 512


class Pick(typing.NamedTuple):
    """What is seen at a pixel."""

    kind: str
    """"polygon", "edge" or "line"."""
    id: int
    """Its pick identifier; -1 for a line without one."""
    segment: int
    """The name of its segment."""
    depth: float
    """In normalised device coordinates: 1 on the front plane, 0 on the back plane."""


class Pieces(typing.NamedTuple):
    """What is drawn, in order, as System.pieces returns it: K pieces of N points in all."""

    kinds: npt.NDArray[np.uint8]
    """(K,): 0 for a solid polygon, 1 for a polygon's sides alone, 2 for a line."""
    first: npt.NDArray[np.uint32]
    """(K + 1,): piece k has the points from first[k] to first[k + 1]."""
    points: npt.NDArray[np.float64]
    """(N, 3): x and y from 0 to 1 over the picture, y up, a larger z nearer."""
    sides: npt.NDArray[np.uint8]
    """(N,): not 0 if the side that ends at the point is drawn."""
    fills: npt.NDArray[np.float64]
    """(K, 3): red, green and blue from 0 to 1."""
    line_kinds: npt.NDArray[np.uint8]
    """(K,): 0 for solid lines, 1 for dashed ones, 2 for none."""
    line_colours: npt.NDArray[np.float64]
    """(K, 3): red, green and blue from 0 to 1, of lines and of sides that are drawn."""
    line_widths: npt.NDArray[np.float64]
    """(K,): in pixels."""
    picks: npt.NDArray[np.int32]
    """(K,): pick identifiers; -1 for a line without one."""
    segments: npt.NDArray[np.int32]
    """(K,): names of segments."""
    cuts: npt.NDArray[np.uint8]
    """(N,): 1 if the point is an end of a line, or of a side that is drawn, at which it is cut: it goes
    on there, but something may hide the rest. A thick line has no cap there."""


class System(_displayfile.System):
    """A graphics system: segments of lines and polygons, and how they are viewed and drawn.

    Every user routine of drawing programs is a method, with underscores for hyphens. Its arguments
    are numbers, words, True and False for on and off, and sequences or arrays of them: a point may
    be three numbers, and a polygon an array (n, 3).

    Every method raises Error for a call that cannot be carried out; the state is then what it
    was before the call. Several threads may call one system: their calls come one after another.

    World coordinates are those that primitives are entered in, before the modelling
    transformation, up to 1e100 in magnitude. Normalised device coordinates are those of the picture:
    x and y from 0 to 1 over the viewport's square, y up, and z from 0 on the back plane to 1 on the
    front plane. Colours are red, green and blue from 0 to 1; angles are in degrees.
    """

    def __init__(
        self,
        *,
        aspect: float | None = None,
        lines: str | None = None,
        retain: bool = False,
    ) -> None:
        """Make an empty system.

        Args:
            aspect: The width over the height of its pictures; 1 if it is not said. A window that
                the program does not set is widened to it. A picture of another shape is
                stretched, with a warning.
            lines: Which sides of polygons are lines, in place of what set_lines says: all, or
                several of outline, boundary, crease, crease=DEGREES, material and intersection,
                with commas between them.
            retain: Keep what is entered in world coordinates, too, for turntable.
        """
        super().__init__()
        if retain:
            self._retain()
        if aspect is not None:
            self._set_aspect_ratio(aspect)
        if lines is not None:
            self._replace_lines(lines)

    def __reduce__(self) -> typing.Any:
        raise _displayfile.Error(
            "a System is not pickled or copied: expected a PicklableSystem, which keeps its calls"
        )

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
        """Enter many polygons at once, several times as fast as one by one.

        They go into the open segment; if none is open, or segment is given, into one of their own,
        which is closed again. Styles in force stay what they were.

        Args:
            vertices: An array (N, 3), in world coordinates.
            faces: An array (M, k) of indices of vertices, or a sequence of sequences of them, of
                any lengths. With sides, all corners, one face after another.
            sides: An array (M,): how many corners each face has.
            segment: The name of their segment; one above all others if none is said.
            fill: The colour of all faces, or "hollow"; the fill style in force if none is said.
            fills: An array (M, 3): the colour of each face.
            picks: An array (M,): the pick identifier of each face, 0 or more. If none is said, that
                in force, or the ordinal of each.
            normals: An array (N, 3): the normals of vertices, for smooth shading.

        Returns:
            The name of the segment.

        Raises:
            Error: Another shape or type, a number that is not finite, an index that is of no
                vertex, a name that is in use. Nothing is entered then.
        """
        return self._mesh(vertices, faces, sides, segment, fill, fills, picks, normals)

    def surface(self, x: _Numbers, y: _Numbers, z: _Numbers, *, segment: int | None = None) -> int:
        """Enter the surface of heights over a grid.

        Where x and y stand at even steps it is surface_3's, otherwise polygons of four sides.

        Args:
            x: The places of the columns, (n,), in world coordinates; or those of all points, (m, n),
                as numpy.meshgrid makes them.
            y: The places of the rows, (m,); or those of all points, (m, n).
            z: The heights, (m, n). Where one is nan, or masked, there is a hole.
            segment: As in mesh.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: Fewer than 2 points either way, shapes that do not fit, a number that is infinite.
        """
        return self._surface(x, y, z, segment)

    def replay(self, text: str, name: str = "program") -> None:
        """Carry out a drawing program, whole or not at all.

        Args:
            text: One user routine a line (displayfile/text/drawing_programs.md).
            name: What messages call it.

        Raises:
            Error: A line that is not understood or that is refused; its file, line and column tell
                which. Nothing of the program is then carried out.
        """
        self._replay(text, name)

    def replay_file(self, path: str | os.PathLike[str]) -> None:
        """Carry out the drawing program in a file, as replay does.

        Args:
            path: The file, of UTF-8; "-" is an Error, and not standard input.

        Raises:
            Error: The same; or a file that cannot be read.
        """
        self._replay_file(path)

    def import_mesh(
        self,
        path: str | os.PathLike[str],
        *,
        colour: _Colour | None = None,
        eye: _Numbers | None = None,
        look_at: _Numbers | None = None,
        up: str | None = None,
        fov: float | None = None,
        parallel: bool = False,
        fit: bool = True,
        turning: bool = False,
    ) -> list[str]:
        """Read a mesh from a file and enter it, each of its objects as a segment.

        Where no window was set the view is fitted to it. What was not said before - light, fill and
        line style, hidden-line removal - is as the command has it for a mesh.

        Args:
            path: An OBJ, OFF, PLY or STL file, or another one that Assimp reads.
            colour: Of all faces, in place of those in the file.
            eye: From where the fitted view looks: (azimuth, elevation) in degrees, (0, 0) from the
                front, (90, 0) from the right; or (x, y, z) in world coordinates.
            look_at: What is in the middle of the picture, (x, y, z); the mesh's middle if it is not
                said.
            up: The axis that is upright: "x", "y", "z", "-x", "-y" or "-z"; or "auto", by the custom
                of the format where the file does not say it.
            fov: Degrees from the bottom of the picture to its top.
            parallel: A parallel projection in place of a perspective one, without fov.
            fit: Find the window, or the eye's distance for fov, in which the mesh is seen whole.
            turning: With fov, for a turntable: the eye is as far away as the mesh needs as it turns.

        Returns:
            What of it is not drawn, a sentence each.

        Raises:
            Error: A file that cannot be read, or is no such mesh; with its place if there is one. A
                camera where the view was set before.
        """
        return self._import_mesh(
            path,
            colour,
            eye=eye,
            look_at=look_at,
            up=up,
            fov=fov,
            parallel=parallel,
            fit=fit,
            turning=turning,
        )

    def record(self, on: bool = True) -> None:
        """Record every user routine that is carried out from now on.

        Args:
            on: False to stop; what was recorded stays.
        """
        self._record(on)

    @property
    def recording(self) -> str:
        """What was recorded, as a drawing program that makes the same display file."""
        return self._recording()

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
        samples: int | None = ...,
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
        samples: int | None = ...,
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
        samples: int | None = None,
        threads: int = 1,
        device: str | None = None,
    ) -> typing.Any:
        """Draw the visible segments into memory.

        What is None is as the system's routines say. Drawing again is quick where little changed.
        Where nothing is seen but the background, a UserWarning says why, here as by svg, save and the
        like; it says most of System(retain=True).

        Args:
            size: (width, height) in pixels, or one number for both: 1 to 65535.
            ids: Return the item buffer too: at the pixels' centres. Where colours are not used,
                samples=1 is quicker.
            depth: Return the depths too, likewise.
            hidden: The method that finds hidden surfaces or lines, one of methods(), such as "map",
                "z-buffer" or "franklin".
            lines: Which sides of polygons are lines, as System has it. They are selected as segments
                are closed, so that it must be what the system selects.
            hidden_lines: "none", or "dashed" to draw lines where they are hidden, too. An Error where
                some are and the method, such as "none", draws in order of entry.
            scope: "segment" or "all": what is put in order together.
            precision: "exact", or "roundoff=EPS" for the textbook's ROUNDOFF.
            background: A colour, or "none" for a transparent one.
            rows: (first, end), counted from the top: only these rows, as they are in the whole.
            samples: Antialiasing: samples along a pixel's side, 1 to 16. If it is None, 4, or the most
                that a picture of this size may have; 1 by "osmesa" and "plain-z-buffer".
            threads: How many may work, 1 to 1024; the picture is the same for any.
            device: "software", or "osmesa" to compare with.

        Returns:
            An array (H, W, 4) of red, green, blue and alpha, uint8, the top row first; or with ids or
            depth a Picture, which has it and them.

        Raises:
            Error: An option out of its range, or a picture for which there is not enough memory.
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

    def turntable(
        self,
        views: int,
        size: _Size = 512,
        *,
        axis: _Numbers | None = None,
        fit: bool | None = None,
        **options: typing.Any,
    ) -> Turntable:
        """Make a turntable of what is entered, whose views are those of the command's --turntable.

        Without hidden they are drawn from one BSP tree; by "z-buffer" and other methods that work in
        image space or find lines, each by itself. What is entered later does not change it.

        Args:
            views: How many, turned evenly all around: 1 to 10000.
            size: (width, height) in pixels, or one number for both.
            axis: What is turned about, (x, y, z), through the middle of what is entered; what is up
                in the view if it is not said.
            fit: Fit the window to all views. If it is not said, it is where import_mesh fitted it.
            options: Those of draw; and for files of vectors those of save.

        Returns:
            The turntable. Nothing is drawn yet.

        Raises:
            Error: A system that is not System(retain=True), segments of several views, a method that
                does not draw views, an option out of its range.
        """
        options = self._checked(options)
        turned = self._turntable(views, size, axis, fit, **options)
        return Turntable(turned, bool(options.get("ids") or options.get("depth")))

    def svg(self, size: _Size = 512, **options: typing.Any) -> str:
        """Draw as SVG.

        Args:
            size: (width, height) in pixels, or one number for both.
            options: Those of save.

        Returns:
            The text of the file.
        """
        return self._draw_as("svg", size, **self._checked(options)).decode()

    def pdf(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """Draw as PDF.

        Args:
            size: (width, height) in points, or one number for both.
            options: Those of save.

        Returns:
            The bytes of the file.
        """
        return self._draw_as("pdf", size, **self._checked(options))

    def eps(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """Draw as EPS.

        Args:
            size: (width, height) in points, or one number for both.
            options: Those of save.

        Returns:
            The bytes of the file.
        """
        return self._draw_as("eps", size, **self._checked(options))

    def png(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """Draw as PNG.

        Args:
            size: (width, height) in pixels, or one number for both.
            options: Those of save.

        Returns:
            The bytes of the file.
        """
        return self._draw_as("png", size, **self._checked(options))

    def ppm(self, size: _Size = 512, **options: typing.Any) -> bytes:
        """Draw as PPM.

        Args:
            size: (width, height) in pixels, or one number for both.
            options: Those of save.

        Returns:
            The bytes of the file.
        """
        return self._draw_as("ppm", size, **self._checked(options))

    def save(
        self,
        path: str | os.PathLike[str],
        size: _Size = 512,
        *,
        format: str | None = None,
        **options: typing.Any,
    ) -> None:
        """Draw into a file, which appears whole or not at all.

        Args:
            path: Where to; its name ends in .svg, .pdf, .eps, .png or .ppm. "-" is an Error, and
                not standard output.
            size: (width, height) in pixels, of PDF and EPS in points; or one number for both.
            format: One of these, such as "svg", in place of the name's.
            options: Those of draw but ids and depth; and for vectors these:
            paper: A sheet on which the picture lies, as large as fits: "A4", "letter" and others, or
                "WIDTHxHEIGHT" in mm.
            margin: Around it, in mm: 10.
            vector_precision: To what part of a pixel vertices are rounded, 0.001 to 1: 0.01.
            seams: "trapped", or "butted" for smaller files, in which what is behind may show between
                neighbours.
            pick_ids: True: each pick identifier is an element of its own with a title, in SVG.
            pens: True: strokes alone, none twice, in layers by pen and in an order with little
                travel, for plotters and lasers; on A4 unless another paper is said.
            hatch: pens, with fills as parallel lines: so many mm apart where a fill is darkest; or a
                dictionary of spacing, angle (45 degrees), cross (True: dark fills get lines at right
                angles too), colour and width (0.3 mm).

        Raises:
            Error: An option out of its range, an unknown format, or a file that cannot be written.
        """
        self._save(path, format, size, **self._checked(options))

    def dump(self, **options: typing.Any) -> str:
        """Write the instructions of all segments.

        Args:
            options: hidden, hidden_lines, scope, precision and threads, as draw has them.

        Returns:
            The text of the command's dump (displayfile/text/drawing_programs.md). It pins what is
            drawn to the bit.
        """
        return self._dump(**self._checked(options))

    def pieces(self, **options: typing.Any) -> Pieces:
        """Find what is drawn in vectors, for programs that draw by themselves.

        By "depth-sort" and "bsp" they are all polygons from back to front, also those that others
        hide; by "map" the visible pieces only, and so by "auto", which is the map unless there are
        only lines to see.

        Args:
            options: hidden, hidden_lines, scope, precision and threads, as draw has them.

        Returns:
            Arrays: pieces of polygons and lines, in the order in which they are drawn.
        """
        return Pieces(*self._pieces(**self._checked(options)))

    def pick(
        self,
        x: float,
        y: float,
        size: _Size = 512,
        *,
        reach: float = 0.0,
        hidden: str | None = None,
        scope: str | None = None,
        precision: str | None = None,
        threads: int = 1,
        device: str | None = None,
    ) -> Pick | None:
        """Tell what a picture shows at a pixel.

        By "none" and "back-face" that is what was entered last, by the other methods what is
        nearest, exactly unless the method rounds.

        Args:
            x: Pixels from the left of the picture.
            y: Pixels from its top.
            size: The picture's, as draw has it.
            reach: Within so many pixels lines and edges are picked, before polygons.
            hidden: As draw has it, as the following are.
            scope: Likewise.
            precision: Likewise.
            threads: How many may work.
            device: As draw has it.

        Returns:
            What is seen there; None if nothing is.
        """
        picked = self._pick(
            x,
            y,
            reach,
            size,
            hidden=hidden,
            scope=scope,
            precision=precision,
            threads=threads,
            device=device,
        )
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
        """Set the width over the height of pictures, for the segments that are opened from now on.

        Args:
            aspect: Above 0. Nothing records it.

        Raises:
            Error: A segment is open, or no such number.
        """
        self._set_aspect_ratio(aspect)

    def set_threads(self, threads: int) -> None:
        """Set how many threads may work as a segment is closed and put in order.

        Args:
            threads: 1 to 1024; the order is the same for any.
        """
        self._set_threads(threads)

    def to_device(self, point: _Numbers) -> tuple[float, float, float] | None:
        """Find where a point is in the view in force.

        Args:
            point: Three numbers, in world coordinates; the modelling transformation acts on them.

        Returns:
            Normalised device coordinates x, y and z, as set_image_centre takes them; None if the
            point is not before the eye.
        """
        return self._to_device(point)

    # ---- Options -------------------------------------------------------------------------

    def _checked(self, options: dict[str, typing.Any]) -> dict[str, typing.Any]:
        self._require_lines(options.pop("lines", None))
        return options
