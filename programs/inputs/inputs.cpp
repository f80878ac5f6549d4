#include "programs/inputs/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/system/process_memory.h"
#include "clip/view/view_volume.h"
#include "displayfile/looks/style.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/hidden_lines_left.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_checks.h"
#include "programs/inputs/exploded_parts.h"
#include "programs/inputs/mistaken_words.h"
#include "programs/inputs/planes_of_inputs.h"
#include "programs/inputs/segment_names.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

bool is_drawing_program(const std::string& input) {
  return input == "-" || extension_of(input) == ".draw";
}

void report_skipped(std::span<const std::string> meshes, std::span<const Mesh::Skipped> skipped) {
  for (std::size_t i = 0; i < skipped.size(); ++i) {
    if (const auto kinds = left_out(skipped[i]); !kinds.empty()) {
      warnings() << fmt::format("{}: left out: {}\n", meshes[i], fmt::join(kinds, ", "));
    }
    for (const std::string& warning : skipped[i].warnings) {
      warnings() << fmt::format("{}: {}\n", meshes[i], warning);
    }
  }
}

namespace {

/// Inputs as read, and the properties of the meshes that are known before any of them is entered.
struct InputsRead {
  std::vector<std::string> programs;  // their texts
  std::vector<Mesh> meshes;
  /// World coordinates of meshes before which no program sets the window, and of the programs'
  /// drawings in the same view.
  std::vector<Point3> bare;
  CameraAsSet before{};   ///< before the first of them
  CommonUpright upright;  ///< of those meshes
};

/// True if they differ in no more than the window, which may be widened.
bool differ_in_window_alone(View one, const View& other) {
  one.window = other.window;
  return one == other;
}

/// Adds the visible points that programs drew in the view.
void append_drawn(const View& view, const RetainedScene& retained, const GraphicsSystem& system,
                  std::vector<Point3>& points) {
  const RetainedScene drawn = retained.visible_in(system.display_file());
  for (const RetainedScene::Segment& segment : drawn.segments()) {
    if (!differ_in_window_alone(segment.view, view)) continue;
    const auto of_segment = drawn.points(segment);
    points.insert(points.end(), of_segment.begin(), of_segment.end());
    for (const RetainedScene::Text& text : drawn.texts(segment)) points.push_back(text.anchor);
    for (const KeptAnnotation& annotation : segment.annotations) {
      points.insert(points.end(), annotation.points.begin(), annotation.points.end());
    }
  }
}

/// Replays up to the first error, which is reported when the program is replayed among the others.
void replay_ahead(const std::string& program, const std::string& name, GraphicsSystem& ahead) {
  const std::size_t saved = ahead.counts().transformations_saved;
  try {
    replay_beside(program, name, ahead);
  } catch (const LimitReached&) {
    throw;
  } catch (const Error&) {
    while (ahead.counts().solids_open > 0) ahead.discard_solid();
    ahead.set_hidden_surfaces({.removal = false});
    if (ahead.open_segment_name()) ahead.close_segment();
    while (ahead.counts().transformations_saved > saved) ahead.restore_transformation_3();
  }
}

/// True for meshes that follow such settings: no window is set, or a camera stands beside it.
bool takes_fitted_view(const CameraAsSet& set) {
  if (!set.settings.contains(Setting::window)) return true;
  return set.camera_beside_window && !set.settings.contains(Setting::camera);
}

/// A mesh's segments, for the programs that follow and may name them.
void enter_ahead(const Mesh& mesh, GraphicsSystem& ahead) {
  try {
    enter_empty_segments(mesh, ahead);
  } catch (const Error&) {  // which is reported when the mesh is entered
  }
}

/// The vertices of a mesh whose segments were opened last, in world coordinates, moved and cut as
/// they are.
void append_placed_vertices(const Mesh& mesh, const GraphicsSystem& ahead,
                            std::vector<Point3>& world) {
  const std::vector<Point3>& places = SystemInside::places(ahead);
  if (places.empty()) return append_vertices_left(mesh, ahead, world);
  ModellingTransformation placed = ahead.modelling_transformation();
  std::size_t opened = SystemInside::segments_opened(ahead) - mesh.objects.size();
  for (const Mesh::Object& object : mesh.objects) {
    placed.place(opened < places.size() ? places[opened] : Point3(0.0));
    ++opened;
    append_corners_left(mesh, object, placed, SystemInside::cutting_planes(ahead), world);
  }
}

/// In files.
std::size_t bytes_of_meshes(std::span<const std::string> inputs) {
  constexpr std::uintmax_t kMost = std::uintmax_t{1} << 32;
  std::uintmax_t bytes = 0;
  for (const std::string& input : inputs) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(input, unknown);
    if (!is_drawing_program(input) && !unknown) bytes += std::min(size, kMost);
  }
  return static_cast<std::size_t>(std::min(bytes, kMost));
}
/// Replays the programs in advance, beside the system: the view that is fitted to the meshes, where
/// the programs place them, includes the programs' drawings.
InputsRead read_inputs(std::span<const std::string> inputs, const GraphicsSystem& system,
                       const MeshOptions& options) {
  ask_for_memory(2 * bytes_of_meshes(inputs));  // a mesh's text and its data are larger
  InputsRead read{{}, {}, {}, {}, CommonUpright(options.camera)};
  Camera of_options = options.camera;
  of_options.turning = false;
  const bool has_camera = of_options != Camera{};  // by options
  RetainedScene drawn;
  GraphicsSystem ahead;
  ahead.retain(&drawn);
  SystemInside::place_segments(ahead, SystemInside::places(system));
  ahead.set_shading(system.looks().attributes.shading);
  const bool crease_is_set = system.explicit_settings().contains(Setting::crease_angle);
  const auto set_crease = [&] { ahead.set_crease_angle(system.looks().crease_degrees); };
  crease_is_set ? set_crease() : SystemInside::by_default(ahead, Setting::crease_angle, set_crease);
  bool any_smooth = false, any_bare = false;
  std::vector<Point3> cut_away;  // of meshes, as long as the planes leave nothing
  for (const std::string& input : inputs) {
    const Progress progress("reading " + input);
    if (is_drawing_program(input)) {
      read.programs.push_back(read_text_file(input));
      replay_ahead(read.programs.back(), input_name(input), ahead);
      continue;
    }
    const bool smooth = ahead.looks().attributes.shading != Shading::flat;
    any_smooth = any_smooth || smooth;
    const NamedWarnings named(input);
    Mesh& mesh = read.meshes.emplace_back(read_mesh(input, smooth, options.import_limits));
    if (smooth) complete_normals(mesh, ahead);
    enter_ahead(mesh, ahead);
    const GraphicsSystem& before = system.explicit_settings().contains_view() ? system : ahead;
    const CameraAsSet as_set{before.view(), before.explicit_settings(), has_camera};
    if (!takes_fitted_view(as_set)) continue;
    if (!any_bare) read.before = as_set;
    any_bare = true;
    append_placed_vertices(mesh, ahead, read.bare);
    if (read.bare.empty()) append_used_vertices(mesh, ahead.modelling_transformation(), cut_away);
    read.upright.add(mesh, ahead.modelling_transformation());
  }
  if (read.bare.empty()) read.bare = std::move(cut_away);
  if (crease_is_set && !read.meshes.empty() && !any_smooth) {
    read.meshes.front().skipped.warnings.emplace_back(
        "--crease has no effect: shading is flat where meshes are entered");
  }
  if (read.upright.differ()) {
    read.meshes.front().skipped.warnings.emplace_back(kStandDifferently);
  }
  if (!read.bare.empty()) append_drawn(read.before.view, drawn, ahead, read.bare);
  return read;
}

