#include "interp/draw/turntable_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/work_budget.h"
#include "displayfile/views/taken_scene.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_plan.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

HiddenMethod surfaces_of_options(const DrawOptions& options) {
  return surfaces_of(options.surfaces.method.value_or(HiddenMethod::automatic));
}

Turntable turntable_of(const TakenScene& taken, const View& otherwise,
                       const TurntableViews& views) {
  Turntable turntable(taken.scene(), taken.attributes(), otherwise);
  if (views.axis) turntable.set_axis(*views.axis);
  if (views.fit_window) turntable.fit_window(views.number);
  return turntable;
}

/// Sets one BSP tree for all views, where no method is set.
DrawOptions by_tree(DrawOptions options) {
  const HiddenMethod method = options.surfaces.method.value_or(HiddenMethod::automatic);
  if (surfaces_of(method) != HiddenMethod::automatic) return options;
  options.surfaces.method =
      is_colour_rule(method) ? colour_rule_by(HiddenMethod::bsp) : HiddenMethod::bsp;
  return options;
}

}  // namespace

/// The settings that apply to views are included.
DrawOptions options_of_views(const GraphicsSystem& system, const DrawOptions& given) {
  const PicturePlan plan = resolve(system, given);
  const HiddenMethod method = plan.surfaces.method;
  DrawOptions options = plan.without_system();
  options.surfaces.method = given.surfaces.method;
  options.surfaces.scope = given.surfaces.scope;
  if (finds_lines(method) && !options.surfaces.scope) {
    const auto usual = given.surfaces.method ? HiddenScope::all : HiddenScope::segment;
    options.surfaces.scope = system.hidden_surfaces().scope.value_or(usual);
  }
  if (finds_lines(method) || is_colour_rule(method)) {
    options.surfaces.method = method;
    require_turntable_method(options);
  }
  if (!options.surfaces.scope &&
      !(options.surfaces.method && is_image_space(*options.surfaces.method))) {
    options.surfaces.scope = system.hidden_surfaces().scope.value_or(HiddenScope::all);
  }
  require_hidden_lines_drawn(*options.surfaces.hidden_lines,
                             options.surfaces.method.value_or(HiddenMethod::bsp), plan);
  return options;
}

void require_turntable_views(int number) {
  if (number >= 1 && number <= TurntableViews::kMost) return;
  throw Error(
      fmt::format("a turntable of {} views: expected 1 to {}", number, TurntableViews::kMost));
}

void require_turntable_method(const DrawOptions& options) {
  const HiddenMethod method = surfaces_of_options(options);
  if (options.pens) require_drawn_by_pens(method, *options.pens);
  if (method != HiddenMethod::automatic && is_image_space(method)) require_scope_of_view(options);
  if (method == HiddenMethod::bsp || is_image_space(method)) return;
  if (finds_lines(method)) return require_drawable_by(method, resolve(options));
  throw Error(fmt::format(
      "a turntable's views are drawn from one BSP tree, by rays from one tree of boxes, "
      "or by a method that works in image space or finds lines, not by {}: expected "
      "bsp, z-buffer or another of those, or no method",
      name_of(method)));
}

std::filesystem::path numbered(const std::filesystem::path& file, int number, int views) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(views - 1).size());
  const std::string name =
      fmt::format("{}-{:0{}}{}", file.stem().string(), number, digits, file.extension().string());
  return file.parent_path() / name;
}

namespace {

/// The options with the output paths of one view.
DrawOptions of_view(DrawOptions options, int number, int views) {
  if (!options.ids.empty()) options.ids = numbered(options.ids, number, views).string();
  if (!options.depth.empty()) options.depth = numbered(options.depth, number, views).string();
  return options;
}

}  // namespace

void require_views_drawable(const TurntableViews& views, const std::filesystem::path& file,
                            const DrawOptions& options) {
  picture_kind(file, options);  // an error for an unknown extension names the file as given
  for (int k = views.first; k < views.end; ++k) {
    require_drawable(numbered(file, k, views.number), of_view(options, k, views.number));
  }
}

