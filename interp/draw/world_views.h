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
/// for picking in it (interp/visibility/ray_cast.md). Which polygon is seen at a pixel's centre or
/// at a point picked is decided exactly, as if the polygons went through the view's matrix
/// unrounded; of equally near ones it is the one entered later.
class WorldViews {
 public:
  /// Takes the visible segments of the scene; `attributes` is the display file of the system that
  /// retained them. Both may be edited and moved, while no other thread calls: the next view, or
  /// pick, takes them anew. Once one of them is gone, views are of what was taken last. Throws
  /// Error if a segment has an image transformation: those act after viewing.
  WorldViews(const RetainedScene& scene, const DisplayFile& attributes);

  /// The scene in a view. Lights are turned by `lights_turned`, a rotation. Throws Error as
  /// ViewVolume does, and here as below as the constructor for a scene that was edited. Several
  /// threads may call it at a time.
  ViewedWorld view(const View& view, const glm::dmat3& lights_turned = glm::dmat3(1.0)) const;
  /// Each segment in the view that the application drew it in. Where these overlap in the picture
  /// the nearer polygon is seen, by its depth in its own view.
  ViewedWorld as_drawn() const;

  /// What is seen of the whole scene in that view at a point of the picture: normalised device
  /// coordinates, 0 to 1 over the picture, y up (the upper left corner of pixel (i, j), which
  /// Renderer::pick asks about, is (i / width, 1 - j / height)). Solid fills alone are seen,
  /// through what clipping and back-face removal take away. Nothing where there is none, and
  /// outside of the viewport. Throws Error as ViewVolume does, and for coordinates that are not
  /// finite.
  std::optional<Pick> pick(const View& view, double x, double y) const;

  std::size_t polygons() const;  ///< in the tree

 private:
  struct Kept;
  std::shared_ptr<const WorldRays> rays() const;
  std::shared_ptr<Kept> kept_;  // by copies too
};

/// Draws a retained scene in a view: pixels by rays cast in world
/// coordinates, world_ray_cast, vectors and what the OSMesa device draws as by any image-space
/// method. Otherwise the same. Throws Error too for a precision with a ROUNDOFF, scope `segment`,
/// and a method that is drawn by no rays: in pixels another than `automatic` and world_ray_cast,
/// the colour rule by these too; in vectors one that is neither the map nor works in image space.
void draw(const ViewedWorld& world, const Destination& to, const DrawOptions& options);
Picture draw(const ViewedWorld& world, const DrawOptions& options = {});

}  // namespace displayfile
