#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "programs/surface/surface_data.h"

namespace displayfile {

/// How surfaces are shown.
struct SurfaceLook {
  Camera camera;
  std::optional<std::array<double, 2>> heights;  ///< of the box; none: those of the surfaces
  bool true_scale = false;                       ///< a unit is as long along z as along x and y
  SurfaceCurves curves = SurfaceCurves::both;
  SurfaceSides sides = SurfaceSides::both;
  bool coloured = false;  ///< by height, with a legend
  int contours = 0;       ///< levels of lines at the base
  bool axes = true, box = true;
  std::array<std::string, 3> names{"x", "y", "z"};
  double curve_width = 0.0;  ///< in pixels; 0: depending on the number of curves
};

/// Enters surfaces, their axes and other requested parts as a scene: segment 1 has the surfaces and
/// the parts that they may hide, segment 2 the legend. Throws Error for an invalid view.
void enter_surfaces(GraphicsSystem& system, std::span<const SurfaceData> surfaces,
                    const SurfaceLook& look);

}  // namespace displayfile
