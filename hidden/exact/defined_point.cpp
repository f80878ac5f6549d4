#include "hidden/exact/defined_point.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "hidden/exact/double_double.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// The coordinates of a point as enclosures.
struct BallPoint {
  Ball x, y, z;
};

Ball exactly(double value) { return {value, 0.0}; }
BallPoint exactly(const Point3& p) { return {exactly(p.x), exactly(p.y), exactly(p.z)}; }

/// The plane's first point.
BallPoint point_of(const Plane& plane) {
  BallPoint point = exactly(plane.p);
  point.z.radius = std::abs(plane.rest.x);
  return point;
}
BallPoint normal_of(const Plane& plane) {
  return {{plane.normal.x, plane.bound.x},
          {plane.normal.y, plane.bound.y},
          {plane.normal.z, plane.bound.z}};
}

BallPoint operator+(const BallPoint& a, const BallPoint& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
BallPoint operator-(const BallPoint& a, const BallPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
BallPoint operator*(const BallPoint& a, const Ball& factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}
BallPoint operator/(const BallPoint& a, const Ball& divisor) {
  return {a.x / divisor, a.y / divisor, a.z / divisor};
}
Ball dot(const BallPoint& a, const BallPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
BallPoint cross(const BallPoint& u, const BallPoint& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

Ball value_at(const Plane& plane, const BallPoint& v) {
  return dot(normal_of(plane), v - point_of(plane));
}

BallPoint lifted(const Point3& p, const Plane& own, int axis) {
  const auto difference = [&](int i) {
    Ball apart = ball_of_difference(p[i], own.p[i]);
    if (i == 2) apart.radius += std::abs(own.rest.x);
    return apart;
  };
  const auto normal = [&](int i) { return Ball{own.normal[i], own.bound[i]}; };
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Ball slope = normal(i) * difference(i) + normal(j) * difference(j);
  BallPoint point = exactly(p);
  (axis == 0   ? point.x
   : axis == 1 ? point.y
               : point.z) =
      Ball{own.p[axis], axis == 2 ? std::abs(own.rest.x) : 0.0} - slope / normal(axis);
  return point;
}

/// Computed from the end nearer to the plane, where the step's rounding error is smaller.
BallPoint met_by(const BallPoint& a, const BallPoint& b, const Plane& cut) {
  const Ball at_a = value_at(cut, a), at_b = value_at(cut, b);
  const bool from_a = std::abs(at_a.middle) <= std::abs(at_b.middle);
  const Ball& at_start = from_a ? at_a : at_b;
  const Ball& at_end = from_a ? at_b : at_a;
  const BallPoint& start = from_a ? a : b;
  const BallPoint& end = from_a ? b : a;
  return start + (end - start) * (at_start / (at_start - at_end));
}

/// Cramer's rule, relative to a point of the first plane, so that this plane's right side is zero.
BallPoint meeting(const Plane& first, const Plane& second, const Plane& third) {
  const BallPoint f = normal_of(first), s = normal_of(second), t = normal_of(third);
  const BallPoint origin = point_of(first);
  const Ball at_s = dot(s, point_of(second) - origin), at_t = dot(t, point_of(third) - origin);
  return origin + (cross(t, f) * at_s + cross(f, s) * at_t) / dot(f, cross(s, t));
}

// Up to this limit, products of three normals stay far below the largest double; for larger
// coordinates the filter is undecided, and the exact stage decides.
constexpr double kLargestForBalls = 0x1p+100;

bool within(const Point3& p, double limit) {
  return std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit;
}
bool within(const Plane& plane, double limit) {
  return within(plane.p, limit) && within(plane.q, limit) && within(plane.r, limit);
}

DefinedPoint without_near(DefinedPoint v) {
  v.radius = std::numeric_limits<double>::infinity();
  return v;
}

/// v, with `near` from the enclosure if that is small enough to be useful.
DefinedPoint with_near(DefinedPoint v, const BallPoint& point) {
  const Point3 middle = {point.x.middle, point.y.middle, point.z.middle};
  const Point3 radii = {point.x.radius, point.y.radius, point.z.radius};
  if (!within(middle, kCoordinateLimit) || !within(radii, kCoordinateLimit)) {
    return without_near(v);
  }
  v.near = middle;
  v.radius = std::max(std::max(radii.x, radii.y), radii.z);
  return v;
}

/// True if the definition alone implies that v is on the plane.
bool on_by_definition(const Definitions& all, const DefinedPoint& v, const Plane& plane) {
  const auto is_plane = [&](std::uint32_t k) { return all.planes[k].same_points(plane); };
  switch (v.kind) {
    case DefinedPoint::Kind::stored: return plane.goes_through(v.near);
    case DefinedPoint::Kind::lifted: return is_plane(v.own);
    case DefinedPoint::Kind::edge_cut:
      return is_plane(v.cut) ||
             (plane.goes_through(all.points[v.a]) && plane.goes_through(all.points[v.b]));
    case DefinedPoint::Kind::lifted_edge_cut: return is_plane(v.own) || is_plane(v.cut);
    case DefinedPoint::Kind::plane_cut: return is_plane(v.own) || is_plane(v.a) || is_plane(v.cut);
  }
  return false;
}

bool is_edge_cut(const DefinedPoint& v) {
  return v.kind == DefinedPoint::Kind::edge_cut || v.kind == DefinedPoint::Kind::lifted_edge_cut;
}
bool same_edge(const DefinedPoint& v, const DefinedPoint& w) {
  return (v.a == w.a && v.b == w.b) || (v.a == w.b && v.b == w.a);
}

/// True if the definitions alone imply that a and b are one point.
bool same_by_definition(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b) {
  if (a.kind != b.kind) return false;
  switch (a.kind) {
    case DefinedPoint::Kind::stored: return a.near == b.near;
    case DefinedPoint::Kind::lifted: return a.a == b.a && a.own == b.own;
    case DefinedPoint::Kind::edge_cut: return a.cut == b.cut && same_edge(a, b);
    case DefinedPoint::Kind::lifted_edge_cut:
      return a.cut == b.cut && a.own == b.own && same_edge(a, b);
    case DefinedPoint::Kind::plane_cut:
      return on_by_definition(all, a, all.planes[b.own]) &&
             on_by_definition(all, a, all.planes[b.a]) &&
             on_by_definition(all, a, all.planes[b.cut]);
  }
  return false;
}

/// The line that defines a point: the intersection of two planes, or an edge.
class DefiningLines {
 public:
  DefiningLines(const Definitions& all, const DefinedPoint& v) : all_(all), v_(v) {
    if (v.kind == DefinedPoint::Kind::plane_cut) take(v.a);
    if (v.kind == DefinedPoint::Kind::plane_cut || v.kind == DefinedPoint::Kind::lifted_edge_cut) {
      take(v.own);
    }
    if (v.kind == DefinedPoint::Kind::plane_cut || is_edge_cut(v)) take(v.cut);
  }
  /// True if the definitions imply that both points are on the edge, or on the same two planes.
  bool hold(const DefinedPoint& b, const DefinedPoint& c) const {
    if (v_.kind == DefinedPoint::Kind::edge_cut && on_edge(b) && on_edge(c)) return true;
    int common = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      common += on_by_definition(all_, b, *planes_[i]) && on_by_definition(all_, c, *planes_[i]);
    }
    return common >= 2;
  }

 private:
  void take(std::uint32_t plane) {
    assert(count_ < planes_.size() && plane < all_.planes.size());
    planes_[count_++] = &all_.planes[plane];
  }
  bool on_edge(const DefinedPoint& w) const {
    if (w.kind == DefinedPoint::Kind::stored) {
      return w.near == all_.points[v_.a] || w.near == all_.points[v_.b];
    }
    return w.kind == DefinedPoint::Kind::edge_cut && same_edge(v_, w);
  }

  const Definitions& all_;
  const DefinedPoint& v_;
  std::array<const Plane*, 3> planes_{};
  std::size_t count_ = 0;
};

bool in_line_by_definition(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                           const DefinedPoint& c) {
  return same_by_definition(all, a, b) || same_by_definition(all, b, c) ||
         same_by_definition(all, a, c) || DefiningLines(all, a).hold(b, c) ||
         DefiningLines(all, b).hold(a, c) || DefiningLines(all, c).hold(a, b);
}

// ---- The middle stage: near and its rest --------------------------------------------------------

/// Error bound of the sum of near and its rest.
double error_with_rest(const DefinedPoint& v) {
  constexpr double kRest = 0x1p-22;  // of a radius: the rest is rounded to a float
  return v.has_rest ? v.radius * kRest + kTiny : v.radius;
}
double rest_of(const DefinedPoint& v, int axis) {
  return v.radius * double{v.rest[static_cast<std::size_t>(axis)]};
}

/// The orientation, by near and its rest; 0: undecided.
int orientation_with_rest(const DefinedPoint& a, const DefinedPoint& b, const DefinedPoint& c) {
  constexpr double kDifference = 0x1p-102, kProducts = 0x1p-101;
  if (!is_double_double_sound()) return 0;
  double error = 0.0, largest = 0.0;
  const auto closer = [&](const DefinedPoint& v) {
    if (!is_known_in_projection(v)) error = std::max(error, error_with_rest(v));
    largest = std::max({largest, std::abs(v.near.x), std::abs(v.near.y)});
    const auto sum = [&](int axis) {
      return v.has_rest ? sum_of_ordered(v.near[axis], rest_of(v, axis))
                        : DoubleDouble{v.near[axis], 0.0};
    };
    return std::array{sum(0), sum(1)};
  };
  const auto p = closer(a), q = closer(b), r = closer(c);
  const DoubleDouble px = p[0] - r[0], py = p[1] - r[1], qx = q[0] - r[0], qy = q[1] - r[1];
  const DoubleDouble left = px * qy, right = py * qx, determinant = left - right;
  const double off = 2.0 * error + kDifference * largest;
  const double reach =
      std::abs(px.high) + std::abs(py.high) + std::abs(qx.high) + std::abs(qy.high);
  const double bound =
      off * (reach + 2.0 * off) + kProducts * (std::abs(left.high) + std::abs(right.high));
  const bool is_decided = std::abs(determinant.high) > bound * kInflate + kTiny;
  return is_decided ? decided_sign(determinant.high) : 0;
}

/// The sign of a's coordinate minus b's, by near and its rest; 0: undecided.
int compare_with_rest(const DefinedPoint& a, const DefinedPoint& b, int axis) {
  const double difference = a.near[axis] - b.near[axis];
  const double rest = rest_of(a, axis) - rest_of(b, axis);
  const double bound = error_with_rest(a) + error_with_rest(b) +
                       4.0 * kUnit * (std::abs(difference) + std::abs(rest));
  const double value = difference + rest;
  return std::abs(value) > bound * kInflate + kTiny ? decided_sign(value) : 0;
}

/// The coordinate of a point on a line along which it is constant, as on sides of polygons clipped
/// by a window. Null if it is not known to be constant.
const double* common_coordinate(const Definitions& all, const DefinedPoint& v, int axis) {
  if (is_known(v, axis)) return &v.near[axis];
  const bool is_cut = v.kind == DefinedPoint::Kind::edge_cut ||
                      (v.kind == DefinedPoint::Kind::lifted_edge_cut && v.axis != axis);
  if (!is_cut || all.points[v.a][axis] != all.points[v.b][axis]) return nullptr;
  return &all.points[v.a][axis];
}

/// The sign of a - b along an axis, if exact arithmetic is not needed. Rounding is monotonic, so a
/// rounded difference larger than both radii has the true sign.
std::optional<int> compare_at_hand(const Definitions& all, const DefinedPoint& a,
                                   const DefinedPoint& b, int axis) {
  const double at_a = a.near[axis], at_b = b.near[axis];
  if (is_known(a, axis) && is_known(b, axis)) {
    return (at_a > at_b) - (at_a < at_b);
  }
  const double difference = at_a - at_b;
  if (std::abs(difference) > (a.radius + b.radius) * kInflate + kTiny) {
    return decided_sign(difference);
  }
  if (same_by_definition(all, a, b) || have_one_coordinate(all, a, b, axis)) {
    count_by_definition(Predicate::compare);
    return 0;
  }
  if (!a.has_rest && !b.has_rest) return std::nullopt;
  const int by_rest = compare_with_rest(a, b, axis);
  return by_rest != 0 ? std::optional(by_rest) : std::nullopt;
}

int compare(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b, int axis) {
  if (const auto at_hand = compare_at_hand(all, a, b, axis)) return *at_hand;
  count_exact(Predicate::compare);
  const ExactPoint p = exact_point(all, a), q = exact_point(all, b);
  const auto coordinate = [axis](const ExactVector& v) -> const ExactNumber& {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  };
  const ExactNumber across = coordinate(p.xyz) * q.w - coordinate(q.xyz) * p.w;
  return across.sign() * p.w.sign() * q.w.sign();
}

Point3 rounded(const ExactPoint& p) {
  return {rounded_quotient(p.xyz.x, p.w), rounded_quotient(p.xyz.y, p.w),
          rounded_quotient(p.xyz.z, p.w)};
}

/// v, with these nearest doubles unless they are too large.
DefinedPoint closest_to(DefinedPoint v, const Point3& p) {
  if (!within(p, kCoordinateLimit)) return v;
  v.near = p;
  v.radius = kUnit * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) * kInflate + kTiny;
  return v;
}

int exact_orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const ExactNumber determinant = a.xyz.x * (b.xyz.y * c.w - c.xyz.y * b.w) -
                                  b.xyz.x * (a.xyz.y * c.w - c.xyz.y * a.w) +
                                  c.xyz.x * (a.xyz.y * b.w - b.xyz.y * a.w);
  return determinant.sign() * a.w.sign() * b.w.sign() * c.w.sign();
}

}  // namespace

