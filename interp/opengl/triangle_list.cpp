#include "interp/opengl/triangle_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "clip/base/error.h"
#include "clip/geometry/clip_to_rectangle.h"
#include "hidden/exact/support_plane.h"
#include "hidden/triangles/convex_turning.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/scan/line_draw.h"

namespace displayfile {

namespace {

void require_in_range(std::span<const Point3> points) {
  for (const Point3& p : points) {
    if (!in_range(p)) {
      throw Error(
          fmt::format("display-file coordinate ({}, {}, {}): expected finite numbers of at "
                      "most {} in size",
                      p.x, p.y, p.z, kCoordinateLimit));
    }
  }
}

bool in_picture(std::span<const Point3> points) {
  return std::ranges::all_of(
      points, [](const Point3& p) { return p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0; });
}

/// True if the polygon goes once around, turning one way only: then a fan tiles it. Turns are
/// rounded: of corners that clipping left in line, none makes the polygon concave.
bool is_convex(std::span<const Point3> vertices, std::vector<Point2>& distinct) {
  if (vertices.size() == 3) return true;
  distinct.clear();
  Point2 from(vertices.back());
  for (const Point3& vertex : vertices) {
    const Point2 to(vertex);
    if (to != from) distinct.push_back(to);
    from = to;
  }
  const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Point2 a = distinct[j] - distinct[i], b = distinct[k] - distinct[j];
    const double cross = a.x * b.y - a.y * b.x;
    return (cross > 0.0) - (cross < 0.0);
  };
  return convex_turning(distinct.size(), turn, [&](std::size_t i, std::size_t j) {
           return direction_by_x(distinct[i], distinct[j]);
         }) != 0;
}

/// A line of some width, in pixels. Its major axis is the one along which it is longer; u (x of
/// a and b) is the coordinate along that axis and v (their y) the other one.
struct WideLine {
  Point2 a, b;
  bool steep;
  double width, height, limit;  ///< of the picture; limit along the major axis
  double length, run, upright;  ///< upright: the parallelogram's size along v
  double from_z, to_z, z_slack;
  const DepthPlane* plane;

  /// Depth follows the plane, or the line where that is null, but differs from the line's own depth
  /// by no more than z_slack: beyond a polygon seen nearly edge-on the depth of its plane is
  /// arbitrary.
  WideLine(const Point3& from, const Point3& to, double line_width, const DepthPlane* its_plane,
           double slack, double picture_width, double picture_height)
      : a(from.x * picture_width, from.y * picture_height),
        b(to.x * picture_width, to.y * picture_height),
        steep(std::abs(b.y - a.y) > std::abs(b.x - a.x)),
        width(picture_width),
        height(picture_height),
        limit(steep ? height : width),
        from_z(from.z),
        to_z(to.z),
        z_slack(slack),
        plane(its_plane) {
    if (steep) {
      std::swap(a.x, a.y);
      std::swap(b.x, b.y);
    }
    if (line_width <= 1.0) {
      a.y = within_a_pixel(a.y);
      b.y = within_a_pixel(b.y);
    }
    run = b.x - a.x;
    length = glm::length(Point2(run, b.y - a.y));
    upright = line_width <= 1.0 ? 1.0 : line_width * (run == 0.0 ? 1.0 : length / std::abs(run));
  }

  /// A line one pixel wide along a border between pixels covers those above, by the rule for
  /// polygons, or those on the right, where that rule would choose the left; on the picture's own
  /// border it covers the last pixels.
  double within_a_pixel(double v) const {
    if (v == (steep ? width : height)) return v - 0.5;
    return steep ? v + 1.0 / 256 : v;
  }

  double low() const { return std::min(a.x, b.x); }
  double high() const { return std::max(a.x, b.x); }

  /// In normalised device coordinates; side is -1 or 1.
  Point3 corner(double u, double side) const {
    const double t = run == 0.0 ? 0.0 : (u - a.x) / run;
    const double v = a.y + t * (b.y - a.y) + side * upright / 2;
    const Point2 p = steep ? Point2(v / width, u / height) : Point2(u / width, v / height);
    const double beyond = std::abs(run) < 1.0 ? 0.0 : 1.0;  // a line along the view is a dot
    const double z = from_z + std::clamp(t, -beyond, 1.0 + beyond) * (to_z - from_z);
    const double wanted = plane != nullptr ? plane->at(p.x, p.y) : z;
    return {p, z + std::clamp(wanted - z, -z_slack, z_slack)};
  }
};

class TriangleCollector final : public OutputDevice {
 public:
  TriangleCollector(TriangleList& list, int width, int height)
      : list_(list), width_(width), height_(height) {}

  Point2 pixels() const override { return {width_, height_}; }
  void fill(const DrawnPolygon& polygon) override {
    require_in_range(polygon.vertices);
    const SupportVertices support = support_vertices(polygon.vertices);
    if (support.edge_on) return;
    points_.assign(polygon.vertices.begin(), polygon.vertices.end());
    if (points_.size() > 3) {
      const DepthPlane plane = plane_of(polygon, support);
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (std::ranges::find(support.index, i) == support.index.end()) {
          points_[i].z = plane.at(points_[i].x, points_[i].y);
        }
      }
    }
    if (polygon.intensities.empty()) {
      enter(polygon.pick,
            [colour = pixel_of(polygon.fill.colour)](const Point3&) { return colour; });
      return;
    }
    list_.shaded = true;
    enter(polygon.pick,
          [&, plane = IntensityPlane(polygon.vertices, polygon.intensities)](const Point3& p) {
            return pixel_of(polygon.fill.colour * plane.at(p));
          });
  }

