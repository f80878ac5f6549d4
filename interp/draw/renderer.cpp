#include "interp/draw/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/hidden_lines_left.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/scene_viewer.h"
#include "displayfile/views/taken_scene.h"
#include "interp/device/raster_request.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/item_buffer.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_source.h"
#include "interp/draw/world_views.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/picker.h"
#include "interp/visibility/world_rays.h"

namespace displayfile {

InView in_view(const GraphicsSystem& system, const View& view) {
  if (system.retained() == nullptr) {
    throw Error("a scene in another view: expected the system to retain it");
  }
  return {.scene = *system.retained(),
          .attributes = system.display_file(),
          .view = view,
          .settings = &system};
}

namespace {

constexpr WorkDone kDrawing{"the drawing",
                            "for pixels one sample each, a smaller picture or hidden-surface "
                            "method z-buffer, scan-line-z in little memory"};

RasterRequest raster_request(const DisplayFile& file, const PicturePlan& plan) {
  RasterRequest request = raster_request(plan);
  request.sorted = has_exact_order(file);
  return request;
}

/// The plan for drawing in the display file's own order.
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

void require_drawn(const PicturePlan& plan) {
  require_drawable_by(plan.method, plan);
  require_hidden_lines_drawn(plan.surfaces.hidden_lines, plan.method, plan);
  require_line_order_obeyed(plan.method, plan, plan.kind());
}

/// True if hidden lines are to be drawn and the method draws in order of entry.
bool may_leave_hidden_lines(const PicturePlan& plan) {
  return plan.surfaces.hidden_lines != HiddenLines::none && !is_image_space(plan.method) &&
         !is_object_space(plan.method);
}

/// Throws Error if hidden lines set by the options would be left out, and warns of those set by the
/// application. The display file must be up to date.
void look_for_hidden_lines_left(const DisplayFile& drawn, const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (!options.surfaces.hidden_lines && !options.warn) return;
  if (!may_leave_hidden_lines(plan)) return;
  if (options.surfaces.hidden_lines) {
    if (leaves_hidden_lines(drawn, true, options.surfaces.threads)) {
      throw Error(words_of_hidden_lines_left(plan.method));
    }
    return;
  }
  try {
    if (!leaves_hidden_lines(drawn, true, options.surfaces.threads)) return;
  } catch (const LimitReached&) {  // of what is not drawn
    return;
  } catch (const std::bad_alloc&) {
    return;
  }
  options.warn({DrawWarning::Kind::hidden_lines, words_of_hidden_lines_left(plan.method)});
}

}  // namespace

void require_drawable(const GraphicsSystem& system, const DrawOptions& options) {
  const PicturePlan plan = resolve(system, options);
  require_drawn(plan);
  if (options.surfaces.hidden_lines && may_leave_hidden_lines(plan) &&
      leaves_hidden_lines(system.display_file(), !options.surfaces.method,
                          options.surfaces.threads)) {
    throw Error(words_of_hidden_lines_left(plan.method));
  }
}

namespace {

/// The application's primitives that explain why nothing is visible, where the display file is
/// drawn.
EnteredSource retained_beside(const GraphicsSystem& system) {
  return {.scene = SystemInside::retains_alone(system) ? nullptr : system.retained()};
}

DisplayFileSource source_of(const ViewedWorld& world, const PicturePlan& plan,
                            SoftwareRenderer& software) {
  const View* const view = world.views.size() == 1 ? &world.views.front() : nullptr;
  return {world.display_file, true, plan, software, {&world.rays->scene(), view}};
}

/// Data cached for all views of a retained scene, each built when it is first needed.
class KeptTrees {
 public:
  /// Prepares for a scene, and releases the data of another one.
  void take(const RetainedScene& scene, const DisplayFile& attributes) {
    const bool is_same = taken_ && !taken_->is_gone() && &taken_->scene() == &scene &&
                         &taken_->attributes() == &attributes;
    if (is_same) return;
    viewer_.reset();
    drop_casters();
    world_.reset();
    trees_.reset();
    taken_.emplace(scene, attributes);
  }

