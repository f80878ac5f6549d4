#include "interp/draw/draw.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "clip/budgeted_work.h"
#include "clip/error.h"
#include "clip/memory.h"
#include "clip/work_budget.h"
#include "displayfile/collected_text.h"
#include "displayfile/hidden_lines_left.h"
#include "displayfile/hidden_surface_check.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/device/raster_request.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_source.h"
#include "interp/draw/renderer.h"
#include "interp/draw/world_views.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/picker.h"
#include "interp/visibility/world_rays.h"

namespace displayfile {

namespace {

constexpr WorkDone kDrawing{
    "the drawing",
    "for pixels a smaller picture or hidden-surface method z-buffer, scan-line-z in little memory"};

RasterRequest raster_request(const DisplayFile& file, const PicturePlan& plan) {
  RasterRequest request = raster_request(plan);
  request.sorted = has_exact_order(file);
  return request;
}

/// What is drawn in the order that the display file has.
PicturePlan in_its_order(PicturePlan plan) {
  const bool colour_rule = is_colour_rule(plan.surfaces.method);
  plan.method = colour_rule ? colour_rule_by(HiddenMethod::none) : HiddenMethod::none;
  plan.surfaces.precision = {};
  plan.surfaces.hidden_lines = HiddenLines::none;
  return plan;
}

PicturePlan by_rays(const ViewedWorld& world, PicturePlan plan) {
  require_drawn_by_rays(plan);
  const bool colour_rule = is_colour_rule(plan.surfaces.method);
  plan.method =
      colour_rule ? colour_rule_by(HiddenMethod::world_ray_cast) : HiddenMethod::world_ray_cast;
  require_hidden_lines_drawn(plan.surfaces.hidden_lines, plan.method, plan);
  plan.surfaces.intersections = world.rays->scene().has_intersections();
  return plan;
}

RasterRequest raster_request(const ViewedWorld& world, const PicturePlan& plan) {
  RasterRequest request = raster_request(world.display_file, plan);
  request.world = &world;
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
  if (options.hidden || system.hidden_surfaces().z_buffer || system.hidden_surfaces().removal)
    return "as asked for";
  const auto& segments = system.display_file().segments();
  const bool some_sorted = std::any_of(segments.begin(), segments.end(),
                                       [](const Segment& s) { return s.sorted() != nullptr; });
  if (some_sorted) {
    return "hidden-line removal is off now; segments stay as they were sorted when they were "
           "closed";
  }
  const SaidSettings& said = system.said();
  const bool is_set =
      said.contains(Setting::hidden_line_removal) || said.contains(Setting::hidden_method);
  return is_set ? "hidden-line removal is off"
                : "all points have one depth: the order of entry holds";
}

}  // namespace

MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  PicturePlan plan{.options = options, .device = &first_device()};
  plan.surfaces = surfaces_of_picture(system, options);
  return choice_for(system, plan, kind);
}

MethodChoice choice_for(const GraphicsSystem& system, const PicturePlan& plan, PictureKind kind) {
  const DrawOptions& options = plan.options;
  const HiddenMethod method = plan.surfaces.method;
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
  if (!options.ids.empty() || !options.depth.empty()) background.reset();  // fills are wanted
  if (is_colour_rule(method)) background.reset();                          // they hide at least
  MethodChoice chosen = choose_method(system.display_file(), kind, background);
  if (is_colour_rule(method)) chosen.method = colour_rule_by(chosen.method);
  return chosen;
}

