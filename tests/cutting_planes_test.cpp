// Cutting planes: the remainder is a scene like any other, and the same for every method and truth.

#include "clip/pipeline/cutting_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/retained_views.h"
#include "interp/draw/draw.h"
#include "interp/truth/truth.h"
#include "interp/truth/world_truth.h"
#include "tests/error_of.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::expect_error;
using test::Retained;
using test::Source;

Point3 any_point(Source& s) { return {s.unit(), s.unit(), s.unit()}; }

void set_any_plane(Source& s, int n, auto& planes) {
  const Point3 normal =
      s.below(3) == 0 ? Point3(0, s.below(2) == 0 ? 1 : -1, 0) : test::any_direction(s);
  const Point3 through = any_point(s);
  const double d = -(normal.x * through.x + normal.y * through.y + normal.z * through.z);
  if constexpr (requires { planes.set(n, 0.0, 0.0, 0.0, 0.0); }) {
    planes.set(n, normal.x, normal.y, normal.z, d);
  } else {
    planes.set_cutting_plane(n, normal.x, normal.y, normal.z, d);
  }
}

bool holds(const CutPolygon& polygon, const Point3& p) {
  return std::ranges::find(polygon.vertices, p) != polygon.vertices.end();
}

TEST(CuttingPlanes, SharedEdgesAreCutAtTheSamePointBitForBit) {
  Source s(5);
  int cut = 0;
  for (int round = 0; round < 20000; ++round) {
    CuttingPlanes planes, others;
    for (int n = 1; n <= s.between(1, 6); ++n) set_any_plane(s, n, planes);
    others = planes;  // each call's result is its object's
    const Point3 a = any_point(s), b = any_point(s);
    const std::array one{a, b, any_point(s)}, other{b, a, any_point(s)};
    const CutPolygon left = planes.cut(one, {}, {}), right = others.cut(other, {}, {});
    Point3 from = a, to = b, back_from = b, back_to = a;
    if (!planes.cut_line(from, to)) continue;
    ASSERT_TRUE(planes.cut_line(back_from, back_to));
    ASSERT_EQ(from, back_to);
    ASSERT_EQ(to, back_from);
    if (from == to || planes.outcode(from) != 0 || planes.outcode(to) != 0) continue;
    for (const Point3& p : {from, to}) {
      ASSERT_TRUE(holds(left, p)) << round;
      ASSERT_TRUE(holds(right, p)) << round;
    }
    cut += from != a || to != b ? 1 : 0;
  }
  EXPECT_GT(cut, 1000);
}

TEST(CuttingPlanes, APlaneAcrossAnAxisIsMetExactlyAndSidesAlongItAreNotDrawn) {
  CuttingPlanes planes;
  planes.set(3, 0, -7, 0, 0.7);  // y <= 0.1
  const std::array square{Point3(0, 0, 0.3), Point3(1, 0, 0.4), Point3(1, 1, 0.7),
                          Point3(0, 1, 0.1)};
  const CutPolygon cut = planes.cut(square, {}, {});
  ASSERT_EQ(cut.vertices.size(), 4u);
  int on_plane = 0, drawn = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    on_plane += cut.vertices[k].y == 0.7 / 7 ? 1 : 0;
    drawn += cut.edge_visible[k];
  }
  EXPECT_EQ(on_plane, 2);
  EXPECT_EQ(drawn, 3);
}

TEST(CuttingPlanes, WhatLiesInAPlaneOrTouchesItStays) {
  CuttingPlanes planes;
  planes.set(1, 0, 0, 1, 0);
  const std::array in_plane{Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0)};
  EXPECT_EQ(planes.cut(in_plane, {}, {}).vertices.size(), 3u);
  const std::array below{Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, -1)};
  for (const Point3& p : planes.cut(below, {}, {}).vertices) EXPECT_EQ(p.z, 0.0);  // of no area
  const std::array away{Point3(0, 0, -1), Point3(1, 0, -1), Point3(0, 1, -1)};
  EXPECT_TRUE(planes.cut(away, {}, {}).vertices.empty());
  Point3 a(0, 0, -1), b(0, 0, -2);
  EXPECT_FALSE(planes.cut_line(a, b));
}

