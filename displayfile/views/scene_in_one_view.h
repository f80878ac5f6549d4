#pragma once

#include <vector>

#include "clip/geometry/bounds.h"
#include "clip/view.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/letters.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// A retained scene's visible segments, and the one view in which all of them were drawn.
struct SceneInOneView {
  View view;
  std::vector<Point3> points;  ///< all points and text anchors, in world coordinates
  Bounds bounds;               ///< theirs; empty if there are none
  std::vector<PlacedText> texts = {};
};

/// `attributes` is the display file of the system that retained the scene, with the visibility of
/// segments. If all are empty, the view is `otherwise`. Throws Error if they were drawn in several
/// views.
SceneInOneView scene_in_one_view(const RetainedScene& scene, const DisplayFile& attributes,
                                 const View& otherwise);

/// Sets the view plane and the projection. Throws Error as the system's routines do, here and
/// below.
void set_camera(const View& view, GraphicsSystem& system);

/// Sets all of the view except the viewport.
void set_view(const View& view, GraphicsSystem& system);

}  // namespace displayfile
