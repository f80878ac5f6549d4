// interp/vector/pens/cut_order.h, and strokes of fills that touch.

#include "interp/vector/pens/cut_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/vector/pens/pen_drawing.h"
#include "interp/vector/pens/unique_strokes.h"

namespace displayfile {
namespace {

struct Box {
  std::int32_t x0, y0, x1, y1;
  bool holds(const Box& o) const { return x0 < o.x0 && o.x1 < x1 && y0 < o.y0 && o.y1 < y1; }
};

PenPath contour(const Box& b) {
  return {{{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}}, true};
}

/// Boxes at random, some inside of others: those that cross count neither way, and are left out.
std::vector<Box> nested_boxes(unsigned seed, std::size_t n) {
  std::mt19937 random(seed);
  std::vector<Box> boxes;
  for (int tries = 0; boxes.size() < n && tries < 100000; ++tries) {
    const auto number = [&](std::int32_t most) {
      return static_cast<std::int32_t>(random() % static_cast<unsigned>(most));
    };
    const Box box{number(9000), number(9000), 0, 0};
    const Box b{box.x0, box.y0, box.x0 + 10 + number(4000), box.y0 + 10 + number(4000)};
    const bool crosses = std::ranges::any_of(boxes, [&](const Box& o) {
      const bool apart = b.x1 < o.x0 || o.x1 < b.x0 || b.y1 < o.y0 || o.y1 < b.y0;
      return !apart && !b.holds(o) && !o.holds(b);
    });
    if (!crosses) boxes.push_back(b);
  }
  return boxes;
}

TEST(CutOrder, DepthsAreThoseOfAllPairs) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const std::vector<Box> boxes = nested_boxes(seed, 60);
    std::vector<PenPath> paths;
    for (const Box& b : boxes) paths.push_back(contour(b));
    const auto depths = nesting_depths(paths);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const auto around =
          std::ranges::count_if(boxes, [&](const Box& o) { return o.holds(boxes[k]); });
      ASSERT_EQ(depths[k], static_cast<std::uint32_t>(around)) << k;
    }
    order_for_cutting(paths);
    ASSERT_EQ(paths.size(), boxes.size());
    const auto after = nesting_depths(paths);
    EXPECT_TRUE(std::ranges::is_sorted(after, std::ranges::greater()));
    EXPECT_GT(after.front(), 0u);
  }
}

TEST(CutOrder, OpenPathsAndDotsLieInContoursToo) {
  const std::vector<PenPath> paths{contour({0, 0, 100, 100}),
                                   {{{10, 10}, {20, 30}}, false},
                                   {{{50, 50}}, false},
                                   {{{150, 50}}, false},
                                   {{{50, 50}, {150, 50}}, false}};
  EXPECT_EQ(nesting_depths(paths), (std::vector<std::uint32_t>{0, 1, 1, 0, 0}));
}

/// A bay: in the box around the contour, but not in the contour; and a chord, over its corners.
TEST(CutOrder, ContainmentIsExact) {
  const PenPath bay{
      {{0, 0}, {100, 0}, {100, 100}, {60, 100}, {60, 40}, {40, 40}, {40, 100}, {0, 100}}, true};
  const std::vector<PenPath> paths{bay,
                                   contour({45, 50, 55, 60}),
                                   contour({10, 10, 20, 20}),
                                   {{{40, 100}, {60, 100}}, false},
                                   {{{0, 0}, {100, 0}}, false},
                                   {{{0, 0}, {40, 40}}, false},
                                   {{{39, 50}, {61, 50}}, false}};
  EXPECT_EQ(nesting_depths(paths), (std::vector<std::uint32_t>{0, 0, 1, 0, 0, 1, 0}));
  const std::vector<PenPath> twice{contour({0, 0, 9, 9}), contour({0, 0, 9, 9})};
  EXPECT_EQ(nesting_depths(twice), (std::vector<std::uint32_t>{0, 0}));
}

/// The inner square touches the outer one: the pen goes around both in one path.
TEST(CutOrder, LoopsOfAPathAreCutOneByOne) {
  const std::vector<Stroke> strokes{{{0, 0}, {1000, 0}},       {{1000, 0}, {1000, 1000}},
                                    {{1000, 1000}, {0, 1000}}, {{0, 1000}, {0, 0}},
                                    {{0, 0}, {400, 100}},      {{400, 100}, {100, 400}},
                                    {{100, 400}, {0, 0}}};
  std::vector<PenPath> paths = stroke_chains(unique_strokes(strokes));
  ASSERT_EQ(paths.size(), 1u);
  const double length = length_of(paths[0]);
  order_for_cutting(paths);
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_TRUE(paths[0].closed && paths[1].closed);
  EXPECT_EQ(paths[0].points.size(), 3u);
  EXPECT_DOUBLE_EQ(length_of(paths[0]) + length_of(paths[1]), length);
}

