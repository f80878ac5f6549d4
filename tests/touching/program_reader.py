"""Reads a drawing program into the polygons that it enters, each with what was in force.

It reads the routines in ROUTINES, as displayfile/text/drawing_programs.md describes them. Every
other routine is an error, so that nothing is ignored in silence.
"""
import re
from dataclasses import dataclass, field, replace

import exact_view

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$")


class Refused(Exception):
    """The program has something that this reader does not know, or that is wrong."""


@dataclass(frozen=True)
class View:
    """The view parameters of the textbook's chapter 8, in doubles."""

    reference_point: tuple = (0.0, 0.0, 0.0)
    plane_normal: tuple = (0.0, 0.0, -1.0)
    distance: float = 0.0
    up: tuple = (0.0, 1.0, 0.0)
    perspective: bool = False
    projection: tuple = (0.0, 0.0, 1.0)  # a direction, or the centre of projection
    depth: tuple = (-1.0, 3.0)
    front_clipping: bool = False
    back_clipping: bool = False
    window: tuple = (-1.0, 1.0, -1.0, 1.0)
    viewport: tuple = (0.0, 1.0, 0.0, 1.0)


@dataclass(frozen=True)
class Image:
    """An image transformation: scaled, turned about the centre in degrees, translated."""

    scale: tuple = (1.0, 1.0)
    rotation: float = 0.0
    translation: tuple = (0.0, 0.0)
    centre: tuple = (0.0, 0.0)


@dataclass
class Segment:
    view: View
    touching: str  # auto, off, or a length
    image: Image = Image()


@dataclass
class Polygon:
    """Its identifier is its place in Program.polygons."""

    points: list  # as entered
    matrix: tuple  # the modelling matrix, 3 rows of 4 doubles
    segment: int
    solid: bool
    without_back: bool


@dataclass
class Program:
    polygons: list = field(default_factory=list)
    segments: dict = field(default_factory=dict)
    shape_was_set: bool = False  # by a window or a viewport


IDENTITY = tuple(tuple(float(i == j) for j in range(4)) for i in range(4))


def product(a, b):
    """Of two matrices of 4 rows, in doubles, summed from the left."""
    return tuple(
        tuple(
            ((a[i][0] * b[0][j] + a[i][1] * b[1][j]) + a[i][2] * b[2][j]) + a[i][3] * b[3][j]
            for j in range(4)
        )
        for i in range(4)
    )


class Reader:
    def __init__(self):
        self.program = Program()
        self.view = View()
        self.called = IDENTITY  # since the transformation was saved last
        self.saved = []  # (what was in force, what had been called)
        self.open = None
        self.touching = "auto"
        self.solid = True
        self.without_back = False

    # ---- The modelling transformation

    def in_force(self):
        return product(self.saved[-1][0], self.called) if self.saved else self.called

    def then(self, step):
        self.called = product(step, self.called)

    def create(self):
        self.called = IDENTITY

    def save(self):
        self.saved.append((self.in_force(), self.called))
        self.called = IDENTITY

    def restore(self):
        if not self.saved:
            raise Refused("restore-transformation-3: none is saved")
        self.called = self.saved.pop()[1]

    def translate(self, x, y, z):
        self.then(
            ((1.0, 0.0, 0.0, x), (0.0, 1.0, 0.0, y), (0.0, 0.0, 1.0, z), (0.0, 0.0, 0.0, 1.0))
        )

    def scale(self, x, y, z):
        self.then(
            ((x, 0.0, 0.0, 0.0), (0.0, y, 0.0, 0.0), (0.0, 0.0, z, 0.0), (0.0, 0.0, 0.0, 1.0))
        )

    def rotate(self, first, second, degrees):
        """From the axis `first` toward the axis `second`."""
        sine, cosine = (float(x) for x in exact_view.sine_and_cosine(degrees))
        rows = [list(row) for row in IDENTITY]
        rows[first][first] = rows[second][second] = cosine
        rows[second][first], rows[first][second] = sine, -sine
        self.then(tuple(map(tuple, rows)))

    # ---- The view, attributes and segments

    def set_view(self, **values):
        self.view = replace(self.view, **values)

    def set_rectangle(self, name, *sides):
        if not (sides[0] < sides[1] and sides[2] < sides[3]):
            raise Refused(f"a {name} without an inside")
        self.set_view(**{name: sides})
        self.program.shape_was_set = True

    def open_segment(self, name):
        if self.open is not None or name in self.program.segments:
            raise Refused("open-segment: one is open, or has this name")
        self.open = name
        self.program.segments[name] = Segment(self.view, self.touching)

    def close_segment(self):
        if self.open is None:
            raise Refused("close-segment: none is open")
        self.open = None

    def set_image(self, name, **values):
        if name not in self.program.segments:
            raise Refused(f"there is no segment {name}")
        segment = self.program.segments[name]
        segment.image = replace(segment.image, **values)

    def set_hidden(self, on):
        self.without_back = on  # of fills that is all that it changes in an item buffer

    def set_back(self, on):
        self.without_back = on

    # ---- Polygons

    def polygon(self, *numbers):
        if self.open is None:
            raise Refused("polygon-abs-3: no segment is open")
        if len(numbers) < 9 or len(numbers) % 3:
            raise Refused("polygon-abs-3: 3 or more points are expected")
        points = [numbers[k : k + 3] for k in range(0, len(numbers), 3)]
        self.program.polygons.append(
            Polygon(points, self.in_force()[:3], self.open, self.solid, self.without_back)
        )

    # ---- Lines of text

    def line(self, text):
        words = text.split("#")[0].split()
        if not words:
            return
        name, arguments = words[0], words[1:]
        if name not in ROUTINES:
            raise Refused(f"{name} is not known here")
        ROUTINES[name](self, arguments)


