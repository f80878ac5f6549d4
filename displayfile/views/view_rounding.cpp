#include "displayfile/views/view_rounding.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>

#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

/// A row of the matrix times a vector, with all terms as magnitudes.
double row_size(const glm::dmat4& m, int row, const Point3& v) {
  return std::abs(m[0][row] * v.x) + std::abs(m[1][row] * v.y) + std::abs(m[2][row] * v.z);
}

}  // namespace

/// With view-plane z = (1 - W) eye and Z = scale (z - back), Z / W gives 1/W.
ViewRounding::ViewRounding(const View& view, const ViewVolume& volume) : matrix_(volume.matrix()) {
  const Point3 step(1.0);
  size_of_step_ =
      std::max(row_size(matrix_, 0, step), row_size(matrix_, 1, step)) + row_size(matrix_, 3, step);
  if (view.projection == View::Projection::parallel) return;
  const double eye = (volume.view_plane() * HomogeneousPoint(view.centre_of_projection, 1.0)).z;
  const double front = view.distance - view.front, back = view.distance - view.back;
  const double scale = (1.0 - front / eye) / (front - back);
  per_w_rise_ = 1.0 / (scale * (eye - back));
  per_w_at_0_ = eye / (eye - back);
}

/// The magnitude to which the rounding errors of x or y and of w are relative.
double ViewRounding::size_of(const Point3& p) const {
  const auto size = [&](int row) { return row_size(matrix_, row, p) + std::abs(matrix_[3][row]); };
  return std::max(size(0), size(1)) + size(3);
}

double ViewRounding::per_w(double device_z) const { return per_w_at_0_ + per_w_rise_ * device_z; }

double ViewRounding::of(std::span<const Point3> world, std::span<const Point3> device,
                        double off_plane) const {
  constexpr double kRoundings = 64.0;
  constexpr double kLift = 2.0;  // along the axis that the plane faces, of the distance from it
  double largest = 0.0, nearest = 0.0;
  for (const Point3& p : world) largest = std::max(largest, size_of(p));
  for (const Point3& p : device) nearest = std::max(nearest, per_w(p.z));
  return (kRoundings * kUnit * largest + kLift * off_plane * size_of_step_) * nearest;
}

}  // namespace displayfile
