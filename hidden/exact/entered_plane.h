#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>

#include "clip/point.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/entered_polygon.h"
#include "hidden/exact/exact_vector.h"

namespace displayfile {

/// Bounds of a length that may not be a double.
struct Reach {
  double low = 0.0, high = 0.0;
};

/// A modelling matrix, with its twelve doubles taken as exact, and the reach of polygons entered
/// under it (hidden/touching/touching_planes.md).
class Modelling {
 public:
  /// Null: the identity. `reach` is before the modelling transformation, finite, at least 0.
  Modelling(const glm::dmat4x3* matrix, double reach);

  /// True if it was made from this matrix, null for the identity.
  bool is_of(const glm::dmat4x3* matrix) const;
  bool is_identity() const { return is_identity_; }
  /// True if the matrix is singular.
  bool is_singular() const { return is_singular_; }
  /// True if three points are collinear in the world, exactly.
  bool puts_in_line(const Point3& p, const Point3& q, const Point3& r) const;
  double entered_reach() const { return entered_reach_; }
  /// That reach times the length of the longest of the first three columns.
  const Reach& reach() const { return reach_; }

  /// World coordinates in doubles, as the system computes them.
  Point3 apply(const Point3& p) const {
    return is_identity_ ? p : Point3(matrix_ * HomogeneousPoint(p, 1.0));
  }
  /// The largest sum of magnitudes for one world coordinate of the point; 0 under the identity.
  /// Each coordinate of apply(p) is off by at most 3.01 roundings of it.
  double magnitude(const Point3& p) const { return is_identity_ ? 0.0 : largest_sum(p); }
  /// World coordinates as sums of two doubles, off by at most 13 u^2 magnitude(p), u = 2^-53.
  std::array<DoubleDouble, 3> apply_closely(const Point3& p) const;
  ExactVector apply_exactly(const Point3& p) const;

  /// The square of the length of the longest column.
  DoubleDouble longest_squared() const;  ///< off by at most 30 u^2 of it, without underflow
  ExactNumber exact_longest_squared() const;

 private:
  double largest_sum(const Point3& p) const;

  glm::dmat4 matrix_;
  bool is_identity_, is_singular_;
  double entered_reach_;
  Reach reach_;
};

/// The three vertices through which a polygon's support plane passes, by the definition
/// (interp/truth/entered_truth.md), from the points as entered; nothing if all are collinear,
/// exactly.
std::optional<std::array<std::size_t, 3>> support_of_entered(std::span<const Point3> entered);

/// The support plane of a polygon as entered, prepared for many points.
class EnteredPlane {
 public:
  using Corners = std::array<Point3, 3>;  ///< before the modelling transformation

  /// Through three points that are not collinear in the world. The matrix must outlive it.
  EnteredPlane(const Corners& corners, const Modelling& modelling);

  /// True if a point, as entered under that matrix, is no farther from the plane than the larger of
  /// both reaches; exact.
  bool reaches(const Point3& entered, const Modelling& of_point) const;

  /// The side of the plane that a point is on, as entered under that matrix: 1 where the normal
  /// points, -1, or 0 on it; exact. It flips where two of the plane's corners change places.
  int side(const Point3& entered, const Modelling& of_point) const;

  /// A unit normal in the world.
  const Point3& normal() const { return normal_; }
  /// Bound on its error in length; infinite if unknown.
  double normal_error() const { return direction_error_ + 8.0 * kRounding; }

 private:
  /// Half a unit of a double's last digit, in rounding to nearest.
  static constexpr double kRounding = 0x1p-53;
  enum class Answer { no, yes, undecided };

  void find_normal(double error);
  Answer by_doubles(const Point3& from_first, double error, const Reach& reach) const;
  Answer closely(const std::array<DoubleDouble, 3>& v, double magnitude,
                 const Modelling& of_point) const;
  bool exactly(const Point3& entered, const Modelling& of_point) const;
  int exact_side(const Point3& entered, const Modelling& of_point) const;

  Corners corners_;
  const Modelling* modelling_;
  bool is_sound_;
  double magnitude_ = 0.0;             // the largest of the corners
  std::array<DoubleDouble, 3> first_;  // the first corner in the world
  std::array<DoubleDouble, 3> cross_;  // (q - p) x (r - p)
  double cross_error_ = 0.0;           // per coordinate
  Point3 normal_{0.0};
  double direction_error_;
};

/// Largest distance of a planar polygon's vertices from its support plane, as a fraction of the
/// largest entered coordinate times the length of the modelling matrix's longest column. Decimals
/// and a rotation leave polygons that planar.
inline constexpr double kFlatAsEntered = 0x1p-48;

/// True if a vertex is farther than that from the polygon's support plane as entered
/// (interp/truth/entered_truth.md), exactly; false for a polygon without a plane. `largest` is a
/// bound on the polygon's coordinates.
bool is_bent(const EnteredPolygon& polygon, double largest);

}  // namespace displayfile
