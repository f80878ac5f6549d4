#include "interp/draw/picture_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "clip/view/window_fit.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/sorted_scene.h"
#include "displayfile/text/output.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/draw/hidden_anchors.h"
#include "interp/draw/picture_source.h"
#include "interp/raster/antialias.h"
#include "interp/text/letter_paths.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

bool draws_for_pens(HiddenMethod method, bool of_fills) {
  if (finds_lines(method)) return !of_fills;
  return method == HiddenMethod::map || method == HiddenMethod::none ||
         method == HiddenMethod::back_face;
}

void require_drawn_by_pens(HiddenMethod method, const Pens& pens) {
  if (draws_for_pens(method, pens.hatching.has_value())) return;
  std::string expected;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    if (!draws_for_pens(entry.method, pens.hatching.has_value())) continue;
    if (expected.find(name_of(entry.method)) != std::string::npos) continue;
    expected.append(expected.empty() ? "" : " ").append(name_of(entry.method));
  }
  throw Error(fmt::format("pens and hidden-surface method '{}', which {}: expected one of {}",
                          name_of(method),
                          finds_lines(method) ? "draws no fills to be hatched"
                                              : "hides by painting over what was drawn",
                          expected));
}

namespace {

/// Refuses a ROUNDOFF for the plain z-buffer, which decides by depths as stored; in vectors it is
/// replaced by the map.
void require_precision_of_plain_z_buffer(HiddenMethod method, const PicturePlan& plan) {
  const bool decides = plan.kind() == PictureKind::raster && plan.is_on_first_device();
  if (!decides || !is_plain_z_buffer(method) || plan.surfaces.precision.exact) return;
  throw Error(
      fmt::format("hidden-surface method '{}' rounds depths as it stores them, without a ROUNDOFF: "
                  "expected precision exact",
                  name_of(method)));
}

}  // namespace

void require_drawable_by(HiddenMethod method, const PicturePlan& plan) {
  require_precision_of_plain_z_buffer(method, plan);
  if (!shows_lines_only(method)) return;
  if (finds_lines(method) && plan.wants_fills()) {
    throw Error(fmt::format(
        "item buffers and depths are of fills, which hidden-line method '{}' does not draw: "
        "expected another method",
        name_of(method)));
  }
  if (!plan.is_on_first_device()) {
    throw Error(
        fmt::format("hidden-line method '{}' on the {} device, which draws surfaces: "
                    "expected the {} device",
                    name_of(method), plan.device->choice.name, first_device().choice.name));
  }
}

void require_hidden_lines_drawn(HiddenLines hidden_lines, HiddenMethod method,
                                const PicturePlan& plan) {
  if (hidden_lines == HiddenLines::none || is_object_space(method)) return;
  require_hidden_lines_found(hidden_lines, method);
  if (!plan.is_on_first_device() && is_image_space(method)) {
    throw Error(
        fmt::format("hidden lines are not drawn by the {} device by '{}': expected the {} device, "
                    "bsp, depth-sort, map, or hidden lines none",
                    plan.device->choice.name, name_of(method), first_device().choice.name));
  }
}

namespace {

/// The reason why overlapping lines stay in order of entry; empty if they do not.
std::string why_not_by_depth(HiddenMethod method, const PicturePlan& plan, PictureKind kind) {
  const HiddenMethod surfaces = surfaces_of(method);
  if (!plan.is_on_first_device()) {
    return fmt::format("the {} device draws lines in order of entry", plan.device->choice.name);
  }
  if (is_colour_rule(method)) {
    return fmt::format("hidden-line method '{}' compares lines with fills alone", name_of(method));
  }
  if (surfaces == HiddenMethod::none || surfaces == HiddenMethod::back_face) {
    return fmt::format("hidden-surface method '{}' draws in order of entry", name_of(method));
  }
  const bool sorts = surfaces == HiddenMethod::bsp || surfaces == HiddenMethod::plain_bsp ||
                     surfaces == HiddenMethod::depth_sort;
  if (sorts && kind == PictureKind::vector) {
    return fmt::format("in vectors hidden-surface method '{}' draws lines among fills",
                       name_of(method));
  }
  return "";
}

}  // namespace