DefinedPoint stored_point(const Point3& p) { return {.near = p}; }

DefinedPoint lifted_point(const Definitions& all, std::uint32_t a, std::uint32_t own, int axis) {
  assert(a < all.points.size() && own < all.planes.size());
  assert(0 <= axis && axis < 3);
  const DefinedPoint v{.near = all.points[a],
                       .kind = DefinedPoint::Kind::lifted,
                       .axis = static_cast<std::uint8_t>(axis),
                       .a = a,
                       .own = own};
  const Plane& plane = all.planes[own];
  if (plane.goes_through(all.points[a])) return stored_point(all.points[a]);
  if (!within(all.points[a], kLargestForBalls) || !within(plane, kLargestForBalls)) {
    return without_near(v);
  }
  return with_near(v, lifted(all.points[a], plane, axis));
}

DefinedPoint edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b, std::uint32_t cut) {
  assert(a < all.points.size() && b < all.points.size() && cut < all.planes.size());
  const DefinedPoint v{.kind = DefinedPoint::Kind::edge_cut, .a = a, .b = b, .cut = cut};
  const Point3 &p = all.points[a], &q = all.points[b];
  if (!within(p, kLargestForBalls) || !within(q, kLargestForBalls) ||
      !within(all.planes[cut], kLargestForBalls)) {
    return without_near(v);
  }
  return with_near(v, met_by(exactly(p), exactly(q), all.planes[cut]));
}

