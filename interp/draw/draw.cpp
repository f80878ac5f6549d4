#include "interp/draw.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "clip/error.h"
#include "clip/memory.h"
#include "clip/work_budget.h"
#include "displayfile/collected_text.h"
#include "displayfile/hidden_lines_left.h"
#include "displayfile/hidden_surface_check.h"
#include "interp/drawing_choice.h"
#include "interp/picture_checks.h"
#include "interp/picture_source.h"
#include "interp/raster/software.h"
#include "interp/renderer.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/picker.h"
#include "interp/visibility/world_rays.h"

namespace displayfile {

namespace {

constexpr WorkDone kDrawing{
    "the drawing",
    "for pixels a smaller picture or hidden-surface method z-buffer, scan-line-z in little memory"};

/// The request for what is drawn in the order that the display file has.
RasterRequest raster_request(const DisplayFile& file, const DrawOptions& options) {
  RasterRequest request = raster_request(options);
  request.sorted = has_exact_order(file);
  if (options.hidden && is_colour_rule(*options.hidden)) {
    request.method = colour_rule_by(HiddenMethod::none);
  }
  return request;
}

/// The display file has been brought up to date for the picture.
RasterRequest raster_request(const GraphicsSystem& system, const DisplayFile& file,
                             const DrawOptions& options) {
  RasterRequest request = raster_request(file, options);
  request.method = method_in_force(system, hidden_surface_options(options));
  const Precision precision = precision_in_force(system, hidden_surface_options(options));
  if (!precision.exact) request.roundoff = precision.roundoff;
  request.hidden_lines = hidden_lines_in_force(system, hidden_surface_options(options));
  request.intersections = contains(system.lines().kinds, LineKind::intersection);
  return request;
}

RasterRequest raster_request(const ViewedWorld& world, const DrawOptions& options) {
  RasterRequest request = raster_request(world.display_file, options);
  const bool colour_rule = is_colour_rule(request.method);
  request.method =
      colour_rule ? colour_rule_by(HiddenMethod::world_ray_cast) : HiddenMethod::world_ray_cast;
  request.world = &world;
  request.hidden_lines = options.hidden_lines.value_or(HiddenLines::none);
  require_scope_of_view(options);
  require_hidden_lines_drawn(request.hidden_lines, request.method, options);
  request.intersections = world.rays->scene().has_intersections();
  if (options.precision && !options.precision->exact) {
    request.roundoff = options.precision->roundoff;
  }
  return request;
}

/// What the application drew, where the method in force casts rays before viewing.
std::optional<ViewedWorld> world_in_force(const GraphicsSystem& system, HiddenMethod method) {
  if (surfaces_of(method) != HiddenMethod::world_ray_cast) return std::nullopt;
  if (system.retained() == nullptr) {
    throw Error(
        "hidden-surface method 'world-ray-cast' needs world coordinates: expected it to be set, or "
        "the scene to be retained, before the first segment");
  }
  return WorldViews(*system.retained(), system.display_file()).as_drawn();
}

/// With what the application set, for what is drawn without it; the scope has no meaning there.
DrawOptions with_settings(const GraphicsSystem& system, HiddenMethod method, DrawOptions options) {
  options.hidden = method;
  options.scope.reset();
  options.precision = precision_in_force(system, hidden_surface_options(options));
  options.hidden_lines = hidden_lines_in_force(system, hidden_surface_options(options));
  return options;
}

DrawOptions with_background(const GraphicsSystem& system, DrawOptions options) {
  if (!options.background) options.background = system.background();
  return options;
}

}  // namespace

HiddenSurfaceOptions hidden_surface_options(const DrawOptions& options) {
  return {.method = options.hidden,
          .scope = options.scope,
          .precision = options.precision,
          .threads = options.threads,
          .most_pieces = options.most_pieces,
          .progress = options.progress,
          .budget = options.budget,
          .hidden_lines = options.hidden_lines};
}

PictureKind picture_kind(const Destination& to, const DrawOptions& options) {
  return format_of(to, options).write_vectors != nullptr ? PictureKind::vector
                                                         : PictureKind::raster;
}

HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  return drawing_choice(system, options, kind).method;
}

namespace {

/// Why it is a method that was not picked.
std::string_view reason_of_method(const GraphicsSystem& system, const DrawOptions& options) {
  if (options.hidden || system.z_buffer() || system.hidden_line_removal()) return "as asked for";
  const auto& segments = system.display_file().segments();
  const bool some_sorted = std::any_of(segments.begin(), segments.end(),
                                       [](const Segment& s) { return s.sorted() != nullptr; });
  return some_sorted ? "hidden-line removal is off now; segments stay as they were sorted when "
                       "they were closed"
                     : "hidden-line removal is off";
}

}  // namespace

MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (surfaces_of(method) != HiddenMethod::automatic) {
    return {method, reason_of_method(system, options)};
  }
  if (options.pens && !options.pens->hatching && !is_colour_rule(method)) {
    return {HiddenMethod::franklin, "for pens: the lines that are seen, and nothing else"};
  }
  if (options.pens && !is_colour_rule(method)) {
    return {HiddenMethod::map, "for pens: fills are hatched where they are seen"};
  }
  std::optional<Background> background = options.background.value_or(system.background());
  if (!options.ids.empty() || !options.depth.empty()) background.reset();  // fills are asked for
  if (is_colour_rule(method)) background.reset();                          // they hide at least
  MethodChoice chosen = choose_method(system.display_file(), kind, background);
  if (is_colour_rule(method)) chosen.method = colour_rule_by(chosen.method);
  return chosen;
}

namespace {

void require_drawable_by(HiddenMethod method, const GraphicsSystem& system,
                         const DrawOptions& options) {
  require_drawable_by(method, options);
  require_hidden_lines_drawn(hidden_lines_in_force(system, hidden_surface_options(options)), method,
                             options);
}

}  // namespace

namespace {

/// Lines are to be drawn where they are hidden, and the method draws in order of entry.
bool may_leave_hidden_lines(const GraphicsSystem& system, HiddenMethod method,
                            const DrawOptions& options) {
  return hidden_lines_in_force(system, hidden_surface_options(options)) != HiddenLines::none &&
         !is_image_space(method) && !is_object_space(method);
}

/// What the options ask for is refused, and what the application set is left out with a warning.
/// The display file has been brought up to date.
void look_for_hidden_lines_left(const GraphicsSystem& system, const DisplayFile& drawn,
                                HiddenMethod method, const DrawOptions& options) {
  if (!options.hidden_lines && !options.warn) return;
  if (!may_leave_hidden_lines(system, method, options)) return;
  if (options.hidden_lines) {
    if (leaves_hidden_lines(drawn, true, options.threads)) {
      throw Error(words_of_hidden_lines_left(method));
    }
    return;
  }
  try {
    if (!leaves_hidden_lines(drawn, true, options.threads)) return;
  } catch (const LimitReached&) {  // of what is not drawn
    return;
  } catch (const std::bad_alloc&) {
    return;
  }
  options.warn({DrawWarning::Kind::hidden_lines, words_of_hidden_lines_left(method)});
}

}  // namespace

void require_drawable(const GraphicsSystem& system, const DrawOptions& options) {
  require_drawable_in_memory(options);
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  require_drawable_by(method, system, options);
  if (options.hidden_lines && may_leave_hidden_lines(system, method, options) &&
      leaves_hidden_lines(system.display_file(), !options.hidden, options.threads)) {
    throw Error(words_of_hidden_lines_left(method));
  }
}

namespace {

/// What tells why nothing is seen, if the display file is what is drawn.
EnteredScene retained_beside(const GraphicsSystem& system) {
  return {.scene = system.retains_alone() ? nullptr : system.retained()};
}

DisplayFileSource source_of(const ViewedWorld& world, const DrawOptions& options,
                            SoftwareRenderer& software) {
  const View* const view = world.views.size() == 1 ? &world.views.front() : nullptr;
  return {world.display_file, true, options, software, {&world.rays->scene(), view}};
}

/// What is kept from one picture to the next.
struct KeptForPictures {
  SortedDisplayFile& sorted;
  SoftwareRenderer& software;
};

/// Gives the display file, brought up to date, and what is asked of it; or the view of a retained
/// scene.
template <class DrawFile, class DrawWorld>
auto draw_up_to_date(const GraphicsSystem& system, const DrawOptions& options, HiddenMethod method,
                     PictureKind kind, SortedDisplayFile& kept, DrawFile&& draw_file,
                     DrawWorld&& draw_world) {
  require_drawable_by(method, system, options);
  HiddenSurfaceOptions asked = hidden_surface_options(options);
  asked.shadows = kind == PictureKind::vector;
  const DisplayFile& sorted = kept.update(system, unsorted_if_automatic(method), asked);
  look_for_hidden_lines_left(system, sorted, method, options);
  if (const auto world = world_in_force(system, method)) {
    return draw_world(*world, with_settings(system, method, options));
  }
  return draw_file(sorted, raster_request(system, sorted, options));
}

Picture draw_in_memory(const GraphicsSystem& system, const DrawOptions& as_asked,
                       const KeptForPictures& kept) {
  const DrawOptions options = with_background(system, as_asked);
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  return with_memory_of_picture(options, kept.software, [&] {
    return draw_up_to_date(
        system, options, method_in_force(system, hidden_surface_options(options)),
        PictureKind::raster, kept.sorted,
        [&](const DisplayFile& sorted, const RasterRequest& request) {
          return draw_pixels(
              DisplayFileSource(sorted, false, options, kept.software, retained_beside(system)),
              request, options);
        },
        [](const ViewedWorld& world, const DrawOptions& exact) { return draw(world, exact); });
  });
}

void draw_to(const GraphicsSystem& system, const Destination& to, const DrawOptions& as_asked,
             const KeptForPictures& kept) {
  const DrawOptions options = with_background(system, as_asked);
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  require_drawable(to, options);
  const PictureKind kind = picture_kind(to, options);
  // For a picture of pixels it is the renderer that picks a method.
  const HiddenMethod method = kind == PictureKind::raster
                                  ? method_in_force(system, hidden_surface_options(options))
                                  : drawing_method(system, options, PictureKind::vector);
  if (options.pens) require_drawn_by_pens(method, *options.pens);
  with_memory_of_drawing(system.display_file().bytes(), to, options, [&] {
    draw_up_to_date(
        system, options, method, kind, kept.sorted,
        [&](const DisplayFile& sorted, const RasterRequest& request) {
          const DisplayFileSource source(sorted, is_image_space(method), options, kept.software,
                                         retained_beside(system));
          write_picture(source, request, to, options);
        },
        [&](const ViewedWorld& world, const DrawOptions& exact) { draw(world, to, exact); });
  });
}

}  // namespace

Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept) {
  SoftwareRenderer software;
  return draw_in_memory(system, options, {kept, software});
}

