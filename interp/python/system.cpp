#include "interp/python/system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <sstream>
#include <tuple>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/camera.h"
#include "interp/python/entering.h"
#include "interp/python/errors.h"
#include "interp/python/smooth_faces.h"

namespace displayfile::python {

namespace py = pybind11;

// ---- Views that follow what is entered ---------------------------------------------------

std::string System::recorded() const {
  const std::string since = recording_.str();
  return recorded_before_ + (followed_.follows() ? followed_.recorded(since) : since);
}

void System::running(GraphicsSystem& system, bool sets_view, const std::function<void()>& run) {
  if (!followed_.follows()) return run();
  followed_.bring_up_to_date(system);
  const std::string since = recording_.str(), in_view = recorded();
  const auto set = [&](const std::string& text) {
    std::ostringstream& stream = recording_;
    stream.str("");
    stream << text;
  };
  set("");
  try {
    followed_.running(system, sets_view, run);
  } catch (...) {
    set(since);
    throw;
  }
  if (followed_.follows()) return set(since + recording_.str());
  recorded_before_ = in_view;
}

void System::set_aspect_ratio(double aspect) {
  call([&](GraphicsSystem& system) {
    system.set_aspect_ratio(aspect);
    is_aspect_set_ = true;
    followed_.changed();
  });
}

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

/// Routines that do little more than store their arguments.
bool is_over_soon(std::string_view name) {
  constexpr std::string_view kBegin[] = {"move-",   "line-",  "polygon-", "set-", "translate-",
                                         "rotate-", "scale-", "open-",    "text"};
  return std::ranges::any_of(kBegin,
                             [&](std::string_view begin) { return name.starts_with(begin); });
}

using EnterPoints = void (*)(GraphicsSystem& system, std::span<const Point3> points);

/// The direct entry point of a routine that Python programs call very often with numbers alone,
/// without conversion to words. Null for other routines and other numbers of arguments.
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

void call_routine(System& self, const UserRoutine& routine, const py::args& by_place,
                  const py::kwargs& by_name) {
  const py::args arguments = by_name.empty() ? by_place : in_places(by_place, by_name, routine);
  require_whole_points(arguments, routine);
  if (enter_at_once(self, routine, arguments)) return;
  const std::string words = words_of(arguments, routine);
  const bool sets_view = routine.section == "View";
  const auto call = [&](GraphicsSystem& system) {
    const auto run = [&] { call_user_routine(system, routine.name, words); };
    if (sets_view) return self.running(system, true, run);
    if (routine.name == "open-segment") self.followed().place(system);
    if (routine.name == "axes-3") self.followed().place_in_segment(system);
    run();
  };
  const bool may_view =
      sets_view && self.call([&](GraphicsSystem&) { return self.followed().follows(); });
  if (is_over_soon(routine.name) && !may_view) return self.call(call);
  self.work([&](GraphicsSystem& system, Renderer&) { call(system); });
}

/// Wraps text to lines that fit on a terminal.
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
      "{}($self, {})\n--\n\n{}\n\n{}", name, signature_of(routine),
      wrapped(in_python(routine.meaning)),
      routine.expected.empty() ? "No arguments." : fmt::format("Arguments: {}.", routine.expected));
  system.def(
      name.c_str(),
      [&routine](System& self, const py::args& arguments, const py::kwargs& by_name) {
        call_routine(self, routine, arguments, by_name);
      },
      what.c_str());
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
         py::handle fill, py::handle fills, py::handle picks, py::handle normals,
         py::handle outline, bool is_lit, py::handle vertex_colours) {
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
  std::vector<Colour> colours;
  if (!vertex_colours.is_none()) colours = points_in(vertex_colours, "fills");
  const ManyPolygons many{.vertices = points,
                          .corners = polygons.corners,
                          .sides = polygons.sides,
                          .fills = styles,
                          .picks = identifiers,
                          .normals = of_vertices,
                          .vertex_colours = colours};
  std::vector<Point3> of_sides;
  Faces sides_drawn;
  if (!outline.is_none()) {
    const auto [whole, whole_faces, whole_sides] =
        py::cast<std::tuple<py::object, py::object, py::object>>(outline);
    of_sides = points_in(whole, "vertices");
    sides_drawn = faces_in(whole_faces, whole_sides, of_sides.size());
  }
  return in_followed_segment(self, {name, is_lit}, [&](GraphicsSystem& system) {
    if (outline.is_none()) return enter_faces(system, many);
    enter_in_pieces(system, many, [&] {
      system.polygons_abs_3(
          {.vertices = of_sides, .corners = sides_drawn.corners, .sides = sides_drawn.sides});
    });
  });
}

