"""A display-file 3D graphics system with exact hidden surfaces, in pixels and vectors.

System has every user routine of drawing programs as a method, and draws; a PicklableSystem can be
sent to other processes. sort, visible_pieces and visible_lines take polygons as arrays and return
arrays, for programs that draw by their own means.
"""

from ._calls import Calls, PicklableSystem
from ._drawing import Pick, Pieces
from ._displayfile import Error, LimitReached, __version__, methods, user_routines
from ._limits import limits
from ._polygons import (
    PolygonPieces,
    VisibleLines,
    VisiblePieces,
    sort,
    visible_lines,
    visible_pieces,
)
from ._picture import Picture
from ._system import System
from ._turntable import Turntable
from ._views import Views

__all__ = [
    "Calls",
    "Error",
    "LimitReached",
    "Pick",
    "Picture",
    "PicklableSystem",
    "Pieces",
    "PolygonPieces",
    "System",
    "Turntable",
    "Views",
    "VisibleLines",
    "VisiblePieces",
    "__version__",
    "limits",
    "methods",
    "sort",
    "user_routines",
    "visible_lines",
    "visible_pieces",
]
