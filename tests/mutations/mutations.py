"""Mutations of the source: a list of them, how they are put into a copy of it side by side, and what
they do to the tests. README.md beside this file tells how they are used."""

import dataclasses
import pathlib
import re

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SWITCH = "displayfile_mutation"


@dataclasses.dataclass
class Mutation:
    """A line of a file, and what it is changed to."""

    path: str
    tests: list  # that may notice, EXECUTABLE or EXECUTABLE=FILTER, the quickest first
    line: str
    changed: str
    same: str = ""  # why it changes nothing that a user sees; otherwise a test must notice

    def __str__(self):
        return f"{self.path}: {self.line} -> {self.changed}"


class ListError(Exception):
    pass


def read_list(path):
    """Sections `## FILE: TEST...`, each of pairs of lines `- LINE` and `+ CHANGED`, and after a pair,
    if nothing changes, `= REASON`."""
    mutations, section, before = [], None, None
    for number, text in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
        def wrong(expected):
            return ListError(f"{path}:{number}: '{text}': expected {expected}")
        if not text.strip() or text.startswith("# "):
            continue
        if text.startswith("## "):
            file, _, tests = text[3:].partition(":")
            if not tests.split():
                raise wrong("## FILE: TEST...")
            section = (file.strip(), tests.split())
        elif text.startswith("- "):
            before = text[2:].strip()
        elif text.startswith("+ "):
            if section is None or before is None:
                raise wrong("a line '- ' before it, in a section")
            mutations.append(Mutation(section[0], section[1], before, text[2:].strip()))
            before = None
        elif text.startswith("= "):
            mutations[-1].same = text[2:].strip()
        else:
            raise wrong("## FILE: TEST..., - LINE, + CHANGED or = REASON")
    return mutations


def closing(text, opening):
    """Where the parenthesis closes that opens there, or None."""
    depth = 0
    for k in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[k], 0)
        if depth == 0:
            return k
    return None


def names_more(expression):
    """True if a comma stands outside of all brackets."""
    depth = 0
    for c in expression:
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(c, 0)
        if c == "," and depth == 0:
            return True
    return False


def parts(line):
    """The line as (before, what is chosen between, after), or None. What is chosen between is an
    expression, or a whole statement, which begins with nothing before it."""
    for pattern in (r"((?:\} else )?if \()", r"(while \()"):
        found = re.match(pattern, line)
        if found:
            end = closing(line, found.end() - 1)
            if end is None or ";" in line[:end]:  # which declares something first
                return None
            return line[: found.end()], line[found.end() : end], line[end:]
    found = re.match(r"for \([^;:]*; ([^;]*);", line)
    if found:
        return line[: found.start(1)], found.group(1), line[found.end(1) :]
    if not line.endswith(";") or line.count("(") != line.count(")"):
        return None
    for pattern in (r"(return )(?=[^{;])", r"((?:const )?(?:auto|double|int|bool|float|std::\w+|Point[23]) \w+ = )"):
        found = re.match(pattern, line)
        if found:
            expression = line[found.end() : -1]
            # Another variable after a comma cannot be within an expression.
            return None if names_more(expression) else (found.group(1), expression, ";")
    if re.match(r"[\w\[\]\.\->\*\(\)]+ [-+|&*/]?= ", line) or re.match(r"[\w\.\->\[\]:]+\(.*\);$", line):
        return "", line, ""
    return None


def begins_statement(lines, k):
    """True if line k does not go on with the one before it."""
    before = lines[k - 1].strip() if k > 0 else ""
    return before == "" or before.startswith(("//", "#")) or before.split("  // ")[0].endswith((";", "{", "}", ":"))


def common_form(mutation):
    """(before, original, changed, after), or None if the two lines do not differ in one part."""
    one, other = parts(mutation.line), parts(mutation.changed)
    if one is None or other is None or one[0] != other[0] or one[2] != other[2]:
        return None
    return one[0], one[1], other[1], one[2]


def switched(mutation, number):
    """The line with both in it, of which a program takes one."""
    before, original, changed, after = common_form(mutation)
    if before == "" and after == "":
        return f"if ({SWITCH}({number})) {{ {changed} }} else {{ {original} }}"
    return f"{before}(::{SWITCH}({number}) ? ({changed}) : ({original})){after}"


def put_in(mutations, folder):
    """Writes the files that mutations are of into a copy of the source, with all of them inside."""
    of_file = {}
    for number, mutation in enumerate(mutations, 1):
        of_file.setdefault(mutation.path, []).append((number, mutation))
    for path, some in of_file.items():
        lines = (SOURCE / path).read_text().splitlines()
        places = {}
        for k, line in enumerate(lines):
            places.setdefault(line.strip(), []).append(k)
        for number, mutation in some:
            found = places.get(mutation.line, [])
            if len(found) != 1:
                raise ListError(f"{path}: '{mutation.line}': expected it once, found {len(found)} times")
            if common_form(mutation) is None:
                raise ListError(f"{mutation}: expected one expression or statement that differs")
        taken = {}
        for number, mutation in some:
            k = places[mutation.line][0]
            taken.setdefault(k, []).append((number, mutation))
        for k, here in taken.items():
            if not begins_statement(lines, k):
                raise ListError(f"{path}: '{here[0][1].line}': expected a whole statement")
            indent = lines[k][: len(lines[k]) - len(lines[k].lstrip())]
            lines[k] = indent + nested(here)
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text("\n".join(lines) + "\n")


def nested(here):
    """Several mutations of one line, in one another."""
    number, mutation = here[0]
    text = switched(mutation, number)
    for number, mutation in here[1:]:
        before, original, changed, after = common_form(mutation)
        if before == "" and after == "":
            text = f"if ({SWITCH}({number})) {{ {changed} }} else {{ {text} }}"
        else:
            inner = text[len(before) : len(text) - len(after)]
            text = f"{before}(::{SWITCH}({number}) ? ({changed}) : {inner}){after}"
    return text


HEADER = f"""#pragma once
#include <cstdlib>
/// Which mutation a program has: DISPLAYFILE_MUTATION, or none.
inline bool {SWITCH}(int number) {{
  static const int chosen = [] {{
    const char* const text = std::getenv("DISPLAYFILE_MUTATION");
    return text == nullptr ? 0 : std::atoi(text);
  }}();
  return chosen == number;
}}
"""
