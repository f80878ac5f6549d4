#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interp/steps/step_items.h"
#include "interp/steps/steps.h"

namespace displayfile {

/// Receives an algorithm's steps: records them, and the resulting picture.
class StepRecord {
 public:
  using Polygon = StepItems::Polygon;
  static constexpr std::uint32_t kBackground = StepRow::kNoPiece;
  // Limits for one step, beyond which it is unreadable; a scene may have a million polygons.
  static constexpr std::size_t kMostRows = 60, kMostMarks = 300, kMostSegments = 400,
                               kMostNames = 12;

  /// Both must outlive this.
  StepRecord(const StepItems& scene, Steps& steps, std::size_t most_steps);

  /// Begins a step, whose contents are added until the next. Throws Error if there are too many.
  Step& step(int line, std::string sentence);
  Step& last() { return steps_.steps.back(); }

  // ---- Names and pieces ------------------------------------------------------------------

  const std::string& name(std::uint32_t piece) const { return steps_.pieces[piece].name; }
  /// "A, B and C"; "nothing" for none; for many, the first ones and the number of the rest.
  std::string names(std::span<const std::uint32_t> pieces) const;
  /// Adds a piece of a polygon, or of the polygon to which the piece `of` belongs: named for the
  /// polygon, with a number.
  std::uint32_t add_piece(std::uint32_t of, std::vector<Point3> points);

  // ---- Marks and panels of the last step; long contents are truncated --------------------

  void mark(StepRole role, std::uint32_t piece);
  void mark(StepMark mark);
  void mark(StepRole role, std::vector<Point2> points, StepMark::Kind kind, bool stays = false);
  void mark(StepRole role, const PixelBox& box, bool stays = false);
  void show(int panel, std::vector<StepRow> rows);
  /// A row for each entry of a list, made by make(entry); for a long list, only the first
  /// kMostRows and the number of the rest.
  template <class List, class Make>
  static std::vector<StepRow> rows(const List& list, Make&& make) {
    std::vector<StepRow> rows;
    std::size_t left = std::size(list);
    for (const auto& entry : list) {
      if (rows.size() == kMostRows) {
        StepRow more{std::vector<std::string>(rows.front().cells.size())};
        more.cells.front() = std::to_string(left) + " more";
        rows.push_back(std::move(more));
        break;
      }
      rows.push_back(make(entry));
      --left;
    }
    return rows;
  }
  void show_segments(int panel, std::vector<StepSegment> segments);
  void show_node(int panel, StepNode node);
  StepRow row(std::uint32_t piece, StepRole role = StepRole::none) const {
    return {{name(piece)}, piece, role};
  }

  // ---- The picture -----------------------------------------------------------------------

  /// The polygon visible in the picture there: kBackground if none.
  Polygon seen(int column, int row) const {
    return picture_[static_cast<std::size_t>(row) * static_cast<std::size_t>(scene_.size().width) +
                    static_cast<std::size_t>(column)];
  }
  /// Paints a run, in the last step, over the picture. Where the present fill is equally near and
  /// was entered later, it is kept: no order of whole polygons can express that. Returns the number
  /// of pixels gained.
  int paint_over(const StepRun& run);
  /// Paints only where the polygon hides the present fill.
  int paint_nearer(const StepRun& run);

 private:
  template <class Keeps>
  int paint(const StepRun& run, Keeps&& keeps);

  const StepItems& scene_;
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
