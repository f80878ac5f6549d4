"""Calls of the package, as Python writes them: most of them sensible, some with hostile arguments.

A seed is always the same calls. They are text, so that what fails can be pasted.
"""

from __future__ import annotations

import random
from typing import Callable, Sequence

import displayfile
from displayfile import _displayfile

ROUTINES = {name: arguments for name, arguments, _, _ in _displayfile._table_of_routines()}

# Words of routines' arguments, and what they are read as.
POSITIVE = ("size", "radius", "height", "tube-radius", "width", "dash", "gap", "spacing", "ambient")
ANY_NUMBER = ("angle", "distance", "front", "back", "top-radius")
COLOUR = ("r", "g", "b")

# Where any numbers would nearly always be refused.
SENSIBLE = {
    "balloon_3": ["0, 0, 0, 1", "0.5, 0, 0.25, 7, 'Shaft'", "0, 0, 0, 2, 'a b', 5, -8"],
    "leader_3": ["0, 0, 0, 'a'", "0.25, 0.5, 0, 'two words', 4, 6"],
    "set_annotation_size": ["3.5, 'mm'", "9, 'px'"],
    "set_dimension_text": ["'<> H7'", "''", "'2\u00d7 <>'"],
    "set_segment_title": ["1, 'a title'", "2, ''", "3, 'M6 \u00d7 20'", "1, '\\n'"],
    "set_crease_angle": ["30", "0", "180", "45.5"],
    "set_cutting_plane": ["1, 1, 0, 0, 0.5", "6, 0, -1, 0.5, 1", "1, 'off'", "2, -1, 1, 1, 0.25"],
    "set_image_translation": ["1, 0.25, 0", "2, -0.5, 0.125"],
    "set_image_scale": ["1, 0.5, 2", "3, -1, 1"],
    "set_image_rotation": ["1, 30", "2, -90"],
    "set_parallel": ["0, 0, 1", "0.25, -0.5, 1", "-0.125, 0, 2"],
    "set_perspective": ["0, 0, 5", "1, -2, 6", "0.5, 0.25, 3"],
    "set_vertex_colours": ["'red', 'red', '#f40'", "0, 0, 1, 0, 0.1, 1, 0, 0, 0.9, 0, 0, 1", ""],
    "set_view_depth": ["-1, 3", "-2, 2", "-0.5, 0.5"],
    "set_view_plane_normal": ["0, 0, -1", "0.25, -0.5, -1", "1, 1, -2"],
    "set_view_reference_point": ["0, 0, 0", "0.25, 0, -0.125"],
    "set_view_up": ["0, 1, 0", "0.5, 1, 0.25"],
    "set_viewport": ["0, 1, 0, 1", "0.25, 0.75, 0, 1", "0, 0.5, 0.5, 1"],
    "set_window": ["-1, 1, -1, 1", "-2, 1, -0.5, 1"],
    "turn_3": ["5, 0, 0, 0.5, 0, 0, 1", "3, [(0.25, 0), (0.5, 0), (0.25, 0.5)]"],
    "torus_3": ["0, 0, 0, 0.5, 0.125, 6", "0.25, 0, 0, 0.75, 0.5, 4"],
    "extrude_3": ["0, 0.5, 0, 0, 1, 0, 0, 1", "-0.5, 0, [(0, 0), (0.5, 0), (0.5, 0.5), (0, 0.75)]"],
}

Texts = Sequence[str]


