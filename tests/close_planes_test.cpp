// Which polygons may have another plane close to their own: none that has is left out.

#include "hidden/touching/close_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "hidden/touching/planes_in_reach.h"
#include "hidden/touching/planes_in_row.h"
#include "hidden/touching/touching_planes.h"

namespace displayfile {
namespace {

class ScenePlanes {
 public:
  explicit ScenePlanes(std::uint64_t seed) : random_(seed) {}

  double coordinate() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Point3 point() { return {coordinate(), coordinate(), coordinate()}; }
  void enter(const std::vector<Point3>& polygon) { polygons.push_back(polygon); }
  void enter_anywhere() { enter({point(), point(), point()}); }
  /// A quadrilateral about `at`, in the plane of u and v.
  static std::vector<Point3> square(const Point3& at, const Point3& u, const Point3& v) {
    return {at - u - v, at + u - v, at + u + v, at - u + v};
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(polygons.size()); }
  /// The numbers of the polygons from that one on.
  std::vector<std::uint32_t> all_from(std::uint32_t first) const {
    std::vector<std::uint32_t> numbers(size() - first);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
  }
  TouchingPlanes::PolygonOf polygon_of() const {
    return [this](std::uint32_t i) -> EnteredPolygon {
      return {polygons[i], modelling ? &*modelling : nullptr};
    };
  }
  ClosePlanes close(double reach, double near) const { return {size(), polygon_of(), reach, near}; }

  std::vector<std::vector<Point3>> polygons;
  std::optional<glm::dmat4x3> modelling;

 private:
  std::mt19937_64 random_;
};

constexpr double kTouching = 0x1p-49, kNearby = 0x1p-24;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

TEST(ClosePlanes, ThatTouchAreFoundInAllDirections) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    ScenePlanes scene(seed);
    if (seed % 3 == 0) {
      scene.modelling = glm::dmat4x3(0.6, 0.8, 0.0, -1.6, 1.2, 0.0, 0.0, 0.0, 1.5, 0.1, 0.2, 0.3);
    }
    for (int n = 0; n < 12; ++n) {
      const Point3 at = scene.point(), u = 0.3 * scene.point(), v = 0.3 * scene.point();
      scene.enter(ScenePlanes::square(at, u, v));
      if (n % 2 == 0) continue;
      const double turned = n % 4 == 1 ? 1.0 : -1.0;  // the other side up
      scene.enter(ScenePlanes::square(at + 0.4 * u - 0.7 * v, 0.5 * u, turned * 0.2 * v));
    }
    const ClosePlanes close = scene.close(kTouching, kNearby);
    const TouchingPlanes touching(scene.size(), scene.polygon_of(), kTouching);
    EXPECT_GT(touching.touching(), 0u);
    for (std::size_t k = 0; k < touching.shared_planes(); ++k) {
      for (const std::uint32_t polygon : touching.members(k)) {
        EXPECT_TRUE(std::ranges::binary_search(close.may_touch(), polygon))
            << "seed " << seed << ", polygon " << polygon;
      }
    }
  }
}

TEST(ClosePlanes, OfPolygonsThatLieAnyhowFewAre) {
  ScenePlanes scene(5);
  for (int n = 0; n < 500; ++n) scene.enter_anywhere();
  const ClosePlanes close = scene.close(kTouching, kNearby);
  EXPECT_LE(close.may_touch().size(), 2u);
}

/// Within reach of a plane lies a polygon that is as small, whatever its normal.
TEST(ClosePlanes, OneThatIsThinMayLieInAnyPlane) {
  ScenePlanes scene(6);
  for (int n = 0; n < 20; ++n) scene.enter_anywhere();
  const Point3 p(0.3, 0.2, 0.0), along(0.1, 0.2, 0.0);
  scene.enter({p, p + along, p + 0.5 * along + Point3(0.0, 0.0, 1e-9)});
  EXPECT_LE(scene.close(kTouching, kNearby).may_touch().size(), 2u);
  scene.enter(ScenePlanes::square({0.3, 0.3, 0.0}, {0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}));
  scene.enter(ScenePlanes::square({0.3, 0.3, 0.2}, {0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}));
  const ClosePlanes close = scene.close(1e-8, kNearby);
  EXPECT_TRUE(std::ranges::binary_search(close.may_touch(), 20u));
  EXPECT_TRUE(std::ranges::binary_search(close.may_touch(), 21u));
  EXPECT_FALSE(std::ranges::binary_search(close.may_touch(), 22u));
}

