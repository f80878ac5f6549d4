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
    """The primitive visible at a pixel."""

    kind: str
    """"polygon", "edge" or "line"."""
    id: int
    """Its pick identifier; -1 for a line without one."""
    segment: int
    """The name of its segment."""
    depth: float
    """In normalised device coordinates: 1 on the front plane, 0 on the back plane."""


class Pieces(typing.NamedTuple):
    """Drawn pieces in drawing order, as System.pieces returns them: K pieces with N points in
    total."""

    kinds: npt.NDArray[np.uint8]
    """(K,): 0 for a solid polygon, 1 for only a polygon's sides, 2 for a line."""
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
    """(N,): 1 if a line, or a drawn side, is cut at the point: it continues, but its rest may be
    hidden. A thick line has no cap there."""


class System(_displayfile.System):
    """A graphics system: segments of lines and polygons, their view and their drawing.

    Every user routine of drawing programs is a method, with underscores for hyphens. Arguments are
    numbers, words, True or False for on or off, and sequences or arrays of them: a point may be
    three numbers, a polygon an array (n, 3).

    Every method raises Error for an invalid call and then leaves the state unchanged. Several
    threads may call one system; the calls are serialised.

    World coordinates are those in which primitives are entered, before the modelling
    transformation, up to 1e100 in magnitude. Normalised device coordinates are those of the
    picture: x and y from 0 to 1 over the viewport's square, y up, and z from 0 on the back plane to
    1 on the front plane. Colours are red, green and blue from 0 to 1; angles are in degrees.
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
            aspect: Width over height of its pictures; default 1. A window that the program does not
                set is widened to it. A picture with another aspect ratio is stretched, with a
                warning.
            lines: Kinds of polygon sides drawn as lines, overriding set_lines: all, or several of
                outline, boundary, crease, crease=DEGREES, material and intersection, separated by
                commas.
            retain: Also keep primitives in world coordinates, for turntable.
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

    # ---- Entering ------------------------------------------------------------------------

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

        They enter the open segment; if none is open, or segment is given, a new segment, which is
        closed again. Styles in force are unchanged.

        Args:
            vertices: An array (N, 3), in world coordinates.
            faces: An array (M, k) of vertex indices, or a sequence of sequences of them, of any
                lengths. With sides: all corners, face after face.
            sides: An array (M,): the number of corners of each face.
            segment: The name of their segment; default: one above all others.
            fill: The colour of all faces, or "hollow"; default: the fill style in force.
            fills: An array (M, 3): the colour of each face.
            picks: An array (M,): the pick identifier of each face, 0 or more; default: the one in
                force, or each face's ordinal.
            normals: An array (N, 3): vertex normals for smooth shading.

        Returns:
            The name of the segment.

        Raises:
            Error: A wrong shape or type, a number that is not finite, an index out of range, a name
                in use. Nothing is entered then.
        """
        return self._mesh(vertices, faces, sides, segment, fill, fills, picks, normals)

    def surface(self, x: _Numbers, y: _Numbers, z: _Numbers, *, segment: int | None = None) -> int:
        """Enter the surface of heights over a grid.

        If x and y are evenly spaced it is entered by surface_3, otherwise as quadrilaterals.

        Args:
            x: Coordinates of the columns, (n,), in world coordinates; or of all points, (m, n), as
                numpy.meshgrid returns them.
            y: Coordinates of the rows, (m,); or of all points, (m, n).
            z: Heights, (m, n). A nan or masked height makes a hole.
            segment: As in mesh.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: Fewer than 2 points in a direction, shapes that do not match, an infinite number.
        """
        return self._surface(x, y, z, segment)

    def replay(self, text: str, name: str = "program") -> None:
        """Run a drawing program, completely or not at all.

        Args:
            text: One user routine per line (displayfile/text/drawing_programs.md).
            name: Its name in messages.

        Raises:
            Error: A line that is not understood or is refused, with its file, line and column.
                Nothing of the program is then carried out.
        """
        self._replay(text, name)

    def replay_file(self, path: str | os.PathLike[str]) -> None:
        """Run the drawing program in a file, as replay does.

        Args:
            path: A UTF-8 file; "-" is an Error, not standard input.

        Raises:
            Error: As in replay; or a file that cannot be read.
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
        """Read a mesh from a file and enter each of its objects as a segment.

        If no window was set, the view is fitted to the mesh. Settings not made before - light, fill
        and line style, hidden-line removal - have the command's defaults for meshes.

        Args:
            path: An OBJ, OFF, PLY or STL file, or another one that Assimp reads.
            colour: Colour of all faces, overriding the file.
            eye: Viewpoint of the fitted view: (azimuth, elevation) in degrees, (0, 0) from the
                front, (90, 0) from the right; or (x, y, z) in world coordinates.
            look_at: The point in the middle of the picture, (x, y, z); default: the mesh's middle.
            up: The up axis: "x", "y", "z", "-x", "-y" or "-z"; or "auto": by the format's
                convention if the file does not state it.
            fov: Vertical angle of view in degrees.
            parallel: Use a parallel instead of a perspective projection, without fov.
            fit: Fit the window, or the eye's distance for fov, to show the whole mesh.
            turning: With fov, for a turntable: fit the eye's distance for the rotating mesh.

        Returns:
            The parts of the mesh that are not drawn, one sentence each.

        Raises:
            Error: A file that cannot be read or is not such a mesh, with the position if known.
                Camera options when the view was set before.
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
        """Record every user routine that succeeds from now on.

        Args:
            on: False to stop; the recording is kept.
        """
        self._record(on)

    @property
    def recording(self) -> str:
        """The recording, as a drawing program that makes the same display file."""
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
        line_order: str | None = ...,
        line_halo: float | None = ...,
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
        line_order: str | None = ...,
        line_halo: float | None = ...,
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
        line_order: str | None = None,
        line_halo: float | None = None,
        scope: str | None = None,
        precision: str | None = None,
        background: _Colour | typing.Literal["none"] | None = None,
        rows: tuple[int, int] | None = None,
        samples: int | None = None,
        threads: int = 1,
        device: str | None = None,
    ) -> typing.Any:
        """Draw the visible segments into memory.

        Options that are None use the system's settings. Drawing again is fast where little changed.
        If only the background is visible, a UserWarning gives the reason, here and in svg, save and
        the like; it is most precise for System(retain=True).

        Args:
            size: (width, height) in pixels, or one number for both: 1 to 65535.
            ids: Also return the item buffer, at pixel centres. samples=1 is faster if colours are
                not used.
            depth: Also return the depths at pixel centres.
            hidden: The hidden-surface or hidden-line method, one of methods(), such as "map",
                "z-buffer" or "franklin".
            lines: Kinds of polygon sides drawn as lines, as in System. They are selected when
                segments are closed, so the value must equal the system's.
            hidden_lines: "none", or "dashed" to also draw hidden parts of lines. An Error if there
                are some and the method, such as "none", draws in order of entry.
            line_order: Which of two lines that overlap is drawn over the other: "entry", the one
                entered later, or "depth", the nearer one. An Error if the method draws in order of
                entry.
            line_halo: With "depth", the gap beside a line where another one crosses in front of it,
                in pixels; 0 for none.
            scope: "segment" or "all": what is sorted together.
            precision: "exact", or "roundoff=EPS" for the textbook's ROUNDOFF.
            background: A colour, or "none" for a transparent one.
            rows: (first, end), counted from the top: draw only these rows of the picture.
            samples: Antialiasing: samples per pixel side, 1 to 16. Default: 4, or the most that a
                picture of this size may have; 1 with "osmesa" and "plain-z-buffer".
            threads: Maximum number of threads, 1 to 1024; the picture does not depend on it.
            device: "software", or "osmesa" for comparison.

        Returns:
            An array (H, W, 4) of red, green, blue and alpha, uint8, the top row first; with ids or
            depth, a Picture of all of them.

        Raises:
            Error: An option out of range, or not enough memory for the picture.
        """
        self._require_lines(lines)
        pixels, of_ids, of_depth = self._draw(
            size,
            ids=ids,
            depth=depth,
            hidden=hidden,
            hidden_lines=hidden_lines,
            line_order=line_order,
            line_halo=line_halo,
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
        """Make a turntable of the scene, whose views are those of the command's --turntable.

        By default they are drawn from one BSP tree; with "z-buffer" and other methods that work in
        image space or find lines, each view by itself. Later calls on the system do not change it.

        Args:
            views: Number of views, at equal angles around the axis: 1 to 10000.
            size: (width, height) in pixels, or one number for both.
            axis: The axis of rotation, (x, y, z), through the middle of the scene; default: the
                view's up direction.
            fit: Fit the window to all views. Default: True if import_mesh fitted it.
            options: Those of draw; and for files of vectors those of save.

        Returns:
            The turntable. Nothing is drawn yet.

        Raises:
            Error: A system that is not System(retain=True), segments in several views, a method
                that does not draw views, an option out of range.
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
        """Draw into a file, which is written completely or not at all.

        Args:
            path: The file; its name ends in .svg, .pdf, .eps, .png or .ppm. "-" is an Error, not
                standard output.
            size: (width, height) in pixels, for PDF and EPS in points; or one number for both.
            format: One of these, such as "svg", overriding the extension.
            options: Those of draw except ids and depth; and for vectors these:
            paper: The paper, on which the picture is as large as fits: "A4", "letter" and others,
                or "WIDTHxHEIGHT" in mm.
            margin: Margin of the paper in mm; default 10.
            vector_precision: Unit in pixels to which vertices are rounded, 0.001 to 1; default
                0.01.
            seams: "trapped", or "butted" for smaller files, in which the background may show
                between neighbours.
            pick_ids: True: one element with a title per pick identifier, in SVG.
            font: The font of texts, by the name that the system has for it; or "hershey", or
                "hershey:NAME", for strokes (Debian: hershey-fonts-data); for pixels too.
            text: "outlines": letters as outlines, the same in every viewer; default "text".
            id_prefix: Beginning of every id, and of every class with a rule, in SVG, in place of a
                hash: letters, digits, - and _.
            inline: True: no XML declaration in SVG, to stand in an HTML page.
            layers: True: a layer for each segment, with its title, in SVG and PDF.
            pens: True: strokes only, none drawn twice, in layers by pen and ordered for short
                travel, for plotters and laser cutters; on A4 unless paper is set.
            hatch: pens, with fills hatched: the distance of lines in mm where a fill is darkest; or
                a dictionary of spacing, angle (45 degrees), cross (True: dark fills get
                perpendicular lines too), colour and width (0.3 mm).
            pen_order: With pens or hatch, "travel", or "cut": what lies inside of closed contours
                is drawn before them.
            pen_layers: With pens or hatch, a list of colours: the pens with these colours come
                first, in this order.
            dpi: For PNG: pixels per inch, which the file states; with paper the picture stands on a
                sheet in pixels.

        Raises:
            Error: An option out of range, an unknown format, or a file that cannot be written.
        """
        self._save(path, format, size, **self._checked(options))

    def dump(self, **options: typing.Any) -> str:
        """Return the instructions of all segments.

        Args:
            options: hidden, hidden_lines, line_order, line_halo, scope, precision and threads, as in
                draw; lines overlap as in a picture of 512 x 512 pixels.

        Returns:
            The text of the command's dump (displayfile/text/drawing_programs.md). It determines the
            drawing bit for bit.
        """
        return self._dump(**self._checked(options))

    def pieces(self, **options: typing.Any) -> Pieces:
        """Return the pieces of a vector drawing, for programs that draw by their own means.

        With "depth-sort" and "bsp": all polygons from back to front, including hidden ones; with
        "map": the visible pieces only, and so with "auto", which is the map unless only lines are
        visible.

        Args:
            options: hidden, hidden_lines, line_order, line_halo, scope, precision and threads, as in
                draw; lines overlap as in a picture of 512 x 512 pixels.

        Returns:
            Arrays of pieces of polygons and lines, in drawing order.
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
        """Return what a picture shows at a pixel.

        For "none" and "back-face" that is the primitive entered last, for the other methods the
        nearest one, exactly unless the method rounds.

        Args:
            x: Pixels from the left of the picture.
            y: Pixels from its top.
            size: The picture's size, as in draw.
            reach: Distance in pixels within which lines and edges are picked, before polygons.
            hidden: As in draw.
            scope: As in draw.
            precision: As in draw.
            threads: Maximum number of threads.
            device: As in draw.

        Returns:
            The Pick; None if nothing is visible there.
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

    # ---- Properties ----------------------------------------------------------------------

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
        """Width over height of the pictures for which segments are viewed."""
        return self._aspect_ratio()

    def set_aspect_ratio(self, aspect: float) -> None:
        """Set the width over height of pictures, for segments opened from now on.

        Args:
            aspect: Above 0. It is not recorded.

        Raises:
            Error: A segment is open, or the number is invalid.
        """
        self._set_aspect_ratio(aspect)

    def set_threads(self, threads: int) -> None:
        """Set the maximum number of threads for sorting a segment when it is closed.

        Args:
            threads: 1 to 1024; the order does not depend on it.
        """
        self._set_threads(threads)

    def to_device(self, point: _Numbers) -> tuple[float, float, float] | None:
        """Map a point by the view in force.

        Args:
            point: Three numbers, in world coordinates; the modelling transformation acts on them.

        Returns:
            Normalised device coordinates x, y and z, as set_image_centre takes them; None if the
            point is not in front of the eye.
        """
        return self._to_device(point)

    # ---- Options -------------------------------------------------------------------------

    def _checked(self, options: dict[str, typing.Any]) -> dict[str, typing.Any]:
        self._require_lines(options.pop("lines", None))
        return options
