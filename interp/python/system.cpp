#include "interp/python/system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/camera.h"
#include "interp/python/errors.h"

namespace displayfile::python {

namespace py = pybind11;

// ---- User routines -----------------------------------------------------------------------

std::string python_name(std::string_view routine) {
  std::string name(routine);
  std::ranges::replace(name, '-', '_');
  return name;
}

std::string in_python(std::string_view sentence) {
  std::string result(sentence);
  for (const UserRoutine& routine : user_routines()) {
    if (routine.name.find('-') == routine.name.npos) continue;
    for (std::size_t at = 0; (at = result.find(routine.name, at)) != result.npos; ++at) {
      result.replace(at, routine.name.size(), python_name(routine.name));
    }
  }
  return result;
}

namespace {

/// Routines that do little more than to note what they are told.
bool is_over_soon(std::string_view name) {
  constexpr std::string_view kBegin[] = {"move-",   "line-",  "polygon-", "set-", "translate-",
                                         "rotate-", "scale-", "open-",    "text"};
  return std::ranges::any_of(kBegin,
                             [&](std::string_view begin) { return name.starts_with(begin); });
}

using EnterPoints = void (*)(GraphicsSystem& system, std::span<const Point3> points);

/// What programs in Python call very often, with numbers alone: without words between. Null for
/// what is not, or not so many numbers.
EnterPoints entered_at_once(std::string_view name, std::size_t numbers) {
  if (name == "polygon-abs-3" && numbers % 3 == 0) {
    return [](GraphicsSystem& system, std::span<const Point3> p) { system.polygon_abs_3(p); };
  }
  if (name == "line-abs-3" && numbers == 3) {
    return
        [](GraphicsSystem& s, std::span<const Point3> p) { s.line_abs_3(p[0].x, p[0].y, p[0].z); };
  }
  if (name == "move-abs-3" && numbers == 3) {
    return
        [](GraphicsSystem& s, std::span<const Point3> p) { s.move_abs_3(p[0].x, p[0].y, p[0].z); };
  }
  return nullptr;
}

bool enter_at_once(System& self, const UserRoutine& routine, const py::args& arguments) {
  if (!routine.name.ends_with("-abs-3")) return false;
  std::vector<double> numbers;
  if (!add_numbers(arguments, numbers)) return false;
  const EnterPoints enter = entered_at_once(routine.name, numbers.size());
  if (enter == nullptr) return false;
  std::vector<Point3> points(numbers.size() / 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
  }
  self.call([&](GraphicsSystem& system) { enter(system, points); });
  return true;
}

void call_routine(System& self, const UserRoutine& routine, const py::args& arguments) {
  require_whole_points(arguments, routine);
  if (enter_at_once(self, routine, arguments)) return;
  const std::string words = words_of(arguments, routine);
  const auto call = [&](GraphicsSystem& system) { call_user_routine(system, routine.name, words); };
  if (is_over_soon(routine.name)) return self.call(call);
  self.work([&](GraphicsSystem& system, Renderer&) { call(system); });
}

/// In lines that fit on a terminal.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 88;
  std::string lines = text;
  std::size_t begin = 0, blank = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i - begin > kWidth && blank > begin) {
      lines[blank] = '\n';
      begin = blank + 1;
    }
    if (lines[i] == ' ') blank = i;
  }
  return lines;
}

void add_routine(SystemClass& system, const UserRoutine& routine) {
  const std::string name = python_name(routine.name);
  const std::string what = fmt::format(
      "{}($self, /, *arguments)\n--\n\n{}\n\n{}", name, wrapped(in_python(routine.meaning)),
      routine.expected.empty() ? "No arguments." : fmt::format("Arguments: {}.", routine.expected));
  system.def(
      name.c_str(),
      [&routine](System& self, const py::args& arguments) {
        call_routine(self, routine, arguments);
      },
      what.c_str());
}

// ---- Segments of their own ---------------------------------------------------------------

int next_name(const GraphicsSystem& system) {
  std::int64_t name = 0;
  for (const Segment& segment : system.display_file().segments()) {
    name = std::max<std::int64_t>(name, segment.name());
  }
  if (name == std::numeric_limits<int>::max())
    throw Error("no segment name is left above all others");
  return static_cast<int>(name + 1);
}

/// Calls enter() within the open segment, or else in one of its own. Returns the segment's name.
template <class Enter>
int in_segment(GraphicsSystem& system, const std::optional<int>& name, const Enter& enter) {
  if (const auto open = system.open_segment_name(); open && !name) {
    enter();
    return *open;
  }
  const int own = name ? *name : next_name(system);
  if (system.open_segment_name()) system.open_segment(own);  // which is refused
  system.enter_segments([&] {
    system.open_segment(own);
    enter();
    system.close_segment();
  });
  return own;
}

// ---- Meshes ------------------------------------------------------------------------------

std::vector<FillStyle> one_fill_in(py::handle value) {
  if (PyUnicode_Check(value.ptr()) != 0) {
    if (word_in(value, "fill") == "hollow") return {{FillStyle::Kind::hollow}};
    throw Error("fill: expected red, green and blue, or 'hollow'");
  }
  const std::vector<double> numbers = numbers_in(value, "fill");
  if (numbers.size() != 3) {
    throw Error(fmt::format("fill: expected red, green and blue, not {} numbers", numbers.size()));
  }
  return {{FillStyle::Kind::solid, {numbers[0], numbers[1], numbers[2]}}};
}

