"""Limits on work."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import types


class limits:
    """Limits on the calls in a with block.

    They apply to all long operations - sorts, lines, maps, pictures - of systems, of sort,
    visible_pieces and visible_lines, and of matplotlib's axes, and to waiting for another thread's
    call on the same system. A call that exceeds them raises LimitReached and changes nothing. The
    limits hold for the block's thread and context: for an asyncio task and the tasks that it starts
    during the block, and for no other. Of nested blocks the innermost applies.
    """

    def __init__(
        self,
        *,
        pieces: int | None = None,
        comparisons: int | None = None,
        bytes: int | None = None,
        seconds: float | None = None,
    ) -> None:
        """Make limits; None means no limit.

        Parameters
        ----------
        pieces : int, optional
            Pieces of cut polygons, visible pieces of lines, or edges of a map, in one operation.
        comparisons : int, optional
            Comparisons of polygons and lines with each other, in all calls together. They are
            counted in batches.
        bytes : int, optional
            Memory of one operation's tables.
        seconds : float, optional
            Time since the beginning of the block.

        Raises
        ------
        Error
            A number below 0, or of another type.
        """
        self._limits = (pieces, comparisons, bytes, seconds)
        _displayfile._require_limits(*self._limits)

    def __enter__(self) -> limits:
        _displayfile._begin_limits(self, *self._limits)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        raised: BaseException | None,
        traceback: types.TracebackType | None,
    ) -> None:
        _displayfile._end_limits(self)
