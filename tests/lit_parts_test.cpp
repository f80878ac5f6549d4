// Shadows as the map finds them (displayfile/segments/lit_parts.md), beside those that rays find:
// two ways that share no line. Drawn in pixels, both are the same picture.

#include "displayfile/segments/lit_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/picture_compare.h"
#include "interp/raster/software.h"
#include "tests/replayed.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::Dice;
using test::kSlower;
using Polygons = std::vector<std::vector<Point3>>;

constexpr int kSize = 128;

/// A view of the surroundings of the origin, about 2 wide.
enum class Eye { level, oblique, close, above };
constexpr Eye kEyes[] = {Eye::level, Eye::oblique, Eye::close, Eye::above};

void set_view(Eye eye, GraphicsSystem& g) {
  g.set_view_depth(-2, 4);
  switch (eye) {
    case Eye::level: return;
    case Eye::oblique: return g.set_parallel({0.3, -0.2, 1});
    case Eye::close: return g.set_perspective({0.3, 0.9, 2.6});
    case Eye::above:
      g.set_view_plane_normal({0.2, -1, -0.8});
      return g.set_perspective({-0.6, 2.5, 2.2});
  }
}

GraphicsSystem drawn(const std::vector<Polygons>& segments, const Point3& light, Eye eye) {
  GraphicsSystem g;
  set_view(eye, g);
  g.set_line_style({LineStyle::Kind::none});
  g.set_light(light, 0.3);
  g.set_shadows(true);
  int name = 0;
  for (const Polygons& polygons : segments) {
    g.open_segment(++name);
    Colour colour(0.9, 0.6, 0.3);
    for (const auto& polygon : polygons) {
      colour = {colour.g, colour.b, colour.r};
      g.set_fill_style({FillStyle::Kind::solid, colour});
      g.polygon_abs_3(polygon);
    }
    g.close_segment();
  }
  return g;
}

DisplayFile with_map(const GraphicsSystem& g, int threads = 1) {
  SortedDisplayFile sorted;
  return sorted.update(g.display_file(),
                       {.method = HiddenMethod::map, .shadows = true, .threads = threads});
}

Picture by_map(const GraphicsSystem& g, int threads = 1) {
  RasterRequest request;
  request.width = request.height = kSize;
  request.ids = true;
  request.sorted = true;
  SoftwareRenderer software;
  return software.draw(with_map(g, threads), request);
}

Picture by_rays(const GraphicsSystem& g) {
  DrawOptions options{.width = kSize, .height = kSize, .samples = 1};
  options.surfaces.method = HiddenMethod::z_buffer;
  options.ids = "asked for";
  return draw(g, options);
}

/// A centre on the edge of a shadow, up to rounding, may be decided either way.
void expect_the_same_shadows(const GraphicsSystem& g, const std::string& what) {
  const Picture map = by_map(g), rays = by_rays(g);
  EXPECT_EQ(map.ids, rays.ids) << what;
  int differ = 0;
  for (std::size_t k = 0; k < rays.pixels.size(); ++k) {
    differ += map.pixels[k] != rays.pixels[k] ? 1 : 0;
  }
  EXPECT_LE(differ, 0) << what;
}

Point3 at_random(Dice& dice, const Point3& low, const Point3& high) {
  const double x = dice.part(), y = dice.part(), z = dice.part();
  return low + Point3(x, y, z) * (high - low);
}
Point3 light_at_random(Dice& dice) { return at_random(dice, {-1, 0.2, -0.6}, {1, 1, 1}); }

Polygons box(const Point3& low, const Point3& high) {
  const auto at = [&](int x, int y, int z) {
    return Point3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  return {{at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
          {at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0)},
          {at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1)},
          {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)},
          {at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}};
}

void add(const Polygons& more, Polygons& polygons) {
  polygons.insert(polygons.end(), more.begin(), more.end());
}

/// Tiles, and a stripe painted over them.
Polygons tiled_floor(int n, double height) {
  Polygons tiles;
  const auto at = [&](int i) { return -1.0 + 2.0 * i / n; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      tiles.push_back({{at(i), height, at(j + 1)},
                       {at(i + 1), height, at(j + 1)},
                       {at(i + 1), height, at(j)},
                       {at(i), height, at(j)}});
    }
  }
  tiles.push_back(
      {{-0.9, height, 0.3}, {0.9, height, 0.3}, {0.9, height, 0.1}, {-0.9, height, 0.1}});
  return tiles;
}

TEST(LitParts, OfTrianglesAnywhere) {
  for (std::uint32_t seed = 0; seed < 40 / kSlower; ++seed) {
    Dice dice{seed};
    Polygons triangles;
    for (int k = 0; k < 40; ++k) {
      const auto corner = [&](double far) { return at_random(dice, Point3(-far), Point3(far)); };
      const Point3 p = corner(1.0), q = corner(0.6), r = corner(0.6);
      triangles.push_back({p, p + q, p + r});
    }
    const Eye eye = kEyes[seed % 4];
    expect_the_same_shadows(drawn({triangles}, light_at_random(dice), eye),
                            "seed " + std::to_string(seed));
  }
}