/// The positions of axes depend on the view: first one is fitted to the points known so far. Adds
/// the programs' drawings in that view if they have axes.
void append_axes(std::span<const std::string> inputs, const GraphicsSystem& system,
                 InputsRead& read) {
  const auto has_axes = [](const std::string& program) {
    return program.find("axes-3") != std::string::npos;
  };
  if (std::ranges::none_of(read.programs, has_axes)) return;
  RetainedScene drawn;
  GraphicsSystem fitted;
  fitted.retain(&drawn);
  SystemInside::place_segments(fitted, SystemInside::places(system));
  fitted.set_aspect_ratio(system.aspect_ratio());
  SystemInside::set_scale(fitted, SystemInside::scale(system));
  fit_view(read.bare, fitted, read.upright.camera(), read.before);
  View shared = fitted.view();
  bool is_before_meshes = true;
  auto program = read.programs.begin();
  auto mesh = read.meshes.begin();
  for (const std::string& input : inputs) {
    is_before_meshes = is_before_meshes && is_drawing_program(input);
    if (!is_drawing_program(input)) {
      enter_ahead(*mesh++, fitted);
      continue;
    }
    replay_ahead(*program++, input_name(input), fitted);
    if (is_before_meshes) shared = fitted.view();
  }
  append_drawn(shared, drawn, fitted, read.bare);
}

