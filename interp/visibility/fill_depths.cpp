#include "interp/visibility/fill_depths.h"
#include "clip/geometry/rectangle.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

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

/// The largest distance between the depths of a fill and of a plane over the polygon: both are
/// linear.
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

/// distance_from_entered for a triangle's plane, by its corners viewed in doubles; none if they are
/// too inaccurate.
std::optional<double> quick_distance_from_entered(const ViewedScene& scene,
                                                  const ViewedScene::EnteredItem& of_plane,
                                                  ViewedScene::Item item, const PixelDepth& depth,
                                                  const PictureSize& size) {
  constexpr double kOfThreePoints = 8.0, kMostOff = 0x1p-32;
  if (of_plane.polygon.points.size() != 3) return std::nullopt;
  const ImageMatrix image(*of_plane.image);
  std::array<Point3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const HomogeneousPoint viewed = of_plane.volume->transform(of_plane.polygon.in_world(k));
    if (!(viewed.w >= of_plane.volume->nearest_w())) return std::nullopt;
    corners[k] = image.apply(of_plane.volume->to_device(viewed));
    // Beyond all visible depths, rounding may be larger.
    if (!(std::abs(corners[k].z) <= scene.largest_depth())) return std::nullopt;
  }
  const Plane plane(corners[0], corners[1], corners[2]);
  if (!(std::abs(plane.normal.z) > plane.bound.z)) return std::nullopt;
  const PointRow vertices = scene.points(item);
  double weights = 0.0;
  for (const Point3& v : vertices) weights = std::max(weights, sum_of_weights(plane, Point2(v)));
  const PixelDepth other(plane, size.width, size.height);
  const double slopes = std::abs(other.dz_dx) * size.width + std::abs(other.dz_dy) * size.height;
  const double off = kOfThreePoints * scene.plane_radius() * weights * (1.0 + slopes);
  if (!(scene.plane_radius() > 0.0 && off <= kMostOff)) return std::nullopt;
  return distance_of_depths(vertices.row(), depth, plane, size) + off;
}

/// The largest distance of the depth from that of the item's plane as entered.
double distance_from_entered(const ViewedScene& scene, ViewedScene::Item item,
                             const PixelDepth& depth, const PictureSize& size) {
  const ViewedScene::EnteredItem of_plane = scene.plane_as_entered(item);
  if (!of_plane.is_known()) return 0.0;
  if (const auto quick = quick_distance_from_entered(scene, of_plane, item, depth, size)) {
    return *quick;
  }
  const auto plane = EnteredProjection(*of_plane.volume, *of_plane.image).plane(of_plane.polygon);
  if (!plane || plane->is_edge_on()) return 0.0;  // then it has its own
  PixelDepth entered;
  entered.z0 = rounded_quotient(-plane->d, plane->c);
  entered.dz_dx = rounded_quotient(-plane->a, plane->c) / size.width;
  entered.dz_dy = rounded_quotient(-plane->b, plane->c) / size.height;
  double most = 0.0, largest = std::abs(entered.z0);
  for (const Point3& v : scene.points(item)) {
    const double x = v.x * size.width, y = v.y * size.height;
    most = std::max(most, std::abs(depth.at_point(x, y) - entered.at_point(x, y)));
    largest = std::max(largest, std::abs(entered.dz_dx * x) + std::abs(entered.dz_dy * y));
  }
  return most + 16.0 * kUnit * largest;
}

}  // namespace

double sum_of_weights(const Plane& plane, const Point2& at) {
  const Point2 p = Point2(plane.p) - at, q = Point2(plane.q) - at, r = Point2(plane.r) - at;
  const auto cross = [](const Point2& a, const Point2& b) {
    return std::abs(a.x * b.y - a.y * b.x);
  };
  return (cross(q, r) + cross(r, p) + cross(p, q)) / std::abs(plane.normal.z);
}

double rounding_error(const ViewedScene& scene, ViewedScene::Fill fill, const PixelDepth& depth,
                      const PictureSize& size) {
  constexpr double kOfThreePoints = 8.0;
  const ViewedScene::Item item = scene.item_of(fill);
  const double radius = scene.plane_radius();
  const double slopes = std::abs(depth.dz_dx) * size.width + std::abs(depth.dz_dy) * size.height;
  const double by_radius = radius > 0.0 ? kOfThreePoints * radius * (1.0 + slopes) : 0.0;
  if (scene.touching_radius() > 0.0) return by_radius;
  if (scene.plane_is_elsewhere(item)) {
    return by_radius + distance_from_entered(scene, item, depth, size);
  }
  const Primitives::PlanePoints* const shared = scene.shared_plane(item);
  if (shared == nullptr) return by_radius;
  return by_radius +
         distance_of_depths(scene.vertices(fill), depth, scene.plane_through(*shared), size);
}

FillDepth::FillDepth(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
                     std::optional<double> roundoff) {
  const Plane plane = scene.plane(fill);
  depth = PixelDepth(plane, size.width, size.height);
  error = roundoff ? error_of_roundoff(*roundoff)
                   : depth_bound(scene.vertices(fill), plane, depth, size).error +
                         rounding_error(scene, fill, depth, size);
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
