#include "programs/drawn_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "displayfile/input_file.h"
#include "displayfile/nothing_seen.h"
#include "programs/inputs.h"
#include "programs/warnings.h"

namespace displayfile {

DrawnInputs::DrawnInputs(std::span<const std::string> inputs, const DrawOptions& options,
                         const MeshWords& meshes, Shading shading)
    : inputs_(inputs), options_(options), meshes_(meshes), shading_(shading) {
  if (options.hidden == HiddenMethod::world_ray_cast) system_.retain(&scene_);
  enter(system_);
  if (!options_.hidden && std::ranges::none_of(inputs, is_drawing_program)) {
    options_.hidden = HiddenMethod::automatic;
  }
}

void DrawnInputs::enter(GraphicsSystem& system) const {
  system.set_threads(options_.threads);
  system.set_shading(shading_);
  enter_inputs(inputs_, system, meshes_, static_cast<double>(options_.width) / options_.height);
}

/// What they drew is retained for that when they are read once more, as standard input cannot be.
std::string DrawnInputs::why_nothing_is_seen() const {
  const DisplayFile& drawn = system_.display_file();
  if (system_.retained() != nullptr) {
    return displayfile::why_nothing_is_seen(*system_.retained(), drawn);
  }
  if (std::ranges::find(inputs_, "-") != inputs_.end()) {
    return "nothing that was entered is inside of the view volume and turned to the viewer";
  }
  std::ostringstream said_before;
  const CollectedWarnings collected(said_before);
  RetainedScene scene;
  GraphicsSystem again;
  again.retain(&scene);
  enter(again);
  return displayfile::why_nothing_is_seen(scene, drawn);
}

void DrawnInputs::warn_if_nothing_is_seen() const {
  if (!nothing_is_seen(system_.display_file())) return;
  const std::string why = why_nothing_is_seen();
  warnings() << fmt::format("{}{}: nothing is seen: {}\n", input_name(inputs_.front()),
                            inputs_.size() > 1 ? " and others" : "", why);
}

}  // namespace displayfile
