#include "interp/z_buffer.h"

#include <cmath>

namespace displayfile {

namespace {

constexpr ZBuffer::Owner kNone = ~ZBuffer::Owner{0};

/// What rounding to a float adds, for depths up to the second number.
constexpr double kFloatUnit = 0x1p-23;
constexpr double kLargestFloatDepth = 1e37;

/// The greatest distance, in pixels, from `origin` to the part of [low, high] on the picture.
double reach(double low, double high, double origin, int pixels) {
  const double limit = pixels;
  low = std::clamp(low * limit, 0.0, limit);
  high = std::clamp(high * limit, 0.0, limit);
  return std::max(std::abs(low - origin), std::abs(high - origin)) + 1.0;
}

}  // namespace

void ZBuffer::begin_polygon(std::span<const Point3> vertices, const SupportVertices& support) {
  const Plane plane(vertices[support.index[0]], vertices[support.index[1]],
                    vertices[support.index[2]]);
  depth_ = PixelDepth(plane, size_.width, size_.height);
  current_ = static_cast<Owner>(polygons_.size());
  if (roundoff_) {
    margin_ = *roundoff_;
    polygons_.push_back({plane.p, plane.q, plane.r, 0.0});
    return;
  }
  double x_min = vertices[0].x, x_max = x_min, y_min = vertices[0].y, y_max = y_min;
  for (const Point3& v : vertices) {
    x_min = std::min(x_min, v.x);
    x_max = std::max(x_max, v.x);
    y_min = std::min(y_min, v.y);
    y_max = std::max(y_max, v.y);
  }
  const double dx = reach(x_min, x_max, depth_.x0, size_.width);
  const double dy = reach(y_min, y_max, depth_.y0, size_.height);
  const double largest =
      std::abs(depth_.z0) + std::abs(depth_.dz_dx) * dx + std::abs(depth_.dz_dy) * dy;
  const double error =
      largest < kLargestFloatDepth
          ? depth_.error(plane, size_.width, size_.height, dx, dy) + kFloatUnit * largest + 1e-44
          : std::numeric_limits<double>::infinity();
  largest_error_ = std::max(largest_error_, error);
  margin_ = 2.0 * (error + largest_error_);
  polygons_.push_back({plane.p, plane.q, plane.r, error});
  compared_ = kNone;
}

void ZBuffer::compare_planes(Owner other) {
  const Polygon& a = polygons_[current_];
  const Polygon& b = polygons_[other];
  plane_ = Plane(a.p, a.q, a.r);
  compared_plane_ = Plane(b.p, b.q, b.r);
  compared_ = other;
  coplanar_ = side_of_plane(a.p, compared_plane_) == 0 &&
              side_of_plane(a.q, compared_plane_) == 0 && side_of_plane(a.r, compared_plane_) == 0;
}

}  // namespace displayfile