  SceneViewer& viewer() {
    if (!viewer_) viewer_.emplace(taken_->scene(), taken_->attributes());
    if (viewer_->bring_up_to_date()) drop_casters();  // they are those of the scene as it was
    return *viewer_;
  }
  /// Null if no shadows are shown.
  RetainedCasters* casters(int threads) {
    if (viewer_->shows_shadows() && casters_ == nullptr) {
      casters_ = std::make_unique<RetainedCasters>(viewer_->scene(), threads);
      ++caster_trees_;
    }
    return casters_.get();
  }
  const WorldViews& world() {
    if (!world_) world_.emplace(taken_->scene(), taken_->attributes());
    return *world_;
  }
  RetainedViews& trees(const SurfacePlan& plan) {
    if (!trees_ || !trees_->take_up(plan)) {
      trees_.reset();
      trees_.emplace(taken_->scene(), taken_->attributes(), plan);
    }
    return *trees_;
  }

  Renderer::Made made(std::size_t surfaces) const {
    return {surfaces, caster_trees_,
            caster_lists_ + (casters_ != nullptr ? casters_->lists_made() : 0u)};
  }
  void keep_drawn_by_pens(const DisplayFile& drawn) { drawn_by_pens_ = drawn; }
  const DisplayFile& drawn_by_pens() const { return drawn_by_pens_; }
  std::size_t bytes_of_casters() const { return casters_ == nullptr ? 0 : casters_->bytes(); }
  Renderer::Trees of_trees() const {
    Renderer::Trees all;
    if (trees_) {
      all = {.sorted = trees_->trees(),
             .pieces = trees_->counts().pieces,
             .cuts = trees_->counts().cuts,
             .comparisons = trees_->counts().comparisons,
             .depth = trees_->counts().depth,
             .walks = trees_->walks(),
             .reused = trees_->reused()};
    }
    if (world_) all.polygons_in_boxes = world_->polygons();
    return all;
  }

 private:
  void drop_casters() {
    if (casters_ != nullptr) caster_lists_ += casters_->lists_made();
    casters_.reset();
  }

