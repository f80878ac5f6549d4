#pragma once

#include <optional>

#include "clip/surfaces.h"
#include "interp/device/picture.h"

namespace displayfile {

struct ViewedWorld;

/// What to draw of a display file, and how large.
struct RasterRequest {
  int width = 512, height = 512;
  /// Only these rows of it, as a picture that has no others; none given: all.
  std::optional<PictureRows> rows = std::nullopt;
  /// An image-space method (interp/visibility/image_space.h), or `automatic` for the one that is
  /// the cheapest (interp/visibility/auto_method.h): the nearest fill is seen, wherever it stands
  /// in the order; any other: what is drawn last.
  HiddenMethod method = HiddenMethod::none;
  /// True if fills that are drawn in order are in exact back-to-front order: what is nearest is
  /// then to be seen also where cuts were rounded and where polygons touch.
  bool sorted = false;
  Background background = {};
  bool ids = false, depth = false;
  /// Over fills whose surfaces are found in image space, beside the lines that are seen
  /// (hidden/lines/README.md); an order of polygons has those that it was made with.
  HiddenLines hidden_lines = HiddenLines::none;
  bool intersections = false;
  bool crumbs = false;  ///< as DrawOptions::crumbs
  bool texts = true;    ///< drawn over the pixels: not where these are not kept
  int threads = 1;
  double line_scale = 1.0;  ///< of the widths and dashes of lines
  /// Depths closer than this count as equal (the textbook's ROUNDOFF); none: exact.
  std::optional<double> roundoff = std::nullopt;
  /// Whose display file it is, for world_ray_cast. A renderer that is used again needs it alive.
  const ViewedWorld* world = nullptr;
};

}  // namespace displayfile