/// Notes, once per call of the command, that an STL file, which does not state its up axis, has set
/// the picture's up axis.
void note_up_axis_of_stl(std::span<const std::string> inputs, const InputsRead& read,
                         const Camera& camera) {
  const auto is_stl = [](const std::string& input) { return extension_of(input) == ".stl"; };
  const auto* const by = std::get_if<UprightBy>(&camera.upright);
  const bool is_set = by == nullptr || *by != UprightBy::file ||  // by --up, or by a program
                      read.before.settings.contains(Setting::camera);
  if (is_set || read.upright.upright() == Upright{}) return;
  const auto stl = std::ranges::find_if(inputs, is_stl);
  static std::atomic<bool> is_noted = false;
  if (stl == inputs.end() || is_noted.exchange(true)) return;
  warnings() << fmt::format("{}: STL has z up: --up sets another axis\n", *stl);
}

/// While it lives, progress of close-segment is reported to a Progress.
class ToldOfClosing {
 public:
  ToldOfClosing(GraphicsSystem& system, Progress& progress) : system_(system) {
    system.set_progress(progress.told());
  }
  ~ToldOfClosing() { system_.set_progress({}); }
  ToldOfClosing(const ToldOfClosing&) = delete;
  ToldOfClosing& operator=(const ToldOfClosing&) = delete;

 private:
  GraphicsSystem& system_;
};

/// The meshes' lines, if there is a selection of them, hold where none is set, and for these
/// meshes alone.
void enter_meshes_with_lines(std::span<const Mesh> meshes, GraphicsSystem& system,
                             const MeshOptions& options,
                             const std::optional<LineSelection>& lines) {
  if (!lines) return enter_meshes(meshes, system, options);
  const LineSelection before = system.hidden_surfaces().lines;
  SystemInside::by_default(system, Setting::lines,
                           [&] { system.set_hidden_surfaces({.lines = *lines}); });
  enter_meshes(meshes, system, options);
  SystemInside::by_default(system, Setting::lines,
                           [&] { system.set_hidden_surfaces({.lines = before}); });
}

constexpr const char* kNothingToFit =
    "--fit all: expected a mesh before which no program sets the window";

/// Sets the view common to all pictures. Throws Error unless this one's programs set the same
/// before the meshes as those of the others.
void set_view_of_all(const ViewOfAll& all, const CameraAsSet& before, GraphicsSystem& system) {
  if (!(before == all.before)) {
    throw Error(
        "--fit all: programs before this mesh set another view than those of other pictures: "
        "expected one for all");
  }
  set_fitted_view(all.view, system, before);
}

/// The part of the view's window that the points take.
Rectangle shown_in_window(const View& view, std::span<const Point3> points) {
  const ViewVolume volume(view);
  Rectangle in_volume = Rectangle::nothing();
  for (const Point3& point : points) {
    const HomogeneousPoint p = volume.transform(point);
    in_volume.include({p.x / p.w, p.y / p.w});
  }
  const auto& [x_min, x_max, y_min, y_max] = view.window;
  return {x_min + in_volume.x_min * (x_max - x_min), x_min + in_volume.x_max * (x_max - x_min),
          y_min + in_volume.y_min * (y_max - y_min), y_min + in_volume.y_max * (y_max - y_min)};
}

