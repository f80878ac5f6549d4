#pragma once

#include "displayfile/display_file.h"
#include "displayfile/retained_scene.h"
#include "displayfile/turntable.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"

namespace displayfile::bench {

/// Prints what it is worth to keep what a moving eye, and what a moving light, leaves as it was
/// (displayfile/scene_viewer.md): so many views of a lit scene each way, kept, by the same way with
/// nothing but memory kept, and entered and drawn anew, in turn.
void print_kept_views(const RetainedScene& scene, const DisplayFile& attributes,
                      const Turntable& turntable, const RasterRequest& request, int views);

}  // namespace displayfile::bench
