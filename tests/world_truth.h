#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/pipeline/clip_pipeline.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"
#include "tests/predicate_truth.h"

// The truth for methods that work before viewing: the definition of truth applied to the world's
// polygons, which are transformed by the view's matrix as rational numbers, without rounding. Where
// it shows another polygon than the truth of the display file, rounding the viewed vertices made
// the difference.

namespace displayfile::test {

class WorldTruth {
 public:
  /// The scene must stay. Its polygons must be solid, and its segments visible and without image
  /// transformations.
  explicit WorldTruth(const RetainedScene& scene) {
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      const PointRow points = scene.points(i);
      polygons_.push_back({{points.begin(), points.end()}, scene[i].pick});
    }
  }

  /// The pick identifier seen, -1 for none. The view clips no front or back plane and fills the
  /// viewport.
  std::int32_t seen_at(const View& view, const PixelCentre& centre) const {
    const ViewVolume volume(view);
    const bool perspective = view.projection == View::Projection::perspective;
    const QPoint at = centre_of(centre);
    std::int32_t seen = -1;
    std::optional<Q> nearest;
    for (const Polygon& polygon : polygons_) {
      if (!may_cover(polygon.points, volume, centre)) continue;
      const auto viewed = device_points(polygon.points, volume, perspective);
      const auto depth = depth_at(viewed, at);
      if (!depth || (nearest && *depth < *nearest)) continue;
      nearest = depth;
      seen = polygon.pick;
    }
    return seen;
  }

 private:
  struct Polygon {
    std::vector<Point3> points;
    std::int32_t pick;
  };
  struct HPoint {
    Q x, y, z, w;
  };

  /// By doubles, and wide; true where the scene's offset leaves doubles too few digits for that.
  static bool may_cover(std::span<const Point3> world, const ViewVolume& volume,
                        const PixelCentre& centre) {
    constexpr double kFar = 1e9;
    for (const Point3& p : world) {
      if (std::abs(p.x) > kFar || std::abs(p.y) > kFar || std::abs(p.z) > kFar) return true;
    }
    ClipPipeline pipeline(volume);
    const auto viewed = pipeline.clip_polygon(world).vertices;
    if (viewed.empty()) return false;
    const double x = (centre.column + 0.5) / centre.size.width;
    const double y = (centre.row + 0.5) / centre.size.height;
    Point2 low(viewed[0]), high(viewed[0]);
    for (const Point3& p : viewed) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    constexpr double kWide = 1e-3;
    return x > low.x - kWide && x < high.x + kWide && y > low.y - kWide && y < high.y + kWide;
  }

  static QPoint rational(const Point3& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }

  /// The vertices, moved on to the plane that the tree takes the polygon to be in; none where there
  /// is no plane.
  static std::vector<QPoint> on_plane(std::span<const Point3> world) {
    const SupportVertices support = spread_vertices(world);
    if (support.edge_on) return {};
    const auto& [p, q, r] = support.index;
    const QPlane plane(rational(world[p]), rational(world[q]), rational(world[r]));
    const int axis = facing_axis(Plane(world[p], world[q], world[r]));
    std::vector<QPoint> moved;
    for (const Point3& v : world) {
      QPoint point = rational(v);
      const Q off = plane.at(point);
      if (axis == 0) point.x -= off / plane.a;
      if (axis == 1) point.y -= off / plane.b;
      if (axis == 2) point.z -= off / plane.c;
      moved.push_back(point);
    }
    return moved;
  }

  static std::vector<QPoint> device_points(std::span<const Point3> world, const ViewVolume& volume,
                                           bool perspective) {
    const glm::dmat4& m = volume.matrix();
    std::vector<HPoint> points;
    for (const QPoint& p : on_plane(world)) {
      const auto row = [&](int i) -> Q {
        return Q(m[0][i]) * p.x + Q(m[1][i]) * p.y + Q(m[2][i]) * p.z + Q(m[3][i]);
      };
      points.push_back({row(0), row(1), row(2), row(3)});
    }
    if (perspective) {
      points = in_front_of_eye(points,
                               Q(-volume.inside_distance(ClipPlane::eye, HomogeneousPoint(0.0))));
    }
    std::vector<QPoint> device;
    for (const HPoint& p : points) device.push_back({p.x / p.w, p.y / p.w, p.z / p.w});
    return device;
  }
  static std::vector<HPoint> in_front_of_eye(const std::vector<HPoint>& points, const Q& least_w) {
    std::vector<HPoint> in;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const HPoint& a = points[i == 0 ? points.size() - 1 : i - 1];
      const HPoint& b = points[i];
      const Q at_a = a.w - least_w, at_b = b.w - least_w;
      if ((at_a < 0) != (at_b < 0)) {
        const Q t = at_a / (at_a - at_b);
        in.push_back(
            {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), least_w});
      }
      if (at_b >= 0) in.push_back(b);
    }
    return in;
  }

  /// Nothing if the polygon does not cover the point.
  static std::optional<Q> depth_at(const std::vector<QPoint>& polygon, const QPoint& at) {
    bool covered = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const QPoint& a = polygon[i == 0 ? polygon.size() - 1 : i - 1];
      const QPoint& b = polygon[i];
      if ((a.y < at.y) == (b.y < at.y)) continue;
      if (a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) <= at.x) covered = !covered;
    }
    if (!covered) return std::nullopt;
    for (std::size_t q = 1; q < polygon.size(); ++q) {
      for (std::size_t r = q + 1; r < polygon.size(); ++r) {
        const QPlane plane(polygon[0], polygon[q], polygon[r]);
        if (plane.c != 0) return plane.z(at.x, at.y);
      }
    }
    return std::nullopt;
  }

  std::vector<Polygon> polygons_;
};

}  // namespace displayfile::test
