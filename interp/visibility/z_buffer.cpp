#include "interp/visibility/z_buffer.h"

#include "interp/visibility/fill_depths.h"

namespace displayfile {

namespace {

/// What rounding to a float adds, for depths up to the second number.
constexpr double kFloatUnit = 0x1p-23;
constexpr double kLargestFloatDepth = 1e37;

}  // namespace

void ZBuffer::begin_polygon(std::span<const Point3> vertices, const Plane& plane) {
  depth_ = PixelDepth(plane, size_.width, size_.height);
  current_ = static_cast<Owner>(polygons_.size());
  if (roundoff_) {
    margin_ = *roundoff_;
    polygons_.push_back({plane.p, plane.q, plane.r, 0.0});
    return;
  }
  const DepthBound bound = depth_bound(vertices, plane, depth_, size_);
  const double error = bound.largest < kLargestFloatDepth
                           ? bound.error + kFloatUnit * bound.largest + 1e-44
                           : std::numeric_limits<double>::infinity();
  largest_error_ = std::max(largest_error_, error);
  margin_ = 2.0 * (error + largest_error_);
  polygons_.push_back({plane.p, plane.q, plane.r, error});
  close_.begin(plane);
}

}  // namespace displayfile
