#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/support_plane.h"
#include "interp/output_device.h"
#include "interp/picture.h"
#include "interp/scan/line_draw.h"
#include "interp/scan/pixel_depth.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

/// Lines, and the visible edges of polygons, as pixels: plot(column, row, z, colour) is called for
/// each in the region's rows. Dashes run on from line to line, also outside of them.
class LinePainter {
 public:
  explicit LinePainter(const ScanConverter::Region& region) : region_(region) {}

  template <class Plot>
  void line(const DrawnLine& line, Plot&& plot) {
    if (pixel(line.from) != dash_end_) dash_phase_ = {};
    const std::uint32_t colour = pixel_of(line.style.colour);
    draw_line(pixel(line.from), pixel(line.to), line.style, region_, dash_phase_,
              [&](int x, int y, double z) { plot(x, y, z, colour); });
    dash_end_ = pixel(line.to);
  }

  /// An edge's z is that of the polygon's support plane.
  template <class Plot>
  void edges(const DrawnPolygon& polygon, Plot&& plot) {
    const PictureSize& size = region_.size;
    if (!may_reach_rows(polygon)) return;
    const SupportVertices support = support_vertices(polygon.vertices);
    std::optional<PixelDepth> depth;
    if (!support.edge_on) depth.emplace(polygon.vertices, support, size.width, size.height);
    const DepthRange range = depth_range(polygon.vertices);
    const std::uint32_t colour = pixel_of(polygon.line.colour);
    DashPhase phase;
    Point3 from = pixel(polygon.vertices.back());
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const Point3 to = pixel(polygon.vertices[i]);
      if (polygon.sides[i] == op::line) {
        draw_line(from, to, polygon.line, region_, phase, [&](int x, int y, double z) {
          if (depth) {
            // The polygon's plane, but half a pixel beyond a polygon seen nearly edge-on
            // that plane is anywhere: no nearer or farther than the polygon itself.
            const double at_centre = depth->at(depth->row(y), x);
            z = std::clamp(at_centre, range.farthest, range.nearest);
          }
          plot(x, y, z, colour);
        });
      } else {
        phase = {};
      }
      from = to;
    }
  }

 private:
  struct DepthRange {
    double nearest, farthest;
  };
  /// The range of the vertices' depths, and a little more: rounding may put the polygon's own fill
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
  bool may_reach_rows(const DrawnPolygon& polygon) const {
    double low = polygon.vertices[0].y, high = low;
    for (const Point3& v : polygon.vertices) {
      low = std::min(low, v.y);
      high = std::max(high, v.y);
    }
    const double height = region_.size.height;
    const double rounding = 1e-12 * height * (std::abs(low) + std::abs(high));
    const double reach = std::max(1.0, polygon.line.width) + 2.0 + rounding;  // also of a slant
    return low * height - reach < region_.row_end && high * height + reach > region_.row_begin;
  }
  Point3 pixel(const Point3& device) const {
    return {device.x * region_.size.width, device.y * region_.size.height, device.z};
  }

  ScanConverter::Region region_;
  DashPhase dash_phase_;
  Point3 dash_end_{-std::numeric_limits<double>::infinity()};
};

}  // namespace displayfile
