#include "displayfile/views/picture_windows.h"

#include <fmt/format.h>

#include <algorithm>

#include "clip/base/error.h"
#include "clip/view/window_fit.h"

namespace displayfile {

namespace {

Point2 sides_of(const Rectangle& r) { return {r.x_max - r.x_min, r.y_max - r.y_min}; }

/// Throws Error if `shown` exceeds the room by more than rounding. In millimetres.
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

void PictureWindows::set_aspect(double aspect) {
  if (!(aspect > 0.0 && aspect <= kCoordinateLimit)) {
    throw Error(fmt::format("aspect ratio {}: expected a positive number", aspect));
  }
  aspect_ = aspect;
}

View PictureWindows::in_picture(View view, const ExplicitSettings& set) const {
  if (scale_) {
    view.window = window_at_scale(*scale_, view.projection, view.window, view.viewport, aspect_);
    return view;
  }
  const bool mapping_was_set = set.contains(Setting::window) || set.contains(Setting::viewport);
  const bool widen =
      set.contains(Setting::window_fit) ? fit_ == WindowFit::widen : !mapping_was_set;
  if (widen) view.window = widened(view.window, shape_in_picture(view.viewport, aspect_));
  return view;
}

void PictureWindows::opened(int segment, const View& view, const ExplicitSettings& set) {
  if (set.contains(Setting::window_fit)) return;
  const StretchedWindow stretched{segment, shape_of(view.window),
                                  shape_in_picture(view.viewport, aspect_)};
  if (!shapes_differ(stretched.window, stretched.viewport)) return;
  const auto how_far = [](const StretchedWindow& w) {
    return std::max(w.window / w.viewport, w.viewport / w.window);
  };
  if (!stretched_ || how_far(stretched) > how_far(*stretched_)) stretched_ = stretched;
}

}  // namespace displayfile
