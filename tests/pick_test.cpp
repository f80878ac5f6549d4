// Picking, and pictures drawn one after another, as an application uses them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "interp/draw/renderer.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/line_picker.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/random_scenes.h"
#include "tests/slower.h"
#include "tests/temporary_folder.h"
#include "tests/truth_scenes.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

using test::unit_square;
using test::unit_square_without_lines;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Polygons ------------------------------------------------------------------------------

/// Every pixel of a picture picked, against the item buffer of the truth.
void expect_picks_of_the_truth(const GraphicsSystem& system, int width, int height) {
  const DrawOptions options{.width = width, .height = height, .samples = 1};
  const Picture right = truth_as_entered(system.display_file(), width, height, true);
  Renderer renderer;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto k = static_cast<std::size_t>(y * width + x);
      const auto pick = renderer.pick(system, x + 0.25, y + 0.75, options);
      ASSERT_EQ(pick ? pick->id : -1, right.ids[k]) << x << ", " << y;
      if (!pick) continue;
      ASSERT_EQ(pick->kind, Pick::Kind::polygon);
      ASSERT_NEAR(pick->depth, right.depth[k], 1e-12 * (1.0 + std::abs(right.depth[k])));
      ASSERT_TRUE(system.display_file().contains(pick->segment));
    }
  }
}

TEST(Picking, IsTheTruthsItemBufferOnTheHardCases) {
  for (const HardCase& family : hard_cases()) {
    const std::size_t all = test::kSlower > 1 ? 1 : family.severities.size();
    for (std::size_t s = 0; s < all; ++s) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(family.severities[s]));
      const Scene scene = family.make(family.size, family.severities[s], 1);
      const int size = s % 2 == 0 ? 32 : 21;
      ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_truth(entered(scene), size, size + 5));
    }
  }
}

TEST(Picking, IsTheTruthsItemBufferOnRandomScenes) {
  for (std::uint64_t seed = 0; seed < 300 / test::kSlower; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(
        expect_picks_of_the_truth(entered(random_degenerate_scene(seed)), 32, 32));
  }
  for (const GeneratedScene& scene : generated_scenes()) {
    SCOPED_TRACE(scene.name);
    ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_truth(entered(scene.make(300, 1)), 61, 47));
  }
}

TEST(Picking, NamesSegmentIdentifierAndDepth) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(7);
  g.polygon_abs_3({{0, 0, 0.25}, {0.5, 0, 0.25}, {0.5, 1, 0.25}, {0, 1, 0.25}});
  g.close_segment();
  g.set_pick_id(41);
  g.open_segment(9);
  g.polygon_abs_3({{0.25, 0.5, -0.5}, {1, 0.5, -0.5}, {1, 1, -0.5}, {0.25, 1, -0.5}});
  g.close_segment();
  const DrawOptions options{.width = 100, .height = 50, .samples = 1};
  Renderer renderer;
  const auto at = [&](double x, double y) { return renderer.pick(g, x, y, options); };
  const DrawOptions with_all{
      .width = 100, .height = 50, .samples = 1, .with_ids = true, .with_depth = true};
  const Picture picture = renderer.draw(g, with_all);
  const auto upper_left = at(10, 10);
  ASSERT_TRUE(upper_left);
  EXPECT_EQ(upper_left->segment, 7);
  EXPECT_EQ(upper_left->id, 0);
  EXPECT_EQ(upper_left->depth, picture.depth[10 * 100 + 10]);
  EXPECT_FALSE(upper_left->world);
  EXPECT_EQ(at(75, 10)->segment, 9);  // y down: the upper half
  EXPECT_EQ(at(75, 10)->id, 41);
  EXPECT_FALSE(at(75, 40));
  EXPECT_EQ(at(49.999, 30)->id, 0);
  EXPECT_FALSE(at(50, 30));  // a right edge is not covered
  for (const Point2& p :
       {Point2(-0.001, 5), Point2(100, 5), Point2(5, -1), Point2(5, 50), Point2(1e300, 5)}) {
    EXPECT_FALSE(at(p.x, p.y)) << p.x << " " << p.y;
  }
  EXPECT_TRUE(at(0, 0));
  EXPECT_TRUE(at(99.999, 0));

  // A change of the display file changes the pick.
  g.set_visibility(7, false);
  EXPECT_FALSE(at(10, 10));
  g.set_image_translation(9, -0.25, 0);
  EXPECT_EQ(at(5, 10)->segment, 9);
  g.rename_segment(9, 4);
  EXPECT_EQ(at(5, 10)->segment, 4);
  g.open_segment(10);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(at(5, 40)->segment, 10);  // still open
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(at(95, 40)->segment, 10);
  g.close_segment();
  g.delete_all_segments();
  EXPECT_FALSE(at(5, 10));
}

