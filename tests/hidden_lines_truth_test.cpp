// Every method that finds lines against their truth (tests/line_truth.h), on scenes as applications
// enter them.

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "tests/entered_scenes.h"
#include "tests/gallery.h"
#include "tests/line_truth.h"
#include "tests/predicate_inputs.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

TEST(HiddenLinesTruth, OfGeneratedScenes) {
  test::expect_right_generated_scenes(
      [](const DisplayFile& file) { return test::wrong_lines(file); });
}

TEST(HiddenLinesTruth, OfHardCases) {
  test::expect_right_hard_cases([](const DisplayFile& file) { return test::wrong_lines(file); });
}

/// Points on a coarse grid, so that lines meet corners, lie in planes and behind edges; polygons
/// that cross themselves, are concave, edge-on or hollow; lines.
DisplayFile degenerate(std::uint32_t seed) {
  test::Dice dice(seed);
  DisplayFile file;
  Segment& segment = file.create(1);
  const int grid = dice.from(2, 5), depths = dice.from(1, 3);
  const auto point = [&] {
    return Point3(dice.from(0, grid) / 8.0, dice.from(0, grid) / 8.0, dice.from(0, depths) / 4.0);
  };
  const int items = dice.from(2, 9);
  for (int k = 0; k < items; ++k) {
    segment.set_pick(k);
    if (dice.one_in(5)) {
      segment.enter_line(point(), point());
      continue;
    }
    segment.set_style(dice.one_in(6) ? FillStyle{FillStyle::Kind::hollow} : FillStyle{});
    test::Vertices polygon(static_cast<std::size_t>(dice.from(3, 6)));
    const double z = dice.from(0, depths) / 4.0, dz_dx = dice.from(-1, 1) / 2.0,
                 dz_dy = dice.from(-1, 1) / 2.0;
    const bool flat = polygon.size() > 3 || dice.one_in(2);
    for (Point3& p : polygon) {
      p = point();
      if (flat) p.z = z + dz_dx * p.x + dz_dy * p.y;
    }
    test::enter(segment, polygon);
  }
  return file;
}

TEST(HiddenLinesTruth, OfRandomDegenerateScenes) {
  constexpr std::uint32_t kScenes = 20000 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_EQ(test::wrong_lines(degenerate(seed), 1), "");
  }
}

/// Small triangles in planes that are seen nearly from the edge, and lines that pass them with an
/// end within reach of such a plane, at the triangle's depth, before it or behind it.
void enter_beside_steep_planes(GraphicsSystem& g, std::uint32_t seed) {
  test::Source s(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * s.unit(); };
  const double reach = std::pow(10.0, between(-6, -3));
  g.set_hidden_surfaces({.touching = Touching{Touching::Kind::length, reach}});
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 0);
  g.open_segment(1);
  for (int k = 0; k < 60; ++k) {
    const Point3 middle(between(0.2, 0.8), between(0.2, 0.8), between(-0.6, -0.4));
    const double x_per_depth = reach * std::pow(10.0, between(0, 3));
    const double deep = std::pow(10.0, between(-3, -0.5)), wide = x_per_depth * deep;
    const double high = wide * std::pow(10.0, between(-0.5, 1.5));
    const auto on_plane = [&](double y, double z) {
      return Point3(middle.x + x_per_depth * (z - middle.z), middle.y + y, z);
    };
    std::array<Point3, 3> steep, beside;
    for (Point3& p : steep) {
      const double y = between(-high, high), z = between(-deep, deep);
      p = on_plane(y, middle.z + z);
    }
    const double along = wide * std::pow(10.0, between(0, 1.5));
    const double end = middle.z + between(-1, 1) * deep * (s.below(2) == 0 ? 1.0 : 5.0);
    beside[0] = on_plane(between(-along, along), end) + Point3(between(-reach, reach), 0, 0);
    for (Point3& p : std::span(beside).subspan(1)) {
      const double x = between(-along, along), y = between(-along, along);
      const double z = between(-1, 1) * deep * std::pow(10.0, s.between(-2, 0));
      p = Point3(middle.x + x, middle.y + y, end + z);
    }
    g.polygon_abs_3(steep);
    g.polygon_abs_3(beside);
  }
  g.close_segment();
}

TEST(HiddenLinesTruth, OfEndsWithinReachOfSteepPlanes) {
  constexpr std::uint32_t kScenes = 90 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
    SCOPED_TRACE(seed);
    GraphicsSystem system;
    enter_beside_steep_planes(system, seed);
    ASSERT_EQ(test::wrong_lines(system.display_file(), 1), "");
  }
}

