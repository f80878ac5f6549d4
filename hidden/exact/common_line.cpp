#include "hidden/exact/common_line.h"

#include "hidden/exact/ball.h"
#include "hidden/exact/depth_order.h"

namespace displayfile {

/// Neighbours in a mesh share points; then no exact arithmetic is needed, here and below.
int CommonLine::side(const Point3& p) const {
  const auto& [one, other] = planes_;
  const int filtered = filtered_depth_order(one, other, {p.x, p.y, 0.0});
  if (filtered != 0) [[likely]]
    return filtered;
  if (one.goes_through(p) && other.goes_through(p)) return 0;
  return exact_depth_order(one, other, Point2(p));
}

/// The plane is nearer where the line's end is behind it.
int CommonLine::nearer(const DefinedPoint& end, const Plane& plane) const {
  return -side_of_plane(definitions(), end, plane);
}

/// True if the end is defined as the cut of p to q by a plane, so that it is the crossing.
bool CommonLine::is_cut_from(const DefinedPoint& end, const Point2& p, const Point2& q) const {
  if (end.kind != DefinedPoint::Kind::edge_cut && end.kind != DefinedPoint::Kind::lifted_edge_cut) {
    return false;
  }
  const Point2 a(points_[end.a]), b(points_[end.b]);
  return (a == p && b == q) || (a == q && b == p);
}

const CommonLine::Ends& CommonLine::ends() const {
  if (!ends_) ends_ = Ends{{definitions(), from_}, {definitions(), to_}};
  return *ends_;
}

double CommonLine::crossing(const Point2& p, const Point2& q) const {
  if (is_cut_from(from_, p, q)) return 0.0;
  if (is_cut_from(to_, p, q)) return 1.0;
  // Most lines cross beyond an end; the rounded ends then decide which one is closer.
  const auto turn_of = [&](const DefinedPoint& v) {
    const double dx = q.x - p.x, dy = q.y - p.y, x = v.near.x - p.x, y = v.near.y - p.y;
    const double left = dx * y, right = dy * x;
    const double bound = 8.0 * kUnit * (std::abs(left) + std::abs(right)) +
                         2.0 * v.radius * (std::abs(dx) + std::abs(dy)) + kTiny;
    return Ball{left - right, bound};
  };
  const Ball at_a = turn_of(from_), at_b = turn_of(to_);
  if (decided(at_a) && decided(at_b) && (at_a.middle > 0.0) == (at_b.middle > 0.0)) {
    const Ball apart =
        Ball{std::abs(at_a.middle), at_a.radius} - Ball{std::abs(at_b.middle), at_b.radius};
    if (decided(apart)) return apart.middle < 0.0 ? 0.0 : 1.0;
  }
  return crossing_parameter(ends().from, ends().to, p, q);
}

double CommonLine::at_point(const Point2& p) const {
  const auto is_at = [&](const DefinedPoint& end) {
    return is_known_in_projection(end) && Point2(end.near) == p;
  };
  if (is_at(from_)) return 0.0;
  if (is_at(to_)) return 1.0;
  return point_parameter(ends().from, ends().to, p);
}

double CommonLine::meeting(const Plane& plane) const {
  return meeting_parameter(ends().from, ends().to, plane);
}

}  // namespace displayfile
