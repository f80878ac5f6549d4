#pragma once

#include <optional>
#include <span>
#include <vector>

#include "clip/view/transformation.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/letters.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/up_axis.h"

namespace displayfile {

class CuttingPlanes;

/// Appends the vertices used by faces, each once, in world coordinates.
void append_used_vertices(const Mesh& mesh, const ModellingTransformation& modelling,
                          std::vector<Point3>& world);
/// Appends the corners of an object's faces as cutting planes leave them, in world coordinates;
/// of faces that lie in a plane only if nothing else is left, as other faces have these corners.
void append_corners_left(const Mesh& mesh, const Mesh::Object& object,
                         const ModellingTransformation& modelling, const CuttingPlanes& planes,
                         std::vector<Point3>& world);
/// Appends the vertices of what the cutting planes in force leave of a mesh, under the modelling
/// transformation in force.
void append_vertices_left(const Mesh& mesh, const GraphicsSystem& system,
                          std::vector<Point3>& world);

/// The application's view settings before a mesh is viewed.
struct CameraAsSet {
  View view;
  ExplicitSettings settings;  ///< the parts set explicitly
  /// If a window was set but no camera, sets the camera beside it. Otherwise nothing changes.
  bool camera_beside_window = false;
  bool operator==(const CameraAsSet&) const = default;
};

/// Sets a view that shows all points, by a camera: by default a three-quarter perspective from the
/// front, a little from the right and above; with the window fitted to the projection with a small
/// margin, in the aspect ratio of the system's pictures, and the view depth enclosing the points.
///
/// View settings of the system are kept, or those of `set`, for a program that is replayed later:
/// the window is made for the viewport, depth and clipping are kept, and with a set camera only the
/// window is fitted. If a window was set nothing changes, unless CameraAsSet::camera_beside_window
/// is set. At an exact scale (SystemInside::set_scale) the window has that scale. A camera without
/// an up axis uses y.
///
/// Throws Error, with no view set, if there are no points, a segment is open, or the camera is
/// invalid: an eye at its target, an angle of view out of range, or, when fitting, points that are
/// not in front of the eye; an angle of view beside a window; as window_at_scale.
void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera = {});
void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera,
              const CameraAsSet& set);
/// The view that fit_view sets, or none if nothing changes; Errors as there. It makes room for the
/// letters of the texts, whose anchors are among the points, except those for which the scene would
/// be smaller by more than a factor of 2.5. An exact scale and views all around make room for the
/// anchors only.
std::optional<View> fitted_view(std::span<const Point3> world, const GraphicsSystem& system,
                                const Camera& camera, const CameraAsSet& set,
                                std::span<const PlacedText> texts = {});
/// Sets the view, except for the parts that the application has set.
void set_fitted_view(const View& view, GraphicsSystem& system, const CameraAsSet& set);
/// The same for meshes, with the modelling transformation and the cutting planes in force, and the
/// meshes' up axis where the camera has none. Where the planes leave nothing: for the whole meshes.
CommonUpright fit_view(std::span<const Mesh> meshes, GraphicsSystem& system,
                       const Camera& camera = {});

}  // namespace displayfile
