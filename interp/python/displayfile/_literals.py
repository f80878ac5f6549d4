"""The words of options, for type checkers: as methods() and the formats have them."""

from __future__ import annotations

import typing

Method = typing.Literal[
    "auto",
    "none",
    "back-face",
    "z-buffer",
    "bsp",
    "depth-sort",
    "map",
    "scan-line",
    "scan-line-z",
    "ray-cast",
    "world-ray-cast",
    "warnock",
    "plain-z-buffer",
    "plain-z-buffer=float",
    "plain-z-buffer=16",
    "plain-z-buffer=24",
    "plain-z-buffer=32",
    "plain-z-buffer=double",
    "plain-scan-line",
    "plain-warnock",
    "plain-bsp",
    "roberts",
    "appel",
    "franklin",
    "perimeter",
    "plain-appel",
    "colour-rule",
]
Format = typing.Literal["png", "ppm", "svg", "pdf", "eps", "dxf"]
HiddenLines = typing.Literal["none", "dashed"]
LineOrder = typing.Literal["entry", "depth"]
Scope = typing.Literal["segment", "all"]
Device = typing.Literal["software", "osmesa"]
Axis = typing.Literal["x", "y", "z", "-x", "-y", "-z"]