/// One so thin that doubles do not determine its plane.
TEST(ClosePlanes, WhereOneIsAlmostInLineAllMayBe) {
  ScenePlanes scene(6);
  for (int n = 0; n < 20; ++n) scene.enter_anywhere();
  const Point3 p = scene.point(), along(0.1, 0.2, 0.0);
  scene.enter({p, p + along, p + 0.5 * along + Point3(0.0, 0.0, 1e-14)});
  const ClosePlanes close = scene.close(kTouching, kNearby);
  EXPECT_EQ(close.may_touch(), scene.all_from(0));
}

/// The support plane decides where a polygon is not flat.
TEST(ClosePlanes, SmallOnesLieInTheSupportPlaneOfABentOne) {
  ScenePlanes scene(7);
  for (int n = 0; n < 20; ++n) scene.enter_anywhere();
  scene.enter({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-6}});  // the support leaves out the last
  EXPECT_TRUE(scene.close(kTouching, kNearby).may_touch().empty());
  scene.enter(ScenePlanes::square({0.2, 0.7, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}));
  EXPECT_EQ(scene.close(kTouching, kNearby).may_touch(), scene.all_from(20));
}

/// Within an alike normal's reach of each other, and yet apart: neighbours of a fine mesh, sheets.
TEST(ClosePlanes, ThatAreAlikeAndApartAreNeither) {
  ScenePlanes scene(9);
  const Point3 u(0.5, 0.0, 0.0), v(0.0, 0.5, 0.0);
  scene.enter(ScenePlanes::square({0.0, 0.0, 0.0}, u, v));
  scene.enter(ScenePlanes::square({0.1, 0.1, 1e-6}, u, v));
  const Point3 bent(0.5, 0.0, 1e-6);  // meets the first along a side
  scene.enter({{0.5, -0.5, 0.0}, {0.5, 0.5, 0.0}, Point3(0.5, 0.5, 0.0) + bent});
  const ClosePlanes close = scene.close(kTouching, kNearby);
  EXPECT_TRUE(close.may_touch().empty());
  const TouchingPlanes alone(scene.size(), scene.polygon_of(), kTouching);
  EXPECT_TRUE(close.near_others(alone).empty());
  scene.enter(ScenePlanes::square({0.3, 0.3, 1e-9}, 0.1 * u, 0.1 * v));
  const ClosePlanes near = scene.close(kTouching, kNearby);
  EXPECT_TRUE(near.may_touch().empty());
  const TouchingPlanes still(scene.size(), scene.polygon_of(), kTouching);
  EXPECT_EQ(near.near_others(still), (std::vector<std::uint32_t>{0, 3}));
}

/// Triangles with a common side are apart except along it, unless one is folded over the other.
TEST(ClosePlanes, NeighboursAreNearOnlyWhereTheyAreFolded) {
  const Point3 p(0.0, -0.5, 0.0), q(0.0, 0.5, 0.0), left(-1.0, 0.0, 0.0), right(1.0, 0.0, 1e-8),
      folded(-0.9, 0.1, 1e-8);
  const auto near = [&](const Point3& corner) {
    ScenePlanes scene(10);
    scene.enter({p, q, left});
    scene.enter({q, p, corner});
    const ClosePlanes close = scene.close(kTouching, kNearby);
    EXPECT_TRUE(close.may_touch().empty());
    return close.near_others(TouchingPlanes(scene.size(), scene.polygon_of(), kTouching));
  };
  EXPECT_TRUE(near(right).empty());
  EXPECT_EQ(near(folded), (std::vector<std::uint32_t>{0, 1}));
}

/// One that lies in a plane may come before others in the sort that lie in it too.
TEST(ClosePlanes, AllThatLieInOnePlaneAreFound) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ScenePlanes scene(seed);
    const Point3 at = scene.point(), u = glm::normalize(scene.point()), v = scene.point();
    for (int n = 0; n < 31; ++n) {  // the last has no other above it in the sort
      const Point3 in_plane = at + scene.coordinate() * u + scene.coordinate() * v;
      scene.enter(ScenePlanes::square(in_plane, 0.1 * u, 0.1 * v));
    }
    EXPECT_EQ(scene.close(kTouching, kNearby).may_touch(), scene.all_from(0)) << "seed " << seed;
  }
}

