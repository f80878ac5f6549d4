// Claims about lines, judged by their truth: wrong ones are found, right ones are accepted.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "interp/truth/true_lines.h"
#include "tests/line_drawings.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using namespace test;

TEST(CompareLines, CountsWhatIsMissingAndWhatIsExtra) {
  Drawing drawing;
  drawing.line({0, 0.5, 0}, {0.5, 0.5, 0}).polygon(rectangle(0.25, 0, 1, 1, 1));
  const LineItems items(drawing.file());
  const auto truth = true_lines(items, std::vector<LineId>{{0, 1}});  // seen from 0 to 0.5
  const auto compare = [&](const std::vector<LinePiece>& claimed) {
    return compare_lines(items, truth, claimed);
  };
  const LineErrors nothing = compare({});
  EXPECT_EQ(nothing.missing, 0.25);
  EXPECT_EQ(nothing.extra, 0.0);
  EXPECT_EQ(nothing.length, 0.5);
  const LineErrors all = compare({{{0, 1}, 0, 1}});
  EXPECT_EQ(all.missing, 0.0);
  EXPECT_EQ(all.extra, 0.25);
  const LineErrors both =
      compare({{{0, 1}, 0.625, 0.75}, {{0, 1}, 0.125, 0.25}, {{0, 1}, 0, 0.25}});
  EXPECT_EQ(both.missing, 0.125);
  EXPECT_EQ(both.extra, 0.0625);
  const LineErrors crumbs = compare({{{0, 1}, 0, 0.5 - 1e-9}, {{0, 1}, 0.75, 0.75 + 1e-9}});
  EXPECT_EQ(crumbs.missing, 0.0);
  EXPECT_EQ(crumbs.extra, 0.0);
  EXPECT_GT(compare({{{0, 1}, 0, 0.5 - 3e-9}}).missing, 1e-9);
  const LineErrors elsewhere = compare({{{0, 1}, 0, 0.5}, {{1, 1}, 0, 1}});
  EXPECT_EQ(elsewhere.missing, 0.0);
  EXPECT_EQ(elsewhere.extra, 0.75);
}

TEST(CompareLines, TakesAPieceForAnySharer) {
  Drawing drawing;
  drawing.polygon(rectangle(0, 0, 0.5, 1, 0)).polygon(rectangle(0.5, 0, 1, 1, 0));
  drawing.polygon(rectangle(0, 0, 1, 0.25, 1));
  const LineItems items(drawing.file());
  const std::vector<LineId> lines{{0, 2}};
  const auto truth = true_lines(items, lines);
  ASSERT_EQ(truth[0].visible, (Parts{{0.25, 1}}));
  for (const LinePiece& piece : std::vector<LinePiece>{{{0, 2}, 0.25, 1}, {{1, 0}, 0, 0.75}}) {
    const LineErrors errors = compare_lines(items, truth, std::vector{piece});
    EXPECT_EQ(errors.missing + errors.extra, 0.0);
    EXPECT_TRUE(judge_lines(items, lines, std::vector{piece}, 100, 1).wrong.empty());
  }
}

TEST(JudgeLines, FindsWhatIsMissingAndWhatIsExtra) {
  Drawing drawing;
  drawing.line({0, 0.5, 0}, {0.5, 0.5, 0}).polygon(rectangle(0.25, 0, 1, 1, 1));
  const LineItems items(drawing.file());
  const std::vector<LineId> lines{{0, 1}};
  const auto judge = [&](const std::vector<LinePiece>& claimed) {
    return judge_lines(items, lines, claimed, 1000, 7);
  };
  const LineJudgement right = judge({{{0, 1}, 0, 0.5}});
  EXPECT_EQ(right.samples, 1000u);
  EXPECT_TRUE(right.wrong.empty());
  const LineJudgement wrong = judge({{{0, 1}, 0.25, 0.75}});
  EXPECT_EQ(wrong.wrong.size(), 500u);
  EXPECT_TRUE(wrong.wrong.front().missing);
  EXPECT_FALSE(wrong.wrong.back().missing);
  EXPECT_EQ(wrong.wrong.front().line, (LineId{0, 1}));
  EXPECT_NEAR(wrong.errors.missing, 0.125, 1e-3);
  EXPECT_NEAR(wrong.errors.extra, 0.125, 1e-3);
  EXPECT_EQ(wrong.errors.length, 0.5);
}

