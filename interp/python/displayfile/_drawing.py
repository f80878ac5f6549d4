"""What a system draws: pictures, in memory and in files."""

from __future__ import annotations

import typing

from . import _colours, _displayfile, _files
from ._picture import Picture
from ._turntable import Turntable
from ._views import Views

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from ._displayfile import _Numbers, _OneColour, _Path, _Size, _SizeOfFile
    from ._literals import Device, Format, HiddenLines, LineOrder, Method, Scope

_MOST_POLYGONS_AS_SVG = 2000
_MOST_BYTES_AS_SVG = 300_000
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


class Drawing(_displayfile.System):
    """The methods of System that draw."""

    # ---- Pictures ------------------------------------------------------------------------

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: typing.Literal[False] = ...,
        depth: typing.Literal[False] = ...,
        hidden: Method | None = ...,
        lines: str | None = ...,
        hidden_lines: HiddenLines | None = ...,
        line_order: LineOrder | None = ...,
        line_halo: float | None = ...,
        scope: Scope | None = ...,
        precision: str | None = ...,
        background: _OneColour | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int | None = ...,
        threads: int = ...,
        device: Device | None = ...,
    ) -> npt.NDArray[np.uint8]:
        ...

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: typing.Literal[True],
        depth: bool = ...,
        hidden: Method | None = ...,
        lines: str | None = ...,
        hidden_lines: HiddenLines | None = ...,
        line_order: LineOrder | None = ...,
        line_halo: float | None = ...,
        scope: Scope | None = ...,
        precision: str | None = ...,
        background: _OneColour | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int | None = ...,
        threads: int = ...,
        device: Device | None = ...,
    ) -> Picture:
        ...

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: bool = ...,
        depth: typing.Literal[True],
        hidden: Method | None = ...,
        lines: str | None = ...,
        hidden_lines: HiddenLines | None = ...,
        line_order: LineOrder | None = ...,
        line_halo: float | None = ...,
        scope: Scope | None = ...,
        precision: str | None = ...,
        background: _OneColour | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int | None = ...,
        threads: int = ...,
        device: Device | None = ...,
    ) -> Picture:
        ...

    @typing.overload
    def draw(
        self,
        size: _Size = ...,
        *,
        ids: bool = ...,
        depth: bool = ...,
        hidden: Method | None = ...,
        lines: str | None = ...,
        hidden_lines: HiddenLines | None = ...,
        line_order: LineOrder | None = ...,
        line_halo: float | None = ...,
        scope: Scope | None = ...,
        precision: str | None = ...,
        background: _OneColour | None = ...,
        rows: tuple[int, int] | None = ...,
        samples: int | None = ...,
        threads: int = ...,
        device: Device | None = ...,
    ) -> npt.NDArray[np.uint8] | Picture:
        ...

    def draw(
        self,
        size: _Size = 512,
        *,
        ids: bool = False,
        depth: bool = False,
        hidden: Method | None = None,
        lines: str | None = None,
        hidden_lines: HiddenLines | None = None,
        line_order: LineOrder | None = None,
        line_halo: float | None = None,
        scope: Scope | None = None,
        precision: str | None = None,
        background: _OneColour | None = None,
        rows: tuple[int, int] | None = None,
        samples: int | None = None,
        threads: int = 1,
        device: Device | None = None,
    ) -> npt.NDArray[np.uint8] | Picture:
        """Draw the visible segments into memory.

        Options that are None use the system's settings. Drawing again is fast where little changed.
        If only the background is visible, a UserWarning gives the reason, here and in svg, save and
        the like; it is most precise for System(retain=True).

        Parameters
        ----------
        size : int or (int, int), optional
            (width, height) in pixels, or one number for both: 1 to 65535.
        ids : bool, optional
            Also return the item buffer, at pixel centres. samples=1 is faster if colours are not
            used.
        depth : bool, optional
            Also return the depths at pixel centres.
        hidden : str, optional
            The hidden-surface or hidden-line method, one of methods(), such as "map", "z-buffer" or
            "franklin".
        lines : str, optional
            Kinds of polygon sides drawn as lines, as in System. They are selected when segments are
            closed, so the value must equal the system's.
        hidden_lines : str, optional
            "none", or "dashed" to also draw hidden parts of lines. An Error if there are some and
            the method, such as "none", draws in order of entry.
        line_order : str, optional
            Which of two lines that overlap is drawn over the other: "entry", the one entered later,
            or "depth", the nearer one. An Error if the method draws in order of entry.
        line_halo : float, optional
            With "depth", the gap beside a line where another one crosses in front of it, in pixels;
            0 for none.
        scope : str, optional
            "segment" or "all": what is sorted together.
        precision : str, optional
            "exact", or "roundoff=EPS" for the textbook's ROUNDOFF.
        background : colour, optional
            A colour, as in mesh, or "none" for a transparent one.
        rows : (int, int), optional
            (first, end), counted from the top: draw only these rows of the picture.
        samples : int, optional
            Antialiasing: samples per pixel side, 1 to 16. Default: 4, or the most that a picture of
            this size may have; 1 with "osmesa" and "plain-z-buffer".
        threads : int, optional
            Maximum number of threads, 1 to 1024; the picture does not depend on it.
        device : str, optional
            "software", or "osmesa" for comparison.

        Returns
        -------
        ndarray or Picture
            An array (H, W, 4) of red, green, blue and alpha, uint8, the top row first; with ids or
            depth, a Picture of all of them.

        Raises
        ------
        Error
            An option out of range, or not enough memory for the picture.
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
            background=_background(background),
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

        Parameters
        ----------
        views : int
            Number of views, at equal angles around the axis: 1 to 10000.
        size : int or (int, int), optional
            (width, height) in pixels, or one number for both.
        axis : array_like, optional
            The axis of rotation, (x, y, z), through the middle of the scene; default: the view's up
            direction.
        fit : bool, optional
            Fit the window to all views. Default: True if import_mesh fitted it.
        **options
            Those of draw; and for files of vectors those of save.

        Returns
        -------
        Turntable
            The turntable. Nothing is drawn yet.

        Raises
        ------
        Error
            A system that is neither System(retain=True) nor has a camera, segments in several
            views, a method that does not draw views, an option out of range.
        """
        options = self._checked(options)
        turned = self._turntable(views, size, axis, fit, **options)
        return Turntable(turned, bool(options.get("ids") or options.get("depth")))

    def views(self, size: _Size = 512, **options: typing.Any) -> Views:
        """Prepare the scene for views from any eye, such as for a slider in a notebook.

        Each view is transformed and drawn from what was entered, without entering it again. Later
        calls on the system do not change it.

        Parameters
        ----------
        size : int or (int, int), optional
            (width, height) in pixels, or one number for both.
        **options
            Those of draw; and for files of vectors those of save.

        Returns
        -------
        Views
            The views. Nothing is drawn yet.

        Raises
        ------
        Error
            A system that was entered without a camera and without System(retain=True), segments in
            several views, an option out of range.
        """
        options = self._checked(options)
        more_than_pixels = bool(options.get("ids") or options.get("depth"))
        return Views(self._views(size, **options), more_than_pixels)

    def svg(
        self, size: _SizeOfFile = None, *, hidden: Method | None = None, **options: typing.Any
    ) -> str:
        """Draw as SVG.

        Parameters
        ----------
        size : int, (int, int) or str, optional
            As in save.
        hidden : str, optional
            As in draw.
        **options
            Those of save.

        Returns
        -------
        str
            The text of the file.
        """
        return self._draw_as("svg", size, hidden=hidden, **self._checked(options)).decode()

    def pdf(
        self, size: _SizeOfFile = None, *, hidden: Method | None = None, **options: typing.Any
    ) -> bytes:
        """Draw as PDF.

        Parameters
        ----------
        size : int, (int, int) or str, optional
            As in save.
        hidden : str, optional
            As in draw.
        **options
            Those of save.

        Returns
        -------
        bytes
            The bytes of the file.
        """
        return self._draw_as("pdf", size, hidden=hidden, **self._checked(options))

    def eps(
        self, size: _SizeOfFile = None, *, hidden: Method | None = None, **options: typing.Any
    ) -> bytes:
        """Draw as EPS.

        Parameters
        ----------
        size : int, (int, int) or str, optional
            As in save.
        hidden : str, optional
            As in draw.
        **options
            Those of save.

        Returns
        -------
        bytes
            The bytes of the file.
        """
        return self._draw_as("eps", size, hidden=hidden, **self._checked(options))

    def png(
        self, size: _SizeOfFile = None, *, hidden: Method | None = None, **options: typing.Any
    ) -> bytes:
        """Draw as PNG.

        Parameters
        ----------
        size : int, (int, int) or str, optional
            As in save.
        hidden : str, optional
            As in draw.
        **options
            Those of save.

        Returns
        -------
        bytes
            The bytes of the file.
        """
        return self._draw_as("png", size, hidden=hidden, **self._checked(options))

    def ppm(
        self, size: _SizeOfFile = None, *, hidden: Method | None = None, **options: typing.Any
    ) -> bytes:
        """Draw as PPM.

        Parameters
        ----------
        size : int, (int, int) or str, optional
            As in save.
        hidden : str, optional
            As in draw.
        **options
            Those of save.

        Returns
        -------
        bytes
            The bytes of the file.
        """
        return self._draw_as("ppm", size, hidden=hidden, **self._checked(options))

    def save(
        self,
        path: _Path | typing.IO[bytes] | typing.IO[str],
        size: _SizeOfFile = None,
        *,
        format: Format | None = None,
        dpi: float | None = None,
        hidden: Method | None = None,
        background: _OneColour | None = None,
        samples: int | None = None,
        threads: int = 1,
        **options: typing.Any,
    ) -> None:
        """Draw into a file, which is written completely or not at all.

        Parameters
        ----------
        path : path_like or file
            The file; its name ends in .svg, .pdf, .eps, .png or .ppm, or with pens in .dxf. "-" is
            an Error, not standard output. Or an open file, such as io.BytesIO(), to which the whole
            picture is written: its format is set, or that of its name, or "png".
        size : int, (int, int) or str, optional
            (width, height) in pixels, for PDF and EPS in points; or one number for both; or
            millimetres, such as "80x60mm", which a PNG has with dpi. Default: 512; on paper its
            shape between the margins, if a camera fits the view and no aspect ratio is set.
        format : str, optional
            One of these, such as "svg", overriding the extension.
        dpi : float, optional
            For PNG: pixels per inch, which the file states; with paper the picture stands on a
            sheet in pixels.
        hidden : str, optional
            As in draw.
        background : colour, optional
            As in draw.
        samples : int, optional
            As in draw.
        threads : int, optional
            As in draw.
        **options
            Those of draw except ids and depth; and for vectors these:

        Other Parameters
        ----------------
        paper : str
            The paper, on which the picture is as large as fits: "A4", "A4-landscape", "letter" and
            others, or "WIDTHxHEIGHT" in mm.
        margin : float
            Margin of the paper in mm; default 10.
        vector_precision : float
            Unit in pixels to which vertices are rounded, 0.001 to 1; default 0.01.
        seams : str
            "trapped", or "butted" for smaller files, in which the background may show between
            neighbours.
        pick_ids : bool
            True: one element with a title per pick identifier, in SVG.
        font : str
            The font of texts, by the name that the system has for it; or "hershey", or
            "hershey:NAME", for strokes (Debian: hershey-fonts-data); for pixels too.
        text : str
            "outlines": letters as outlines, the same in every viewer; default "text".
        id_prefix : str
            Beginning of every id, and of every class with a rule, in SVG, in place of a hash:
            letters, digits, - and _.
        inline : bool
            True: no XML declaration in SVG, to stand in an HTML page.
        layers : bool
            True: a layer for each segment, with its title, in SVG and PDF.
        pens : bool
            True: strokes only, none drawn twice, in layers by pen and ordered for short travel, for
            plotters and laser cutters; on A4 unless paper is set.
        hatch : float or dict
            pens, with fills hatched: the distance of lines in mm where a fill is darkest; or a
            dictionary of spacing, angle (45 degrees), cross (True: dark fills get perpendicular
            lines too), colour and width (0.3 mm).
        pen_order : str
            With pens or hatch, "travel", or "cut": what lies inside of closed contours is drawn
            before them.
        pen_layers : list of colours
            With pens or hatch, a list of colours: the pens with these colours come first, in this
            order.

        Raises
        ------
        Error
            An option out of range, an unknown format, or a file that cannot be written.
        """
        options = self._checked(
            {
                "dpi": dpi,
                "hidden": hidden,
                "background": background,
                "samples": samples,
                "threads": threads,
                **options,
            }
        )
        if not _files.is_open_file(path):
            self._save(typing.cast("_Path", path), format, size, **options)
            return
        chosen = _files.format_of(path, format)
        _files.write(path, self._draw_as(chosen, size, **options), chosen)

    def dump(self, *, hidden: Method | None = None, **options: typing.Any) -> str:
        """Return the instructions of all segments.

        Parameters
        ----------
        hidden : str, optional
            As in draw.
        **options
            hidden_lines, line_order, line_halo, scope, precision and threads, as in draw; lines
            overlap as in a picture of 512 x 512 pixels.

        Returns
        -------
        str
            The text of the command's dump (displayfile/text/drawing_programs.md). It determines the
            drawing bit for bit.
        """
        return self._dump(hidden=hidden, **self._checked(options))

    def pieces(self, *, hidden: Method | None = None, **options: typing.Any) -> Pieces:
        """Return the pieces of a vector drawing, for programs that draw by their own means.

        With "depth-sort" and "bsp": all polygons from back to front, including hidden ones; with
        "map": the visible pieces only, and so with "auto", which is the map unless only lines are
        visible.

        Parameters
        ----------
        hidden : str, optional
            As in draw.
        **options
            hidden_lines, line_order, line_halo, scope, precision and threads, as in draw; lines
            overlap as in a picture of 512 x 512 pixels.

        Returns
        -------
        Pieces
            Arrays of pieces of polygons and lines, in drawing order.
        """
        return Pieces(*self._pieces(hidden=hidden, **self._checked(options)))

    def pick(
        self,
        x: float,
        y: float,
        size: _Size = 512,
        *,
        reach: float = 0.0,
        hidden: Method | None = None,
        scope: Scope | None = None,
        precision: str | None = None,
        threads: int = 1,
        device: Device | None = None,
    ) -> Pick | None:
        """Return what a picture shows at a pixel.

        For "none" and "back-face" that is the primitive entered last, for the other methods the
        nearest one, exactly unless the method rounds.

        Parameters
        ----------
        x : float
            Pixels from the left of the picture.
        y : float
            Pixels from its top.
        size : int or (int, int), optional
            The picture's size, as in draw.
        reach : float, optional
            Distance in pixels within which lines and edges are picked, before polygons.
        hidden : str, optional
            As in draw.
        scope : str, optional
            As in draw.
        precision : str, optional
            As in draw.
        threads : int, optional
            Maximum number of threads.
        device : str, optional
            As in draw.

        Returns
        -------
        Pick or None
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
        drawn = self._drawn_for_notebook()
        return drawn if isinstance(drawn, str) else None

    def _repr_png_(self) -> bytes | None:
        drawn = self._drawn_for_notebook()
        return drawn if isinstance(drawn, bytes) else None

    def _drawn_for_notebook(self) -> str | bytes | None:
        """As SVG if that is small, or else as PNG."""
        if self._is_empty():
            return None
        size = self._size_in_notebooks()
        try:
            if self._polygons() <= _MOST_POLYGONS_AS_SVG:
                text = self.svg(size, inline=True)
                if len(text) <= _MOST_BYTES_AS_SVG:
                    return text
            return self.png(size)
        except _displayfile.Error:
            return None

    def __repr__(self) -> str:
        names = self._segments()
        try:
            polygons = f"{self._polygons()} polygons"
        except _displayfile.Error as error:
            polygons = str(error)
        segments = f"{len(names)} segment{'' if len(names) == 1 else 's'}"
        camera = ", seen by a camera" if self._follows() else ""
        return f"<{type(self).__name__}: {segments}, {polygons}{camera}>"

    def _size_in_notebooks(self) -> tuple[int, int]:
        aspect = self._aspect_ratio()
        width = _SIZE_IN_NOTEBOOKS * min(1.0, aspect)
        height = _SIZE_IN_NOTEBOOKS / max(1.0, aspect)
        return max(1, round(width)), max(1, round(height))

    # ---- Options -------------------------------------------------------------------------

    def _checked(self, options: dict[str, typing.Any]) -> dict[str, typing.Any]:
        self._require_lines(options.pop("lines", None))
        if "background" in options:
            options["background"] = _background(options["background"])
        return options


def _background(value: typing.Any) -> typing.Any:
    """A colour as numbers; "none" and None as they are."""
    if not isinstance(value, str) or value == "none":
        return value
    return _colours.colour(value, "background")
