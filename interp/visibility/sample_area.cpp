#include "interp/visibility/sample_area.h"

#include <cmath>

#include "interp/scan/scan_edge.h"

namespace displayfile {

namespace {

/// The rectangle from an area's first centre to its last; pixel units.
struct Centres {
  Centres(const SampleArea& area, const PictureSize& size_)
      : left(area.first_column + 0.5),
        right(area.end_column - 0.5),
        bottom(area.first_row + 0.5),
        top(area.end_row - 0.5),
        size(size_.width, size_.height) {}
  double left, right, bottom, top;
  Point2 size;
};

/// False if the side between a and b (pixel units, rounded) certainly misses the rectangle: it is
/// wholly to one side of it, or has all its corners on one side of its line. The bound is derived
/// in interp/visibility/warnock.md.
bool may_meet(const Point2& a, const Point2& b, const Centres& c) {
  if (std::max(a.x, b.x) < c.left || std::min(a.x, b.x) > c.right) return false;
  if (std::max(a.y, b.y) < c.bottom || std::min(a.y, b.y) > c.top) return false;
  const double run = b.x - a.x, rise = b.y - a.y;
  const double middle_x = 0.5 * (c.left + c.right), middle_y = 0.5 * (c.bottom + c.top);
  const double at_middle = run * (middle_y - a.y) - rise * (middle_x - a.x);
  const double to_corner =
      0.5 * (std::abs(run) * (c.top - c.bottom) + std::abs(rise) * (c.right - c.left));
  const double bound = 32.0 * kUnit * (std::abs(a.x) + std::abs(b.x) + c.size.x) *
                       (std::abs(a.y) + std::abs(b.y) + c.size.y);
  return !(std::abs(at_middle) - to_corner > bound);
}

bool a_side_may_meet(std::span<const Point3> polygon, const Centres& centres) {
  const auto in_pixels = [&](const Point3& v) {
    return Point2(v.x * centres.size.x, v.y * centres.size.y);
  };
  Point2 from = in_pixels(polygon.back());
  for (const Point3& vertex : polygon) {
    const Point2 to = in_pixels(vertex);
    if (may_meet(from, to, centres)) return true;
    from = to;
  }
  return false;
}

}  // namespace

bool covers(std::span<const Point3> polygon, const PixelCentre& centre) {
  const auto is_below = [&](const Point2& v) {
    return compare_with_centres(v.y, centre.size.height, centre.row) < 0;
  };
  bool covered = false;
  Point2 from(polygon.back());
  bool from_below = is_below(from);
  for (const Point3& vertex : polygon) {
    const Point2 to(vertex);
    const bool to_below = is_below(to);
    if (from_below != to_below && crossing(from, to, centre) <= 0) covered = !covered;
    from = to;
    from_below = to_below;
  }
  return covered;
}

/// Where no side meets the rectangle of the centres, the polygon covers all of them or none:
/// testing one is sufficient.
AreaCategory category_of(std::span<const Point3> polygon, const SampleArea& extents,
                         const SampleArea& area, const PictureSize& size) {
  if (intersection(extents, area).empty()) return AreaCategory::disjoint;
  if (area.contains(extents) && !(area == extents)) return AreaCategory::contained;
  if (!is_pixel(area) && a_side_may_meet(polygon, {area, size})) {
    return area == extents ? AreaCategory::contained : AreaCategory::intersecting;
  }
  return covers(polygon, {area.first_column, area.first_row, size}) ? AreaCategory::surrounding
                                                                    : AreaCategory::disjoint;
}

}  // namespace displayfile