struct TurntableRenderer::Kept {
  TakenScene taken;
  View otherwise;
  TurntableViews turned;
  Turntable turntable;
  DrawOptions options;
  bool is_stretch_set;  // by the application
  Renderer renderer = {};
  Turntable::Turn turn = {};           // of the view drawn last
  std::vector<std::string> told = {};  // warnings given that apply to all views
  int told_of_annotation = -1;         // the view of which annotation was warned of

  /// Options of one view: a warning that applies to all views is given once, and those of
  /// annotation, which differ from view to view, for the first view that has some.
  DrawOptions of_one(const DrawOptions& all, int view) {
    DrawOptions one = by_tree(all);
    if (!one.warn) return one;
    one.warn = [this, view, warn = one.warn](const DrawWarning& warning) {
      const bool is_stretched = warning.kind == DrawWarning::Kind::stretched;
      if (is_stretched && is_stretch_set) return;
      if (warning.kind == DrawWarning::Kind::annotation) {
        if (told_of_annotation < 0) told_of_annotation = view;
        if (told_of_annotation != view) return;
      }
      if (is_stretched || warning.kind == DrawWarning::Kind::no_effect) {
        if (std::ranges::find(told, warning.text) != told.end()) return;
        told.push_back(warning.text);
      }
      warn(warning);
    };
    return one;
  }

  void bring_up_to_date() {
    if (taken.is_same()) return;
    turntable = turntable_of(taken, otherwise, turned);
    taken.take();
  }

  InView in_view(int view) {
    if (view < 0 || view >= turned.number) {
      throw Error(fmt::format("view {}: expected 0 to {}", view, turned.number - 1));
    }
    const BudgetInForce in_force(options.surfaces.budget);
    bring_up_to_date();
    turn = turntable.at(360.0 * view / turned.number);
    return {taken.scene(), taken.attributes(), turn.view, &turn.lights};
  }
};

TurntableRenderer::TurntableRenderer(const GraphicsSystem& system, const RetainedScene& scene,
                                     const DisplayFile& display_file, const TurntableViews& views,
                                     const DrawOptions& options) {
  require_turntable_views(views.number);
  require_turntable_method(options);
  const BudgetInForce in_force(options.surfaces.budget);
  const DrawOptions settled = options_of_views(system, options);
  TakenScene taken(scene, display_file);
  Turntable turntable = turntable_of(taken, system.view(), views);
  taken.take();
  kept_ = std::make_unique<Kept>(Kept{std::move(taken), system.view(), views, std::move(turntable),
                                      settled,
                                      system.explicit_settings().contains(Setting::window_fit)});
}
TurntableRenderer::TurntableRenderer(TurntableRenderer&& other) noexcept = default;
TurntableRenderer& TurntableRenderer::operator=(TurntableRenderer&& other) noexcept = default;
TurntableRenderer::~TurntableRenderer() = default;

int TurntableRenderer::views() const { return kept_->turned.number; }
const DrawOptions& TurntableRenderer::options() const { return kept_->options; }
const Renderer& TurntableRenderer::renderer() const { return kept_->renderer; }

Picture TurntableRenderer::draw(int view) {
  kept_->renderer.draw(kept_->in_view(view), kept_->of_one(kept_->options, view));
  return kept_->renderer.take_picture();
}

void TurntableRenderer::draw(int view, const Destination& to) {
  kept_->renderer.draw(kept_->in_view(view), to, kept_->of_one(kept_->options, view));
}

std::filesystem::path TurntableRenderer::draw_numbered(int view,
                                                       const std::filesystem::path& file) {
  std::filesystem::path name = numbered(file, view, views());
  kept_->renderer.draw(kept_->in_view(view), name,
                       kept_->of_one(of_view(kept_->options, view, views()), view));
  return name;
}

void TurntableRenderer::give_back(Picture picture) {
  kept_->renderer.give_back(std::move(picture));
}

}  // namespace displayfile
