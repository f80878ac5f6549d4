#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/hatched_faces.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The fills of a picture, hatched (interp/vector/pens/hatching.md). A tone whose flat faces cover
/// much of the picture gets lines that are evenly apart, at a spacing of its own; all others share
/// one grid, and of two the darker has all lines of the lighter.
class HatchedFills {
 public:
  /// In millimetres on the sheet, y down; clipped to the frame. Lines shorter than the pen is wide
  /// are omitted, unless `crumbs` is set (hidden/lines/strokes_once.md).
  HatchedFills(const Hatching& hatching, const Rectangle& frame, bool crumbs = false)
      : hatching_(hatching), frame_(frame), shortest_(crumbs ? 0.0 : hatching.width) {}

  /// Adds a polygon by the even-odd rule, with its darkness (Darkness) at each vertex, linear
  /// between them. It covers earlier ones, unless it is known to overlap none. `slope` is that of
  /// its plane, as in HatchedFill.
  void add(std::span<const Point2> polygon, std::span<const double> darkness, bool overlaps_nothing,
           const Point2& slope = Point2(0.0));

  /// All lines, one direction after the other.
  std::vector<Stroke> strokes() const;

 private:
  using Fill = HatchedFill;
  std::span<const Point2> polygon(const Fill& fill) const {
    return std::span(points_).subspan(fill.first, fill.end - fill.first);
  }
  double darkness(const Fill& fill) const { return darkness_[fill.first]; }
  /// The tones of flat faces that cover much of the picture, in order.
  struct LargeTones {
    std::vector<double> of_fill;  ///< of the face of each fill; 0: none of these
    std::vector<double> tones;
  };
  LargeTones large_tones() const;
  void add_direction(double degrees, double factor, double less, const LargeTones& large,
                     std::vector<Stroke>& strokes) const;

  Hatching hatching_;
  Rectangle frame_;
  double shortest_;  // line, in mm
  std::vector<Fill> fills_;
  std::vector<Point2> points_;
  std::vector<double> darkness_;  // at each point
  bool overlap_ = false;
};

}  // namespace displayfile
