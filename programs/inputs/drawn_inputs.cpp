#include "programs/inputs/drawn_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <ostream>
#include <sstream>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/work_budget.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/draw/cropped_figure.h"
#include "interp/draw/nothing_seen.h"
#include "interp/draw/picture_plan.h"
#include "interp/draw/renderer.h"
#include "interp/visibility/image_space.h"
#include "programs/inputs/inputs.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

/// Printed where finding the reason would exceed the limits.
constexpr const char* kNoReason = "finding the reason would exceed the limits";

bool reads_standard_input(std::span<const std::string> inputs) {
  return std::ranges::find(inputs, "-") != inputs.end();
}

/// By a method that views a retained scene, on a device that needs no display file.
bool draws_views(const PicturePlan& plan) {
  const auto method = plan.options.surfaces.method;
  return method && is_image_space(*method) &&
         surfaces_of(*method) != HiddenMethod::world_ray_cast && plan.is_on_first_device();
}

}  // namespace

DrawnInputs::DrawnInputs(std::span<const std::string> inputs, const PicturePlan& call,
                         const MeshWords& meshes, const StartingShading& shading, Use use)
    : inputs_(inputs), plan_(call), meshes_(meshes), shading_(shading) {
  std::optional<HiddenMethod>& method = plan_.options.surfaces.method;
  const bool by_world_rays = method && surfaces_of(*method) == HiddenMethod::world_ray_cast;
  if (!method && are_bare_meshes()) method = HiddenMethod::automatic;
  const bool pictures_alone = !by_world_rays && use == Use::picture;
  if (pictures_alone && are_bare_meshes() && draws_views(plan_)) {
    SystemInside::retain_alone(system_, scene_);
  } else if (by_world_rays || meshes_.scale || (are_programs() && reads_standard_input(inputs_))) {
    system_.retain(&scene_);  // for check_window too, as standard input is read once
  }
  enter(system_);
  SystemInside::retains_alone(system_) ? settle_in_view(plan_, &system_) : settle(plan_, &system_);
}

bool DrawnInputs::are_bare_meshes() const {
  return std::ranges::none_of(inputs_, is_drawing_program);
}

bool DrawnInputs::are_programs() const { return std::ranges::all_of(inputs_, is_drawing_program); }

std::string DrawnInputs::first_name() const {
  return input_name(inputs_.front()) + (inputs_.size() > 1 ? " and others" : "");
}

std::size_t DrawnInputs::polygons() const {
  return SystemInside::retains_alone(system_) ? scene_.size() : system_.display_file().polygons();
}

/// Bare meshes are drawn in one view, in image space, where the scope has no meaning.
std::vector<DrawWarning> DrawnInputs::draw(SortedDisplayFile& kept,
                                           const WorkProgress& progress) const {
  std::vector<DrawWarning> warned;
  PicturePlan plan = plan_;
  plan.surfaces.progress = progress;
  plan.options.warn = [&](const DrawWarning& warning) { warned.push_back(warning); };
  if (SystemInside::retains_alone(system_)) {
    displayfile::draw(in_view(system_, scene_.segments().front().view), plan);
  } else {
    displayfile::draw(system_, plan, kept);
  }
  return warned;
}

void DrawnInputs::enter(GraphicsSystem& system) const {
  const DrawOptions& options = plan_.options;
  system.set_threads(options.surfaces.threads);
  shading_.start(system);
  const double aspect = static_cast<double>(options.width) / options.height;
  enter_inputs(inputs_, system, meshes_, aspect, options.surfaces);
}

/// The scene is retained for this when the inputs are read again, as standard input cannot be.
std::string DrawnInputs::why_nothing_is_seen() const {
  const DisplayFile& drawn = system_.display_file();
  const SeenIn picture = seen_in(plan_);
  std::ostringstream said_before;
  const CollectedWarnings collected(said_before);
  try {
    if (system_.retained() != nullptr) {
      return displayfile::why_nothing_is_seen(*system_.retained(), drawn, picture);
    }
    if (reads_standard_input(inputs_)) {
      return displayfile::why_nothing_is_seen(drawn, picture);
    }
    RetainedScene scene;
    GraphicsSystem again;
    again.retain(&scene);
    enter(again);
    return displayfile::why_nothing_is_seen(scene, drawn, picture);
  } catch (const LimitReached&) {  // the picture is there
    return kNoReason;
  } catch (const std::bad_alloc&) {
    return kNoReason;
  }
}

void DrawnInputs::check_window() const {
  const bool is_set = system_.explicit_settings().contains(Setting::window);
  if (SystemInside::retains_alone(system_) || SystemInside::is_all_in_view(system_) ||
      !(meshes_.scale || (are_programs() && !is_set)))
    return;
  const auto cropped = [&] {
    if (system_.retained() != nullptr) {
      return cropped_figure(*system_.retained(), system_.display_file());
    }
    std::ostringstream warned_before;
    const CollectedWarnings collected(warned_before);
    RetainedScene scene;
    GraphicsSystem again;
    again.retain(&scene);
    enter(again);
    return cropped_figure(scene, again.display_file());
  };
  const CroppedFigure figure = cropped();
  if (figure.beyond == 0) return;
  const std::string beyond =
      fmt::format("{}: {} of {} polygons, lines and annotations reach beyond", first_name(),
                  figure.beyond, figure.all);
  if (!meshes_.scale) {
    const Rectangle window = system_.view().window;
    warnings() << fmt::format(
        "{} the window {:.6g} {:.6g} {:.6g} {:.6g}, which no set-window sets: --fit each fits it\n",
        beyond, window.x_min, window.x_max, window.y_min, window.y_max);
    return;
  }
  const std::string paper = fmt::format("{} the picture at {}", beyond, meshes_.scale->name);
  if (!is_set) {
    throw Error(paper + ": expected a smaller scale, or larger paper");
  }
  warnings() << paper << '\n';
}

bool DrawnInputs::warn_if_nothing_is_seen(const std::vector<DrawWarning>& warned) const {
  const bool is_empty = std::ranges::any_of(warned, [](const DrawWarning& warning) {
    return warning.kind == DrawWarning::Kind::nothing_seen;
  });
  if (!is_empty) return false;
  const std::string why = why_nothing_is_seen();
  warnings() << fmt::format("{}: nothing is seen: {}\n", first_name(), why);
  return true;
}

}  // namespace displayfile
