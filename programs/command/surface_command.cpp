#include "programs/command/surface_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/system/process_memory.h"
#include "displayfile/text/output_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/draw/draw.h"
#include "programs/inputs/not_in_picture.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/number_in.h"
#include "programs/options/picture_words.h"
#include "programs/process/progress.h"

namespace displayfile {

namespace {

constexpr int kMostContours = 100;

/// `X,Y,Z`, three names.
std::array<std::string, 3> names_of_axes(const std::string& text) {
  if (text.empty()) return {"x", "y", "z"};
  const std::size_t first = text.find(','), second = text.find(',', first + 1);
  if (first == text.npos || second == text.npos || text.find(',', second + 1) != text.npos) {
    throw Error(fmt::format("--labels {}: expected three names separated by commas", text));
  }
  return {text.substr(0, first), text.substr(first + 1, second - first - 1),
          text.substr(second + 1)};
}

bool has_holes(const SurfaceData& surface) {
  return std::ranges::any_of(surface.heights, [](double height) { return std::isnan(height); });
}

/// The most bytes that drawing holds at a time for a cell, measured: of curves by the perimeter
/// method, and of anything drawn by another method.
constexpr double kBytesOfCurves = 500.0, kBytesOfOthers = 1300.0;
/// The factor for address space that is reserved at once: not all of it is used without gaps.
constexpr double kRoom = 1.25;

/// Throws Error, before any time is spent on them, if the system lacks the memory that the points
/// need.
void require_memory(double points, const std::string& surface, double bytes_of_cell) {
  constexpr double kGigabyte = 1e9, kWorthAsking = 1e8;
  const double needed = points * bytes_of_cell;
  if (needed < kWorthAsking) return;
  const auto offered = static_cast<double>(offered_memory());
  if (needed <= offered) return;
  const double most = std::floor(std::sqrt(offered / bytes_of_cell));
  throw Error(
      fmt::format("out of memory: {}: drawing {:.0f} points needs {:.3g} GB, and the system offers "
                  "{:.3g} GB: expected {:.0f} x {:.0f} points or fewer",
                  surface, points, needed / kGigabyte, offered / kGigabyte, most, most));
}

/// One surface in lines is drawn nearest first; coloured or intersecting surfaces are drawn as
/// surfaces.
HiddenMethod usual_method(std::span<const SurfaceData> surfaces, bool coloured) {
  if (surfaces.size() > 1 || coloured) return HiddenMethod::automatic;
  return has_holes(surfaces[0]) ? HiddenMethod::franklin : HiddenMethod::perimeter;
}

/// Records the user routines that set the hidden-surface options, so that the program draws the
/// same without them. A surface is open: its back faces are visible.
void record_drawing(Recorder& recorder, const DrawOptions& options,
                    const std::optional<LineSelection>& lines) {
  GraphicsSystem system;
  system.set_recorder(&recorder);
  system.set_hidden_surfaces({.removal = true});
  system.set_back_face_removal(false);
  system.set_hidden_surfaces({.method = options.surfaces.method,
                              .scope = options.surfaces.scope,
                              .precision = options.surfaces.precision,
                              .hidden_lines = options.surfaces.hidden_lines});
  if (options.background) system.set_background(*options.background);
  if (lines) system.set_hidden_surfaces({.lines = *lines});
}

}  // namespace

CLI::App& SurfaceCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "surface", "Draw surfaces z = F(x, y) over a grid: curves, axes, colours");
  command
      .add_option("SURFACE", surfaces,
                  "expressions in x and y, or files of heights, .npy, .txt or .csv, with the row "
                  "at y-min first; several are drawn together and may intersect")
      ->type_name("EXPRESSION|HEIGHTS.{npy,txt,csv}")
      ->required();
  command.add_option("-o,--output", output, "the picture")->type_name(picture_file())->required();
  command.add_option("--x", x, "range of x [-1:1]")->type_name("A:B");
  command.add_option("--y", y, "range of y [-1:1]")->type_name("A:B");
  command.add_option("--z", z, "heights that the box must include")->type_name("A:B");
  command.add_option("--grid", grid, "number of points for expressions [50x50]")
      ->type_name("NXxNY");
  command.add_option("--curves", curves, "curves to draw")
      ->type_name("x|y|both")
      ->default_str("both");
  command.add_option("--sides", sides, "sides of the surface on which curves are drawn")
      ->type_name("upper|lower|both")
      ->default_str("both");
  command.add_option("--colour", colour, "colour cells by height, with a legend")
      ->type_name("height");
  command
      .add_option("--contours", contours,
                  "number of lines of equal height, drawn at the base of the box")
      ->type_name("N")
      ->transform(any_number<int>())
      ->default_str("0");
  command.add_flag("--axes,!--no-axes", axes, "draw axes with numbers and names")
      ->default_str("true");
  command.add_flag("--box,!--no-box", box, "draw the faces of the box behind the surface")
      ->default_str("true");
  command.add_option("--labels", labels, "names of the axes [x,y,z]")->type_name("X,Y,Z");
  command.add_flag(
      "--true-scale", true_scale,
      "use the same unit length on every axis; by default the box has fixed proportions");
  command
      .add_option("--line-width", line_width,
                  "width of all lines: in pixels, in mm with --paper or --pens, or with a unit "
                  "(0.2mm, 0.5pt, 2px); by default curves are thinner, the more there are")
      ->type_name("WIDTH");
  command
      .add_option("--text-size", text_size,
                  "size of the letters of axes and legend, that of the font: in pixels, in mm with "
                  "--paper or --pens, or with a unit (8pt, 3mm); the surface gets the room that "
                  "they leave [2.6 % of the picture's height]")
      ->type_name("SIZE");
  command.add_option("--program", program, "also write the drawing program")
      ->type_name("PROGRAM.draw");
  command
      .add_option("--threads", hidden_surfaces.surfaces.threads,
                  "maximum number of threads; the picture does not depend on it")
      ->type_name("N")
      ->transform(any_number<int>());
  command
      .add_option("--samples", samples,
                  "antialiasing: each pixel is the mean of N x N samples; 1 for none, the default "
                  "with plain-z-buffer")
      ->type_name("N")
      ->transform(any_number<int>())
      ->default_str(fmt::format("{}", kUsualSamples));
  size.add_to(command, true);
  camera.add_to(command, {"the surface", "30,30", "z"});
  hidden_surfaces.add_to(command);
  background.add_to(command);
  vectors.add_to(command);
  paper.add_to(command);
  return command;
}

