#pragma once

#include <optional>
#include <string>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// A sentence that names the leaders and balloons whose point of the model is hidden
/// (interp/text/seen_points.h) by something nearer by more than a hundredth of the figure's depth,
/// so that points of round surfaces may be behind their facets. They are drawn as if it were seen.
/// None if there are none, and where hidden surfaces are not removed. `by_depth`: an image-space
/// method removes them.
std::optional<std::string> hidden_anchors(const DisplayFile& display_file, bool by_depth);

/// The same for a scene whose hidden surfaces are removed.
std::optional<std::string> hidden_anchors(const ViewedScene& scene);

}  // namespace displayfile
