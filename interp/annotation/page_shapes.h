#pragma once

#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"

namespace displayfile {

/// The smallest rectangle around points.
Rectangle rectangle_of(std::span<const Point2> points);
/// In order around it.
std::vector<Point2> corners_of(const Rectangle& box);
bool is_within(const Rectangle& inner, const Rectangle& outer);
bool are_apart(const Rectangle& a, const Rectangle& b, double by);

/// True if the points' extents along some axis are that far apart: then so are their convex hulls.
/// Axes have length 1.
bool are_apart(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> axes,
               double by);

/// True if the lines from a to b and from c to d have a point in common that is no end of either.
bool cross_each_other(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// The convex outline of a figure.
class FigureOutline {
 public:
  explicit FigureOutline(std::vector<Point2> points);

  bool is_empty() const { return corners_.empty(); }
  std::span<const Point2> corners() const { return corners_; }
  const Rectangle& around() const { return around_; }

  /// True if all points are beyond one side of the outline, or of the rectangle around it, by that
  /// distance: then so is their convex hull. Always true of an empty outline.
  bool is_clear_of(std::span<const Point2> points, double by) const;

 private:
  /// The outer half plane of a side: the points p with dot(out, p) > at.
  struct Side {
    Point2 out;
    double at;
  };
  std::vector<Point2> corners_;
  std::vector<Side> sides_;
  Rectangle around_ = Rectangle::nothing();
};

}  // namespace displayfile