TEST(Picking, RefusesWhatIsNoPlaceNoReachAndNoSize) {
  GraphicsSystem g = unit_square();
  Renderer renderer;
  for (const double wrong : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_THROW(renderer.pick(g, wrong, 1), Error);
    EXPECT_THROW(renderer.pick(g, 1, wrong), Error);
  }
  for (const double reach : {kNaN, kInfinity, -1e-9, 65536.0}) {
    EXPECT_THROW(renderer.pick(g, 1, 1, {}, reach), Error);
  }
  EXPECT_THROW(renderer.pick(g, 1, 1, {.width = 0}), Error);
  EXPECT_THROW(renderer.pick(g, 1, 1, {.height = 65536}), Error);
  EXPECT_FALSE(renderer.pick(g, 1, 1, {}, 65535.0));
}

// ---- Lines ---------------------------------------------------------------------------------

const DrawOptions kHundred{.width = 100, .height = 100, .samples = 1};

TEST(PickingLines, WithinAReach) {
  GraphicsSystem g = unit_square();
  g.set_pick_id(5);
  g.open_segment(1);
  g.move_abs_3(0.1, 0.505, 0);
  g.line_abs_3(0.9, 0.505, 0);  // through the centres of row 49 from the top
  g.close_segment();
  g.set_pick_id(-1);
  g.set_line_style({LineStyle::Kind::solid, {1, 0, 0}, 20.0});
  g.open_segment(2);
  g.move_abs_3(0.1, 0.205, 0);
  g.line_abs_3(0.9, 0.205, -1);
  g.close_segment();
  Renderer renderer;
  const auto at = [&](double x, double y, double reach) {
    return renderer.pick(g, x, y, kHundred, reach);
  };
  ASSERT_TRUE(at(50, 49, 0.5));
  EXPECT_EQ(at(50, 49, 0.5)->kind, Pick::Kind::line);
  EXPECT_EQ(at(50, 49, 0.5)->id, 5);
  EXPECT_EQ(at(50, 49, 0.5)->segment, 1);
  EXPECT_FALSE(at(50, 49, 0));  // as in an item buffer
  EXPECT_TRUE(at(50, 46.5, 3));
  EXPECT_FALSE(at(50, 45.5, 3));
  EXPECT_TRUE(at(8.5, 49.5, 2));  // beyond the end
  EXPECT_FALSE(at(7.5, 49.5, 2));
  const auto wide = at(50.5, 71.5, 1);  // within half of its width
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->segment, 2);
  EXPECT_EQ(wide->id, -1);
  EXPECT_NEAR(wide->depth, -0.405 / 0.8, 1e-12);
  EXPECT_EQ(at(50, 65.5, 40)->segment, 2);  // the nearer of two
  EXPECT_EQ(at(50, 63.5, 40)->segment, 1);
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(3);
  g.move_abs_3(0, 0.9, 0);
  g.line_abs_3(1, 0.9, 0);
  g.polygon_abs_3({{0, 0.7, 0}, {1, 0.7, 0}, {0, 0.8, 0}});
  g.close_segment();
  EXPECT_FALSE(at(50, 10, 5));  // a polygon that is not drawn
  EXPECT_EQ(at(2, 25, 5)->kind, Pick::Kind::polygon);
}