Picture draw(const GraphicsSystem& system, const DrawOptions& options) {
  SortedDisplayFile kept;
  return draw(system, options, kept);
}

void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
          SortedDisplayFile& kept) {
  SoftwareRenderer software;
  draw_to(system, to, options, {kept, software});
}

std::string draw_as(const GraphicsSystem& system, std::string_view format,
                    const DrawOptions& options) {
  DrawOptions in_format = options;
  in_format.format = format;
  if (format.empty()) format_named("");  // refuses
  CollectedText bytes;
  bytes.exceptions(std::ios::badbit);  // that of memory, where it is written
  draw(system, bytes, in_format);
  return std::move(bytes).str();
}

void draw(const DisplayFile& display_file, const Destination& to, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  require_drawable(to, options);
  require_order_as_it_is(display_file, options);
  SoftwareRenderer software;
  write_picture(DisplayFileSource(display_file, false, options, software),
                raster_request(display_file, options), to, options);
}

Picture draw(const DisplayFile& display_file, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  SoftwareRenderer software;
  return with_memory_of_picture(options, software, [&] {
    require_order_as_it_is(display_file, options);
    return draw_pixels(DisplayFileSource(display_file, false, options, software),
                       raster_request(display_file, options), options);
  });
}

void draw(const ViewedWorld& world, const Destination& to, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  require_drawable(to, options);
  require_drawn_by_rays(options, picture_kind(to, options));
  SoftwareRenderer software;
  write_picture(source_of(world, options, software), raster_request(world, options), to, options);
}

Picture draw(const ViewedWorld& world, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  SoftwareRenderer software;
  return with_memory_of_picture(options, software, [&] {
    require_drawn_by_rays(options, PictureKind::raster);
    return draw_pixels(source_of(world, options, software), raster_request(world, options),
                       options);
  });
}

void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options) {
  SortedDisplayFile kept;
  draw(system, to, options, kept);
}

// ---- What is kept ------------------------------------------------------------------------

struct Renderer::Kept {
  SortedDisplayFile sorted;
  SoftwareRenderer software;
  Picture picture;  ///< where the software renderer has not the whole of it
  std::optional<Picker> picker;
};

Renderer::Renderer() : kept_(std::make_unique<Kept>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&& other) noexcept = default;
Renderer& Renderer::operator=(Renderer&& other) noexcept = default;

const Picture& Renderer::draw(const GraphicsSystem& system, const DrawOptions& options) {
  require_drawable_in_memory(options);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));  // none, if drawing fails
  kept.picture = draw_in_memory(system, options, {kept.sorted, kept.software});
  return kept.picture;
}

Picture Renderer::take_picture() { return std::exchange(kept_->picture, Picture()); }

void Renderer::give_back(Picture picture) { kept_->picture = std::move(picture); }

void Renderer::draw(const GraphicsSystem& system, const Destination& to,
                    const DrawOptions& options) {
  draw_to(system, to, options, {kept_->sorted, kept_->software});
}

std::optional<Pick> Renderer::pick(const GraphicsSystem& system, double x, double y,
                                   const DrawOptions& options, double reach) {
  require_drawable_in_memory(options);
  const BudgetInForce in_force(options.budget);
  const PictureSize size{options.width, options.height};
  Kept& kept = *kept_;
  std::optional<Picker>& picker = kept.picker;
  const bool same_scene = picker && picker->scene().is_of(system.display_file());
  if (!same_scene || !(picker->size() == size)) {
    picker.reset();
    const std::size_t polygons = system.display_file().polygons();
    with_memory(
        system.display_file().bytes(),
        [&] { return fmt::format("picking among {} polygons", polygons); },
        [&] {
          picker.emplace(kept.software.scene_of(system.display_file()), size, options.threads);
        });
  }
  return picker->pick(x, y, reach);
}

}  // namespace displayfile
