#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interp/steps/step_scene.h"
#include "interp/steps/steps.h"

namespace displayfile {

/// What an algorithm tells its steps to: it writes them down, and the picture that they add up to.
class StepRecord {
 public:
  using Polygon = StepScene::Polygon;
  static constexpr std::uint32_t kBackground = StepRow::kNoPiece;

  /// Both must live on.
  StepRecord(const StepScene& scene, Steps& steps, std::size_t most_steps);

  /// Begins a step, of which more is said until the next. Throws Error if there are too many.
  Step& step(int line, std::string sentence);
  Step& last() { return steps_.steps.back(); }

  // ---- Names and pieces ------------------------------------------------------------------

  const std::string& name(std::uint32_t piece) const { return steps_.pieces[piece].name; }
  /// "A, B and C"; "nothing" of none.
  std::string names(std::span<const std::uint32_t> pieces) const;
  /// A new piece of the polygon that the other is, or is of: the polygon's name and a number.
  std::uint32_t add_piece(std::uint32_t of, std::vector<Point3> points);

  // ---- What the last step marks and shows ------------------------------------------------

  void mark(StepRole role, std::uint32_t piece);
  void mark(StepRole role, std::vector<Point2> points, StepMark::Kind kind);
  void mark(StepRole role, const PixelBox& box, bool stays = false);
  /// A list of pieces, with a role each if it says so.
  void show(int panel, std::vector<StepRow> rows);
  void show_segments(int panel, std::vector<StepSegment> segments);
  void show_node(int panel, StepNode node);
  StepRow row(std::uint32_t piece, StepRole role = StepRole::none) const {
    return {{name(piece)}, piece, role};
  }

  // ---- The picture -----------------------------------------------------------------------

  /// What the picture shows there: kBackground where nothing.
  Polygon seen(int column, int row) const {
    return picture_[static_cast<std::size_t>(row) * static_cast<std::size_t>(scene_.size().width) +
                    static_cast<std::size_t>(column)];
  }
  /// Paints a run, in the last step, over what is there, as painters do. Where what is there is
  /// exactly as near and was entered later, it stays: no order of whole polygons can say that.
  /// Returns how many pixels it gained.
  int paint_over(const StepRun& run);
  /// Paints only where the polygon is seen before what is there.
  int paint_nearer(const StepRun& run);

 private:
  template <class Keeps>
  int paint(const StepRun& run, Keeps&& keeps);

  const StepScene& scene_;
  Steps& steps_;
  std::size_t most_steps_;
  std::vector<std::uint32_t> cuts_;  // how many pieces each polygon has
  std::vector<Polygon> picture_;     // row by row from the bottom
};

/// "1 pixel", "3 pixels".
std::string counted(std::size_t n, std::string_view what);

/// Points in the projection.
Point2 flat(const Point3& p);

}  // namespace displayfile