  std::optional<TakenScene> taken_;
  std::optional<SceneViewer> viewer_;
  std::unique_ptr<RetainedCasters> casters_;
  std::size_t caster_trees_ = 0, caster_lists_ = 0;  // that were made; lists of former casters
  std::optional<WorldViews> world_;
  std::optional<RetainedViews> trees_;
  DisplayFile drawn_by_pens_;
};

}  // namespace

/// Data cached between pictures.
struct Renderer::Kept {
  SortedDisplayFile sorted;
  SoftwareRenderer software;
  Picture picture;  ///< used where the software renderer does not hold the whole picture
  std::optional<Picker> picker;
  KeptTrees of_scene;
};

namespace {

struct KeptForPictures {
  SortedDisplayFile& sorted;
  SoftwareRenderer& software;
  KeptTrees& of_scene;
};

/// The retained scene in the application's views, if the method in force casts rays in world
/// coordinates.
std::optional<ViewedWorld> world_in_force(const GraphicsSystem& system, HiddenMethod method,
                                          KeptTrees& kept) {
  if (surfaces_of(method) != HiddenMethod::world_ray_cast) return std::nullopt;
  if (system.retained() == nullptr) {
    throw Error(
        "hidden-surface method 'world-ray-cast' needs world coordinates: expected it to be set, or "
        "the scene to be retained, before the first segment");
  }
  kept.take(*system.retained(), system.display_file());
  return kept.world().as_drawn();
}

/// Returns the result of draw(source, request, plan) for the updated display file, or for the
/// retained scene in its views.
template <class Draw>
auto draw_up_to_date(const GraphicsSystem& system, const PicturePlan& plan,
                     const KeptForPictures& kept, const Draw& draw) {
  require_drawn(plan);
  const DisplayFile& sorted = kept.sorted.update(system, plan.options.surfaces, plan.surfaces,
                                                 unsorted_if_automatic(plan.method));
  look_for_hidden_lines_left(sorted, plan);
  warn_of_options_without_effect(plan, sorted);
  warn_of_annotation(plan, sorted);
  if (const auto world = world_in_force(system, plan.method, kept.of_scene)) {
    const PicturePlan cast = by_rays(*world, plan);
    return draw(source_of(*world, cast, kept.software), raster_request(*world, cast), cast);
  }
  const bool by_depth = plan.kind() == PictureKind::vector && is_image_space(plan.method);
  return draw(DisplayFileSource(sorted, by_depth, plan, kept.software, retained_beside(system)),
              raster_request(sorted, plan), plan);
}

Picture draw_in_memory(const GraphicsSystem& system, const PicturePlan& plan,
                       const KeptForPictures& kept) {
  const BudgetInForce in_force(plan.options.surfaces.budget);
  const NamedWork named(kDrawing);
  warn_if_stretched(system, plan.options);
  return with_memory_of_picture(plan, kept.software,
                                [&] { return draw_up_to_date(system, plan, kept, draw_pixels); });
}

void draw_by(const PicturePlan& plan, const GraphicsSystem& system, const KeptForPictures& kept) {
  const DrawOptions& options = plan.options;
  require_writable(plan);
  if (options.pens) require_drawn_by_pens(plan.method, *options.pens);
  warn_if_stretched(system, options);
  with_memory_of_drawing(system.display_file().bytes(), plan,
                         [&] { draw_up_to_date(system, plan, kept, write_picture); });
}

void draw_to(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
             const KeptForPictures& kept) {
  const BudgetInForce in_force(options.surfaces.budget);
  const NamedWork named(kDrawing);
  draw_by(resolve(system, options, &to), system, kept);
}

const glm::dmat3& lights_of(const InView& scene) {
  static const glm::dmat3 kAsTheyAre(1.0);
  return scene.lights_turned != nullptr ? *scene.lights_turned : kAsTheyAre;
}

// ---- In a view -----------------------------------------------------------------------------

bool works_in_image_space(HiddenMethod method) {
  return is_image_space(method) && surfaces_of(method) != HiddenMethod::world_ray_cast;
}

void require_drawn_in_view(const InView& scene, const PicturePlan& plan) {
  if (plan.options.pens) require_drawn_by_pens(plan.method, *plan.options.pens);
  const bool is_systems = scene.settings != nullptr;  // whose scope has no meaning there either
  if (!is_systems && is_image_space(plan.method)) require_scope_of_view(plan.options);
  require_drawn(plan);
}

bool has_annotations(const RetainedScene& scene) {
  return std::ranges::any_of(scene.segments(), [](const RetainedScene::Segment& segment) {
    return !segment.annotations.empty();
  });
}

/// Returns the result of draw(source, request, plan) for the scene in that view.
template <class Draw>
auto draw_in_view(const InView& in, PicturePlan plan, KeptTrees& kept, SoftwareRenderer& software,
                  const Draw& draw) {
  kept.take(in.scene, in.attributes);
  warn_if_stretched(in.view, in.settings, plan.options);
  require_line_order_obeyed(plan.method, plan, plan.kind());
  warn_of_options_without_effect(plan, in.attributes);
  if (plan.options.warn && has_annotations(in.scene)) {
    warn_of_annotation(plan, kept.viewer().view({in.view, lights_of(in)}));
  }
  plan.surfaces.intersections = in.scene.has_intersections();
  if (surfaces_of(plan.method) == HiddenMethod::world_ray_cast) {
    const ViewedWorld world = kept.world().view(in.view, lights_of(in));
    const PicturePlan cast = by_rays(world, plan);
    return draw(source_of(world, cast, software), raster_request(world, cast), cast);
  }
  if (works_in_image_space(plan.method)) {
    SceneViewer& viewer = kept.viewer();
    return draw(RetainedSource(viewer, in.view, lights_of(in), plan, software,
                               kept.casters(plan.options.surfaces.threads)),
                raster_request(plan), plan);
  }
  if (surfaces_of(plan.method) == HiddenMethod::bsp) {
    RetainedViews& trees = kept.trees(plan.surfaces);
    const DisplayFile seen = trees.view(in.view, lights_of(in));
    const PicturePlan ordered = in_its_order(plan);
    return draw(DisplayFileSource(seen, false, ordered, software, {&in.scene, &in.view}),
                raster_request(seen, ordered), ordered);
  }
  const DisplayFile whole = kept.viewer().display_file(in.view, lights_of(in));
  SortedDisplayFile sorted;
  const DisplayFile& seen = is_object_space(plan.method)
                                ? sorted.update(whole, plan.surfaces.by(surfaces_of(plan.method)))
                                : whole;
  look_for_hidden_lines_left(seen, plan);
  if (plan.options.pens) kept.keep_drawn_by_pens(seen);
  return draw(DisplayFileSource(seen, false, plan, software, {&in.scene, &in.view}),
              raster_request(seen, plan), plan);
}

void draw_view_to(const InView& scene, const PicturePlan& plan, KeptTrees& kept,
                  SoftwareRenderer& software) {
  require_drawn_in_view(scene, plan);
  require_writable(plan);
  const BudgetInForce in_force(plan.options.surfaces.budget);
  const NamedWork named(kDrawing);
  with_memory_of_drawing(scene.scene.size() * sizeof(Point3), plan,
                         [&] { draw_in_view(scene, plan, kept, software, write_picture); });
}

}  // namespace

void draw(const InView& scene, const PicturePlan& plan) {
  SoftwareRenderer software;
  KeptTrees of_scene;
  draw_view_to(scene, plan, of_scene, software);
}

// ---- Free functions ------------------------------------------------------------------------

Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept) {
  SoftwareRenderer software;
  KeptTrees of_scene;
  return draw_in_memory(system, resolve(system, options), {kept, software, of_scene});
}

