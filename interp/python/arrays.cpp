#include "interp/python/arrays.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <span>

#include "clip/base/error.h"
#include "interp/python/errors.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// The requested NumPy array: C order, aligned, native byte order.
template <class T>
using Block = py::array_t<T, py::array::c_style | py::array::forcecast |
                                 py::detail::npy_api::NPY_ARRAY_ALIGNED_>;

enum class Numbers { any, whole };

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

/// True for an array with masked numbers.
bool has_masked(py::handle value) {
  return py::isinstance<py::array>(value) && py::hasattr(value, "mask") &&
         py::hasattr(value, "filled") && py::bool_(value.attr("mask").attr("any")());
}

/// The NumPy array made of a value, if it holds numbers. Masked ones are unknown: NaN. An empty
/// list, which NumPy converts to doubles, is accepted as an empty array of integers.
py::array array_of(py::handle value, std::string_view what, Numbers numbers) {
  const auto refuse = [&](const std::string& is) -> Error {
    return Error(fmt::format("{}: expected an array of {}numbers, not {}", what,
                             numbers == Numbers::whole ? "whole " : "", is));
  };
  if (PyUnicode_Check(value.ptr()) != 0 || value.is_none() || py::isinstance<py::dict>(value)) {
    throw refuse(type_name(value));
  }
  const py::array array =
      reading(refuse(type_name(value) + " of unequal parts or other things").what(), [&] {
        py::object given = py::reinterpret_borrow<py::object>(value);
        if (has_masked(given)) {
          if (numbers == Numbers::whole) throw refuse("a masked array");
          given = given.attr("astype")("float64").attr("filled")(
              std::numeric_limits<double>::quiet_NaN());
        }
        return py::array(given);
      });
  const char kind = array.dtype().kind();
  const bool is_whole = kind == 'i' || kind == 'u';
  const bool is_empty_list = array.size() == 0 && !py::isinstance<py::array>(value);
  if (is_whole || is_empty_list || (kind == 'f' && numbers == Numbers::any)) return array;
  throw refuse("one of " + py::cast<std::string>(py::str(array.dtype())));
}

template <class T>
std::span<const T> span_of(const Block<T>& block) {
  return {block.data(), static_cast<std::size_t>(block.size())};
}

/// The array's numbers in C order.
template <class T>
Block<T> block_of(const py::array& array, std::string_view what) {
  return reading(fmt::format("{}: numbers that cannot be read", what),
                 [&] { return Block<T>(array); });
}

template <class To, class From>
std::vector<To> copied(std::span<const From> from) {
  static_assert(sizeof(To) % sizeof(From) == 0);
  std::vector<To> to(from.size_bytes() / sizeof(To));
  if (!to.empty()) std::memcpy(static_cast<void*>(to.data()), from.data(), from.size_bytes());
  return to;
}

/// Integers from `least` to `largest`; throws Error that reports the first one out of range.
template <class To>
std::vector<To> whole(const py::array& array, std::string_view what, std::int64_t least,
                      std::int64_t largest) {
  if (array.dtype().kind() == 'u' && array.itemsize() == 8) {
    for (const std::uint64_t n : span_of(block_of<std::uint64_t>(array, what))) {
      if (n > static_cast<std::uint64_t>(largest)) {
        throw Error(fmt::format("{}: {}: expected {} to {}", what, n, least, largest));
      }
    }
  }
  const auto block = block_of<std::int64_t>(array, what);
  const std::span<const std::int64_t> from = span_of(block);
  std::vector<To> to(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::int64_t n = from[i];
    if (n < least || n > largest) {
      throw Error(fmt::format("{}: {}: expected {} to {}", what, n, least, largest));
    }
    to[i] = static_cast<To>(n);
  }
  return to;
}

void require_points(const py::array& array, std::string_view what) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  if (array.size() == 0 && array.ndim() == 1) return;  // an empty list
  throw Error(fmt::format("{}: expected an array of shape (N, 3), not {}", what, shape_of(array)));
}

}  // namespace

std::string type_name(py::handle value) { return Py_TYPE(value.ptr())->tp_name; }

std::vector<double> numbers_in(py::handle value, std::string_view what) {
  const auto block = block_of<double>(array_of(value, what, Numbers::any), what);
  return copied<double>(span_of(block));
}

