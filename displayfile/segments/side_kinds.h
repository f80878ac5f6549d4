#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/exact/eye.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Which sides of a retained segment's polygons are lines of the kinds that are wanted
/// (displayfile/segments/line_kinds.md). What no view changes is found once; in a view, which
/// polygons face the viewer, and with that which sides are outlines. Corners and primitives are
/// counted from the segment's own first, so that it holds of the same segment in another scene.
class SideKinds {
 public:
  SideKinds(const RetainedScene& scene, const RetainedScene::Segment& segment,
            const LineSelection& wanted);

  /// What becomes of polygons that are turned away from the viewer.
  enum class TurnedAway : std::uint8_t {
    kept,     ///< they are polygons like others
    stays,    ///< a side of theirs stays that has kByBackFace
    removed,  ///< all of them
  };
  static constexpr LineKinds kByBackFace = 128;
  /// For the side that ends at each of the segment's corners its kinds, 0 where it is not drawn; of
  /// lines kDrawn. `scene` has the segment. A line that is only a part of a side that faces the
  /// viewer is drawn by a side that is turned away, if one is just that part and may be.
  void in_view(const RetainedScene& scene, const RetainedScene::Segment& segment, const Eye& eye,
               std::span<LineKinds> of_corners, TurnedAway turned_away) const;
  /// The same of all views together: 0 where it is drawn in none.
  void in_any_view(std::span<LineKinds> of_corners) const;

  std::size_t corners() const { return fixed_.size(); }

 private:
  class Finder;
  /// A side of a polygon that shares it with others.
  struct SharedSide {
    std::uint32_t primitive, corner;
  };
  /// What lies between two vertices that follow each other along sides.
  struct Stretch {
    LineKinds fixed;         ///< the kinds that no view changes
    bool begins_line;        ///< no side has it and the one before
    std::uint32_t end_face;  ///< of the primitives that have it, in faces_
  };
  /// A side that stretches make up, which others have too.
  struct PartedSide {
    std::uint32_t corner, face;  ///< the face as in faces_
    std::uint32_t first, end;    ///< of its stretches
    LineKinds drawn;             ///< the kinds as which it may be drawn
  };

  std::span<const std::uint32_t> faces_of(std::uint32_t stretch) const;
  LineKinds kinds_of_stretch(std::uint32_t stretch, std::span<const std::uint8_t> is_facing) const;
  class Tiling;

  std::vector<LineKinds> fixed_;  // of the corners: the kinds that no view changes
  // Sides that several polygons share, where outlines are wanted: set after set, and where each
  // ends.
  std::vector<SharedSide> shared_;
  std::vector<std::uint32_t> ends_;
  // Sides with the ends of others along them, and sides between vertices that are one with others,
  // in the order in which they begin; and their stretches, in order along each line.
  std::vector<PartedSide> parted_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> faces_;  // primitives, counted from the segment's own first
  bool wants_outlines_ = false;
};

}  // namespace displayfile
