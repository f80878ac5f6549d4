#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "clip/point.h"

namespace displayfile {

/// Which way is up in the world: three directions at right angles, right x up = front. A scene
/// whose up is another axis than y is seen as if it were turned to y-up.
struct Upright {
  Point3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
  Point3 front{0.0, 0.0, 1.0};  ///< toward a viewer who stands before it
  bool operator==(const Upright&) const = default;
};

/// Reads `x`, `y`, `z`, `-x`, `-y` or `-z`, the axis that is up. With z up the front is the side of
/// negative y, and x still runs to the right. Throws Error for anything else.
Upright upright(std::string_view axis);

/// Who says which axis is up, if the application does not. Of meshes that stand by different axes
/// none is followed: then y is up.
enum class UprightBy {
  file,        ///< the file, or what its format lays down (up_axis.h); y where neither says it
  convention,  ///< or else the custom of its format
};

/// From what is looked at to the eye, in degrees: azimuth 0 is from the front and 90 from the
/// right, elevation 90 from above.
struct EyeDirection {
  double azimuth = 30.0, elevation = 20.0;
  bool operator==(const EyeDirection&) const = default;
};

/// How a mesh is looked at, in the coordinates of the world. Lengths and directions that are not
/// given are found from the mesh.
struct Camera {
  std::variant<EyeDirection, Point3> eye = EyeDirection{};  ///< or where it is
  /// In the middle of the picture; if not given, the picture's middle is that of what is seen.
  std::optional<Point3> look_at = std::nullopt;
  std::variant<UprightBy, Upright> upright = UprightBy::file;
  /// In degrees, from the bottom to the top of the picture, more than 0 and less than 180. If not
  /// given, the eye is four times the mesh's radius away.
  std::optional<double> angle_of_view = std::nullopt;
  bool parallel = false;  ///< a parallel projection, which has no angle of view
  /// Finds the window, or the eye's distance for an angle of view, in which the mesh is seen whole.
  /// Otherwise nothing depends on the mesh: the view is that of a ball of radius 1 at the origin or
  /// at what is looked at.
  bool fit = true;
  /// Finds the eye's distance for the mesh as it turns about the axis that is up, through its
  /// middle.
  bool turning = false;
  bool operator==(const Camera&) const = default;
};

}  // namespace displayfile
