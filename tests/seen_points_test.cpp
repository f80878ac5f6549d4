// Which points are seen among polygons: by the definition in interp/truth/truth.md, looked at in
// the most naive way.

#include "interp/text/seen_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "tests/slower.h"

namespace displayfile {
namespace {

using Polygon = std::vector<Point3>;

ViewedScene scene_of(const std::vector<Polygon>& polygons) {
  auto instructions = std::make_shared<Instructions>();
  instructions->set_style(FillStyle{});
  for (const Polygon& polygon : polygons) {
    instructions->enter_polygon(polygon, std::vector<std::uint8_t>(polygon.size(), 1));
  }
  return {instructions, ImageTransformation{}};
}

bool seen(const std::vector<Polygon>& polygons, const Point3& point) {
  return points_seen(scene_of(polygons), std::vector{point})[0] != 0;
}

Polygon rectangle(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

TEST(SeenPoints, BehindTheInsideOfAPolygonIsHidden) {
  const Polygon sheet = rectangle(0.25, 0.75, 0.25, 0.75, 0.5);
  EXPECT_FALSE(seen({sheet}, {0.5, 0.5, 0.25}));
  EXPECT_TRUE(seen({sheet}, {0.5, 0.5, 0.75}));
  EXPECT_TRUE(seen({sheet}, {0.125, 0.5, 0.25}));
  EXPECT_TRUE(seen({}, {0.5, 0.5, 0.25}));
}

/// On the polygon's plane, inside and on its outline, and where rounding put the point behind it.
TEST(SeenPoints, OnASurfaceIsSeen) {
  const Polygon sheet = rectangle(0.25, 0.75, 0.25, 0.75, 0.5);
  for (const double x : {0.25, 0.3, 0.5, 0.75}) {
    for (const double y : {0.25, 0.6, 0.75}) {
      EXPECT_TRUE(seen({sheet}, {x, y, 0.5}));
      EXPECT_TRUE(seen({sheet}, {x, y, std::nextafter(0.5, 0.0)}));
      EXPECT_TRUE(seen({sheet}, {x, y, 0.5 - 0.9 * kOnSurface}));
    }
  }
  EXPECT_TRUE(seen({sheet}, {0.5, 0.5, 0.5 - kOnSurface}));
  EXPECT_FALSE(seen({sheet}, {0.5, 0.5, std::nextafter(0.5 - kOnSurface, 0.0)}));
  // Far off the view volume's planes depths are rounded more.
  const Polygon far = rectangle(0.25, 0.75, 0.25, 0.75, -1024.0);
  EXPECT_TRUE(seen({far}, {0.5, 0.5, -1024.0 - 512 * kOnSurface}));
  EXPECT_FALSE(seen({far}, {0.5, 0.5, -1024.0 - 2048 * kOnSurface}));
}

/// A polygon that is not quite flat leaves one of its vertices behind its plane.
TEST(SeenPoints, APolygonDoesNotHideItsOwnVertices) {
  const Polygon bent{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.25}};
  EXPECT_TRUE(seen({bent}, {0, 1, 0.25}));
  EXPECT_TRUE(seen({bent, bent}, {0, 1, 0.25}));
  const Polygon reaching_over = rectangle(-1, 1, 0.5, 2, 0.75);
  EXPECT_FALSE(seen({bent, reaching_over}, {0, 1, 0.25}));
}

TEST(SeenPoints, BehindAnOutlineIsSeenAndBehindASharedEdgeHidden) {
  const Polygon left = rectangle(0, 0.5, 0, 1, 0.5), right = rectangle(0.5, 1, 0, 1, 0.75);
  const Point3 behind(0.5, 0.5, 0.25);
  EXPECT_TRUE(seen({left}, behind));
  EXPECT_TRUE(seen({right}, behind));
  EXPECT_FALSE(seen({left, right}, behind));
  EXPECT_TRUE(seen({left, right}, {0.5, 0.5, 0.6}));   // in front of one of them
  EXPECT_TRUE(seen({left, right}, {0.5, 1.0, 0.25}));  // behind their corners
  const Polygon above = rectangle(0, 1, 1, 2, 0.5);
  EXPECT_FALSE(seen({left, right, above}, {0.5, 1.0, 0.25}));
}

/// Three faces of a cube meet in front of the corner that is farthest away.
TEST(SeenPoints, BehindACornerOfACubeIsHidden) {
  const Point3 corner(0.5, 0.5, 0.75);
  const std::vector<Point3> around{{0.5, 0.25, 0.6}, {0.75, 0.375, 0.5}, {0.75, 0.625, 0.6},
                                   {0.5, 0.75, 0.5}, {0.25, 0.625, 0.6}, {0.25, 0.375, 0.5}};
  std::vector<Polygon> faces;
  for (std::size_t k = 0; k < 6; k += 2) {
    faces.push_back({corner, around[k], around[k + 1], around[(k + 2) % 6]});
  }
  const Point3 behind(0.5, 0.5, 0.25);
  EXPECT_FALSE(seen(faces, behind));
  EXPECT_TRUE(seen(faces, corner));
  faces.pop_back();
  EXPECT_TRUE(seen(faces, behind));
}

/// Even-odd: where a polygon covers twice it does not cover.
TEST(SeenPoints, SelfCrossingPolygons) {
  const Polygon bow{{0, 0, 0.5}, {1, 1, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}};
  EXPECT_FALSE(seen({bow}, {0.25, 0.5, 0.25}));
  EXPECT_TRUE(seen({bow}, {0.5, 0.25, 0.25}));
  EXPECT_TRUE(seen({bow}, {0.5, 0.5, 0.25}));
  const Polygon twice{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5},
                      {0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  EXPECT_TRUE(seen({twice}, {0.5, 0.5, 0.25}));
}

TEST(SeenPoints, HollowPolygonsHideNothing) {
  auto instructions = std::make_shared<Instructions>();
  instructions->set_style(FillStyle{FillStyle::Kind::hollow});
  instructions->set_style(LineStyle{});
  instructions->enter_polygon(rectangle(0, 1, 0, 1, 0.5), std::vector<std::uint8_t>(4, 1));
  const ViewedScene scene(instructions, ImageTransformation{});
  EXPECT_EQ(points_seen(scene, std::vector{Point3(0.5, 0.5, 0)})[0], 1);
}

// ---- The definition, by looking around ------------------------------------------------------

/// Coordinates are whole numbers of sixteenths.
struct Whole {
  std::int64_t x, y, z;
  explicit Whole(const Point3& p)
      : x(std::llround(p.x * 16)), y(std::llround(p.y * 16)), z(std::llround(p.z * 16)) {}
};

bool strictly_nearer(const Plane& plane, const Point3& point) {
  const Whole p(plane.p), q(plane.q), r(plane.r), v(point);
  const std::int64_t ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const std::int64_t vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const std::int64_t a = uy * vz - uz * vy, b = uz * vx - ux * vz, c = ux * vy - uy * vx;
  const std::int64_t height = a * (v.x - p.x) + b * (v.y - p.y) + c * (v.z - p.z);
  return c > 0 ? height < 0 : height > 0;
}

bool covers(std::span<const Point3> polygon, double x, double y) {
  bool inside = false;
  Point3 from = polygon.back();
  for (const Point3& to : polygon) {
    if ((from.y > y) != (to.y > y) &&
        x < from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x)) {
      inside = !inside;
    }
    from = to;
  }
  return inside;
}

/// Looks a little beside the point, between all directions in which anything can change.
bool seen_by_looking_around(const ViewedScene& scene, const Point3& point) {
  std::vector<double> angles{0.0, 3.0};
  std::vector<ViewedScene::Fill> nearer;
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
    const auto polygon = scene.vertices(fill);
    if (std::ranges::find(polygon, point) != polygon.end()) continue;
    if (!strictly_nearer(scene.plane(fill), point)) continue;
    nearer.push_back(fill);
    for (const Point3& v : polygon) angles.push_back(std::atan2(v.y - point.y, v.x - point.x));
  }
  std::ranges::sort(angles);
  angles.push_back(angles.front() + 2 * M_PI);
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    if (angles[i + 1] - angles[i] < 1e-9) continue;
    const double angle = (angles[i] + angles[i + 1]) / 2, little = 0x1p-20;
    const double x = point.x + little * std::cos(angle), y = point.y + little * std::sin(angle);
    const bool covered = std::ranges::any_of(
        nearer, [&](ViewedScene::Fill fill) { return covers(scene.vertices(fill), x, y); });
    if (!covered) return true;
  }
  return false;
}

