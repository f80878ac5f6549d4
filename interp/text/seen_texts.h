#pragma once

#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// The texts of the visible segments that are to be drawn, after all else and in order of entry.
/// Where hidden surfaces are removed, those whose anchor is hidden (interp/text/seen_points.h) are
/// left out, unless their style makes them always visible. `by_depth`: an image-space method
/// removes hidden surfaces; otherwise they are removed where the display file is sorted: by the
/// fills of all visible segments, or, in a segment sorted by itself, by its own.
std::vector<DeviceText> seen_texts(const DisplayFile& display_file, bool by_depth);

/// The same for a scene whose hidden surfaces are removed.
std::vector<DeviceText> seen_texts(const ViewedScene& scene);

}  // namespace displayfile
