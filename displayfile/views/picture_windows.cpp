#include "displayfile/views/picture_windows.h"

#include <fmt/format.h>

#include <algorithm>

#include "clip/base/error.h"

namespace displayfile {

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