/// On a grid so coarse that points are on vertices, sides and planes all the time.
TEST(SeenPoints, AsByLookingAround) {
  std::mt19937_64 random(15);
  const auto below = [&](std::uint64_t n) { return random() % n; };
  const auto any_point = [&](std::uint64_t size) {
    const auto coordinate = [&] { return static_cast<double>(below(size + 1)) / 16; };
    const double x = coordinate(), y = coordinate();
    return Point3(x, y, coordinate());
  };
  int hidden = 0, all = 0;
  for (int k = 0; k < 4000 / test::kSlower; ++k) {
    const std::uint64_t size = 2 + below(5);
    std::vector<Polygon> polygons(1 + below(7));
    for (Polygon& polygon : polygons) {
      polygon.resize(3 + below(4));
      for (Point3& v : polygon) v = any_point(size);
    }
    const ViewedScene scene = scene_of(polygons);
    std::vector<Point3> points;
    for (int i = 0; i < 12; ++i) points.push_back(any_point(size));
    const auto seen = points_seen(scene, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool expected = seen_by_looking_around(scene, points[i]);
      ASSERT_EQ(seen[i] != 0, expected) << "scene " << k << ", point " << i;
      hidden += expected ? 0 : 1;
      ++all;
    }
  }
  EXPECT_GT(hidden, all / 20);
  EXPECT_LT(hidden, all / 2);
}

}  // namespace
}  // namespace displayfile
