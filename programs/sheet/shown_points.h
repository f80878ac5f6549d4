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

  /// The first view in which a point of a face, in the part's coordinates, is seen: where nothing
  /// lies before it by more than a hundredth of the part's size. Or else, of the views in which it
  /// is not cut away, the one in which what is seen there is nearest to it.
  std::size_t view_of(const Point3& point) const;

 private:
  /// Behind what a view shows there; 0: the point is seen; infinite: it is cut away, or no point of
  /// a face.
  double depth_behind(std::size_t view, const Point3& point) const;

  const Part& part_;
  std::span<const ViewWanted> wanted_;
  std::span<const PartDrawing> views_;
  std::vector<std::vector<std::uint8_t>> is_whole_;  // of each view, its uncut objects
  double reach_;
};

}  // namespace displayfile
