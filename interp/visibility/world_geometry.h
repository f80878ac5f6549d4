#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/geometry/corners.h"
#include "clip/view.h"
#include "clip/view/view_volume.h"
#include "hidden/boxes/space_tree.h"
#include "hidden/exact/ball.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/rounding.h"

/// The geometry of rays in world coordinates (interp/visibility/ray_cast.md): one algorithm, two
/// precisions. Numbers are balls first, and exact where these leave a decision open.
namespace displayfile::in_world {

inline constexpr int kUndecided = 2;
inline int sign_of(const Ball& a) { return decided(a) ? decided_sign(a.middle) : kUndecided; }
inline int sign_of(const ExactNumber& a) { return a.sign(); }

template <class Number>
Number number(double value);
template <>
inline Ball number(double value) {
  return {value, 0.0};
}
template <>
inline ExactNumber number(double value) {
  return ExactNumber(value);
}

/// World coordinates, homogeneous; w is positive.
template <class Number>
struct WorldPoint {
  Number x, y, z, w;
};
template <class Number>
WorldPoint<Number> world_point(const Point3& p) {
  return {number<Number>(p.x), number<Number>(p.y), number<Number>(p.z), number<Number>(1.0)};
}
template <class Number>
using WorldPoints = std::vector<WorldPoint<Number>>;
/// Three points of a plane.
template <class Number>
using WorldPlane = std::array<WorldPoint<Number>, 3>;

/// A x + B y + C z + D w.
template <class Number>
struct Linear {
  Number a, b, c, d;
  Number at(const WorldPoint<Number>& p) const { return a * p.x + b * p.y + c * p.z + d * p.w; }

  friend Linear operator+(const Linear& f, const Linear& g) {
    return {f.a + g.a, f.b + g.b, f.c + g.c, f.d + g.d};
  }
  friend Linear operator-(const Linear& f, const Linear& g) {
    return {f.a - g.a, f.b - g.b, f.c - g.c, f.d - g.d};
  }
  Linear times(const Number& s) const { return {a * s, b * s, c * s, d * s}; }
};

/// A linear function over boxes whose coordinates are at most `size` in magnitude, with an error
/// bound for all rounding.
class OverBoxes {
 public:
  OverBoxes(const Linear<Ball>& f, const Point3& size)
      : normal_{f.a.middle, f.b.middle, f.c.middle} {
    const double error = error_of(f.a) * size.x + error_of(f.b) * size.y + error_of(f.c) * size.z +
                         2.0 * error_of(f.d) + kTiny;
    offset_ = {f.d.middle, 2.0 * error};
    least_offset_ = f.d.middle - 2.0 * error;
    most_offset_ = f.d.middle + 2.0 * error;
  }

  /// At a point whose coordinates are within that size.
  Ball at(const Point3& p) const {
    const double value = normal_[0] * p.x + normal_[1] * p.y + normal_[2] * p.z;
    return {value + offset_.middle, offset_.radius};
  }

  using EachBox = std::array<double, SpaceBoxes::kBoxes>;
  double most(const Bounds& box) const {
    SpaceBoxes boxes{};
    boxes.set(0, box);
    return most(boxes)[0];
  }
  /// A lower bound over each box; it is at a corner, which the signs determine.
  EachBox least(const SpaceBoxes& boxes) const {
    return at_corners(boxes.low, boxes.high, least_offset_);
  }
  EachBox most(const SpaceBoxes& boxes) const {
    return at_corners(boxes.high, boxes.low, most_offset_);
  }

 private:
  /// Visits one axis after the other, according to whether the function rises or falls along it.
  template <class Sides>
  EachBox at_corners(const Sides& rising, const Sides& falling, double offset) const {
    const auto& x = normal_[0] < 0.0 ? falling[0] : rising[0];
    const auto& y = normal_[1] < 0.0 ? falling[1] : rising[1];
    const auto& z = normal_[2] < 0.0 ? falling[2] : rising[2];
    EachBox values;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = normal_[0] * x[k] + normal_[1] * y[k] + normal_[2] * z[k] + offset;
    }
    return values;
  }
  /// Bounds the at most eight roundings of one unit in which a term takes part.
  static double error_of(const Ball& of) { return of.radius + 16.0 * kUnit * std::abs(of.middle); }

  std::array<double, 3> normal_;
  double least_offset_, most_offset_;
  Ball offset_;
};

// ---- A view ---------------------------------------------------------------------------------

/// The rows of the view's matrix, those of x and y to the viewport: a point's device coordinates
/// are x / w, y / w and z / w.
template <class Number>
struct MatrixRows {
  Linear<Number> x, y, z, w;
  Linear<Number> window_x, window_y;  ///< from 0 to w in the window
  /// Not negative in front of the eye, and between the front plane and the back plane.
  std::vector<Linear<Number>> clip{};
  std::vector<Linear<Number>> sides{};  ///< not negative in the window