/// A box and its contents, cut to x <= 0.25.
void enter_box(GraphicsSystem& g, bool by_hand) {
  g.set_parallel({0.3, 0.2, 1});
  g.rotate_y_3(90);  // planes are of the world: not turned
  if (!by_hand) g.set_cutting_plane(2, -1, 0, 0, 0.25);
  g.open_segment(1);
  g.create_transformation_3();
  if (by_hand) {
    g.polygon_abs_3({{-0.5, -0.5, 0.5}, {0.25, -0.5, 0.5}, {0.25, 0.5, 0.5}, {-0.5, 0.5, 0.5}});
    g.polygon_abs_3({{-0.5, -0.5, 0.0}, {0.25, -0.5, 0.0}, {0.25, 0.5, 0.0}, {-0.5, 0.5, 0.0}});
    g.set_pick_id(7);
    g.polygon_abs_3({{0.1, 0.1, 0.7}, {0.25, 0.25, 0.7}, {0.25, 0.4, 0.7}, {0.1, 0.4, 0.7}});
    g.move_abs_3(-0.7, 0, 0.8);
    g.line_abs_3(0.25, 0, 0.8);
  } else {
    g.polygon_abs_3({{-0.5, -0.5, 0.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}});
    g.polygon_abs_3({{-0.5, -0.5, 0.0}, {0.5, -0.5, 0.0}, {0.5, 0.5, 0.0}, {-0.5, 0.5, 0.0}});
    g.set_pick_id(7);
    g.polygon_abs_3({{0.1, 0.1, 0.7}, {0.4, 0.4, 0.7}, {0.1, 0.4, 0.7}});
    g.polygon_abs_3({{0.3, 0.1, 0.7}, {0.4, 0.4, 0.7}, {0.5, 0.4, 0.7}});  // gone
    g.move_abs_3(-0.7, 0, 0.8);
    g.line_abs_3(1.2, 0, 0.8);
    g.text("gone");
  }
  g.close_segment();
}

TEST(CuttingPlanes, TheCutSceneIsThatOfPolygonsCutByHand) {
  GraphicsSystem by_plane, by_hand;
  enter_box(by_plane, false);
  enter_box(by_hand, true);
  const Picture a = truth(by_plane.display_file(), 80, 80, true);
  const Picture b = truth(by_hand.display_file(), 80, 80, true);
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.depth, b.depth);
  const std::string cut = dump(by_plane.display_file());
  EXPECT_EQ(cut.find("gone"), std::string::npos);
  const auto last_line = [](const std::string& text) { return text.substr(text.rfind("\nmove")); };
  EXPECT_EQ(last_line(cut), last_line(dump(by_hand.display_file())));
}

/// Shapes in the unit cube, cut by some planes.
void enter_cut_shapes(Source& s, GraphicsSystem& g) {
  g.set_back_face_removal(false);
  for (int n = 1; n <= s.between(1, 4); ++n) set_any_plane(s, n, g);
  g.open_segment(1);
  g.set_cut_faces({CutFaces::Kind::hatched, 0.1});
  sphere_3(g, any_point(s), 0.4, 10);
  torus_3(g, any_point(s), 0.3, 0.1, 9);
  g.set_cut_faces({CutFaces::Kind::open});
  box_3(g, {0.1, 0.2, 0.3}, {0.7, 0.8, 0.9});
  g.set_cutting_plane_off(1);
  torus_3(g, any_point(s), 0.3, 0.1, 9);
  g.polygon_abs_3({any_point(s), any_point(s), any_point(s)});
  const std::array heights{0.1, 0.3, s.unit(), 0.4, s.unit(), 0.2, s.unit(), 0.7, 0.1};
  g.surface_3({0.0, 1.0, 3, 0.0, 1.0, 3, heights});
  g.close_segment();
}

void set_view(GraphicsSystem& g, const View& view) {
  g.set_view_reference_point(view.reference_point);
  g.set_view_plane_normal(view.plane_normal);
  g.set_view_distance(view.distance);
  g.set_view_up(view.up);
  view.projection == View::Projection::parallel ? g.set_parallel(view.direction_of_projection)
                                                : g.set_perspective(view.centre_of_projection);
  g.set_view_depth(view.front, view.back);
  g.set_window(view.window.x_min, view.window.x_max, view.window.y_min, view.window.y_max);
}

TEST(CuttingPlanes, EveryMethodSeesWhatTheTruthSees) {
  constexpr std::array kMethods{
      HiddenMethod::bsp,       HiddenMethod::depth_sort,     HiddenMethod::z_buffer,
      HiddenMethod::scan_line, HiddenMethod::scan_line_z,    HiddenMethod::ray_cast,
      HiddenMethod::warnock,   HiddenMethod::world_ray_cast, HiddenMethod::map};
  for (const HiddenMethod method : kMethods) {
    for (unsigned round = 0; round < 4; ++round) {
      Source s(round);
      GraphicsSystem g;
      g.set_hidden_surfaces({.method = method});
      g.set_hidden_surfaces({.removal = true});
      set_view(g, test::any_view(s));
      enter_cut_shapes(s, g);
      DrawOptions options{.width = 64, .height = 64, .samples = 1};
      options.with_ids = true;
      EXPECT_EQ(draw(g, options).ids, truth(g.display_file(), 64, 64, false).ids)
          << name_of(method) << " " << round;
    }
  }
}

