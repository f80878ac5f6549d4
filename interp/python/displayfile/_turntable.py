"""Turntable: views of a scene at equal angles."""

from __future__ import annotations

import typing

from . import _displayfile
from ._picture import Picture

if typing.TYPE_CHECKING:
    from ._displayfile import _Path

_MOST_BYTES = 8_000_000
"""Of the pictures that a notebook holds to turn them."""


class Turntable:
    """The views of a scene that rotates in front of a fixed camera and fixed lights.

    It shows the system's contents at the time of System.turntable; len() is the number of views. A
    view is the same, bit for bit, whichever others are drawn. Several threads may call one
    turntable; the calls are serialised. A notebook shows its views with a slider if they take up to
    8 MB as PNG, and otherwise the first one.
    """

    def __init__(self, views: _displayfile.Turntable, more_than_pixels: bool) -> None:
        """Called by System.turntable."""
        self._views = views
        self._more_than_pixels = more_than_pixels

    def __repr__(self) -> str:
        return f"<Turntable: {len(self)} views>"

    def __len__(self) -> int:
        return self._views._views()

    def _png(self, view: int) -> bytes:
        return _displayfile._png_of(Picture(*self._views._draw(view)).pixels)

    def _repr_png_(self) -> bytes:
        return self._png(0)

    def _repr_html_(self) -> str | None:
        """All views and a slider, in a page that needs nothing else; None if they are too large."""
        import base64

        frames: list[str] = []
        size = 0
        for view in range(len(self)):
            png = self._png(view)
            size += len(png)
            if size > _MOST_BYTES:
                return None
            hidden = ' style="display:none"' if view else ""
            data = base64.b64encode(png).decode()
            frames.append(f'<img alt="view {view}" src="data:image/png;base64,{data}"{hidden}>')
        show = (
            "this.parentNode.querySelectorAll('img').forEach("
            "(view, k) => view.style.display = k == this.value ? '' : 'none')"
        )
        slider = (
            f'<br><input type="range" min="0" max="{len(self) - 1}" value="0" '
            f'aria-label="view" oninput="{show}">'
        )
        return f"<div>{''.join(frames)}{slider}</div>"

    def draw(self, view: int) -> typing.Any:
        """Draw one of the views into memory.

        Parameters
        ----------
        view : int
            Its number, from 0.

        Returns
        -------
        object
            The same as System.draw.

        Raises
        ------
        Error
            No such view, or not enough memory for the picture.
        """
        picture = Picture(*self._views._draw(view))
        return picture if self._more_than_pixels else picture.pixels

    def save(self, path: _Path, views: tuple[int, int] | None = None) -> list[str]:
        """Draw views into files, numbered as by the command: turn-000.png for turn.png.

        Each file is written completely or not at all.

        Parameters
        ----------
        path : path_like
            The file name without the number; it ends in .svg, .pdf, .eps, .png or .ppm, or
            with pens in .dxf.
        views : (int, int), optional
            (first, end): only these; default: all.

        Returns
        -------
        list[str]
            The names of the files.

        Raises
        ------
        Error
            Views out of range, an unknown format, or a file that cannot be written; if this is
            known beforehand, nothing is drawn.
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
