#include "interp/visibility/fill_depths.h"
#include "clip/rectangle.h"

#include <algorithm>
#include <cmath>

namespace displayfile {

namespace {

/// The greatest distance, in pixels, from `origin` to the part of [low, high] on the picture.
double reach(double low, double high, double origin, int pixels) {
  const double limit = pixels;
  low = std::clamp(low * limit, 0.0, limit);
  high = std::clamp(high * limit, 0.0, limit);
  return std::max(std::abs(low - origin), std::abs(high - origin)) + 1.0;
}

}  // namespace

DepthBound depth_bound(std::span<const Point3> vertices, const Plane& plane,
                       const PixelDepth& depth, const PictureSize& size) {
  const Rectangle e = bounding_rectangle(vertices);
  const double dx = reach(e.x_min, e.x_max, depth.x0, size.width);
  const double dy = reach(e.y_min, e.y_max, depth.y0, size.height);
  return {depth.error(plane, size.width, size.height, dx, dy),
          std::abs(depth.z0) + std::abs(depth.dz_dx) * dx + std::abs(depth.dz_dy) * dy};
}

FillDepth::FillDepth(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
                     std::optional<double> roundoff) {
  const Plane plane = scene.plane(fill);
  depth = PixelDepth(plane, size.width, size.height);
  error = roundoff ? error_of_roundoff(*roundoff)
                   : depth_bound(scene.vertices(fill), plane, depth, size).error;
}

FillDepths::FillDepths(const ViewedScene& scene, const PictureSize& size,
                       std::optional<double> roundoff)
    : roundoff_(roundoff) {
  of_fill_.resize(scene.end());
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    of_fill_[fill] = FillDepth(scene, fill, size, roundoff);
  }
}

}  // namespace displayfile
