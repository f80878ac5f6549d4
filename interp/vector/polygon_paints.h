#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "clip/point.h"
#include "interp/device/output_device.h"
#include "interp/vector/fill_paint.h"

namespace displayfile {

/// What polygons are painted with in vectors. An intensity that is linear over a triangle makes its
/// colour one linear gradient: the ramp on which it lies, so exactly that no vertex is off by more
/// than an eighth of a level. Even is what hardly varies: by less than half a level, or within a
/// ramp of a million pixels; and what is so steep that a ramp would have no length.
///
/// A piece narrower than half a pixel has a slope across it that says nothing, and that is steep:
/// what is seen of it is how it changes along it, and its ramp runs from its first vertex to the
/// one farthest from it.
class PolygonPaints {
 public:
  /// `page` are its vertices in pixels, y down, finite, and `shown` what is to be painted, near the
  /// page, where ramps are: some points. The ends of ramps are rounded to multiples
  /// of `unit` pixels where those suffice, and to decimals of them otherwise. Pieces of one
  /// triangle, known by their pick identifier, that come one after another get the very same paint.
  FillPaint paint_of(const DrawnPolygon& polygon, std::span<const Point2> page,
                     std::span<const Point2> shown, double unit);

 private:
  std::unordered_map<std::int32_t, FillPaint> last_of_pick_;  // that have ramps
};

}  // namespace displayfile