bool draws_lines_by_depth(HiddenMethod method, const PicturePlan& plan, PictureKind kind) {
  return plan.surfaces.line_order == LineOrder::depth &&
         why_not_by_depth(method, plan, kind).empty();
}

void require_line_order_obeyed(HiddenMethod method, const PicturePlan& plan, PictureKind kind) {
  if (plan.options.surfaces.line_order != LineOrder::depth) return;
  const std::string why = why_not_by_depth(method, plan, kind);
  if (why.empty()) return;
  throw Error(fmt::format("line order depth: {}: expected {}, or line order entry", why,
                          plan.is_on_first_device()
                              ? "z-buffer, franklin or another method that finds surfaces or lines"
                              : fmt::format("the {} device", first_device().choice.name)));
}

void require_scope_of_view(const DrawOptions& options) {
  if (options.surfaces.scope != HiddenScope::segment) return;
  throw Error(
      "scope 'segment' for a view of a retained scene, whose visible segments are drawn together: "
      "expected all, or no scope");
}

namespace {

/// An order of visible segments; null if they are in order of entry.
struct OrderMade {
  const SortedScene* sorted;
  HiddenScope scope;

  HiddenMethod method() const {
    return sorted == nullptr ? HiddenMethod::none : sorted->plan.method;
  }
  HiddenLines hidden_lines() const {
    return sorted == nullptr ? HiddenLines::none : sorted->plan.hidden_lines;
  }
};

std::vector<OrderMade> orders_of(const DisplayFile& file) {
  const auto visible = file.visible_segments();
  if (visible.empty()) return {};
  if (file.sorted() != nullptr) return {{file.sorted().get(), HiddenScope::all}};
  std::vector<OrderMade> orders;
  orders.reserve(visible.size());
  for (const Segment* segment : visible) {
    orders.push_back({segment->sorted().get(), HiddenScope::segment});
  }
  return orders;
}

bool is_method_of(const OrderMade& order, HiddenMethod method) {
  const HiddenMethod surfaces = surfaces_of(method);
  return surfaces == HiddenMethod::automatic || surfaces == order.method() ||
         (surfaces == HiddenMethod::back_face && order.method() == HiddenMethod::none);
}

/// Throws Error: setting `what` of the order is `made`, but the options set `asked`.
[[noreturn]] void refuse_for_order(std::string_view what, std::string_view asked,
                                   std::string_view made) {
  throw Error(fmt::format(
      "{} '{}' for a display file that is drawn in the order that it has, of {} '{}': expected {}, "
      "or no {}",
      what, asked, what, made, made, what));
}

/// True if a picture whose aspect ratio is `wider` times its view's is stretched by more than
/// rounding to whole pixels.
bool is_stretched(double wider, const DrawOptions& options) {
  constexpr double kRounded = 0.01;
  return std::abs(wider - 1.0) > kRounded + 1.0 / std::min(options.width, options.height);
}

}  // namespace

const Segment* distorted_by_turning(const DisplayFile& file, int width, int height) {
  if (width == height) return nullptr;
  for (const Segment& segment : file.segments()) {
    if (segment.visible && std::fmod(segment.image.rotation, 180.0) != 0.0) return &segment;
  }
  return nullptr;
}

namespace {

void warn_if_distorted_by_turning(const DisplayFile& file, const DrawOptions& options) {
  const Segment* turned = distorted_by_turning(file, options.width, options.height);
  if (turned == nullptr) return;
  options.warn(
      {DrawWarning::Kind::stretched,
       fmt::format("the image rotation of segment {} distorts it in a picture of {} x {}: "
                   "expected as many pixels in width as in height, or a modelling transformation",
                   turned->name(), options.width, options.height)});
}

/// A window of another shape than its viewport's, in a picture of the shape that was set.
void warn_of_stretched_window(const StretchedWindow& stretched, const DrawOptions& options) {
  if (!is_stretched(stretched.viewport / stretched.window, options)) return;
  options.warn({DrawWarning::Kind::stretched,
                fmt::format("segment {}: a window {:.4g} times as wide as high is stretched to a "
                            "viewport {:.4g} times as wide as high: expected a window of that "
                            "shape, or set_window_fit",
                            stretched.segment, stretched.window, stretched.viewport)});
}

}  // namespace