TEST(ClosePlanes, AreNearOthersOnlyIfTheseAreNotOneWithThem) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    ScenePlanes scene(seed);
    for (int n = 0; n < 10; ++n) scene.enter_anywhere();
    const std::uint32_t floor = scene.size();
    const Point3 at = scene.point(), u = 0.3 * scene.point(), v = 0.3 * scene.point();
    for (const double part : {1.0, 0.5, 0.25}) {
      scene.enter(ScenePlanes::square(at, part * u, part * v));
    }
    const TouchingPlanes one(scene.size(), scene.polygon_of(), 0x1p-45);
    EXPECT_TRUE(scene.close(0x1p-45, kNearby).near_others(one).empty()) << "seed " << seed;

    const Point3 off = 1e-9 * glm::normalize(glm::cross(u, v));
    scene.enter(ScenePlanes::square(at + off, 0.5 * u, 0.5 * v));
    const TouchingPlanes two(scene.size(), scene.polygon_of(), 0x1p-45);
    EXPECT_EQ(scene.close(0x1p-45, kNearby).near_others(two), scene.all_from(floor));
  }
}

/// Tangent planes of a sphere around the reference point of distances: all have the same distance.
void enter_tangent_planes(ScenePlanes& scene, int planes) {
  const Point3 least(-2.0), size(4.0), from = least + Point3(0.6180, 0.2716, 0.4142) * size;
  scene.enter({least, least + Point3(0.1, 0, 0), least + Point3(0, 0.1, 0)});
  scene.enter({-least, -least + Point3(0.1, 0, 0), -least + Point3(0, 0, 0.1)});
  for (int n = 0; n < planes; ++n) {
    const Point3 normal = glm::normalize(scene.point()), u = glm::cross(normal, scene.point()),
                 v = glm::cross(normal, u), at = from + 0.5 * normal;
    scene.enter({at, at + 0.01 * u, at + 0.01 * v});
  }
}

TEST(ClosePlanes, ManyOfOneDistanceAreToldApartByPlanesInReach) {
  ScenePlanes scene(8);
  enter_tangent_planes(scene, 1000);
  const ClosePlanes close = scene.close(kTouching, kNearby);
  EXPECT_TRUE(close.may_touch().empty());
  const TouchingPlanes touching(scene.size(), scene.polygon_of(), kTouching);
  EXPECT_EQ(touching.touching(), 0u);
  EXPECT_EQ(close.near_others(touching), scene.all_from(0));
}

// ---- At a reach that is not small compared with polygons --------------------------------------

void expect_equal(const TouchingPlanes& found, const TouchingPlanes& all, std::uint32_t polygons,
                  const std::string& name) {
  for (std::uint32_t i = 0; i < polygons; ++i) {
    ASSERT_EQ(found.plane_of(i), all.plane_of(i)) << name << ", polygon " << i;
  }
  ASSERT_EQ(found.touching(), all.touching()) << name;
  ASSERT_EQ(found.shared_planes(), all.shared_planes()) << name;
  for (std::size_t k = 0; k < all.shared_planes(); ++k) {
    ASSERT_TRUE(std::ranges::equal(found.members(k), all.members(k))) << name << ", plane " << k;
  }
}

/// Fails if TouchingPlanes finds other planes among those that planes_in_reach leaves, or among its
/// pairs.
void expect_same_planes(const ScenePlanes& scene, double reach, const std::string& name) {
  const TouchingPlanes::PolygonOf polygon_of = scene.polygon_of();
  const auto found = planes_in_reach(scene.size(), polygon_of, reach);
  if (!found) return;
  const TouchingPlanes all(scene.size(), polygon_of, reach);
  expect_equal(TouchingPlanes(scene.size(), found->polygons, polygon_of, reach), all, scene.size(),
               name);
  if (!found->pairs) return;
  expect_equal(TouchingPlanes(scene.size(), found->polygons, polygon_of, reach, &*found->pairs),
               all, scene.size(), name + ", by pairs");
}

/// A curved surface of triangles, turned randomly, with slivers on some.
void enter_surface(ScenePlanes& scene, int squares, double bend, double height_of_slivers) {
  const Point3 u = glm::normalize(scene.point()), v = glm::normalize(glm::cross(u, scene.point())),
               w = glm::cross(u, v);
  const auto at = [&](int i, int j) {
    const double x = static_cast<double>(i) / squares, y = static_cast<double>(j) / squares;
    const double bent = bend * (x * x + 0.7 * y * y + 0.02 / squares * scene.coordinate());
    return (x - 0.5) * u + (y - 0.5) * v + bent * w;
  };
  std::vector<Point3> points;
  for (int j = 0; j <= squares; ++j) {
    for (int i = 0; i <= squares; ++i) points.push_back(at(i, j));
  }
  for (int j = 0; j < squares; ++j) {
    for (int i = 0; i < squares; ++i) {
      const auto p = [&](int k, int l) {
        return points[static_cast<std::size_t>((j + l) * (squares + 1) + i + k)];
      };
      scene.enter({p(0, 0), p(1, 0), p(1, 1)});
      scene.enter({p(0, 0), p(1, 1), p(0, 1)});
      if (height_of_slivers == 0.0 || (i + j) % 7 != 0) continue;
      scene.enter({p(0, 0), p(1, 1), 0.5 * (p(0, 0) + p(1, 1)) + height_of_slivers * w});
    }
  }
}

