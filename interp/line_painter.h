#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "hidden/pixel_centre.h"
#include "hidden/support_plane.h"
#include "interp/line_draw.h"
#include "interp/output_device.h"
#include "interp/picture.h"
#include "interp/pixel_depth.h"

namespace displayfile {

/// Lines, and the visible edges of polygons, as pixels: plot(column, row, z, colour) is called for
/// each, also outside of the rows that the caller draws. Dashes run on from line to line.
class LinePainter {
 public:
  explicit LinePainter(const PictureSize& size) : size_(size) {}

  template <class Plot>
  void line(const DrawnLine& line, Plot&& plot) {
    if (pixel(line.from) != dash_end_) dash_phase_ = {};
    const std::uint32_t colour = pixel_of(line.style.colour);
    draw_line(pixel(line.from), pixel(line.to), line.style, size_.width, size_.height, dash_phase_,
              [&](int x, int y, double z) { plot(x, y, z, colour); });
    dash_end_ = pixel(line.to);
  }

  /// An edge's z is that of the polygon's support plane.
  template <class Plot>
  void edges(const DrawnPolygon& polygon, Plot&& plot) {
    const SupportVertices support = support_vertices(polygon.vertices);
    std::optional<PixelDepth> depth;
    if (!support.edge_on) depth.emplace(polygon.vertices, support, size_.width, size_.height);
    const DepthRange range = depth_range(polygon.vertices);
    const std::uint32_t colour = pixel_of(polygon.line.colour);
    DashPhase phase;
    Point3 from = pixel(polygon.vertices.back());
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const Point3 to = pixel(polygon.vertices[i]);
      if (polygon.sides[i] == op::line) {
        draw_line(from, to, polygon.line, size_.width, size_.height, phase,
                  [&](int x, int y, double z) {
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
  /// Of the vertices, and a little more: rounding may put the polygon's own fill there.
  static DepthRange depth_range(std::span<const Point3> vertices) {
    double nearest = vertices[0].z, farthest = nearest;
    for (const Point3& v : vertices) {
      nearest = std::max(nearest, v.z);
      farthest = std::min(farthest, v.z);
    }
    const double slack = 1e-6 * (nearest - farthest) + 1e-12;
    return {nearest + slack, farthest - slack};
  }
  Point3 pixel(const Point3& device) const {
    return {device.x * size_.width, device.y * size_.height, device.z};
  }

  PictureSize size_;
  DashPhase dash_phase_;
  Point3 dash_end_{-std::numeric_limits<double>::infinity()};
};

}  // namespace displayfile
