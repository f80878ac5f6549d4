#include "displayfile/views/exact_scale.h"

#include <fmt/format.h>

#include "clip/base/error.h"
#include "clip/window_fit.h"

namespace displayfile {

namespace {

Point2 sides_of(const Rectangle& r) { return {r.x_max - r.x_min, r.y_max - r.y_min}; }

/// In millimetres; up to rounding.
void require_room(const ExactScale& scale, const Point2& shown, const Point2& room) {
  constexpr double kRounding = 1e-6;
  const double wide = shown.x - room.x, high = shown.y - room.y;
  if (wide <= kRounding && high <= kRounding) return;
  throw Error(fmt::format(
      "{}: {:.6g} x {:.6g} mm at this scale, in {:.6g} x {:.6g} mm: {:.6g} mm too {}: expected a "
      "smaller scale or larger paper",
      scale.name, shown.x, shown.y, room.x, room.y, wide > high ? wide : high,
      wide > high ? "wide" : "high"));
}

}  // namespace

Rectangle window_at_scale(const ExactScale& scale, View::Projection projection,
                          const Rectangle& shown, const Rectangle& viewport, double aspect) {
  if (projection != View::Projection::parallel) {
    throw Error(fmt::format(
        "{}: a perspective view has no scale: expected --parallel, or set-parallel in a program",
        scale.name));
  }
  const double height = scale.picture_height * sides_of(viewport).y;
  const double width = height * shape_in_picture(viewport, aspect);
  const Point2 size = sides_of(shown);
  require_room(scale, size * scale.millimetres, {width, height});
  const double half_width = 0.5 * width / scale.millimetres;
  const double half_height = 0.5 * height / scale.millimetres;
  const double x = shown.x_min + 0.5 * size.x, y = shown.y_min + 0.5 * size.y;
  return {x - half_width, x + half_width, y - half_height, y + half_height};
}

}  // namespace displayfile