GridRange SurfaceCommand::range() const {
  GridRange range;
  read_range("--x", x, range.x_min, range.x_max);
  read_range("--y", y, range.y_min, range.y_max);
  read_grid_size(grid, range);
  return range;
}

SurfaceLook SurfaceCommand::look(const DrawOptions& drawing) const {
  SurfaceLook look;
  look.camera = camera.camera();
  if (camera.up.empty()) look.camera.upright = upright("z");
  if (camera.eye.empty()) look.camera.eye = EyeDirection{30.0, 30.0};
  if (!z.empty()) {
    look.heights.emplace();
    read_range("--z", z, (*look.heights)[0], (*look.heights)[1]);
  }
  look.true_scale = true_scale;
  look.curves = surface_curves(curves);
  look.sides = surface_sides(sides);
  if (!colour.empty() && colour != "height") {
    throw Error(fmt::format("--colour {}: expected height", colour));
  }
  look.coloured = !colour.empty();
  if (contours < 0 || contours > kMostContours) {
    throw Error(fmt::format("--contours {}: expected 0 to {}", contours, kMostContours));
  }
  look.contours = contours;
  look.axes = axes;
  look.box = box;
  look.names = names_of_axes(labels);
  if (!labels.empty() && !axes && !look.coloured) {
    throw Error(fmt::format("--labels {}: expected axes or --colour height: nothing else has names",
                            labels));
  }
  if (line_width) {
    look.line_width =
        length_of_option("--line-width", *line_width, pixel_size(drawing, size, output));
  }
  if (text_size) {
    if (!axes && !look.coloured) {
      throw Error(
          fmt::format("--text-size {}: expected axes or --colour height: nothing else has "
                      "letters",
                      *text_size));
    }
    look.letter_height =
        length_of_option("--text-size", *text_size, pixel_size(drawing, size, output)) /
        drawing.height;
  }
  return look;
}

