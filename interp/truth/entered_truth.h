#pragma once

#include <optional>

#include "clip/surfaces.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/truth.h"

namespace displayfile {

/// What is seen at each pixel centre, judged from what the application entered: the points of its
/// polygons as they were entered, the modelling matrices, the views, the viewports and the image
/// transformations are taken as the doubles that they are, and nothing is rounded. Polygons that
/// touch lie in one plane. interp/truth/entered_truth.md has the definition. Nothing is shared with
/// the methods but the input.
struct EnteredTruth {
  Picture picture;           ///< as truth() returns it
  std::size_t touching = 0;  ///< polygons that lie in the plane of another
};

/// `retained` is what was drawn into the display file, all of it; `touching` is in place of what
/// its segments have. Ties and errors as in truth().
EnteredTruth entered_truth(const RetainedScene& retained, const DisplayFile& display_file,
                           int width, int height, bool depth,
                           const std::optional<Touching>& touching,
                           const WorkProgress& progress = {}, DepthTies* ties = nullptr);

/// What exact methods draw of a display file: its entered truth, if all its visible segments keep
/// what was entered, and otherwise truth(). Polygons of which clipping or back-face removal left
/// nothing are not there. Ties and errors as in truth().
Picture truth_as_entered(const DisplayFile& display_file, int width, int height, bool depth,
                         const WorkProgress& progress = {}, DepthTies* ties = nullptr);

}  // namespace displayfile