TEST(LitParts, OfBoxesOnTiles) {
  for (std::uint32_t seed = 0; seed < 40 / kSlower; ++seed) {
    Dice dice{seed};
    const double floor = -0.7;
    std::vector<Polygons> segments{tiled_floor(3, floor), {}};
    for (int k = 0; k < 6; ++k) {
      const Point3 low = at_random(dice, {-0.9, floor, -0.9}, {0.6, floor, 0.6});
      add(box(low, low + at_random(dice, {0.05, 0.1, 0.05}, {0.4, 0.9, 0.4})), segments[1]);
    }
    const Eye eye = kEyes[seed % 4];
    expect_the_same_shadows(drawn(segments, light_at_random(dice), eye),
                            "seed " + std::to_string(seed));
  }
}

/// Most faces' neighbours are in nearly the same light, down to where it grazes them.
TEST(LitParts, OfABallAboveAFloor) {
  Polygons ball;
  constexpr int kAround = 24, kUp = 16;
  const auto point = [&](int i, int k) {
    const double a = std::numbers::pi * i / kUp, b = 2 * std::numbers::pi * (k % kAround) / kAround;
    return Point3(0.5 * std::sin(a) * std::sin(b), -0.5 * std::cos(a),
                  0.5 * std::sin(a) * std::cos(b));
  };
  for (int i = 0; i < kUp; ++i) {
    for (int k = 0; k < kAround; ++k) {
      if (i + 1 < kUp) ball.push_back({point(i, k), point(i + 1, k + 1), point(i + 1, k)});
      if (i > 0) ball.push_back({point(i, k), point(i, k + 1), point(i + 1, k + 1)});
    }
  }
  for (std::uint32_t seed = 0; seed < 12 / kSlower + 1; ++seed) {
    Dice dice{seed};
    for (const Eye eye : kEyes) {
      expect_the_same_shadows(drawn({tiled_floor(2, -0.8), ball}, light_at_random(dice), eye),
                              "seed " + std::to_string(seed));
    }
  }
}

/// A scene of triangles that shadows fall on, and of polygons in planes through the eye, or along
/// the projectors, that cross themselves, are concave, or have corners twice: seen as lines.
GraphicsSystem with_polygons_seen_edge_on(std::uint32_t seed) {
  Dice dice{seed};
  const auto below = [&](int n) { return dice.from(0, n - 1); };
  GraphicsSystem g;
  const bool along_x = below(2) == 0;
  const auto placed = [&](double away, double across, double up) {  // away from the viewer
    return along_x ? Point3(away, up, across) : Point3(across, up, -away);
  };
  if (along_x) g.set_view_plane_normal({1, 0, 0});
  g.set_view_depth(-2, 4);
  constexpr double kDistances[] = {4.256465140655326, 3.0, 2.5, 3.7};
  const Point3 eye = placed(-kDistances[below(4)], 0.0, 0.0);
  below(3) == 0 ? g.set_parallel(-eye) : g.set_perspective(eye);
  g.set_line_style({LineStyle::Kind::none});
  const double away = -0.2 - dice.part(), across = 2.0 * dice.part() - 1.0;
  g.set_light(placed(away, across, 0.3 + dice.part()), 0.3);
  g.set_shadows(true);
  const auto coordinate = [&] {
    return below(2) == 0 ? 0.25 * below(9) - 1.0 : below(2001) / 1000.0 - 1.0;
  };
  g.open_segment(1);
  for (int k = 1 + below(2); k > 0; --k) {
    std::vector<Point3> triangle;
    for (int c = 0; c < 3; ++c) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      triangle.emplace_back(x, y, z);
    }
    g.polygon_abs_3(triangle);
  }
  for (int k = 1 + below(3); k > 0; --k) {
    const bool is_regular = below(3) > 0;  // more of them in line in space, too
    const double to_side = coordinate(), up = coordinate();
    std::vector<Point3> polygon;
    for (int sides = 4 + below(4); sides > 0; --sides) {
      const double depth = is_regular ? 0.5 * below(4) - 1.0 : coordinate();
      const double along = is_regular ? 0.5 * below(5) - 1.0 : coordinate();
      polygon.push_back(placed(depth, along * to_side, along * up));
    }
    if (below(4) == 0) polygon.push_back(polygon[1]);
    g.polygon_abs_3(polygon);
  }
  g.close_segment();
  return g;
}

TEST(LitParts, OfPolygonsSeenEdgeOn) {
  std::size_t shadows = 0;
  for (std::uint32_t seed = 0; seed < 300 / kSlower; ++seed) {
    const GraphicsSystem g = with_polygons_seen_edge_on(seed);
    expect_the_same_shadows(g, "seed " + std::to_string(seed));
    if (HasFailure()) return;
    const Picture lit = by_rays(g);
    for (std::size_t k = 1; k < lit.pixels.size(); ++k) {  // two colours of one polygon
      const bool changes = lit.ids[k] == lit.ids[k - 1] && lit.pixels[k] != lit.pixels[k - 1];
      if (lit.ids[k] >= 0 && changes) {
        ++shadows;
        break;
      }
    }
  }
  EXPECT_GT(shadows, 90U / kSlower);
}

