// The spanning scan line, step by step: which polygons are IN on which line, which one is visible
// where, and which work is not repeated. software_truth_test and the hard cases test that no pixel
// is wrong.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "interp/visibility/scan_line.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::file_of;
using test::Vertices;
using Fill = ViewedScene::Fill;
using Polygons = std::vector<Vertices>;

/// A rectangle, in eighths of the picture, with z at its left and at its right side.
Vertices rectangle(double x_min, double y_min, double x_max, double y_max, double left,
                   double right) {
  return {{x_min / 8, y_min / 8, left},
          {x_max / 8, y_min / 8, right},
          {x_max / 8, y_max / 8, right},
          {x_min / 8, y_max / 8, left}};
}
Vertices rectangle(double x_min, double y_min, double x_max, double y_max, double z) {
  return rectangle(x_min, y_min, x_max, y_max, z, z);
}

char letter(Fill fill) {
  return fill == ViewedScene::kBackground ? '.' : static_cast<char>('A' + fill - 1);
}

/// The scan line at work on a small picture.
class Lines {
 public:
  explicit Lines(const DisplayFile& file, const PictureSize& size = {8, 8})
      : scene_(file), size_(size) {
    scan_line_.prepare({scene_, size, std::nullopt}, 1);
  }
  explicit Lines(const Polygons& polygons) : Lines(file_of(polygons)) {}

  /// The fills seen on a line from left to right.
  std::string seen(int row) {
    std::string text;
    counts_ =
        scan_line_.draw_rows_counting(row, row + 1, [&](int, int, std::span<const Fill> fills) {
          for (const Fill fill : fills) text += letter(fill);
        });
    return text;
  }
  /// The counts of the last query.
  const ScanLine::Counts& counts() const { return counts_; }

  ScanLine::Counts draw_all() {
    return scan_line_.draw_rows_counting(0, size_.height, [](int, int, std::span<const Fill>) {});
  }
  const ScanLine& method() const { return scan_line_; }
  const ViewedScene& scene() const { return scene_; }

  /// The polygons IN on one line after another: "A 1-5" for columns 1 to 4.
  std::vector<std::string> in() const {
    const PolygonList list(scene_, size_.height);
    const FillDepths depths(scene_, size_, std::nullopt);
    ActivePolygons active(scene_, depths, size_, list, 0);
    std::vector<std::string> lines;
    for (int row = 0; row < size_.height; ++row) {
      std::string line;
      active.next_row([&](ActivePolygons::Index k, int first, int end) {
        line +=
            fmt::format("{}{} {}-{}", line.empty() ? "" : ", ", letter(active[k].fill), first, end);
      });
      lines.push_back(line);
    }
    return lines;
  }

 private:
  ViewedScene scene_;
  PictureSize size_;
  ScanLine scan_line_;
  ScanLine::Counts counts_;
};

/// The problem book's section 10.5: edges become active and invert their polygon's flag; with one
/// polygon IN it is visible, with two the nearer.
TEST(ScanLine, PolygonsAreInBetweenTheirEdges) {
  Lines lines(Polygons{rectangle(1, 1, 5, 6, 0.25), rectangle(3, 3, 7, 8, 0.5)});
  const std::vector<std::string> in{
      "", "A 1-5", "A 1-5", "A 1-5, B 3-7", "A 1-5, B 3-7", "A 1-5, B 3-7", "B 3-7", "B 3-7"};
  EXPECT_EQ(lines.in(), in);
  EXPECT_EQ(lines.seen(0), "........");
  EXPECT_EQ(lines.counts().sweep.comparisons, 0u);
  EXPECT_EQ(lines.seen(2), ".AAAA...");
  EXPECT_EQ(lines.counts().sweep.comparisons, 0u) << "one polygon alone is seen unasked";
  EXPECT_EQ(lines.seen(4), ".AABBBB.");
  EXPECT_EQ(lines.counts().sweep.painted, 2u);
  EXPECT_EQ(lines.seen(7), "...BBBB.");
}