TEST(CuttingPlanes, TheTruthFromTheWorldIsOfTheSameScene) {
  for (unsigned round = 0; round < 6; ++round) {
    Source s(round);
    Retained retained;
    set_view(retained.system, test::any_parallel_view(s));
    enter_cut_shapes(s, retained.system);
    const DisplayFile& file = retained.system.display_file();
    EXPECT_LE(different_pixels(world_truth(retained.scene, file, 64, 64, false),
                               truth(file, 64, 64, false)),
              0u);
  }
}

TEST(CuttingPlanes, ARetainedSceneIsCutInEveryView) {
  Source s(3);
  const View other = test::any_view(s);
  Retained retained;
  Source again = s;
  enter_cut_shapes(s, retained.system);
  GraphicsSystem there;
  set_view(there, other);
  enter_cut_shapes(again, there);
  RetainedViews views(retained.scene, retained.system.display_file(), {});
  EXPECT_EQ(truth(views.view(other), 64, 64, false).ids,
            truth(there.display_file(), 64, 64, false).ids);
}

TEST(CuttingPlanes, NormalsRunAlongCutEdges) {
  CuttingPlanes planes;
  planes.set(1, -1, 0, 0, 0.25);
  const std::array triangle{Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0)};
  const std::array normals{Point3(0, 0, 2), Point3(5, 0, 0), Point3(0, 0, 1)};
  const CutPolygon cut = planes.cut(triangle, {}, normals);
  ASSERT_EQ(cut.vertices.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const bool is_cut = cut.vertices[k].x == 0.25;
    EXPECT_EQ(cut.normals[k], is_cut ? Point3(0.25, 0, 0.75) : Point3(0, 0, 1));
  }
  GraphicsSystem g;
  g.set_light({1, 0, 1});
  g.set_shading(Shading::phong);
  g.set_cutting_plane(1, -1, 0, 0, 0.25);
  g.open_segment(1);
  g.set_vertex_normals(normals);
  g.polygon_abs_3(triangle);
  g.close_segment();
  const std::string text = dump(g.display_file());
  EXPECT_NE(text.find("normals"), std::string::npos);
  EXPECT_EQ(text.find("polygon 4"), std::string::npos);  // two triangles
}

TEST(CuttingPlanes, RecordedAndReplayedTheyCutTheSame) {
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  Source s(8);
  enter_cut_shapes(s, g);
  GraphicsSystem again;
  replay(program.str(), "recorded", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  EXPECT_NE(program.str().find("set-cutting-plane 1 off\n"), std::string::npos);
}

TEST(CuttingPlanes, WhatIsNoPlaneIsRefusedAndTheOldOneStays) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  GraphicsSystem g;
  g.set_cutting_plane(6, 1, 0, 0, 0);
  for (const int n : {0, 7, -1}) {
    expect_error([&] { g.set_cutting_plane(n, 1, 0, 0, 0); }, "expected 1 to 6");
    expect_error([&] { g.set_cutting_plane_off(n); }, "expected 1 to 6");
  }
  expect_error([&] { g.set_cutting_plane(6, 0, 0, 0, 1); },
               "cutting plane 0 0 0 1: its normal is zero");
  expect_error([&] { g.set_cutting_plane(6, kNone, 0, 1, 1); }, "expected finite numbers");
  expect_error([&] { g.set_cutting_plane(6, 1, 0, 1, 1e101); }, "expected finite numbers");
  expect_error([&] { g.set_cutting_plane(6, 1e-300, 0, 0, 1); }, "too far from the origin");
  EXPECT_TRUE(SystemInside::cutting_planes(g).is_on(6));
  EXPECT_EQ(SystemInside::cutting_planes(g).outcode({-1, 0, 0}), 32u);
  g.set_cutting_plane(6, 1e-300, 0, 0, 1e-300);
  EXPECT_EQ(SystemInside::cutting_planes(g).outcode({-1, 0, 0}), 0u);
  EXPECT_EQ(SystemInside::cutting_planes(g).outcode({-1.5, 0, 0}), 32u);
  const auto error_of_program = [](const std::string& program) {
    GraphicsSystem of_program;
    return test::error_of([&] { replay(program, "p", of_program); });
  };
  EXPECT_NE(error_of_program("set-cutting-plane 1 on\n").find("p:1:21: expected off, or four"),
            std::string::npos);
  EXPECT_NE(
      error_of_program("set-cutting-plane 1 0 1 0\n").find("4 arguments, expected 5: n a b c d"),
      std::string::npos);
}

}  // namespace
}  // namespace displayfile
