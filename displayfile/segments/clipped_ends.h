#pragma once

#include "clip/point.h"
#include "clip/surfaces.h"
#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// True if the point is on a border of the item's viewport that is not a border of the picture.
/// Device coordinates.
inline bool is_clipped(const ViewedScene& scene, ViewedScene::Item item, const Point3& p) {
  const auto [x_min, x_max, y_min, y_max] = scene.viewport_of(item);
  return (p.x == x_min && x_min > 0.0) || (p.x == x_max && x_max < 1.0) ||
         (p.y == y_min && y_min > 0.0) || (p.y == y_max && y_max < 1.0);
}

/// The ends of an item's line that are clipped, beside those that are cut.
inline LineCuts with_clipped_ends(const ViewedScene& scene, ViewedScene::Item item,
                                  const Point3& from, const Point3& to, const LineCuts& cuts) {
  return {cuts.at_start || is_clipped(scene, item, from),
          cuts.at_end || is_clipped(scene, item, to)};
}

}  // namespace displayfile