bool add_array(py::handle value, std::vector<double>& numbers) {
  const bool is_plain = py::type::handle_of(value).ptr() ==
                        reinterpret_cast<PyObject*>(py::detail::npy_api::get().PyArray_Type_);
  if (!is_plain || !Block<double>::check_(value)) return false;
  const auto block = py::reinterpret_borrow<Block<double>>(value);
  const std::span<const double> all = span_of(block);
  numbers.insert(numbers.end(), all.begin(), all.end());
  return true;
}

std::vector<Point3> points_in(py::handle value, std::string_view what) {
  const py::array array = array_of(value, what, Numbers::any);
  require_points(array, what);
  const auto block = block_of<double>(array, what);
  return copied<Point3>(span_of(block));
}

std::vector<FillStyle> fills_in(py::handle value, std::string_view what) {
  std::vector<FillStyle> fills;
  for (const Point3& colour : points_in(value, what)) {
    fills.push_back({FillStyle::Kind::solid, colour});
  }
  return fills;
}

std::vector<std::int32_t> whole_numbers_in(py::handle value, std::string_view what) {
  const py::array array = array_of(value, what, Numbers::whole);
  if (array.ndim() != 1) {
    throw Error(fmt::format("{}: expected an array of shape (N,), not {}", what, shape_of(array)));
  }
  using Limits = std::numeric_limits<std::int32_t>;
  return whole<std::int32_t>(array, what, Limits::min(), Limits::max());
}

// ---- Faces -------------------------------------------------------------------------------

namespace {

std::int64_t last_index(std::size_t vertices) {
  if (vertices > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(fmt::format("{} vertices: expected 4294967295 at most", vertices));
  }
  return static_cast<std::int64_t>(vertices) - 1;
}

/// True for a list or a similar sequence; false for objects that convert themselves to arrays.
bool is_sequence(py::handle value) {
  return PySequence_Check(value.ptr()) != 0 && PyUnicode_Check(value.ptr()) == 0 &&
         PyObject_CheckBuffer(value.ptr()) == 0 && !py::hasattr(value, "__array__");
}

/// Calls visit(part) for each part of a sequence, until it returns false. Holds a reference to the
/// part meanwhile: it may be the only one.
template <class Visit>
void for_each_part(py::handle sequence, std::string_view what, const Visit& visit) {
  reading(fmt::format("{}: a sequence that cannot be read", what), [&] {
    for (py::iterator part = py::iter(sequence); part != py::iterator::sentinel(); ++part) {
      if (!visit(*part)) break;
    }
  });
}

/// True for a list of lists or arrays that are not all of one length.
bool is_ragged(py::handle value) {
  if (!is_sequence(value)) return false;
  std::optional<std::size_t> length;
  bool differ = false;
  for_each_part(value, "faces", [&](py::handle part) {
    if (PySequence_Check(part.ptr()) == 0 || PyUnicode_Check(part.ptr()) != 0) return false;
    const std::size_t of_part = py::len(part);
    differ = length && *length != of_part;
    length = of_part;
    return !differ;
  });
  return differ;
}

void add_ragged_faces(py::handle value, std::int64_t last, Faces& faces) {
  for_each_part(value, "faces", [&](py::handle part) {
    const std::string what = fmt::format("face {}", faces.sides.size());
    const py::array array = array_of(part, what, Numbers::whole);
    if (array.ndim() != 1) {
      throw Error(
          fmt::format("{}: expected indices, not an array of shape {}", what, shape_of(array)));
    }
    const auto corners = whole<std::uint32_t>(array, what + ": index", 0, last);
    faces.corners.insert(faces.corners.end(), corners.begin(), corners.end());
    faces.sides.push_back(static_cast<std::uint32_t>(corners.size()));
    return true;
  });
}

}  // namespace