TEST(ScanLine, WhatWasHiddenIsSeenAgainWhereTheNearerEnds) {
  Lines lines(Polygons{rectangle(0, 0, 8, 8, 0.1), rectangle(1, 0, 6, 8, 0.3),
                       rectangle(2, 0, 4, 8, 0.5), rectangle(3, 0, 7, 8, 0.2)});
  EXPECT_EQ(lines.seen(3), "ABCCBBDA");
  EXPECT_EQ(lines.counts().sweep.spans, 4u);
  EXPECT_EQ(lines.counts().sweep.crossovers, 0u);
}

/// A concave polygon is IN twice on a line; where a polygon crosses itself it is even-odd.
TEST(ScanLine, ConcaveAndSelfCrossingPolygonsAreInMoreThanOnce) {
  const Vertices u{{0, 0, 0.5},       {1, 0, 0.5},       {1, 1, 0.5},    {0.75, 1, 0.5},
                   {0.75, 0.25, 0.5}, {0.25, 0.25, 0.5}, {0.25, 1, 0.5}, {0, 1, 0.5}};
  Lines concave(Polygons{u});
  EXPECT_EQ(concave.in()[0], "A 0-8");
  EXPECT_EQ(concave.in()[5], "A 0-2, A 6-8");
  EXPECT_EQ(concave.seen(5), "AA....AA");

  // At height 2 1/2 its sides cross the line at 0, 2 1/2, 5 1/2 and 8.
  Lines bow_tie(Polygons{Vertices{{0, 0, 0.5}, {1, 1, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}}});
  EXPECT_EQ(bow_tie.in()[2], "A 0-2, A 5-8");
  EXPECT_EQ(bow_tie.seen(2), "AA...AAA");
}

/// The lecture's Figure 1. A is level at z = 1/2, B rises by dz* = 1/8 a column from 1/16: from
/// column 0 they cross over N = (z* - z) / (dz - dz*) = (1/16 - 1/2) / (0 - 1/8) = 3 1/2 columns
/// on, so B is seen from column 4.
TEST(ScanLine, PolygonsThatInterpenetrateSwitchAtTheCrossover) {
  const Vertices level = rectangle(0, 0, 8, 8, 0.5), rising = rectangle(0, 0, 8, 8, 0.0, 1.0);
  Lines lines(Polygons{level, rising});
  EXPECT_EQ(lines.seen(3), "AAAABBBB");
  EXPECT_EQ(lines.counts().sweep.crossovers, 1u);
  EXPECT_EQ(lines.counts().sweep.painted, 2u) << "they never switch back";
}

/// They meet at z = 9/16, the centre of column 4: there the one entered later is visible.
TEST(ScanLine, AtACrossoverOnACentreTheLaterIsSeen) {
  const Vertices level = rectangle(0, 0, 8, 8, 0.5625), rising = rectangle(0, 0, 8, 8, 0.0, 1.0);
  EXPECT_EQ(Lines(Polygons{level, rising}).seen(3), "AAAABBBB");
  EXPECT_EQ(Lines(Polygons{rising, level}).seen(3), "BBBBBAAA");
}

/// A crossover behind a nearer polygon changes the visible polygon where that one ends.
TEST(ScanLine, CrossoversAreFoundBehindWhatIsSeen) {
  Lines lines(Polygons{rectangle(0, 0, 8, 8, 0.5), rectangle(0, 0, 8, 8, 0.0, 1.0),
                       rectangle(2, 0, 6, 8, 2.0), rectangle(5, 0, 7, 8, 1.5)});
  EXPECT_EQ(lines.seen(3), "AACCCCDB");
}

/// At an earlier, hidden polygon's end, the polygons that it hid must be kept.
TEST(ScanLine, WhatAHiddenPolygonHidComesOutAfterIt) {
  // B hides C; then A hides B and ends last; C passes A after B's end.
  Lines lines(Polygons{rectangle(1, 0, 8, 8, 0.75, 0.75), rectangle(0, 0, 4, 8, 0.7),
                       rectangle(0, 0, 8, 8, 0.0, 1.0)});
  EXPECT_EQ(lines.seen(3), "BAAAAACC");
}

