#pragma once

#include <cstdint>
#include <optional>

#include "clip/point.h"

namespace displayfile {

/// What is seen at a place of a picture: the nearest solid polygon, of equally near ones the one
/// entered later, or a line. A Renderer (interp/draw/renderer.h) finds it.
struct Pick {
  enum class Kind {
    polygon,  ///< the fill of one
    edge,     ///< a drawn side of a polygon
    line,
  };
  Kind kind;
  /// The pick identifier of the polygon; of a line the one that the application set, -1 if none.
  std::int32_t id;
  int segment;   ///< the name of the segment that it is in
  double depth;  ///< normalised: 0 on the back plane, 1 on the front plane, larger is nearer
  /// Where it is seen, in world coordinates: the exact point, rounded. Of a retained scene alone.
  std::optional<Point3> world;
};

}  // namespace displayfile
