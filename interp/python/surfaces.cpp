#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/pipeline/cutting_planes.h"
#include "displayfile/graphics_system.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/entering.h"
#include "interp/python/lines.h"
#include "interp/python/smooth_faces.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// A surface over a grid, x and y along its columns and rows; or points anywhere.
struct SurfacePoints {
  std::vector<double> x, y;  // of columns and of rows, if `regular`; else of all points
  Grid z;
  bool regular = true;
};

/// The numbers along the columns (or rows) of a meshgrid's array, if all rows (or columns) agree.
std::optional<std::vector<double>> along(const Grid& grid, bool columns) {
  std::vector<double> numbers(columns ? grid.columns : grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const double value = grid.values[j * grid.columns + i];
      double& number = numbers[columns ? i : j];
      if ((columns ? j : i) == 0) number = value;
      if (number != value) return std::nullopt;
    }
  }
  return numbers;
}

void require_finite(std::span<const double> numbers, std::string_view what) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) {
      throw Error(fmt::format("{}: expected finite numbers, not {}", what, number));
    }
  }
}

SurfacePoints surface_points(py::handle x, py::handle y, py::handle z) {
  SurfacePoints surface;
  surface.z = grid_in(z, "z");
  const std::size_t rows = surface.z.rows, columns = surface.z.columns;
  if (rows < 2 || columns < 2) {
    throw Error(
        fmt::format("z: shape ({}, {}), expected 2 points or more each way", rows, columns));
  }
  const int dimensions = dimensions_of(x, "x");
  if (dimensions_of(y, "y") != dimensions)
    throw Error("x and y: expected the same number of dimensions");
  if (dimensions == 2) {
    Grid of_x = grid_in(x, "x"), of_y = grid_in(y, "y");
    if (of_x.rows != rows || of_x.columns != columns || of_y.rows != rows ||
        of_y.columns != columns) {
      throw Error(fmt::format("x and y: expected the shape of z, ({}, {})", rows, columns));
    }
    auto along_x = along(of_x, true), along_y = along(of_y, false);
    surface.regular = along_x && along_y;
    surface.x = surface.regular ? std::move(*along_x) : std::move(of_x.values);
    surface.y = surface.regular ? std::move(*along_y) : std::move(of_y.values);
  } else {
    surface.x = numbers_in(x, "x");
    surface.y = numbers_in(y, "y");
    if (dimensions != 1 || surface.x.size() != columns || surface.y.size() != rows) {
      throw Error(fmt::format("x and y: expected {} and {} numbers, as z has columns and rows",
                              columns, rows));
    }
  }
  require_finite(surface.x, "x");
  require_finite(surface.y, "y");
  for (const double height : surface.z.values) {
    if (std::isinf(height)) throw Error("z: expected finite numbers, or nan for a hole, not inf");
  }
  return surface;
}

/// True if the numbers increase at even steps, up to their rounding.
bool rise_evenly(std::span<const double> numbers) {
  const double low = numbers.front(), high = numbers.back();
  if (!(low < high)) return false;
  const double size = std::max(std::abs(low), std::abs(high));
  const double allowed = 8.0 * std::numeric_limits<double>::epsilon() * size;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(numbers.size() - 1);
    if (std::abs(numbers[k] - (low + (high - low) * part)) > allowed) return false;
  }
  return true;
}

/// Reverses x and y where they decrease, so that they increase.
void make_rise(SurfacePoints& surface) {
  const std::size_t columns = surface.z.columns;
  auto& heights = surface.z.values;
  const auto row = [&](std::size_t j) {
    return heights.begin() + static_cast<std::ptrdiff_t>(j * columns);
  };
  if (surface.x.front() > surface.x.back()) {
    std::ranges::reverse(surface.x);
    for (std::size_t j = 0; j < surface.z.rows; ++j) std::reverse(row(j), row(j + 1));
  }
  if (surface.y.front() > surface.y.back()) {
    std::ranges::reverse(surface.y);
    for (std::size_t j = 0; j < surface.z.rows / 2; ++j) {
      std::swap_ranges(row(j), row(j + 1), row(surface.z.rows - 1 - j));
    }
  }
}

/// Enters the surface's cells as quadrilaterals, except those with an unknown height.
void enter_cells(const SurfacePoints& surface, GraphicsSystem& system) {
  const std::size_t rows = surface.z.rows, columns = surface.z.columns;
  if (rows * columns > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("z: too many points for a surface that is not over an even grid");
  }
  std::vector<Point3> vertices(rows * columns);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const double height = surface.z.values[k];
    vertices[k] = {surface.regular ? surface.x[k % columns] : surface.x[k],
                   surface.regular ? surface.y[k / columns] : surface.y[k],
                   std::isnan(height) ? 0.0 : height};
  }
  const auto known = [&](std::size_t k) { return !std::isnan(surface.z.values[k]); };
  std::vector<std::uint32_t> corners;
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t k = j * columns + i;
      const std::size_t cell[] = {k, k + 1, k + 1 + columns, k + columns};
      if (!std::ranges::all_of(cell, known)) continue;
      for (const std::size_t corner : cell) corners.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  const std::vector<std::uint32_t> sides(corners.size() / 4, 4);
  enter_faces(system, {vertices, corners, sides});
}

