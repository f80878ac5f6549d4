"""Picture: what draw returns where more than pixels is asked for."""

from __future__ import annotations

import typing

if typing.TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


class Picture(typing.NamedTuple):
    """What System.draw returns where ids or depth are asked for."""

    pixels: npt.NDArray[np.uint8]
    """(H, W, 4): red, green, blue and alpha, the top row first."""
    ids: npt.NDArray[np.int32] | None
    """(H, W): the pick identifier of the fill that is seen, -1 for none; None if not asked for."""
    depth: npt.NDArray[np.float64] | None
    """(H, W): that of the fill that is seen, 1 on the front plane and 0 on the back plane; minus
    infinity where none is seen; None if not asked for."""
