// Strokes that lie on each other are drawn once, and those that join no other are known
// (hidden/lines/strokes_once.h).

#include "hidden/lines/strokes_once.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace displayfile {
namespace {

StrokeOfPicture stroke(const Point2& from, const Point2& to, std::uint32_t rank = 0,
                       std::uint32_t group = 0) {
  return {{from, to}, rank, group, false, false};
}

std::vector<StrokePart> once(const std::vector<StrokeOfPicture>& strokes, double apart = 1e-9) {
  return strokes_once(strokes, apart);
}

void expect_whole(const std::vector<StrokePart>& parts, const std::vector<std::uint32_t>& strokes) {
  ASSERT_EQ(parts.size(), strokes.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_EQ(parts[k].stroke, strokes[k]);
    EXPECT_TRUE(parts[k].is_whole());
  }
}

// ---- Once ---------------------------------------------------------------------------------------

TEST(StrokesOnce, ThatAreApartAreWhole) {
  expect_whole(once({stroke({0.1, 0.1}, {0.5, 0.1}), stroke({0.1, 0.1}, {0.1, 0.7}),
                     stroke({0.1, 0.2}, {0.5, 0.2}), stroke({0.5, 0.1}, {0.9, 0.1})}),
               {0, 1, 2, 3});
  EXPECT_TRUE(once({}).empty());
}

TEST(StrokesOnce, OfEqualOnesTheFirstIsDrawn) {
  expect_whole(once({stroke({0.1, 0.3}, {0.5, 0.7}), stroke({0.5, 0.7}, {0.1, 0.3}),
                     stroke({0.1, 0.3}, {0.5, 0.7})}),
               {0});
}

TEST(StrokesOnce, OfTheLowestRankIsDrawnAndOfOthersTheRest) {
  const auto parts = once({stroke({0.1, 0.5}, {0.9, 0.5}, 2), stroke({0.3, 0.5}, {0.5, 0.5}, 1)});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].stroke, 0u);
  EXPECT_NEAR(parts[0].to, 0.25, 1e-12);
  EXPECT_EQ(parts[1].stroke, 0u);
  EXPECT_NEAR(parts[1].from, 0.5, 1e-12);
  EXPECT_EQ(parts[1].to, 1.0);
  EXPECT_EQ(parts[2].stroke, 1u);
  EXPECT_TRUE(parts[2].is_whole());
}

TEST(StrokesOnce, OfOtherGroupsAreDrawnOverEachOther) {
  expect_whole(once({stroke({0.1, 0.5}, {0.9, 0.5}, 0, 1), stroke({0.1, 0.5}, {0.9, 0.5}, 0, 2)}),
               {0, 1});
}

TEST(StrokesOnce, LieOnEachOtherWithinADistance) {
  const double off = 1e-6;
  const std::vector<StrokeOfPicture> strokes{stroke({0.1, 0.5}, {0.9, 0.5}),
                                             stroke({0.2, 0.5 + off}, {0.8, 0.5 - off})};
  expect_whole(once(strokes, 2 * off), {0});
  expect_whole(once(strokes, 0.5 * off), {0, 1});
}

/// The length that is drawn is that of the union, found along each line by sorting.
TEST(StrokesOnce, DrawTheUnion) {
  std::mt19937 random(7);
  const auto number = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  for (int scene = 0; scene < 200; ++scene) {
    std::vector<StrokeOfPicture> strokes;
    std::vector<std::vector<bool>> is_drawn(4, std::vector<bool>(32, false));
    for (int k = 0; k < 12; ++k) {
      const int line = number(4), from = number(31), to = from + 1 + number(31 - from);
      const auto at = [&](int x) { return Point2(x / 64.0, line / 8.0 + x / 128.0); };
      strokes.push_back(stroke(at(from), at(to), static_cast<std::uint32_t>(number(3))));
      for (int x = from; x < to; ++x)
        is_drawn[static_cast<std::size_t>(line)][static_cast<std::size_t>(x)] = true;
    }
    double expected = 0.0, length = 0.0;
    for (const auto& of_line : is_drawn) {
      expected +=
          std::hypot(1 / 64.0, 1 / 128.0) * static_cast<double>(std::ranges::count(of_line, true));
    }
    for (const StrokePart& part : once(strokes)) {
      const LineOfPicture& line = strokes[part.stroke].line;
      length +=
          (part.to - part.from) * std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    }
    EXPECT_NEAR(length, expected, 1e-12) << scene;
  }
}

// ---- Alone --------------------------------------------------------------------------------------

std::vector<bool> alone(const std::vector<StrokeOfPicture>& strokes, double apart = 1e-9) {
  std::vector<bool> found;
  for (const StrokePart& part : once(strokes, apart)) found.push_back(part.is_alone);
  return found;
}

TEST(StrokesOnce, AreAloneWhereNoEndMeetsOneOfTheirs) {
  using IsAlone = std::vector<bool>;
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1})}), IsAlone{true});
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1}), stroke({0.2, 0.1}, {0.2, 0.4}),
                   stroke({0.5, 0.5}, {0.6, 0.5})}),
            (IsAlone{false, false, true}));
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1}), stroke({0.3, 0.4}, {0.1, 0.1})}),
            (IsAlone{false, false}))
      << "at its start";
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1}), stroke({0.2 + 1e-6, 0.1}, {0.2, 0.4})}, 1e-5),
            (IsAlone{false, false}))
      << "within the distance";
}

TEST(StrokesOnce, ThatWereEnteredAreNeverAlone) {
  StrokeOfPicture entered = stroke({0.1, 0.1}, {0.2, 0.1});
  entered.is_entered = true;
  EXPECT_EQ(alone({entered}), std::vector<bool>{false});
}

TEST(StrokesOnce, ThatAreHiddenJoinNothing) {
  StrokeOfPicture hidden = stroke({0.2, 0.1}, {0.2, 0.4}, 0, 1);
  hidden.is_hidden = true;
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1}), hidden}), (std::vector<bool>{true, false}));
}

/// A group matters to covering, not to meeting.
TEST(StrokesOnce, MeetThoseOfOtherGroups) {
  EXPECT_EQ(alone({stroke({0.1, 0.1}, {0.2, 0.1}, 0, 1), stroke({0.2, 0.1}, {0.2, 0.4}, 0, 2)}),
            (std::vector<bool>{false, false}));
}

TEST(StrokesOnce, AreShorterThanAPenInPixels) {
  const Point2 pixels(200, 100);
  EXPECT_TRUE(is_shorter_than_wide({0.5, 0.5}, {0.5 + 0.9 / 200, 0.5}, pixels, 1.0));
  EXPECT_FALSE(is_shorter_than_wide({0.5, 0.5}, {0.5 + 1.1 / 200, 0.5}, pixels, 1.0));
  EXPECT_TRUE(is_shorter_than_wide({0.5, 0.5}, {0.5, 0.5 - 0.9 / 100}, pixels, 1.0));
  EXPECT_FALSE(is_shorter_than_wide({0.5, 0.5}, {0.5, 0.5 - 0.9 / 100}, pixels, 0.5));
  EXPECT_FALSE(is_shorter_than_wide({0.5, 0.5}, {0.5 + 0.8 / 200, 0.5 + 0.8 / 100}, pixels, 1.0));
}

}  // namespace
}  // namespace displayfile
