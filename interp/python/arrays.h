#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile::python {

// ---- In ----------------------------------------------------------------------------------

// Arrays of any numbers, and sequences that NumPy converts to one, are read as doubles or integers.
// Their contents are copied in one block, since another thread may change them meanwhile. Each
// function throws Error, with `what` naming the array, for a wrong shape or type.

std::string type_name(pybind11::handle value);

std::vector<double> numbers_in(pybind11::handle value, std::string_view what);
/// Adds the numbers of a contiguous array of doubles; false for anything else, including a
/// subclass, whose numbers may mean something else: masked ones are unknown.
bool add_array(pybind11::handle value, std::vector<double>& numbers);
/// Reads an array (N, 3).
std::vector<Point3> points_in(pybind11::handle value, std::string_view what);
/// Reads an array (N, 3) of components, each in [0,1], as the routine requires.
std::vector<FillStyle> fills_in(pybind11::handle value, std::string_view what);
/// Reads an array (N,).
std::vector<std::int32_t> whole_numbers_in(pybind11::handle value, std::string_view what);

/// Polygons over vertices: `sides[k]` corners of polygon k, or 3 of each if it is empty.
struct Faces {
  std::vector<std::uint32_t> corners, sides;
};
/// An array (M, k), a sequence of sequences of indices, or with `sides` an array of all corners.
Faces faces_in(pybind11::handle faces, pybind11::handle sides, std::size_t vertices);

/// Polygons with vertices of their own: an array (M, k, 3), or a sequence of arrays (k, 3);
/// or if `sides` is not None, an array (N, 3) of all corners, of which polygon k has sides[k].
struct Polygons {
  std::vector<Point3> points;
  std::vector<std::uint32_t> sides;
};
Polygons polygons_in(pybind11::handle value, pybind11::handle sides, std::string_view what);
/// An array (L, 2, 3), as 2 L points.
std::vector<Point3> segments_in(pybind11::handle value, std::string_view what);

/// A grid of heights as an array (rows, columns).
struct Grid {
  std::vector<double> values;
  std::size_t rows = 0, columns = 0;
};
Grid grid_in(pybind11::handle value, std::string_view what);
/// The number of dimensions of the NumPy array made of the value.
int dimensions_of(pybind11::handle value, std::string_view what);

// ---- Out ---------------------------------------------------------------------------------

/// An array over the vector's memory, which lives as long as the array.
template <class T, class Element>
pybind11::array owned(std::vector<Element>&& values, std::vector<pybind11::ssize_t> shape) {
  auto kept = std::make_unique<std::vector<Element>>(std::move(values));
  Element* const data = kept->data();
  const pybind11::capsule owner(kept.get(),
                                [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  kept.release();
  return pybind11::array_t<T>(std::move(shape), reinterpret_cast<const T*>(data), owner);
}
template <class T>
pybind11::array owned(std::vector<T>&& values) {
  const auto count = static_cast<pybind11::ssize_t>(values.size());
  return owned<T>(std::move(values), {count});
}
/// Points or colours, (N, 3).
inline pybind11::array owned(std::vector<Point3>&& values) {
  const auto count = static_cast<pybind11::ssize_t>(values.size());
  return owned<double>(std::move(values), {count, 3});
}

}  // namespace displayfile::python