Picture draw(const GraphicsSystem& system, const DrawOptions& options) {
  SortedDisplayFile kept;
  return draw(system, options, kept);
}

void draw(const GraphicsSystem& system, const PicturePlan& plan, SortedDisplayFile& kept) {
  const BudgetInForce in_force(plan.options.surfaces.budget);
  const NamedWork named(kDrawing);
  SoftwareRenderer software;
  KeptTrees of_scene;
  draw_by(plan, system, {kept, software, of_scene});
}

void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
          SortedDisplayFile& kept) {
  SoftwareRenderer software;
  KeptTrees of_scene;
  draw_to(system, to, options, {kept, software, of_scene});
}

void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options) {
  SortedDisplayFile kept;
  draw(system, to, options, kept);
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
  const BudgetInForce in_force(options.surfaces.budget);
  const NamedWork named(kDrawing);
  const PicturePlan plan = in_its_order(resolve(options, &to));
  require_writable(plan);
  require_order_as_it_is(display_file, options);
  SoftwareRenderer software;
  write_picture(DisplayFileSource(display_file, false, plan, software),
                raster_request(display_file, plan), plan);
}

Picture draw(const DisplayFile& display_file, const DrawOptions& options) {
  const BudgetInForce in_force(options.surfaces.budget);
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
  const BudgetInForce in_force(options.surfaces.budget);
  const NamedWork named(kDrawing);
  const PicturePlan plan = by_rays(world, resolve(options, &to));
  require_writable(plan);
  require_scope_of_view(options);
  SoftwareRenderer software;
  write_picture(source_of(world, plan, software), raster_request(world, plan), plan);
}

Picture draw(const ViewedWorld& world, const DrawOptions& options) {
  const BudgetInForce in_force(options.surfaces.budget);
  const NamedWork named(kDrawing);
  SoftwareRenderer software;
  const PicturePlan plan = by_rays(world, resolve(options));
  return with_memory_of_picture(plan, software, [&] {
    require_scope_of_view(options);
    return draw_pixels(source_of(world, plan, software), raster_request(world, plan), plan);
  });
}

// ---- Renderer ------------------------------------------------------------------------------

Renderer::Renderer() : kept_(std::make_unique<Kept>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&& other) noexcept = default;
Renderer& Renderer::operator=(Renderer&& other) noexcept = default;

const Picture& Renderer::draw(const GraphicsSystem& system, const DrawOptions& options) {
  const PicturePlan plan = resolve(system, options);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));  // none, if drawing fails
  kept.picture = draw_in_memory(system, plan, {kept.sorted, kept.software, kept.of_scene});
  return kept.picture;
}

void Renderer::draw(const GraphicsSystem& system, const Destination& to,
                    const DrawOptions& options) {
  draw_to(system, to, options, {kept_->sorted, kept_->software, kept_->of_scene});
}

