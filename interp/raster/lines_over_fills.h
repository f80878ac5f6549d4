#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "displayfile/display_file.h"
#include "displayfile/viewed_scene.h"
#include "hidden/exact/precision.h"
#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// The lines that are drawn over the fills of a picture, where they are seen by the rule of lines
/// (hidden/lines/README.md): found once, before rows are drawn, and kept while they stay the same.
/// Those of a scene are found together, or where segments were sorted on their own those of each of
/// them.
class LinesOverFills {
 public:
  /// Lines of one scene, which lives as long as it is drawn.
  struct Group {
    std::shared_ptr<const ViewedScene> scene;
    Precision precision;
    std::vector<VisiblePiece> pieces;
  };

  /// There are none.
  void clear();
  /// Those of one scene, which since the last clear() was always one of the same items.
  void take(const std::shared_ptr<const ViewedScene>& scene, const Precision& precision,
            int threads);
  /// Those of each visible segment that has an order of polygons of its own.
  void take_sorted_segments(const DisplayFile& display_file, int threads);

  /// Null if they are not found together.
  const Group* all() const { return all_ ? &*all_ : nullptr; }
  /// Null if it has none that are found.
  const Group* of_segment(int name) const;

 private:
  /// With what decides which lines they are.
  struct OfSegment {
    std::shared_ptr<const Instructions> entered;
    ImageTransformation image;
    Group group;
  };
  static Group group_of(const Segment& segment, int threads);

  std::optional<Group> all_;
  std::unordered_map<int, OfSegment> of_segments_;  // by name
};

}  // namespace displayfile