void warn_if_stretched(const GraphicsSystem& system, const DrawOptions& options) {
  if (!options.warn || system.display_file().segments().empty()) return;
  warn_if_distorted_by_turning(system.display_file(), options);
  if (system.explicit_settings().contains(Setting::window_fit)) return;
  const double shape = static_cast<double>(options.width) / options.height;
  const auto stretched = system.counts().stretched_window;
  if (shape == system.aspect_ratio()) {
    if (stretched) warn_of_stretched_window(*stretched, options);
    return;
  }
  const double meant = stretched ? stretched->window / stretched->viewport : 1.0;
  const double wider = shape / (system.aspect_ratio() * meant);
  if (!is_stretched(wider, options)) return;
  options.warn({DrawWarning::Kind::stretched,
                fmt::format("a picture of {} x {} shows this system {:.3g} times as wide as it was "
                            "viewed: expected set_aspect_ratio({:.4g}) before the first segment",
                            options.width, options.height, wider, shape)});
}

void warn_if_stretched(const View& view, const GraphicsSystem* settings,
                       const DrawOptions& options) {
  const bool is_meant =
      settings != nullptr && settings->explicit_settings().contains(Setting::window_fit);
  if (!options.warn || is_meant) return;
  const double shape = static_cast<double>(options.width) / options.height;
  const double meant = shape * shape_of(view.viewport);
  const double wider = meant / shape_of(view.window);
  if (!is_stretched(wider, options)) return;
  options.warn({DrawWarning::Kind::stretched,
                fmt::format("a picture of {} x {} shows this view {:.3g} times as wide as it is: "
                            "expected a window that is {:.4g} times as wide as high",
                            options.width, options.height, wider, meant)});
}

namespace {

/// True if no visible segment was sorted.
bool is_in_order_of_entry(const DisplayFile& drawn) {
  return drawn.sorted() == nullptr &&
         std::ranges::none_of(drawn.segments(), [](const Segment& segment) {
           return segment.visible && segment.sorted() != nullptr;
         });
}

/// A ROUNDOFF affects the lines drawn over the map's pieces, not the pieces themselves.
bool is_map_without_lines(const DisplayFile& drawn) {
  const auto& sorted = drawn.sorted();
  return sorted != nullptr && sorted->plan.method == HiddenMethod::map &&
         std::ranges::none_of(sorted->parts,
                              [](const auto& part) { return part->scene->has_lines(); });
}

/// The reason why a ROUNDOFF has no effect; empty if it has one.
std::string why_nothing_rounds(HiddenMethod method, const DisplayFile& drawn, FoundBy by) {
  const std::string_view name = name_of(method);
  if (is_image_space(method)) {
    if (by == FoundBy::method) return "";
    return by == FoundBy::device
               ? "the device finds surfaces by a z-buffer of its own"
               : fmt::format("hidden-surface method '{}' puts nothing in order", name);
  }
  if (is_map_without_lines(drawn)) return "the map is exact, and there are no lines";
  if (is_object_space(method) || !is_in_order_of_entry(drawn)) return "";
  return fmt::format("hidden-surface method '{}' draws in order of entry", name);
}

/// The reason why the scope has no effect; empty if it has one.
std::string why_nothing_has_a_scope(HiddenScope scope, const SurfacePlan& plan, HiddenMethod method,
                                    const DisplayFile& drawn, FoundBy by) {
  const std::string_view name = name_of(plan.method);
  if (is_image_space(method) || surfaces_of(plan.method) == HiddenMethod::automatic) {
    if (by == FoundBy::nobody && surfaces_of(method) != HiddenMethod::automatic)
      return fmt::format("hidden-surface method '{}' puts nothing in order", name);
    if (scope == HiddenScope::all) return "";
    return fmt::format("hidden-surface method '{}' takes all segments together", name);
  }
  if (is_object_space(method) || !is_in_order_of_entry(drawn)) return "";
  return fmt::format("hidden-surface method '{}' draws in order of entry", name);
}

}  // namespace

