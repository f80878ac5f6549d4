#include "interp/vector/sampled/collected_drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "interp/interpreter.h"

namespace displayfile {

namespace {

/// The index of the style, which is stored if it is not the one stored last.
template <class Style>
std::uint32_t index_of(const Style& style, std::vector<Style>& styles) {
  if (styles.empty() || styles.back() != style) styles.push_back(style);
  return static_cast<std::uint32_t>(styles.size() - 1);
}

class Collector : public OutputDevice {
 public:
  explicit Collector(CollectedDrawing& drawing) : drawing_(drawing) {}

  void begin_segment(int name) override {
    drawing_.segments.push_back(name);
    line_end_.reset();
  }

  void fill(const DrawnPolygon& polygon) override { add(polygon, true); }

  void edges(const DrawnPolygon& polygon) override {
    // The interpreter fills a polygon just before it draws its edges.
    if (drawing_.polygons.empty() || !is_last(polygon)) add(polygon, false);
    add_sides();
  }

  void line(const DrawnLine& line) override {
    if (line_end_ != line.from) line_length_ = 0.0;
    drawing_.lines.push_back({line.from, line.to, CollectedDrawing::kNone, segment(),
                              index_of(line.style, drawing_.line_styles), line_length_});
    line_length_ += length(line.from, line.to);
    line_end_ = line.to;
  }

 private:
  std::uint32_t segment() const { return static_cast<std::uint32_t>(drawing_.segments.size() - 1); }
  double length(const Point3& a, const Point3& b) const {
    return std::hypot((b.x - a.x) * drawing_.width, (b.y - a.y) * drawing_.height);
  }

  bool is_last(const DrawnPolygon& polygon) const {
    const auto& last = drawing_.polygons.back();
    return last.segment == segment() && last.pick == polygon.pick &&
           std::ranges::equal(drawing_.vertices_of(last), polygon.vertices) &&
           std::ranges::equal(drawing_.drawn(last).sides, polygon.sides);
  }

  void add(const DrawnPolygon& polygon, bool filled) {
    CollectedDrawing::Polygon p{};
    p.first = drawing_.vertices.size();
    p.size = static_cast<std::uint32_t>(polygon.vertices.size());
    p.segment = segment();
    p.fill_style = index_of(even_fill(polygon), drawing_.fill_styles);
    p.line_style = index_of(polygon.line, drawing_.line_styles);
    p.pick = polygon.pick;
    drawing_.vertices.insert(drawing_.vertices.end(), polygon.vertices.begin(),
                             polygon.vertices.end());
    drawing_.sides.insert(drawing_.sides.end(), polygon.sides.begin(), polygon.sides.end());
    find_extent(p, polygon.vertices);
    const SupportVertices support = support_vertices(polygon.vertices);
    if (!support.edge_on) {
      p.depth = PixelDepth(polygon.vertices, support, drawing_.width, drawing_.height);
    }
    p.filled = filled && !support.edge_on && p.first_row <= p.last_row &&
               std::isfinite(p.depth.z0) && std::isfinite(p.depth.dz_dx) &&
               std::isfinite(p.depth.dz_dy);
    edge_on_ = support.edge_on;
    drawing_.polygons.push_back(p);
  }

  void find_extent(CollectedDrawing::Polygon& p, std::span<const Point3> vertices) const {
    double low = vertices[0].y, high = low, left = vertices[0].x, right = left;
    p.nearest = p.farthest = vertices[0].z;
    bool finite = true;
    for (const Point3& v : vertices) {
      finite = finite && std::isfinite(v.x) && std::isfinite(v.y);
      left = std::min(left, v.x);
      right = std::max(right, v.x);
      low = std::min(low, v.y);
      high = std::max(high, v.y);
      p.nearest = std::max(p.nearest, v.z);
      p.farthest = std::min(p.farthest, v.z);
    }
    const double last = drawing_.height - 1.0;
    if (!finite || right < 0.0 || left > 1.0 || high < 0.0 || low > 1.0) {
      p.first_row = 1;
      p.last_row = 0;
      return;
    }
    p.first_row = static_cast<int>(std::clamp(std::floor(low * drawing_.height), 0.0, last));
    p.last_row = static_cast<int>(std::clamp(std::floor(high * drawing_.height), 0.0, last));
  }

  /// The drawn sides of the polygon added last.
  void add_sides() {
    const auto index = static_cast<std::uint32_t>(drawing_.polygons.size() - 1);
    const CollectedDrawing::Polygon& p = drawing_.polygons.back();
    const auto vertices = drawing_.vertices_of(p);
    const auto on_plane = [&](Point3 v) {
      if (edge_on_) return v;
      const double z = p.depth.at_point(v.x * drawing_.width, v.y * drawing_.height);
      // Seen nearly edge-on, the plane's doubles are worth less than the vertex's.
      if (z >= p.farthest && z <= p.nearest) v.z = z;
      return v;
    };
    double drawn = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Point3& from = vertices[i > 0 ? i - 1 : vertices.size() - 1];
      if (drawing_.sides[p.first + i] == op::line) {
        drawing_.lines.push_back(
            {on_plane(from), on_plane(vertices[i]), index, p.segment, p.line_style, drawn});
        drawn += length(from, vertices[i]);
      } else {
        drawn = 0.0;
      }
    }
  }

  CollectedDrawing& drawing_;
  bool edge_on_ = false;  // the polygon added last
  std::optional<Point3> line_end_;
  double line_length_ = 0.0;
};

}  // namespace

bool CollectedDrawing::covers(const Polygon& p, double x, double y) const {
  bool inside = false;
  const auto polygon = vertices_of(p);
  Point3 from = to_pixels(polygon.back());
  for (const Point3& vertex : polygon) {
    const Point3 to = to_pixels(vertex);
    const Point3& low = from.y < to.y ? from : to;
    const Point3& high = from.y < to.y ? to : from;
    if (low.y < y && y <= high.y) {
      const double crossing = low.x + (y - low.y) * ((high.x - low.x) / (high.y - low.y));
      if (crossing <= x) inside = !inside;
    }
    from = to;
  }
  return inside;
}

CollectedDrawing collect(const DisplayFile& display_file, int width, int height) {
  CollectedDrawing drawing{width, height, {}, {}, {}, {}, {}, {}, {}};
  Collector collector(drawing);
  interpret(display_file, collector, Pass::everything, Order::entered);
  return drawing;
}

}  // namespace displayfile
