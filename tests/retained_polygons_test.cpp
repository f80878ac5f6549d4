// Polygons as they were entered are in the display file and in a retained scene: once, and the same
// whatever happens to either.

#include "displayfile/entered/retained_polygons.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {
namespace {

using Triangle = std::array<Point3, 3>;

Triangle triangle(double x) { return {{{x, 0.1, 0.2}, {x + 0.1, 0.3, 0.1}, {x, 0.7, 0.6}}}; }

void enter_triangles(GraphicsSystem& g, int name, int count) {
  g.open_segment(name);
  for (int i = 0; i < count; ++i) g.polygon_abs_3(triangle(0.01 * name + 0.001 * i));
  g.close_segment();
}

const EnteredPolygons& kept(const DisplayFile& display_file, int name) {
  return *display_file.segment(name).entered()->as_entered();
}

void expect_triangles(const DisplayFile& display_file, int name, int count) {
  SCOPED_TRACE(name);
  const EnteredPolygons& polygons = kept(display_file, name);
  ASSERT_EQ(polygons.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Triangle expected = triangle(0.01 * name + 0.001 * i);
    const PointRow found = polygons.points(static_cast<std::size_t>(i));
    EXPECT_EQ(std::vector(found.begin(), found.end()),
              std::vector(expected.begin(), expected.end()));
  }
}

TEST(GrowingArrays, PartsStayWhateverBecomesOfTheArray) {
  GrowingArray<int> array;
  std::vector<GrowingArray<int>::Part> parts;
  for (int i = 0; i < 100; ++i) {
    parts.push_back(array.part());
    array.push_back(i);
    if (i == 40) array.shrink_to_fit();
  }
  const GrowingArray<int> copy = array;
  array.append(std::array{7, 8});
  EXPECT_EQ(array.size(), 102u);
  EXPECT_EQ(array.back(), 8);
  EXPECT_EQ(copy.size(), 100u);
  EXPECT_NE(copy.data(), array.data());
  array = {};
  for (std::size_t n = 0; n < parts.size(); ++n) {
    ASSERT_EQ(parts[n].span().size(), n);
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(parts[n].span()[i], static_cast<int>(i));
  }
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(copy[i], static_cast<int>(i));
}

TEST(GrowingArrays, MovedFromTheyAreEmptyAndGrowAnew) {
  GrowingArray<int> array;
  array.push_back(1);
  const GrowingArray<int> other = std::move(array);
  array = {};
  EXPECT_TRUE(array.empty());
  array.push_back(2);
  EXPECT_EQ(array.back(), 2);
  EXPECT_EQ(other.back(), 1);
}

TEST(GrowingArrays, OneOfTheirOwnElementsIsAddedAsTheyGrow) {
  GrowingArray<int> array;
  array.push_back(5);
  for (int i = 0; i < 100; ++i) array.push_back(array.back());
  EXPECT_EQ(array.back(), 5);
}

class RetainedPolygonsOf : public testing::TestWithParam<bool> {
 protected:
  RetainedPolygonsOf() {
    system.retain(&scene);
    if (GetParam()) system.rotate_z_3(10.0);
  }
  RetainedScene scene;
  GraphicsSystem system;
};
INSTANTIATE_TEST_SUITE_P(, RetainedPolygonsOf, testing::Bool(),
                         [](const auto& p) { return p.param ? "Turned" : "AsDrawn"; });

TEST_P(RetainedPolygonsOf, AreKeptOnce) {
  enter_triangles(system, 1, 9);
  const EnteredPolygons& polygons = kept(system.display_file(), 1);
  EXPECT_TRUE(polygons.are_retained());
  EXPECT_LE(polygons.bytes(), 128u) << "its matrix";
  expect_triangles(system.display_file(), 1, 9);
  EXPECT_EQ(polygons.modelling(0) != nullptr, GetParam());
}

TEST_P(RetainedPolygonsOf, StayAsSegmentsComeAndGo) {
  for (int name = 1; name <= 30; ++name) enter_triangles(system, name, name);
  const DisplayFile before = system.display_file();
  for (const int name : {1, 30, 7, 8}) system.delete_segment(name);
  system.rename_segment(9, 99);
  enter_triangles(system, 31, 40);
  for (int name = 1; name <= 31; ++name) {
    if (name <= 30) expect_triangles(before, name, name);
    if (name == 31) expect_triangles(system.display_file(), name, 40);
    if (name == 9 || !system.display_file().contains(name) || name == 31) continue;
    expect_triangles(system.display_file(), name, name);
    EXPECT_TRUE(kept(system.display_file(), name).are_retained());
  }
}

/// As the scene grows it has other arrays: no segment refers to the old ones any more, which would
/// keep all polygons more than once.
TEST_P(RetainedPolygonsOf, AreInTheArraysThatTheSceneHasNow) {
  for (int name = 1; name <= 30; ++name) enter_triangles(system, name, name);
  system.delete_segment(5);
  for (const RetainedScene::Segment& part : scene.segments()) {
    const PointRow kept_points = kept(system.display_file(), part.name).points(0);
    EXPECT_EQ(kept_points.data(), scene.entered_points(part.first).data()) << part.name;
  }
}

TEST_P(RetainedPolygonsOf, OutliveTheScene) {
  std::optional<DisplayFile> display_file;
  {
    RetainedScene own;
    GraphicsSystem of_own;
    of_own.retain(&own);
    enter_triangles(of_own, 1, 9);
    display_file = of_own.display_file();
  }
  expect_triangles(*display_file, 1, 9);
}

TEST_P(RetainedPolygonsOf, MoreAreEnteredIntoACopyOfTheSegment) {
  enter_triangles(system, 1, 3);
  EnteredPolygons polygons = kept(system.display_file(), 1);
  polygons.enter(triangle(0.01 + 0.003), polygons.modelling(0));
  EXPECT_FALSE(polygons.are_retained());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(polygons.points(i).front(), triangle(0.01 + 0.001 * static_cast<double>(i))[0]);
    EXPECT_EQ(polygons.points(i).size(), 3u);
  }
  EXPECT_EQ(polygons.size(), 4u);
  expect_triangles(system.display_file(), 1, 3);
}

