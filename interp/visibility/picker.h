#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/device/picture.h"
#include "interp/visibility/decided_centres.h"
#include "interp/visibility/drawn_layers.h"
#include "interp/visibility/line_picker.h"
#include "interp/visibility/ray_cast.h"

namespace displayfile {

/// A picture's values at a pixel: item buffer and depth.
struct DrawnPixel {
  std::int32_t id;  ///< -1: the background
  double depth;
};

/// Finds the primitive visible at a pixel: by one ray through its centre, as every exact method
/// draws it, or from the picture drawn; and by the rule of lines. Prepared data serve all picks.
class Picker {
 public:
  Picker(std::shared_ptr<const ViewedScene> scene, const PictureSize& size, int threads);

  const ViewedScene& scene() const { return *scene_; }
  const PictureSize& size() const { return size_; }

  /// A pixel, in columns from the left and rows from the bottom.
  struct Pixel {
    int column, row;
  };
  /// The pixel that holds the point: pixels from the upper left corner, y down. None outside of the
  /// picture. Throws Error for a point that is not finite and for a reach that is not 0 to
  /// kLargestSide.
  std::optional<Pixel> pixel_at(double x, double y, double reach) const;

  /// The primitive visible there. A line visible within `reach` pixels of the pixel's centre takes
  /// precedence over the fill; with a reach of 0 lines are ignored.
  std::optional<Pick> pick(const Pixel& at, double reach, const DrawnLayers& layers = {});
  /// The same for a drawn picture, in these layers.
  std::optional<Pick> pick(const Pixel& at, double reach, const DrawnLayers& layers,
                           const DrawnPixel& drawn);

 private:
  using Fill = ViewedScene::Fill;

  std::optional<Pick> line_at(const Pixel& at, double reach, const DrawnLayers& layers, Fill fill);
  Fill drawn_fill(const Pixel& at, const DrawnPixel& drawn) const;

  std::shared_ptr<const ViewedScene> scene_;
  PictureSize size_;
  int threads_;
  RayCast fills_;
  DecidedCentres decided_;
  std::optional<LinePicker> lines_;  // made on first use
};

}  // namespace displayfile
