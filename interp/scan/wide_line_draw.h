#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "displayfile/looks/style.h"
#include "interp/scan/line_draw.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

/// The widest line without caps, in pixels: of a narrower one caps would be seen as noise.
inline constexpr double kWidestWithoutCaps = 1.5;

/// A line with width, in pixel coordinates.
struct CappedLine {
  Point2 from, to;
  LineStyle style;
  LineCuts cuts;       ///< ends without a cap
  double dash_start;   ///< length drawn before `from`
  Point2 before{0.0};  ///< direction of the dashed line that ends at `from`; 0: there is none

  double length() const { return glm::distance(from, to); }
  double radius() const { return 0.5 * style.width; }

  /// The projection of a point to the line: 0 at `from`, 1 at `to`.
  double place_of(const Point2& centre) const {
    const double squared = glm::dot(to - from, to - from);
    return squared > 0.0 ? glm::dot(centre - from, to - from) / squared : 0.0;
  }
  /// True if a point whose projection is there, and that is no farther than radius() from the
  /// infinite line, belongs to the line.
  bool reaches(const Point2& centre, double place) const {
    const bool is_dashed = style.kind == LineStyle::Kind::dashed;
    if (place < 0.0)
      return is_dashed ? is_in_join(centre) : !cuts.at_start && is_near(centre, from);
    if (place > 1.0) return !is_dashed && !cuts.at_end && is_near(centre, to);
    return !is_dashed || is_in_dash(place * length());
  }

 private:
  bool is_near(const Point2& centre, const Point2& end) const {
    return glm::distance(centre, end) < radius();
  }
  bool is_in_dash(double along) const {
    return std::fmod(dash_start + along, style.dash + style.gap) < style.dash;
  }
  /// Outside of the corner of two dashed lines.
  bool is_in_join(const Point2& centre) const {
    return glm::dot(centre - from, before) > 0.0 && is_in_dash(0.0) && is_near(centre, from);
  }
};

/// Draws a line that has caps and joins as in vector files (interp/vector/line_ends.md): the pixels
/// whose centres are within half its width of it. Solid lines have round ends, except where `cuts`
/// says that the line continues; dashes are cut at right angles and joined round at corners. A line
/// without length is a square. Otherwise as draw_line; is_seen gets the place along the line that
/// is nearest to the pixel's centre, so that caps are visible where the line's ends are.
template <class IsSeen, class Plot>
void draw_wide_line(Point3 a, Point3 b, const LineStyle& style, const LineCuts& cuts,
                    const ScanConverter::Region& region, DashPhase& phase, const IsSeen& is_seen,
                    Plot&& plot) {
  CappedLine line{Point2(a), Point2(b), style, cuts, phase.length, phase.direction};
  const double length = line.length();
  phase.length += length;
  if (length > 0.0) phase.direction = (line.to - line.from) / length;
  if (!std::isfinite(length) || is_seen.nothing()) return;
  auto [width, height] = region.size;
  const bool steep = lay_flat(a, b);
  if (steep) std::swap(width, height);
  const bool turned = b.x < a.x;
  const Point3 low = turned ? b : a, high = turned ? a : b;
  const double run = high.x - low.x;
  const double radius = line.radius(), reach = run > 0.0 ? radius * length / run : radius;
  LineSteps steps{std::max(0.0, std::ceil(low.x - radius - 0.5)),
                  std::min(width - 1.0, std::ceil(high.x + radius - 0.5) - 1.0)};
  double lowest = region.row_begin, highest = region.row_end - 1.0;
  if (steep) {  // whose steps are rows
    steps = {std::max(steps.first, lowest), std::min(steps.last, highest)};
    lowest = 0.0, highest = height - 1.0;
  } else {
    steps = columns_in_rows(low, high, reach, region, steps);
  }
  for (double column = steps.first; column <= steps.last; ++column) {
    const double t = run > 0.0 ? (column + 0.5 - low.x) / run : 0.0;
    const double y = low.y + t * (high.y - low.y);
    const double z = low.z + std::clamp(t, 0.0, 1.0) * (high.z - low.z);
    const double bottom = std::ceil(y - reach - 0.5);
    const double top = std::max(bottom, std::ceil(y + reach - 0.5) - 1.0);
    for (double row = std::max(lowest, bottom); row <= std::min(highest, top); ++row) {
      const Point2 centre = Point2(steep ? row : column, steep ? column : row) + 0.5;
      const double place = line.place_of(centre);
      if (!line.reaches(centre, place) || !is_seen(std::clamp(place, 0.0, 1.0))) continue;
      plot(static_cast<int>(centre.x), static_cast<int>(centre.y), z);
    }
  }
}

}  // namespace displayfile