DefinedPoint lifted_edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b,
                             std::uint32_t own, std::uint32_t cut, int axis) {
  assert(a < all.points.size() && b < all.points.size());
  assert(own < all.planes.size() && cut < all.planes.size());
  assert(0 <= axis && axis < 3);
  const Point3 &p = all.points[a], &q = all.points[b];
  const Plane& plane = all.planes[own];
  if (plane.goes_through(p) && plane.goes_through(q)) return edge_cut(all, a, b, cut);
  const DefinedPoint v{.kind = DefinedPoint::Kind::lifted_edge_cut,
                       .axis = static_cast<std::uint8_t>(axis),
                       .a = a,
                       .b = b,
                       .own = own,
                       .cut = cut};
  if (!within(p, kLargestForBalls) || !within(q, kLargestForBalls) ||
      !within(plane, kLargestForBalls) || !within(all.planes[cut], kLargestForBalls)) {
    return without_near(v);
  }
  return with_near(v, met_by(lifted(p, plane, axis), lifted(q, plane, axis), all.planes[cut]));
}

DefinedPoint plane_cut(const Definitions& all, std::uint32_t own, std::uint32_t first,
                       std::uint32_t second) {
  assert(own < all.planes.size() && first < all.planes.size() && second < all.planes.size());
  const DefinedPoint v{
      .kind = DefinedPoint::Kind::plane_cut, .a = first, .own = own, .cut = second};
  const Plane &p = all.planes[own], &q = all.planes[first], &r = all.planes[second];
  if (!within(p, kLargestForBalls) || !within(q, kLargestForBalls) ||
      !within(r, kLargestForBalls)) {
    return without_near(v);
  }
  return with_near(v, meeting(p, q, r));
}

