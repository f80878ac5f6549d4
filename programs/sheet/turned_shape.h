#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "clip/view/transformation.h"

namespace displayfile {

/// The axis of revolution of a shape, over the shape's extent. A sphere's has length 0: its centre.
struct CentreAxis {
  Point3 from, to;
  double radius;  ///< largest, of the shape about it
};

/// The surface that a routine of turned shapes makes, with its axis in world coordinates.
class TurnedShape {
 public:
  /// The axis, as far along the points as these lie on the surface: on its facets, which are
  /// inscribed. Nothing if fewer than 3 do, as where a solid is combined to something without it.
  std::optional<CentreAxis> axis_at(std::span<const Point3> points) const;

 private:
  friend std::optional<TurnedShape> turned_shape(std::string_view, const ModellingTransformation&);
  bool is_on_surface(const Point2& p) const;

  Point3 origin_{0.0}, along_{0.0, 0.0, 1.0};  // along: of length 1
  std::vector<Point2> profile_;                // distance from the axis, place along it; closed
  double sagitta_ = 0.0;                       // of a facet, in parts of its least distance
  double bulge_ = 0.0;                         // of a profile that is round itself, over its facets
  double largest_ = 0.0;                       // of the profile's numbers
  bool is_sphere_ = false;
};

/// True for the routines of drawing programs that turned_shape() supports.
bool makes_turned_shape(std::string_view routine);

/// The shape of a drawing program's line that calls cylinder-3, cone-3, sphere-3, torus-3 or turn-3
/// without an error, under the modelling transformation in force. Nothing for other lines, and
/// where the transformation leaves nothing that is round about an axis.
std::optional<TurnedShape> turned_shape(std::string_view line,
                                        const ModellingTransformation& modelling);

}  // namespace displayfile
