#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "displayfile/retained_scene.h"
#include "hidden/exact/eye.h"
#include "hidden/line_kinds.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Which sides of a retained segment's polygons are lines of the kinds that are wanted
/// (displayfile/line_kinds.md). What no view changes is found once; in a view, which polygons face
/// the viewer, and with that which sides are outlines. Corners and primitives are counted from the
/// segment's own first, so that it holds of the same segment in another scene.
class SideKinds {
 public:
  SideKinds(const RetainedScene& scene, const RetainedScene::Segment& segment,
            const LineSelection& wanted);

  /// For the side that ends at each of the segment's corners its kinds, 0 where it is not drawn; of
  /// lines kDrawn. `scene` has the segment.
  void in_view(const RetainedScene& scene, const RetainedScene::Segment& segment, const Eye& eye,
               std::span<LineKinds> of_corners) const;
  /// The same of all views together: 0 where it is drawn in none.
  void in_any_view(std::span<LineKinds> of_corners) const;

  std::size_t corners() const { return fixed_.size(); }

 private:
  class Finder;
  /// A side of a polygon that shares it with others.
  struct SharedSide {
    std::uint32_t primitive, corner;
  };

  std::vector<LineKinds> fixed_;  // of the corners: the kinds that no view changes
  // Sides that several polygons share, where outlines are wanted: set after set, and where each
  // ends.
  std::vector<SharedSide> shared_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace displayfile