int exact_side_of_plane(const Definitions& all, const DefinedPoint& v, const Plane& plane) {
  if (on_by_definition(all, v, plane)) {
    count_by_definition(Predicate::side_of_plane);
    return 0;
  }
  count_exact(Predicate::side_of_plane);
  const ExactPoint point = exact_point(all, v);
  return value_at(ExactPlane(plane), point).sign() * point.w.sign();
}

std::optional<int> orientation_at_hand(const Definitions& all, const DefinedPoint& a,
                                       const DefinedPoint& b, const DefinedPoint& c) {
  if (is_known_in_projection(a) && is_known_in_projection(b) && is_known_in_projection(c)) {
    return orientation(a.near, b.near, c.near);
  }
  const int filtered = filtered_turn({a.near, a.radius}, {b.near, b.radius}, {c.near, c.radius});
  if (filtered != 0) return filtered;
  if (in_line_by_definition(all, a, b, c)) {
    count_by_definition(Predicate::side_of_line);
    return 0;
  }
  if (!a.has_rest && !b.has_rest && !c.has_rest) return std::nullopt;
  const int by_rest = orientation_with_rest(a, b, c);
  return by_rest != 0 ? std::optional(by_rest) : std::nullopt;
}

int orientation(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                const DefinedPoint& c) {
  if (const auto at_hand = orientation_at_hand(all, a, b, c)) return *at_hand;
  count_exact(Predicate::side_of_line);
  return exact_orientation(exact_point(all, a), exact_point(all, b), exact_point(all, c));
}

