#pragma once

#include <optional>

#include "clip/view.h"
#include "clip/window_fit.h"
#include "displayfile/graphics_system.h"
#include "displayfile/views/exact_scale.h"

namespace displayfile {

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
  /// widened, but stretched if it or the viewport was set. At an exact scale it has that, whatever
  /// the fit; Error as window_at_scale.
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

}  // namespace displayfile
