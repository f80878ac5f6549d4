#pragma once

#include <optional>

#include "clip/surface_plan.h"
#include "interp/device/picture.h"

namespace displayfile {

struct ViewedWorld;

/// What to draw of a display file, and how large.
struct RasterRequest {
  int width = 512, height = 512;
  /// Only these rows of it, as a picture that has no others; none given: all.
  std::optional<PictureRows> rows = std::nullopt;
  /// By an image-space method (interp/visibility/image_space.h), or `automatic` for the one that is
  /// the cheapest (interp/visibility/auto_method.h), the nearest fill is seen, wherever it stands
  /// in the order; by any other what is drawn last. With a roundoff, depths closer than that count
  /// as equal (the textbook's ROUNDOFF). Hidden lines and intersections are drawn over fills whose
  /// surfaces are found in image space; an order of polygons has those that it was made with.
  SurfacePlan surfaces = {.method = HiddenMethod::none};
  /// True if fills that are drawn in order are in exact back-to-front order: what is nearest is
  /// then to be seen also where cuts were rounded and where polygons touch.
  bool sorted = false;
  Background background = {};
  bool ids = false, depth = false;
  bool crumbs = false;      ///< as DrawOptions::crumbs
  bool texts = true;        ///< drawn over the pixels: not where these are not kept
  double line_scale = 1.0;  ///< of the widths and dashes of lines
  /// Depths closer than this count as equal; none: exact.
  std::optional<double> roundoff() const {
    if (surfaces.precision.exact) return std::nullopt;
    return surfaces.precision.roundoff;
  }
  /// Whose display file it is, for world_ray_cast. A renderer that is used again needs it alive.
  const ViewedWorld* world = nullptr;
};

}  // namespace displayfile