/// The line's depth decides: behind, at equal depth, on an outline, and right behind an edge that
/// two polygons share.
TEST(PickingLines, WhereTheyAreSeen) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0.2, 0.2, -0.5}, {0.5, 0.2, -0.5}, {0.5, 0.8, -0.5}, {0.2, 0.8, -0.5}});
  g.polygon_abs_3({{0.5, 0.2, -0.5}, {0.8, 0.2, -0.5}, {0.8, 0.8, -0.5}, {0.5, 0.8, -0.5}});
  g.close_segment();
  g.set_line_style({});
  const auto is_seen = [&](const Point3& from, const Point3& to, double x, double y) {
    g.open_segment(2);
    g.move_abs_3(from.x, from.y, from.z);
    g.line_abs_3(to.x, to.y, to.z);
    g.close_segment();
    Renderer renderer;
    const auto pick = renderer.pick(g, x, y, kHundred, 1);
    g.delete_segment(2);
    return pick && pick->kind == Pick::Kind::line;
  };
  EXPECT_FALSE(is_seen({0.3, 0.1, -0.6}, {0.3, 0.9, -0.6}, 30, 50));  // behind
  EXPECT_TRUE(is_seen({0.3, 0.1, -0.6}, {0.3, 0.9, -0.6}, 30, 15));   // beside it
  EXPECT_TRUE(is_seen({0.3, 0.1, -0.5}, {0.3, 0.9, -0.5}, 30, 50));   // in it
  EXPECT_TRUE(is_seen({0.3, 0.1, -0.4}, {0.3, 0.9, -0.4}, 30, 50));
  EXPECT_TRUE(is_seen({0.2, 0.1, -0.6}, {0.2, 0.9, -0.6}, 20, 50));  // behind the outline
  EXPECT_TRUE(is_seen({0.8, 0.1, -0.6}, {0.8, 0.9, -0.6}, 80, 50));
  EXPECT_TRUE(is_seen({0.1, 0.8, -0.6}, {0.9, 0.8, -0.6}, 30, 20));
  EXPECT_FALSE(is_seen({0.5, 0.1, -0.6}, {0.5, 0.9, -0.6}, 50, 50));  // behind the common edge
  EXPECT_TRUE(is_seen({0.5, 0.1, -0.6}, {0.5, 0.9, -0.6}, 50, 15));
  EXPECT_TRUE(is_seen({0.3, 0.5, -0.3}, {0.7, 0.5, -0.7}, 45, 49));  // through both
  EXPECT_FALSE(is_seen({0.3, 0.5, -0.3}, {0.7, 0.5, -0.7}, 55, 49));
  EXPECT_FALSE(is_seen({0.3, 0.5, -0.3}, {0.3, 0.5, 0}, 30, 49));  // end-on
}

/// The place touches the line, or is as far from it as it reaches, at the very end.
TEST(PickingLines, EndsOfHiddenOnesAreHidden) {
  GraphicsSystem g;
  g.set_window(0, 16, 0, 16);
  g.open_segment(1);
  g.move_abs_3(4, 8.5, 0);
  g.line_abs_3(10, 8.5, 0);
  g.close_segment();
  const DrawOptions options{.width = 16, .height = 16, .samples = 1};
  const std::array<std::array<double, 3>, 4> places{
      {{3, 7, 0.5}, {3, 7, 0.6}, {2, 7, 1.5}, {10, 7, 0.5}}};
  for (const bool is_hidden : {false, true}) {
    if (is_hidden) {
      g.open_segment(2);
      g.polygon_abs_3({{-1, -1, 1}, {17, -1, 1}, {17, 17, 1}, {-1, 17, 1}});
      g.close_segment();
    }
    Renderer renderer;
    for (const auto& [x, y, reach] : places) {
      const auto pick = renderer.pick(g, x, y, options, reach);
      EXPECT_EQ(pick && pick->kind == Pick::Kind::line, !is_hidden) << x << ' ' << reach;
    }
  }
}

