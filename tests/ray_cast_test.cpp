// The invariants of ray casting besides having no wrong pixel (software_truth_test.cpp).

#include "interp/visibility/ray_cast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/pixel_tree.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using Fill = ViewedScene::Fill;

/// The fills seen, drawn `rows` at a time from the bottom.
std::vector<Fill> drawn(const ViewedScene& scene, const PictureSize& size,
                        std::optional<double> roundoff, int threads, int rows) {
  RayCast method;
  method.prepare({scene, size, roundoff}, threads);
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<Fill> seen(width * static_cast<std::size_t>(size.height), ~Fill{0});
  for (int begin = 0; begin < size.height; begin += rows) {
    method.draw_rows(
        begin, std::min(begin + rows, size.height),
        [&](int row, int first, std::span<const Fill> fills) {
          for (std::size_t i = 0; i < fills.size(); ++i) {
            Fill& at =
                seen[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(first) + i];
            EXPECT_EQ(at, ~Fill{0}) << "told twice";
            at = fills[i];
          }
        });
  }
  return seen;
}

TEST(RayCast, TheSameInWhateverRowsItIsDrawn) {
  for (const test::SceneFamily& family : test::scene_families()) {
    const DisplayFile file = test::scene(family, 77, 40);
    const ViewedScene scene(file);
    const PictureSize size{37, 45};
    for (const std::optional<double> roundoff : {std::optional<double>(), std::optional(1e-3)}) {
      const auto whole = drawn(scene, size, roundoff, 1, size.height);
      for (const int rows : {1, 3, 7, 8, 20}) {
        EXPECT_EQ(drawn(scene, size, roundoff, 1, rows), whole) << family.name << ", rows " << rows;
      }
    }
  }
}

test::Vertices of_many_sides(test::Dice& dice) {
  const double z = dice.from(0, 8) / 8.0, slope = dice.from(-1, 1) / 8.0;
  return test::polygon(dice.from(9, 200), [&] {
    const double x = test::scenes::step(dice, 16), y = test::scenes::step(dice, 16);
    return Point3{x, y, z + slope * x};
  });
}

TEST(RayCast, NoWrongPixelsOfPolygonsOfManySides) {
  const test::SceneFamily family{"many sides", of_many_sides};
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const DisplayFile file = test::scene(family, seed, 5);
    const RasterRequest request{
        .width = 40, .height = 31, .surfaces = {.method = HiddenMethod::ray_cast}, .ids = true};
    EXPECT_EQ(draw_with_software(file, request).ids, truth(file, 40, 31, false).ids) << seed;
  }
}

TEST(RayCast, NothingInAnEmptySceneAndNothingKeptOfTheSceneBefore) {
  const DisplayFile file = test::scene({"grid", test::scenes::on_a_grid}, 5, 30);
  const ViewedScene full(file), empty;
  const PictureSize size{9, 9};
  RayCast method;
  method.prepare({full, size, std::nullopt}, 1);
  method.prepare({empty, size, std::nullopt}, 1);
  int rows = 0;
  method.draw_rows(0, size.height, [&](int, int, std::span<const Fill> seen) {
    ++rows;
    EXPECT_EQ(std::ranges::count(seen, ViewedScene::kBackground), 9);
  });
  EXPECT_EQ(rows, 9);
}

TEST(RayCast, TheSameOnAnyNumberOfThreads) {
  const DisplayFile file = test::scene({"anything", test::scenes::anything}, 3, 6000);
  const ViewedScene scene(file);
  const PictureSize size{64, 64};
  const auto one = drawn(scene, size, std::nullopt, 1, size.height);
  EXPECT_EQ(drawn(scene, size, std::nullopt, 2, size.height), one);
  EXPECT_EQ(drawn(scene, size, std::nullopt, 64, 5), one);
}

/// By definition, ray by ray: of the fills hit within ROUNDOFF of the nearest the last.
void expect_the_last_of_the_nearest(double roundoff) {
  const PictureSize size{29, 23};
  for (const auto& family : {test::SceneFamily{"anything", test::scenes::anything},
                             test::SceneFamily{"grid", test::scenes::on_a_grid}}) {
    const DisplayFile file = test::scene(family, 9, 60);
    const ViewedScene scene(file);
    const FillDepths depths(scene, size, roundoff);
    const auto seen = drawn(scene, size, roundoff, 1, size.height);
    // Each fill by itself shows which rays hit it.
    const auto pixels = static_cast<std::size_t>(size.width * size.height);
    std::vector<std::vector<bool>> hit(scene.end(), std::vector<bool>(pixels));
    for (Fill fill = 1; fill < scene.end(); ++fill) {
      DisplayFile alone;
      Segment& segment = alone.create(1);
      segment.set_style(FillStyle{FillStyle::Kind::solid});
      segment.set_style(LineStyle{LineStyle::Kind::none});
      segment.set_pick(0);
      const auto vertices = scene.vertices(fill);
      test::enter(segment, {vertices.begin(), vertices.end()});
      const Picture picture = truth(alone, size.width, size.height, false);
      for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
          const auto from_top = static_cast<std::size_t>((size.height - 1 - row) * size.width);
          hit[fill][static_cast<std::size_t>(row * size.width + column)] =
              picture.ids[from_top + static_cast<std::size_t>(column)] == 0;
        }
      }
    }
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const auto at = static_cast<std::size_t>(row * size.width + column);
        double nearest = -std::numeric_limits<double>::infinity();
        for (Fill fill = 1; fill < scene.end(); ++fill) {
          if (hit[fill][at]) nearest = std::max(nearest, depths.at(fill, column, row));
        }
        Fill last = ViewedScene::kBackground;
        for (Fill fill = 1; fill < scene.end(); ++fill) {
          if (hit[fill][at] && depths.at(fill, column, row) >= nearest - roundoff) last = fill;
        }
        ASSERT_EQ(seen[at], last) << family.name << ", column " << column << ", row " << row;
      }
    }
  }
}

