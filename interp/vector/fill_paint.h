#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "clip/point.h"

namespace displayfile {

/// A linear gradient over the page, in pixels, y down: black at one point, the full colour at the
/// other, linear along the line between them, the same across it. Finite, and of some length.
struct ColourRamp {
  double black_x, black_y, full_x, full_y;

  /// The fraction of the full colour there: not clamped to [0,1].
  double at(const Point2& page) const {
    const Point2 from(black_x, black_y), way = Point2(full_x, full_y) - from, p = page - from;
    return (p.x * way.x + p.y * way.y) / (way.x * way.x + way.y * way.y);
  }
  friend auto operator<=>(const ColourRamp&, const ColourRamp&) = default;
};

/// The paint of a region and of its traps: a colour, or a ramp from black to it.
struct FillPaint {
  std::uint32_t pixel;  ///< pixel_of the colour
  std::optional<ColourRamp> ramp = std::nullopt;
  friend auto operator<=>(const FillPaint&, const FillPaint&) = default;
};

}  // namespace displayfile