namespace {

void require_drawn(const PicturePlan& plan) {
  require_drawable_by(plan.method, plan);
  require_hidden_lines_drawn(plan.surfaces.hidden_lines, plan.method, plan);
}

/// Lines are to be drawn where they are hidden, and the method draws in order of entry.
bool may_leave_hidden_lines(const PicturePlan& plan) {
  return plan.surfaces.hidden_lines != HiddenLines::none && !is_image_space(plan.method) &&
         !is_object_space(plan.method);
}

/// What the options ask for is refused, and what the application set is left out with a warning.
/// The display file has been brought up to date.
void look_for_hidden_lines_left(const DisplayFile& drawn, const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (!options.hidden_lines && !options.warn) return;
  if (!may_leave_hidden_lines(plan)) return;
  if (options.hidden_lines) {
    if (leaves_hidden_lines(drawn, true, options.threads)) {
      throw Error(words_of_hidden_lines_left(plan.method));
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
  options.warn({DrawWarning::Kind::hidden_lines, words_of_hidden_lines_left(plan.method)});
}

}  // namespace

void require_format(const Destination& to, const DrawOptions& options) { resolve(options, &to); }

void require_drawable(const Destination& to, const DrawOptions& options) {
  require_writable(to, resolve(options, &to));
}

void require_drawable(const GraphicsSystem& system, const DrawOptions& options) {
  const PicturePlan plan = resolve(system, options);
  require_drawn(plan);
  if (options.hidden_lines && may_leave_hidden_lines(plan) &&
      leaves_hidden_lines(system.display_file(), !options.hidden, options.threads)) {
    throw Error(words_of_hidden_lines_left(plan.method));
  }
}

namespace {

/// What tells why nothing is seen, if the display file is what is drawn.
EnteredScene retained_beside(const GraphicsSystem& system) {
  return {.scene = SystemInside::retains_alone(system) ? nullptr : system.retained()};
}

DisplayFileSource source_of(const ViewedWorld& world, const PicturePlan& plan,
                            SoftwareRenderer& software) {
  const View* const view = world.views.size() == 1 ? &world.views.front() : nullptr;
  return {world.display_file, true, plan, software, {&world.rays->scene(), view}};
}

/// What is kept from one picture to the next.
struct KeptForPictures {
  SortedDisplayFile& sorted;
  SoftwareRenderer& software;
};

/// What draw(source, request, plan) returns: of the display file, brought up to date, or of the
/// retained scene in its views.
template <class Draw>
auto draw_up_to_date(const GraphicsSystem& system, const PicturePlan& plan,
                     const KeptForPictures& kept, const Draw& draw) {
  require_drawn(plan);
  const DisplayFile& sorted =
      kept.sorted.update(system, plan.surfaces, unsorted_if_automatic(plan.method));
  look_for_hidden_lines_left(sorted, plan);
  if (const auto world = world_in_force(system, plan.method)) {
    const PicturePlan cast = by_rays(*world, plan);
    return draw(source_of(*world, cast, kept.software), raster_request(*world, cast), cast);
  }
  const bool by_depth = plan.kind() == PictureKind::vector && is_image_space(plan.method);
  return draw(DisplayFileSource(sorted, by_depth, plan, kept.software, retained_beside(system)),
              raster_request(sorted, plan), plan);
}

Picture draw_in_memory(const GraphicsSystem& system, const PicturePlan& plan,
                       const KeptForPictures& kept) {
  const BudgetInForce in_force(plan.options.budget);
  const NamedWork named(kDrawing);
  return with_memory_of_picture(plan, kept.software,
                                [&] { return draw_up_to_date(system, plan, kept, draw_pixels); });
}

void draw_to(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
             const KeptForPictures& kept) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  const PicturePlan plan = resolve(system, options, &to);
  require_writable(to, plan);
  if (options.pens) require_drawn_by_pens(plan.method, *options.pens);
  with_memory_of_drawing(system.display_file().bytes(), to, plan, [&] {
    draw_up_to_date(system, plan, kept,
                    [&](const PictureSource& source, const RasterRequest& request,
                        const PicturePlan& drawn) { write_picture(source, request, to, drawn); });
  });
}

}  // namespace

Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept) {
  SoftwareRenderer software;
  return draw_in_memory(system, resolve(system, options), {kept, software});
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
  const PicturePlan plan = in_its_order(resolve(options, &to));
  require_writable(to, plan);
  require_order_as_it_is(display_file, options);
  SoftwareRenderer software;
  write_picture(DisplayFileSource(display_file, false, plan, software),
                raster_request(display_file, plan), to, plan);
}

Picture draw(const DisplayFile& display_file, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  const PicturePlan plan = in_its_order(resolve(options));
  SoftwareRenderer software;
  return with_memory_of_picture(plan, software, [&] {
    require_order_as_it_is(display_file, options);
    return draw_pixels(DisplayFileSource(display_file, false, plan, software),
                       raster_request(display_file, plan), plan);
  });
}

void draw(const ViewedWorld& world, const Destination& to, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  const PicturePlan plan = by_rays(world, resolve(options, &to));
  require_writable(to, plan);
  require_scope_of_view(options);
  SoftwareRenderer software;
  write_picture(source_of(world, plan, software), raster_request(world, plan), to, plan);
}

Picture draw(const ViewedWorld& world, const DrawOptions& options) {
  const BudgetInForce in_force(options.budget);
  const NamedWork named(kDrawing);
  SoftwareRenderer software;
  const PicturePlan plan = by_rays(world, resolve(options));
  return with_memory_of_picture(plan, software, [&] {
    require_scope_of_view(options);
    return draw_pixels(source_of(world, plan, software), raster_request(world, plan), plan);
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
  const PicturePlan plan = resolve(system, options);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));  // none, if drawing fails
  kept.picture = draw_in_memory(system, plan, {kept.sorted, kept.software});
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
  resolve(options);  // refuses
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
