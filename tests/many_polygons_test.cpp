// Many polygons entered at once give the same as one call each.

#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/files.h"
#include "displayfile/user_routines/system_inside.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/scene_viewer.h"
#include "interp/draw/nothing_seen.h"
#include "tests/error_of.h"

namespace displayfile {
namespace {

using test::expect_error;

/// Vertices, corners and sides of polygons that share vertices; some cross the window's sides, and
/// some are not flat.
struct SharedPolygons {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners, sides;

  explicit SharedPolygons(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> grid(-8, 8);
    for (int i = 0; i < 40; ++i) {
      vertices.push_back(Point3(grid(random), grid(random), grid(random)) / 6.0);
    }
    for (int k = 0; k < 60; ++k) {
      sides.push_back(3 + static_cast<std::uint32_t>(random() % 3));
      for (std::uint32_t i = 0; i < sides.back(); ++i)
        corners.push_back(static_cast<std::uint32_t>(random() % 40));
    }
  }
  void enter_one_by_one(GraphicsSystem& g, std::span<const FillStyle> fills,
                        std::span<const std::int32_t> picks = {},
                        std::span<const Point3> normals = {}) const {
    std::size_t first = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (!fills.empty()) g.set_fill_style(fills[fills.size() == 1 ? 0 : k]);
      if (!picks.empty()) g.set_pick_id(picks[k]);
      std::vector<Point3> polygon, of_corners;
      for (std::size_t i = 0; i < sides[k]; ++i, ++first) {
        polygon.push_back(vertices[corners[first]]);
        if (!normals.empty()) of_corners.push_back(normals[corners[first]]);
      }
      g.set_vertex_normals(of_corners);
      g.polygon_abs_3(polygon);
    }
  }
};

TEST(ManyPolygons, AreEnteredAsOneByOne) {
  for (std::uint32_t seed = 0; seed < 32; ++seed) {
    const SharedPolygons polygons(seed);
    std::vector<FillStyle> fills;
    for (std::size_t k = 0; k < polygons.sides.size(); ++k) {
      fills.push_back(
          k % 7 == 0 ? FillStyle{FillStyle::Kind::hollow}
                     : FillStyle{FillStyle::Kind::solid, Colour(static_cast<double>(k % 5) / 4.0)});
    }
    if (seed % 3 == 1) fills.resize(1);
    if (seed % 3 == 2) fills.clear();
    std::string dumps[2], programs[2];
    for (const bool at_once : {false, true}) {
      std::ostringstream program;
      Recorder recorder(program);
      RetainedScene retained;
      GraphicsSystem g;
      if (seed % 2 == 0) g.set_perspective({0.5, 0.25, 3});
      if (seed % 4 < 2) g.set_light({1, 2, 3});
      if (seed % 8 == 3) g.retain(&retained);
      g.set_back_face_removal(seed % 5 == 0);
      g.rotate_y_3(10.0 * seed);
      g.open_segment(1);
      if (at_once) g.set_recorder(&recorder);
      if (at_once) {
        g.polygons_abs_3({polygons.vertices, polygons.corners, polygons.sides, fills});
      } else {
        polygons.enter_one_by_one(g, fills);
        if (!fills.empty()) g.set_fill_style({});
      }
      g.line_rel_3(0.1, 0.2, 0.3);
      g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
      g.close_segment();
      dumps[at_once] = dump(g.display_file());
      if (seed % 8 == 3) {
        dumps[at_once] += dump(RetainedViews(retained, g.display_file(), {}).view(g.view()));
      }
    }
    EXPECT_EQ(dumps[0], dumps[1]) << "seed " << seed;
  }
}

/// With pick identifiers and normals of their own they equal those entered by single calls.
TEST(ManyPolygons, HavePicksAndNormalsOfTheirOwn) {
  for (std::uint32_t seed = 0; seed < 32; ++seed) {
    const SharedPolygons polygons(seed);
    std::vector<std::int32_t> picks;
    std::vector<Point3> normals;
    for (std::size_t k = 0; k < polygons.sides.size(); ++k) {
      picks.push_back(static_cast<std::int32_t>(k * k % 17));
    }
    for (const Point3& p : polygons.vertices) normals.push_back(p + Point3(0, 0, 0.5));
    if (seed % 3 == 1) picks.clear();
    if (seed % 3 == 2) normals.clear();
    std::string dumps[2], programs[2];
    for (const bool at_once : {false, true}) {
      std::ostringstream program;
      Recorder recorder(program);
      RetainedScene retained;
      GraphicsSystem g;
      if (seed % 4 < 2) g.retain(&retained);
      if (seed % 8 == 7) g.set_recorder(&recorder);
      g.set_light({1, 2, 3});
      g.set_shading(seed % 2 == 0 ? Shading::gouraud : Shading::phong);
      if (seed % 5 == 3) g.set_cutting_plane(1, 1, 0, 0, 0.1);
      g.set_pick_id(5);
      g.open_segment(1);
      if (at_once) {
        g.polygons_abs_3({polygons.vertices, polygons.corners, polygons.sides, {}, picks, normals});
      } else {
        polygons.enter_one_by_one(g, {}, picks, normals);
        g.set_pick_id(5);
      }
      g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
      g.close_segment();
      g.set_recorder(nullptr);
      dumps[at_once] = dump(g.display_file());
      if (seed % 4 < 2) {
        dumps[at_once] += dump(RetainedViews(retained, g.display_file(), {}).view(g.view()));
      }
      if (seed % 8 != 7) continue;
      GraphicsSystem replayed;
      replay(program.view(), "record", replayed);
      EXPECT_EQ(dump(replayed.display_file()), dump(g.display_file()));
    }
    EXPECT_EQ(dumps[0], dumps[1]) << "seed " << seed;
  }
}

/// The text of a view of a scene that is retained alone, or beside a display file.
std::string retained_view(std::uint32_t seed, bool alone, bool triangles) {
  SharedPolygons polygons(seed);
  if (triangles) {
    polygons.sides.clear();
    polygons.corners.resize(polygons.corners.size() / 3 * 3);
  }
  RetainedScene scene;
  GraphicsSystem g;
  alone ? SystemInside::retain_alone(g, scene) : g.retain(&scene);
  EXPECT_EQ(SystemInside::retains_alone(g), alone);
  if (seed % 2 == 0) g.set_perspective({0.5, 0.25, 3});
  if (seed % 4 < 2) g.set_light({1, 2, 3});
  if (seed % 5 == 1) g.set_pick_id(7);
  if (seed % 5 == 2) g.set_shading(seed % 2 == 0 ? Shading::gouraud : Shading::phong);
  g.set_back_face_removal(seed % 3 == 0);
  g.rotate_y_3(10.0 * seed);
  for (const int name : {1, 2}) {
    g.open_segment(name);
    if (name == 2 || seed % 7 != 3) g.line_rel_3(0.1, 0.2, 0.3);
    const FillStyle fill{FillStyle::Kind::solid, Colour(0.25 * name)};
    g.polygons_abs_3({polygons.vertices, polygons.corners, polygons.sides, std::span(&fill, 1)});
    g.text("a word");
    g.set_vertex_normals({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}});
    g.polygon_abs_3({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
    g.close_segment();
  }
  EXPECT_EQ(g.looks().attributes.fill, FillStyle{});
  const std::string view = dump(SceneViewer(scene, g.display_file()).display_file(g.view()));
  if (!alone) {
    EXPECT_EQ(view, dump(g.display_file()));
    EXPECT_EQ(nothing_is_seen(scene, g.display_file()), nothing_is_seen(g.display_file()));
  } else {
    EXPECT_EQ(g.display_file().polygons(), 0u);
    EXPECT_TRUE(nothing_is_seen(g.display_file()));
  }
  return view + std::to_string(g.counts().polygons);
}

TEST(ManyPolygons, RetainedAloneAreSeenAsThoseOfADisplayFile) {
  for (std::uint32_t seed = 0; seed < 32; ++seed) {
    for (const bool triangles : {false, true}) {
      EXPECT_EQ(retained_view(seed, true, triangles), retained_view(seed, false, triangles))
          << "seed " << seed;
    }
  }
}

TEST(ManyPolygons, AreNotRetainedAloneAfterOthers) {
  RetainedScene scene;
  GraphicsSystem g;
  g.open_segment(1);
  g.close_segment();
  EXPECT_THROW(SystemInside::retain_alone(g, scene), Error);
  EXPECT_FALSE(SystemInside::retains_alone(g));
  GraphicsSystem other;
  SystemInside::retain_alone(other, scene);
  other.retain(nullptr);
  EXPECT_FALSE(SystemInside::retains_alone(other));
}

/// Two segments of polygons with shared vertices, one with own, and a line in each; retained.
struct RetainedPolygons {
  RetainedScene scene;
  GraphicsSystem system;

  explicit RetainedPolygons(bool at_once) {
    system.retain(&scene);
    system.set_light({1, 2, 3});
    for (const int name : {3, 1, 2}) {
      const SharedPolygons polygons(static_cast<std::uint32_t>(name));
      system.open_segment(name);
      system.line_rel_3(0.1, 0.2, 0.3);
      if (at_once && name != 1) {
        system.polygons_abs_3({polygons.vertices, polygons.corners, polygons.sides});
      } else {
        polygons.enter_one_by_one(system, {});
      }
      system.line_rel_3(-0.1, 0.1, 0.1);
      system.close_segment();
    }
  }
  std::string views() const {
    RetainedViews drawn(scene, system.display_file(), {});
    std::string text;
    View view = system.view();
    for (const Point3& eye : {Point3(0.5, 0.25, 3), Point3(-2, 1, 2), Point3(0, 0.5, 4)}) {
      view.set_perspective(eye);
      text += dump(drawn.view(view));
    }
    return text;
  }
};

TEST(ManyPolygons, AreRetainedWithTheirVerticesShared) {
  RetainedPolygons shared(true), own(false);
  const auto points = [](const RetainedPolygons& of, std::size_t segment) {
    return of.scene.points(of.scene.segments()[segment]).size();
  };
  EXPECT_LT(points(shared, 0), points(own, 0));
  EXPECT_EQ(points(shared, 1), points(own, 1));
  EXPECT_LT(points(shared, 2), points(own, 2));
  EXPECT_EQ(shared.views(), own.views());
  for (RetainedPolygons* of : {&shared, &own}) {
    of->system.delete_segment(3);
    of->system.set_visibility(1, false);
  }
  EXPECT_LT(points(shared, 1), points(own, 1));
  EXPECT_EQ(shared.views(), own.views());
}

TEST(ManyPolygons, OnlyVerticesInUseAreRetained) {
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  g.open_segment(1);
  const std::vector<Point3> vertices{{9, 9, 9}, {0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {-9, 9, 9}};
  g.polygons_abs_3({vertices, std::vector<std::uint32_t>{3, 1, 2, 2, 3, 1}});
  g.close_segment();
  const auto kept = scene.points(scene.segments()[0]);
  EXPECT_EQ(std::vector<Point3>(kept.begin(), kept.end()),
            (std::vector<Point3>{vertices[3], vertices[1], vertices[2]}));
}

TEST(ManyPolygons, ErrorsEnterNothing) {
  GraphicsSystem g;
  g.set_viewport(0, 1, 0, 1);
  const std::vector<Point3> vertices{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
  using Indices = std::vector<std::uint32_t>;
  const Indices corners{0, 1, 2, 1, 2, 3};
  expect_error([&] { g.polygons_abs_3({vertices, corners}); }, "no segment open");
  g.open_segment(1);
  expect_error(
      [&] {
        g.polygons_abs_3({vertices, Indices{0, 1, 2, 3, 0, 4}});
      },
      "corner 5: vertex 4: there are 4 vertices: expected 0 to 3");
  expect_error([&] { g.polygons_abs_3({vertices, Indices{0, 1}}); }, "2 corners");
  expect_error([&] { g.polygons_abs_3({vertices, corners, Indices{4, 2}}); }, "polygon of 2 sides");
  expect_error(
      [&] {
        g.polygons_abs_3({vertices, corners, Indices{3, 4}});
      },
      "6 corners: expected 7");
  const std::vector<FillStyle> three(3), outside{FillStyle{FillStyle::Kind::solid, {2, 0, 0}}};
  expect_error([&] { g.polygons_abs_3({vertices, corners, {}, three}); }, "3 fill styles");
  expect_error([&] { g.polygons_abs_3({vertices, corners, {}, outside}); }, "colour component");
  std::vector<Point3> far = vertices;
  far.back().x = std::numeric_limits<double>::infinity();
  expect_error([&] { g.polygons_abs_3({far, corners}); }, "coordinates inf");
  g.set_pick_id(8);
  const auto many = [&](std::vector<std::int32_t> picks, std::vector<Point3> normals,
                        const std::vector<Point3>& points) {
    g.polygons_abs_3({points, corners, {}, {}, picks, normals});
  };
  const std::vector<Point3> up(4, Point3(0, 0, 1));
  expect_error([&] { many({1}, {}, vertices); }, "1 pick identifiers of 2 polygons");
  expect_error([&] { many({1, -1}, {}, vertices); }, "pick identifier -1");
  expect_error([&] { many({}, {{0, 0, 1}}, vertices); }, "1 normals of 4 vertices");
  expect_error([&] { many({}, far, vertices); }, "vertex normal");
  expect_error([&] { many({1, 2}, up, far); }, "coordinates inf");
  expect_error([&] { many({1, 2}, {}, far); }, "coordinates inf");
  g.set_pick_id(-1);
  EXPECT_EQ(g.display_file().polygons(), 0u);
  EXPECT_EQ(g.counts().polygons, 0);
  g.polygons_abs_3({vertices, corners});
  EXPECT_EQ(g.display_file().polygons(), 2u);
  g.polygons_abs_3({{}, {}});
  EXPECT_EQ(g.display_file().polygons(), 2u);
}

/// After the largest pick identifier, in whatever way polygons are entered.
TEST(ManyPolygons, OrdinalsBeginAtZeroAgain) {
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  static_assert(pick_of_ordinal(0) == 0 && pick_of_ordinal(kLargest) == kLargest);
  static_assert(pick_of_ordinal(kLargest + std::int64_t{1}) == 0);
  static_assert(pick_of_ordinal((std::int64_t{1} << 40) + 7) == 7);
  const std::vector<Point3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 1, 2, 0, 1, 2};
  RetainedScene scene;
  scene.open_segment(1, View());
  scene.begin_shared(vertices.size());
  scene.enter_shared_triangles({.world = vertices}, corners, Attributes(), kLargest - 1, 1);
  scene.enter_shared_triangles({.world = vertices}, corners, Attributes(), kLargest, 0);
  ASSERT_EQ(scene.size(), 6u);
  EXPECT_EQ(scene[0].pick, kLargest - 1);
  EXPECT_EQ(scene[1].pick, kLargest);
  EXPECT_EQ(scene[2].pick, 0);
  for (std::uint32_t i = 3; i < 6; ++i) EXPECT_EQ(scene[i].pick, kLargest);
  GraphicsSystem g;
  g.open_segment(1);
  g.polygons_abs_3({vertices, corners, {}, {}, std::vector{kLargest - 1, kLargest, 0}, {}});
  const std::string text = dump(g.display_file());
  for (const std::int32_t pick : {kLargest - 1, kLargest, 0}) {
    EXPECT_NE(text.find("pick " + std::to_string(pick) + "\n"), text.npos) << text;
  }
}

}  // namespace
}  // namespace displayfile
