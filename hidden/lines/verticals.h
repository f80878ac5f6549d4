#pragma once

#include <cassert>
#include <cmath>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "hidden/lines/grid_surface.h"

namespace displayfile {

/// The images of a surface's verticals: parallel lines, or lines through their vanishing point. A
/// projective map transforms them to the columns x = constant, running up as y grows; straight
/// lines stay straight. Its coordinates are rounded, and decide only the column of a point.
class Verticals {
 public:
  explicit Verticals(const GridSurface& surface);

  /// True if the view is along the verticals: the surface hides nothing of itself.
  bool are_points() const { return are_points_; }
  /// True if all of the surface is on one side of the vanishing point, so that each vertical has
  /// one direction; otherwise there are no columns.
  bool make_columns() const { return make_columns_; }

  /// The position of point (i, j), by number, in column coordinates.
  const Point2& in_columns(std::uint32_t number) const {
    assert(number < in_columns_.size());
    return in_columns_[number];
  }
  /// The rectangle around all of them.
  const Rectangle& box() const { return box_; }
  /// Points close to the surface's are no farther apart in column coordinates than this times their
  /// distance in the picture, nearly.
  double largest_scale() const { return largest_scale_; }
  /// The upward direction of the vertical's image at a point.
  Point2 direction_at(const Point2& p) const { return Point2(upward_) - upward_.w * p; }
  /// True if a line runs along the verticals, almost.
  bool are_along(const Point2& a, const Point2& b) const {
    constexpr double kSlope = 1e-6;
    const Point2 up = direction_at(a), way = b - a;
    const double area = way.x * up.y - way.y * up.x;
    return area * area <=
           kSlope * kSlope * (way.x * way.x + way.y * way.y) * (up.x * up.x + up.y * up.y);
  }
  /// The parameter of p's vertical on the line from a to b, in [0,1]; the line does not run along
  /// it.
  double part_at(const Point2& a, const Point2& b, const Point2& p) const {
    const Point2 up = direction_at(p);
    const double of_a = (a.x - p.x) * up.y - (a.y - p.y) * up.x;
    const double of_b = (b.x - p.x) * up.y - (b.y - p.y) * up.x;
    const double part = of_a / (of_a - of_b);
    return part > 0.0 ? std::fmin(part, 1.0) : 0.0;
  }
  /// The parameter of column x on the line from a to b.
  double part_at_column(const Point2& a, const Point2& b, double x) const;

 private:
  /// A point's position: its distance from the middle vertical, divided by the verticals'
  /// convergence there.
  struct Place {
    double across, along, over;
  };
  Place place(const Point2& p) const;

  HomogeneousPoint upward_;
  Point2 middle_{0.0}, up_{0.0}, across_{0.0};
  std::vector<Point2> in_columns_;
  Rectangle box_ = Rectangle::nothing();
  double largest_scale_ = 1.0;
  bool are_points_ = false, make_columns_ = false;
};

}  // namespace displayfile