Faces faces_in(py::handle value, py::handle sides, std::size_t vertices) {
  const std::int64_t last = last_index(vertices);
  Faces faces;
  if (sides.is_none() && is_ragged(value)) {
    add_ragged_faces(value, last, faces);
    return faces;
  }
  const py::array array = array_of(value, "faces", Numbers::whole);
  const bool is_empty = array.size() == 0;
  if (array.ndim() != (sides.is_none() ? 2 : 1) && !is_empty) {
    throw Error(fmt::format("faces: expected {}, not an array of shape {}",
                            sides.is_none() ? "an array of shape (M, k), or sequences of indices"
                                            : "an array of all corners beside sides",
                            shape_of(array)));
  }
  faces.corners = whole<std::uint32_t>(array, "faces: index", 0, last);
  if (!sides.is_none()) {
    const py::array counts = array_of(sides, "sides", Numbers::whole);
    if (counts.ndim() != 1) {
      throw Error(fmt::format("sides: expected shape (M,), not {}", shape_of(counts)));
    }
    faces.sides =
        whole<std::uint32_t>(counts, "sides", 0, std::numeric_limits<std::uint32_t>::max());
    std::uint64_t sum = 0;
    for (const std::uint32_t n : faces.sides) sum += n;
    if (sum != faces.corners.size()) {
      throw Error(
          fmt::format("sides: {} corners in all, but faces has {}", sum, faces.corners.size()));
    }
  } else if (!is_empty && array.shape(1) != 3) {
    faces.sides.assign(static_cast<std::size_t>(array.shape(0)),
                       static_cast<std::uint32_t>(array.shape(1)));
  }
  return faces;
}

// ---- Polygons and grids ------------------------------------------------------------------

namespace {

void require_sides(py::ssize_t sides, std::size_t polygon) {
  if (sides >= 3) return;
  throw Error(fmt::format("polygon {}: {} vertices, expected 3 or more", polygon, sides));
}

}  // namespace

Polygons polygons_in(py::handle value, py::handle sides, std::string_view what) {
  Polygons polygons;
  if (!sides.is_none()) {
    polygons.points = points_in(value, what);
    std::size_t corners = 0;
    for (const std::int32_t count : whole_numbers_in(sides, "sides")) {
      require_sides(count, polygons.sides.size());
      polygons.sides.push_back(static_cast<std::uint32_t>(count));
      corners += static_cast<std::size_t>(count);
    }
    if (corners == polygons.points.size()) return polygons;
    throw Error(fmt::format("sides: {} corners in all, but there are {} points", corners,
                            polygons.points.size()));
  }
  if (is_sequence(value)) {
    for_each_part(value, what, [&](py::handle part) {
      const std::size_t number = polygons.sides.size();
      const auto points = points_in(part, fmt::format("polygon {}", number));
      require_sides(static_cast<py::ssize_t>(points.size()), number);
      polygons.points.insert(polygons.points.end(), points.begin(), points.end());
      polygons.sides.push_back(static_cast<std::uint32_t>(points.size()));
      return true;
    });
    return polygons;
  }
  const py::array array = array_of(value, what, Numbers::any);
  if (array.ndim() != 3 || array.shape(2) != 3) {
    throw Error(
        fmt::format("{}: expected an array of shape (M, k, 3), not {}", what, shape_of(array)));
  }
  if (array.shape(0) > 0) require_sides(array.shape(1), 0);
  const auto block = block_of<double>(array, what);
  polygons.points = copied<Point3>(span_of(block));
  polygons.sides.assign(static_cast<std::size_t>(array.shape(0)),
                        static_cast<std::uint32_t>(array.shape(1)));
  return polygons;
}

std::vector<Point3> segments_in(py::handle value, std::string_view what) {
  const py::array array = array_of(value, what, Numbers::any);
  if (array.ndim() != 3 || array.shape(1) != 2 || array.shape(2) != 3) {
    throw Error(
        fmt::format("{}: expected an array of shape (L, 2, 3), not {}", what, shape_of(array)));
  }
  const auto block = block_of<double>(array, what);
  return copied<Point3>(span_of(block));
}

Grid grid_in(py::handle value, std::string_view what) {
  const py::array array = array_of(value, what, Numbers::any);
  if (array.ndim() != 2) {
    throw Error(fmt::format("{}: expected an array of shape (rows, columns), not {}", what,
                            shape_of(array)));
  }
  const auto block = block_of<double>(array, what);
  return {copied<double>(span_of(block)), static_cast<std::size_t>(array.shape(0)),
          static_cast<std::size_t>(array.shape(1))};
}

int dimensions_of(py::handle value, std::string_view what) {
  return static_cast<int>(array_of(value, what, Numbers::any).ndim());
}

}  // namespace displayfile::python
