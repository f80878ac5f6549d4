#include "interp/draw/picture_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_source.h"
#include "interp/raster/antialias.h"

namespace displayfile {

namespace {

/// Checks numbers that are the same for a file and in memory; throws Error.
void require_numbers(const DrawOptions& options) {
  if (options.surfaces.threads < 1) {
    throw Error(fmt::format("{} threads: expected 1 or more", options.surfaces.threads));
  }
  const int samples = options.samples.value_or(1);
  if (samples < 1 || samples > kMostSamples) {
    throw Error(
        fmt::format("{} samples along a pixel's side: expected 1 to {}", samples, kMostSamples));
  }
  if (options.surfaces.line_halo) require_line_halo(*options.surfaces.line_halo);
  require_vector_options(options.vectors);
  require_lettering(options.lettering);
  if (options.pens && !options.lettering.font.empty() && !options.lettering.is_of_paths()) {
    throw Error(fmt::format("font {} for pens: expected hershey, or texts as outlines",
                            options.lettering.font));
  }
  if (options.dpi && !(*options.dpi >= 1.0 && *options.dpi <= kHighestDensity)) {
    throw Error(fmt::format("{} dpi: expected 1 to {}", *options.dpi, kHighestDensity));
  }
  require_picture_size(options.width, options.height);
  if (const auto& rows = options.rows;
      rows && (rows->first < 0 || rows->end <= rows->first || rows->end > options.height)) {
    throw Error(fmt::format("rows {} up to {}: expected rows within the picture's {}", rows->first,
                            rows->end, options.height));
  }
  const int most = kLargestSide / samples;
  if (options.width <= most && options.height <= most) return;
  throw Error(
      fmt::format("picture size {}x{} with {} x {} samples a pixel: expected 1x1 to {}x{} pixels",
                  options.width, options.height, samples, samples, most, most));
}

/// Throws Error for a density with a format that has none, and for rows, ids or depth of a sheet of
/// paper in pixels.
void require_density(const Destination& to, const PictureFormat& format,
                     const DrawOptions& options) {
  if (!options.dpi) return;
  if (!format.has_density()) {
    throw Error(fmt::format("{}: {} files have no dpi: expected {}", to.name(), format.choice.name,
                            names_of_formats(&PictureFormat::has_density, " or ")));
  }
  if (!options.vectors.paper) return;
  if (options.rows || !options.ids.empty() || !options.depth.empty()) {
    throw Error(fmt::format(
        "{}: a sheet of paper in pixels has no rows, ids or depth: expected no paper", to.name()));
  }
}

/// Throws Error for pens with a format that has none, and for paper with pixels of unknown density.
void require_paper_and_pens(const Destination& to, const PictureFormat& format,
                            const DrawOptions& options) {
  if (options.pens && !format.is_for_pens()) {
    throw Error(fmt::format("{}: {} files are not for pens: expected one of {}", to.name(),
                            format.choice.name,
                            names_of_formats(&PictureFormat::is_for_pens, " ")));
  }
  if (!options.pens && !format.is_for_areas()) {
    throw Error(fmt::format("{}: {} files are lines for pens: expected pens, or one of {}",
                            to.name(), format.choice.name,
                            names_of_formats(&PictureFormat::is_for_areas, " ")));
  }
  if (!options.vectors.paper && !options.pens) return;
  if (!format.is_for_paper() && !options.dpi) {
    const bool needs_dpi = format.has_density();
    throw Error(fmt::format("{}: {} files have no size on paper{}: expected {}one of {}", to.name(),
                            format.choice.name, needs_dpi ? " without dpi" : "",
                            needs_dpi ? "dpi, or " : "",
                            names_of_formats(&PictureFormat::is_for_paper, " ")));
  }
  fit_on_paper(options.vectors.paper.value_or(Paper{}), options.width, options.height);
  if (options.pens) require_pens(*options.pens);
}

/// Throws Error for names and layers with formats that do not have them.
void require_names(const Destination& to, const PictureFormat& format, const DrawOptions& options) {
  const auto refuse = [&](const char* what, bool (PictureFormat::*which)() const) {
    throw Error(fmt::format("{}: {} files have no {}: expected {}", to.name(), format.choice.name,
                            what, names_of_formats(which, " or ")));
  };
  const VectorOptions& vectors = options.vectors;
  if (options.pens && !options.pens->layers.empty() && !format.has_pen_layers()) {
    refuse("layers of pens", &PictureFormat::has_pen_layers);
  }
  if (!vectors.id_prefix.empty() && !format.has_ids()) {
    refuse("ids, which a prefix could be of", &PictureFormat::has_ids);
  }
  if (vectors.is_inline && !format.has_ids()) {
    refuse("XML declaration to be left out inline", &PictureFormat::has_ids);
  }
  if (!vectors.layers) return;
  if (!format.has_layers()) refuse("layers", &PictureFormat::has_layers);
  if (options.pens) {
    throw Error(fmt::format(
        "{}: a drawing for pens has a layer for each pen: expected no layers of segments",
        to.name()));
  }
}

/// Throws Error for options that the format does not support.
void require_format(const Destination& to, const PicturePlan& plan) {
  const PictureFormat& format = *plan.format;
  if (!format.is_of_pixels() && !plan.is_on_first_device()) {
    throw Error(fmt::format("{}: the {} device draws pixels: expected {}", to.name(),
                            plan.device->choice.name,
                            names_of_formats(&PictureFormat::is_of_pixels, " or ")));
  }
  if (plan.options.rows && !format.is_of_pixels()) {
    throw Error(fmt::format("{}: vectors have no rows: expected {}", to.name(),
                            names_of_formats(&PictureFormat::is_of_pixels, " or ")));
  }
  require_density(to, format, plan.options);
  require_paper_and_pens(to, format, plan.options);
  require_names(to, format, plan.options);
}

/// The sheet of paper in pixels, if a file of pixels is to be one.
std::optional<PixelPage> page_of(const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (!options.vectors.paper || !options.dpi || plan.kind() != PictureKind::raster) {
    return std::nullopt;
  }
  const PaperFit fit = fit_on_paper(*options.vectors.paper, options.width, options.height);
  const auto pixels = [&](double millimetres) {
    return static_cast<int>(std::lround(millimetres / fit.pixel));
  };
  const int width = std::max(pixels(fit.width), options.width);
  const int height = std::max(pixels(fit.height), options.height);
  require_picture_size(width, height);
  return PixelPage{width, height, (width - options.width) / 2, (height - options.height) / 2};
}

}  // namespace

DrawOptions PicturePlan::without_system() const {
  DrawOptions settled = options;
  settled.surfaces.method = surfaces.method;
  settled.surfaces.scope.reset();
  settled.surfaces.precision = surfaces.precision;
  settled.surfaces.hidden_lines = surfaces.hidden_lines;
  settled.surfaces.line_order = surfaces.line_order;
  const bool by_depth = surfaces.line_order == LineOrder::depth;
  settled.surfaces.line_halo = by_depth ? surfaces.line_halo : 0.0;
  return settled;
}

namespace {

/// Only BSP trees have roots.
void require_root(const PicturePlan& plan) {
  const HiddenMethod method = plan.surfaces.method;
  if (plan.surfaces.root == RootChoice::free || surfaces_of(method) == HiddenMethod::bsp) return;
  throw Error(
      fmt::format("a root of a BSP tree is set, and the hidden-surface method is {}: "
                  "expected bsp, or no root",
                  name_of(method)));
}

/// Sets the size of the picture in which lines overlap; a halo is part of an order by depth.
void set_line_picture(PicturePlan& plan) {
  plan.surfaces.width = plan.options.width;
  plan.surfaces.height = plan.options.height;
  const bool is_set = plan.options.surfaces.line_halo.value_or(0.0) > 0.0;
  if (!is_set || plan.surfaces.line_order == LineOrder::depth) return;
  throw Error(fmt::format("a line halo of {} pixels in line order entry: expected line order depth",
                          plan.surfaces.line_halo));
}

/// The samples per pixel side, once the method is known. Only samples set by the options can be
/// refused.
int samples_in_force(const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (plan.kind() == PictureKind::vector) return 1;
  if (options.samples) return *options.samples;
  if (bytes_of_samples(plan, 1) > 0) return 1;
  return std::min(kUsualSamples, kLargestSide / std::max(options.width, options.height));
}

void require_background(const PicturePlan& plan) {
  if (plan.format == nullptr || plan.format->can_be_transparent()) return;
  if (has_background(plan.options)) return;
  throw Error(fmt::format("{}: {} files have no alpha: expected a background, or one of {}",
                          plan.to->name(), plan.format->choice.name,
                          names_of_formats(&PictureFormat::can_be_transparent, " ")));
}

/// Completes the plan once its surface plan is set.
void finish(PicturePlan& plan) {
  require_background(plan);
  require_root(plan);
  set_line_picture(plan);
  plan.samples = samples_in_force(plan);
  plan.method = plan.surfaces.method;
}

}  // namespace

PicturePlan resolve_call(const DrawOptions& options, const Destination* to) {
  const PictureFormat* const format = to == nullptr ? nullptr : &format_of(*to, options);
  require_numbers(options);
  PicturePlan plan{
      .options = options, .to = to, .device = &device_of(options.device), .format = format};
  if (plan.options.dpi && plan.options.vectors.paper) {
    plan.options.vectors.paper->pixel = kMillimetresOfInch / *plan.options.dpi;
  }
  if (to != nullptr) {
    require_format(*to, plan);
    plan.page = page_of(plan);
  } else if (!options.format.empty()) {
    format_named(options.format);
  }
  return plan;
}

namespace {

bool has_one_depth(const DisplayFile& file) {
  std::optional<double> depth;
  for (const Segment* const segment : file.visible_segments()) {
    const Instructions& entered = *segment->entered();
    if (entered.points() == 0) continue;
    if (entered.stores_z()) return false;
    if (depth.value_or(entered.flat_depth()) != entered.flat_depth()) return false;
    depth = entered.flat_depth();
  }
  return true;
}

bool sets_nothing_of_surfaces(const GraphicsSystem& system) {
  return !system.hidden_surfaces().z_buffer && !system.hidden_surfaces().removal &&
         !system.explicit_settings().contains(Setting::hidden_line_removal) &&
         !system.explicit_settings().contains(Setting::hidden_method);
}

}  // namespace

SurfacePlan surfaces_of_picture(const GraphicsSystem& system, const HiddenSurfaceOptions& options) {
  SurfacePlan plan = resolve_surfaces(system, options);
  if (options.method || !sets_nothing_of_surfaces(system)) return plan;
  const bool by_depth = plan.line_order == LineOrder::depth;
  if (by_depth || !has_one_depth(system.display_file())) plan.method = HiddenMethod::automatic;
  return plan;
}

namespace {

/// Takes all settings except the choice of a method for `automatic`.
void take_settings(PicturePlan& plan, const GraphicsSystem* system) {
  if (system == nullptr) {
    plan.surfaces = resolve_surfaces(plan.options.surfaces);
    return finish(plan);
  }
  if (!plan.options.background) plan.options.background = system->looks().background;
  plan.surfaces = surfaces_of_picture(*system, plan.options.surfaces);
  finish(plan);
  plan.surfaces.shadows = plan.kind() == PictureKind::vector;
}

}  // namespace

void settle(PicturePlan& plan, const GraphicsSystem* system) {
  take_settings(plan, system);
  if (system == nullptr) return;
  const NamedWork named(drawing_work(plan));
  plan.choice = choice_for(*system, plan, plan.kind());
  // For pixels the renderer chooses the method.
  if (plan.kind() == PictureKind::vector) plan.method = plan.choice.method;
}

void settle_in_view(PicturePlan& plan, const GraphicsSystem* system) {
  take_settings(plan, system);
  SurfacePlan& surfaces = plan.surfaces;
  const bool is_applications = system != nullptr && !plan.options.surfaces.method;
  if (!surfaces.scope) surfaces.scope = is_applications ? HiddenScope::segment : HiddenScope::all;
  if (plan.options.pens && plan.method == HiddenMethod::automatic) {
    plan.method = plan.options.pens->hatching ? HiddenMethod::map : HiddenMethod::franklin;
  }
}

PicturePlan resolve(const DrawOptions& options, const Destination* to) {
  PicturePlan plan = resolve_call(options, to);
  settle(plan, nullptr);
  return plan;
}

PicturePlan resolve(const GraphicsSystem& system, const DrawOptions& options,
                    const Destination* to) {
  PicturePlan plan = resolve_call(options, to);
  settle(plan, &system);
  return plan;
}

PicturePlan resolve_in_view(const GraphicsSystem* system, const DrawOptions& options,
                            const Destination* to) {
  PicturePlan plan = resolve_call(options, to);
  settle_in_view(plan, system);
  return plan;
}

}  // namespace displayfile