  MatrixRows(const View& view, const ViewVolume& volume) {
    const glm::dmat4& m = volume.matrix();
    const auto row = [&](int i) -> Linear<Number> {
      return {number<Number>(m[0][i]), number<Number>(m[1][i]), number<Number>(m[2][i]),
              number<Number>(m[3][i])};
    };
    z = row(2);
    w = row(3);
    const auto between = [&](double low, double high, int i) {
      if (low == 0.0 && high == 1.0) return row(i);
      return w.times(number<Number>(low)) +
             row(i).times(number<Number>(high) - number<Number>(low));
    };
    x = between(view.viewport.x_min, view.viewport.x_max, 0);
    y = between(view.viewport.y_min, view.viewport.y_max, 1);
    // Not by z and w, whose rounded coefficients would displace the planes from where they were
    // set.
    const glm::dmat4& plane = volume.view_plane();
    const Linear<Number> toward{number<Number>(plane[0][2]), number<Number>(plane[1][2]),
                                number<Number>(plane[2][2]), number<Number>(plane[3][2])};
    const Number zero = number<Number>(0.0);
    const auto always = [&](double value) -> Linear<Number> {
      return {zero, zero, zero, number<Number>(value)};
    };
    if (view.back_clipping) clip.push_back(toward - always(volume.back_z()));
    if (view.front_clipping) {
      clip.push_back(always(volume.front_z()) - toward);
    } else if (view.projection == View::Projection::perspective) {
      Linear<Number> beyond = w;  // inside_distance's, of the plane at the eye
      beyond.d = beyond.d - number<Number>(volume.nearest_w());
      clip.push_back(beyond);
    }
    window_x = row(0);
    window_y = row(1);
    sides = {window_x, w - window_x, window_y, w - window_y};
  }
};

// ---- A ray ----------------------------------------------------------------------------------

/// A ray as the intersection of two planes through the eye: through a column of pixel centres and
/// through a row. Points right of the column and above the row are on the positive sides.
template <class Number>
struct Ray {
  Linear<Number> column, row;
};
/// A device coordinate as a quotient of doubles, as that of a pixel's centre is exactly.
struct Quotient {
  double above, below;
};
inline Quotient centre(int pixel, int pixels) { return {2.0 * pixel + 1.0, 2.0 * pixels}; }

/// The plane of all points with that device coordinate; `along` is the coordinate's row of the
/// view's matrix.
template <class Number>
Linear<Number> plane_at(const Linear<Number>& along, const Quotient& at, const Linear<Number>& w) {
  return along.times(number<Number>(at.below)) - w.times(number<Number>(at.above));
}

// ---- A polygon ------------------------------------------------------------------------------

enum class Clipping { undecided, nothing, something };  ///< was cut away

/// A step of Sutherland and Hodgman's clipping. It is not the clip pipeline's, which divides and
/// rounds: here exact numbers must give the same result as rounded ones. A vertex on the plane is
/// inside, and an edge is cut only from strictly inside to outside.
template <class Number>
Clipping clip(const Linear<Number>& inside, WorldPoints<Number>& points, WorldPoints<Number>& cut) {
  bool is_outside = false;
  for (const WorldPoint<Number>& p : points) {
    const int sign = sign_of(inside.at(p));
    if (sign == kUndecided) return Clipping::undecided;
    is_outside |= sign < 0;
  }
  if (!is_outside) return Clipping::nothing;
  cut.clear();
  Number from = inside.at(points.back());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Number to = inside.at(points[i]);
    const int sign_from = sign_of(from), sign_to = sign_of(to);
    if (sign_from * sign_to < 0) {
      const WorldPoint<Number>& a = points[previous_corner(i, points.size())];
      const WorldPoint<Number>& b = points[i];
      const Number s = sign_from < 0 ? -from : from, t = sign_to < 0 ? -to : to;
      cut.push_back({b.x * s + a.x * t, b.y * s + a.y * t, b.z * s + a.z * t, b.w * s + a.w * t});
    }
    if (sign_to >= 0) cut.push_back(points[i]);
    from = std::move(to);
  }
  points.swap(cut);
  return Clipping::something;
}
/// Clips by one plane after the other.
template <class Number>
Clipping clip(const std::vector<Linear<Number>>& planes, WorldPoints<Number>& points,
              WorldPoints<Number>& cut) {
  Clipping all = Clipping::nothing;
  for (const Linear<Number>& inside : planes) {
    const Clipping by_this = clip(inside, points, cut);
    if (by_this == Clipping::undecided) return by_this;
    if (by_this == Clipping::something) all = by_this;
  }
  return all;
}

/// The part of a polygon in the view volume.
template <class Number>
Clipping clip_whole(std::span<const Point3> polygon, const MatrixRows<Number>& view,
                    WorldPoints<Number>& points, WorldPoints<Number>& cut) {
  points.clear();
  for (const Point3& v : polygon) points.push_back(world_point<Number>(v));
  const Clipping before = clip(view.clip, points, cut);
  if (before == Clipping::undecided) return before;
  const Clipping in_window = clip(view.sides, points, cut);
  return in_window == Clipping::nothing ? before : in_window;
}