/// The surface in pieces of one colour each.
struct SurfacePieces {
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners, sides;
  std::vector<FillStyle> fills;
  std::vector<std::int32_t> picks;
  std::vector<Point3> normals;
  ManyPolygons many() const { return {points, corners, sides, fills, picks, normals}; }
};

std::optional<SurfacePieces> pieces_in(py::handle value) {
  if (value.is_none()) return std::nullopt;
  const auto [points, sides, fills, picks, normals] =
      py::cast<std::tuple<py::object, py::object, py::object, py::object, py::object>>(value);
  SurfacePieces pieces;
  pieces.points = points_in(points, "points");
  for (const std::int32_t n : whole_numbers_in(sides, "sides")) {
    pieces.sides.push_back(static_cast<std::uint32_t>(n));
  }
  for (std::size_t k = 0; k < pieces.points.size(); ++k) {
    pieces.corners.push_back(static_cast<std::uint32_t>(k));
  }
  pieces.fills = fills_in(fills, "fills");
  pieces.picks = whole_numbers_in(picks, "picks");
  if (!normals.is_none()) pieces.normals = points_in(normals, "normals");
  return pieces;
}

/// The rows of an array (K, 4).
std::vector<std::array<double, 4>> planes_in(py::handle value) {
  const std::vector<double> numbers = numbers_in(value, "crop");
  std::vector<std::array<double, 4>> planes(numbers.size() / 4);
  for (std::size_t k = 0; k < numbers.size(); ++k) planes[k / 4][k % 4] = numbers[k];
  return planes;
}

/// Calls enter() with these cutting planes in force.
template <class Enter>
void cropping(GraphicsSystem& system, std::span<const std::array<double, 4>> planes,
              const Enter& enter) {
  if (planes.empty()) return enter();
  if (SystemInside::cutting_planes(system).any() ||
      !system.modelling_transformation().is_identity()) {
    throw Error("crop: expected no cutting plane and no modelling transformation in force");
  }
  const auto count = static_cast<int>(planes.size());
  const auto off = [&] {
    for (int n = 1; n <= count; ++n) system.set_cutting_plane_off(n);
  };
  for (int n = 1; n <= count; ++n) {
    const auto& [a, b, c, d] = planes[static_cast<std::size_t>(n - 1)];
    system.set_cutting_plane(n, a, b, c, d);
  }
  try {
    enter();
  } catch (...) {
    off();
    throw;
  }
  off();
}

void enter_contours(GraphicsSystem& system, std::span<const Point3> ends,
                    const OwnLineStyle& style) {
  with_line_style(system, style, [&] {
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      system.move_abs_3(ends[k].x, ends[k].y, ends[k].z);
      system.line_abs_3(ends[k + 1].x, ends[k + 1].y, ends[k + 1].z);
    }
  });
}

void enter_surface(const SurfacePoints& points, GraphicsSystem& system) {
  const bool even = points.regular && rise_evenly(points.x) && rise_evenly(points.y);
  if (!even) return enter_cells(points, system);
  system.surface_3({points.x.front(), points.x.back(), static_cast<int>(points.z.columns),
                    points.y.front(), points.y.back(), static_cast<int>(points.z.rows),
                    points.z.values});
}

int surface(System& self, py::handle x, py::handle y, py::handle z, py::handle segment,
            py::handle crop, py::handle lines, py::handle in_pieces, py::handle line_colour,
            py::handle line_width) {
  const auto name = if_given(segment, "segment", whole_number_in);
  SurfacePoints points = surface_points(x, y, z);
  const auto planes = planes_in(crop);
  const std::vector<Point3> ends =
      lines.is_none() ? std::vector<Point3>() : segments_in(lines, "contours");
  const std::optional<SurfacePieces> pieces = pieces_in(in_pieces);
  const OwnLineStyle style = own_line_style_in(line_colour, line_width, "contour_");
  return in_followed_segment(self, {name, !pieces}, [&](GraphicsSystem& system) {
    if (points.regular) make_rise(points);
    cropping(system, planes, [&] {
      const auto enter_whole = [&] { enter_surface(points, system); };
      pieces ? enter_in_pieces(system, pieces->many(), enter_whole) : enter_whole();
      if (!ends.empty()) enter_contours(system, ends, style);
    });
  });
}

}  // namespace

void add_surfaces(SystemClass& system) {
  system.def("_surface", surface, py::arg(), py::arg(), py::arg(), py::arg(), py::arg(),
             py::arg() = py::none(), py::arg() = py::none(), py::arg() = py::none(),
             py::arg() = py::none());
}

}  // namespace displayfile::python