TEST(CutOrder, SimplePathsKeepOpenRests) {
  const std::vector<PenPath> paths{{{{0, 0}, {10, 0}, {10, 10}, {20, 0}, {10, 0}, {0, 9}}, false}};
  const auto simple = simple_paths(paths);
  ASSERT_EQ(simple.size(), 2u);
  EXPECT_TRUE(simple[0].closed);
  EXPECT_EQ(simple[0].points.size(), 3u);
  EXPECT_FALSE(simple[1].closed);
  EXPECT_EQ(simple[1].points, (std::vector<SheetPoint>{{0, 0}, {10, 0}, {0, 9}}));
}

/// No two strokes of a pen lie on each other along a way.
void expect_unique(const PenDrawing& drawing) {
  for (const PenLayer& layer : drawing.layers) {
    std::vector<Stroke> strokes;
    for (const PenPath& path : layer.paths) {
      const auto& p = path.points;
      for (std::size_t i = path.closed ? 0 : 1; i < p.size(); ++i) {
        strokes.push_back({p[i == 0 ? p.size() - 1 : i - 1], p[i]});
      }
    }
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      for (std::size_t j = i + 1; j < strokes.size(); ++j) {
        const Stroke &a = strokes[i], &b = strokes[j];
        if (cross(a.from, a.to, a.from, b.from) != 0 || cross(a.from, a.to, a.from, b.to) != 0) {
          continue;
        }
        const auto along = [&](const SheetPoint& q) { return dot(a.from, a.to, a.from, q); };
        const auto low = std::min(along(b.from), along(b.to));
        const auto high = std::max(along(b.from), along(b.to));
        ASSERT_TRUE(high <= 0 || low >= along(a.to)) << i << " " << j;
      }
    }
  }
}

/// Two parts that share a piece of their outlines, in one tone or two, hatched along it.
TEST(CutOrder, PartsThatTouchShareTheirStrokes) {
  for (const double second : {0.0, 0.5}) {
    for (const bool outlines : {true, false}) {
      for (const double angle : {0.0, 45.0, 90.0}) {
        GraphicsSystem g;
        g.set_window(0, 1, 0, 1);
        g.open_segment(1);
        LineStyle line;
        if (!outlines) line.kind = LineStyle::Kind::none;
        g.set_line_style(line);
        g.set_fill_style({FillStyle::Kind::solid, Colour(0.0)});
        g.polygon_abs_2({{0.1, 0.1}, {0.5, 0.1}, {0.5, 0.9}, {0.1, 0.9}});
        g.set_fill_style({FillStyle::Kind::solid, Colour(second)});
        g.polygon_abs_2({{0.5, 0.3}, {0.9, 0.3}, {0.9, 0.7}, {0.5, 0.7}});
        g.close_segment();
        Pens pens;
        pens.order = PenOrder::cut;
        pens.hatching.emplace();
        pens.hatching->spacing = 1.0;
        pens.hatching->angle = angle;
        pens.hatching->width = 0.190;  // that of the lines: one pen draws both
        const PenDrawing drawing = pen_drawing(g.display_file(), 1000, 1000, Paper{}, pens);
        ASSERT_FALSE(drawing.layers.empty());
        expect_unique(drawing);
      }
    }
  }
}

TEST(CutOrder, LayersAreInTheStatedOrder) {
  GraphicsSystem g;
  g.set_window(0, 1, 0, 1);
  g.open_segment(1);
  const Colour red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), blue(0.0, 0.0, 1.0);
  double y = 0.1;
  for (const Colour& colour : {red, green, blue}) {
    g.set_line_style({LineStyle::Kind::solid, colour});
    g.move_abs_2(0.1, y);
    g.line_abs_2(0.9, y);
    y += 0.1;
  }
  g.close_segment();
  const auto colours = [&](const std::vector<Colour>& layers) {
    Pens pens;
    pens.layers = layers;
    std::vector<std::uint32_t> all;
    for (const PenLayer& layer : pen_drawing(g.display_file(), 100, 100, Paper{}, pens).layers) {
      all.push_back(layer.pen.colour);
    }
    return all;
  };
  const std::uint32_t r = pixel_of(red), green_pixel = pixel_of(green), b = pixel_of(blue);
  EXPECT_EQ(colours({}), (std::vector<std::uint32_t>{r, green_pixel, b}));
  EXPECT_EQ(colours({blue}), (std::vector<std::uint32_t>{b, r, green_pixel}));
  EXPECT_EQ(colours({blue, green}), (std::vector<std::uint32_t>{b, green_pixel, r}));
  Pens pens;
  pens.layers = {Colour(1.0), red};
  const PenDrawing drawing = pen_drawing(g.display_file(), 100, 100, Paper{}, pens);
  EXPECT_EQ(layers_without_pen(drawing, pens), (std::vector<std::string>{"#ffffff"}));
  pens.layers = {red, red};
  EXPECT_THROW(require_pens(pens), std::exception);
}

}  // namespace
}  // namespace displayfile