class RandomCalls:
    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.last_name = 0  # of the segments opened

    def chance(self, percent: float) -> bool:
        return self.random.random() * 100 < percent

    def any_of(self, texts: Texts) -> str:
        return self.random.choice(texts)

    # ---- Programs ------------------------------------------------------------------------

    def program(self, calls: int) -> list[str]:
        """Calls on a system g, segments being opened and closed now and then."""
        lines: list[str] = []
        while len(lines) < calls:
            lines += [self.setting() for _ in range(self.random.randrange(4))]
            self.last_name += 1
            lines.append(f"g.open_segment({self.last_name if self.chance(90) else self.name()})")
            for _ in range(self.random.randrange(12)):
                lines.append(self.primitive() if self.chance(75) else self.anything())
            lines.append("g.close_segment()")
            lines += [self.anything() for _ in range(self.random.randrange(5))]
        return lines

    def setting(self) -> str:
        return self.routine(self.any_of([n for n in ROUTINES if n.startswith("set_")]))

    def primitive(self) -> str:
        return self.routine(
            self.any_of([n for n in ROUTINES if n.endswith(("_3", "_2")) or n == "text"])
        )

    def anything(self) -> str:
        kinds: list[Callable[[], str]] = [
            lambda: self.routine(self.any_of(list(ROUTINES))),
            self.mesh,
            self.surface,
            self.polyline,
            self.drawn,
            self.asked_for,
            self.entered_as_text,
            self.of_polygons,
            self.wrong_call,
            self.limited,
        ]
        return self.random.choices(kinds, (10, 4, 3, 2, 6, 4, 1, 2, 0.5, 2))[0]()

    # ---- User routines -------------------------------------------------------------------

    def routine(self, name: str) -> str:
        if name in SENSIBLE and self.chance(85):
            return f"g.{name}({self.any_of(SENSIBLE[name])})"
        words = self.words(ROUTINES[name])
        if self.chance(5):
            words = self.spoiled(words)
        joined = ", ".join(words)
        if words and self.chance(10):
            joined = self.any_of(
                ["[{}]", "({},)", "Fresh([{}])", "*[{}]", "odd_list([{}])"]
            ).format(joined)
        elif words and self.chance(4):
            joined = self.hostile(f"[{joined}]")
        return f"g.{name}({joined})"

    def words(self, expected: str) -> list[str]:
        """Arguments of a user routine, as its table has them in words."""
        if ": " in expected:  # how many there may be
            expected = self.any_of(
                [part.split(": ", 1)[1] for part in expected.split(", or ") if ": " in part]
            )
        elif expected.startswith("one or more of "):
            kinds = expected.removeprefix("one or more of ").replace(
                "crease[=DEGREES]", "crease=40"
            )
            return [repr(self.any_of(kinds.split())) for _ in range(self.random.randrange(1, 3))]
        words = self.any_of(expected.split(" | ")).split()
        if words and words[-1] == "...":
            return self.repeated([word for word in words if word != "..."])
        texts: list[str] = []
        for word in words:
            if word.startswith("[") and self.chance(50):
                break
            texts.append(self.word(word.strip("[]")))
        return texts

    def repeated(self, words: list[str]) -> list[str]:
        if "z" in words and "x-points" in words:  # a surface
            nx, ny = self.random.randrange(1, 5), self.random.randrange(1, 4)
            heights = [self.coordinate() for _ in range(nx * ny)]
            return ["-1", self.word("x-max"), str(nx), "0", "0.5", str(ny), *heights]
        if words[0] == "z-min":
            once, each = words[:2], words[2:]
        elif words[0] == "facets":
            once, each = words[:1], words[1:]
        else:
            once, each = [], words
        count = self.random.choice([3, 3, 3, 4, 4, 5, 8] if self.chance(90) else [0, 1, 2])
        texts = [self.word(word) for word in once]
        if self.chance(40):
            points = f"[{', '.join(self.point(len(each)) for _ in range(count))}]"
            return [*texts, self.array(points) if self.chance(60) else points]
        return texts + [self.word(word) for _ in range(count) for word in each]

    def word(self, word: str) -> str:
        if word.startswith('"'):
            return self.characters()
        if word.startswith("exact"):
            return self.any_of(["'exact'", "'roundoff'", "'roundoff=1e-7'", "'roundoff=2'"])
        if word == "on|off":
            return self.any_of(["True", "False", "'on'", "'off'", "np.True_", "0", "'of'"])
        if "|" in word:
            return repr(self.any_of(word.split("|")))
        if word == "method":
            return repr(self.any_of(displayfile.methods()))
        if word in ("name", "new-name"):
            return self.name()
        if word in ("facets", "sides"):
            wrong = ["2", "1001", "-1", "2**31", "3.5"]
            return self.any_of(wrong if self.chance(5) else ["3", "4", "7", "12"])
        if word == "n":
            return self.any_of(["0", "1", "3", "6", "7", "-1", "-2", "2**31 - 1"])
        if word in COLOUR:
            return self.any_of(["1.5", "-0.1"] if self.chance(2) else ["0", "1", "0.5", "0.25"])
        if word in POSITIVE or word.endswith("-max"):
            return (
                self.any_of(["0.125", "0.25", "0.5", "0.75"]) if self.chance(95) else self.number()
            )
        if word.endswith("-min"):
            return self.any_of(["0", "-0.25", "-0.5", "-1"]) if self.chance(95) else self.number()
        if word in ANY_NUMBER or len(word) < 4:
            return self.coordinate()
        return repr(word)

    # ---- Numbers -------------------------------------------------------------------------

    def name(self) -> str:
        if self.chance(5):
            return self.number()
        return str(self.random.randrange(1, self.last_name + 2))

    def coordinate(self) -> str:
        if self.chance(92):
            return repr(self.random.randrange(-8, 9) / 8)
        if self.chance(50):
            return repr(round(self.random.uniform(-2, 2), 3))
        return self.number()

    def number(self) -> str:
        return self.any_of(
            ["nan", "inf", "-inf", "1e100", "-1e100", "2e100", "5e-324", "-0.0", "10**400", "2**63"]
            + ["2**31", "-1", "True", "None", "1j", "'1'", "b'1'", "np.float32(0.1)", "odd_int(1)"]
            + ["np.longdouble(0.1)", "np.int8(-3)", "np.datetime64('2020')", "np.array(0.5)", "[]"]
            + ["np.ma.masked", "fractions.Fraction(1, 3)", "decimal.Decimal('0.1')", "'\\ud800'"]
            + ["decimal.Decimal('sNaN')", "odd_float(0.5)", "Wrong()", "raising('__float__')"]
            + ["dead()", "liar(None)", "liar('x')", "liar(object())", "object()", "...", "np.void(b'xy')"]
            + [f"asked(lambda: {self.asked_while()}, 0.5)", "raising('dtype')", "raising('item')"]
            + ["np.array(1, object)", "ctypes.c_double(1)", "np.float64(1)", "1e308", "{}", "int"]
        )  # fmt: skip

    def point(self, numbers: int) -> str:
        texts = [repr(self.random.randrange(-8, 9) / 8) for _ in range(numbers)]
        if self.chance(2):
            texts[0] = self.number()
        return f"({', '.join(texts)},)"

    def characters(self) -> str:
        parts = ["a", " ", '"', "\\", "#", "é", "\u2212", "\U0001f4d0", "<", "'", "&"]
        if self.chance(5):
            parts += ["\n", "\0", "\t", "\ud800", "\x7f", "a" * 70000]
        text = repr("".join(self.random.choices(parts, k=self.random.randrange(6))))
        return f"odd_str({text})" if self.chance(3) else text

    # ---- Arrays --------------------------------------------------------------------------

    def array(self, values: str, whole: bool = False) -> str:
        """The values as some kind of array, or as what hostile() makes of them."""
        if self.chance(8):
            return self.hostile(values)
        types = ["int", "np.int32", "np.uint8", "'>i4'", "np.uint64", "'<u2'"]
        if not whole or self.chance(3):
            types = ["float", "np.float32", "np.float16", "'>f8'", "np.longdouble"]
        if self.chance(3):
            types = ["object", "str", "bool", "complex", "'V8'", "'M8[s]'", "'f8,f8'"]
        text = f"np.array({values}, {self.any_of(types)})" if self.chance(60) else values
        kinds = ["swapped", "fortran", "strided", "unaligned", "read_only", "as_array"]
        return f"{self.any_of(kinds)}({text})" if self.chance(30) else text

    def hostile(self, values: str) -> str:
        asking = self.asked_while()
        return self.any_of(
            [f"Fresh({values})", f"shrinking({values})", f"generator({values})", f"dict({values})"]
            + [f"odd_list({values})", f"released({values})", f"asked(lambda: {asking}, {values})"]
            + [f"collections.deque({values})", f"set({values})", f"map(list, {values})"]
            + [f"as_array({values}, ndim=5)", f"as_array({values}, dtype='float')", "b'123'", "'123'"]
            + [f"as_array({values}, item=lambda self: None, dtype=1)", "range(3)", "range(10**12)"]
            + [f"np.ma.array({values}, mask=True)", f"np.matrix({values})", f"[{values}]"]
            + [f"np.broadcast_to({values}, (2, 3, 3))", "memoryview(b'123')", "Wrong()", "None"]
            + ["raising('__array__')", "raising('__len__')", "raising('__len__', '__getitem__')"]
            + ["raising('__array_interface__')", "raising('__array_struct__')", "raising('ndim')"]
            + ["[Wrong()]", "[[Wrong()] * 3] * 3", "[raising('__float__')] * 3", "clearing(0, 0)"]
            + ["[clearing(0, 0), (1, 0, 0), (0, 1, 0)]", "dead()", "[dead()]", "liar(None)"]
            + ["np.zeros((0, 3))", "np.zeros((3, 0))", "np.zeros((0, 0, 3))", "np.zeros((2, 3, 0))"]
            + ["array.array('d', [0, 1, 2])", "(ctypes.c_double * 3)()", "bytearray(24)", "[[]]"]
            + ["np.array(['x'] * 3)", "np.zeros(3, 'f8,f8')", "np.array([None] * 3)", "np.zeros(())"]
            + [f"[asked(lambda: {asking}, (0, 0, 0)), (1, 0, 0), (0, 1, 0)]", "[[[]]]", "object()"]
            + ["np.array([2**64 - 1] * 3, np.uint64)", "[2**64] * 3", "[-1, 0, 1]", "[10**30] * 3"]
        )  # fmt: skip

    def asked_while(self) -> str:
        """What an argument does with the system while it is read."""
        return self.any_of(
            ["g.draw(8)", "g.dump()", "g.pick(4, 4, 8)", "g.segments", "g.svg(8)"]
            + ["g.set_pick_id(3)", "g.close_segment()", "g.delete_all_segments()", "g.open_segment(9)"]
            + ["g.polygon_abs_3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])", "g.set_fill_style('hollow')"]
        )  # fmt: skip

    def spoiled(self, words: list[str]) -> list[str]:
        """One too few, one too many, or another one."""
        at = self.random.randrange(len(words) + 1)
        kind = self.random.randrange(3)
        if kind == 0:
            return words[:at] + words[at + 1 :]
        return words[:at] + [self.number()] + words[at + kind - 1 :]

    # ---- Meshes, surfaces, files -----------------------------------------------------------

    def indices(self, vertices: int, count: int) -> str:
        top = vertices + (1 if self.chance(3) else 0)
        low = -1 if self.chance(3) else 0
        return f"[{', '.join(str(self.random.randrange(low, max(top, 1))) for _ in range(count))}]"

    def mesh(self) -> str:
        n = self.random.choice([0, 1, 3, 4, 6, 9])
        count = self.random.choice([0, 1, 2, 3, 5])
        ragged = self.chance(40)
        vertices = f"[{', '.join(self.point(3) for _ in range(n))}]"
        rows = [self.indices(n, self.random.randrange(2, 6) if ragged else 3) for _ in range(count)]
        faces = f"[{', '.join(rows)}]"
        parts = [self.array(vertices), self.array(faces, whole=True)]
        if self.chance(15):
            parts[1] = self.array(self.indices(n, 3 * count), whole=True)
            parts.append(f"sides={self.array(f'[3] * {count}', whole=True)}")
        colours = f"[{', '.join(self.colour() for _ in range(count))}]"
        for percent, text in [
            (10, f"segment={self.name()}"),
            (10, f"fill={self.colour_or_word()}"),
            (10, f"fills={self.array(colours)}"),
            (10, f"picks={self.array(str(list(range(count))), whole=True)}"),
            (10, f"normals={self.array(vertices)}"),
        ]:
            if self.chance(percent):
                parts.append(text)
        return f"g.mesh({', '.join(parts)})"

    def colour(self) -> str:
        return self.any_of(["(1, 0.5, 0)", "(0, 0, 1)", "[0.1, 0.2, 0.3]", "(0.5, 0.5, 0.5)"])

    def colour_or_word(self) -> str:
        if self.chance(80):
            return self.colour()
        return self.any_of(
            ["'hollow'", "'none'", "(1, 2, 3)", "(1, 0)", "nan", "'red'", "[nan] * 3"]
        )

    def surface(self) -> str:
        m, n = self.random.choice([1, 2, 3, 4]), self.random.choice([2, 3, 5])
        x = self.any_of([f"np.linspace(-1, 1, {n})", f"np.arange({n}) ** 2.0", f"[{n}] * {n}"])
        y = self.any_of([f"np.linspace(1, -1, {m})", f"np.arange({m})", f"list(range({m}))"])
        z = f"[{', '.join(self.point(n) for _ in range(m))}]"
        if self.chance(40):
            x, y = f"np.meshgrid({x}, {y})[0]", f"np.meshgrid({x}, {y})[1]"
        parts = [text if self.chance(96) else self.hostile(z) for text in (x, y)]
        parts.append(self.array(z))
        if self.chance(15):
            parts.append(f"segment={self.name()}")
        if self.chance(20):
            parts.append(self.any_of(["contours=2", "contours=[0.25]", "contours=2, levels=3"]))
            if self.chance(50):
                parts.append(self.any_of(["contour_colour='red'", f"contour_width={self.number()}"]))
        return f"g.surface({', '.join(parts)})"

    def polyline(self) -> str:
        points = f"[{', '.join(self.point(3) for _ in range(self.random.choice([0, 1, 2, 5])))}]"
        parts = [self.array(points) if self.chance(96) else self.hostile(points)]
        for percent, text in [
            (20, "closed=True"),
            (20, f"colour={self.colour_or_word()}"),
            (20, f"width={self.number()}"),
            (10, f"segment={self.name()}"),
        ]:
            if self.chance(percent):
                parts.append(text)
        return f"g.polyline({', '.join(parts)})"

    def entered_as_text(self) -> str:
        program = "\\n".join(
            self.any_of(
                ["open-segment 7", "close-segment", "move-abs-3 0 0 0", "line-abs-3 1 1 1"]
                + ["polygon-abs-3 0 0 0 1 0 0 0 1 0", "set-light 0 0", "#", "no-routine", "\\0"]
            )
            for _ in range(self.random.randrange(5))
        )
        return self.any_of(
            [f"g.replay('{program}')", f"g.replay('{program}', 'a:1:2: b')", "g.replay(b'x')"]
            + [f"g.replay_file({self.path()})", f"g.import_mesh({self.path()})"]
            + [f"g.import_mesh({self.path()}, colour={self.colour_or_word()})"]
            + [f"g.import_mesh({self.path()}, {self.camera()})"]
        )

    def camera(self) -> str:
        """What must not be said together is said together now and then."""
        some = [f"eye={self.point(2)}", f"eye={self.point(3)}", f"eye={self.hostile('[0, 0, 0]')}"]
        some += [f"look_at={self.point(3)}", f"fov={self.number()}", "fov=30", "parallel=True"]
        some += ["up='z'", "up='-x'", "up='auto'", "up='w'", "up=5", "fit=False", "fit=nan"]
        some += ["turning=True", "turning='x'"]
        by_name = {option.split("=", 1)[0]: option for option in self.random.choices(some, k=2)}
        return ", ".join(by_name.values())

    def path(self) -> str:
        return self.any_of(
            ["'some.obj'", "b'some.obj'", "'some.draw'"] * 4
            + [
                "'none.draw'",
                "'.'",
                "''",
                "b'none.obj'",
                "'a\\0b'",
                "'\\ud800'",
                "None",
                "5",
                "Wrong()",
            ]
            + ["pathlib.Path('none.stl')", "raising('__fspath__')", "odd_str('none.off')", "{}"]
        )

    # ---- Pictures and questions ------------------------------------------------------------

    def size(self) -> str:
        return (
            self.any_of(["8", "(8, 6)", "12", "[5, 9]", "np.array([8, 8])"])
            if self.chance(92)
            else self.any_of(
                ["0", "-1", "65536", "(65536, 1)", "2**40", "True", "None", "'8'", "(8,)", "(8, 0)"]
                + [
                    "Fresh([8, 8])",
                    "shrinking([8, 8, 8])",
                    "raising('__len__', '__getitem__')",
                    "Wrong()",
                ]
                + [
                    "odd_int(8)",
                    "odd_list([8, 8])",
                    "{8, 9}",
                    "range(8, 10)",
                    "nan",
                    "8.0",
                    "dead()",
                ]
                + ["asked(lambda: g.draw(8), (8, 8))", "generator([8, 8])", "(8, [8])", "liar(8)"]
            )
        )

    def option(self, of_vectors: bool) -> str:
        method = repr(self.any_of(displayfile.methods()))
        options = [
            f"hidden={method}", "hidden_lines='dashed'", "scope='all'", "scope='segment'",
            "precision='roundoff'", "background=(0, 0, 0)", "background='none'", "lines=None",
            "line_order='depth'", "line_order='x'", "line_halo=2", "line_halo=-1",
            "threads=2", "hidden=None", "hidden='magic'", "hidden=5", "hidden_lines='x'",
            "background=(1, 2, 3)", "background=[nan] * 3", "background=raising('__array__')",
            "threads=0", "threads=True", "lines='outline'", "lines='all'", "scope=b'all'",
            "precision=odd_str('exact')", "samples=2", "samples=0", "samples=99",
            "hidden='\\ud800'", "**{'\\ud800': 1}", "colour=1", "device='osmesa2'", "ids=0.5",
        ]  # fmt: skip
        if of_vectors:
            options += [
                "paper='A4'", "paper='A99'", "seams='butted'", "vector_precision=0.1", "pick_ids=True",
                "font='serif'", "font='a;b'", "text='outlines'", "text=3", "paper=4",
                "id_prefix='a-'", "id_prefix='1'", "inline=True", "layers=True", "dpi=300", "dpi=0",
                "vector_precision=nan", "vector_precision=-1", "seams='x'",
            ]  # fmt: skip
        else:
            options += [
                "ids=True", "depth=True", "rows=(1, 3)", "rows=(3, 3)", "rows=(-1, 2)", "rows=range(2)",
                "rows='all'", "rows=[0, 2**40]", "rows=shrinking([0, 1, 2])", "ids='on'", "depth=None",
            ]  # fmt: skip
        return self.any_of(options)

    def options(self, of_vectors: bool) -> str:
        some = [self.option(of_vectors) for _ in range(self.random.choice([0, 0, 1, 1, 2]))]
        by_name = {option.split("=", 1)[0]: option for option in some}
        return "".join(f", {option}" for option in by_name.values())

    def turned(self) -> str:
        said = ["", ", hidden='z-buffer'", ", hidden='franklin'", ", hidden='world-ray-cast'"]
        said += [", fit=True", f", axis={self.array(self.point(3))}", f", fit={self.number()}"]
        views = self.number() if self.chance(10) else self.any_of(["1", "3", "np.int8(4)"])
        view = self.number() if self.chance(10) else self.any_of(["0", "0", "1", "2"])
        turned = f"{views}, {self.size()}{self.any_of(said)}{self.options(False)}"
        if self.chance(10):
            return f"views_saved(g, {self.path()}, {self.point(2)}, {turned})"
        return f"view_drawn(g, {view}, {turned})"

    def drawn(self) -> str:
        if self.chance(15):
            return self.turned()
        size = self.size()
        if self.chance(50):
            return f"g.draw({size}{self.options(False)})"
        return self.any_of(
            [f"g.svg({size}{self.options(True)})", f"g.png({size}{self.options(False)})"]
            + [f"g.ppm({size}{self.options(False)})", f"g.eps({size}{self.options(True)})"]
            + [f"g.save({self.path()}, {size}{self.options(True)})", "g._repr_svg_()"]
            + [f"g.save('none/none.svg', {size})", f"g.save('a.svg', format={self.number()})"]
        )

    def asked_for(self) -> str:
        n = self.number()
        return self.any_of(
            [f"g.pick({self.coordinate()}, {self.coordinate()}, {self.size()})", f"g.pick(4, {n}, 8)"]
            + [f"g.pick(4, 4, 8, reach={n})", "g.pick(3, 3, 8, reach=2)", f"g.dump({self.options(True)[2:]})"]
            + [f"g.pieces({self.options(True)[2:]})", f"g.to_device({self.point(3)})", f"g.to_device({n})"]
            + [f"g.to_device({self.hostile('[0, 0, 0]')})", f"g.set_threads({n})", "g.set_threads(2)"]
            + [f"g.set_aspect_ratio({n})", "g.segments", "g.open_segment_name", "g.polygons"]
        )  # fmt: skip

    def of_polygons(self) -> str:
        count = self.random.choice([0, 1, 2, 4])
        corners = 3 if self.chance(80) else self.random.randrange(6)
        each = [f"[{', '.join(self.point(3) for _ in range(corners))}]" for _ in range(count)]
        polygons = self.array(f"[{', '.join(each)}]")
        options = ["", ", threads=2", ", threads=-1", f", sides=[3] * {count}", ", sides='3'"]
        segments = f", segments={self.array(f'[[(0, 0, 0), {self.point(3)}]]')}"
        sort = [
            *options,
            segments,
            ", whole=True",
            ", method='bsp'",
            ", method='map'",
            ", method=1",
        ]
        lines = [*options, segments, ", lines='outline'", ", hidden=True", ", method='roberts'"]
        return self.any_of(
            [f"displayfile.sort({polygons}{self.any_of(sort)})"]
            + [f"displayfile.visible_pieces({polygons}{self.any_of(options)})"]
            + [f"displayfile.visible_lines({polygons}{self.any_of(lines)})"]
        )

    def limited(self) -> str:
        call = self.random.choice([self.mesh, self.surface, self.drawn, self.of_polygons])()
        if self.chance(50) or "_repr_" in call:  # which tells no Error
            call = self.any_of(["g.close_segment()", "g.import_mesh('some.obj')"])
        function, arguments = call[:-1].split("(", 1)
        wrong = ["-1", "nan", "1.5", "None", "True", "'1'", "2**70", "Wrong()", "odd_int(3)"]
        number = self.any_of(wrong if self.chance(20) else ["0", "0", "3", "10**6"])
        limit = self.any_of(["pieces", "comparisons", "bytes", "seconds"])
        return f"limited({function}, {arguments + ', ' if arguments else ''}most={{'{limit}': {number}}})"

    def wrong_call(self) -> str:
        """What Python itself refuses."""
        return self.any_of(
            [
                "g.mesh()",
                "g.polygon_abs_3(x=1)",
                "g.no_routine()",
                "g.draw(8, 8, 8)",
                "g.polygons()",
            ]
            + [
                "displayfile.System.draw(5)",
                "displayfile.System.__new__(displayfile.System).dump()",
            ]
            + ["g.segments.append(1)", "displayfile.sort()", "g.pick('x')", "g.__init__()"]
        )