const Picture& Renderer::draw(const InView& scene, const DrawOptions& options) {
  const PicturePlan plan = resolve_in_view(scene.settings, options);
  require_drawn_in_view(scene, plan);
  const BudgetInForce in_force(options.surfaces.budget);
  const NamedWork named(kDrawing);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));
  kept.picture = with_memory_of_picture(plan, kept.software, [&] {
    return draw_in_view(scene, plan, kept.of_scene, kept.software, draw_pixels);
  });
  return kept.picture;
}

void Renderer::draw(const InView& scene, const Destination& to, const DrawOptions& options) {
  draw_view_to(scene, resolve_in_view(scene.settings, options, &to), kept_->of_scene,
               kept_->software);
}

DisplayFile Renderer::display_file(const InView& scene) {
  const RoundToNearest nearest;
  kept_->of_scene.take(scene.scene, scene.attributes);
  return kept_->of_scene.viewer().display_file(scene.view, lights_of(scene));
}

Picture Renderer::take_picture() { return std::exchange(kept_->picture, Picture()); }

void Renderer::give_back(Picture picture) { kept_->picture = std::move(picture); }

const DisplayFile& Renderer::drawn_by_pens() const { return kept_->of_scene.drawn_by_pens(); }

namespace {

DrawnPixel pixel_drawn(const GraphicsSystem& system, const DrawOptions& options,
                       const Picker::Pixel& at, const KeptForPictures& kept) {
  const DrawOptions row = row_of_pixel(options, at);
  Picture picture = draw_in_memory(system, resolve(system, row), kept);
  const auto column = static_cast<std::size_t>(at.column);
  const DrawnPixel drawn{picture.ids[column], picture.depth[column]};
  kept.software.give_back(std::move(picture));
  return drawn;
}

/// Draws one row, so that the software renderer holds the picture's lines.
void draw_row_of_lines(const GraphicsSystem& system, const DrawOptions& options,
                       const Picker::Pixel& at, const KeptForPictures& kept) {
  DrawOptions row = row_of_pixel(options, at);
  row.with_ids = row.with_depth = false;
  kept.software.give_back(draw_in_memory(system, resolve(system, row), kept));
}

}  // namespace

std::optional<Pick> Renderer::pick(const GraphicsSystem& system, double x, double y,
                                   const DrawOptions& options, double reach) {
  const PicturePlan plan = resolve(system, options);
  const BudgetInForce in_force(options.surfaces.budget);
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
          picker.emplace(kept.software.scene_of(system.display_file()), size,
                         options.surfaces.threads);
        });
  }
  const auto at = picker->pixel_at(x, y, reach);
  if (!at) return std::nullopt;
  if (reach > 0.0 && draws_lines_by_depth(plan.method, plan, PictureKind::raster)) {
    draw_row_of_lines(system, options, *at, {kept.sorted, kept.software, kept.of_scene});
    if (const auto line = kept.software.line_at(size, *at, reach)) return line;
    reach = 0.0;
  }
  const ItemBufferIs item_buffer = item_buffer_of(system, plan);
  if (item_buffer == ItemBufferIs::truth) return picker->pick(*at, reach);
  if (finds_lines(plan.method)) {
    const DisplayFile& sorted =
        kept.sorted.update(system, options.surfaces, plan.surfaces, plan.method);
    return picker->pick(*at, reach, layers_of(sorted, picker->scene(), plan.method));
  }
  const DrawnPixel drawn =
      pixel_drawn(system, options, *at, {kept.sorted, kept.software, kept.of_scene});
  if (item_buffer == ItemBufferIs::drawn) return picker->pick(*at, reach, {}, drawn);
  const DisplayFile& sorted = kept.sorted.display_file();
  return picker->pick(*at, reach, layers_of(sorted, picker->scene(), plan.method), drawn);
}

std::optional<Pick> Renderer::seen_at(const InView& scene, double x, double y) {
  kept_->of_scene.take(scene.scene, scene.attributes);
  return kept_->of_scene.world().pick(scene.view, x, y);
}

Renderer::Made Renderer::made() const {
  return kept_->of_scene.made(kept_->software.surfaces_found());
}

std::size_t Renderer::bytes_of_casters() const { return kept_->of_scene.bytes_of_casters(); }

Renderer::Trees Renderer::trees() const { return kept_->of_scene.of_trees(); }

}  // namespace displayfile