bool have_one_coordinate(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                         int axis) {
  const double* const of_a = common_coordinate(all, a, axis);
  if (of_a == nullptr) return false;
  const double* const of_b = common_coordinate(all, b, axis);
  return of_b != nullptr && *of_a == *of_b;
}

int compare_x(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b) {
  return compare(all, a, b, 0);
}

int compare_y(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b) {
  return compare(all, a, b, 1);
}

int compare_xy(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b) {
  const int by_x = compare_x(all, a, b);
  return by_x != 0 ? by_x : compare_y(all, a, b);
}

std::optional<int> compare_xy_at_hand(const Definitions& all, const DefinedPoint& a,
                                      const DefinedPoint& b) {
  const auto by_x = compare_at_hand(all, a, b, 0);
  return by_x == 0 ? compare_at_hand(all, a, b, 1) : by_x;
}

DefinedPoint refined(const Definitions& all, const DefinedPoint& v) {
  return closest_to(v, rounded(all, v));
}

std::optional<DefinedPoint> refined_if_any(const Definitions& all, const DefinedPoint& v) {
  if (const auto close = rounded_closely(all, v)) return closest_to(v, *close);
  const auto point = exact_point_if_any(all, v);
  return point ? std::optional(closest_to(v, rounded(*point))) : std::nullopt;
}

DefinedPoint with_rest(const Definitions& all, const DefinedPoint& v) {
  if (v.kind == DefinedPoint::Kind::stored) return v;
  const ExactPoint point = exact_point(all, v);
  const Point3 p = rounded(point);
  DefinedPoint closer = closest_to(v, p);
  if (closer.near != p) return v;
  const auto rest = [&](const ExactNumber& coordinate, double near) {
    return static_cast<float>(rounded_quotient(coordinate - ExactNumber(near) * point.w, point.w) /
                              closer.radius);
  };
  closer.rest = {rest(point.xyz.x, p.x), rest(point.xyz.y, p.y), rest(point.xyz.z, p.z)};
  assert(std::ranges::all_of(closer.rest, [](float lack) { return std::abs(lack) <= 1.0F; }));
  closer.has_rest = true;
  return closer;
}

Point3 rounded(const Definitions& all, const DefinedPoint& v) {
  if (v.kind == DefinedPoint::Kind::stored) return v.near;
  const auto close = rounded_closely(all, v);
  return close ? *close : rounded(exact_point(all, v));
}

}  // namespace displayfile
