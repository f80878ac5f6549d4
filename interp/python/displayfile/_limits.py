"""What work may use at most."""

from __future__ import annotations

import typing

from . import _displayfile

if typing.TYPE_CHECKING:
    import types


class limits:
    """What is called in a with block may use at most.

    Sorts, lines, maps, pictures and whatever else takes long, of systems, of sort, visible_pieces and
    visible_lines, and of matplotlib's axes, and the wait for another thread's call on the same
    system. A call that would use more raises LimitReached, and
    changes nothing. The block's limits are those of its thread, and there of its context: of an
    asyncio task, and of tasks that it begins while the block lasts, but of no other one. Of blocks
    within each other the innermost counts.
    """

    def __init__(
        self,
        *,
        pieces: int | None = None,
        comparisons: int | None = None,
        bytes: int | None = None,
        seconds: float | None = None,
    ) -> None:
        """Make limits; what is not said is not limited.

        Args:
            pieces: Into which polygons are cut, that lines are seen in, or edges of a map: of one
                operation.
            comparisons: Of polygons and lines with each other, of all calls together. They are
                counted in lumps.
            bytes: That the tables of one operation take.
            seconds: From the beginning of the block on.

        Raises:
            Error: A number below 0, or of another type.
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
