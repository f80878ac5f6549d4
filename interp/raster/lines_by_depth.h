#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hidden/exact/support_plane.h"
#include "interp/device/output_device.h"
#include "interp/raster/line_painter.h"
#include "interp/raster/raster_band.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// Lines and edges by the picture's depths, for the colour rule with an image-space method
/// (interp/raster/colour_rule.md): at each of a line's pixels its depth is compared with that of
/// the fill visible at the pixel's centre, and it is drawn unless the fill is nearer. An edge's
/// depth there is that of its polygon's support plane.
class LinesByDepth : public OutputDevice {
 public:
  LinesByDepth(const RasterBand& band, double line_scale)
      : band_(band), lines_(band.region, line_scale) {}

  void fill(const DrawnPolygon&) override {}
  void edges(const DrawnPolygon& polygon) override {
    const SupportVertices support = support_vertices(polygon.vertices);
    if (support.edge_on) {
      lines_.edges(polygon, [&](int x, int y, double z, std::uint32_t c) { plot(x, y, z, c); });
      return;
    }
    const PixelDepth depth(polygon.vertices, support, band_.size().width, band_.size().height);
    const DepthRange range = depth_range(polygon.vertices);
    lines_.edges(polygon, [&](int x, int y, double /*z*/, std::uint32_t colour) {
      // The polygon's plane. Half a pixel beyond a polygon seen nearly edge-on its depth is
      // arbitrary: it is clamped to the depths of the polygon itself.
      const double at_centre = depth.at(depth.row(y), x);
      plot(x, y, std::clamp(at_centre, range.farthest, range.nearest), colour);
    });
  }
  void line(const DrawnLine& line) override {
    lines_.line(line, [&](int x, int y, double z, std::uint32_t c) { plot(x, y, z, c); });
  }

 private:
  struct DepthRange {
    double nearest, farthest;
  };
  /// The range of the vertices' depths, slightly enlarged: rounding may put the polygon's own fill
  /// there.
  static DepthRange depth_range(std::span<const Point3> vertices) {
    double nearest = vertices[0].z, farthest = nearest;
    for (const Point3& v : vertices) {
      nearest = std::max(nearest, v.z);
      farthest = std::min(farthest, v.z);
    }
    const double slack = 1e-6 * (nearest - farthest) + 1e-12;
    return {nearest + slack, farthest - slack};
  }
  void plot(int x, int y, double z, std::uint32_t colour) {
    const std::size_t at = band_.index(y, x);
    if (z < band_.picture.depth[at]) return;
    band_.picture.depth[at] = z;
    band_.picture.pixels[at] = colour;
  }

  RasterBand band_;
  LinePainter lines_;
};

}  // namespace displayfile
