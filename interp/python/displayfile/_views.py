"""Views: a scene from any eye."""

from __future__ import annotations

import typing
import warnings

from . import _displayfile
from ._picture import Picture

if typing.TYPE_CHECKING:
    from ._displayfile import _Numbers, _Path


class Views:
    """A scene from any eye: fast for many views, as a slider in a notebook needs.

    It shows the system's contents at the time of System.views, without colour bars and legends. A
    view is that of a system that was entered in it. The light turns with the camera, and is rounded
    then, unless set_light set one. Several threads may call one object; the calls are serialised.
    """

    def __init__(self, views: _displayfile.Views, more_than_pixels: bool) -> None:
        """Called by System.views."""
        self._views = views
        self._more_than_pixels = more_than_pixels
        if views._leaves_out():
            warnings.warn("views are without colour bars and legends", stacklevel=3)

    def __repr__(self) -> str:
        return "<Views: a scene that draw, picture and save show from any eye>"

    def draw(
        self,
        eye: _Numbers | None = None,
        *,
        look_at: _Numbers | None = None,
        up: str | None = None,
        fov: float | None = None,
        parallel: bool | None = None,
        fit: bool | None = None,
        turning: bool | None = None,
    ) -> typing.Any:
        """Draw the scene in one view into memory.

        Parameters
        ----------
        eye : array_like, optional
            As in System.look; default, here and below: as the system's look() set it.
        look_at : array_like, optional
            As in System.look.
        up : str, optional
            As in System.look.
        fov : float, optional
            As in System.look.
        parallel : bool, optional
            As in System.look.
        fit : bool, optional
            As in System.look.
        turning : bool, optional
            As in System.look.

        Returns
        -------
        object
            The same as System.draw.

        Raises
        ------
        Error
            An invalid camera, or not enough memory for the picture.
        """
        drawn = self._views._draw(
            eye=eye,
            look_at=look_at,
            up=up,
            fov=fov,
            parallel=parallel,
            fit=fit,
            turning=turning,
        )
        return Picture(*drawn) if self._more_than_pixels else drawn[0]

    def picture(self, eye: _Numbers | None = None, **camera: typing.Any) -> Picture:
        """Draw the scene in one view, as a Picture that a notebook shows.

        Parameters
        ----------
        eye : array_like, optional
            As in draw.
        **camera
            The others of draw.

        Returns
        -------
        Picture
            The Picture, with item buffer and depths if System.views set them.
        """
        drawn = self.draw(eye, **camera)
        return drawn if isinstance(drawn, Picture) else Picture(drawn, None, None)

    def save(
        self,
        path: _Path,
        eye: _Numbers | None = None,
        *,
        format: str | None = None,
        **camera: typing.Any,
    ) -> None:
        """Draw the scene in one view into a file, which is written completely or not at all.

        Parameters
        ----------
        path : path_like
            As in System.save.
        eye : array_like, optional
            As in draw.
        format : str, optional
            As in System.save.
        **camera
            The others of draw.

        Raises
        ------
        Error
            An invalid camera, an unknown format, or a file that cannot be written.
        """
        self._views._save(path, format, eye=eye, **camera)
