#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/visible_lines.h"
#include "interp/device/interpreter.h"
#include "interp/raster/line_painter.h"

namespace displayfile {

/// The lines drawn over the fills of a picture where they are visible by the rule of lines
/// (hidden/lines/README.md): found once, before rows are drawn, and kept while they are unchanged.
/// Lines of a scene are found together; where segments were sorted separately, per segment.
class LinesOverFills {
 public:
  /// The lines to find, and their accuracy.
  struct Wanted {
    SurfacePlan plan = {};  ///< by Franklin's method, whatever finds the fills
    Point2 pixels{0.0};     ///< OutputDevice::pixels, in the unit of widths as they are set

    /// True if the lines found for `o`, within the limit of pieces in force then, can be reused.
    bool are_as(const Wanted& o) const {
      return plan.finds_as(o.plan) && pixels == o.pixels && plan.most_pieces >= o.plan.most_pieces;
    }
    /// The lines that accompany fills found by that plan.
    static Wanted beside(const SurfacePlan& fills, const Point2& pixels);
  };
  /// A line that is drawn as a whole.
  struct Stroke {
    Point3 from, to;
    LineStyle style;
    LineCuts cuts;
  };
  /// A part of a line, drawn at its place in the order of depth.
  struct DeepPart {
    Stroke stroke;
    double from, to;     ///< the part, as fractions of it
    std::uint32_t item;  ///< whose line it is
    bool is_hidden = false;
  };
  /// Lines of one scene, which must live until they are drawn.
  struct Group {
    std::shared_ptr<const ViewedScene> scene;
    Wanted wanted;
    std::vector<Stroke> hidden;         ///< drawn before the others
    std::vector<VisiblePiece> pieces;   ///< of the scene's lines
    std::vector<Stroke> intersections;  ///< their visible parts
    /// With line order `depth` in place of all these: the one drawn last is nearest.
    std::vector<DeepPart> by_depth;

    bool is_nothing() const {
      return hidden.empty() && pieces.empty() && intersections.empty() && by_depth.empty();
    }
    /// Draws the lines with a LinePainter.
    template <class Painter, class Plot>
    void draw(Painter& painter, const Plot& plot) const {
      painter.strokes(hidden, plot);
      painter.seen(*scene, pieces, plot);
      painter.strokes(intersections, plot);
      for (const DeepPart& part : by_depth) draw(part, painter, plot);
    }
    template <class Painter, class Plot>
    static void draw(const DeepPart& part, Painter& painter, const Plot& plot) {
      const VisiblePiece seen{0, 0, part.from, part.to};
      painter.stroke(part.stroke, SeenOfLine(std::span(&seen, 1)), plot);
    }
  };

  /// Removes all lines.
  void clear();
  /// Finds the lines of one scene. Since the last clear(), all scenes must have had the same items.
  void take(const std::shared_ptr<const ViewedScene>& scene, const Wanted& wanted);
  /// Finds the lines of each visible segment that has its own order of polygons, with the settings
  /// of that order.
  void take_sorted_segments(const DisplayFile& display_file, const Point2& pixels, int threads);

  /// Null if lines are not found together.
  const Group* all() const { return all_ ? &*all_ : nullptr; }
  /// Null if the segment has no lines found separately.
  const Group* of_segment(int name) const;

 private:
  /// The lines of a segment, with the data that determine them.
  struct OfSegment {
    std::shared_ptr<const Instructions> entered;
    ImageTransformation image;
    Group group;
  };
  static Group group_of(const Segment& segment, const Wanted& wanted);

  std::optional<Group> all_;
  std::unordered_map<int, OfSegment> of_segments_;  // by name
};

}  // namespace displayfile
