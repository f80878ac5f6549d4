#include "interp/c/displayfile_c.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/work_budget.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/hidden_lines_left.h"
#include "interp/c/system.h"
#include "interp/device/output_device.h"
#include "interp/displayfile.h"
#include "interp/draw/draw.h"
#include "interp/steps/steps.h"
#include "interp/truth/truth.h"

using namespace displayfile;
using namespace displayfile::c;

constinit thread_local const df_system* displayfile::c::was_busy = nullptr;

namespace {

static_assert(sizeof(Point3) == 3 * sizeof(double) && sizeof(Colour) == 3 * sizeof(double),
              "rows of them are rows of doubles");
constexpr std::array kVersionOfHeader{DF_VERSION_MAJOR, DF_VERSION_MINOR, DF_VERSION_PATCH};
constexpr std::array kVersion{DISPLAYFILE_VERSION_MAJOR, DISPLAYFILE_VERSION_MINOR,
                              DISPLAYFILE_VERSION_PATCH};
static_assert(kVersionOfHeader == kVersion,
              "the version of the C header is that of interp/displayfile.h");

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

/// Converts the options of a structure of a known version to the application API's.
DrawOptions draw_options(const df_options& options) {
  DrawOptions result;
  if (options.width != 0) result.width = options.width;
  if (options.height != 0) result.height = options.height;
  if (options.method != nullptr) result.surfaces.method = hidden_method(options.method);
  if (options.scope != nullptr) result.surfaces.scope = hidden_scope(options.scope);
  if (options.precision != nullptr) result.surfaces.precision = precision(options.precision);
  if (options.hidden_lines != nullptr)
    result.surfaces.hidden_lines = hidden_lines(options.hidden_lines);
  if (options.line_order != nullptr) result.surfaces.line_order = line_order(options.line_order);
  if (options.line_halo != 0.0) result.surfaces.line_halo = options.line_halo;
  if (options.font != nullptr || options.text != nullptr) {
    const auto word = [](const char* text) {
      return text == nullptr ? std::nullopt : std::optional<std::string_view>(text);
    };
    result.lettering = lettering_of(word(options.font), word(options.text));
  }
  if (options.device != nullptr) result.device = options.device;
  result.background = background_of(options);
  if (options.samples != 0) result.samples = options.samples;
  if (options.threads != 0) result.surfaces.threads = options.threads;
  if (options.most_pieces != 0) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
    result.surfaces.most_pieces = static_cast<std::size_t>(std::min(options.most_pieces, kMost));
  }
  if (options.first_row != 0 || options.end_row != 0) {
    result.rows = PictureRows{options.first_row, options.end_row};
  }
  return result;
}

const Picture& drawn_picture(df_system& system, const DrawOptions& options) {
  OtherEye* const eye = eye_in_force(system);
  if (eye != nullptr && eye->draws(options)) return eye->draw(options);
  return system.renderer.draw(looked_at(system), options);
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

template <class Value>
std::span<const Value> array(const void* values, std::size_t count, const char* what) {
  if (count > 0) require_given(values, what);
  return {static_cast<const Value*>(values), values == nullptr ? 0 : count};
}

/// An array of a mesh, or null for none. An empty array that is not null is an error if the mesh
/// has corners.
template <class Value>
std::span<const Value> array_or_null(const void* values, std::size_t count, const df_mesh& mesh,
                                     const char* what) {
  if (values != nullptr && count == 0 && mesh.corner_count > 0) {
    throw Error(fmt::format("{}: an empty array: expected null for none", what));
  }
  return array<Value>(values, count, what);
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
          p.segments.data(),
          p.cuts.data()};
}

}  // namespace

extern "C" {

const char* df_version(void) { return DISPLAYFILE_VERSION; }

df_system* df_create(void) {
  try {
    auto* const system = new df_system;
    if (was_busy == system) was_busy = nullptr;  // that was another one in the same place
    return system;
  } catch (...) {
    return nullptr;
  }
}

void df_destroy(df_system* system) { delete system; }

const char* df_error(const df_system* system) {
  if (system == nullptr) return "the system: expected it, not null";
  if (system == was_busy) return "busy: another thread's call on the system is in progress";
  return system->error.c_str();
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
    const char* const file = path_given(path);
    system->is_new = false;
    replay_file(file, system->system);
  });
}

int df_import_mesh(df_system* system, const char* path) {
  return told(system, [&] { import_mesh(path_given(path), system->system); });
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
    for (const Colour& c : array_or_null<Colour>(m.colours, m.colour_count, m, "the colours")) {
      fills.push_back({FillStyle::Kind::solid, c});
    }
    const bool has_sides = m.sides != nullptr;
    system->system.polygons_abs_3(
        {array<Point3>(m.vertices, m.vertex_count, "the vertices"),
         array<std::uint32_t>(m.corners, m.corner_count, "the corners"),
         array_or_null<std::uint32_t>(m.sides, has_sides ? m.polygon_count : 0, m, "the sides"),
         fills, array_or_null<std::int32_t>(m.picks, m.pick_count, m, "the pick identifiers"),
         array_or_null<Point3>(m.normals, m.normal_count, m, "the normals")});
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
    require_given(bytes, "the pointer to the bytes");
    require_given(length, "where the length goes");
    system->bytes = draw_as(looked_at(*system), format, asked);
    hand_out_text(system->bytes, bytes, length);
  });
}

int df_draw_file(df_system* system, const df_options* options, const char* path) {
  return drawn(system, options, [&](const DrawOptions& asked) {
    system->renderer.draw(looked_at(*system), path_given(path), asked);
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
    system->pieces = drawn_pieces(looked_at(*system), asked, system->sorted);
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
    if (!asked.surfaces.method) throw Error("method: expected one with steps");
    steps.method = *asked.surfaces.method;
    steps.width = asked.width;
    steps.height = asked.height;
    if (most_steps != 0) steps.most_steps = most_steps;
    system->bytes = steps_as_json(looked_at(*system), steps);
    hand_out_text(system->bytes, text, length);
  });
}

void df_stop(df_system* system) {
  if (system != nullptr) system->budget.stop();
}

}  // extern "C"
