#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/point.h"
#include "displayfile/looks/style.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

/// Where a dashed line is in its pattern; carried from side to side of a polygon.
struct DashPhase {
  double length = 0.0;    ///< drawn so far, in pixels
  Point2 direction{0.0};  ///< of the line drawn last; 0: there is none
};

/// Exchanges x and y of a line that is steep, which then is not; true if it was.
inline bool lay_flat(Point3& a, Point3& b) {
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  if (!steep) return false;
  std::swap(a.x, a.y);
  std::swap(b.x, b.y);
  return true;
}

/// The steps of a line: integers from first to last.
struct LineSteps {
  double first, last;
};

/// The columns of a flat line in which the area within `reach` of it (pixels, vertically) is in the
/// region's rows, and possibly more. So each band processes only its part of a long line.
inline LineSteps columns_in_rows(const Point3& low, const Point3& high, double reach,
                                 const ScanConverter::Region& region, const LineSteps& all) {
  const double rise = high.y - low.y, run = high.x - low.x;
  reach += 2.0 + 1e-12 * (std::abs(low.y) + std::abs(high.y));  // and rounding
  const double bottom = region.row_begin - reach, top = region.row_end + reach;
  if (std::max(low.y, high.y) < bottom || std::min(low.y, high.y) > top) return {0.0, -1.0};
  if (!(std::abs(rise) > 1e-6 * run)) return all;
  const double a = low.x + (bottom - low.y) / rise * run;
  const double b = low.x + (top - low.y) / rise * run;
  const double margin = 2.0 + 1e-12 * (std::abs(low.x) + std::abs(high.x));
  return {std::max(all.first, std::floor(std::min(a, b) - margin)),
          std::min(all.last, std::ceil(std::max(a, b) + margin))};
}

/// For a line that is entirely visible, or drawn without hidden-line removal.
struct WholeLine {
  bool nothing() const { return false; }
  bool operator()(double /*place*/) const { return true; }
};

/// Draws a line in pixel coordinates (see scan_convert.h) in the region's rows: one step per column
/// of a flat line, or per row of a steep one, at the pixel that contains the line's point there (a
/// point scan-converts to the floor of its coordinates; one on the picture's right or top border to
/// the last pixel). A line wider than a pixel covers the pixels whose centres are within its width,
/// measured across. Calls plot(i, j, z), with z interpolated between the ends, for the covered
/// pixels whose place along the line is_seen: from 0 at a to 1 at b, that of the step, or for a
/// wide line that of the point nearest to the pixel's centre. So hidden parts move no pixel of
/// visible ones (interp/scan/lines.md).
template <class IsSeen, class Plot>
void draw_line(Point3 a, Point3 b, const LineStyle& style, const ScanConverter::Region& region,
               DashPhase& phase, const IsSeen& is_seen, Plot&& plot) {
  auto [width, height] = region.size;
  const bool steep = lay_flat(a, b);
  if (steep) std::swap(width, height);
  const double length = glm::length(Point2(b - a));
  const double start = phase.length;
  phase.length += length;
  if (!std::isfinite(length) || is_seen.nothing()) return;
  const bool turned = b.x < a.x;
  const Point3 low = turned ? b : a, high = turned ? a : b;
  const double run = high.x - low.x;
  const double per_step = run > 0.0 ? length / run : 0.0;  // length along the line, a column
  const double across = std::max(1.0, style.width) * std::max(1.0, per_step);
  const bool wide = style.width > 1.0;
  const auto place_of_centre = [&](double column, double row) {
    const double along = (column + 0.5 - a.x) * (b.x - a.x) + (row + 0.5 - a.y) * (b.y - a.y);
    return length > 0.0 ? std::clamp(along / (length * length), 0.0, 1.0) : 0.0;
  };
  const auto cell = [](double v, int limit) {  // the border belongs to the last pixel
    return v == limit ? limit - 1.0 : std::floor(v);
  };
  LineSteps steps{std::max(0.0, cell(low.x, width)), std::min(width - 1.0, cell(high.x, width))};
  double lowest = region.row_begin, highest = region.row_end - 1.0;
  if (steep) {  // whose steps are rows
    steps = {std::max(steps.first, lowest), std::min(steps.last, highest)};
    lowest = 0.0, highest = height - 1.0;
  } else {
    steps = columns_in_rows(low, high, across / 2.0, region, steps);
  }
  const double period = style.dash + style.gap;
  for (double column = steps.first; column <= steps.last; ++column) {
    const double x = std::clamp(column + 0.5, low.x, high.x);
    const double t = run > 0.0 ? (x - low.x) / run : 0.0;
    const double y = low.y + t * (high.y - low.y);
    const double z = low.z + t * (high.z - low.z);
    if (style.kind == LineStyle::Kind::dashed) {
      const double along = start + per_step * (turned ? high.x - x : x - low.x);
      if (std::fmod(along, period) >= style.dash) continue;
    }
    if (!wide && !is_seen(turned ? 1.0 - t : t)) continue;
    double bottom = cell(y, height), top = bottom;
    if (wide) {
      bottom = std::ceil(y - across / 2 - 0.5);
      top = std::max(bottom, std::ceil(y + across / 2 - 0.5) - 1.0);
    }
    for (double row = std::max(lowest, bottom); row <= std::min(highest, top); ++row) {
      if (wide && !is_seen(place_of_centre(column, row))) continue;
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
