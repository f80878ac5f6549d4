#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "clip/point.h"
#include "interp/device/output_device.h"
#include "interp/vector/fill_paint.h"

namespace displayfile {

/// Paints of polygons in vectors. An intensity that is linear over a triangle gives one linear
/// gradient: its ramp, accurate to an eighth of a level at each vertex. Even paint is used for
/// little variation: less than half a level, or within a ramp of a million pixels; and for slopes
/// so steep that a ramp would have no length.
///
/// A piece narrower than half a pixel has a steep, meaningless slope across it: only the change
/// along it is visible, and its ramp runs from its first vertex to the one farthest from it.
class PolygonPaints {
 public:
  /// `page` are the polygon's vertices in pixels, y down, finite, and `shown` are points of the
  /// painted area, near the page, where ramps are placed. The ends of ramps are rounded to
  /// multiples of `unit` pixels where that suffices, and otherwise to decimals of them. Consecutive
  /// pieces of one triangle, recognised by their pick identifier, get the same paint.
  FillPaint paint_of(const DrawnPolygon& polygon, std::span<const Point2> page,
                     std::span<const Point2> shown, double unit);

 private:
  std::unordered_map<std::int32_t, FillPaint> last_of_pick_;  // that have ramps
};

}  // namespace displayfile
