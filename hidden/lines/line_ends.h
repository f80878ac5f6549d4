#pragma once

#include <cassert>

#include "clip/geometry/corners.h"
#include "clip/point.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The two ends of a named line: the item's own points.
struct LineEnds {
  Point3 from, to;

  LineEnds(const Primitives& items, const LineName& line) {
    assert(line.item < items.items.size() && line.corner < items.items[line.item].sides);
    const Primitives::Item& item = items.items[line.item];
    const PointRow points = items.points_of(item);
    from = points[previous_corner(line.corner, item.sides)];
    to = points[line.corner];
  }

  /// The point at this fraction from start to end, rounded; 0 and 1 are the ends themselves.
  Point3 at(double share) const {
    assert(0.0 <= share && share <= 1.0);
    if (share == 0.0) return from;
    return share == 1.0 ? to : from + share * (to - from);
  }
};

}  // namespace displayfile