/// Sets the window that shows all that the programs draw in their one view, as a default.
void fit_window(std::span<const std::string> programs, std::span<const std::string> inputs,
                GraphicsSystem& system) {
  RetainedScene drawn;
  GraphicsSystem ahead;
  ahead.retain(&drawn);
  SystemInside::place_segments(ahead, SystemInside::places(system));
  ahead.set_aspect_ratio(system.aspect_ratio());
  for (std::size_t k = 0; k < programs.size(); ++k) {
    replay_ahead(programs[k], input_name(inputs[k]), ahead);
    if (!ahead.explicit_settings().contains(Setting::window)) continue;
    throw Error(
        fmt::format("{}: sets a window: expected none with --fit each", input_name(inputs[k])));
  }
  const View& view = ahead.view();
  const bool has_one_view =
      std::ranges::all_of(drawn.segments(), [&](const RetainedScene::Segment& segment) {
        return differ_in_window_alone(segment.view, view);
      });
  if (!has_one_view) {
    throw Error(fmt::format("{}: has several views: expected one with --fit each",
                            input_name(inputs.front())));
  }
  std::vector<Point3> points;
  append_drawn(view, drawn, ahead, points);
  if (points.empty()) return;
  const View fitted = fit(view, points, system.aspect_ratio());
  Rectangle window = fitted.window;
  if (SystemInside::scale(system)) {  // then only visible points have to fit
    const Rectangle shown = shown_in_window(fitted, points);
    if (shown.x_min < shown.x_max && shown.y_min < shown.y_max) window = shown;
  }
  SystemInside::by_default(system, Setting::window, [&] {
    system.set_window(window.x_min, window.x_max, window.y_min, window.y_max);
  });
}

void replay_each(std::span<const std::string> inputs, GraphicsSystem& system, bool fitted,
                 PlanesOfInputs& planes) {
  std::vector<std::string> programs;
  if (fitted) {
    for (const std::string& input : inputs) programs.push_back(read_text_file(input));
    fit_window(programs, inputs, system);
  }
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    Progress progress("replaying " + inputs[k]);
    const ToldOfClosing told(system, progress);
    replay_beside(fitted ? programs[k] : read_text_file(inputs[k]), input_name(inputs[k]), system);
    planes.entered(k, system);
  }
}

/// Cut faces are closed on closed objects alone.
void warn_of_cut_meshes_left_open(const std::string& input, const Mesh& mesh,
                                  const GraphicsSystem& system) {
  const std::size_t open = objects_cut_open(mesh, system);
  if (open == 0) return;
  const std::size_t all = mesh.objects.size();
  warnings() << fmt::format("{}: set-cut-faces {} has no effect{}: not closed\n", input,
                            name_of(system.looks().cut_faces.kind),
                            all == 1 ? "" : fmt::format(" on {} of {} objects", open, all));
}

std::optional<Upright> enter_each(std::span<const std::string> inputs, GraphicsSystem& system,
                                  const MeshOptions& options,
                                  const std::optional<LineSelection>& lines_of_meshes,
                                  const ViewOfAll* together, bool fit_programs,
                                  PlanesOfInputs& planes) {
  if (std::ranges::all_of(inputs, is_drawing_program)) {
    if (together != nullptr) throw Error(kNothingToFit);
    replay_each(inputs, system, fit_programs, planes);
    return std::nullopt;
  }
  InputsRead read = read_inputs(inputs, system, options);
  const std::string& first_mesh = *std::ranges::find_if_not(inputs, is_drawing_program);
  naming_mesh(first_mesh, [&] {
    if (together != nullptr && read.bare.empty()) throw Error(kNothingToFit);
    if (read.bare.empty()) return;
    if (together != nullptr) return set_view_of_all(*together, read.before, system);
    append_axes(inputs, system, read);
    fit_view(read.bare, system, read.upright.camera(), read.before);
  });
  if (!read.bare.empty()) note_up_axis_of_stl(inputs, read, options.camera);
  Progress progress("entering " + inputs.front() + (inputs.size() > 1 ? " and others" : ""));
  const ToldOfClosing told(system, progress);
  auto program = read.programs.begin();
  std::span<const Mesh> meshes = read.meshes;
  for (std::size_t i = 0; i < inputs.size();) {
    if (is_drawing_program(inputs[i])) {
      replay_beside(*program++, input_name(inputs[i]), system);
      planes.entered(i++, system);
      continue;
    }
    const std::size_t begin = i;
    while (i < inputs.size() && !is_drawing_program(inputs[i])) ++i;
    naming_mesh(inputs[begin], [&] {
      enter_meshes_with_lines(meshes.first(i - begin), system, options, lines_of_meshes);
    });
    planes.entered(i - 1, system);
    for (std::size_t k = begin; k < i; ++k) {
      warn_of_cut_meshes_left_open(inputs[k], meshes[k - begin], system);
      report_skipped(inputs.subspan(k, 1), std::span(&meshes[k - begin].skipped, 1));
    }
    meshes = meshes.subspan(i - begin);
  }
  if (read.bare.empty() || read.before.settings.contains(Setting::camera)) return std::nullopt;
  return together != nullptr ? together->upright : read.upright.upright();
}

/// The style that --lines sets for hatching has no effect if no cut face is hatched.
void warn_of_style_of_no_hatching(std::span<const std::string> inputs, const GraphicsSystem& system,
                                  const MeshWords& meshes) {
  const auto is_of_hatching = [](const StyleOfKind& of) { return of.lines == StyledLines::hatch; };
  if (system.counts().has_hatching || std::ranges::none_of(meshes.line_styles, is_of_hatching)) {
    return;
  }
  warnings() << fmt::format(
      "{}: --lines hatch= has no effect: no cut face is hatched: expected set-cut-faces hatched "
      "and a cutting plane before what is cut\n",
      inputs.back());
}

std::optional<Upright> enter_all(std::span<const std::string> inputs, GraphicsSystem& system,
                                 const MeshOptions& options,
                                 const std::optional<LineSelection>& lines_of_meshes,
                                 const ViewOfAll* together, bool fit_programs) {
  for (const std::string& input : inputs) require_no_folder_or_pattern(input);
  const std::int64_t empty_before = system.counts().empty_solids;
  PlanesOfInputs planes;
  const std::optional<Upright> upright =
      enter_each(inputs, system, options, lines_of_meshes, together, fit_programs, planes);
  planes.warn(inputs, system);
  if (const std::int64_t empty = system.counts().empty_solids - empty_before; empty > 0) {
    warnings() << fmt::format("{}: nothing is left of {} combined solid{}\n", inputs.front(), empty,
                              empty == 1 ? "" : "s");
  }
  return upright;
}

}  // namespace

std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshOptions& options) {
  return enter_all(inputs, system, options, std::nullopt, nullptr, false);
}

std::optional<Upright> enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system,
                                    const MeshWords& meshes, double aspect,
                                    const HiddenSurfaceOptions& asked) {
  MeshOptions options = meshes.options();
  options.sides_drawn =
      meshes.lines || meshes.lines_of_meshes || (asked.method && shows_lines_only(*asked.method));
  options.hidden_sides_drawn = asked.hidden_lines == HiddenLines::dashed;
  if (options.colour && std::ranges::all_of(inputs, is_drawing_program)) {
    throw Error("--colour: expected a mesh among the inputs");
  }
  meshes.start(system, aspect);
  std::optional<ExplodedParts> exploded;
  if (meshes.explosion) {
    exploded = exploded_parts(inputs, *meshes.explosion, options.import_limits, aspect);
    SystemInside::place_segments(system, exploded->places);
    if (!exploded->cut_off.empty()) {
      warnings() << fmt::format(
          "{}: --explode {} moves segments out of the view that is set: {}: expected a larger "
          "window or view depth\n",
          inputs.front(), meshes.explosion->word, fmt::join(exploded->cut_off, ", "));
    }
  }
  const std::optional<Upright> fitted = enter_all(inputs, system, options, meshes.lines_of_meshes,
                                                  meshes.together.get(), meshes.fits_each());
  warn_of_style_of_no_hatching(inputs, system, meshes);
  constexpr double kTraceOfWidth = 0.5;
  if (exploded) SystemInside::enter_segment_of_lines(system, exploded->traces, kTraceOfWidth);
  meshes.require_fitted(fitted.has_value());
  return fitted;
}

