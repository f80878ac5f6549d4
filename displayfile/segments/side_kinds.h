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

/// Which sides of a retained segment's polygons are lines of the selected kinds
/// (displayfile/segments/line_kinds.md). View-independent results are found once; a view determines
/// which polygons face the viewer, and so which sides are outlines. Corners and primitives are
/// counted from the segment's first, so that it applies to the same segment in another scene.
class SideKinds {
 public:
  SideKinds(const RetainedScene& scene, const RetainedScene::Segment& segment,
            const LineSelection& wanted);

  /// How polygons turned away from the viewer are treated.
  enum class TurnedAway : std::uint8_t {
    kept,     ///< like other polygons
    stays,    ///< only their sides with kByBackFace are kept
    removed,  ///< all of them
  };
  static constexpr LineKinds kByBackFace = 128;
  /// The kinds of the side that ends at each of the segment's corners, 0 where it is not drawn;
  /// kDrawn for lines. `scene` has the segment. A line that is only a part of a side facing the
  /// viewer is drawn by a side that is turned away, if one is exactly that part and allowed.
  void in_view(const RetainedScene& scene, const RetainedScene::Segment& segment, const Eye& eye,
               std::span<LineKinds> of_corners, TurnedAway turned_away) const;
  /// The same over all views: 0 for sides that no view draws.
  void in_any_view(std::span<LineKinds> of_corners) const;

  std::size_t corners() const { return fixed_.size(); }

 private:
  class Finder;
  /// A polygon's side that is shared with others.
  struct SharedSide {
    std::uint32_t primitive, corner;
  };
  /// The part between two successive vertices along sides.
  struct Stretch {
    LineKinds fixed;         ///< the kinds that no view changes
    bool begins_line;        ///< no side contains it and the one before
    std::uint32_t end_face;  ///< of its primitives, in faces_
  };
  /// A side composed of stretches that it shares with others.
  struct PartedSide {
    std::uint32_t corner, face;  ///< the face as in faces_
    std::uint32_t first, end;    ///< of its stretches
    LineKinds drawn;             ///< the kinds as which it may be drawn
  };

  std::span<const std::uint32_t> faces_of(std::uint32_t stretch) const;
  LineKinds kinds_of_stretch(std::uint32_t stretch, std::span<const std::uint8_t> is_facing) const;
  class Tiling;

  std::vector<LineKinds> fixed_;  // of the corners: view-independent kinds
  // Sides that several polygons share, if outlines are selected: set after set, and where each
  // ends.
  std::vector<SharedSide> shared_;
  std::vector<std::uint32_t> ends_;
  // Sides with the ends of others along them, and sides between merged vertices, in order of their
  // starts; and their stretches, in order along each line.
  std::vector<PartedSide> parted_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> faces_;  // primitives, counted from the segment's own first
  bool wants_outlines_ = false;
};

}  // namespace displayfile
