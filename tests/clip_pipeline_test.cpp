#include "clip/pipeline/clip_pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "clip/geometry/back_face.h"
#include "clip/geometry/clip_to_rectangle.h"
#include "clip/geometry/planarity.h"

namespace displayfile {
namespace {

using Polygon = std::vector<Point3>;

ClipPipeline pipeline(bool front, bool back, bool perspective = false) {
  View view;
  view.front_clipping = front;
  view.back_clipping = back;
  view.set_depth(-1, 1);
  if (perspective) view.set_perspective({0.2, 0.1, 3});
  return ClipPipeline(ViewVolume(view));
}

double area(std::span<const Point3> p) { return newell_c(p) / 2; }

TEST(ClipPipeline, InsideIsAcceptedAsItIs) {
  auto clip = pipeline(true, true);
  const Polygon square{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  const auto out = clip.clip_polygon(square);
  ASSERT_EQ(out.vertices.size(), 4u);
  EXPECT_EQ(out.vertices[0], Point3(0.25, 0.25, 0.5));
  EXPECT_EQ(out.vertices[2], Point3(0.75, 0.75, 0.5));
  EXPECT_EQ(std::ranges::count(out.edge_visible, 1), 4);
}

TEST(ClipPipeline, OutsideOfAnyPlaneIsRejected) {
  auto clip = pipeline(true, true);
  for (const Point3& away : {Point3(3, 0, 0), Point3(-3, 0, 0), Point3(0, 3, 0), Point3(0, -3, 0),
                             Point3(0, 0, 3), Point3(0, 0, -3)}) {
    const Polygon t{away, away + Point3(0.5, 0, 0), away + Point3(0, 0.5, 0.1)};
    EXPECT_TRUE(clip.clip_polygon(t).vertices.empty());
  }
}

TEST(ClipPipeline, CutsAtEachSideOfTheWindowExactly) {
  auto clip = pipeline(false, false);
  const Polygon diamond{{0, -1.5, 0}, {1.5, 0, 0}, {0, 1.5, 0}, {-1.5, 0, 0}};
  const auto out = clip.clip_polygon(diamond);
  ASSERT_EQ(out.vertices.size(), 8u);
  for (const Point3& p : out.vertices) {
    EXPECT_TRUE(p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1) << p.x << ' ' << p.y;
  }
  // Every second side lies along the window and is not an edge of the polygon.
  EXPECT_EQ(std::ranges::count(out.edge_visible, 1), 4);
  EXPECT_NEAR(area(out.vertices), 1.0 - 4 * 0.5 * 0.25 * 0.25, 1e-15);
}

TEST(ClipPipeline, FrontAndBackPlanesOpenAnObjectOnlyWhenOn) {
  const Polygon sloping{{-0.5, -0.5, 3}, {0.5, -0.5, 3}, {0.5, 0.5, -3}, {-0.5, 0.5, -3}};
  EXPECT_EQ(pipeline(false, false).clip_polygon(sloping).vertices[0].z, 2.0);
  {
    auto clip = pipeline(true, false);
    const auto out = clip.clip_polygon(sloping);
    for (const Point3& p : out.vertices) EXPECT_LE(p.z, 1.0);
    EXPECT_EQ(std::ranges::count(out.vertices, 1.0, &Point3::z), 2);
  }
  auto clip = pipeline(true, true);
  const auto out = clip.clip_polygon(sloping);
  ASSERT_EQ(out.vertices.size(), 4u);
  EXPECT_EQ(std::ranges::count(out.vertices, 1.0, &Point3::z), 2);
  EXPECT_EQ(std::ranges::count(out.vertices, 0.0, &Point3::z), 2);
}

TEST(ClipPipeline, PerspectiveWithoutFrontClippingStillClipsAtTheEye) {
  View view;
  view.set_perspective({0, 0, 5});
  ClipPipeline clip((ViewVolume(view)));
  const Polygon floor{{-1, -1, -2}, {1, -1, -2}, {1, -1, 20}, {-1, -1, 20}};  // runs behind the eye
  const auto out = clip.clip_polygon(floor);
  ASSERT_GE(out.vertices.size(), 3u);
  for (const Point3& p : out.vertices) {
    EXPECT_TRUE(std::isfinite(p.z));
    EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
  }
  const Polygon behind{{-1, -1, 6}, {1, -1, 6}, {1, 1, 7}};
  EXPECT_TRUE(clip.clip_polygon(behind).vertices.empty());
  const Polygon through_the_eye{{-1, 0, 5}, {1, 0, 5}, {0, 0, 9}};
  for (const Point3& p : clip.clip_polygon(through_the_eye).vertices) {
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

/// 0, or of either sign and of a magnitude from 1e-`most` to 1e`most`.
double of_any_magnitude(std::mt19937_64& random, int most) {
  const auto choice = random() % 8;
  if (choice == 0) return 0.0;
  const double digits = std::uniform_real_distribution<double>(1.0, 10.0)(random);
  const double exponent = static_cast<double>(random() % static_cast<unsigned>(2 * most + 1));
  return (choice % 2 == 0 ? digits : 1.0) * std::pow(10.0, exponent - most) *
         (choice < 5 ? 1.0 : -1.0);
}

TEST(ClipPipeline, VerticesAreInsideTheVolumeHoweverLargeTheCoordinates) {
  for (const bool front : {false, true}) {
    for (const bool back : {false, true}) {
      View view;
      view.front_clipping = front;
      view.back_clipping = back;
      view.set_perspective({1.0, 0.5, 2.0});
      ClipPipeline clip((ViewVolume(view)));
      const auto expect_inside = [&](const Point3& p) {
        EXPECT_TRUE(p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0) << p.x << ' ' << p.y;
        EXPECT_TRUE(std::isfinite(p.z) && (!back || p.z >= 0.0)) << p.z;
      };
      std::mt19937_64 random(16);
      int drawn = 0;
      for (int trial = 0; trial < 40000; ++trial) {
        const int most = trial % 100;
        Polygon polygon(3 + random() % 4);
        for (Point3& v : polygon) {
          for (int axis = 0; axis < 3; ++axis) v[axis] = of_any_magnitude(random, most);
        }
        const auto clipped = clip.clip_polygon(polygon);
        drawn += clipped.vertices.empty() ? 0 : 1;
        for (const Point3& p : clipped.vertices) expect_inside(p);
        Point3 p, q;
        if (!clip.clip_line(polygon[0], polygon[1], p, q)) continue;
        expect_inside(p);
        expect_inside(q);
        if (HasFailure()) return;
      }
      EXPECT_GT(drawn, 1000);
    }
  }
}

TEST(ClipPipeline, FarEndOfASideLeavesTheCutItsDigits) {
  View view;
  view.front_clipping = true;
  view.set_perspective({0.0, 0.0, 2.0});
  ClipPipeline clip((ViewVolume(view)));
  // From far before the front plane, z = 1, to farther behind it. There W is 1/2, and 0.25 is at
  // 0.5 in the view plane, a quarter of the window from its side.
  Point3 near, far;
  ASSERT_TRUE(clip.clip_line({0.25, 0.0, 1e8}, {0.25, 0.0, -1e16}, near, far));
  EXPECT_NEAR(near.x, 0.75, 1e-7);
  EXPECT_NEAR(near.z, 1.0, 1e-15);
}

TEST(ClipPipeline, ConcavePolygonKeepsItsAreaInside) {
  auto clip = pipeline(false, false);
  // A comb whose teeth leave the window at the top.
  const Polygon comb{{-0.8, -0.5, 0}, {0.8, -0.5, 0}, {0.8, 2, 0},  {0.4, 2, 0},
                     {0.4, 0, 0},     {-0.4, 0, 0},   {-0.4, 2, 0}, {-0.8, 2, 0}};
  const auto out = clip.clip_polygon(comb);
  const double expected = (1.6 * 0.5 + 2 * 0.4 * 1.0) / 4;  // device area is a quarter
  EXPECT_NEAR(area(out.vertices), expected, 1e-15);
}

// Random clipped triangles cover the part of the polygon inside the window: judged by sampling the
// definition.
TEST(ClipPipeline, ClippedPolygonCoversWhatTheWindowCutsOut) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-2, 2);
  auto clip = pipeline(true, true);
  const auto side = [](const Point3& a, const Point3& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
  };
  const auto covers = [&](std::span<const Point3> p, double x, double y) {
    bool inside = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Point3 &a = p[i], &b = p[(i + 1) % p.size()];
      if ((a.y <= y) != (b.y <= y) && (side(a, b, x, y) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
  };
  int seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon t{{u(random), u(random), u(random)},
                    {u(random), u(random), u(random)},
                    {u(random), u(random), u(random)}};
    Polygon device;
    for (const Point3& p : t) device.emplace_back((p.x + 1) / 2, (p.y + 1) / 2, (p.z + 1) / 2);
    const auto out = clip.clip_polygon(t);
    const Polygon clipped(out.vertices.begin(), out.vertices.end());
    const Point3 n = newell_normal(device);
    for (int k = 0; k < 100; ++k) {
      const double x = u(random) / 4 + 0.5, y = u(random) / 4 + 0.5;
      const double z = device[0].z - (n.x * (x - device[0].x) + n.y * (y - device[0].y)) / n.z;
      const bool expected = covers(device, x, y) && z > 0 && z < 1;
      const bool got = !clipped.empty() && covers(clipped, x, y);
      EXPECT_EQ(got, expected) << trial << ' ' << x << ' ' << y << ' ' << z;
      seen += got;
    }
  }
  EXPECT_GT(seen, 1000);
}

// Two polygons that share an edge are cut at the same point, bit for bit, whichever way each
// runs along it: every clipped vertex off the window's own corners appears in both.
TEST(ClipPipeline, SharedEdgesAreCutAtTheSamePointBitForBit) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> u(-3, 3);
  for (bool perspective : {false, true}) {
    auto clip = pipeline(true, true, perspective);
    int cut_edges = 0;
    for (int trial = 0; trial < 20000; ++trial) {
      const Point3 a(u(random), u(random), u(random)), b(u(random), u(random), u(random));
      const Point3 c(u(random), u(random), u(random)), d(u(random), u(random), u(random));
      // The edge a-b alone is a line; its parts in both polygons must have the same two ends.
      Point3 p, q;
      if (!clip.clip_line(a, b, p, q)) continue;
      const auto on_edge = [&](std::span<const Point3> polygon) {
        std::vector<Point3> found;
        for (const Point3& v : polygon) {
          if (v == p || v == q) found.push_back(v);
        }
        return found.size();
      };
      EXPECT_EQ(on_edge(clip.clip_polygon(Polygon{a, b, c}).vertices), 2u);
      EXPECT_EQ(on_edge(clip.clip_polygon(Polygon{b, a, d}).vertices), 2u);
      EXPECT_EQ(on_edge(clip.clip_polygon(Polygon{d, c, b, a}).vertices), 2u);
      ++cut_edges;
    }
    EXPECT_GT(cut_edges, 1000);
  }
}

TEST(ClipPipeline, VertexOnAPlaneGivesNoRepeatedVertex) {
  auto clip = pipeline(false, false);
  const auto out = clip.clip_polygon(Polygon{{1, 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}});
  EXPECT_EQ(out.vertices.size(), 3u);
  const auto cut = clip.clip_polygon(Polygon{{1, -0.5, 0}, {2, 0, 0}, {1, 0.5, 0}, {0, 0, 0}});
  EXPECT_EQ(cut.vertices.size(), 3u);
  EXPECT_EQ(std::ranges::count(cut.edge_visible, 0), 1);  // the side along the window
  // Touching the window from outside leaves nothing.
  EXPECT_TRUE(clip.clip_polygon(Polygon{{1, 0, 0}, {2, -1, 0}, {2, 1, 0}}).vertices.empty());
}

TEST(ClipPipeline, HiddenEdgesStayHidden) {
  auto clip = pipeline(false, false);
  const std::uint8_t visible[] = {1, 0, 1};
  const auto out = clip.clip_polygon(Polygon{{-0.5, -0.5, 0}, {2, 0, 0}, {-0.5, 0.5, 0}}, visible);
  ASSERT_EQ(out.vertices.size(), 4u);
  EXPECT_EQ(out.edge_visible[0], 1);
  EXPECT_EQ(out.edge_visible[1], 0);  // the rest of the hidden side
  EXPECT_EQ(out.edge_visible[2], 0);  // along the window
  EXPECT_EQ(out.edge_visible[3], 1);
}

TEST(ClipPipeline, LinesAreClippedAtBothEnds) {
  auto clip = pipeline(false, false);
  Point3 p, q;
  ASSERT_TRUE(clip.clip_line({-3, 0, 0}, {3, 0, 0}, p, q));
  EXPECT_EQ(p.x, 0.0);
  EXPECT_EQ(q.x, 1.0);
  EXPECT_FALSE(clip.clip_line({-3, 2, 0}, {3, 2, 0}, p, q));
  EXPECT_FALSE(clip.clip_line({-3, 0, 0}, {0, 3, 0}, p, q));  // passes the corner by
}

TEST(BackFace, CounterclockwiseIsAFrontFace) {
  const Polygon front{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const Polygon back(front.rbegin(), front.rend());
  const Polygon edge_on{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
  EXPECT_FALSE(is_back_face(front));
  EXPECT_TRUE(is_back_face(back));
  EXPECT_TRUE(is_back_face(edge_on));
}

TEST(BackFace, NewellsSumsAreTwiceTheProjectedAreas) {
  // Equation 9.3 on a concave polygon in the plane z = x + 2y: normal (-1, -2, 1).
  const auto lift = [](double x, double y) { return Point3(x, y, x + 2 * y); };
  const Polygon arrow{lift(0, 0), lift(4, 0), lift(4, 4), lift(2, 1)};
  const Point3 n = newell_normal(arrow);
  EXPECT_DOUBLE_EQ(n.z, 2 * 6.0);
  EXPECT_DOUBLE_EQ(n.x / n.z, -1.0);
  EXPECT_DOUBLE_EQ(n.y / n.z, -2.0);
  EXPECT_DOUBLE_EQ(newell_c(arrow), n.z);
}

TEST(BackFace, SmallPolygonFarFromTheOriginIsJudgedRightly) {
  const double o = 1e8, e = 1.0 / 1024;  // the plain sums would cancel to noise
  EXPECT_FALSE(is_back_face(Polygon{{o, o, 0}, {o + e, o, 0}, {o, o + e, 0}}));
  EXPECT_TRUE(is_back_face(Polygon{{o, o, 0}, {o, o + e, 0}, {o + e, o, 0}}));
}

TEST(Planarity, ToleranceIsRelativeToThePolygon) {
  for (double size : {1e-20, 1.0, 1e30}) {
    const auto quad = [&](double lift) {
      return Polygon{Point3(0, 0, 0) * size, Point3(1, 0, 0) * size, Point3(1, 1, lift) * size,
                     Point3(0, 1, 0) * size};
    };
    EXPECT_TRUE(is_flat(quad(0)));
    EXPECT_TRUE(is_flat(quad(1e-6)));
    EXPECT_FALSE(is_flat(quad(1e-4)));
  }
}

TEST(ClipToRectangle, SolvedCases) {
  const Rectangle unit{0, 1, 0, 1};
  std::vector<Point3> spare;
  const struct {
    std::vector<Point3> polygon, inside;
  } cases[] = {
      {{{0.25, 0.25, 1}, {0.5, 0.25, 1}, {0.5, 0.5, 1}},
       {{0.25, 0.25, 1}, {0.5, 0.25, 1}, {0.5, 0.5, 1}}},
      {{{2, 2, 0}, {3, 2, 0}, {3, 3, 0}}, {}},
      // Its z runs linearly: 0 at the left to 4 at the right.
      {{{-1, 0.25, 0}, {3, 0.25, 4}, {3, 0.75, 4}, {-1, 0.75, 0}},
       {{0, 0.25, 1}, {1, 0.25, 2}, {1, 0.75, 2}, {0, 0.75, 1}}},
      {{{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}},
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}},  // on the sides
      {{}, {}},
  };
  for (const auto& c : cases) {
    std::vector<Point3> polygon = c.polygon;
    clip_to_rectangle(polygon, spare, unit);
    ASSERT_EQ(polygon.size(), c.inside.size());
    const auto first = std::ranges::find(polygon, c.inside.empty() ? Point3(0.0) : c.inside[0]);
    if (!polygon.empty()) {
      ASSERT_NE(first, polygon.end());
      std::rotate(polygon.begin(), first, polygon.end());
    }
    EXPECT_EQ(polygon, c.inside);
  }
}

TEST(ClipToRectangle, InTwoDimensionsTheSamePoints) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> u(-2, 3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Point3> solid, spare_solid;
    std::vector<Point2> flat, spare_flat;
    for (int k = 0; k < 7; ++k) {
      solid.emplace_back(u(random), u(random), u(random));
      flat.emplace_back(solid.back());
    }
    clip_to_rectangle(solid, spare_solid, {0, 1, -1, 2});
    clip_to_rectangle(flat, spare_flat, {0, 1, -1, 2});
    ASSERT_EQ(solid.size(), flat.size());
    for (std::size_t k = 0; k < flat.size(); ++k) {
      EXPECT_EQ(Point2(solid[k]), flat[k]);
      EXPECT_NEAR(flat[k].x, 0.5, 0.5 + 1e-15);
      EXPECT_NEAR(flat[k].y, 0.5, 1.5 + 1e-15);
    }
  }
}

}  // namespace
}  // namespace displayfile