/// A table whose legs touch its top, with its sides along the axes. All coordinates and the eye's
/// are whole tenths, so that some edges lie exactly behind others, except for rounding.
void enter_table(GraphicsSystem& g, std::uint32_t seed) {
  test::Dice dice(seed);
  const auto tenths = [&](int low, int high) { return dice.from(low, high) / 10.0; };
  g.set_view_plane_normal({tenths(-60, -40), tenths(-60, -10), tenths(-70, -50)});
  g.set_perspective({tenths(60, 80), tenths(20, 70), tenths(70, 90)});
  g.set_window(-3.2, 3.2, -2.4, 2.4);
  g.open_segment(1);
  const double left = tenths(5, 15), right = tenths(20, 30), near = tenths(20, 25);
  constexpr double kFar = 1.2, kUnder = 0.7;
  box_3(g, {left, kUnder, kFar}, {right, kUnder + 0.06, near});
  for (const double x : {left, right - 0.1}) {
    for (const double z : {kFar, near - 0.1}) {
      if (!dice.one_in(4)) box_3(g, {x, 0, z}, {x + 0.1, kUnder, z + 0.1});
    }
  }
  g.close_segment();
}

TEST(HiddenLinesTruth, OfTablesWhoseEdgesLieBehindOthers) {
  constexpr std::uint32_t kScenes = 1000 / test::kSlower;
  for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
    SCOPED_TRACE(seed);
    GraphicsSystem system;
    enter_table(system, seed);
    ASSERT_EQ(test::wrong_lines(system.display_file(), 1), "");
  }
}

TEST(HiddenLinesTruth, WithRoundoffSomeAreWrong) {
  int wrong = 0, wrong_at_points = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const DisplayFile file = degenerate(seed);
    const SurfacePlan judged{.method = HiddenMethod::franklin,
                             .precision = {.exact = false, .roundoff = 0.3}};
    const JudgedLines whole = judged_lines(file, judged);
    const JudgedLines at_points = judged_lines(file, judged, 1000);
    EXPECT_EQ(at_points.lines, whole.lines);
    EXPECT_TRUE(at_points.lines == 0 || at_points.samples > 500);
    EXPECT_NEAR(at_points.errors.missing, whole.errors.missing, 0.1);
    EXPECT_NEAR(at_points.errors.extra, whole.errors.extra, 0.1);
    wrong += whole.are_right() ? 0 : 1;
    wrong_at_points += at_points.are_right() ? 0 : 1;
  }
  EXPECT_GT(wrong, 10);
  EXPECT_GT(wrong_at_points, 10);
}

/// The oracle's drawing of lines is that of a method that is right, instruction by instruction:
/// groups of segments, image transformations, styles, pick identifiers, texts.
/// Word by word, numbers within rounding: where a polygon touches another at a vertex, the truth
/// may have an end one unit of the last place beside it.
void expect_nearly_equal(const std::string& a, const std::string& b) {
  std::istringstream words_a(a), words_b(b);
  std::string word_a, word_b;
  while (words_a >> word_a) {
    ASSERT_TRUE(words_b >> word_b) << word_a;
    if (word_a == word_b) continue;
    for (const std::string& word : {word_a, word_b}) {
      ASSERT_TRUE(std::isdigit(static_cast<unsigned char>(word.back())) != 0)
          << word_a << " " << word_b;
    }
    ASSERT_NEAR(std::strtod(word_a.c_str(), nullptr), std::strtod(word_b.c_str(), nullptr), 1e-14)
        << word_a << " " << word_b;
  }
  EXPECT_FALSE(words_b >> word_b) << word_b;
}

TEST(HiddenLinesTruth, IsTheSameDrawing) {
  const HiddenSurfaceOptions options{.method = HiddenMethod::franklin,
                                     .scope = HiddenScope::all,
                                     .hidden_lines = HiddenLines::none};
  int lines = 0;
  test::for_each_in_gallery([&](const std::string&, const test::Retained& retained) {
    // The truth of intersections is apart (true_intersections).
    if (contains(retained.system.hidden_surfaces().lines.kinds, LineKind::intersection)) return;
    const DisplayFile truth = true_line_drawing(retained.system.display_file(), 2);
    SortedDisplayFile sorted;
    expect_nearly_equal(dump(truth),
                        dump(sorted.update(retained.system, HiddenMethod::franklin, options)));
    lines += truth.sorted()->counts.pieces > 0 ? 1 : 0;
    EXPECT_TRUE(judged_lines(retained.system.display_file(), {.method = HiddenMethod::roberts})
                    .are_right());
  });
  EXPECT_GE(lines, 12);
}

}  // namespace
}  // namespace displayfile
