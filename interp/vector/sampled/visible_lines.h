#pragma once

#include <cstdint>
#include <vector>

#include "clip/clip_to_rectangle.h"
#include "interp/vector/sampled/sampled_scene.h"
#include "interp/vector/sampled/seen_band.h"

namespace displayfile {

/// Finds which parts of a drawing's lines are seen: where no fill is nearer. At equal depth the
/// line is seen.
///
/// Each line is looked at in steps of half a pixel; where two neighbouring steps differ the place
/// is found by bisection. At a point, a fill hides the line if it covers the point and its plane is
/// nearer there. The fills tried are those seen at the four pixel centres around the point; if
/// all four are nearer by more than their slopes across a pixel explain, the point is hidden
/// also where none of the four covers it (a mesh finer than the pixels).
class VisibleLines {
 public:
  explicit VisibleLines(const SampledScene& drawing);

  /// The rows that each line reaches, for ActiveByRow.
  std::vector<ActiveByRow::Rows> rows() const;
  /// Looks at the steps that lie in the band's rows, of these lines. To be called once a band.
  void look(const SeenBand& band, std::span<const std::uint32_t> lines);
  /// To be called when all bands were looked at.
  void finish();

  /// The parts that are seen, in order. Valid until the next call.
  std::span<const LinePart> parts(std::uint32_t line);

 private:
  /// The part of a line near the picture, and how many steps it is looked at in.
  struct Steps {
    double from = 0.0, to = 0.0;
    std::int64_t count = -1;  ///< -1: nothing of it is near the picture

    double at(std::int64_t k) const {
      if (k == count) return to;
      return from + (to - from) * (static_cast<double>(k) / static_cast<double>(count));
    }
  };
  struct Change {
    std::uint32_t line;
    double at;
    bool to_visible;
  };

  Steps steps_of(const SampledScene::Line& line) const;
  std::int64_t first_step_in(const SeenBand& band, const SampledScene::Line& line,
                             const Steps& steps) const;
  Point3 point(const SampledScene::Line& line, double t) const;
  int row_of(const SampledScene::Line& line, double t) const;
  bool visible(const SeenBand& band, const SampledScene::Line& line, double t) const;
  double find_change(const SeenBand& band, const SampledScene::Line& line, double before,
                     double after, bool visible_before) const;

  const SampledScene& drawing_;
  std::vector<Change> changes_;
  std::vector<std::size_t> first_change_;  // of each line, once finished
  std::vector<LinePart> parts_;
};

}  // namespace displayfile
