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

/// What a picture shows at a pixel: the item buffer's value and the depth.
struct DrawnPixel {
  std::int32_t id;  ///< -1: the background
  double depth;
};

/// Tells what is seen at a pixel: by one ray through its centre, so that it is what every exact
/// method draws there, or as a picture has it; and by the rule of lines. What it has made ready
/// serves all picks.
class Picker {
 public:
  Picker(std::shared_ptr<const ViewedScene> scene, const PictureSize& size, int threads);

  const ViewedScene& scene() const { return *scene_; }
  const PictureSize& size() const { return size_; }

  /// A pixel, in columns from the left and rows from the bottom.
  struct Pixel {
    int column, row;
  };
  /// The pixel that holds the point: pixels from the upper left corner, y down. Nothing beyond the
  /// picture. Throws Error for a point that is not finite and for a reach that is not 0 to
  /// kLargestSide.
  std::optional<Pixel> pixel_at(double x, double y, double reach) const;

  /// What is seen there. A line that is seen within `reach` pixels of the pixel's centre comes
  /// before the fill there; with a reach of 0 no line is looked for.
  std::optional<Pick> pick(const Pixel& at, double reach, const DrawnLayers& layers = {});
  /// The same where the picture was drawn, in these layers.
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
  std::optional<LinePicker> lines_;  // made when they are first needed
};

}  // namespace displayfile
