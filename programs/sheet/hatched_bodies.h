#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The hatching of a body's cut faces, in all views. Bodies of one group are hatched together:
/// lines continue from one to the other.
struct BodyHatching {
  Point2 direction{1.0, 0.0};  ///< of length 1
  double spacing = 1.0;        ///< in mm
  std::uint32_t group = 0;     ///< its first body
};

/// The hatching of each body that is cut, by its index (ISO 128-50): bodies whose cut faces are
/// nearer to each other than twice the spacing differ, in direction or, if need be, in spacing,
/// which is then wider than this; bodies of one part do not differ otherwise. Bodies that overlap
/// by more than a hundredth of the smaller cut face are one group, and so is a body with a cavity
/// that was entered by itself. `mm` is the length on paper of the views' unit, `spacing` is in mm.
std::vector<BodyHatching> hatching_of_bodies(std::span<const PartDrawing> views, double mm,
                                             double spacing);

/// Hatching lines within loops, less their parts within the polygons before them, which are
/// counterclockwise. All on paper, in mm.
std::vector<std::pair<Point2, Point2>> hatching_lines(
    const std::vector<std::vector<Point2>>& loops, const std::vector<std::vector<Point2>>& before,
    const BodyHatching& hatching);

}  // namespace displayfile