/// Numbers of polygons and of primitives differ where there are lines.
TEST_P(RetainedPolygonsOf, AreKeptByThemselvesAmongLines) {
  system.open_segment(1);
  system.polygon_abs_3(triangle(0.01));
  system.move_abs_3(0.0, 0.0, 0.0);
  system.line_abs_3(0.1, 0.2, 0.3);
  system.polygon_abs_3(triangle(0.011));
  system.close_segment();
  EXPECT_FALSE(kept(system.display_file(), 1).are_retained());
  expect_triangles(system.display_file(), 1, 2);
}

TEST_P(RetainedPolygonsOf, ThatShareVerticesAreKeptOnce) {
  const std::vector<Point3> vertices{
      {0.1, 0.1, 0.1}, {0.3, 0.1, 0.1}, {0.3, 0.3, 0.2}, {0.1, 0.4, 0.2}};
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 2, 3};
  enter_triangles(system, 1, 2);
  system.open_segment(2);
  system.polygons_abs_3({vertices, corners});
  system.close_segment();
  const EnteredPolygons& polygons = kept(system.display_file(), 2);
  EXPECT_TRUE(polygons.are_retained());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    EXPECT_EQ(polygons.points(k / 3)[k % 3], vertices[corners[k]]);
  }
  expect_triangles(system.display_file(), 1, 2);
}

/// Where lines are selected, a segment is viewed when it is closed, from the retained scene.
TEST(RetainedPolygons, AreThoseThatWereEnteredBesideLinesToo) {
  for (const bool with_line : {false, true}) {
    GraphicsSystem g;
    g.set_hidden_surfaces({.lines = line_selection("boundary")});
    g.open_segment(1);
    g.move_abs_3(0.1, 0.1, 0.1);
    if (with_line) g.line_abs_3(0.9, 0.8, 0.7);
    for (int i = 0; i < 3; ++i) g.polygon_abs_3(triangle(0.01 + 0.001 * i));
    g.close_segment();
    SCOPED_TRACE(with_line ? "with a line" : "without lines");
    expect_triangles(g.display_file(), 1, 3);
    EXPECT_EQ(kept(g.display_file(), 1).are_retained(), !with_line);
  }
}

}  // namespace
}  // namespace displayfile
