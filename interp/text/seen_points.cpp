#include "interp/text/seen_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "clip/geometry/rectangle.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// A direction in which a side of a polygon leaves the point: the polygon's coverage changes there.
struct SideRay {
  Point2 through;
  std::uint32_t polygon;  ///< its number among those around the point
};

/// Coverage by polygons in a small neighbourhood of a point, if it is on their sides.
struct Surroundings {
  bool hidden = false;                ///< the point is inside of a nearer polygon
  std::vector<std::uint8_t> covered;  ///< of each polygon, in the direction of +x, just above it
  std::vector<SideRay> rays;
};

/// The direction's position in a turn about the point, counterclockwise from just above +x: the
/// half above, -x, the half below, +x.
int part_of_turn(const Point2& point, const Point2& through) {
  if (through.y > point.y) return 0;
  if (through.y < point.y) return 2;
  return through.x < point.x ? 1 : 3;
}

/// -1 if the first direction comes earlier in the turn, 0 if the two are the same, 1 otherwise.
int compare_directions(const Point2& point, const Point2& a, const Point2& b) {
  const int part_a = part_of_turn(point, a), part_b = part_of_turn(point, b);
  if (part_a != part_b) return part_a < part_b ? -1 : 1;
  return part_a % 2 == 1 ? 0 : -orientation(point, a, b);
}

/// Adds a polygon's coverage around a point. Just above +x it is found by the even-odd rule: counts
/// the sides that cross the row just above the point, right of it.
void add_polygon(std::span<const Point3> polygon, const Point2& point, Surroundings& around) {
  const auto number = static_cast<std::uint32_t>(around.covered.size());
  const std::size_t rays_before = around.rays.size();
  bool covered = false;
  Point2 from(polygon.back());
  for (const Point3& vertex : polygon) {
    const Point2 to(vertex);
    const auto [low, high] = from.y <= to.y ? std::pair(from, to) : std::pair(to, from);
    from = to;
    if (point.y < low.y || point.y > high.y) continue;
    const bool level = low.y == high.y;
    const int side = level ? 0 : orientation(low, high, point);  // 1: the point is left of it
    if (side == 1 && point.y < high.y) covered = !covered;
    if (side != 0) continue;
    const auto [left, right] = low.x <= high.x ? std::pair(low, high) : std::pair(high, low);
    if (level && (point.x < left.x || point.x > right.x)) continue;
    for (const Point2& end : {low, high}) {
      if (end != point) around.rays.push_back({end, number});
    }
  }
  if (around.rays.size() == rays_before) {
    around.hidden |= covered;
  } else {
    around.covered.push_back(covered ? 1 : 0);
  }
}

/// Makes one turn about the point. True if no polygon covers in some direction.
bool has_gap(const Point2& point, Surroundings& around) {
  if (around.hidden) return false;
  auto covering = std::ranges::count(around.covered, 1);
  std::ranges::sort(around.rays, [&](const SideRay& a, const SideRay& b) {
    return compare_directions(point, a.through, b.through) < 0;
  });
  for (std::size_t i = 0; i < around.rays.size() && covering > 0;) {
    const Point2 direction = around.rays[i].through;
    for (; i < around.rays.size() &&
           compare_directions(point, direction, around.rays[i].through) == 0;
         ++i) {
      std::uint8_t& covered = around.covered[around.rays[i].polygon];
      covered ^= 1;
      covering += covered != 0 ? 1 : -1;
    }
  }
  return covering == 0;
}

bool is_nearer(const Plane& plane, const Point3& point) {
  const double allowed = kOnSurface * std::max(1.0, std::abs(point.z));
  return side_of_plane({point.x, point.y, point.z + allowed}, plane) * facing(plane) < 0;
}

/// The rectangle around some fills, in the projection.
Rectangle rectangle_around(const ViewedScene& scene, Fill first, Fill end) {
  Rectangle all = Rectangle::nothing();
  for (Fill fill = first; fill < end; ++fill) {
    for (const Point3& p : scene.vertices(fill)) all.include(Point2(p));
  }
  return all;
}

}  // namespace

std::vector<std::uint8_t> points_seen(const ViewedScene& scene, std::span<const Point3> points) {
  std::vector<std::uint32_t> by_y(points.size());
  std::iota(by_y.begin(), by_y.end(), 0u);
  const auto y_of = [&](std::uint32_t i) { return points[i].y; };
  std::ranges::stable_sort(by_y, {}, y_of);
  std::vector<Surroundings> around(points.size());
  const auto for_each_within = [&](const Rectangle& box, const auto& visit) {
    auto i = std::ranges::lower_bound(by_y, box.y_min, {}, y_of);
    for (; i != by_y.end() && y_of(*i) <= box.y_max; ++i) {
      if (points[*i].x >= box.x_min && points[*i].x <= box.x_max) visit(*i);
    }
  };
  const auto look_at = [&](Fill fill) {
    const auto polygon = scene.vertices(fill);
    for_each_within(bounding_rectangle(polygon), [&](std::uint32_t i) {
      const Point3& point = points[i];
      if (around[i].hidden || std::ranges::find(polygon, point) != polygon.end()) return;
      if (is_nearer(scene.plane(fill), point)) add_polygon(polygon, Point2(point), around[i]);
    });
  };
  // Fills that follow each other are often beside each other, and away from all points together.
  constexpr Fill kTogether = 32;
  for (Fill first = 1; first < scene.end(); first += kTogether) {
    const Fill end = std::min(scene.end(), first + kTogether);
    bool is_near = false;
    for_each_within(rectangle_around(scene, first, end), [&](std::uint32_t) { is_near = true; });
    for (Fill fill = first; is_near && fill < end; ++fill) look_at(fill);
  }
  std::vector<std::uint8_t> seen(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    seen[i] = has_gap(Point2(points[i]), around[i]) ? 1 : 0;
  }
  return seen;
}

}  // namespace displayfile
