#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// A polygon's drawn sides, by the style that their kinds have.
class StyledSides {
 public:
  /// Calls draw(style, sides) for each style: sides[i] is op::line for the sides drawn in it and
  /// op::move for the others. `kinds` may be empty: they were not determined. The spans hold during
  /// the call.
  template <class Draw>
  void for_each(const LineStyle& line, std::span<const LineKinds> kinds,
                std::span<const std::int32_t> sides, Draw&& draw) {
    left_.assign(sides.begin(), sides.end());
    for (std::size_t first = 0; first < left_.size(); ++first) {
      if (left_[first] != op::line) continue;
      const LineStyle style = style_of(line, kinds, first);
      of_style_.assign(left_.size(), op::move);
      for (std::size_t i = first; i < left_.size(); ++i) {
        if (left_[i] != op::line || style_of(line, kinds, i) != style) continue;
        of_style_[i] = op::line;
        left_[i] = op::move;
      }
      draw(style, std::span<const std::int32_t>(of_style_));
    }
  }

 private:
  static LineStyle style_of(const LineStyle& line, std::span<const LineKinds> kinds,
                            std::size_t side) {
    return side_line_style(line, kinds.empty() ? kDrawn : kinds[side]);
  }
  std::vector<std::int32_t> left_, of_style_;
};

}  // namespace displayfile
