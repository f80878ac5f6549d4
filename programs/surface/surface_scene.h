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
  /// The width of all lines, in pixels; 0: that of curves depends on their number, others are
  /// fixed.
  double line_width = 0.0;
  /// The size of the font (the em), in parts of the picture's height; none: in proportion.
  std::optional<double> letter_height;
};

/// Enters surfaces, their axes and other requested parts as a scene: segment 1 has the surfaces and
/// the parts that they may hide, segment 2 the legend. Throws Error for an invalid view, and for
/// letters that leave no room for the surfaces.
void enter_surfaces(GraphicsSystem& system, std::span<const SurfaceData> surfaces,
                    const SurfaceLook& look);

}  // namespace displayfile