std::vector<std::string> options_without_effect(const HiddenSurfaceOptions& set,
                                                const SurfacePlan& plan, HiddenMethod method,
                                                const DisplayFile& drawn, FoundBy by) {
  std::vector<std::string> all;
  if (set.precision && !set.precision->exact) {
    const std::string why = why_nothing_rounds(method, drawn, by);
    if (!why.empty()) {
      all.push_back(fmt::format("precision {} has no effect: {}", word_of(*set.precision), why));
    }
  }
  if (set.scope && drawn.visible_segments().size() > 1) {
    const std::string why = why_nothing_has_a_scope(*set.scope, plan, method, drawn, by);
    if (!why.empty()) {
      all.push_back(fmt::format("scope {} has no effect: {}", name_of(*set.scope), why));
    }
  }
  return all;
}

namespace {

/// Warnings of the application's line settings without effect; set as options, the same are
/// refused.
std::vector<std::string> line_settings_without_effect(const PicturePlan& plan) {
  const bool by_depth = plan.surfaces.line_order == LineOrder::depth;
  const std::string why = by_depth ? why_not_by_depth(plan.method, plan, plan.kind()) : "";
  if (!why.empty()) return {"line order depth has no effect: " + why};
  if (!by_depth && plan.surfaces.line_halo > 0.0) {
    return {"a line halo has no effect: expected line order depth"};
  }
  const bool of_segments = plan.options.surfaces.scope == HiddenScope::segment;
  if (by_depth && of_segments && is_object_space(plan.method)) {
    return {"scope segment has no effect: line order depth takes all segments together"};
  }
  return {};
}

/// The page on which the devices lay out annotation.
AnnotationPage annotation_page(const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  AnnotationPage page{options.width, options.height, kPixelsOfMillimetre};
  if (plan.kind() == PictureKind::raster) {
    if (options.dpi) page.millimetre = *options.dpi / kMillimetresOfInch;
  } else if (options.pens || options.vectors.paper) {
    const Paper paper = options.vectors.paper.value_or(Paper{});
    page.millimetre = 1.0 / fit_on_paper(paper, options.width, options.height).pixel;
  } else if (plan.format->choice.name != ".svg") {
    page.millimetre = kPointsOfMillimetre;
  }
  return page;
}

}  // namespace

void warn_of_options_without_effect(const PicturePlan& plan, const DisplayFile& drawn) {
  if (!plan.options.warn) return;
  for (const std::string& text : line_settings_without_effect(plan)) {
    plan.options.warn({DrawWarning::Kind::no_effect, text});
  }
  const bool by_device = plan.kind() == PictureKind::raster && !plan.is_on_first_device();
  for (const std::string& text :
       options_without_effect(plan.options.surfaces, plan.surfaces, plan.method, drawn,
                              by_device ? FoundBy::device : FoundBy::method)) {
    plan.options.warn({DrawWarning::Kind::no_effect, text});
  }
  for (const std::string& text :
       lettering_warnings(plan.options.lettering, drawn, plan.options.pens.has_value())) {
    plan.options.warn({DrawWarning::Kind::no_effect, text});
  }
}

namespace {

template <class Drawn>
void warn_of_annotation_on(const PicturePlan& plan, const Drawn& drawn,
                           const std::optional<std::string>& hidden) {
  for (const std::string& text : annotation_faults(drawn, annotation_page(plan))) {
    plan.options.warn({DrawWarning::Kind::annotation, text});
  }
  if (hidden) plan.options.warn({DrawWarning::Kind::annotation, *hidden});
}

}  // namespace

void warn_of_annotation(const PicturePlan& plan, const DisplayFile& drawn) {
  if (!plan.options.warn) return;
  warn_of_annotation_on(plan, drawn, hidden_anchors(drawn, is_image_space(plan.method)));
}

void warn_of_annotation(const PicturePlan& plan, const ViewedScene& drawn) {
  if (!plan.options.warn) return;
  const HiddenMethod method = surfaces_of(plan.method);
  const bool removes = method != HiddenMethod::none && method != HiddenMethod::back_face;
  warn_of_annotation_on(plan, drawn, removes ? hidden_anchors(drawn) : std::nullopt);
}