def numbers(arguments, count=None):
    if count is not None and len(arguments) != count:
        raise Refused(f"{count} numbers are expected, not {len(arguments)}")
    for word in arguments:
        if not NUMBER.match(word):
            raise Refused(f"{word} is not a number")
    return [float(word) for word in arguments]


def is_on(arguments):
    if arguments not in (["on"], ["off"]):
        raise Refused(f"on or off is expected, not {' '.join(arguments)}")
    return arguments == ["on"]


def touching(reader, arguments):
    if arguments not in (["auto"], ["off"]):
        numbers(arguments, 1)
    reader.touching = arguments[0]


def fill(reader, arguments):
    if arguments != ["hollow"]:
        if arguments[:1] != ["solid"]:
            raise Refused("set-fill-style: solid or hollow is expected")
        numbers(arguments[1:], 3)
    reader.solid = arguments != ["hollow"]


def no_lines(reader, arguments):
    if arguments != ["none"]:
        raise Refused("set-line-style: only none is known here")


def with_numbers(count, call):
    return lambda reader, arguments: call(reader, *numbers(arguments, count))


def with_switch(call):
    return lambda reader, arguments: call(reader, is_on(arguments))


def of_segment(count, call):
    """A routine of a segment's name and numbers."""
    return lambda reader, arguments: call(reader, int(arguments[0]), *numbers(arguments[1:], count))


def view_point(name, **more):
    return with_numbers(3, lambda r, x, y, z: r.set_view(**{name: (x, y, z)}, **more))


def rotation(first, second):
    return with_numbers(1, lambda r, angle: r.rotate(first, second, angle))


ROUTINES = {
    "set-view-reference-point": view_point("reference_point"),
    "set-view-plane-normal": view_point("plane_normal"),
    "set-view-distance": with_numbers(1, lambda r, d: r.set_view(distance=d)),
    "set-view-up": view_point("up"),
    "set-parallel": view_point("projection", perspective=False),
    "set-perspective": view_point("projection", perspective=True),
    "set-view-depth": with_numbers(2, lambda r, front, back: r.set_view(depth=(front, back))),
    "set-front-plane-clipping": with_switch(lambda r, on: r.set_view(front_clipping=on)),
    "set-back-plane-clipping": with_switch(lambda r, on: r.set_view(back_clipping=on)),
    "set-window": with_numbers(4, lambda r, *sides: r.set_rectangle("window", *sides)),
    "set-viewport": with_numbers(4, lambda r, *sides: r.set_rectangle("viewport", *sides)),
    "create-transformation-3": with_numbers(0, Reader.create),
    "save-transformation-3": with_numbers(0, Reader.save),
    "restore-transformation-3": with_numbers(0, Reader.restore),
    "translate-3": with_numbers(3, Reader.translate),
    "scale-3": with_numbers(3, Reader.scale),
    "rotate-x-3": rotation(1, 2),
    "rotate-y-3": rotation(2, 0),
    "rotate-z-3": rotation(0, 1),
    "open-segment": of_segment(0, Reader.open_segment),
    "close-segment": with_numbers(0, Reader.close_segment),
    "set-segment-title": lambda reader, words: None,
    "set-image-scale": of_segment(2, lambda r, n, x, y: r.set_image(n, scale=(x, y))),
    "set-image-rotation": of_segment(1, lambda r, n, a: r.set_image(n, rotation=a)),
    "set-image-translation": of_segment(2, lambda r, n, x, y: r.set_image(n, translation=(x, y))),
    "set-image-centre": of_segment(2, lambda r, n, x, y: r.set_image(n, centre=(x, y))),
    "set-fill-style": fill,
    "set-line-style": no_lines,
    "set-hidden-line-removal": with_switch(Reader.set_hidden),
    "set-back-face-removal": with_switch(Reader.set_back),
    "set-touching": touching,
    "polygon-abs-3": with_numbers(None, Reader.polygon),
}


def read(text):
    """The Program of a text. Raises Refused, with the line's number, for what it does not know."""
    reader = Reader()
    for number, line in enumerate(text.splitlines(), 1):
        try:
            reader.line(line)
        except (Refused, ValueError, IndexError) as error:
            raise Refused(f"line {number}: {error}") from error
    if reader.open is not None or reader.saved:
        raise Refused("at the end a segment is open, or a transformation is saved")
    return reader.program
