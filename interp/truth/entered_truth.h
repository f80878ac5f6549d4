#pragma once

#include <optional>

#include "clip/surfaces.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/truth/truth.h"

namespace displayfile {

/// The fill visible at each pixel centre, from the entered data: the points of polygons as entered,
/// the modelling matrices, the views, the viewports and the image transformations are taken as
/// exact doubles, and nothing is rounded. Touching polygons are coplanar.
/// interp/truth/entered_truth.md has the definition. It shares only the input with the methods.
struct EnteredTruth {
  Picture picture;           ///< as truth() returns it
  std::size_t touching = 0;  ///< polygons that lie in the plane of another
};

/// `retained` has all primitives of the display file; `touching` overrides that of its segments.
/// Ties and errors as in truth().
EnteredTruth entered_truth(const RetainedScene& retained, const DisplayFile& display_file,
                           int width, int height, bool depth,
                           const std::optional<Touching>& touching,
                           const WorkProgress& progress = {}, DepthTies* ties = nullptr);

/// The picture that exact methods draw of a display file: its entered truth, if all its visible
/// segments keep the entered data, and otherwise truth(). Polygons entirely removed by clipping or
/// back-face removal are not included. Ties and errors as in truth().
Picture truth_as_entered(const DisplayFile& display_file, int width, int height, bool depth,
                         const WorkProgress& progress = {}, DepthTies* ties = nullptr);

}  // namespace displayfile
