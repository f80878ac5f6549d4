#pragma once

#include <memory>
#include <optional>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/device/picture.h"
#include "interp/visibility/decided_centres.h"
#include "interp/visibility/line_picker.h"
#include "interp/visibility/ray_cast.h"

namespace displayfile {

/// Finds the primitive visible at a pixel: by one ray through its centre, as every exact method
/// draws it, and by the rule of lines. Prepared data serve all picks.
class Picker {
 public:
  Picker(std::shared_ptr<const ViewedScene> scene, const PictureSize& size, int threads);

  const ViewedScene& scene() const { return *scene_; }
  const PictureSize& size() const { return size_; }

  /// At the pixel that holds the point: pixels from the upper left corner, y down. A line visible
  /// within `reach` pixels of the pixel's centre takes precedence over the fill; with a reach of 0
  /// lines are ignored. Throws Error for a point that is not finite and for a reach that is not 0
  /// to kLargestSide.
  std::optional<Pick> pick(double x, double y, double reach);

 private:
  std::shared_ptr<const ViewedScene> scene_;
  PictureSize size_;
  int threads_;
  RayCast fills_;
  DecidedCentres decided_;
  std::optional<LinePicker> lines_;  // made on first use
};

}  // namespace displayfile
