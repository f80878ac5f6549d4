#pragma once

#include <algorithm>
#include <cmath>

#include "clip/point.h"
#include "displayfile/style.h"

namespace displayfile {

/// Where a dashed line is in its pattern; carried from side to side of a polygon.
struct DashPhase {
  double length = 0.0;  ///< drawn so far, in pixels
};

/// Draws a line in pixel coordinates (see scan_convert.h) on a width x height picture: one
/// step for each column that a flat line passes, or each row that a steep one does, and the
/// pixel that holds the line's point there (a point scan-converts to the floor of its
/// coordinates; one on the picture's right or top border to the last pixel). A line wider than
/// a pixel takes the pixels whose centres lie within its width, measured across. Calls
/// plot(i, j, z) with z interpolated between the ends.
template <class Plot>
void draw_line(Point3 a, Point3 b, const LineStyle& style, int width, int height, DashPhase& phase,
               Plot&& plot) {
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  if (steep) {
    std::swap(a.x, a.y);
    std::swap(b.x, b.y);
    std::swap(width, height);
  }
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double start = phase.length;
  phase.length += length;
  if (!(std::isfinite(length))) return;
  const bool turned = b.x < a.x;
  const Point3 low = turned ? b : a, high = turned ? a : b;
  const double run = high.x - low.x;
  const double per_step = run > 0.0 ? length / run : 0.0;  // length along the line, a column
  const double across = std::max(1.0, style.width) * std::max(1.0, per_step);
  const auto cell = [](double v, int limit) {  // the border belongs to the last pixel
    return v == limit ? limit - 1.0 : std::floor(v);
  };
  const double first = std::max(0.0, cell(low.x, width));
  const double last = std::min(width - 1.0, cell(high.x, width));
  const double period = style.dash + style.gap;
  for (double column = first; column <= last; ++column) {
    const double x = std::clamp(column + 0.5, low.x, high.x);
    const double t = run > 0.0 ? (x - low.x) / run : 0.0;
    const double y = low.y + t * (high.y - low.y);
    const double z = low.z + t * (high.z - low.z);
    if (style.kind == LineStyle::Kind::dashed) {
      const double along = start + per_step * (turned ? high.x - x : x - low.x);
      if (std::fmod(along, period) >= style.dash) continue;
    }
    double bottom = cell(y, height), top = bottom;
    if (style.width > 1.0) {
      bottom = std::ceil(y - across / 2 - 0.5);
      top = std::max(bottom, std::ceil(y + across / 2 - 0.5) - 1.0);
    }
    for (double row = std::max(0.0, bottom); row <= std::min(height - 1.0, top); ++row) {
      const int i = static_cast<int>(column), j = static_cast<int>(row);
      if (steep) {
        plot(j, i, z);
      } else {
        plot(i, j, z);
      }
    }
  }
}

}  // namespace displayfile
