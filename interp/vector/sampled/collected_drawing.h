#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "displayfile/display_file.h"
#include "interp/output_device.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// What a display file draws, gathered so that it can be drawn in another order: the visible
/// segments' polygons and lines after the image transformation, in order of entry.
struct CollectedDrawing {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Polygon {
    std::size_t first;  ///< of its vertices and sides
    std::uint32_t size;
    std::uint32_t segment, fill_style, line_style;  ///< indices
    std::int32_t pick;
    bool filled;  ///< solid, of some area, and its depth is known
    PixelDepth depth;
    double nearest, farthest;  ///< z of its vertices
    int first_row, last_row;   ///< those it may reach; none if first_row > last_row
  };
  /// A line, or a drawn side of a polygon with its depth on the polygon's plane.
  struct Line {
    Point3 from, to;
    std::uint32_t polygon;  ///< whose side it is, or kNone
    std::uint32_t segment, style;
    double dash_start;  ///< pixels drawn of the line that it continues
  };

  int width, height;
  std::vector<int> segments;  ///< names
  std::vector<FillStyle> fill_styles;
  std::vector<LineStyle> line_styles;
  std::vector<Point3> vertices;  ///< normalised device coordinates
  std::vector<std::int32_t> sides;
  std::vector<Polygon> polygons;
  std::vector<Line> lines;

  std::span<const Point3> vertices_of(const Polygon& p) const {
    return std::span(vertices).subspan(p.first, p.size);
  }
  DrawnPolygon drawn(const Polygon& p) const {
    return {vertices_of(p), std::span(sides).subspan(p.first, p.size), fill_styles[p.fill_style],
            line_styles[p.line_style], p.pick};
  }
  Point3 to_pixels(const Point3& device) const {
    return {device.x * width, device.y * height, device.z};
  }
  /// True if the point (pixel coordinates) belongs to the polygon, by the even-odd rule and the
  /// rule for centres on an edge.
  bool covers(const Polygon& p, double x, double y) const;
};

/// For a picture of width x height pixels.
CollectedDrawing collect(const DisplayFile& display_file, int width, int height);

}  // namespace displayfile