/// The light is parallel to facets of these, except for rounding: nothing may reach beyond the
/// polygons, and the picture is that of rays.
TEST(LitParts, OfFacetsThatTheLightGrazes) {
  for (int k = 0; k < 36; ++k) {
    const double x = -0.3 + 0.05 * (k % 6), y = -0.2 + 0.06 * (k / 6);
    GraphicsSystem g;
    g.set_view_plane_normal({-1, -1, -2});
    g.set_perspective({1, 1, 4});
    g.set_line_style({LineStyle::Kind::none});
    g.set_light({1, 2, 3}, 0.2);
    g.set_shadows(true);
    g.open_segment(1);
    torus_3(g, {x, y, 0}, 0.4, 0.15, 12);
    g.close_segment();
    const std::string what = "at " + std::to_string(x) + " " + std::to_string(y);
    const Picture map = by_map(g), rays = by_rays(g);
    EXPECT_EQ(map.ids, rays.ids) << what;
    EXPECT_LE(compare(map, rays).wrong_pixels, 0) << what;
  }
}

/// Three of its corners are in line in space, and look from the eye as far apart as any.
TEST(LitParts, OfOneThatCrossesItself) {
  const GraphicsSystem g = test::replayed(R"(
      set-view-plane-normal 1.0 0 0
      set-perspective -4.256465140655326 0.0 0.0
      set-view-depth -1.0 4.0
      set-line-style none
      set-light 1 2 3
      set-shadows on
      open-segment 1
      polygon-abs-3 -1 -1 -0.75  0 1 -0.75  -0.352 -0.584 0.91
      polygon-abs-3 -1 0 0.0  0 -0.5 -0.1  0.5 -0.5 -0.1  0 0.5 0.1  -1 0.5 0.1  -1 -0.5 -0.1
      close-segment)");
  expect_the_same_shadows(g, "one that crosses itself");
}

/// Lit parts keep their shades, and parts in shadow have none.
TEST(LitParts, AreShadedSmoothly) {
  for (const Shading shading : {Shading::gouraud, Shading::phong}) {
    for (const Eye eye : kEyes) {
      GraphicsSystem g;
      set_view(eye, g);
      g.set_line_style({LineStyle::Kind::none});
      g.set_light({0.5, 1.0, 0.7}, 0.2);
      g.set_shadows(true);
      g.set_shading(shading);
      g.open_segment(1);
      for (int k = 0; k < 5; ++k) {
        const Point3 at(-0.8 + 0.2 * k, -0.6 + 0.25 * k, 0.3 * k - 0.6);
        const Polygons triangles{{at, at + Point3(0.9, 0.1, 0.2), at + Point3(0.3, 0.2, -0.8)},
                                 {at, at + Point3(0.3, 0.2, -0.8), at + Point3(-0.4, 0.5, 0.3)}};
        for (const auto& triangle : triangles) {
          g.set_vertex_normals({{0.3, 1, 0.2}, {-0.2, 1, 0.6}, {0.6, 0.5, 0.4}});
          g.polygon_abs_3(triangle);
        }
      }
      g.close_segment();
      const Picture map = by_map(g), rays = by_rays(g);
      EXPECT_EQ(map.ids, rays.ids);
      EXPECT_LE(compare(map, rays).largest, 1.0);
    }
  }
}

TEST(LitParts, AreTheSameForAnyNumberOfThreads) {
  Dice dice{7};
  Polygons boxes;
  for (int k = 0; k < 12; ++k) {
    const Point3 low = at_random(dice, Point3(-0.9), Point3(0.6));
    add(box(low, low + at_random(dice, Point3(0.1), Point3(0.5))), boxes);
  }
  const GraphicsSystem g = drawn({tiled_floor(3, -0.8), boxes}, {0.3, 1, 0.5}, Eye::close);
  const std::string one = dump(with_map(g));
  EXPECT_EQ(dump(with_map(g, 3)), one);
  EXPECT_EQ(one.find("shadow"), std::string::npos);
}

/// An order found without shadows cannot be reused; one that has them can be reused.
TEST(LitParts, AreFoundAgainWhereSomethingChanged) {
  GraphicsSystem g = drawn({tiled_floor(1, -0.5), box({-0.3, -0.2, -0.3}, {0.2, 0.1, 0.2})},
                           {0.2, 1, 0.1}, Eye::above);
  SortedDisplayFile sorted;
  SurfacePlan options{.method = HiddenMethod::map};
  const auto pieces = [&] { return sorted.update(g.display_file(), options).sorted(); };
  const auto without = pieces();
  options.shadows = true;
  const auto with = pieces();
  EXPECT_GT(with->counts.pieces, without->counts.pieces);
  EXPECT_EQ(pieces(), with);
  g.set_visibility(2, false);
  EXPECT_LT(pieces()->counts.pieces, with->counts.pieces);
  options.shadows = false;
  EXPECT_FALSE(pieces()->plan.shadows);
}

}  // namespace
}  // namespace displayfile