/// Coverage by the even-odd rule of interp/truth/truth.md: 1, 0, or kUndecided.
template <class Number>
int covers(const WorldPoints<Number>& points, const Ray<Number>& ray) {
  if (points.empty()) return 0;
  bool covered = false;
  Number from_u = ray.column.at(points.back()), from_v = ray.row.at(points.back());
  int from_side = sign_of(from_v);
  for (const WorldPoint<Number>& point : points) {
    Number u = ray.column.at(point), v = ray.row.at(point);
    const int side = sign_of(v);
    if (side == kUndecided || from_side == kUndecided) return kUndecided;
    if ((from_side < 0) != (side < 0)) {
      const int crossing = sign_of(from_u * v - u * from_v);
      if (crossing == kUndecided) return kUndecided;
      if ((from_side < 0 ? crossing : -crossing) <= 0) covered = !covered;
    }
    from_u = std::move(u);
    from_v = std::move(v);
    from_side = side;
  }
  return covered ? 1 : 0;
}

/// A point in the picture: x / w, y / w.
template <class Number>
struct Place {
  Number x, y, w;
};
template <class Number>
std::vector<Place<Number>> places(const WorldPoints<Number>& points,
                                  const MatrixRows<Number>& view) {
  std::vector<Place<Number>> places;
  places.reserve(points.size());
  for (const WorldPoint<Number>& p : points) {
    places.push_back({view.x.at(p), view.y.at(p), view.w.at(p)});
  }
  return places;
}

/// The orientation in the picture of a polygon entirely in front of the eye, -1, 0 or 1: the sign
/// of its area, the sum of the signed areas of its parts.
inline int turn_in_picture(const WorldPoints<ExactNumber>& points,
                           const MatrixRows<ExactNumber>& view) {
  const std::vector<Place<ExactNumber>> at = places(points, view);
  ExactNumber sum, below(1.0);  // of quotients
  for (std::size_t i = 2; i < at.size(); ++i) {
    const auto &p = at[0], &q = at[i - 1], &r = at[i];
    const ExactNumber twice_area = p.x * (q.y * r.w - q.w * r.y) - p.y * (q.x * r.w - q.w * r.x) +
                                   p.w * (q.x * r.y - q.y * r.x);
    const ExactNumber of_both = q.w * r.w;  // positive
    sum = sum * of_both + twice_area * below;
    below = below * of_both;
  }
  return sum.sign();
}

// ---- Intersection of a ray and a plane ------------------------------------------------------

/// The hit is the sum of three points of the plane, each weighted by the values of the ray's planes
/// at the other two.
template <class Number>
struct Hit {
  Number z, w;                ///< the depth in the view is z / w
  Number nearness, of_world;  ///< their quotient; larger ones hide smaller ones
};
template <class Number>
Number cross(const Number& au, const Number& av, const Number& bu, const Number& bv) {
  return au * bv - av * bu;
}
template <class Number>
std::array<Number, 3> weights(const WorldPlane<Number>& plane, const Ray<Number>& ray) {
  std::array<Number, 3> u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = ray.column.at(plane[i]);
    v[i] = ray.row.at(plane[i]);
  }
  return {cross(u[1], v[1], u[2], v[2]), cross(u[2], v[2], u[0], v[0]),
          cross(u[0], v[0], u[1], v[1])};
}
template <class Number>
Hit<Number> hit_of(const WorldPlane<Number>& plane, const Ray<Number>& ray,
                   const MatrixRows<Number>& view, bool perspective) {
  const std::array<Number, 3> weight = weights(plane, ray);
  Hit<Number> hit{number<Number>(0.0), number<Number>(0.0), number<Number>(0.0),
                  number<Number>(0.0)};
  for (std::size_t i = 0; i < 3; ++i) {
    hit.z = hit.z + weight[i] * view.z.at(plane[i]);
    hit.w = hit.w + weight[i] * view.w.at(plane[i]);
    hit.of_world = hit.of_world + weight[i] * plane[i].w;
  }
  hit.nearness = perspective ? -hit.w : hit.z;
  return hit;
}

/// The same point, rounded, in world coordinates. Throws Error if it is out of the range of
/// doubles.
inline Point3 point_hit(const WorldPlane<ExactNumber>& plane, const Ray<ExactNumber>& ray) {
  const std::array<ExactNumber, 3> weight = weights(plane, ray);
  WorldPoint<ExactNumber> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.x = sum.x + weight[i] * plane[i].x;
    sum.y = sum.y + weight[i] * plane[i].y;
    sum.z = sum.z + weight[i] * plane[i].z;
    sum.w = sum.w + weight[i] * plane[i].w;
  }
  if (sum.w.sign() == 0) throw Error("the visible point is infinitely far away");
  return {rounded_quotient(sum.x, sum.w), rounded_quotient(sum.y, sum.w),
          rounded_quotient(sum.z, sum.w)};
}

/// The sign of a's depth less b's, or kUndecided. Neither is edge-on.
template <class Number>
int compare(const Hit<Number>& a, const Hit<Number>& b) {
  const int difference = sign_of(a.z * b.w - b.z * a.w);
  const int of_a = sign_of(a.w), of_b = sign_of(b.w);
  if (difference == kUndecided || of_a == kUndecided || of_b == kUndecided) return kUndecided;
  return difference * of_a * of_b;
}

}  // namespace displayfile::in_world
