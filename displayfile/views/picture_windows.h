#pragma once

#include <optional>

#include "clip/view.h"
#include "clip/window_fit.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// The windows that segments are opened with, for pictures of one shape: widened to the shape of
/// their viewport there, or stretched to it.
class PictureWindows {
 public:
  double aspect() const { return aspect_; }
  void set_aspect(double aspect);  ///< Error: not a positive number up to kCoordinateLimit.
  void set_fit(WindowFit fit) { fit_ = fit; }

  /// A view, its window in the shape that the picture wants. As long as the application did not
  /// say what it wants, a window is widened unless it set it, or the viewport.
  View in_picture(View view, const ExplicitSettings& set) const;
  /// Notes the window of the segment just opened, if it is stretched and the application did not
  /// say that it should be.
  void opened(int segment, const View& view, const ExplicitSettings& set);
  /// The worst of those noted.
  const std::optional<StretchedWindow>& stretched() const { return stretched_; }

 private:
  double aspect_ = 1.0;  // width over height
  WindowFit fit_ = WindowFit::widen;
  std::optional<StretchedWindow> stretched_;
};

}  // namespace displayfile
