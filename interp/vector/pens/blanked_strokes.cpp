#include "interp/vector/pens/blanked_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "clip/geometry/corners.h"
#include "clip/geometry/rectangle.h"

namespace displayfile {

namespace {

double cross_of(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// Twice the signed area, positive if the points run counterclockwise with y up.
double signed_area(std::span<const Point2> polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    area += cross_of(polygon[previous_corner(i, polygon.size())], polygon[i]);
  }
  return area;
}

/// The part of a line that is inside, from `from` to `to` of 0 to 1; empty unless from < to.
struct PartInside {
  double from = 0.0, to = 1.0;
};

/// Cyrus and Beck, "Generalized two- and three-dimensional clipping", Computers & Graphics 3
/// (1978).
PartInside part_inside(const Point2& a, const Point2& b, std::span<const Point2> polygon,
                       double area) {
  PartInside inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& corner = polygon[previous_corner(i, polygon.size())];
    const Point2 side = polygon[i] - corner;
    const double at_a = std::copysign(1.0, area) * cross_of(side, a - corner);
    const double at_b = std::copysign(1.0, area) * cross_of(side, b - corner);
    if (at_a <= 0.0 && at_b <= 0.0) return {1.0, 0.0};
    if (at_a < 0.0) inside.from = std::max(inside.from, at_a / (at_a - at_b));
    if (at_b < 0.0) inside.to = std::min(inside.to, at_a / (at_a - at_b));
  }
  return inside;
}

}  // namespace

std::vector<Stroke> strokes_outside(std::span<const Stroke> strokes,
                                    std::span<const Point2> polygon) {
  std::vector<Stroke> outside;
  outside.reserve(strokes.size());
  const double area = signed_area(polygon);
  Rectangle around = Rectangle::nothing();
  for (const Point2& p : polygon) around.include(p);
  for (const Stroke& stroke : strokes) {
    const Point2 a(stroke.from.x, stroke.from.y), b(stroke.to.x, stroke.to.y);
    const bool is_far = std::max(a.x, b.x) <= around.x_min || std::min(a.x, b.x) >= around.x_max ||
                        std::max(a.y, b.y) <= around.y_min || std::min(a.y, b.y) >= around.y_max;
    const PartInside inside = is_far ? PartInside{1.0, 0.0} : part_inside(a, b, polygon, area);
    if (!(inside.from < inside.to)) {
      outside.push_back(stroke);
      continue;
    }
    const auto at = [&](double t) {
      const Point2 p = a + t * (b - a);
      return SheetPoint{static_cast<std::int32_t>(std::lround(p.x)),
                        static_cast<std::int32_t>(std::lround(p.y))};
    };
    const Stroke before{stroke.from, at(inside.from)}, after{at(inside.to), stroke.to};
    if (inside.from > 0.0 && !before.is_dot()) outside.push_back(before);
    if (inside.to < 1.0 && !after.is_dot()) outside.push_back(after);
  }
  return outside;
}

}  // namespace displayfile