TEST(PlanesInReach, OfSurfacesThatBendAllThatTouchAreFound) {
  std::size_t left_out = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    ScenePlanes scene(seed);
    const double reach = 1e-3 * std::pow(4.0, -static_cast<double>(seed % 4));
    if (seed % 3 == 0) {
      scene.modelling = glm::dmat4x3(0.6, 0.8, 0.0, -1.6, 1.2, 0.0, 0.0, 0.0, 1.5, 0.1, 0.2, 0.3);
    }
    const int squares = 5 + static_cast<int>(seed % 11);
    enter_surface(scene, squares, 0.05 + std::abs(scene.coordinate()),
                  seed % 5 == 0 ? 3.0 * reach : 0.0);
    expect_same_planes(scene, reach, "seed " + std::to_string(seed));
    const auto found = planes_in_reach(scene.size(), scene.polygon_of(), reach);
    if (found && 2 * found->polygons.size() < scene.size()) ++left_out;
  }
  EXPECT_GT(left_out, 30u) << "most of them are left out of some scenes";
}

/// Normals on both sides of the plane where they are turned over.
TEST(PlanesInReach, NormalsThatAreTurnedOverFindEachOther) {
  const Point3 toward = glm::normalize(Point3(0.5242, -0.7633, 0.3770));
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ScenePlanes scene(seed);
    const double reach = 1e-3;
    for (int n = 0; n < 60; ++n) {
      const Point3 across = glm::normalize(glm::cross(toward, scene.point())),
                   other = glm::cross(toward, across), at = scene.point();
      // In the plane of `toward` and `other`, within the reach.
      const auto in_plane = [&](double size) {
        const Point3 p =
            at + size * scene.coordinate() * toward + size * scene.coordinate() * other;
        return p + 0.7 * reach * scene.coordinate() * across;
      };
      scene.enter({in_plane(0.5), in_plane(0.5), in_plane(0.5)});
      if (n % 3 == 0) scene.enter({in_plane(0.2), in_plane(0.2), in_plane(0.2)});
    }
    expect_same_planes(scene, reach, "seed " + std::to_string(seed));
  }
}

TEST(PlanesInReach, PolygonsAnyhowAndAnyReach) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ScenePlanes scene(seed);
    for (int n = 0; n < (seed % 2 == 0 ? 60 : 12); ++n) {
      const Point3 at = scene.point(), u = 0.3 * scene.point(), v = 0.3 * scene.point();
      scene.enter(ScenePlanes::square(at, u, v));
      if (n % 4 == 0) scene.enter(ScenePlanes::square(at + 0.4 * u - 0.7 * v, 0.1 * u, -0.2 * v));
      if (n % 5 == 0) scene.enter({at, at, at + u});  // no plane
    }
    for (const double reach : {0x1p-49, 1e-9, 1e-4, 1e-2, 0.1, 3.0, 1e30, 1e39, 1e200, 1e300}) {
      expect_same_planes(scene, reach, "seed " + std::to_string(seed));
    }
  }
}

/// Planes are compared several at a time, also past the last one.
TEST(PlanesInRow, NoneAreFoundThatWereNotPut) {
  for (const float near :
       {1.0F, 1e38F, std::numeric_limits<float>::max(), static_cast<float>(kNoLimit)}) {
    PlanesInRow planes(3, near);
    for (std::uint32_t k = 0; k < 3; ++k) planes.put(k, {{0.0F, 0.0F, 1.0F}, 0.5F}, k);
    const std::array<PlanesInRow::Run, 1> all{{{0, 3}}};
    const auto found = planes.near({0.3F, 0.2F, 0.1F}, all);
    EXPECT_TRUE(std::ranges::equal(found, std::array<std::uint32_t, 3>{0, 1, 2})) << near;
  }
}

