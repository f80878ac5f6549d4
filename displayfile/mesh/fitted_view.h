#pragma once

#include <span>
#include <vector>

#include "clip/transformation.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/up_axis.h"

namespace displayfile {

/// Appends the positions that faces use, each vertex once, in world coordinates.
void append_used_vertices(const Mesh& mesh, const ModellingTransformation& modelling,
                          std::vector<Point3>& world);

/// What an application set of the view before a mesh.
struct CameraAsSet {
  View view;
  ExplicitSettings settings;  ///< which parts of it were set
};

/// Sets a view that shows the points whole, by a camera: unless it has another one a three-quarter
/// perspective from the front, a little from the right and from above; the window fitted to what is
/// projected with a small margin, in the shape of the system's pictures; the view depth enclosing
/// the points.
///
/// What was set of the view stays, as the system has it or as `set` has it, to which a program
/// that is yet to be replayed brings it: the window is made for its viewport, its depth and
/// clipping are kept, and of its camera only the window is fitted. If a window was set nothing is
/// changed. A camera without an axis that is up has y.
///
/// Throws Error, with no view set, if there are no points, a segment is open, or the camera cannot
/// be: an eye at what it looks at, an angle of view out of range, or, to be fitted, points that are
/// not before the eye.
void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera = {});
void fit_view(std::span<const Point3> world, GraphicsSystem& system, const Camera& camera,
              const CameraAsSet& set);
/// The same for meshes, in the modelling transformation in force, upright as they stand where the
/// camera does not say how.
CommonUpright fit_view(std::span<const Mesh> meshes, GraphicsSystem& system,
                       const Camera& camera = {});

}  // namespace displayfile
