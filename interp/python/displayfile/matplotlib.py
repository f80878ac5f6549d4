"""Exact visibility for matplotlib's three-dimensional axes.

exact(ax) makes an Axes3D draw its surfaces, polygons, lines and markers with hidden surfaces
removed exactly, across artists.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d import Axes3D

from . import _matplotlib_private as private
from ._displayfile import Error
from ._matplotlib_scene import Markers, Scene, is_scatter, is_taken

__all__ = ["Exact", "exact"]

_METHODS = ("depth-sort", "bsp")
_LINE_ORDERS = ("entry", "depth")


def exact(
    ax: Axes3D,
    *,
    method: str = "depth-sort",
    lift: float = 0.0,
    line_order: str = "entry",
    halo: float = 0.0,
    clip: bool = False,
    off: bool = False,
) -> Exact:
    """Make the axes draw with exact visibility from now on.

    Polygons, lines and markers are hidden where opaque polygons are in front of them, across
    artists, including those added later.

    Parameters
    ----------
    ax : Axes3D
        Three-dimensional axes.
    method : str, optional
        "depth-sort", or "bsp", which cuts more.
    lift : float, optional
        Moves lines and markers toward the viewer by this fraction of the scene's depth. Those in
        the plane of a polygon are visible without it. A curve on a bent surface needs some, such as
        0.01: between its points it passes below the polygons.
    line_order : str, optional
        Which of two lines that cross is drawn over the other: "entry", the later one, or "depth",
        the nearer one. Lines behind translucent polygons stay in the order of method.
    halo : float, optional
        With "depth", the gap beside a line where another one crosses in front of it, in points; 0
        for none.
    clip : bool, optional
        Crop polygons and lines where they pass the axes' limits, and leave out markers outside of
        them.
    off : bool, optional
        Restore the axes.

    Returns
    -------
    Exact
        The Exact that draws them; its remove method restores the axes, too.

    Raises
    ------
    Error
        Axes that are not three-dimensional, an option of another type or out of range, or a version
        of matplotlib without a required attribute.
    """
    _require_axes(ax)
    options = _checked(
        {"method": method, "lift": lift, "line_order": line_order, "halo": halo, "clip": clip}
    )
    off = _switch(off, "off")
    private.require_axes(ax)
    handle = getattr(vars(ax).get("draw"), "__self__", None)
    if not isinstance(handle, Exact):
        handle = Exact(ax)
    vars(handle).update(options)
    ax.stale = True
    if off:
        handle.remove()
    else:
        ax.draw = handle._draw
    return handle


def _require_axes(ax: Any) -> None:
    if isinstance(ax, Axes3D):
        return
    advice = ""
    if isinstance(ax, Figure):
        advice = ": call exact for each of its axes, such as fig.axes[0]"
    elif isinstance(ax, (np.ndarray, list, tuple)):
        advice = ": call exact for each of the axes in it"
    elif isinstance(ax, Axes):
        advice = ": these axes have no projection='3d'"
    raise Error(f"exact: expected an Axes3D, not {type(ax).__name__}{advice}")


def _checked(options: dict[str, Any]) -> dict[str, Any]:
    """The options of exact, with numbers as float."""
    method, line_order = options["method"], options["line_order"]
    if not isinstance(method, str) or method not in _METHODS:
        raise Error(f"method {method!r}: expected depth-sort or bsp")
    lift, halo = _number(options["lift"], "lift"), _number(options["halo"], "halo")
    clip = _switch(options["clip"], "clip")
    if not 0.0 <= lift < 1.0:
        raise Error(f"lift: {lift}: expected 0 or more, and less than 1")
    if not isinstance(line_order, str) or line_order not in _LINE_ORDERS:
        raise Error(f"line_order {line_order!r}: expected entry or depth")
    if not 0.0 <= halo <= 1e4:
        raise Error(f"halo: {halo}: expected 0 to 10000 points")
    if halo > 0.0 and line_order == "entry":
        raise Error(f"halo: {halo} with line_order 'entry': expected line_order depth")
    return {**options, "lift": lift, "halo": halo, "clip": clip}


def _number(value: Any, what: str) -> float:
    if isinstance(value, (str, bytes, bool)) or not hasattr(value, "__float__"):
        raise Error(f"{what}: expected a number, not {type(value).__name__}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise Error(f"{what}: expected a number, not {type(value).__name__}") from None


def _switch(value: Any, what: str) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise Error(f"{what}: expected True or False, not {type(value).__name__}")
    return bool(value)


class Exact:
    """Draws axes with exact visibility. Returned by exact()."""

    ax: Axes3D
    """The axes."""
    method: str
    """As in exact; it may be set."""
    lift: float
    """As in exact; it may be set."""
    line_order: str
    """As in exact; it may be set."""
    halo: float
    """As in exact; it may be set."""
    clip: bool
    """As in exact; it may be set."""

    def __init__(self, ax: Axes3D) -> None:
        vars(self)["ax"] = ax

    def __setattr__(self, name: str, value: Any) -> None:
        options = self._options()
        if name not in options:
            raise Error(f"exact has no option {name}: expected {', '.join(options)}")
        vars(self).update(_checked({**options, name: value}))
        self.ax.stale = True

    def __repr__(self) -> str:
        return f"<Exact: {', '.join(f'{name}={value!r}' for name, value in self._options().items())}>"

    def _options(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "ax"}

    def remove(self) -> None:
        """Restore the axes."""
        if getattr(vars(self.ax).get("draw"), "__self__", None) is self:
            del self.ax.draw
            self.ax.stale = True

    def _draw(self, renderer: Any) -> None:
        ax = self.ax
        groups: dict[float, list[Any]] = {}
        drawn: list[Any] = []
        for artist in private.children(ax):
            if not is_taken(artist):
                drawn.append(artist)
                continue
            # Without a computed order the artists' order is kept: each is a scene by itself.
            group = groups.setdefault(0.0 if ax.computed_zorder else artist.get_zorder(), [])
            if not group:
                drawn.append(group)
            group.append(artist)
        shown: list[Any] = []
        for entry in drawn:
            if isinstance(entry, list):
                scene = Scene(
                    *(ax, entry, self.method, self.lift),
                    *(self.line_order, self.halo, self.clip),
                )
                shown.append(scene)
                shown += [Markers(scene, artist) for artist in entry if is_scatter(artist)]
            else:
                shown.append(entry)
        with private.children_replaced(ax, shown):
            type(ax).draw(ax, renderer)
