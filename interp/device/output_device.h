#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "displayfile/intensity_plane.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/segment.h"
#include "hidden/line_cuts.h"

namespace displayfile {

/// A polygon as the interpreter meets it: normalised device coordinates (x, y in [0,1] over
/// the picture, y up; nearer is larger z) after the image transformation. sides[i] is op::line
/// if the edge that ends at vertex i is drawn, op::move if not.
struct DrawnPolygon {
  std::span<const Point3> vertices;
  std::span<const std::int32_t> sides;
  const FillStyle& fill;
  const LineStyle& line;
  std::int32_t pick;
  /// The intensities of the vertices of a shaded polygon, which was cut from one triangle: the fill
  /// colour is to be multiplied by the intensity, linear over the picture. Empty if the polygon is
  /// flat.
  std::span<const double> intensities = {};
  /// The kinds of line that the sides are, 0 of those that are not drawn. Empty if nobody asked.
  std::span<const LineKinds> kinds = {};
  /// With Phong shading (displayfile/looks/phong.md) the normals of the vertices too, and the light
  /// that they are seen in, for a device that lights each pixel: to others it is Gouraud shading.
  std::span<const Point3> normals = {};
  const Light* light = nullptr;
  /// 1 for each vertex at which a drawn side was cut, by what may hide the rest of it. Empty if
  /// none was.
  std::span<const std::uint8_t> cuts = {};
};

/// Where a polygon is filled with one colour: a shaded one gets the mean of its
/// intensities.
inline FillStyle even_fill(const DrawnPolygon& polygon) {
  if (polygon.intensities.empty()) return polygon.fill;
  return lit(polygon.fill, mean_intensity(polygon.intensities));
}

/// A line as the interpreter meets it; never in line style none.
struct DrawnLine {
  Point3 from, to;
  const LineStyle& style;
  LineKinds kinds = kDrawn;
  LineCuts cuts = {};
};

/// Where the interpreter draws: the one interface every output device has.
class OutputDevice {
 public:
  virtual ~OutputDevice() = default;
  /// The picture's size in pixels, or in whatever the widths of lines are: strokes that are shorter
  /// than their lines are wide, and join no other, are left out (hidden/lines/strokes_once.md). 0:
  /// all are drawn.
  virtual Point2 pixels() const { return Point2(0.0); }
  /// The instructions that follow, up to end_segment, are the segment's.
  virtual void begin_segment(int /*name*/) {}
  virtual void end_segment() {}
  /// The fills that follow, up to end_disjoint_fills, do not overlap: they tile what is seen. Sides
  /// of neighbours are the same, bit for bit, in opposite directions, and a vertex on a neighbour's
  /// side is a vertex of the neighbour too. Segments may begin and end in between; no lines do.
  virtual void begin_disjoint_fills() {}
  virtual void end_disjoint_fills() {}
  virtual void fill(const DrawnPolygon& polygon) = 0;   ///< the inside, in the fill style
  virtual void edges(const DrawnPolygon& polygon) = 0;  ///< the visible edges, in the line style
  virtual void line(const DrawnLine& line) = 0;
};

}  // namespace displayfile