/// The side of the clicked polygon, not that of the one beyond it; for polygons drawn as sides
/// only, those sides.
TEST(PickingLines, SidesOfPolygons) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.polygon_abs_3({{0.2, 0.2, 0}, {0.5, 0.2, 0}, {0.5, 0.8, 0}, {0.2, 0.8, 0}});
  g.polygon_abs_3({{0.5, 0.2, 0}, {0.8, 0.2, 0}, {0.8, 0.8, 0}, {0.5, 0.8, 0}});
  g.set_fill_style({FillStyle::Kind::hollow});
  g.polygon_abs_3({{0.1, 0.1, -0.5}, {0.9, 0.1, -0.5}, {0.9, 0.9, -0.5}, {0.1, 0.9, -0.5}});
  g.close_segment();
  Renderer renderer;
  const auto at = [&](double x, double y, double reach) {
    return renderer.pick(g, x, y, kHundred, reach);
  };
  EXPECT_EQ(at(48, 50, 3)->id, 0);
  EXPECT_EQ(at(48, 50, 3)->kind, Pick::Kind::edge);
  EXPECT_EQ(at(51, 50, 3)->id, 1);
  EXPECT_EQ(at(40, 50, 3)->kind, Pick::Kind::polygon);
  EXPECT_EQ(at(9, 50, 3)->id, 2);
  EXPECT_EQ(at(9, 50, 3)->kind, Pick::Kind::edge);
  EXPECT_FALSE(at(15, 50, 3));  // inside a hollow polygon
}

/// The rule of lines in the most naive way: a point is hidden if a hair beside it, on both sides, a
/// nearer fill covers. Places where that hair decides are left out.
class NaiveLines {
 public:
  struct Line {
    Point3 from, to;
    ViewedScene::Fill own;
  };
  enum class Seen { no, yes, unclear };

  explicit NaiveLines(const ViewedScene& scene) : scene_(scene) {
    for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
      const auto points = scene.points(item);
      const bool line = scene.kind(item) == Primitives::Kind::line;
      for (std::size_t k = line ? 1 : 0; k < points.size(); ++k) {
        lines_.push_back({points[(k + points.size() - 1) % points.size()], points[k], own(item)});
      }
    }
  }

  const std::vector<Line>& lines() const { return lines_; }
  Point2 at(const Line& line, double t) const {
    return Point2(line.from + t * (line.to - line.from));
  }

  Seen seen(const Line& line, double t) const {
    const Point2 along = Point2(line.to) - Point2(line.from);
    const Point2 beside = kHair / glm::length(along) * Point2(-along.y, along.x);
    const double z = line.from.z + t * (line.to.z - line.from.z);
    bool hidden[2] = {false, false};
    for (ViewedScene::Fill fill = 1; fill < scene_.end(); ++fill) {
      if (fill == line.own) continue;
      const Plane plane = scene_.plane(fill);
      for (int side = 0; side < 2; ++side) {
        const Point2 p = at(line, t) + (side == 0 ? 1.0 : -1.0) * beside;
        const auto covers = [&](const Point2& q) { return covered(scene_.vertices(fill), q); };
        const Point2 forth = 100.0 * kHair / glm::length(along) * along;
        const bool here = covers(p);
        if (covers(p + forth) != here || covers(p - forth) != here ||
            covers(p + 50.0 * (side == 0 ? 1.0 : -1.0) * beside) != here) {
          return Seen::unclear;
        }
        if (!here) continue;
        const Point2 q = at(line, t) - Point2(plane.p);
        const double nearer =
            plane.p.z - (plane.normal.x * q.x + plane.normal.y * q.y) / plane.normal.z - z;
        if (nearer > 1e-4) hidden[side] = true;
        if (std::abs(nearer) > 1e-11 && std::abs(nearer) <= 1e-4) return Seen::unclear;
      }
    }
    return hidden[0] && hidden[1] ? Seen::no : Seen::yes;
  }

 private:
  static constexpr double kHair = 1e-8;

  ViewedScene::Fill own(ViewedScene::Item item) const {
    for (ViewedScene::Fill fill = 1; fill < scene_.end(); ++fill) {
      if (scene_.item_of(fill) == item) return fill;
    }
    return ViewedScene::kBackground;
  }
  static bool covered(std::span<const Point3> polygon, const Point2& p) {
    bool odd = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) odd = !odd;
    }
    return odd;
  }

  const ViewedScene& scene_;
  std::vector<Line> lines_;
};

