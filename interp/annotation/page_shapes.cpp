#include "interp/annotation/page_shapes.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace displayfile {

namespace {

double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// The corners of the convex hull, counterclockwise, in doubles: Andrew, "Another efficient
/// algorithm for convex hulls in two dimensions", Information Processing Letters 9 (1979).
std::vector<Point2> convex_hull(std::vector<Point2> points) {
  std::ranges::sort(points, {}, [](const Point2& p) { return std::pair(p.x, p.y); });
  std::vector<Point2> hull;
  const auto add_chain = [&](const auto& range) {
    const std::size_t first = hull.size();
    for (const Point2& p : range) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
  };
  add_chain(points);
  std::ranges::reverse(points);
  add_chain(points);
  return hull;
}

}  // namespace

Rectangle rectangle_of(std::span<const Point2> points) {
  Rectangle all = Rectangle::nothing();
  for (const Point2& p : points) all.include(p);
  return all;
}

std::vector<Point2> corners_of(const Rectangle& box) {
  return {{box.x_min, box.y_min},
          {box.x_max, box.y_min},
          {box.x_max, box.y_max},
          {box.x_min, box.y_max}};
}

bool is_within(const Rectangle& inner, const Rectangle& outer) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

bool are_apart(const Rectangle& a, const Rectangle& b, double by) {
  return a.x_min >= b.x_max + by || b.x_min >= a.x_max + by || a.y_min >= b.y_max + by ||
         b.y_min >= a.y_max + by;
}

bool are_apart(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> axes,
               double by) {
  return std::ranges::any_of(axes, [&](const Point2& axis) {
    const auto extent = [&](std::span<const Point2> points) {
      std::pair<double, double> range{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
      for (const Point2& p : points) {
        const double at = glm::dot(p, axis);
        range = {std::min(range.first, at), std::max(range.second, at)};
      }
      return range;
    };
    const auto of_a = extent(a), of_b = extent(b);
    return of_a.first >= of_b.second + by || of_b.first >= of_a.second + by;
  });
}

bool cross_each_other(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto turn = [](const Point2& p, const Point2& q, const Point2& r) {
    return cross(q - p, r - p);
  };
  return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

FigureOutline::FigureOutline(std::vector<Point2> points)
    : corners_(convex_hull(std::move(points))), around_(rectangle_of(corners_)) {
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    const Point2 along = corners_[i] - corners_[i - 1];
    const double length = glm::length(along);
    if (!(length > 0.0)) continue;
    const Point2 out = Point2(along.y, -along.x) / length;
    sides_.push_back({out, std::max(glm::dot(out, corners_[i - 1]), glm::dot(out, corners_[i]))});
  }
}

bool FigureOutline::is_clear_of(std::span<const Point2> points, double by) const {
  if (is_empty() || are_apart(rectangle_of(points), around_, by)) return true;
  return std::ranges::any_of(sides_, [&](const Side& side) {
    return std::ranges::all_of(
        points, [&](const Point2& p) { return glm::dot(side.out, p) >= side.at + by; });
  });
}

}  // namespace displayfile
