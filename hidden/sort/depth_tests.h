#pragma once

#include "hidden/sort/sort_tables.h"

namespace displayfile {

/// The drawing order of two polygons or lines that overlap in the projection.
enum class DrawnFirst : std::uint8_t {
  either,  ///< they do not overlap after all
  first,   ///< the second is nearer
  second,
  neither,  ///< they intersect
};
inline DrawnFirst reversed(DrawnFirst d) {
  if (d == DrawnFirst::first) return DrawnFirst::second;
  return d == DrawnFirst::second ? DrawnFirst::first : d;
}

/// The tests of depth sort in order of cost: extents in z; all of one on one side of the other's
/// plane, and vice versa. Undecided (neither) if each is cut by the other's plane, or the other has
/// none.
template <class Policy>
DrawnFirst tested_order(const SortTables<Policy>& scene, PolygonTable::Index a,
                        PolygonTable::Index b, const Extent& box_a, const Extent& box_b) {
  if (box_a.z_max < box_b.z_min) return DrawnFirst::first;
  if (box_b.z_max < box_a.z_min) return DrawnFirst::second;
  const auto against = [&](PolygonTable::Index test, PolygonTable::Index other) {
    if (scene.table[other].plane == kNoPlane) return DrawnFirst::neither;
    switch (scene.comparing.where(test, scene.table[other].plane)) {
      case PlaneSide::front: return DrawnFirst::second;
      case PlaneSide::back: return DrawnFirst::first;
      case PlaneSide::on:
        return scene.entered_before(test, other) ? DrawnFirst::first : DrawnFirst::second;
      case PlaneSide::both: break;
    }
    return DrawnFirst::neither;
  };
  const DrawnFirst by_b = against(a, b);
  return by_b != DrawnFirst::neither ? by_b : reversed(against(b, a));
}

}  // namespace displayfile
