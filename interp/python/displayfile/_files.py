"""Files to which pictures are written: paths, or open ones."""

from __future__ import annotations

import io
import os
import typing

from ._displayfile import Error

_TEXTS = ("svg", "eps", "dxf")


def is_open_file(to: typing.Any) -> bool:
    return hasattr(to, "write") and not isinstance(to, (str, bytes, os.PathLike))


def format_of(file: typing.Any, format: str | None) -> str:
    """The format as set, or by the name of the file, or png."""
    if format is not None:
        return format
    name = getattr(file, "name", None)
    extension = os.path.splitext(name)[1] if isinstance(name, str) else ""
    return extension[1:] or "png"


def write(file: typing.Any, contents: bytes, format: str) -> None:
    """Write a whole picture into a file of bytes, or of text if it is one of text."""
    if isinstance(file, io.TextIOBase):
        if format.lstrip(".").lower() not in _TEXTS:
            raise Error(f"format '{format}': expected a file of bytes, not one of text")
        file.write(contents.decode())
    else:
        file.write(contents)
