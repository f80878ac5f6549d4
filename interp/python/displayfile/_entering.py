"""Arrays that a system enters: meshes, surfaces and lines, and what stands beside them."""

from __future__ import annotations

import typing
import warnings

from . import _colours, _displayfile, _other_meshes, _scalars
from ._drawing import Drawing

if typing.TYPE_CHECKING:
    from ._displayfile import _Crop, _Faces, _ManyColours, _Numbers, _OneColour, _Points


class Entering(Drawing):
    """The methods of System that enter arrays."""

    _scale: _colours.Scale | None = None
    """Of the values entered last."""
    _has_warned = False

    # ---- Meshes, surfaces and lines ------------------------------------------------------

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

        Parameters
        ----------
        vertices : array_like, shape (N, 3)
            An array (N, 3), in world coordinates.
        faces : array_like of int
            An array (M, k) of vertex indices, or a sequence of sequences of them, of any lengths.
            With sides: all corners, face after face.
        sides : array_like, optional
            An array (M,): the number of corners of each face.
        segment : int, optional
            The name of their segment; default: one above all others.
        fill : colour, optional
            The colour of all faces, or "hollow"; default: the fill style in force.
        fills : sequence of colours, optional
            The colour of each face: an array (M, 3), or a sequence of colours. With at="vertices",
            the colour of each vertex, (N, 3): linear over each triangle, which is entered in pieces
            of one colour each.
        picks : array_like, optional
            An array (M,): the pick identifier of each face, 0 or more; default: the one in force,
            or each face's ordinal, with values at vertices its index.
        normals : array_like, shape (N, 3), optional
            An array (N, 3): vertex normals for smooth shading. Default, if set_shading was called:
            the mean of the faces around each vertex; set_crease_angle keeps edges.
        values : array_like, optional
            Scalars that colours stand for: (M,), one for each face, or (N,), one for each vertex.
            Those of vertices are linear over each triangle, and each colour covers exactly its part
            of it, in pixels and vectors. Faces with a nan are light grey.
        at : {"faces", "vertices"}, optional
            "faces" or "vertices": with values, needed where there are as many of both; with fills,
            "vertices" for colours of vertices.
        cmap : object, optional
            The colour map: the name of one of matplotlib's, which is imported for it, such as
            "viridis"; one of its objects; an array (n, 3) of colours; or "displayfile". Default:
            the command's own.
        limits : (float, float), optional
            (lowest, highest) value of the colour map; default, also of one that is None: those of
            the values.
        levels : int or array_like, optional
            A number of bands of one colour each, or their bounds, instead of the colours of the
            whole map.

        Returns
        -------
        int
            The name of the segment.

        Raises
        ------
        Error
            A wrong shape or type, a number that is not finite, an index out of range, a name in
            use, colours that are not opaque. Nothing is entered then.
        """
        if values is None:
            _require_none("values", cmap=cmap, limits=limits, levels=levels)
            if fills is None:
                _require_none("values or fills", at=at)
            if fill is not None and not (_colours.is_a(fill, str) and fill == "hollow"):
                fill = _colours.colour(fill, "fill")
            of_vertices = None
            if fills is not None:
                fills = _colours.colours(fills, "fills")
                if _scalars.is_of_vertices(fills, at, vertices):
                    fills, of_vertices = None, fills
                    _require_none("fills of vertices", False, fill=fill)
            name = self._mesh(
                *(vertices, faces, sides, segment, fill, fills, picks, normals),
                *(None, True, of_vertices),
            )
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

        Parameters
        ----------
        x : array_like
            Coordinates of the columns, (n,), in world coordinates; or of all points, (m, n), as
            numpy.meshgrid returns them.
        y : array_like
            Coordinates of the rows, (m,); or of all points, (m, n).
        z : array_like
            Heights, (m, n). A nan or masked height makes a hole.
        segment : int, optional
            As in mesh.
        values : array_like, optional
            Scalars at the points, (m, n), that colours stand for, as in mesh; default, with cmap,
            limits or levels: the heights.
        cmap : object, optional
            As in mesh.
        limits : (float, float), optional
            As in mesh. The default is that of all values, also of those that crop cuts away.
        levels : int or array_like, optional
            As in mesh: filled contours.
        contours : int or array_like, optional
            Lines of equal value, or height: their levels, or how many there are between the lowest
            and the highest. In the line style, or black if that is not set or none.
        contour_colour : colour, optional
            The colour of contours, as in mesh.
        contour_width : float, optional
            Their width in pixels.
        crop : sequence of 3 ranges, optional
            A box beyond which the surface is cut away exactly: ((x-min, x-max), (y-min, y-max),
            (z-min, z-max)); None leaves all. Needs world coordinates without a modelling
            transformation, and no other cutting plane.

        Returns
        -------
        int
            The name of the segment, as mesh does.

        Raises
        ------
        Error
            Fewer than 2 points in a direction, shapes that do not match, an infinite number.
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

        Parameters
        ----------
        points : array_like, shape (N, 3)
            An array (N, 3), in world coordinates. A nan leaves a gap.
        closed : bool, optional
            True: also from the last point to the first.
        colour : colour, optional
            Their colour, as in mesh.
        width : float, optional
            Their width in pixels.
        segment : int, optional
            As in mesh.

        Returns
        -------
        int
            The name of the segment, as mesh does.

        Raises
        ------
        Error
            Fewer than 2 points without a gap between them, another shape, an infinite number.
        """
        runs = _scalars.runs_of(points, closed)
        of_lines = None if colour is None else _colours.colour(colour)
        name = self._polyline(*runs, segment, of_lines, width)
        self._warn_if_not_fitted()
        return name

    # ---- Meshes of other packages --------------------------------------------------------

    def from_trimesh(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter a trimesh.Trimesh: its faces, and their colours if it has some.

        Parameters
        ----------
        mesh : object
            The mesh, or any object with vertices and faces. trimesh is not imported.
        **options
            Those of mesh.

        Returns
        -------
        int
            The name of the segment, as mesh does.

        Raises
        ------
        Error
            As mesh does; or another object. A UserWarning names what is left out.
        """
        return self._enter_other(_other_meshes.of_trimesh(mesh), options)

    def from_meshio(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter the triangles, quadrilaterals and polygons of a meshio.Mesh.

        Parameters
        ----------
        mesh : object
            The mesh, or any object with points and cells. meshio is not imported.
        **options
            Those of mesh; values may be the name of one of its arrays of data.

        Returns
        -------
        int
            The name of the segment, as mesh does.

        Raises
        ------
        Error
            As mesh does; another object; or no faces. A UserWarning names what is left out.
        """
        return self._enter_other(_other_meshes.of_meshio(mesh), options)

    def from_pyvista(self, mesh: typing.Any, **options: typing.Any) -> int:
        """Enter the faces of a pyvista.PolyData, or the surface that another data set extracts.

        Parameters
        ----------
        mesh : object
            The mesh, or any object with points and padded faces. pyvista is not imported.
        **options
            Those of mesh; values may be the name of one of its arrays of data.

        Returns
        -------
        int
            The name of the segment, as mesh does.

        Raises
        ------
        Error
            As mesh does; or another object. A UserWarning names what is left out.
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

        Parameters
        ----------
        label : str, optional
            The text above it; a long one stands in several rows.
        ticks : array_like, optional
            The values beside it; default: the bounds of levels, or about eight round ones.
        letters : float, optional
            The size of letters as a part of the picture's height, as in set_text_style: 9 / 288 is
            9 points where the picture is 288 points high. Default: 0.026.
        segment : int, optional
            As in mesh.

        Returns
        -------
        int
            The name of its segment.

        Raises
        ------
        Error
            No values were entered, a segment is open, or ticks are outside of the colour map's
            limits.
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

        Parameters
        ----------
        entries : mapping
            The colour of each name.
        letters : float, optional
            As in colour_bar.
        segment : int, optional
            As in mesh.

        Returns
        -------
        int
            The name of its segment.

        Raises
        ------
        Error
            No names, an invalid colour, or a segment is open.
        """
        return self._beside(segment, *_scalars.legend(entries, letters))


def _require_none(what: str, missing: bool = True, **options: typing.Any) -> None:
    for name, value in options.items():
        if value is not None:
            needed = f"expected it with {what}" if missing else f"expected none with {what}"
            raise _displayfile.Error(f"{name}: {needed}")
