#include "interp/z_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hidden/depth_order.h"

namespace displayfile {

namespace {

constexpr ZBuffer::Owner kNone = ~ZBuffer::Owner{0};
constexpr double kBackground = -std::numeric_limits<double>::infinity();

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
bool ZBuffer::nearer_or_equal(double nearer, const Rest& rest, const double* depth,
                              const Owner* owner) {
  if (roundoff_) return true;  // within ROUNDOFF: equal, and later
  if (rest.column < run_.end) return run_.nearer_or_equal;
  if (depth[rest.column] == kBackground) return true;
  const Owner other = owner[rest.column];
  const double margin = 2.0 * (polygons_[current_].error + polygons_[other].error);
  if (nearer > margin) return true;
  if (nearer < -margin) return false;
  if (compared_ != other) compare_planes(other);
  return coplanar_ || decide_run(rest, depth, owner);
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

/// Along a row the difference of two depths is linear: if it has one sign at both ends of a run
/// of pixels that show the same polygon, it has that sign between them; if not, it changes once.
bool ZBuffer::decide_run(const Rest& rest, const double* depth, const Owner* owner) {
  const auto later_is_seen = [&](int column) {
    return depth_order(plane_, compared_plane_, PixelCentre(column, rest.row, size_)) >= 0;
  };
  int last = rest.column;
  while (last + 1 < rest.end && owner[last + 1] == compared_ && depth[last + 1] != kBackground) {
    ++last;
  }
  const bool seen = later_is_seen(rest.column);
  if (last - rest.column < 4) return seen;  // as soon asked one by one
  int same = rest.column;
  for (int different = last + 1; different - same > 1;) {
    const int middle = different == last + 1 ? last : same + (different - same) / 2;
    (later_is_seen(middle) == seen ? same : different) = middle;
  }
  run_ = {same + 1, seen};
  return seen;
}

}  // namespace displayfile
