"""Writes reference.md from the docstrings of the package.

    python3 interp/python/tests/write_reference.py [FILE]
"""

from __future__ import annotations

import ast
import inspect
import re
import sys
import textwrap
from pathlib import Path
from typing import Any, Iterator

import displayfile
from displayfile import _displayfile, dask, matplotlib
from displayfile._drawing import Drawing
from displayfile._entering import Entering

PAGE = Path(__file__).resolve().parents[1] / "reference.md"
WIDTH = 120
SECTIONS = ("Parameters", "Other Parameters", "Returns", "Raises")
BEGIN = """# Reference

`tests/write_reference.py` generates this page from the docstrings of the package, which `help()` shows too.
[README.md](README.md) is the introduction.
"""


# ---- Docstrings --------------------------------------------------------------------------


def docstring_of(thing: Any) -> str:
    docstring = inspect.getdoc(thing)
    if not docstring:
        raise ValueError(f"{thing!r} has no docstring")
    return docstring


def sections_of(docstring: str) -> dict[str, str]:
    """What stands before all sections, under "", and what stands in each, as numpydoc has them."""
    sections = {"": ""}
    name = ""
    lines = docstring.splitlines()
    for line, below in zip(lines, [*lines[1:], ""]):
        if line in SECTIONS and below == "-" * len(line):
            name = line
        elif line != "-" * len(name) or not name:
            sections[name] = sections.get(name, "") + line + "\n"
    return {name: text.strip() for name, text in sections.items()}


def entries_of(section: str) -> Iterator[tuple[str, str, str]]:
    """Names, types and what is written of each: lines that are indented go on."""
    for entry in re.split(r"\n(?! )", section):
        first, _, text = entry.partition("\n")
        name, _, of = first.partition(" : ")
        yield name.lstrip("*"), of, " ".join(text.split())


def fields_of(kind: type) -> Iterator[tuple[str, str, str]]:
    """Names, types and docstrings of members: those that stand below them."""
    body = ast.parse(textwrap.dedent(inspect.getsource(kind))).body[0]
    assert isinstance(body, ast.ClassDef)
    for member, below in zip(body.body, body.body[1:]):
        if isinstance(member, ast.AnnAssign):
            assert isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant), member
            of = ast.unparse(member.annotation)
            array = re.match(r"npt\.NDArray\[np\.(\w+)\]", of)
            yield ast.unparse(member.target), array[1].rstrip(
                "_"
            ) if array else of, below.value.value


# ---- Markdown ----------------------------------------------------------------------------


def wrapped(text: str, first: str = "", others: str = "") -> str:
    return textwrap.fill(
        " ".join(text.split()),
        WIDTH,
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )


def paragraphs(text: str) -> str:
    return "\n\n".join(wrapped(paragraph) for paragraph in text.split("\n\n"))


def listed(section: str) -> str:
    return "\n".join(
        wrapped(f"**{name}**{f' ({of})' if of else ''}: {text}", "- ", "  ")
        for name, of, text in entries_of(section)
    )


def signature_of(function: Any, name: str) -> str:
    """As it is called: without self and without types."""
    signature = inspect.signature(function)
    shown = [
        parameter.replace(annotation=parameter.empty)
        for parameter in signature.parameters.values()
        if parameter.name != "self"
    ]
    text = str(signature.replace(parameters=shown, return_annotation=signature.empty))
    return textwrap.fill(
        name + text, WIDTH - 4, initial_indent="    ", subsequent_indent=" " * (5 + len(name))
    )


def function(thing: Any, name: str) -> str:
    sections = sections_of(docstring_of(thing))
    said = [parameter for parameter in inspect.signature(thing).parameters if parameter != "self"]
    parameters = sections.get("Parameters")
    described = [name for name, _, _ in entries_of(parameters)] if parameters else []
    if described != said or ("Other Parameters" in sections and said[-1] != "options"):
        raise ValueError(f"{name}: parameters {said}, but described are {described}")
    parts = [signature_of(thing, name), paragraphs(sections[""])]
    for section in ("Parameters", "Other Parameters"):
        if section in sections:
            parts.append(listed(sections[section]))
    for of, _, text in entries_of(sections["Returns"]) if "Returns" in sections else ():
        parts.append(wrapped(f"Returns ({of}): {text}"))
    for error, _, text in entries_of(sections["Raises"]) if "Raises" in sections else ():
        parts.append(wrapped(f"Raises {error}: {text}"))
    return "\n\n".join(parts)


