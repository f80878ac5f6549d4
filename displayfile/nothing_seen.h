#pragma once

#include <string>

#include "displayfile/display_file.h"
#include "displayfile/retained_scene.h"

namespace displayfile {

/// True if the visible segments hold nothing that shows: nothing is drawn.
bool nothing_is_seen(const DisplayFile& display_file);

/// The same of what the application drew, in the views that it drew in, where that is not in the
/// display file (GraphicsSystem::retain_alone). Looks no further than the first that shows.
bool nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file);

/// Why that is so, from what the application drew, such as "all 6 polygons and lines are behind the
/// eye": the display file is that of the system that retained the scene.
std::string why_nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file);

}  // namespace displayfile
