"""Picture: the result of draw with ids or depth."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


class Picture(typing.NamedTuple):
    """The result of System.draw with ids or depth. A notebook shows its pixels."""

    pixels: npt.NDArray[np.uint8]
    """(H, W, 4): red, green, blue and alpha, the top row first."""
    ids: npt.NDArray[np.int32] | None
    """(H, W): the pick identifier of the visible fill, -1 for none; None without ids."""
    depth: npt.NDArray[np.float64] | None
    """(H, W): the depth of the visible fill, 1 on the front plane and 0 on the back plane; minus
    infinity where there is none; None without depth."""

    def _repr_png_(self) -> bytes:
        return _displayfile._png_of(self.pixels)

    def __repr__(self) -> str:
        height, width = self.pixels.shape[:2]
        parts = [f"{width} x {height} pixels"]
        if self.ids is not None:
            parts.append("ids")
        if self.depth is not None:
            parts.append("depth")
        return f"<Picture: {', '.join(parts)}>"
