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

namespace {

/// How far the depth of a fill is from that of a plane, at most, over the polygon: both are linear.
double distance_of_depths(std::span<const Point3> vertices, const PixelDepth& depth,
                          const Plane& plane, const PictureSize& size) {
  const PixelDepth other(plane, size.width, size.height);
  double most = 0.0, dx = 0.0, dy = 0.0;
  for (const Point3& v : vertices) {
    const double x = v.x * size.width, y = v.y * size.height;
    most = std::max(most, std::abs(depth.at_point(x, y) - other.at_point(x, y)));
    dx = std::max(dx, std::abs(x - other.x0));
    dy = std::max(dy, std::abs(y - other.y0));
  }
  return most + other.error(plane, size.width, size.height, dx + 1.0, dy + 1.0);
}

}  // namespace

double touching_error(const ViewedScene& scene, ViewedScene::Fill fill, const PixelDepth& depth,
                      const PictureSize& size) {
  constexpr double kOfThreePoints = 8.0;
  if (const double radius = scene.touching_radius(); radius > 0.0) {
    const double slopes = std::abs(depth.dz_dx) * size.width + std::abs(depth.dz_dy) * size.height;
    return kOfThreePoints * radius * (1.0 + slopes);
  }
  const Primitives::PlanePoints* const shared = scene.shared_plane(scene.item_of(fill));
  if (shared == nullptr) return 0.0;
  return distance_of_depths(scene.vertices(fill), depth, scene.plane_through(*shared), size);
}

FillDepth::FillDepth(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
                     std::optional<double> roundoff) {
  const Plane plane = scene.plane(fill);
  depth = PixelDepth(plane, size.width, size.height);
  error = roundoff ? error_of_roundoff(*roundoff)
                   : depth_bound(scene.vertices(fill), plane, depth, size).error +
                         touching_error(scene, fill, depth, size);
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