/// Normals at the corners of the faces, (C, 3), for pieces of them; None where those do not count,
/// because the light of pieces leaves colours as they are unless one is set.
py::object normals_at_corners(System& self, py::handle vertices, py::handle faces,
                              py::handle sides) {
  const bool count = self.call([](GraphicsSystem& system) {
    return system.explicit_settings().contains(Setting::light) && shades_smoothly(system);
  });
  if (!count) return py::none();
  const std::vector<Point3> points = points_in(vertices, "vertices");
  const Faces polygons = faces_in(faces, sides, points.size());
  if (polygons.corners.empty() || !std::ranges::all_of(points, in_range)) return py::none();
  return owned(self.work([&](GraphicsSystem& system, Renderer&) {
    return corner_normals(
        {.vertices = points, .corners = polygons.corners, .sides = polygons.sides}, system);
  }));
}

// ---- Files -------------------------------------------------------------------------------

void replay_text(System& self, py::handle text, py::handle name) {
  const std::string program = word_in(text, "replay"), file = word_in(name, "name");
  self.work([&](GraphicsSystem& system, Renderer&) {
    self.running(system, false, [&] {
      placing_errors([&] { system.all_or_nothing([&] { replay(program, file, system); }); });
    });
  });
}

void replay_path(System& self, py::handle file) {
  const std::string path = path_in(file, "path");
  self.work([&](GraphicsSystem& system, Renderer&) {
    self.running(system, false, [&] {
      placing_errors([&] { system.all_or_nothing([&] { replay_file(path, system); }); });
    });
  });
}

/// Imports a mesh beside others that a camera follows. Returns the skipped parts.
Mesh::Skipped import_followed(const std::string& path, GraphicsSystem& system,
                              FollowedView& followed, const MeshOptions& options) {
  const bool is_smooth = system.looks().attributes.shading != Shading::flat;
  Mesh mesh = placing_errors([&] { return read_mesh(path, is_smooth, options.import_limits); });
  if (is_smooth) complete_normals(mesh, system);
  followed.place(system);
  system.all_or_nothing([&] { enter_meshes(std::span(&mesh, 1), system, options); });
  return std::move(mesh.skipped);
}

/// Imports a mesh; returns a sentence for each kind of content that is not drawn.
std::vector<std::string> import_path(System& self, py::handle file, py::handle colour,
                                     const py::kwargs& camera) {
  const std::string path = path_in(file, "path");
  MeshOptions options{.camera = camera_in(camera)};
  if (!colour.is_none()) options.colour = one_fill_in(colour).front().colour;
  const bool changes_view = options.camera != Camera{.turning = options.camera.turning};
  const Mesh::Skipped skipped = self.work([&](GraphicsSystem& system, Renderer&) {
    const ExplicitSettings set = system.explicit_settings();
    if (self.followed().follows()) {
      if (changes_view) throw Error("a camera for the mesh: expected that of look() alone");
      return import_followed(path, system, self.followed(), options);
    }
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
  system.def("_mesh", mesh, py::arg(), py::arg(), py::arg(), py::arg(), py::arg(), py::arg(),
             py::arg(), py::arg(), py::arg() = py::none(), py::arg() = true,
             py::arg() = py::none());
  system.def("_normals_at_corners", normals_at_corners);
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