/// Where floats nearly fail to separate planes, and where they do separate them.
TEST(PlanesInReach, OfManyPolygonsAtAnyReach) {
  std::size_t left_out = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    for (const double reach : {1e-4, 1e-5, 1e-6, 3e-7, 1e-7, 1e-8, 1e-11}) {
      ScenePlanes scene(seed);
      if (seed % 3 == 0) {
        scene.modelling = glm::dmat4x3(6.0, 8.0, 0.0, -16.0, 12.0, 0.0, 0.0, 0.0, 15.0, 70, 200, 3);
      }
      enter_surface(scene, 20, 0.05 + std::abs(scene.coordinate()), seed % 2 == 0 ? reach : 0.0);
      for (int n = 0; n < 10; ++n) {  // of the planes of others, far from them
        const std::vector<Point3> of = scene.polygons[static_cast<std::size_t>(61 * n)];
        const Point3 u = of[1] - of[0], v = of[2] - of[0];
        scene.enter({of[0] + 9.0 * u, of[0] + 9.0 * u + 0.4 * v, of[0] + 8.7 * u - 0.2 * v});
      }
      const std::string name = "seed " + std::to_string(seed) + ", " + std::to_string(reach);
      expect_same_planes(scene, reach, name);
      const auto found = planes_in_reach(scene.size(), scene.polygon_of(), reach);
      if (found && 4 * found->polygons.size() < scene.size()) ++left_out;
    }
  }
  EXPECT_GT(left_out, 60u) << "most of them are left out of most scenes";
}

/// The frame is derived from some polygons; these are all in one place, or one point.
TEST(PlanesInReach, PolygonsFarFromThoseThatAreLookedAtFirst) {
  for (const double size : {1.0, 1e-5, 1e-200}) {
    ScenePlanes scene(12);
    for (int n = 0; n < 1500; ++n) {
      const Point3 at = (n % 2 == 0 ? 0.001 * size : 100.0) * scene.point(),
                   u = 0.1 * scene.point(), v = 0.1 * scene.point();
      if (n % 6 == 0) {
        scene.enter({at, at, at});
      } else if (n % 7 == 0 && n % 6 != 1) {
        const std::vector<Point3> of = scene.polygons[static_cast<std::size_t>(n - 1)];
        scene.enter({of[0], 0.6 * of[1] + 0.4 * of[0], 0.3 * of[2] + 0.7 * of[1]});
      } else {
        scene.enter({at, at + u, at + v});
      }
    }
    ASSERT_TRUE(planes_in_reach(scene.size(), scene.polygon_of(), 1e-6).has_value());
    expect_same_planes(scene, 1e-6, std::to_string(size));
  }
}

TEST(PlanesInReach, TangentPlanesOfASphere) {
  ScenePlanes scene(8);
  enter_tangent_planes(scene, 1000);
  for (const double reach : {0x1p-49, 1e-7, 1e-5}) {
    expect_same_planes(scene, reach, std::to_string(reach));
  }
}

/// Stacks of which each has about as many polygons as there are stacks: pairs are too many to keep.
TEST(PlanesInReach, WherePairsAreManyPolygonsAreFoundNevertheless) {
  ScenePlanes scene(5);
  for (int n = 0; n < 1000; ++n) scene.enter_anywhere();
  for (int n = 0; n < 160; ++n) {
    const Point3 at(scene.coordinate(), scene.coordinate(), 0.0);
    scene.enter(ScenePlanes::square(at, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}));
  }
  const auto found = planes_in_reach(scene.size(), scene.polygon_of(), 1e-5);
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->pairs.has_value());
  expect_same_planes(scene, 1e-5, "a floor of 160");
}

TEST(PlanesInReach, WhereMostTouchItGivesUp) {
  ScenePlanes scene(3);
  const Point3 u(0.01, 0.0, 0.0), v(0.0, 0.01, 0.0);
  for (int n = 0; n < 300; ++n) {
    scene.enter(ScenePlanes::square({scene.coordinate(), scene.coordinate(), 0.0}, u, v));
  }
  EXPECT_FALSE(planes_in_reach(scene.size(), scene.polygon_of(), 1e-6).has_value());
  EXPECT_EQ(scene.close(1e-6, 1e-6).may_touch(), scene.all_from(0));
}

TEST(PlanesInReach, CoordinatesOfAnySize) {
  for (const double size : {1e-170, 1e-12, 1e12, 1e170}) {
    ScenePlanes scene(4);
    for (int n = 0; n < 50; ++n) scene.enter_anywhere();
    scene.enter(ScenePlanes::square({0.2, 0.7, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}));
    scene.enter(ScenePlanes::square({0.1, 0.2, 0.0}, {0.2, 0.0, 0.0}, {0.0, 0.1, 0.0}));
    for (std::vector<Point3>& polygon : scene.polygons) {
      for (Point3& p : polygon) p *= size;
    }
    expect_same_planes(scene, 1e-5 * size, std::to_string(std::log10(size)));
  }
}

}  // namespace
}  // namespace displayfile