DrawOptions SurfaceCommand::drawing() const {
  DrawOptions drawing;
  drawing.surfaces = hidden_surfaces.options();
  if (!drawing.surfaces.scope) drawing.surfaces.scope = HiddenScope::all;
  drawing.samples = samples;
  drawing.background = background.background();
  drawing.vectors = vectors.options();
  drawing.lettering = vectors.lettering();
  paper.read(drawing, size);
  return drawing;
}

int SurfaceCommand::run() const {
  const GridRange points = range();
  DrawOptions options = drawing();
  const SurfaceLook shown = look(options);
  require_drawable(output, options);
  if (!program.empty()) require_extension(program, ".draw", "a drawing program");
  require_files_of_their_own({output, program}, surfaces);
  const bool in_curves =
      surfaces.size() == 1 && !shown.coloured &&
      options.surfaces.method.value_or(HiddenMethod::perimeter) == HiddenMethod::perimeter;
  const double bytes_of_cell = in_curves ? kBytesOfCurves : kBytesOfOthers;
  std::vector<SurfaceData> data;
  double entered = 0.0;
  if (!grid.empty() && std::ranges::all_of(surfaces, is_grid_file)) {
    throw Error(
        fmt::format("--grid {}: expected an expression: the file sets the number of points", grid));
  }
  for (const std::string& surface : surfaces) {
    if (!is_grid_file(surface)) {
      const auto cells = static_cast<double>(points.points());
      require_memory(entered + cells, surface, bytes_of_cell);
      if (in_curves) hand_out_large_pages(static_cast<std::size_t>(kRoom * cells * kBytesOfCurves));
    }
    data.push_back(read_surface(surface, points));
    entered += static_cast<double>(data.back().range.points());
    require_memory(entered, surface, has_holes(data.back()) ? kBytesOfOthers : bytes_of_cell);
  }
  if (!options.surfaces.method) options.surfaces.method = usual_method(data, shown.coloured);
  if (shown.coloured && finds_lines(*options.surfaces.method)) {
    throw Error(
        fmt::format("--colour height: {} draws lines only, which are not coloured by height: "
                    "expected a method that draws surfaces, such as map or z-buffer",
                    name_of(*options.surfaces.method)));
  }
  GraphicsSystem system;
  system.set_aspect_ratio(static_cast<double>(options.width) / options.height);
  if (surfaces_of(*options.surfaces.method) == HiddenMethod::world_ray_cast) system.retain();
  const auto lines = hidden_surfaces.line_selection();
  std::optional<OutputFile> recorded;
  std::optional<Recorder> recorder;
  if (!program.empty()) {
    recorded.emplace(program);
    recorder.emplace(recorded->stream());
    record_drawing(*recorder, options, lines);
    system.set_recorder(&*recorder);
  }
  // The recorded program has this setting too.
  if (hidden_surfaces.touching) system.set_hidden_surfaces({.touching = *hidden_surfaces.touching});
  if (lines) {
    SystemInside::replace_lines(system, *lines);
  } else if (data.size() > 1 && !needs_surface(*options.surfaces.method)) {
    system.set_hidden_surfaces({.lines = line_selection("all,intersection")});
  }
  {
    const Progress progress("entering surfaces");
    enter_surfaces(system, data, shown);
  }
  if (recorded) recorded->finish();
  Progress progress("drawing " + output);
  options.surfaces.progress = progress.told();
  const Destination to(output);
  const PicturePlan plan = resolve(system, options, &to);
  SortedDisplayFile sorted;
  draw(system, plan, sorted);
  NotInPicture left_out;
  left_out.note(system, plan);
  left_out.warn(output);
  if (recorded) recorded->commit();
  return 0;
}

}  // namespace displayfile
