#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/rectangle.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The fills of a picture, hatched (interp/vector/pens/hatching.md). A tone that covers much of the
/// picture gets lines that are evenly apart, at a spacing of its own; all others share one grid,
/// and of two the darker has all lines of the lighter.
class HatchedFills {
 public:
  /// Millimetres on the sheet, y down; only inside of the frame.
  HatchedFills(const Hatching& hatching, const Rectangle& frame)
      : hatching_(hatching), frame_(frame) {}

  /// A polygon by the even-odd rule, with its darkness (Darkness) at each vertex, linear between
  /// them. It covers earlier ones, unless it is known to overlap none.
  void add(std::span<const Point2> polygon, std::span<const double> darkness,
           bool overlaps_nothing);

  /// All lines, in one direction after the other.
  std::vector<Stroke> strokes() const;

 private:
  struct Fill {
    std::size_t first, end;  // in points_
    bool is_even;            // as dark everywhere
  };
  std::span<const Point2> polygon(const Fill& fill) const {
    return std::span(points_).subspan(fill.first, fill.end - fill.first);
  }
  double darkness(const Fill& fill) const { return darkness_[fill.first]; }
  std::vector<Point3> corners_of_uneven() const;
  std::vector<double> large_tones() const;
  void add_direction(double degrees, double factor, double less,
                     std::vector<Stroke>& strokes) const;

  Hatching hatching_;
  Rectangle frame_;
  std::vector<Fill> fills_;
  std::vector<Point2> points_;
  std::vector<double> darkness_;  // at each point
  bool overlap_ = false;
};

}  // namespace displayfile