TEST(JudgeLines, PlacesDoNotDependOnThreadsOrOtherLinesButOnTheSeed) {
  Drawing drawing;
  for (int k = 0; k < 50; ++k) drawing.polygon(rectangle(0.01 * k, 0, 1, 0.02 * k + 0.01, 0.1 * k));
  const LineItems items(drawing.file());
  const auto all = items.all_lines();
  const auto places = [&](std::span<const LineId> lines, std::uint64_t seed, int threads) {
    std::vector<double>
        at;  // of the line (7, 1): nothing is claimed, so its visible part is an error
    for (const WrongSample& s : judge_lines(items, lines, {}, 5, seed, threads).wrong) {
      if (s.line == LineId{49, 3}) at.push_back(s.at);
    }
    return at;
  };
  const auto at = places(all, 1, 1);
  EXPECT_EQ(at.size(), 5u);
  EXPECT_EQ(places(all, 1, 3), at);
  EXPECT_EQ(places(std::vector<LineId>{{49, 3}}, 1, 1), at);
  EXPECT_NE(places(all, 2, 1), at);
}

TEST(JudgeLines, FindsNothingWrongWithTheTruthAndEveryPieceTakenAwayOrAdded) {
  constexpr std::uint32_t kScenes = 2000 / kSlower / 3;
  std::size_t taken = 0, added = 0;
  for (std::uint32_t seed = 0; seed < kScenes; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const DisplayFile file = drawn(on_coarse_grid(seed));
    const LineItems items(file);
    const auto lines = items.all_lines();
    const auto truth = true_lines(items, lines);
    const auto judge = [&](const std::vector<LinePiece>& claimed) {
      return judge_lines(items, lines, claimed, 40, seed);
    };
    auto pieces = visible_pieces(truth);
    const LineJudgement right = judge(pieces);
    ASSERT_TRUE(right.wrong.empty());
    ASSERT_GT(right.samples, 39 * truth.size());

    const auto longest = std::ranges::max_element(
        pieces, {}, [](const LinePiece& piece) { return piece.to - piece.from; });
    if (longest != pieces.end() && longest->to - longest->from > 0.1) {
      const LinePiece gone = *longest;
      pieces.erase(longest);
      const LineJudgement judgement = judge(pieces);
      ASSERT_FALSE(judgement.wrong.empty());
      for (const WrongSample& s : judgement.wrong) {
        ASSERT_TRUE(s.missing && s.line == gone.line && gone.from <= s.at && s.at <= gone.to);
      }
      ASSERT_GT(compare_lines(items, truth, pieces).missing, 0.0);
      pieces.push_back(gone);
      ++taken;
    }
    const auto hidden = std::ranges::find(truth, Parts{}, &TrueLine::visible);
    if (hidden != truth.end()) {
      pieces.push_back({hidden->sharers.back(), 0.25, 0.5});
      const LineJudgement judgement = judge(pieces);
      ASSERT_EQ(judgement.wrong.size(), 10u);
      ASSERT_EQ(judgement.errors.missing, 0.0);
      ASSERT_NEAR(judgement.errors.extra, hidden->length / 4, 1e-12);
      ASSERT_NEAR(compare_lines(items, truth, pieces).extra, hidden->length / 4, 1e-12);
      ++added;
    }
  }
  EXPECT_GT(taken, 600u / test::kSlower);
  EXPECT_GT(added, 100u / test::kSlower);
}

}  // namespace
}  // namespace displayfile
