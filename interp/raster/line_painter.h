#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "clip/surfaces.h"
#include "displayfile/segments/clipped_ends.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/visible_lines.h"
#include "interp/device/interpreter.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/scan/line_draw.h"
#include "interp/scan/scan_convert.h"
#include "interp/scan/wide_line_draw.h"

namespace displayfile {

/// The visible parts of one line.
class SeenOfLine {
 public:
  explicit SeenOfLine(std::span<const VisiblePiece> pieces) : pieces_(pieces) {}
  bool nothing() const { return pieces_.empty(); }
  bool operator()(double place) const {
    const auto piece = std::ranges::lower_bound(pieces_, place, {}, &VisiblePiece::to);
    return piece != pieces_.end() && piece->from <= place;
  }

 private:
  std::span<const VisiblePiece> pieces_;
};

/// Lines, and the visible edges of polygons, as pixels: plot(column, row, z, colour) is called for
/// each in the region's rows, with the line's own z. Dashes run on from line to line, also outside
/// of the rows and where a line is hidden, as if the pen were lifted (interp/scan/lines.md).
class LinePainter {
 public:
  /// Widths of strokes and scenes are multiplied by line_scale; those of drawn lines already are.
  explicit LinePainter(const ScanConverter::Region& region, double line_scale = 1.0)
      : region_(region), line_scale_(line_scale) {}

  template <class Plot>
  void line(const DrawnLine& line, Plot&& plot) {
    draw_line(line, {}, WholeLine(), plot);
  }
  /// Draws the parts of a stroke for which is_seen is true.
  template <class Stroke, class Plot>
  void stroke(const Stroke& stroke, const SeenOfLine& is_seen, Plot&& plot) {
    const LineStyle style = scaled(stroke.style, line_scale_);
    draw_line({stroke.from, stroke.to, style}, stroke.cuts, is_seen, plot);
  }

  template <class Plot>
  void edges(const DrawnPolygon& polygon, Plot&& plot) {
    if (!may_reach_rows(polygon.vertices, polygon.line.width)) return;
    outline(
        polygon.vertices, [&](std::size_t) -> const LineStyle& { return polygon.line; },
        [&](std::size_t side) { return polygon.sides[side] == op::line; },
        [](std::size_t) { return LineCuts(); }, [](std::size_t) { return WholeLine(); }, plot);
  }

  /// Draws lines, each with its own ends, style and cuts.
  template <class Strokes, class Plot>
  void strokes(const Strokes& lines, Plot&& plot) {
    for (const auto& [from, to, style, cuts] : lines) {
      const LineStyle as_drawn = scaled(style, line_scale_);
      draw_line({from, to, as_drawn}, cuts, WholeLine(), plot);
    }
  }

  /// Visible parts of a scene's lines, in order of entry: pieces as in visible_lines for the
  /// scene's items.
  template <class Plot>
  void seen(const ViewedScene& scene, std::span<const VisiblePiece> pieces, Plot&& plot) {
    using Item = ViewedScene::Item;
    std::size_t next = 0;
    const auto pieces_of = [&](Item item, std::size_t corner) {
      const std::size_t first = next;
      while (next < pieces.size() && pieces[next].item == item && pieces[next].corner == corner) {
        ++next;
      }
      return SeenOfLine(pieces.subspan(first, next - first));
    };
    for_each_outlined(scene, [&](Item item, const LineStyle& line) {
      while (next < pieces.size() && pieces[next].item < item) ++next;
      if (scene.kind(item) == Primitives::Kind::line) {
        const PointRow points = scene.points(item);
        const LineStyle style = scaled(line, line_scale_);
        const LineCuts cuts = with_clipped_ends(scene, item, points[0], points[1], {});
        return draw_line({points[0], points[1], style}, cuts, pieces_of(item, 1), plot);
      }
      if (next == pieces.size() || pieces[next].item != item) return;
      const PointRow points = scene.points(item);
      const std::span<const Point3> vertices(points.data(), points.size());
      LineStyle style = scaled(line, line_scale_);
      const auto style_of = [&](std::size_t side) -> const LineStyle& {
        if (line.of_kinds.empty()) return style;
        return style = scaled(side_line_style(line, scene.side_kinds(item, side)), line_scale_);
      };
      if (line.of_kinds.empty() && !may_reach_rows(vertices, style.width)) return;
      outline(
          vertices, style_of, [&](std::size_t side) { return scene.edge_visible(item, side); },
          [&](std::size_t side) {
            const Point3& from = vertices[side == 0 ? vertices.size() - 1 : side - 1];
            return with_clipped_ends(scene, item, from, vertices[side], {});
          },
          [&](std::size_t side) { return pieces_of(item, side); }, plot);
    });
  }

 private:
  template <class IsSeen, class Plot>
  void draw_line(const DrawnLine& line, const LineCuts& cuts, const IsSeen& is_seen, Plot&& plot) {
    if (pixel(line.from) != dash_end_) dash_phase_ = {};
    scan_convert(line, cuts, dash_phase_, is_seen, plot);
    dash_end_ = pixel(line.to);
  }

  /// Draws the drawn sides, each in style_of(side), where seen_of(side) is true.
  template <class StyleOf, class IsDrawn, class CutsOf, class SeenOf, class Plot>
  void outline(std::span<const Point3> vertices, const StyleOf& style_of, const IsDrawn& is_drawn,
               const CutsOf& cuts_of, const SeenOf& seen_of, Plot&& plot) {
    DashPhase phase;
    Point3 from = vertices.back();
    for (std::size_t side = 0; side < vertices.size(); ++side) {
      if (is_drawn(side)) {
        scan_convert({from, vertices[side], style_of(side)}, cuts_of(side), phase, seen_of(side),
                     plot);
      } else {
        phase = {};
      }
      from = vertices[side];
    }
  }

  template <class IsSeen, class Plot>
  void scan_convert(const DrawnLine& line, const LineCuts& cuts, DashPhase& phase,
                    const IsSeen& is_seen, Plot&& plot) {
    const std::uint32_t colour = pixel_of(line.style.colour);
    const auto plot_it = [&](int x, int y, double z) { plot(x, y, z, colour); };
    const Point3 from = pixel(line.from), to = pixel(line.to);
    if (line.style.width > kWidestWithoutCaps * line_scale_) {
      return draw_wide_line(from, to, line.style, cuts, region_, phase, is_seen, plot_it);
    }
    displayfile::draw_line(from, to, line.style, region_, phase, is_seen, plot_it);
  }

  bool may_reach_rows(std::span<const Point3> vertices, double line_width) const {
    double low = vertices[0].y, high = low;
    for (const Point3& v : vertices) {
      low = std::min(low, v.y);
      high = std::max(high, v.y);
    }
    const double height = region_.size.height;
    const double rounding = 1e-12 * height * (std::abs(low) + std::abs(high));
    const double reach = std::max(1.0, line_width) + 2.0 + rounding;  // also of a slant
    return low * height - reach < region_.row_end && high * height + reach > region_.row_begin;
  }
  Point3 pixel(const Point3& device) const {
    return {device.x * region_.size.width, device.y * region_.size.height, device.z};
  }

  ScanConverter::Region region_;
  double line_scale_;
  DashPhase dash_phase_;
  Point3 dash_end_{-std::numeric_limits<double>::infinity()};
};

}  // namespace displayfile
