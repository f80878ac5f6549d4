#pragma once

#include <optional>

#include "clip/surfaces.h"
#include "interp/device/picture.h"

namespace displayfile {

struct ViewedWorld;

/// Parameters for drawing a raster picture of a display file.
struct RasterRequest {
  int width = 512, height = 512;
  /// Only these rows of it, as a picture with no others; none: all.
  std::optional<PictureRows> rows = std::nullopt;
  /// With an image-space method (interp/visibility/image_space.h), or `automatic` for the cheapest
  /// one (interp/visibility/auto_method.h), the nearest fill is visible, whatever its place in the
  /// order; with others the one drawn last. With a roundoff, depths within it are equal (the
  /// textbook's ROUNDOFF). Hidden lines and intersection lines are drawn over fills found in image
  /// space; an order of polygons has those with which it was made.
  SurfacePlan surfaces = {.method = HiddenMethod::none};
  /// True if the order of fills is exactly back to front: then the nearest is also visible where
  /// cuts were rounded and where polygons touch.
  bool sorted = false;
  Background background = {};
  bool ids = false, depth = false;
  bool crumbs = false;  ///< as DrawOptions::crumbs
  bool texts = true;    ///< drawn over the pixels, which must be kept
  Lettering lettering = {};
  std::optional<double> dpi = std::nullopt;  ///< pixels per inch on paper; none: 96
  double line_scale = 1.0;                   ///< of the widths and dashes of lines
  /// Depths closer than this count as equal; none: exact.
  std::optional<double> roundoff() const {
    if (surfaces.precision.exact) return std::nullopt;
    return surfaces.precision.roundoff;
  }
  /// The source of the display file, for world_ray_cast. A renderer that is reused needs it alive.
  const ViewedWorld* world = nullptr;
};

}  // namespace displayfile