/// Problem 10.8 by spans: the square B is IN from side to side on both lines, alone, and is
/// painted in one run each; the line A is drawn over it where it is nearer.
TEST(ScanLine, Problem10_8) {
  GraphicsSystem system;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/problem-10-8.draw", system);
  Lines lines(system.display_file(), {2, 2});
  EXPECT_EQ(lines.in(), (std::vector<std::string>{"A 0-2", "A 0-2"}));  // its only fill
  const ScanLine::Counts counts = lines.draw_all();
  EXPECT_EQ(counts.sweep.spans, 2u);
  EXPECT_EQ(counts.sweep.painted, 2u);
  EXPECT_EQ(counts.sweep.comparisons, 0u);

  const Picture picture = draw_with_software(
      system.display_file(),
      {.width = 2, .height = 2, .surfaces = {.method = HiddenMethod::scan_line}});
  // Top row first.
  const std::uint32_t b = picture.pixels[0], a = picture.pixels[1];
  EXPECT_NE(a, b);
  EXPECT_EQ(picture.pixels, (std::vector<std::uint32_t>{b, a, a, b}));
  EXPECT_EQ(b, pixel_of(lines.scene().fill_colour(lines.scene().item_of(1))));
}

TEST(ScanLine, EveryPixelIsToldOnceInWhateverBandsItIsDrawn) {
  const int width = 41, height = 37;
  for (const test::SceneFamily& family : test::scene_families()) {
    const DisplayFile file = test::scene(family, 7, 30);
    const Lines lines(file, {width, height});
    std::vector<Fill> whole(static_cast<std::size_t>(width * height)), in_bands = whole;
    for (const int rows : {height, 1, 5, 16}) {
      std::vector<int> told(whole.size());
      for (int row = 0; row < height; row += rows) {
        lines.method().draw_rows(
            row, std::min(row + rows, height), [&](int y, int first, std::span<const Fill> seen) {
              for (std::size_t i = 0; i < seen.size(); ++i) {
                const std::size_t at = static_cast<std::size_t>(y * width + first) + i;
                ++told[at];
                in_bands[at] = seen[i];
              }
            });
      }
      EXPECT_EQ(told, std::vector<int>(told.size(), 1)) << family.name;
      if (rows == height) whole = in_bands;
      EXPECT_EQ(in_bands, whole) << family.name << ", " << rows << " rows at a time";
    }
  }
}

/// The textbook: while nothing changes, the depth order of the line above holds. Of a stack of
/// sheets only the visible one is tested again.
TEST(ScanLine, HiddenPolygonsRestWhileNothingChanges) {
  constexpr int kSheets = 20, kRows = 100;
  Polygons sheets;
  for (int k = 0; k < kSheets; ++k) {
    sheets.push_back(rectangle(0.5 + 0.1 * k, 0, 7.5 - 0.1 * k, 8, 0.9 - 0.02 * k));
  }
  Lines lines(file_of(sheets), {100, kRows});
  const ScanLine::Counts counts = lines.draw_all();
  EXPECT_EQ(counts.rests, std::uint64_t{kSheets - 1});
  EXPECT_EQ(counts.rows_left, std::uint64_t{(kSheets - 1) * (kRows - 1)});
  EXPECT_EQ(counts.sweep.spans, std::uint64_t{kSheets - 1 + kRows});
  EXPECT_EQ(counts.sweep.painted, std::uint64_t{kRows});
}

/// Coplanar polygons rest too, of which the last is visible, and so do sheets that only exact
/// arithmetic distinguishes.
TEST(ScanLine, CoplanarPolygonsRestToo) {
  Polygons sheets;
  for (int k = 0; k < 20; ++k) {
    Vertices sheet = rectangle(0, 0, 8, 8, 0.3, 0.7);
    if (k % 2 == 0) {
      for (Point3& v : sheet) v.z = std::nextafter(v.z, 1.0);
    }
    sheets.push_back(sheet);
  }
  Lines lines(file_of(sheets), {50, 50});
  EXPECT_EQ(lines.draw_all().sweep.spans, 19u + 50u);
  EXPECT_EQ(lines.seen(30), std::string(50, 'S'));  // the last of the ten that are an ulp nearer
}