TEST(PickingLines, FollowTheRuleOnRandomScenes) {
  constexpr int kSize = 64;
  constexpr double kReach = 1e-5;
  int seen = 0, hidden = 0;
  for (std::uint32_t seed = 0; seed < 400 / test::kSlower; ++seed) {
    SCOPED_TRACE(seed);
    test::Dice dice(seed);
    const auto point = [&] {
      return Point3(dice.from(1, 7) / 8.0, dice.from(1, 7) / 8.0, dice.from(1, 4) / 4.0);
    };
    Segment segment(1);
    for (int k = dice.from(2, 6); k > 0; --k) {
      segment.set_style(FillStyle{});
      segment.set_style(LineStyle{});
      if (dice.one_in(3)) {
        segment.enter_line(point(), point());
        continue;
      }
      test::Vertices triangle{point(), point(), point()};
      test::enter(segment, triangle);
      if (dice.one_in(2)) {  // a neighbour
        triangle[0] = point();
        std::swap(triangle[1], triangle[2]);
        test::enter(segment, triangle);
      }
    }
    const ViewedScene scene(segment.entered(), {});
    const LinePicker picker(scene, {kSize, kSize}, 1);
    const NaiveLines naive(scene);
    for (const NaiveLines::Line& line : naive.lines()) {
      if (Point2(line.from) == Point2(line.to)) continue;
      const double t = dice.part();
      const Point2 at = naive.at(line, t);
      bool any = false, unclear = false;
      for (const NaiveLines::Line& other : naive.lines()) {
        const Point2 along = Point2(other.to) - Point2(other.from);
        if (along == Point2(0.0)) continue;
        const double near =
            std::clamp(glm::dot(at - Point2(other.from), along) / glm::dot(along, along), 0.0, 1.0);
        const double distance = kSize * glm::distance(at, naive.at(other, near));
        if (distance > 10.0 * kReach) continue;
        if (distance > 0.1 * kReach) unclear = true;
        const NaiveLines::Seen of_other = naive.seen(other, near);
        any = any || of_other == NaiveLines::Seen::yes;
        unclear = unclear || of_other == NaiveLines::Seen::unclear;
      }
      if (unclear) continue;
      const auto found = picker.nearest(double{kSize} * at, kReach, ViewedScene::kBackground);
      // A line is at least a pixel wide, and so is the area in which it is found.
      const bool is_there = found && found->distance < kReach;
      ASSERT_EQ(is_there, any) << at.x << ' ' << at.y;
      ++(any ? seen : hidden);
    }
  }
  EXPECT_GT(seen, 1000 / test::kSlower);
  EXPECT_GT(hidden, 300 / test::kSlower);
}

// ---- As the picture is drawn ---------------------------------------------------------------

/// Every pixel picked, against the picture's own item buffer and depths.
void expect_picks_of_the_picture(const GraphicsSystem& system, const DrawOptions& options) {
  DrawOptions with_fills = options;
  with_fills.with_ids = with_fills.with_depth = true;
  const Picture picture = draw(system, with_fills);
  Renderer renderer;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const auto k = static_cast<std::size_t>(y * options.width + x);
      const auto pick = renderer.pick(system, x + 0.5, y + 0.5, options);
      ASSERT_EQ(pick ? pick->id : -1, picture.ids[k]) << x << ", " << y;
      if (!pick) continue;
      ASSERT_EQ(pick->kind, Pick::Kind::polygon);
      ASSERT_NEAR(pick->depth, picture.depth[k], 1e-12 * (1.0 + std::abs(picture.depth[k])));
    }
  }
}

DrawOptions by_method(HiddenMethod method) {
  return {.width = 24, .height = 20, .surfaces = {.method = method}, .samples = 1};
}

TEST(PickingAsDrawn, IsTheItemBufferByEveryMethod) {
  for (std::uint64_t seed = 0; seed < 20 / test::kSlower + 1; ++seed) {
    const GraphicsSystem system = entered(random_degenerate_scene(seed));
    for (const HiddenMethodEntry& entry : hidden_methods()) {
      if (finds_lines(entry.method)) continue;                     // which draw no fills
      if (entry.method == HiddenMethod::world_ray_cast) continue;  // the scene is not retained
      SCOPED_TRACE(std::string(entry.name) + " " + std::to_string(seed));
      ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_picture(system, by_method(entry.method)));
    }
    for (const HiddenMethod surfaces : {HiddenMethod::none, HiddenMethod::z_buffer}) {
      ASSERT_NO_FATAL_FAILURE(
          expect_picks_of_the_picture(system, by_method(colour_rule_by(surfaces))));
    }
  }
}

