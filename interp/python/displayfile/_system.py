"""System: the user routines, cameras and meshes."""

from __future__ import annotations

import typing
import warnings

from . import _colours, _displayfile, _other_meshes, _scalars
from ._drawing import Drawing

if typing.TYPE_CHECKING:
    import os
    from ._displayfile import _Crop, _Faces, _ManyColours, _Numbers, _OneColour, _Points
    from ._literals import Axis


class System(Drawing):
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
        self._scale: _colours.Scale | None = None
        self._has_warned = False
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

    # ---- Cameras -------------------------------------------------------------------------

    def look(
        self,
        *,
        eye: _Numbers | None = None,
        look_at: _Numbers | None = None,
        up: Axis | None = None,
        fov: float | None = None,
        parallel: bool = False,
        fit: bool = True,
        turning: bool = False,
    ) -> None:
        """Set the camera for all that is entered, before and after this call.

        The view is fitted whenever a picture is drawn, to all segments that are closed, and for the
        picture's aspect ratio, unless System(aspect=) or set_aspect_ratio set one. A system whose
        view is not set gets this camera when mesh or surface is called: look() changes it. Then meshes
        and surfaces are lit from over the viewer's left shoulder, and filled in a light grey without
        lines, unless set_light, set_fill_style and set_line_style were called.

        A routine that sets view parameters, such as set_perspective or set_viewport, acts on later
        segments alone: earlier ones keep the view that they have.

        Args:
            eye: Viewpoint: (azimuth, elevation) in degrees, (0, 0) from the front and (90, 0) from
                the right; or (x, y, z) in world coordinates. Default: (30, 20).
            look_at: The point in the middle of the picture, (x, y, z); default: the middle of the
                scene.
            up: The up axis: "x", "y", "z", "-x", "-y" or "-z"; default "z". With "z" the front is
                the side of negative y.
            fov: Vertical angle of view in degrees; default: from four times the scene's radius.
            parallel: Use a parallel instead of a perspective projection, without fov.
            fit: Fit the window, or the eye's distance for fov, to show the whole scene. If False,
                the view is that of a ball of radius 1 at look_at or the origin.
            turning: With fov, for views all around: fit the eye's distance for the rotating scene.

        Raises:
            Error: An invalid camera, an open segment, segments that were entered without a camera
                and without System(retain=True), or a view that was set by other routines.
        """
        self._look(
            eye=eye,
            look_at=look_at,
            up=up,
            fov=fov,
            parallel=parallel,
            fit=fit,
            turning=turning,
        )

    # ---- Entering ------------------------------------------------------------------------

    def mesh(
        self,
        vertices: _Points,
        faces: _Faces,
        *,
        sides: _Numbers | None = None,
        segment: int | None = None,
        fill: _OneColour | None = None,
        fills: _ManyColours | None = None,
        picks: _Numbers | None = None,
        normals: _Points | None = None,
        values: _Numbers | None = None,
        at: typing.Literal["faces", "vertices"] | None = None,
        cmap: typing.Any = None,
        limits: tuple[float | None, float | None] | None = None,
        levels: int | _Numbers | None = None,
    ) -> int:
        """Enter many polygons at once, several times as fast as one by one.

        They enter the open segment; if none is open, or segment is given, a new segment, which is
        closed again. Styles in force are unchanged. If no view was set, it is fitted to them and to
        what follows, as by look(); a UserWarning, if other segments were entered before.

        A colour is a name of CSS or matplotlib, "#rrggbb", a grey such as "0.5", or red, green and
        blue from 0 to 1, also with an alpha of 1. Faces in colours of values are not lit, and so not
        shaded, unless set_light was called.

        Args:
            vertices: An array (N, 3), in world coordinates.
            faces: An array (M, k) of vertex indices, or a sequence of sequences of them, of any
                lengths. With sides: all corners, face after face.
            sides: An array (M,): the number of corners of each face.
            segment: The name of their segment; default: one above all others.
            fill: The colour of all faces, or "hollow"; default: the fill style in force.
            fills: The colour of each face: an array (M, 3), or a sequence of colours.
            picks: An array (M,): the pick identifier of each face, 0 or more; default: the one in
                force, or each face's ordinal, with values at vertices its index.
            normals: An array (N, 3): vertex normals for smooth shading. Default, if set_shading was
                called: the mean of the faces around each vertex; set_crease_angle keeps edges.
            values: Scalars that colours stand for: (M,), one for each face, or (N,), one for each
                vertex. Those of vertices are linear over each triangle, and each colour covers
                exactly its part of it, in pixels and vectors. Faces with a nan are light grey.
            at: "faces" or "vertices", where there are as many of both.
            cmap: The colour map: the name of one of matplotlib's, which is imported for it, such as
                "viridis"; one of its objects; an array (n, 3) of colours; or "displayfile".
                Default: the command's own.
            limits: (lowest, highest) value of the colour map; default, also of one that is None:
                those of the values.
            levels: A number of bands of one colour each, or their bounds, instead of the colours of
                the whole map.

        Returns:
            The name of the segment.

        Raises:
            Error: A wrong shape or type, a number that is not finite, an index out of range, a name
                in use, colours that are not opaque. Nothing is entered then.
        """
        if values is None:
            _require_none("values", at=at, cmap=cmap, limits=limits, levels=levels)
            if fill is not None and not (isinstance(fill, str) and fill == "hollow"):
                fill = _colours.colour(fill, "fill")
            if fills is not None:
                fills = _colours.colours(fills, "fills")
            name = self._mesh(vertices, faces, sides, segment, fill, fills, picks, normals)
            self._warn_if_not_fitted()
            return name
        _require_none("colours of values", False, fill=fill, fills=fills)
        scalars = _colours.numbers(values, "values")
        points = _colours.numbers(vertices, "vertices")
        triangles, corners, face, count = _displayfile._triangles_of(vertices, faces, sides)
        place = _scalars.place_of(scalars, at, count, len(points))
        scale = _colours.scale_of(scalars, cmap, limits, levels)
        if place == "faces":
            fills = scale.of_steps(scale.steps(scalars))
            name = self._mesh(
                vertices, faces, sides, segment, None, fills, picks, normals, None, False
            )
        else:
            if normals is None:
                at_corners = self._normals_at_corners(vertices, faces, sides)
                of_triangles = None if at_corners is None else at_corners[corners]
            else:
                of_triangles = _scalars.normals_of(normals, len(points))[triangles]
            pieces = _scalars.pieces_of(
                points[triangles], face, scalars[triangles], scale, of_triangles
            )
            name = self._enter_pieces(
                pieces, _scalars.picks_of(picks, count), segment, (vertices, faces, sides)
            )
        self._scale = scale
        self._warn_if_not_fitted()
        return name

    def _warn_if_not_fitted(self) -> None:
        """Warns once where the camera cannot show what was entered before."""
        if self._has_warned or self._follows() or self._is_view_set():
            return
        self._has_warned = True
        warnings.warn(
            "no view is set, and no camera fits it to segments that were entered before: expected "
            "look() before the first of them, or a view; x and y from -1 to 1 are shown",
            stacklevel=3,
        )

    def _enter_pieces(
        self,
        pieces: _scalars.Pieces,
        picks: typing.Any,
        segment: int | None,
        outline: tuple[typing.Any, typing.Any, typing.Any],
    ) -> int:
        import numpy as np

        return self._mesh(
            pieces.points,
            np.arange(len(pieces.points)),
            pieces.sides,
            segment,
            None,
            pieces.fills,
            picks[pieces.face],
            pieces.normals,
            outline,
            False,
        )

    def surface(
        self,
        x: _Numbers,
        y: _Numbers,
        z: _Numbers,
        *,
        segment: int | None = None,
        values: _Numbers | None = None,
        cmap: typing.Any = None,
        limits: tuple[float | None, float | None] | None = None,
        levels: int | _Numbers | None = None,
        contours: int | _Numbers | None = None,
        contour_colour: _OneColour | None = None,
        contour_width: float | None = None,
        crop: _Crop | None = None,
    ) -> int:
        """Enter the surface of heights over a grid.

        If x and y are evenly spaced it is entered by surface_3, otherwise as quadrilaterals. If no
        view was set, it is fitted as in mesh. With set_shading its points have normals, as the
        vertices of a mesh. The line style draws the grid; by default there is none.

        Args:
            x: Coordinates of the columns, (n,), in world coordinates; or of all points, (m, n), as
                numpy.meshgrid returns them.
            y: Coordinates of the rows, (m,); or of all points, (m, n).
            z: Heights, (m, n). A nan or masked height makes a hole.
            segment: As in mesh.
            values: Scalars at the points, (m, n), that colours stand for, as in mesh; default, with
                cmap, limits or levels: the heights.
            cmap: As in mesh.
            limits: As in mesh.
            levels: As in mesh: filled contours.
            contours: Lines of equal value, or height: their levels, or how many there are between
                the lowest and the highest. In the line style, or black if that is not set or none.
            contour_colour: The colour of contours, as in mesh.
            contour_width: Their width in pixels.
            crop: A box beyond which the surface is cut away exactly: ((x-min, x-max), (y-min, y-max),
                (z-min, z-max)); None leaves all. Needs world coordinates without a modelling
                transformation, and no other cutting plane.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: Fewer than 2 points in a direction, shapes that do not match, an infinite number.
        """
        planes = _scalars.planes_of(crop)
        if contours is None:
            _require_none("contours", contour_colour=contour_colour, contour_width=contour_width)
        if contour_colour is not None:
            contour_colour = _colours.colour(contour_colour, "contour_colour")
        style = (contour_colour, contour_width)
        coloured = any(option is not None for option in (values, cmap, limits, levels))
        if not coloured and contours is None:
            name = self._surface(x, y, z, segment, planes)
            self._warn_if_not_fitted()
            return name
        heights, points = _scalars.points_of_grid(x, y, z)
        scalars = heights if values is None else _colours.numbers(values, "values")
        if scalars.shape != heights.shape:
            raise _displayfile.Error(
                f"values: shape {scalars.shape}, expected that of z, {heights.shape}"
            )
        triangles, cell = _scalars.triangles_of_grid(heights)
        corners, at_corners = points[triangles], scalars.ravel()[triangles]
        lines = _scalars.contours_of(corners, at_corners, contours, limits)
        if not coloured:
            name = self._surface(x, y, z, segment, planes, lines, None, *style)
            self._warn_if_not_fitted()
            return name
        scale = _colours.scale_of(scalars, cmap, limits, levels)
        normals = self._normals_at_corners(_scalars.without_nan(points), triangles, None)
        of_triangles = None if normals is None else normals.reshape(-1, 3, 3)
        pieces = _scalars.pieces_of(corners, cell, at_corners, scale, of_triangles)
        name = self._surface(x, y, z, segment, planes, lines, tuple(pieces), *style)
        self._scale = scale
        self._warn_if_not_fitted()
        return name

    def polyline(
        self,
        points: _Points,
        *,
        closed: bool = False,
        colour: _OneColour | None = None,
        width: float | None = None,
        segment: int | None = None,
    ) -> int:
        """Enter lines from each point to the next.

        They are drawn in the line style, or in black if that is not set or none, and hidden by
        polygons. If no view was set, it is fitted as in mesh.

        Args:
            points: An array (N, 3), in world coordinates. A nan leaves a gap.
            closed: True: also from the last point to the first.
            colour: Their colour, as in mesh.
            width: Their width in pixels.
            segment: As in mesh.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: Fewer than 2 points without a gap between them, another shape, an infinite number.
        """
        runs = _scalars.runs_of(points, closed)
        of_lines = None if colour is None else _colours.colour(colour)
        name = self._polyline(*runs, segment, of_lines, width)
        self._warn_if_not_fitted()
        return name

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
        colour: _OneColour | None = None,
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
            None if colour is None else _colours.colour(colour),
            eye=eye,
            look_at=look_at,
            up=up,
            fov=fov,
            parallel=parallel,
            fit=fit,
            turning=turning,
        )

    # ---- Meshes of other packages --------------------------------------------------------

    def from_trimesh(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter a trimesh.Trimesh: its faces, and their colours if it has some.

        Args:
            mesh: The mesh, or any object with vertices and faces. trimesh is not imported.
            options: Those of mesh.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: As mesh does; or another object. A UserWarning names what is left out.
        """
        return self._enter_other(_other_meshes.of_trimesh(mesh), options)

    def from_meshio(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter the triangles, quadrilaterals and polygons of a meshio.Mesh.

        Args:
            mesh: The mesh, or any object with points and cells. meshio is not imported.
            options: Those of mesh; values may be the name of one of its arrays of data.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: As mesh does; another object; or no faces. A UserWarning names what is left out.
        """
        return self._enter_other(_other_meshes.of_meshio(mesh), options)

    def from_pyvista(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter the faces of a pyvista.PolyData, or the surface that another data set extracts.

        Args:
            mesh: The mesh, or any object with points and padded faces. pyvista is not imported.
            options: Those of mesh; values may be the name of one of its arrays of data.

        Returns:
            The name of the segment, as mesh does.

        Raises:
            Error: As mesh does; or another object. A UserWarning names what is left out.
        """
        return self._enter_other(_other_meshes.of_pyvista(mesh), options)

    def _enter_other(self, found: _other_meshes.Faces, options: dict[str, typing.Any]) -> int:
        coloured = any(options.get(name) is not None for name in ("fill", "fills", "values"))
        fills = {} if coloured or found.fills is None else {"fills": found.fills}
        if isinstance(options.get("values"), str):
            options = {**options, "values": _other_meshes.array_of(found, options["values"])}
        name = self.mesh(found.vertices, found.faces, sides=found.sides, **fills, **options)
        if found.left_out:
            warnings.warn(f"left out: {', '.join(found.left_out)}", stacklevel=3)
        return name

    # ---- Beside the picture --------------------------------------------------------------

    def colour_bar(
        self,
        label: str = "",
        *,
        ticks: _Numbers | None = None,
        letters: float | None = None,
        segment: int | None = None,
    ) -> int:
        """Enter a bar of the colours of the values entered last, at the picture's right.

        It keeps its place in every view of the system. Where the camera follows what is entered, the
        scene makes room for it.

        Args:
            label: The text above it; a long one stands in several rows.
            ticks: The values beside it; default: the bounds of levels, or about eight round ones.
            letters: The size of letters as a part of the picture's height, as in set_text_style:
                9 / 288 is 9 points where the picture is 288 points high. Default: 0.026.
            segment: As in mesh.

        Returns:
            The name of its segment.

        Raises:
            Error: No values were entered, a segment is open, or ticks are outside of the colour
                map's limits.
        """
        if self._scale is None:
            raise _displayfile.Error("colour_bar: no values were entered: expected mesh(values=)")
        return self._beside(segment, *_scalars.colour_bar(self._scale, label, ticks, letters))

    def legend(
        self,
        entries: typing.Mapping[str, _OneColour],
        *,
        letters: float | None = None,
        segment: int | None = None,
    ) -> int:
        """Enter names beside their colours, at the picture's right, as colour_bar does.

        Args:
            entries: The colour of each name.
            letters: As in colour_bar.
            segment: As in mesh.

        Returns:
            The name of its segment.

        Raises:
            Error: No names, an invalid colour, or a segment is open.
        """
        return self._beside(segment, *_scalars.legend(entries, letters))

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


def _require_none(what: str, missing: bool = True, **options: typing.Any) -> None:
    for name, value in options.items():
        if value is not None:
            needed = f"expected it with {what}" if missing else f"expected none with {what}"
            raise _displayfile.Error(f"{name}: {needed}")
