#include "interp/draw/draw.h"

#include <algorithm>
#include <string_view>

#include "displayfile/user_routines/system_inside.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_plan.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

PictureKind picture_kind(const Destination& to, const DrawOptions& options) {
  return !format_of(to, options).is_of_pixels() ? PictureKind::vector : PictureKind::raster;
}

HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  return drawing_choice(system, options, kind).method;
}

namespace {

/// The reason for a method that `automatic` did not choose.
std::string_view reason_of_method(const GraphicsSystem& system, const DrawOptions& options) {
  if (options.surfaces.method || system.hidden_surfaces().z_buffer ||
      system.hidden_surfaces().removal)
    return "as set";
  const auto& segments = system.display_file().segments();
  const bool some_sorted = std::any_of(segments.begin(), segments.end(),
                                       [](const Segment& s) { return s.sorted() != nullptr; });
  if (some_sorted) {
    return "hidden-line removal is off now; segments stay as they were sorted when they were "
           "closed";
  }
  const ExplicitSettings& set = system.explicit_settings();
  const bool is_set =
      set.contains(Setting::hidden_line_removal) || set.contains(Setting::hidden_method);
  return is_set ? "hidden-line removal is off"
                : "all points have one depth: the order of entry holds";
}

}  // namespace

MethodChoice drawing_choice(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  PicturePlan plan{.options = options, .device = &first_device()};
  plan.surfaces = surfaces_of_picture(system, options.surfaces);
  return choice_for(system, plan, kind);
}

MethodChoice choice_for(const GraphicsSystem& system, const PicturePlan& plan, PictureKind kind) {
  const DrawOptions& options = plan.options;
  const HiddenMethod method = plan.surfaces.method;
  if (surfaces_of(method) != HiddenMethod::automatic) {
    return {method, reason_of_method(system, options)};
  }
  if (options.pens && !options.pens->hatching && !is_colour_rule(method)) {
    return {HiddenMethod::franklin, "for pens: visible lines only"};
  }
  if (options.pens && !is_colour_rule(method)) {
    return {HiddenMethod::map, "for pens: visible fills are hatched"};
  }
  std::optional<Background> background = options.background.value_or(system.looks().background);
  if (!options.ids.empty() || !options.depth.empty()) background.reset();  // need fills
  if (is_colour_rule(method)) background.reset();                          // fills hide lines
  MethodChoice chosen = choose_method(system.display_file(), kind, background);
  const bool by_depth = plan.surfaces.line_order == LineOrder::depth;
  if (by_depth && chosen.method == HiddenMethod::none) {
    chosen = {HiddenMethod::franklin, "lines in order of depth, and no fills: visible lines only"};
  }
  if (is_colour_rule(method)) chosen.method = colour_rule_by(chosen.method);
  return chosen;
}

void require_format(const Destination& to, const DrawOptions& options) { resolve(options, &to); }

void require_drawable(const Destination& to, const DrawOptions& options) {
  require_writable(resolve(options, &to));
}

}  // namespace displayfile
