"""Turntable: a scene in views evenly around it."""

from __future__ import annotations

import typing

from . import _displayfile
from ._picture import Picture

if typing.TYPE_CHECKING:
    from ._displayfile import _Path


class Turntable:
    """The views of a scene that turns before a camera and lights that stay.

    It is of what the system had when System.turntable made it; len() of it is the number of views. A
    view is the same, bit for bit, whichever others are drawn. Several threads may call one
    turntable: their calls come one after another.
    """

    def __init__(self, views: _displayfile.Turntable, more_than_pixels: bool) -> None:
        """For System.turntable, which makes it."""
        self._views = views
        self._more_than_pixels = more_than_pixels

    def __len__(self) -> int:
        return self._views._views()

    def draw(self, view: int) -> typing.Any:
        """Draw one of the views into memory.

        Args:
            view: Its number, from 0.

        Returns:
            What System.draw returns.

        Raises:
            Error: No such view, or a picture for which there is not enough memory.
        """
        picture = Picture(*self._views._draw(view))
        return picture if self._more_than_pixels else picture.pixels

    def save(self, path: _Path, views: tuple[int, int] | None = None) -> list[str]:
        """Draw views into files, numbered as the command does it: turn-000.png for turn.png.

        Each file appears whole or not at all.

        Args:
            path: Where to, without the number; its name ends in .svg, .pdf, .eps, .png or .ppm.
            views: (first, end): only these; all if it is not said.

        Returns:
            The names of the files.

        Raises:
            Error: Views that there are not, an unknown format, or a file that cannot be written: if
                that is so from the start, nothing is drawn.
        """
        first, end = self._range(views)
        self._views._require_drawable(first, end, path)
        for view in range(first, end):
            self._views._save(view, path)
        return [_displayfile._numbered(path, view, len(self)) for view in range(first, end)]

    def _range(self, views: tuple[int, int] | None) -> tuple[int, int]:
        if views is None:
            return 0, len(self)
        try:
            first, end = views
        except (TypeError, ValueError):
            raise _displayfile.Error("views: expected the first and the end") from None
        return first, end
