"""The viewing transformation, from the textbook's parameters, to 60 digits.

Square roots, sines and cosines are the only numbers that are not exact. Everything else in this
folder is: what is rounded here once is a rational from then on.
"""
import decimal
from decimal import Decimal
from fractions import Fraction

CONTEXT = decimal.Context(
    prec=90,
    Emax=decimal.MAX_EMAX,
    Emin=decimal.MIN_EMIN,
    traps=[decimal.InvalidOperation, decimal.DivisionByZero],
)
DIGITS = 70  # of what series are summed to
PI = Decimal(
    "3.14159265358979323846264338327950288419716939937510"
    "58209749445923078164062862089986280348253421170680"
)


def in_decimal(function):
    def with_digits(*arguments):
        with decimal.localcontext(CONTEXT):
            return function(*arguments)

    return with_digits


def power_series(x, power):
    """The cosine of x, which is below 1, for power 0; the sine for power 1."""
    term = total = x if power else Decimal(1)
    while abs(term) > Decimal(10) ** -(DIGITS + 5):
        power += 2
        term = -term * x * x / (power * (power - 1))
        total += term
    return total


@in_decimal
def sine_and_cosine(degrees):
    """Of an angle in degrees, a double; exact at multiples of 90."""
    turn = Fraction(degrees) % 360
    quarter = round(turn / 90)
    rest = turn - 90 * quarter
    x = Decimal(rest.numerator) / Decimal(rest.denominator) * PI / 180
    sine, cosine = power_series(x, 1), power_series(x, 0)
    if x == 0:
        sine, cosine = Decimal(0), Decimal(1)
    return [(sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine)][quarter % 4]


# ---- Vectors and matrices of decimals


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Decimal(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = dot(a, a).sqrt()
    return [x / length for x in a]


def times(a, b):
    return [[dot(row, [line[j] for line in b]) for j in range(len(b[0]))] for row in a]


def decimals(numbers):
    return [Decimal(x) for x in numbers]  # exact: the context does not round constructors


def view_plane_rows(view):
    """World coordinates to view-plane coordinates: z grows toward the viewer, y is up."""
    toward = [-x for x in unit(decimals(view.plane_normal))]
    right = unit(cross(decimals(view.up), toward))
    up = cross(toward, right)
    distance = Decimal(view.distance)
    origin = [r - distance * t for r, t in zip(decimals(view.reference_point), toward)]
    rows = [axis + [-dot(axis, origin)] for axis in (right, up, toward)]
    return rows + [decimals([0, 0, 0, 1])]


def projector(view, to_view_plane):
    """(sx, sy, k): a projector through (x, y, z) meets the view plane at
    ((x - sx z) / (1 - k z), (y - sy z) / (1 - k z))."""
    if not view.perspective:
        direction = decimals(view.projection) + [Decimal(0)]
        x, y, z = (dot(row, direction) for row in to_view_plane[:3])
        if z == 0:
            raise ValueError("the direction of projection is parallel to the view plane")
        return x / z, y / z, Decimal(0)
    x, y, z = (dot(row, decimals(view.projection) + [Decimal(1)]) for row in to_view_plane[:3])
    if z <= 0:
        raise ValueError("the centre of projection is not on the viewer's side of the view plane")
    return x / z, y / z, 1 / z


@in_decimal
def to_pixels(view, image, width, height):
    """World coordinates to homogeneous pixels (X, Y, Z, W): 4 rows of 4 decimals. Z / W is 1 on the
    front plane and 0 on the back plane; W is 1 on the view plane and 0 at the centre of projection.
    """
    plane = view_plane_rows(view)
    sx, sy, k = projector(view, plane)
    zero, one = Decimal(0), Decimal(1)
    front, back = (Decimal(view.distance) - Decimal(d) for d in view.depth)
    if front <= back or k * front >= 1:
        raise ValueError("the front plane is behind the back plane or the centre of projection")
    deep = (1 - k * front) / (front - back)
    parallel = [
        [one, zero, -sx, zero],
        [zero, one, -sy, zero],
        [zero, zero, deep, -deep * back],
        [zero, zero, -k, one],
    ]
    return times(picture_rows(view, image, width, height), times(parallel, plane))


@in_decimal
def depth_at(view, w):
    """Z / W of a perspective view where W is w, rounded down to a whole number."""
    _, _, k = projector(view, view_plane_rows(view))
    front, back = (Decimal(view.distance) - Decimal(d) for d in view.depth)
    z = (1 - Decimal(w)) / k
    return int((1 - k * front) / (front - back) * (z - back) / Decimal(w))


@in_decimal
def picture_rows(view, image, width, height):
    """View-plane coordinates to pixels: window, viewport, image transformation, size."""
    x, tx = across(view.window[:2], view.viewport[:2])
    y, ty = across(view.window[2:], view.viewport[2:])
    (xx, xy, left), (yx, yy, down) = image_rows(image)
    w, h, zero, one = Decimal(width), Decimal(height), Decimal(0), Decimal(1)
    return [
        [w * xx * x, w * xy * y, zero, w * (xx * tx + xy * ty + left)],
        [h * yx * x, h * yy * y, zero, h * (yx * tx + yy * ty + down)],
        [zero, zero, one, zero],
        [zero, zero, zero, one],
    ]


def across(window, viewport):
    """Factor and summand of a window's interval on to a viewport's."""
    low, high = decimals(window)
    to_low, to_high = decimals(viewport)
    factor = (to_high - to_low) / (high - low)
    return factor, to_low - factor * low


def image_rows(image):
    sine, cosine = sine_and_cosine(image.rotation)
    sx, sy = decimals(image.scale)
    cx, cy = decimals(image.centre)
    tx, ty = decimals(image.translation)
    rows = [[cosine * sx, -sine * sy], [sine * sx, cosine * sy]]
    return [
        rows[0] + [cx + tx - rows[0][0] * cx - rows[0][1] * cy],
        rows[1] + [cy + ty - rows[1][0] * cx - rows[1][1] * cy],
    ]


@in_decimal
def image_numbers(image):
    """The six numbers of an image transformation's matrix."""
    return tuple(x for row in image_rows(image) for x in row)