  void edges(const DrawnPolygon& polygon) override {
    require_in_range(polygon.vertices);
    const SupportVertices support = support_vertices(polygon.vertices);
    std::optional<DepthPlane> plane;
    if (!support.edge_on) plane = plane_of(polygon, support);
    const auto [nearest, farthest] = std::ranges::minmax(polygon.vertices, {}, &Point3::z);
    DashPhase phase;
    Point3 from = polygon.vertices.back();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const Point3& to = polygon.vertices[i];
      if (polygon.sides[i] == op::line) {
        stroke(from, to, polygon.line, plane ? &*plane : nullptr, farthest.z - nearest.z, phase);
      } else {
        phase = {};
      }
      from = to;
    }
  }

  void line(const DrawnLine& line) override {
    require_in_range(std::array{line.from, line.to});
    if (dash_end_ != line.from) dash_phase_ = {};
    stroke(line.from, line.to, line.style, nullptr, 0.0, dash_phase_);
    dash_end_ = line.to;
  }

 private:
  static DepthPlane plane_of(const DrawnPolygon& polygon, const SupportVertices& support) {
    return depth_plane(polygon.vertices[support.index[0]], polygon.vertices[support.index[1]],
                       polygon.vertices[support.index[2]]);
  }

  /// Enters a line as parallelograms, one for each dash. Parts outside of the picture get no
  /// dashes, so a long line costs no more than one across it.
  void stroke(const Point3& from, const Point3& to, const LineStyle& style, const DepthPlane* plane,
              double z_slack, DashPhase& phase) {
    const WideLine line(from, to, style.width, plane, z_slack, width_, height_);
    const double before = phase.length;
    phase.length += line.length;
    const double first = std::max(std::floor(std::min(line.low(), line.limit - 0.5)), -1.0);
    const double last = std::clamp(std::floor(line.high()) + 1.0, first, line.limit + 1.0);
    if (!(first < last)) return;
    const std::uint32_t colour = pixel_of(style.colour);
    const auto piece = [&](double u0, double u1) {
      points_.assign(
          {line.corner(u0, -1), line.corner(u1, -1), line.corner(u1, 1), line.corner(u0, 1)});
      enter(-1, [&](const Point3&) { return colour; });
    };
    const double period = style.dash + style.gap;
    constexpr double kShortestPeriod = 0.125;  // pixels; a finer pattern cannot be seen
    if (style.kind != LineStyle::Kind::dashed || period < kShortestPeriod) {
      return piece(first, last);
    }
    const double per_column = line.run == 0.0 ? 1.0 : line.length / std::abs(line.run);
    const double direction = line.run < 0.0 ? -1.0 : 1.0;
    const double start = std::fmod(before, period);
    const double begin =
        start + direction * ((direction > 0.0 ? first : last) - line.a.x) * per_column;
    const double end = begin + (last - first) * per_column;
    const auto column = [&](double along) {
      return std::clamp(line.a.x + direction * (along - start) / per_column, first, last);
    };
    for (double k = std::floor(begin / period); k * period < end; ++k) {
      const auto [u0, u1] = std::minmax({column(k * period), column(k * period + style.dash)});
      if (u0 < u1) piece(u0, u1);
    }
  }

  /// Enters the polygon in points_, clipped to the picture; colour_at(vertex) is as in
  /// Picture::pixels.
  template <class ColourAt>
  void enter(std::int32_t id, ColourAt&& colour_at) {
    if (!in_picture(points_)) clip_to_rectangle(points_, clipped_, {0.0, 1.0, 0.0, 1.0});
    if (points_.size() < 3) return;
    add_batch(
        is_convex(points_, distinct_) ? TriangleBatch::Rule::each : TriangleBatch::Rule::even_odd,
        3 * (points_.size() - 2));
    for (const Point3& p : points_) {
      list_.z_min = std::min(list_.z_min, p.z);
      list_.z_max = std::max(list_.z_max, p.z);
    }
    const auto add = [&](const Point3& p) {
      list_.vertices.push_back({static_cast<float>(2.0 * p.x - 1.0),
                                static_cast<float>(1.0 - 2.0 * p.y), p.z, colour_at(p), id});
    };
    for (std::size_t i = 2; i < points_.size(); ++i) {
      add(points_[0]);
      add(points_[i - 1]);
      add(points_[i]);
    }
  }

  void add_batch(TriangleBatch::Rule rule, std::size_t count) {
    auto& batches = list_.batches;
    const bool joins = rule == TriangleBatch::Rule::each && !batches.empty() &&
                       batches.back().rule == TriangleBatch::Rule::each;
    if (!joins) batches.push_back({rule, list_.vertices.size(), 0});
    batches.back().count += count;
  }

  TriangleList& list_;
  double width_, height_;
  std::vector<Point3> points_, clipped_;
  std::vector<Point2> distinct_;
  DashPhase dash_phase_;
  std::optional<Point3> dash_end_;
};

}  // namespace

TriangleList triangle_list(const DisplayFile& display_file, Pass pass, Order order, int width,
                           int height, double line_scale) {
  TriangleList list;
  if (pass != Pass::lines) list.vertices.reserve(3 * display_file.polygons());
  TriangleCollector collector(list, width, height);
  interpret(display_file, collector, pass, order, line_scale);
  return list;
}

}  // namespace displayfile