int mesh(System& self, py::handle vertices, py::handle faces, py::handle sides, py::handle segment,
         py::handle fill, py::handle fills, py::handle picks, py::handle normals) {
  const auto name = if_given(segment, "segment", whole_number_in);
  const std::vector<Point3> points = points_in(vertices, "vertices");
  const Faces polygons = faces_in(faces, sides, points.size());
  const std::size_t count =
      polygons.sides.empty() ? polygons.corners.size() / 3 : polygons.sides.size();
  if (!fill.is_none() && !fills.is_none()) throw Error("fill and fills: expected one of them");
  std::vector<FillStyle> styles;
  if (!fill.is_none()) styles = one_fill_in(fill);
  if (!fills.is_none()) {
    styles = fills_in(fills, "fills");
    if (styles.size() != count) {
      throw Error(fmt::format("fills: {} of them for {} faces", styles.size(), count));
    }
  }
  std::vector<std::int32_t> identifiers;
  if (!picks.is_none()) {
    identifiers = whole_numbers_in(picks, "picks");
    if (identifiers.size() != count) {
      throw Error(fmt::format("picks: {} of them for {} faces", identifiers.size(), count));
    }
  }
  std::vector<Point3> of_vertices;
  if (!normals.is_none()) {
    of_vertices = points_in(normals, "normals");
    if (of_vertices.size() != points.size()) {
      throw Error(
          fmt::format("normals: {} of them for {} vertices", of_vertices.size(), points.size()));
    }
  }
  return self.work([&](GraphicsSystem& system, Renderer&) {
    return in_segment(system, name, [&] {
      system.polygons_abs_3({.vertices = points,
                             .corners = polygons.corners,
                             .sides = polygons.sides,
                             .fills = styles,
                             .picks = identifiers,
                             .normals = of_vertices});
    });
  });
}

// ---- Surfaces ----------------------------------------------------------------------------

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

/// True if the numbers stand at even steps, but for what their rounding moves them, and rise.
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

/// Turned round so that x and y rise, if they fall.
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

/// Its cells as polygons of four sides; those with an unknown height are left out.
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
  system.polygons_abs_3({vertices, corners, sides});
}

int surface(System& self, py::handle x, py::handle y, py::handle z, py::handle segment) {
  const auto name = if_given(segment, "segment", whole_number_in);
  SurfacePoints points = surface_points(x, y, z);
  return self.work([&](GraphicsSystem& system, Renderer&) {
    if (points.regular) make_rise(points);
    const bool even = points.regular && rise_evenly(points.x) && rise_evenly(points.y);
    return in_segment(system, name, [&] {
      if (!even) return enter_cells(points, system);
      system.surface_3({points.x.front(), points.x.back(), static_cast<int>(points.z.columns),
                        points.y.front(), points.y.back(), static_cast<int>(points.z.rows),
                        points.z.values});
    });
  });
}

// ---- Files -------------------------------------------------------------------------------

void replay_text(System& self, py::handle text, py::handle name) {
  const std::string program = word_in(text, "replay"), file = word_in(name, "name");
  self.work([&](GraphicsSystem& system, Renderer&) {
    placing_errors([&] { system.all_or_nothing([&] { replay(program, file, system); }); });
  });
}

void replay_path(System& self, py::handle file) {
  const std::string path = path_in(file, "path");
  self.work([&](GraphicsSystem& system, Renderer&) {
    placing_errors([&] { system.all_or_nothing([&] { replay_file(path, system); }); });
  });
}

/// What of the mesh is not drawn, a sentence each.
std::vector<std::string> import_path(System& self, py::handle file, py::handle colour,
                                     const py::kwargs& camera) {
  const std::string path = path_in(file, "path");
  MeshOptions options{.camera = camera_in(camera)};
  if (!colour.is_none()) options.colour = one_fill_in(colour).front().colour;
  const bool changes_view = options.camera != Camera{.turning = options.camera.turning};
  const Mesh::Skipped skipped = self.work([&](GraphicsSystem& system, Renderer&) {
    const ExplicitSettings set = system.explicit_settings();
    if (changes_view && (set.contains(Setting::window) || set.contains(Setting::camera))) {
      throw Error("a camera for the mesh: expected a system whose view was not set before");
    }
    ImportedMeshes imported =
        placing_errors([&] { return import_meshes(std::span(&path, 1), system, options); });
    if (imported.fitted) {
      const Camera& looking = options.camera;
      self.set_fitted({imported.fitted->up, looking.fit && !looking.angle_of_view});
    }
    return std::move(imported.skipped.front());
  });
  std::vector<std::string> sentences = skipped.warnings;
  for (const std::string& what : left_out(skipped)) sentences.push_back("left out: " + what);
  return sentences;
}

}  // namespace

SystemClass add_system(py::module_& module) {
  SystemClass system(module, "System", "An application's display file.");
  system.def(py::init<>());
  for (const UserRoutine& routine : user_routines()) add_routine(system, routine);
  system.def("_record", [](System& self, py::handle on) { self.record(switch_in(on, "on")); });
  system.def("_recording", [](System& self) { return self.recording(); });
  system.def("_mesh", mesh);
  system.def("_surface", surface);
  system.def("_replay", replay_text);
  system.def("_replay_file", replay_path);
  system.def("_import_mesh",
             [](System& self, py::handle path, py::handle colour, const py::kwargs& camera) {
               py::list left_out;
               for (const std::string& sentence : import_path(self, path, colour, camera)) {
                 left_out.append(text_of(sentence));
               }
               return left_out;
             });
  system.def("_retain", [](System& self) { self.call([](GraphicsSystem& s) { s.retain(); }); });
  return system;
}

}  // namespace displayfile::python