def with_fields(kind: type) -> str:
    entries = ((f"{name}** ({of})", text) for name, of, text in fields_of(kind))
    fields = "\n".join(wrapped(f"**{entry}: {text}", "- ", "  ") for entry, text in entries)
    return f"### {kind.__name__}\n\n{paragraphs(docstring_of(kind))}\n\n{fields}"


def members_of(kind: type) -> Iterator[str]:
    """Methods and properties, in the order of the source."""
    for name, member in vars(kind).items():
        if isinstance(member, property):
            yield f"### {name}\n\n{paragraphs(docstring_of(member))}"
        elif not name.startswith("_") and callable(member):
            yield f"### {name}\n\n{function(member, name)}"


def user_routines() -> Iterator[str]:
    before = None
    for name, arguments, meaning, section in _displayfile._table_of_routines():
        if section != before:
            yield f"\n### {section}\n\n| routine | arguments | meaning |\n|---|---|---|"
        before = section
        words = f"`{arguments}`".replace("|", "\\|") if arguments else ""
        yield f"| `{name}` | {words} | {meaning} |"


def page() -> str:
    tuples = [displayfile.Picture, displayfile.Pick, displayfile.Pieces]
    tuples += [displayfile.PolygonPieces, displayfile.VisiblePieces, displayfile.VisibleLines]
    functions = [displayfile.sort, displayfile.visible_pieces, displayfile.visible_lines]
    functions += [displayfile.methods, displayfile.user_routines]
    system = docstring_of(displayfile.System)
    parts = [BEGIN.strip(), "## System", paragraphs(system), "### System"]
    parts.append(function(displayfile.System.__init__, "System"))
    parts += members_of(displayfile.System)
    parts += members_of(Entering)
    parts += members_of(Drawing)
    parts += ["## User routines", paragraphs(ROUTINES), "\n".join(user_routines()).strip()]
    parts += ["## Turntable", paragraphs(docstring_of(displayfile.Turntable))]
    parts += members_of(displayfile.Turntable)
    parts += ["## Views", paragraphs(docstring_of(displayfile.Views))]
    parts += members_of(displayfile.Views)
    parts += ["## PicklableSystem", paragraphs(docstring_of(displayfile.PicklableSystem))]
    calls = displayfile.PicklableSystem.calls  # else it has the members of System
    parts.append(f"### calls\n\n{paragraphs(docstring_of(calls))}")
    parts += ["## Calls", paragraphs(docstring_of(displayfile.Calls))]
    parts += members_of(displayfile.Calls)
    parts.append("## Functions")
    parts += [f"### {f.__name__}\n\n{function(f, f.__name__)}" for f in functions]
    parts.append("## What they return")
    parts += [with_fields(kind) for kind in tuples]
    parts += ["## Limits", "### limits", paragraphs(docstring_of(displayfile.limits))]
    parts.append(function(displayfile.limits.__init__, "limits"))
    parts += ["## Errors", "### Error", paragraphs(docstring_of(displayfile.Error))]
    parts += ["### LimitReached", paragraphs(docstring_of(displayfile.LimitReached))]
    parts += ["## displayfile.dask", paragraphs(docstring_of(dask))]
    for name in dask.__all__:
        parts.append(f"### dask.{name}\n\n{function(getattr(dask, name), name)}")
    parts += ["## displayfile.matplotlib", paragraphs(docstring_of(matplotlib))]
    parts.append(f"### exact\n\n{function(matplotlib.exact, 'exact')}")
    parts.append(with_fields(matplotlib.Exact))
    parts += members_of(matplotlib.Exact)
    return "\n\n".join(parts) + "\n"


ROUTINES = """Each is a method of System. Arguments are in the order of the table; those in brackets are optional,
and words are strings: set_line_style("dashed", 1, 0, 0, 2). x y z ... stands for any number of points, as
numbers, sequences or arrays. Values in brackets in a meaning are the defaults."""


if __name__ == "__main__":
    (Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE).write_text(page())
