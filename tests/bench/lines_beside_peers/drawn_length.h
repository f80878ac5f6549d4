#pragma once

#include <vector>

#include "clip/point.h"

namespace displayfile::bench {

/// A straight piece of a drawing, in device coordinates: the unit is the picture.
struct DrawnSegment {
  Point2 p, q;
};
using LineDrawing = std::vector<DrawnSegment>;

/// The sum of the segments' lengths, those that lie on others again.
double total_length(const LineDrawing& drawing);

/// The drawing without the parts that lie within the tolerance of an earlier segment: so that each
/// length counts once, however many edges lie on one another in the picture.
LineDrawing drawn_once(const LineDrawing& drawing, double tolerance);

/// The length of the drawing that is farther than the tolerance from all segments of the other.
double length_beside(const LineDrawing& drawing, const LineDrawing& other, double tolerance);

}  // namespace displayfile::bench