TEST(RayCast, WithRoundoffTheLastOfTheNearestIsSeen) { expect_the_last_of_the_nearest(0.05); }
TEST(RayCast, WithARoundoffOfZeroTheLastOfTheNearestIsSeen) { expect_the_last_of_the_nearest(0.0); }

std::vector<DeepPixelBox> random_boxes(test::Dice& dice, int count, int side) {
  std::vector<DeepPixelBox> boxes;
  for (int k = 0; k < count; ++k) {
    const int column = dice.from(0, 100 - side), row = dice.from(0, 100 - side);
    const PixelBox pixels{column, column + dice.from(1, side), row, row + dice.from(1, side)};
    const float nearest = dice.one_in(20) ? std::numeric_limits<float>::infinity()
                                          : static_cast<float>(dice.from(-9, 9));
    boxes.push_back({pixels, nearest});
  }
  return boxes;
}

bool meet(const PixelBox& a, const PixelBox& b) {
  return a.first_column < b.end_column && b.first_column < a.end_column &&
         a.first_row < b.end_row && b.first_row < a.end_row;
}

TEST(PixelTree, VisitsWhatTheRaysMeetAndIsNotHidden) {
  test::Dice dice(1);
  for (const int count : {0, 1, 7, 8, 9, 100, 3000}) {
    for (const int side : {1, 5, 90}) {
      const auto boxes = random_boxes(dice, count, side);
      PixelTree tree;
      tree.build(boxes, 1);
      for (int round = 0; round < 30; ++round) {
        const int column = dice.from(0, 95), row = dice.from(0, 95);
        const PixelBox rays{column, column + dice.from(1, 8), row, row + dice.from(1, 8)};
        const auto farthest = static_cast<float>(dice.from(-10, 10));
        std::vector<PixelTree::Item> expected, visited;
        for (PixelTree::Item item = 0; item < boxes.size(); ++item) {
          if (meet(boxes[item].pixels, rays) && !(boxes[item].nearest < farthest)) {
            expected.push_back(item);
          }
        }
        front_to_back(
            tree, rays, [&](float nearest) { return nearest < farthest; },
            [&](PixelTree::Position p) { visited.push_back(tree.order()[p]); });
        std::ranges::sort(visited);
        ASSERT_EQ(visited, expected) << count << " boxes, side " << side;
      }
    }
  }
}

TEST(PixelTree, TheSameOnAnyNumberOfThreads) {
  test::Dice dice(2);
  const auto boxes = random_boxes(dice, 20'000, 6);
  std::vector<PixelTree::Item> order[2];
  for (const int threads : {1, 2}) {
    PixelTree tree;
    tree.build(boxes, threads);
    front_to_back(
        tree, {0, 100, 0, 100}, [](float) { return false; },
        [&](PixelTree::Position p) { order[threads - 1].push_back(tree.order()[p]); });
  }
  EXPECT_EQ(order[0], order[1]);
}

/// Boxes that no plane separates, and boxes each twice as far away as the one before: neither makes
/// the tree slow to build or deep.
TEST(PixelTree, BoxesInOnePlaceAndBoxesEverFartherApart) {
  for (const bool one_place : {true, false}) {
    std::vector<DeepPixelBox> boxes;
    for (int k = 0; k < 100'000; ++k) {
      const std::int32_t column = one_place ? 3 : 1 << (k % 30);
      boxes.push_back({{column, column + 1, 0, 1}, one_place ? 0.0F : static_cast<float>(k % 7)});
    }
    PixelTree tree;
    tree.build(boxes, 1);
    std::vector<int> visits(boxes.size());
    front_to_back(
        tree, {0, 1 << 30, 0, 1}, [](float) { return false; },
        [&](PixelTree::Position p) { ++visits[tree.order()[p]]; });
    EXPECT_EQ(std::ranges::count(visits, 1), 100'000);
    EXPECT_LT(tree.depth(), 40U);
  }
}

}  // namespace
}  // namespace displayfile
