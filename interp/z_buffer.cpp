#include "interp/z_buffer.h"

#include <algorithm>
#include <cmath>

#include "hidden/depth_order.h"

namespace displayfile {

namespace {

constexpr ZBuffer::Owner kNone = ~ZBuffer::Owner{0};

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
  if (roundoff_) {
    margin_ = *roundoff_;
    return;
  }
  double x_min = vertices[0].x, x_max = x_min, y_min = vertices[0].y, y_max = y_min;
  for (const Point3& v : vertices) {
    x_min = std::min(x_min, v.x);
    x_max = std::max(x_max, v.x);
    y_min = std::min(y_min, v.y);
    y_max = std::max(y_max, v.y);
  }
  const double error =
      depth_.error(plane, size_.width, size_.height, reach(x_min, x_max, depth_.x0, size_.width),
                   reach(y_min, y_max, depth_.y0, size_.height));
  largest_error_ = std::max(largest_error_, error);
  margin_ = 2.0 * (error + largest_error_);
  current_ = static_cast<Owner>(polygons_.size());
  polygons_.push_back({plane.p, plane.q, plane.r, error});
  compared_ = kNone;
}

/// What the rounded depths do not tell.
bool ZBuffer::nearer_or_equal(double nearer, double old_depth, const Owner* owner, int column,
                              int row) {
  if (roundoff_) return true;  // within ROUNDOFF: equal, and later
  if (old_depth == -std::numeric_limits<double>::infinity()) return true;  // the background
  const Polygon& a = polygons_[current_];
  const Polygon& b = polygons_[owner[column]];
  const double margin = 2.0 * (a.error + b.error);
  if (nearer > margin) return true;
  if (nearer < -margin) return false;
  const Plane plane_a(a.p, a.q, a.r), plane_b(b.p, b.q, b.r);
  if (compared_ != owner[column]) {
    compared_ = owner[column];
    coplanar_ = side_of_plane(a.p, plane_b) == 0 && side_of_plane(a.q, plane_b) == 0 &&
                side_of_plane(a.r, plane_b) == 0;
  }
  return coplanar_ || depth_order(plane_a, plane_b, PixelCentre(column, row, size_)) >= 0;
}

}  // namespace displayfile
