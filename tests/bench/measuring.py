"""What the scripts of this folder have in common: costs of processes, tables, exponents."""
import collections
import json
import math
import os
import statistics
import subprocess
import sys
import time

Cost = collections.namedtuple("Cost", "wall processor memory")  # seconds, seconds, bytes
Spread = collections.namedtuple("Spread", "median least greatest")


def cost_of(words, **options):
    """Of a process from its start to its end; the memory is at least what this interpreter has. Raises Failed."""
    options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, **options}
    begin = time.monotonic()
    child = subprocess.Popen([str(word) for word in words], **options)
    said = child.stderr.read().decode(errors="replace") if child.stderr else ""
    _, status, used = os.wait4(child.pid, 0)
    wall = time.monotonic() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise Failed(f"{' '.join(map(str, words))}: exit status {child.returncode}: {said.strip()}")
    return Cost(wall, used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss)


class Failed(Exception):
    """A process did not end well."""


def least(costs):
    """What disturbs a process only adds."""
    return Cost(*map(min, zip(*costs)))


def spread(values):
    return Spread(statistics.median_high(values), min(values), max(values))


def in_turn(rounds, *works):
    """The results of each work, which take turns."""
    return zip(*[[work() for work in works] for _ in range(rounds)])


def exponent(sizes, costs):
    """Of the power of the size that fits best."""
    x, y = [math.log(size) for size in sizes], [math.log(max(cost, 1e-9)) for cost in costs]
    return statistics.linear_regression(x, y).slope if len(set(x)) > 1 else 0.0


def text(value):
    if isinstance(value, dict):
        value = Spread(value["median"], value["least"], value["greatest"])
    if isinstance(value, Spread):
        return f"{text(value.median)} ({text(value.least)} to {text(value.greatest)})"
    if value is None:
        return "-"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def table(rows):
    """A table in Markdown, its columns aligned; rows are dictionaries, columns in order of keys."""
    heads = list(dict.fromkeys(key for row in rows for key in row))
    cells = [heads, *([text(row.get(head, "")) for head in heads] for row in rows)]
    widths = [max(len(row[k]) for row in cells) for k in range(len(heads))]
    cells.insert(1, ["-" * width for width in widths])
    return "".join(
        "| " + " | ".join(f"{cell:{width}}" for cell, width in zip(row, widths)) + " |\n"
        for row in cells
    )


def growths(rows):
    """Of rows with sizes n and seconds: one a scene and way, with the exponent, and what else grew from and to."""
    groups = {}
    for row in rows:
        groups.setdefault((row["scene"], row["way"]), []).append(row)
    for (scene_name, way), group in groups.items():
        first, last = group[0], group[-1]
        fitted = exponent([row["n"] for row in group], [row["seconds"] for row in group])
        others = [key for key in first if key not in ("table", "scene", "way", "seconds")]
        ranges = {key: f"{text(first[key])} to {text(last[key])}" for key in others}
        yield {"scene": scene_name, "way": way, "exponent": f"{fitted:.2f}", **ranges}


def verdict(holds):
    return "holds" if holds else "DOES NOT HOLD"


def rows_of(words):
    """The rows of JSON that a program prints, one by one."""
    with subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, text=True) as child:
        for line in child.stdout:
            yield json.loads(line)
    if child.returncode:
        sys.exit(f"{words[0]}: exit status {child.returncode}")


def scene(program, name, polygons, seed=1):
    """A drawing program of a generated scene, by tests/bench/scene_program."""
    words = [program, name, str(polygons), str(seed)]
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout
