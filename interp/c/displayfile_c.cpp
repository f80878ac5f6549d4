#include "interp/c/displayfile_c.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/work_budget.h"
#include "displayfile/drawn_pieces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/recorder.h"
#include "displayfile/scene_in_one_view.h"
#include "displayfile/sorted_display_file.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "displayfile/text/user_routine.h"
#include "interp/draw.h"
#include "interp/other_eye.h"
#include "interp/renderer.h"
#include "interp/steps/steps.h"
#include "interp/truth/truth.h"

using namespace displayfile;

struct df_system {
  GraphicsSystem system;
  bool is_new = true;  // no routine was called
  std::ostringstream recorded;
  std::optional<Recorder> recorder;  // if it retains
  std::optional<View> eye;           // that is looked from
  std::optional<OtherEye> other;     // made when it is needed
  Renderer renderer;
  SortedDisplayFile sorted;
  WorkBudget budget;
  std::atomic_flag is_busy;
  std::string error;

  // What was handed out last.
  std::string bytes;
  DrawnPieces pieces;
};

namespace {

static_assert(sizeof(Point3) == 3 * sizeof(double) && sizeof(Colour) == 3 * sizeof(double),
              "rows of them are rows of doubles");

/// Carries a call out, by the budget's limits, while no other thread is in one.
template <class Call>
int carried_out(df_system* system, const WorkLimits& limits, Call&& call) noexcept {
  if (system == nullptr) return DF_ERROR;
  if (system->is_busy.test_and_set(std::memory_order_acquire)) return DF_BUSY;
  int result = DF_ERROR;
  const auto fail = [&](const char* what) noexcept {
    try {
      system->error = what;
    } catch (...) {
      system->error.clear();
    }
  };
  try {
    system->error.clear();
    system->budget.start(limits);
    const BudgetInForce in_force(system->budget);
    call();
    result = DF_OK;
  } catch (const std::bad_alloc&) {
    fail("out of memory");
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail("unknown error");
  }
  system->is_busy.clear(std::memory_order_release);
  return result;
}
template <class Call>
int carried_out(df_system* system, Call&& call) noexcept {
  return carried_out(system, {}, call);
}

/// Carries a call out that tells the system something.
template <class Call>
int told(df_system* system, Call&& call) noexcept {
  return carried_out(system, [&] {
    system->other.reset();
    call();
    system->is_new = false;
  });
}

template <class Pointer>
void require_given(const Pointer* pointer, const char* what) {
  if (pointer == nullptr) throw Error(fmt::format("{}: expected it, not null", what));
}

/// The size that a structure says. That of any version is a multiple of its alignment: no member is
/// cut in two.
template <class Structure>
std::size_t size_said(const Structure* given, const char* name) {
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size >= sizeof size && size % alignof(Structure) == 0) return size;
  throw Error(fmt::format("{}: size {}: expected sizeof({})", name, size, name));
}

/// The structure as this version knows it: members that an earlier caller does not know are 0, and
/// those that a later one knows must be.
template <class Structure>
Structure known(const Structure* given, const char* name) {
  static_assert(std::is_trivially_copyable_v<Structure>);
  Structure result{};
  if (given == nullptr) return result;
  const std::size_t size = size_said(given, name);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  const std::size_t both = std::min(size, sizeof result);
  if (std::any_of(bytes + both, bytes + size, [](unsigned char byte) { return byte != 0; })) {
    throw Error(fmt::format("{}: size {}: it says more than version {} of the library knows", name,
                            size, df_version()));
  }
  std::memcpy(static_cast<void*>(&result), bytes, both);
  return result;
}

/// Hands out as much of a structure as the caller has room for.
template <class Structure>
void hand_out(Structure result, Structure* to, const char* name) {
  require_given(to, name);
  const std::size_t size = size_said(to, name);
  result.size = size;
  std::memcpy(static_cast<void*>(to), &result, std::min(size, sizeof result));
}

std::optional<Background> background_of(const df_options& options) {
  const double* const c = options.background_colour;
  switch (options.background) {
    case DF_BACKGROUND_AS_SET: return std::nullopt;
    case DF_BACKGROUND_SOLID: {
      const Background background{Background::Kind::solid, Colour(c[0], c[1], c[2])};
      GraphicsSystem{}.set_background(background);  // or refuses
      return background;
    }
    case DF_BACKGROUND_NONE: return Background{Background::Kind::none};
    default: break;
  }
  throw Error(fmt::format("background {}: expected DF_BACKGROUND_AS_SET, _SOLID or _NONE",
                          options.background));
}

/// The options in the words of the application API. Of a structure that is known.
DrawOptions draw_options(const df_options& options) {
  DrawOptions result;
  if (options.width != 0) result.width = options.width;
  if (options.height != 0) result.height = options.height;
  if (options.method != nullptr) result.hidden = hidden_method(options.method);
  if (options.scope != nullptr) result.scope = hidden_scope(options.scope);
  if (options.precision != nullptr) result.precision = precision(options.precision);
  if (options.hidden_lines != nullptr) result.hidden_lines = hidden_lines(options.hidden_lines);
  if (options.device != nullptr) result.device = options.device;
  result.background = background_of(options);
  if (options.samples != 0) result.samples = options.samples;
  if (options.threads != 0) result.threads = options.threads;
  if (options.most_pieces != 0) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
    result.most_pieces = static_cast<std::size_t>(std::min(options.most_pieces, kMost));
  }
  if (options.first_row != 0 || options.end_row != 0) {
    result.rows = PictureRows{options.first_row, options.end_row};
  }
  return result;
}

const RetainedScene& retained(const df_system& system) {
  if (system.recorder) return *system.system.retained();
  throw Error("another eye: expected df_retain to be called first");
}

SceneInOneView scene_drawn(const df_system& system) {
  return scene_in_one_view(retained(system), system.system.display_file(), system.system.view());
}

/// A system that retains, seen from where it is looked from.
OtherEye& other_eye(df_system& system) {
  if (!system.other) {
    system.other.emplace(system.system, retained(system), system.recorded.str());
  }
  system.other->set_view(system.eye.value_or(system.other->as_drawn()));
  return *system.other;
}

/// The system as it is looked at.
const GraphicsSystem& looked_at(df_system& system) {
  return system.eye ? other_eye(system).system() : system.system;
}

const Picture& drawn_picture(df_system& system, const DrawOptions& options) {
  if (system.eye && other_eye(system).draws(options)) return other_eye(system).draw(options);
  return system.renderer.draw(looked_at(system), options);
}

Point3 point_of(const double* c) { return {c[0], c[1], c[2]}; }
void hand_out_point(const Point3& from, double* to) { std::copy_n(&from.x, 3, to); }
Rectangle rectangle_of(const double* c) { return {c[0], c[1], c[2], c[3]}; }
void hand_out_rectangle(const Rectangle& r, double* to) {
  std::ranges::copy(std::array{r.x_min, r.x_max, r.y_min, r.y_max}, to);
}

View view_of(const df_view& v) {
  View view;
  view.set_reference_point(point_of(v.reference_point));
  view.set_plane_normal(point_of(v.plane_normal));
  view.set_up(point_of(v.up));
  view.set_distance(v.distance);
  if (v.is_perspective != 0) {
    view.set_perspective(point_of(v.projection));
  } else {
    view.set_parallel(point_of(v.projection));
  }
  view.set_depth(v.depth[0], v.depth[1]);
  view.front_clipping = v.clips_front != 0;
  view.back_clipping = v.clips_back != 0;
  view.set_window(rectangle_of(v.window));
  view.set_viewport(rectangle_of(v.viewport));
  return view;
}

df_view parameters_of(const View& view) {
  df_view v{};
  hand_out_point(view.reference_point, v.reference_point);
  hand_out_point(view.plane_normal, v.plane_normal);
  hand_out_point(view.up, v.up);
  v.distance = view.distance;
  v.is_perspective = view.projection == View::Projection::perspective ? 1 : 0;
  hand_out_point(v.is_perspective ? view.centre_of_projection : view.direction_of_projection,
                 v.projection);
  v.depth[0] = view.front;
  v.depth[1] = view.back;
  v.clips_front = view.front_clipping ? 1 : 0;
  v.clips_back = view.back_clipping ? 1 : 0;
  hand_out_rectangle(view.window, v.window);
  hand_out_rectangle(view.viewport, v.viewport);
  return v;
}

void require_room(std::size_t pixels, const DrawOptions& asked, std::int64_t rows) {
  const std::size_t expected =
      static_cast<std::size_t>(asked.width) * static_cast<std::size_t>(rows);
  if (pixels == expected) return;
  throw Error(
      fmt::format("room for {} pixels: expected {}, {} x {}", pixels, expected, asked.width, rows));
}

/// Calls draw(options) under the limits that they state.
template <class Draw>
int drawn(df_system* system, const df_options* given, Draw&& draw) noexcept {
  WorkLimits limits;
  df_options options{};
  std::string wrong;
  try {
    options = known(given, "df_options");
    if (!(options.most_seconds >= 0.0)) throw Error("most_seconds: expected 0 or more");
    if (options.most_seconds > 0.0) limits.seconds = options.most_seconds;
    if (options.most_comparisons != 0) limits.comparisons = options.most_comparisons;
    if (options.most_bytes != 0) limits.bytes = options.most_bytes;
  } catch (const std::exception& error) {
    return carried_out(system, [&] { throw Error(error.what()); });
  }
  return carried_out(system, limits, [&] { draw(draw_options(options)); });
}

void hand_out_text(const std::string& from, const char** text, std::size_t* length) {
  *text = from.c_str();
  *length = from.size();
}

template <class Value>
std::span<const Value> array(const void* values, std::size_t count, const char* what) {
  if (count > 0) require_given(values, what);
  return {static_cast<const Value*>(values), values == nullptr ? 0 : count};
}

df_pieces arrays_of(const DrawnPieces& p) {
  static_assert(static_cast<int>(DrawnPieces::Kind::solid) == DF_SOLID &&
                static_cast<int>(DrawnPieces::Kind::hollow) == DF_HOLLOW &&
                static_cast<int>(DrawnPieces::Kind::line) == DF_LINE &&
                static_cast<int>(DrawnPieces::Line::solid) == DF_LINE_SOLID &&
                static_cast<int>(DrawnPieces::Line::dashed) == DF_LINE_DASHED &&
                static_cast<int>(DrawnPieces::Line::none) == DF_LINE_NONE);
  return {sizeof(df_pieces),
          p.size(),
          reinterpret_cast<const std::uint8_t*>(p.kinds.data()),
          p.first.data(),
          reinterpret_cast<const double*>(p.points.data()),
          p.sides.data(),
          reinterpret_cast<const double*>(p.fills.data()),
          reinterpret_cast<const double*>(p.line_colours.data()),
          p.line_widths.data(),
          reinterpret_cast<const std::uint8_t*>(p.line_kinds.data()),
          p.picks.data(),
          p.segments.data()};
}

}  // namespace

extern "C" {

const char* df_version(void) { return DISPLAYFILE_VERSION; }

df_system* df_create(void) {
  try {
    return new df_system;
  } catch (...) {
    return nullptr;
  }
}

void df_destroy(df_system* system) { delete system; }

const char* df_error(const df_system* system) {
  return system == nullptr ? "the system: expected it, not null" : system->error.c_str();
}

size_t df_routines(void) { return user_routines().size(); }

// They are string literals, which end with a zero byte.
const char* df_routine_name(size_t routine) {
  return routine < df_routines() ? user_routines()[routine].name.data() : nullptr;
}
const char* df_routine_arguments(size_t routine) {
  return routine < df_routines() ? user_routines()[routine].expected.data() : nullptr;
}
const char* df_routine_meaning(size_t routine) {
  return routine < df_routines() ? user_routines()[routine].meaning.data() : nullptr;
}
const char* df_routine_section(size_t routine) {
  return routine < df_routines() ? user_routines()[routine].section.data() : nullptr;
}

int df_call(df_system* system, const char* routine, const char* arguments) {
  return told(system, [&] {
    require_given(routine, "the routine's name");
    call_user_routine(system->system, routine, arguments == nullptr ? "" : arguments);
  });
}

int df_call_numbers(df_system* system, const char* routine, const double* numbers, size_t count) {
  return told(system, [&] {
    require_given(routine, "the routine's name");
    const auto all = array<double>(numbers, count, "the numbers");
    call_user_routine(system->system, routine, fmt::format("{}", fmt::join(all, " ")));
  });
}

int df_replay(df_system* system, const char* text, size_t length, const char* name) {
  return told(system, [&] {
    const auto all = array<char>(text, length, "the drawing program");
    system->is_new = false;  // what lines did before one that is wrong stays
    replay({all.data(), all.size()}, name == nullptr ? "drawing program" : name, system->system);
  });
}

int df_replay_file(df_system* system, const char* path) {
  return told(system, [&] {
    require_given(path, "the path");
    system->is_new = false;
    replay_file(path, system->system);
  });
}

int df_import_mesh(df_system* system, const char* path) {
  return told(system, [&] {
    require_given(path, "the path");
    import_mesh(path, system->system);
  });
}

int df_set_aspect_ratio(df_system* system, double aspect) {
  return carried_out(system, [&] {
    system->other.reset();
    system->system.set_aspect_ratio(aspect);
  });
}

int df_polygons(df_system* system, const df_mesh* mesh) {
  return told(system, [&] {
    require_given(mesh, "df_mesh");
    const df_mesh m = known(mesh, "df_mesh");
    std::vector<FillStyle> fills;
    for (const Colour& c : array<Colour>(m.colours, m.colour_count, "the colours")) {
      fills.push_back({FillStyle::Kind::solid, c});
    }
    const bool has_sides = m.sides != nullptr;
    system->system.polygons_abs_3(
        {array<Point3>(m.vertices, m.vertex_count, "the vertices"),
         array<std::uint32_t>(m.corners, m.corner_count, "the corners"),
         array<std::uint32_t>(m.sides, has_sides ? m.polygon_count : 0, "the sides"), fills,
         array<std::int32_t>(m.picks, m.pick_count, "the pick identifiers"),
         array<Point3>(m.normals, m.normal_count, "the normals")});
  });
}

int df_draw(df_system* system, const df_options* options, size_t pixels, uint8_t* rgba,
            int32_t* ids, double* depth) {
  return drawn(system, options, [&](DrawOptions asked) {
    require_given(rgba, "the pixels' memory");
    const std::int64_t rows =
        asked.rows ? std::int64_t{asked.rows->end} - asked.rows->first : asked.height;
    require_room(pixels, asked, rows);
    asked.with_ids = ids != nullptr;
    asked.with_depth = depth != nullptr;
    const Picture& picture = drawn_picture(*system, asked);
    for (const std::uint32_t pixel : picture.pixels) {
      const std::uint32_t bytes = in_bytes(pixel);
      std::memcpy(rgba, &bytes, sizeof bytes);
      rgba += sizeof bytes;
    }
    if (ids != nullptr) std::ranges::copy(picture.ids, ids);
    if (depth != nullptr) std::ranges::copy(picture.depth, depth);
  });
}

int df_draw_as(df_system* system, const df_options* options, const char* format, const char** bytes,
               size_t* length) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(format, "the format");
    require_given(bytes, "where the bytes go");
    require_given(length, "where the length goes");
    system->bytes = draw_as(looked_at(*system), format, asked);
    hand_out_text(system->bytes, bytes, length);
  });
}

int df_draw_file(df_system* system, const df_options* options, const char* path) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(path, "the path");
    system->renderer.draw(looked_at(*system), path, asked);
  });
}

