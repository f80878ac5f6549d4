#include "programs/inputs/drawn_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <ostream>
#include <sstream>

#include "clip/base/input_file.h"
#include "clip/base/work_budget.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/draw/nothing_seen.h"
#include "interp/draw/picture_plan.h"
#include "interp/draw/renderer.h"
#include "interp/visibility/image_space.h"
#include "programs/inputs/inputs.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

/// What is said where it would take more to know more.
constexpr const char* kNoReason = "finding the reason would exceed the limits";

/// By a method that views a retained scene, on a device that needs no display file.
bool draws_views(const DrawOptions& options) {
  return options.surfaces.method && is_image_space(*options.surfaces.method) &&
         surfaces_of(*options.surfaces.method) != HiddenMethod::world_ray_cast &&
         options.device == raster_devices().front().name;
}

}  // namespace

DrawnInputs::DrawnInputs(std::span<const std::string> inputs, const DrawOptions& options,
                         const MeshWords& meshes, const StartingShading& shading, Use use)
    : inputs_(inputs), options_(options), meshes_(meshes), shading_(shading) {
  if (!options_.surfaces.method && are_bare_meshes())
    options_.surfaces.method = HiddenMethod::automatic;
  if (options.surfaces.method &&
      surfaces_of(*options.surfaces.method) == HiddenMethod::world_ray_cast) {
    system_.retain(&scene_);
  } else if (use == Use::picture && are_bare_meshes() && draws_views(options_)) {
    SystemInside::retain_alone(system_, scene_);
  }
  enter(system_);
}

bool DrawnInputs::are_bare_meshes() const {
  return std::ranges::none_of(inputs_, is_drawing_program);
}

std::size_t DrawnInputs::polygons() const {
  return SystemInside::retains_alone(system_) ? scene_.size() : system_.display_file().polygons();
}

/// Bare meshes are drawn in one view, in image space, where the scope has no meaning.
std::vector<DrawWarning> DrawnInputs::draw(const std::filesystem::path& file,
                                           SortedDisplayFile& kept,
                                           const WorkProgress& progress) const {
  std::vector<DrawWarning> warned;
  DrawOptions options = options_;
  options.surfaces.progress = progress;
  options.warn = [&](const DrawWarning& warning) { warned.push_back(warning); };
  if (!SystemInside::retains_alone(system_)) {
    displayfile::draw(system_, file, options, kept);
    return warned;
  }
  Renderer renderer;
  renderer.draw(in_view(system_, scene_.segments().front().view), file, options);
  return warned;
}

void DrawnInputs::enter(GraphicsSystem& system) const {
  system.set_threads(options_.surfaces.threads);
  shading_.start(system);
  const double aspect = static_cast<double>(options_.width) / options_.height;
  enter_inputs(inputs_, system, meshes_, aspect, options_.surfaces);
}

/// What they drew is retained for that when they are read once more, as standard input cannot be.
std::string DrawnInputs::why_nothing_is_seen(PictureKind kind) const {
  const DisplayFile& drawn = system_.display_file();
  const SeenIn picture =
      kind == PictureKind::raster ? seen_in(resolve(system_, options_)) : SeenIn{};
  std::ostringstream said_before;
  const CollectedWarnings collected(said_before);
  try {
    if (system_.retained() != nullptr) {
      return displayfile::why_nothing_is_seen(*system_.retained(), drawn, picture);
    }
    if (std::ranges::find(inputs_, "-") != inputs_.end()) {
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

bool DrawnInputs::warn_if_nothing_is_seen(const std::vector<DrawWarning>& warned,
                                          PictureKind kind) const {
  const bool is_empty = std::ranges::any_of(warned, [](const DrawWarning& warning) {
    return warning.kind == DrawWarning::Kind::nothing_seen;
  });
  if (!is_empty) return false;
  const std::string why = why_nothing_is_seen(kind);
  warnings() << fmt::format("{}{}: nothing is seen: {}\n", input_name(inputs_.front()),
                            inputs_.size() > 1 ? " and others" : "", why);
  return true;
}

}  // namespace displayfile