TEST(PickingAsDrawn, IsTheItemBufferOfARoundoffAndOfAScope) {
  for (std::uint64_t seed = 0; seed < 10 / test::kSlower + 1; ++seed) {
    const GraphicsSystem system = entered(random_degenerate_scene(seed));
    for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::map, HiddenMethod::z_buffer,
                                      HiddenMethod::scan_line, HiddenMethod::depth_sort}) {
      SCOPED_TRACE(std::string(name_of(method)) + " " + std::to_string(seed));
      DrawOptions options = by_method(method);
      options.surfaces.precision = Precision{false, 0.1};
      ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_picture(system, options));
      if (is_image_space(method)) continue;
      options.surfaces.scope = HiddenScope::segment;
      ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_picture(system, options));
      options.surfaces.precision.reset();
      ASSERT_NO_FATAL_FAILURE(expect_picks_of_the_picture(system, options));
    }
  }
}

/// A near square in segment 1 and a farther one in segment 2, and lines over and under them. All
/// have one pick identifier.
GraphicsSystem near_before_far() {
  GraphicsSystem g = unit_square_without_lines();
  g.set_pick_id(3);
  g.open_segment(1);
  g.polygon_abs_3({{0.2, 0.2, -0.2}, {0.8, 0.2, -0.2}, {0.8, 0.8, -0.2}, {0.2, 0.8, -0.2}});
  g.set_line_style({});
  g.move_abs_3(0.1, 0.505, -0.1);
  g.line_abs_3(0.9, 0.505, -0.1);
  g.close_segment();
  g.open_segment(2);
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({{0.4, 0.4, -0.8}, {0.9, 0.4, -0.8}, {0.9, 0.9, -0.8}, {0.4, 0.9, -0.8}});
  g.set_line_style({});
  g.move_abs_3(0.605, 0.1, -0.9);
  g.line_abs_3(0.605, 0.9, -0.9);
  g.close_segment();
  return g;
}

TEST(PickingAsDrawn, InOrderOfEntryTheLastIsSeen) {
  const GraphicsSystem g = near_before_far();
  Renderer renderer;
  const auto at = [&](HiddenMethod method, double x, double y, double reach) {
    DrawOptions options = by_method(method);
    options.width = options.height = 100;
    return renderer.pick(g, x, y, options, reach);
  };
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::back_face, colour_rule_by(HiddenMethod::none)}) {
    SCOPED_TRACE(name_of(method));
    EXPECT_EQ(at(method, 50, 30, 0)->segment, 2);
    EXPECT_NEAR(at(method, 50, 30, 0)->depth, -0.8, 1e-12);
    EXPECT_EQ(at(method, 30, 30, 0)->segment, 1);
    EXPECT_EQ(at(method, 30, 49, 1)->kind, Pick::Kind::line);
    EXPECT_EQ(at(method, 50, 49, 1)->kind, Pick::Kind::polygon);  // drawn over the line
    EXPECT_EQ(at(method, 50, 49, 1)->segment, 2);
    EXPECT_EQ(at(method, 60, 70, 1)->kind, Pick::Kind::line);  // drawn over the nearer square
    EXPECT_EQ(at(method, 60, 49, 1)->segment, 2);              // of two lines
  }
  EXPECT_EQ(at(HiddenMethod::z_buffer, 50, 30, 0)->segment, 1);
  EXPECT_EQ(at(HiddenMethod::z_buffer, 50, 49, 1)->kind, Pick::Kind::line);
  EXPECT_EQ(at(HiddenMethod::z_buffer, 60, 70, 1)->kind, Pick::Kind::polygon);
}