int df_dump(df_system* system, const char** text, size_t* length) {
  return carried_out(system, [&] {
    require_given(text, "where the text goes");
    require_given(length, "where the length goes");
    system->bytes = dump(looked_at(*system).display_file());
    hand_out_text(system->bytes, text, length);
  });
}

int df_drawn_pieces(df_system* system, const df_options* options, df_pieces* pieces) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(pieces, "df_pieces");
    const GraphicsSystem& from = looked_at(*system);
    const HiddenMethod method = drawing_method(from, asked, PictureKind::vector);
    system->pieces =
        drawn_pieces(system->sorted.update(from, method, hidden_surface_options(asked)));
    hand_out(arrays_of(system->pieces), pieces, "df_pieces");
  });
}

int df_pick(df_system* system, const df_options* options, double x, double y, double reach,
            df_seen* seen) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(seen, "df_seen");
    const auto pick = system->renderer.pick(looked_at(*system), x, y, asked, reach);
    df_seen result{};
    if (pick) {
      result.is_seen = 1;
      result.kind = pick->kind == Pick::Kind::polygon ? DF_SEEN_POLYGON
                    : pick->kind == Pick::Kind::edge  ? DF_SEEN_EDGE
                                                      : DF_SEEN_LINE;
      result.pick = pick->id;
      result.segment = pick->segment;
      result.depth = pick->depth;
    }
    hand_out(result, seen, "df_seen");
  });
}

int df_truth(df_system* system, const df_options* options, size_t pixels, int32_t* ids,
             double* depth) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(ids, "the item buffer's memory");
    require_room(pixels, asked, asked.height);
    const Picture picture =
        truth(looked_at(*system).display_file(), asked.width, asked.height, depth != nullptr);
    std::ranges::copy(picture.ids, ids);
    if (depth != nullptr) std::ranges::copy(picture.depth, depth);
  });
}

int df_steps(df_system* system, const df_options* options, size_t most_steps, const char** text,
             size_t* length) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    require_given(text, "where the text goes");
    require_given(length, "where the length goes");
    StepsOptions steps;
    if (!asked.hidden) throw Error("method: expected one that tells its steps");
    steps.method = *asked.hidden;
    steps.width = asked.width;
    steps.height = asked.height;
    if (most_steps != 0) steps.most_steps = most_steps;
    system->bytes = steps_as_json(looked_at(*system), steps);
    hand_out_text(system->bytes, text, length);
  });
}

int df_retain(df_system* system) {
  return carried_out(system, [&] {
    if (system->recorder) return;
    if (!system->is_new) {
      throw Error("a routine was called already: expected df_retain before all of them");
    }
    system->system.retain();
    system->recorder.emplace(system->recorded);
    system->system.set_recorder(&*system->recorder);
  });
}

int df_drawn_view(df_system* system, df_view* view) {
  return carried_out(system,
                     [&] { hand_out(parameters_of(scene_drawn(*system).view), view, "df_view"); });
}

int df_box(df_system* system, double box[6]) {
  return carried_out(system, [&] {
    require_given(box, "the box");
    const Bounds bounds = scene_drawn(*system).bounds;
    if (bounds.empty()) throw Error("nothing is visible: expected a box around something");
    hand_out_point(bounds.low, box);
    hand_out_point(bounds.high, box + 3);
  });
}

int df_look_from(df_system* system, const df_view* view) {
  return carried_out(system, [&] {
    if (view == nullptr) {
      system->eye.reset();
      return;
    }
    retained(*system);
    const auto before = std::exchange(system->eye, view_of(known(view, "df_view")));
    try {
      other_eye(*system);
    } catch (...) {
      system->eye = before;
      throw;
    }
  });
}

int df_program(df_system* system, const char** text, size_t* length) {
  return carried_out(system, [&] {
    require_given(text, "where the text goes");
    require_given(length, "where the length goes");
    retained(*system);
    system->bytes = system->eye ? other_eye(*system).program() : system->recorded.str();
    hand_out_text(system->bytes, text, length);
  });
}

void df_stop(df_system* system) {
  if (system != nullptr) system->budget.stop();
}

}  // extern "C"
