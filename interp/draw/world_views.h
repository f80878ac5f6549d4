#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/device/picture.h"
#include "interp/device/viewed_world.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// One tree of boxes, many views: ray casting in object space for pictures of a retained scene and
/// for picking in it (interp/visibility/ray_cast.md). The polygon visible at a pixel's centre or a
/// picked point is found exactly, as if the polygons were transformed by the view's matrix without
/// rounding; of equally near ones it is the one entered later.
class WorldViews {
 public:
  /// Prepares for the visible segments of the scene; `attributes` is the display file of the system
  /// that retained them. Both may be edited and moved while no other thread calls: the next view,
  /// or pick, prepares again. After one is destroyed, views show the last state prepared. Throws
  /// Error if a segment has an image transformation, since these act after viewing.
  WorldViews(const RetainedScene& scene, const DisplayFile& attributes);

  /// The scene in a view. `lights_turned` rotates the lights. Throws Error as ViewVolume does, and,
  /// here and below, as the constructor for an edited scene. Several threads may call it at a time.
  ViewedWorld view(const View& view, const glm::dmat3& lights_turned = glm::dmat3(1.0)) const;
  /// Each segment in the application's view of it. Where these overlap in the picture the nearer
  /// polygon is visible, by its depth in its own view.
  ViewedWorld as_drawn() const;

  /// The solid fill of the whole scene visible in that view at a point of the picture: normalised
  /// device coordinates, 0 to 1 over the picture, y up (the upper left corner of pixel (i, j), as
  /// in Renderer::pick, is (i / width, 1 - j / height)). Clipped parts and removed back faces are
  /// not hit. None where nothing is hit, and outside of the viewport. Throws Error as ViewVolume
  /// does, and for coordinates that are not finite.
  std::optional<Pick> pick(const View& view, double x, double y) const;

  std::size_t polygons() const;  ///< in the tree

 private:
  struct Kept;
  std::shared_ptr<const WorldRays> rays() const;
  std::shared_ptr<Kept> kept_;  // shared by copies
};

/// Draws a retained scene in a view: pixels by rays in world coordinates, world_ray_cast; vectors,
/// and pictures of the OSMesa device, as by any image-space method. Otherwise as draw. Throws Error
/// too for a precision with ROUNDOFF, scope `segment`, and a method that does not draw by rays: in
/// pixels other than `automatic`, world_ray_cast and the colour rule by these; in vectors one that
/// is neither the map nor an image-space method.
void draw(const ViewedWorld& world, const Destination& to, const DrawOptions& options);
Picture draw(const ViewedWorld& world, const DrawOptions& options = {});

}  // namespace displayfile
