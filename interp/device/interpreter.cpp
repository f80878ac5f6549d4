#include "interp/device/interpreter.h"

#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/geometry/corners.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/entered/styled_sides.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/looks/vertex_shading.h"
#include "hidden/lines/strokes_once.h"

namespace displayfile {

LineStyle scaled(LineStyle style, double by) {
  style.width *= by;
  style.dash *= by;
  style.gap *= by;
  return style;
}

static_assert(DrawnPolygon::kDrawnSide == op::line);

FillStyle even_fill(const DrawnPolygon& polygon) {
  if (polygon.intensities.empty()) return polygon.fill;
  return lit(polygon.fill, mean_intensity(polygon.intensities));
}

namespace {

/// Passes the drawn sides to the device, those of each style together. `line` is not scaled.
void draw_sides(const DrawnPolygon& polygon, const LineStyle& line, double line_scale,
                StyledSides& styled, OutputDevice& device) {
  styled.for_each(line, polygon.kinds, polygon.sides,
                  [&](const LineStyle& style, std::span<const std::int32_t> sides) {
                    const LineStyle as_drawn = scaled(style, line_scale);
                    device.edges({polygon.vertices, sides, polygon.fill, as_drawn, polygon.pick,
                                  polygon.intensities, polygon.kinds, polygon.normals,
                                  polygon.light, polygon.cuts});
                  });
}

/// Instructions in order, with the styles and the pen position in force.
struct Interpretation {
  OutputDevice& device;
  Pass pass;
  double line_scale;
  FillStyle fill_style;
  LineStyle style;
  std::int32_t pick_id = -1;
  Point3 pen{0.0};
  VertexShading of_vertices{};                         // of the polygon that follows
  std::span<const LineKinds> of_sides{};               // likewise
  std::span<const std::uint8_t> of_corners{};          // likewise
  LineKinds of_lines = kDrawn;                         // that follow
  LineCuts cuts_of_lines{};                            // likewise
  bool in_segment = false, in_segment_before = false;  // before disjoint polygons
  std::vector<double> of_normals{};                    // intensities, of one polygon
  LineStyle style_as_set{};                            // `style`, not scaled
  StyledSides styled_sides{};
  WorkSteps steps{};

  void segment(int name) {
    end_segment();
    device.begin_segment(name);
    in_segment = true;
  }
  void end_segment() {
    if (in_segment) device.end_segment();
    in_segment = false;
  }
  void fill(const FillStyle& s) { fill_style = s; }
  void line_style(const LineStyle& s) {
    style = scaled(s, line_scale);
    style_as_set = s;
  }
  void pick(int id) { pick_id = id; }
  void intensities(std::span<const double> values) { of_vertices = {.intensities = values}; }
  void normals(std::span<const Point3> values, const Light& light) {
    of_vertices = {.normals = values, .light = &light};
  }
  void side_kinds(std::span<const LineKinds> kinds) { of_sides = kinds; }
  void corner_cuts(std::span<const std::uint8_t> cuts) { of_corners = cuts; }
  void line_kinds(LineKinds kinds) { of_lines = kinds; }
  void line_cuts(LineCuts cuts) { cuts_of_lines = cuts; }
  void disjoint_polygons(bool begin) {
    if (begin) {
      in_segment_before = in_segment;
      return device.begin_disjoint_fills();
    }
    if (!in_segment_before) end_segment();
    device.end_disjoint_fills();
  }
  bool is_crumb(const Point3& from, const Point3& to) const {
    return is_shorter_than_wide(Point2(from), Point2(to), device.pixels(), style.width);
  }
  void move(const Point3& p) { pen = p; }
  void line(const Point3& p) {
    steps.step();
    if (pass != Pass::fills && style.kind != LineStyle::Kind::none) {
      device.line({pen, p, style, of_lines, cuts_of_lines});
    }
    pen = p;
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    steps.step();
    const DrawnPolygon polygon{vertices,          sides,
                               fill_style,        style,
                               pick_id,           vertex_intensities(of_vertices, of_normals),
                               of_sides,          of_vertices.normals,
                               of_vertices.light, of_corners};
    if (pass != Pass::lines && fill_style.kind == FillStyle::Kind::solid) device.fill(polygon);
    if (pass != Pass::fills && style.kind != LineStyle::Kind::none) edges(polygon);
    of_vertices = {};
    of_sides = {};
    of_corners = {};
    pen = vertices.back();
  }
  void edges(const DrawnPolygon& polygon) {
    if (style.of_kinds.empty()) return device.edges(polygon);
    draw_sides(polygon, style_as_set, line_scale, styled_sides, device);
  }
};

}  // namespace

void interpret(const DisplayFile& display_file, OutputDevice& device, Pass pass, Order order,
               double line_scale) {
  if (order == Order::drawn && display_file.sorted() != nullptr) {
    Interpretation all{device, pass, line_scale, {}, {}};
    display_file.sorted()->walk(all);
    return all.end_segment();
  }
  for (const Segment& segment : display_file.segments()) {
    if (!segment.visible) continue;
    Interpretation one{device, pass, line_scale, {}, {}};
    one.segment(segment.name());
    order == Order::drawn ? segment.walk_drawn(one) : segment.walk_entered_drawn(one);
    one.end_segment();
  }
}

void interpret_lines(const ViewedScene& scene, OutputDevice& device, double line_scale) {
  const FillStyle fill;
  std::vector<std::int32_t> sides;
  std::vector<LineKinds> kinds;
  StyledSides styled;
  for_each_outlined(scene, [&](ViewedScene::Item item, const LineStyle& style) {
    const PointRow points = scene.points(item);
    if (scene.kind(item) == Primitives::Kind::line) {
      const LineStyle as_drawn = scaled(style, line_scale);
      return device.line({points[0], points[1], as_drawn});
    }
    sides.clear();
    kinds.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      kinds.push_back(scene.side_kinds(item, i));
      sides.push_back(kinds.back() != 0 ? op::line : op::move);
    }
    const std::span<const Point3> vertices(points.data(), points.size());
    if (style.of_kinds.empty()) {
      const LineStyle as_drawn = scaled(style, line_scale);
      return device.edges({vertices, sides, fill, as_drawn, scene.pick_of_item(item)});
    }
    draw_sides({vertices, sides, fill, style, scene.pick_of_item(item), {}, kinds}, style,
               line_scale, styled, device);
  });
}

}  // namespace displayfile
