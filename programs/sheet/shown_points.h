#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "programs/sheet/part.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The views of a sheet, and which of them shows a point of the part.
class ShownPoints {
 public:
  /// `wanted` and `views` are in the same order, and stay while this is used.
  ShownPoints(const Part& part, std::span<const ViewWanted> wanted,
              std::span<const PartDrawing> views);

  /// The first view in which a point of a face, in the part's coordinates, is visible: where
  /// nothing lies before it by more than a hundredth of the part's size. Otherwise, of the views in
  /// which it is not cut away, the one in which the visible surface there is nearest to it.
  std::size_t view_of(const Point3& point) const;

 private:
  /// The depth of the point behind the visible surface in a view; 0: the point is visible;
  /// infinite: it is cut away, or not a point of a face.
  double depth_behind(std::size_t view, const Point3& point) const;

  const Part& part_;
  std::span<const ViewWanted> wanted_;
  std::span<const PartDrawing> views_;
  std::vector<std::vector<std::uint8_t>> is_whole_;  // of each view, its uncut objects
  double reach_;
};

}  // namespace displayfile
