#include "interp/raster/way_to_world.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "clip/view/view_volume.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

/// Bounds the rounding of a coordinate on its way, including clipping, the ray test and terms that
/// the bounds omit.
constexpr double kOperations = 64.0 * kUnit;

constexpr int kAxes = 3, kW = 3;

/// Maps to device coordinates, including the viewport, rather than to the unit cube.
glm::dmat4 to_device_coordinates(const View& view) {
  const ViewVolume volume(view);
  const Rectangle& v = view.viewport;
  glm::dmat4 in_viewport(1.0);
  in_viewport[0][0] = v.x_max - v.x_min;
  in_viewport[1][1] = v.y_max - v.y_min;
  in_viewport[kW][0] = v.x_min;
  in_viewport[kW][1] = v.y_min;
  return in_viewport * volume.matrix();
}

/// A bound of a row's product with columns bounded by `largest`.
double row_bound(const glm::dmat4& m, int row, const HomogeneousPoint& largest) {
  double sum = 0.0;
  for (int column = 0; column < 4; ++column) sum += std::abs(m[column][row]) * largest[column];
  return sum;
}

/// The largest such bound of the coordinate rows.
double largest_bound(const glm::dmat4& m, const HomogeneousPoint& largest) {
  double bound = 0.0;
  for (int row = 0; row < kAxes; ++row) bound = std::max(bound, row_bound(m, row, largest));
  return bound;
}

}  // namespace

/// A world point x is N h / (n h), N the rows of coordinates and n the row of W of the way back,
/// for h = (device, 1); n h is 1 / W. So dx = W (N - x n) dh: no more than W (|N| + |x| |n|) |dh|.
WayToWorld::WayToWorld(const View& view, const Bounds& box)
    : to_device_(to_device_coordinates(view)), to_world_(glm::inverse(to_device_)) {
  double x = 0.0;
  for (int axis = 0; axis < kAxes; ++axis) {
    x = std::max({x, std::abs(box.low[axis]), std::abs(box.high[axis])});
  }
  const HomogeneousPoint world(x, x, x, 1.0), direction(1.0, 1.0, 1.0, 0.0), any(1.0);
  const auto back = [&](const HomogeneousPoint& h) {
    return largest_bound(to_world_, h) + x * row_bound(to_world_, kW, h);
  };
  const double w = row_bound(to_device_, kW, world);
  stretch_ = w * back(direction);
  // A ray's direction in the view is that of the light less W times the point. It may come close
  // to zero, where the light is seen behind the point; it is no less than 1 / (|N| + |x| |n|).
  steepest_ = back(direction) * largest_bound(to_device_, direction);
  // Vertices are off by rounding in homogeneous coordinates, where W does not matter; and the
  // matrix back is not exactly the inverse.
  const double coordinates = std::max(largest_bound(to_device_, world), w);
  of_vertices_ = back(any) * kOperations * coordinates;
  glm::dmat4 off = to_world_ * to_device_ - glm::dmat4(1.0);
  const double of_inverse = largest_bound(off, world) + x * row_bound(off, kW, world);
  of_vertices_ += 2.0 * of_inverse + kOperations * x;
  if (!(row_bound(off, kW, world) < 0.25)) of_vertices_ = std::numeric_limits<double>::infinity();
}

double WayToWorld::error(double largest_depth) const {
  const double largest = std::max(1.0, largest_depth);
  const double error =
      of_vertices_ * largest + stretch_ * kOperations * largest * (1.0 + steepest_);
  return std::isfinite(error) ? 4.0 * error : std::numeric_limits<double>::infinity();
}

}  // namespace displayfile