namespace {

/// True if a picture with several samples a pixel takes hardly more memory than one without: the
/// device draws a few rows at a time, and the method holds no more.
bool holds_few_rows(const PicturePlan& plan) {
  return plan.device->draw_rows != nullptr && !is_plain_z_buffer(plan.surfaces.method);
}

}  // namespace

std::size_t bytes_of_samples(const PicturePlan& plan, int samples) {
  constexpr std::size_t kBytesOfSample = 8;  // a colour or a fill, and a depth
  if (plan.kind() == PictureKind::vector || holds_few_rows(plan)) return 0;
  const auto along = static_cast<std::size_t>(samples);
  return kBytesOfSample * along * along * static_cast<std::size_t>(plan.options.width) *
         static_cast<std::size_t>(plan.options.height);
}

bool needs_fewer_samples(std::size_t bytes, const PicturePlan& plan) {
  const std::uint64_t allowed = bytes_allowed();
  return bytes + bytes_of_samples(plan, plan.samples) > allowed &&
         bytes + bytes_of_samples(plan, 1) <= allowed;
}

void throw_needs_fewer_samples(std::size_t bytes, const PicturePlan& plan,
                               const std::string& what) {
  throw LimitReached(
      fmt::format("out of memory: {} needs at least {} bytes with {} x {} samples a pixel, and the "
                  "limit is {}: expected fewer, such as --samples 1",
                  what, bytes + bytes_of_samples(plan, plan.samples), plan.samples, plan.samples,
                  bytes_allowed()));
}

WorkDone drawing_work(const PicturePlan& plan) {
  if (plan.kind() == PictureKind::vector) {
    return {"the drawing",
            "pixels by hidden-surface method z-buffer, or by scan-line-z in little memory"};
  }
  if (plan.samples > 1) {
    return {"the drawing",
            "fewer samples a pixel, such as --samples 1, a smaller picture or hidden-surface "
            "method z-buffer, scan-line-z in little memory"};
  }
  return {"the drawing",
          "a smaller picture or hidden-surface method z-buffer, scan-line-z in little memory"};
}

void require_order_as_it_is(const DisplayFile& display_file, const DrawOptions& options) {
  for (const OrderMade& order : orders_of(display_file)) {
    const HiddenSurfaceOptions& set = options.surfaces;
    if (set.method && !is_method_of(order, *set.method)) {
      refuse_for_order("hidden-surface method", name_of(*set.method), name_of(order.method()));
    }
    if (set.hidden_lines && *set.hidden_lines != order.hidden_lines()) {
      refuse_for_order("hidden lines", name_of(*set.hidden_lines), name_of(order.hidden_lines()));
    }
    const LineOrder lines =
        order.sorted == nullptr ? LineOrder::entry : order.sorted->plan.line_order;
    if (set.line_order && *set.line_order != lines) {
      refuse_for_order("line order", name_of(*set.line_order), name_of(lines));
    }
    if (order.sorted == nullptr) continue;
    const Precision made = order.sorted->plan.precision;
    if (set.precision && !(*set.precision == made)) {
      refuse_for_order("precision", word_of(*set.precision), word_of(made));
    }
    const bool of_several = display_file.visible_segments().size() > 1;
    if (set.scope && of_several && *set.scope != order.scope) {
      refuse_for_order("scope", name_of(*set.scope), name_of(order.scope));
    }
  }
}

void require_drawn_by_rays(const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (!options.surfaces.method) return;
  const HiddenMethod method = surfaces_of(*options.surfaces.method);
  if (method == HiddenMethod::automatic || method == HiddenMethod::world_ray_cast) return;
  const bool by_rays = plan.kind() == PictureKind::raster && plan.is_on_first_device();
  if (!by_rays && (is_image_space(method) || method == HiddenMethod::map)) return;
  throw Error(fmt::format(
      "hidden-surface method '{}' for a view into which rays are cast: expected world-ray-cast, {}"
      "auto, or no method",
      name_of(*options.surfaces.method), by_rays ? "" : "map, a method of image space, "));
}

void require_writable(const PicturePlan& plan) {
  output_to(*plan.to);
  if (!plan.options.ids.empty()) output_to(plan.options.ids);
  if (!plan.options.depth.empty()) output_to(plan.options.depth);
}

}  // namespace displayfile
