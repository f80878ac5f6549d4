#pragma once

#include <vector>

#include "clip/bounds.h"
#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// A retained scene's visible segments, and the one view in which all of them were drawn.
struct SceneInOneView {
  View view;
  std::vector<Point3> points;  ///< all their points and places of texts, in world coordinates
  Bounds bounds;               ///< theirs; empty if there are none
};

/// `attributes` is the display file of the system that retained the scene, and says which segments
/// are visible. If there is nothing in any, the view is `otherwise`. Throws Error if they were
/// drawn in several views.
SceneInOneView scene_in_one_view(const RetainedScene& scene, const DisplayFile& attributes,
                                 const View& otherwise);

}  // namespace displayfile