namespace {

/// The points of some pictures' inputs to which a view is fitted.
struct PointsOfAll {
  std::vector<Point3> points;
  std::optional<CameraAsSet> before;  ///< of the first picture
  std::optional<Upright> upright;     ///< y, where pictures differ
  bool differ = false;

  void add(const InputsRead& read) {
    if (read.bare.empty()) return;
    points.insert(points.end(), read.bare.begin(), read.bare.end());
    if (!before) before = read.before;
    const Upright own = read.upright.upright();
    differ = differ || (upright && *upright != own);
    upright = differ ? Upright{} : own;
  }
};

}  // namespace

std::shared_ptr<const ViewOfAll> fit_to_all(std::span<const std::vector<std::string>> pictures,
                                            const MeshOptions& options,
                                            const std::function<void(GraphicsSystem&)>& start) {
  PointsOfAll all;
  std::ostringstream said_when_entered;
  for (const std::vector<std::string>& inputs : pictures) {
    if (std::ranges::find(inputs, "-") != inputs.end()) {
      throw Error("--fit all: inputs are read twice: expected files, not standard input");
    }
    if (std::ranges::all_of(inputs, is_drawing_program)) continue;
    const CollectedWarnings collected(said_when_entered);
    try {
      GraphicsSystem system;
      start(system);
      InputsRead read = read_inputs(inputs, system, options);
      if (!read.bare.empty()) append_axes(inputs, system, read);
      all.add(read);
    } catch (const LimitReached&) {
      throw;
    } catch (const Error&) {  // which is reported when the picture's inputs are entered
    }
  }
  if (!all.before) throw Error(kNothingToFit);
  if (all.differ) warnings() << "--fit all: " << kStandDifferently << '\n';
  Camera camera = options.camera;
  camera.upright = *all.upright;
  GraphicsSystem system;
  start(system);
  const auto view = fitted_view(all.points, system, camera, *all.before);
  if (!view) throw Error("--fit all --no-fit: expected one of them");
  return std::make_shared<const ViewOfAll>(ViewOfAll{*all.before, *view, *all.upright});
}

DrawnFile as_drawn(std::span<const std::string> inputs, const HiddenSurfaceOptions& options,
                   const MeshWords& meshes, double aspect) {
  GraphicsSystem system;
  system.set_threads(options.threads);
  enter_inputs(inputs, system, meshes, aspect, options);
  SurfacePlan plan = resolve_surfaces(system, options);
  const HiddenMethod method = plan.method;
  require_hidden_lines_found(plan.hidden_lines, method);
  Progress progress(
      fmt::format("hidden surfaces of {} polygons", system.display_file().polygons()));
  plan.progress = progress.told();
  DrawnFile drawn{SortedDisplayFile{}.update(system, options, plan, unsorted_if_automatic(method)),
                  std::nullopt};
  require_hidden_lines_dumped(drawn.file, method, options);
  if (!options.hidden_lines && plan.hidden_lines == HiddenLines::dashed &&
      leaves_hidden_lines(drawn.file, true, options.threads)) {
    warnings() << fmt::format("{}: left out: set-hidden-lines dashed: {}\n",
                              input_name(inputs.front()), words_of_hidden_lines_left(method));
  }
  for (const std::string& text :
       options_without_effect(options, plan, method, drawn.file, FoundBy::nobody)) {
    warnings() << fmt::format("{}: {}\n", input_name(inputs.front()), text);
  }
  if (!is_colour_rule(method)) return drawn;
  require_colour_of_fills(method, system.looks().background);
  drawn.fills = system.looks().background.colour;
  return drawn;
}

}  // namespace displayfile
