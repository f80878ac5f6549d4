#pragma once

#include <cstddef>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// Polygons, lines, texts and annotations of a scene's visible segments, and how many of them reach
/// beyond a side of their window, by more than rounding; some of these may not be seen at all.
struct CroppedFigure {
  std::size_t all = 0, beyond = 0;
};

/// Each segment in the view in which it was drawn; the display file is that of the system that
/// retained the scene.
CroppedFigure cropped_figure(const RetainedScene& scene, const DisplayFile& display_file);

}  // namespace displayfile