/// Segments that are sorted each by itself are drawn one over the other, and by a method that finds
/// lines hide nothing of each other.
TEST(PickingAsDrawn, SegmentsSortedByThemselves) {
  const GraphicsSystem g = near_before_far();
  Renderer renderer;
  const auto at = [&](HiddenMethod method, HiddenScope scope, double x, double y) {
    DrawOptions options = by_method(method);
    options.width = options.height = 100;
    options.surfaces.scope = scope;
    return renderer.pick(g, x, y, options, 1);
  };
  const auto all = HiddenScope::all, segment = HiddenScope::segment;
  EXPECT_EQ(at(HiddenMethod::bsp, all, 50, 30)->segment, 1);
  EXPECT_EQ(at(HiddenMethod::bsp, segment, 50, 30)->segment, 2);
  EXPECT_EQ(at(HiddenMethod::bsp, all, 50, 49)->kind, Pick::Kind::line);
  EXPECT_EQ(at(HiddenMethod::bsp, segment, 50, 49)->kind, Pick::Kind::polygon);
  EXPECT_EQ(at(HiddenMethod::bsp, segment, 60, 30)->kind, Pick::Kind::polygon);  // by its own
  EXPECT_EQ(at(HiddenMethod::bsp, segment, 60, 70)->kind, Pick::Kind::line);
  EXPECT_EQ(at(HiddenMethod::bsp, all, 60, 70)->kind, Pick::Kind::polygon);
  EXPECT_EQ(at(HiddenMethod::appel, segment, 50, 49)->kind, Pick::Kind::line);
  EXPECT_EQ(at(HiddenMethod::appel, segment, 60, 70)->kind, Pick::Kind::line);
  EXPECT_EQ(at(HiddenMethod::appel, all, 60, 70)->kind, Pick::Kind::polygon);
}

// ---- Pictures one after another --------------------------------------------------------------

/// Whatever changes from one picture to the next, each equals one drawn from nothing.
using KeptRenderer = test::TemporaryFolder;
TEST_F(KeptRenderer, DrawsWhatIsDrawnFromNothing) {
  GraphicsSystem g;
  g.set_light({1, 2, 3});
  const auto enter = [&](int name, double z) {
    g.open_segment(name);
    for (int k = 0; k < 5; ++k) {
      g.polygon_abs_3({{-0.8, -0.8, z}, {0.8, -0.1 * k, -z}, {0.1 * k, 0.8, 0.1}});
    }
    g.move_abs_3(-1, 0, 0);
    g.line_abs_3(1, 0.5, 0);
    g.close_segment();
  };
  enter(1, 0.3);
  enter(2, -0.2);
  Renderer renderer;
  const auto check = [&](const DrawOptions& options) {
    for (int again = 0; again < 2; ++again) {
      const Picture right = draw(g, options);
      const Picture& drawn = renderer.draw(g, options);
      EXPECT_EQ(drawn.width, right.width);
      EXPECT_EQ(drawn.pixels, right.pixels);
      EXPECT_EQ(drawn.ids, right.ids);
      EXPECT_EQ(drawn.depth, right.depth);
      EXPECT_EQ(drawn.ids.empty(), !options.with_ids);
      EXPECT_EQ(drawn.depth.empty(), !options.with_depth);
    }
  };
  const auto check_all = [&] {
    for (const HiddenMethod method : {HiddenMethod::automatic, HiddenMethod::bsp,
                                      HiddenMethod::none, HiddenMethod::scan_line}) {
      check({.width = 40, .height = 30, .surfaces = {.method = method}});
      check({.width = 33, .height = 30, .surfaces = {.method = method}, .with_ids = true});
      check({.width = 40,
             .height = 30,
             .surfaces = {.method = method},
             .samples = 2,
             .with_depth = true});
    }
    renderer.draw(g, file("kept.png"), {.width = 40, .height = 30, .samples = 3});
    draw(g, file("anew.png"), {.width = 40, .height = 30, .samples = 3});
    EXPECT_EQ(test::content(file("kept.png")), test::content(file("anew.png")));
  };
  check_all();
  g.set_image_rotation(1, 20);
  check_all();
  enter(3, 0.1);
  g.delete_segment(1);
  check_all();
  g.set_visibility(3, false);
  check_all();
  Renderer moved = std::move(renderer);
  renderer = std::move(moved);
  check_all();
  EXPECT_THROW(renderer.draw(g, {.width = 0}), Error);
  check_all();
  g.delete_all_segments();
  check_all();
}

}  // namespace
}  // namespace displayfile
