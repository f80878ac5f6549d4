#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "interp/device/picture.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The fraction of the lines of a full hatching that a fill gets: 0 as bright as the paper, 1 as
/// dark as the pen. Colours are compared by luma (ITU-R BT.709).
class Darkness {
 public:
  Darkness(const Colour& paper, const Colour& pen);
  /// The darkness of a fill; below 0 if it is brighter than the paper, above 1 if darker than the
  /// pen.
  double of(const Colour& fill) const { return (paper_ - luma(fill)) * scale_; }
  static double luma(const Colour& colour);

 private:
  double paper_, scale_;
};

/// Hatching lines in one direction. All lines of the sheet are on one grid; a fill gets the share
/// of them that corresponds to its darkness, and of two fills the darker gets all lines of the
/// lighter (interp/vector/pens/hatching.md): so lines continue across pieces.
class HatchLines {
 public:
  /// In millimetres on the sheet, y down; clipped to the frame.
  HatchLines(double spacing, double degrees, const Rectangle& frame);

  /// Adds a polygon by the even-odd rule, with its darkness at each vertex, linear between them. It
  /// covers earlier ones.
  void add(std::span<const Point2> polygon, std::span<const double> darkness);
  /// The lines, each of maximal length; none shorter than `shortest` millimetres.
  std::vector<Stroke> strokes(double shortest);

 private:
  struct Span {
    std::int32_t line;
    std::uint32_t order;
    double from, to;
    double dark_from, dark_to;
  };
  struct Crossing {
    std::int32_t line;
    double at, darkness;
  };
  struct Part {
    double from, to;
  };

  double across(std::int32_t line) const { return (line + 0.5) * spacing_; }
  void add_crossings(const Point2& a, const Point2& b, double dark_a, double dark_b);
  void find_inked(std::span<const Span> spans);
  void find_nearest_of_overlapping(std::span<const Span> spans);
  void ink(const Span& span, double from, double to);
  void add_strokes(double shortest, std::vector<Stroke>& strokes) const;

  double spacing_, cosine_, sine_;
  Rectangle frame_;
  double low_ = 0.0, high_ = 0.0;  // across, of the frame
  std::uint32_t next_order_ = 0;
  std::vector<Span> spans_;
  std::vector<Crossing> crossings_;
  std::vector<Part> inked_;  // of one line
  std::int32_t line_ = 0;    // that it is
  double threshold_ = 0.0;   // and the darkness from which it is drawn
};

}  // namespace displayfile