/// A polygon that would come out at the side, or in front, farther up does not rest.
TEST(ScanLine, WhatComesOutFartherUpIsLookedAtAgain) {
  const auto shown_at_top = [](const Vertices& hidden) {
    Lines lines(file_of({hidden, rectangle(1, 0, 7, 8, 0.5)}), {64, 64});
    std::string top;
    lines.method().draw_rows(0, 64, [&](int row, int, std::span<const Fill> seen) {
      top.clear();
      for (const Fill fill : seen) top += letter(fill);
      if (row == 0) {
        EXPECT_EQ(top.find('A'), std::string::npos);
      }
    });
    return top.find('A') != std::string::npos;
  };
  const double z = 0.25;
  EXPECT_FALSE(shown_at_top({{0.25, 0, z}, {0.75, 0, z}, {0.75, 1, z}, {0.25, 1, z}}));
  EXPECT_TRUE(shown_at_top({{0.25, 0, z}, {0.75, 0, z}, {1, 1, z}, {0.25, 1, z}}));
  EXPECT_TRUE(shown_at_top({{0.25, 0, z}, {0.75, 0, z}, {0.75, 1, 0.51}, {0.25, 1, 0.51}}));
  // A bow tie hides nothing at its waist.
  Lines lines(file_of({rectangle(3, 0, 5, 8, z),
                       Vertices{{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.5}}}),
              {64, 64});
  std::string waist;
  lines.method().draw_rows(0, 64, [&](int row, int, std::span<const Fill> seen) {
    if (row == 31) waist = letter(seen[24]);
  });
  EXPECT_EQ(waist, "A");
}

TEST(ScanLine, PolygonsThatRestLeaveNoWrongPixels) {
  std::uint64_t rests = 0;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      const DisplayFile file = test::scene(family, seed, 40);
      rests += Lines(file, {96, 80}).draw_all().rests;
      const Picture drawn =
          draw_with_software(file, {.width = 96,
                                    .height = 80,
                                    .surfaces = {.method = HiddenMethod::scan_line},
                                    .ids = true});
      ASSERT_EQ(drawn.ids, truth(file, 96, 80, false).ids) << family.name << ", seed " << seed;
    }
  }
  EXPECT_GT(rests, 100u);
}

/// All k polygons of a line that has them all are put in order with near k log k comparisons, not
/// with k^2 / 2, in whatever order they begin, end and lie behind each other.
TEST(ScanLine, ComparisonsGrowAsTheSpansDo) {
  constexpr int kPolygons = 1000;
  const double most = kPolygons * (2.0 * std::log2(kPolygons) + 2.0);
  test::Dice dice(1);
  for (const char* order : {"nested", "stairs", "random", "crossing"}) {
    Polygons polygons;
    for (int k = 0; k < kPolygons; ++k) {
      const double part = 1.0 * k / kPolygons;
      const std::string name = order;
      const double x = name == "random" ? 4 * dice.part() : 4 * part;
      const double end = name == "nested" ? 8 - x : x + 4;
      const double z = name == "random" ? dice.part() : part;
      const double rise = name == "crossing" ? part : 0.0;
      polygons.push_back(rectangle(x, 0, end, 8, z - rise, z + rise));
    }
    Lines lines(file_of(polygons), {4096, 1});
    const auto counts = lines.draw_all().sweep;
    EXPECT_GT(counts.spans, kPolygons * 9u / 10u) << order;
    const auto crossovers = static_cast<double>(counts.crossovers);
    EXPECT_LT(crossovers, kPolygons * std::log2(kPolygons)) << order;
    EXPECT_LT(static_cast<double>(counts.comparisons), most + 8.0 * crossovers) << order;
  }
}

}  // namespace
}  // namespace displayfile
