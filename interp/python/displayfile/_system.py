"""System: the user routines, cameras, programs and files."""

from __future__ import annotations

import typing

from . import _colours, _displayfile
from ._entering import Entering

if typing.TYPE_CHECKING:
    import os
    from ._displayfile import _Numbers, _OneColour
    from ._literals import Axis


class System(Entering):
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

        Parameters
        ----------
        aspect : float, optional
            Width over height of its pictures; default 1. A window that the program does not set is
            widened to it. A picture with another aspect ratio is stretched, with a warning.
        lines : str, optional
            Kinds of polygon sides drawn as lines, overriding set_lines: all, or several of outline,
            boundary, crease, crease=DEGREES, material and intersection, separated by commas.
        retain : bool, optional
            Also keep primitives in world coordinates, for turntable.
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

        The view is fitted whenever a picture is drawn, to all that is entered, with room for texts,
        and for the picture's aspect ratio, unless System(aspect=) or set_aspect_ratio set one. A
        segment is in the picture when it is closed. A system whose view is not set gets this camera
        when mesh, surface or polyline is called: look() changes it. Then meshes and surfaces are lit
        from over the viewer's left shoulder, and filled in a light grey without lines, unless
        set_light, set_fill_style and set_line_style were called. Shapes that routines enter, such as
        sphere_3, are not lit and have black sides, unless set_light and set_line_style were called.

        A routine that sets view parameters, such as set_perspective or set_viewport, acts on later
        segments alone: earlier ones keep the view that they have.

        Parameters
        ----------
        eye : array_like, optional
            Viewpoint: (azimuth, elevation) in degrees, (0, 0) from the front and (90, 0) from the
            right; or (x, y, z) in world coordinates. Default: (30, 20).
        look_at : array_like, optional
            The point in the middle of the picture, (x, y, z); default: the middle of the scene.
        up : str, optional
            The up axis: "x", "y", "z", "-x", "-y" or "-z"; default "z". With "z" the front is the
            side of negative y.
        fov : float, optional
            Vertical angle of view in degrees; default: from four times the scene's radius.
        parallel : bool, optional
            Use a parallel instead of a perspective projection, without fov.
        fit : bool, optional
            Fit the window, or the eye's distance for fov, to show the whole scene. If False, the
            view is that of a ball of radius 1 at look_at or the origin.
        turning : bool, optional
            With fov, for views all around: fit the eye's distance for the rotating scene.

        Raises
        ------
        Error
            An invalid camera, an open segment, segments that were entered without a camera and
            without System(retain=True), or a view that was set by other routines.
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

    # ---- Programs and files ----------------------------------------------------------------

    def replay(self, text: str, name: str = "program") -> None:
        """Run a drawing program, completely or not at all.

        Parameters
        ----------
        text : str
            One user routine per line (displayfile/text/drawing_programs.md).
        name : str, optional
            Its name in messages.

        Raises
        ------
        Error
            A line that is not understood or is refused, with its file, line and column. Nothing of
            the program is then carried out.
        """
        self._replay(text, name)

    def replay_file(self, path: str | os.PathLike[str]) -> None:
        """Run the drawing program in a file, as replay does.

        Parameters
        ----------
        path : path_like
            A UTF-8 file; "-" is an Error, not standard input.

        Raises
        ------
        Error
            As in replay; or a file that cannot be read.
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

        Parameters
        ----------
        path : path_like
            An OBJ, OFF, PLY or STL file, or one that Assimp or OpenCASCADE (STEP, IGES) reads.
        colour : colour, optional
            Colour of all faces, overriding the file.
        eye : array_like, optional
            Viewpoint of the fitted view: (azimuth, elevation) in degrees, (0, 0) from the front,
            (90, 0) from the right; or (x, y, z) in world coordinates.
        look_at : array_like, optional
            The point in the middle of the picture, (x, y, z); default: the mesh's middle.
        up : str, optional
            The up axis: "x", "y", "z", "-x", "-y" or "-z"; or "auto": by the format's convention if
            the file does not state it.
        fov : float, optional
            Vertical angle of view in degrees.
        parallel : bool, optional
            Use a parallel instead of a perspective projection, without fov.
        fit : bool, optional
            Fit the window, or the eye's distance for fov, to show the whole mesh.
        turning : bool, optional
            With fov, for a turntable: fit the eye's distance for the rotating mesh.

        Returns
        -------
        list[str]
            The parts of the mesh that are not drawn, one sentence each.

        Raises
        ------
        Error
            A file that cannot be read or is not such a mesh, with the position if known. Camera
            options when the view was set before.
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

    def record(self, on: bool = True) -> None:
        """Record every user routine that succeeds from now on.

        Parameters
        ----------
        on : bool, optional
            False to stop; the recording is kept.
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

        Parameters
        ----------
        aspect : float
            Above 0. It is not recorded.

        Raises
        ------
        Error
            A segment is open, or the number is invalid.
        """
        self._set_aspect_ratio(aspect)

    def set_threads(self, threads: int) -> None:
        """Set the maximum number of threads for sorting a segment when it is closed.

        Parameters
        ----------
        threads : int
            1 to 1024; the order does not depend on it.
        """
        self._set_threads(threads)

    def to_device(self, point: _Numbers) -> tuple[float, float, float] | None:
        """Map a point by the view in force.

        Parameters
        ----------
        point : array_like
            Three numbers, in world coordinates; the modelling transformation acts on them.

        Returns
        -------
        (float, float, float) or None
            Normalised device coordinates x, y and z, as set_image_centre takes them; None if the
            point is not in front of the eye.
        """
        return self._to_device(point)
