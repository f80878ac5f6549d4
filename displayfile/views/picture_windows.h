#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "clip/geometry/bounds.h"
#include "clip/view.h"
#include "clip/view/window_fit.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// An exact scale of pictures on paper, for parallel views.
struct ExactScale {
  std::string name;       ///< for messages, such as "--scale 1:2"
  double millimetres;     ///< on paper, of a unit of the view plane
  double picture_height;  ///< in mm
};

/// The window, around the middle of `shown`, that a viewport has at this scale in pictures with
/// this aspect ratio. Throws Error, beginning with the scale's name, for a projection that is not
/// parallel, or if `shown` does not fit, with the excess.
Rectangle window_at_scale(const ExactScale& scale, View::Projection projection,
                          const Rectangle& shown, const Rectangle& viewport, double aspect);

/// The windows of segments, for pictures with one aspect ratio: widened to the shape of their
/// viewport there, or stretched to it.
class PictureWindows {
 public:
  double aspect() const { return aspect_; }
  void set_aspect(double aspect);  ///< Error: not a positive number up to kCoordinateLimit.
  void set_fit(WindowFit fit) { fit_ = fit; }
  const std::optional<ExactScale>& scale() const { return scale_; }
  void set_scale(const std::optional<ExactScale>& scale) { scale_ = scale; }

  /// A view with its window fitted to the picture. Unless the application sets a fit, a window is
  /// widened, but stretched if it or the viewport was set. At an exact scale the window has that
  /// scale, whatever the fit; Error as window_at_scale.
  View in_picture(View view, const ExplicitSettings& set) const;
  /// Records the window of the segment just opened, if it is stretched by default.
  void opened(int segment, const View& view, const ExplicitSettings& set);
  /// The worst recorded one.
  const std::optional<StretchedWindow>& stretched() const { return stretched_; }

 private:
  double aspect_ = 1.0;  // width over height
  WindowFit fit_ = WindowFit::widen;
  std::optional<ExactScale> scale_;
  std::optional<StretchedWindow> stretched_;
};

/// The window with this aspect ratio (width over height) around `seen` (view-plane coordinates),
/// with at least a twentieth of it free at each side; it is high enough for `least_height` with
/// these margins.
inline Rectangle fitted_window(const Bounds& seen, double aspect, double least_height = 0.0) {
  constexpr double kMargin = 0.05;
  const Point3 size = seen.high - seen.low, middle = seen.middle();
  const double half_height =
      0.5 * std::max({size.x / aspect, size.y, least_height}) / (1.0 - 2.0 * kMargin);
  const double half_width = aspect * half_height;
  return {middle.x - half_width, middle.x + half_width, middle.y - half_height,
          middle.y + half_height};
}

}  // namespace displayfile
