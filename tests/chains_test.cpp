// Pieces joined into chains (hidden/lines/chains.h): by hand, and their properties at random.

#include "hidden/lines/chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "tests/predicate_inputs.h"

namespace displayfile {
namespace {

using test::Source;

ChainLink link(const Point2& a, const Point2& b, std::uint64_t key = 0) {
  return {{a.x, a.y, 0.0}, {b.x, b.y, 0.0}, key};
}

/// Chains as numbers of pieces, with a minus sign where reversed.
std::string drawn(const std::vector<ChainLink>& pieces) {
  const Chains chains = chains_of(pieces);
  std::string text;
  for (std::size_t k = 0; k < chains.first.size(); ++k) {
    if (k > 0) text += " |";
    for (const auto& [piece, reversed] : chains.chain(k)) {
      if (!text.empty()) text += ' ';
      if (reversed) text += '-';
      text += std::to_string(piece);
    }
  }
  return text;
}

TEST(Chains, PiecesAreJoinedEndToEndEitherWay) {
  EXPECT_EQ(drawn({}), "");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0})}), "0");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}), link({1, 0}, {1, 1})}), "0 1");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}), link({1, 1}, {1, 0})}), "0 -1");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}), link({2, 2}, {3, 3}), link({5, 5}, {0, 0})}), "2 0 | 1");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}), link({-0.0, 0}, {0, 1})}), "-1 0");
}

TEST(Chains, EndsThatDifferInDepthOrKeyAreNotJoined) {
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}), {{1, 0, 0x1p-50}, {1, 1, 0}, 0}}), "0 | 1");
  EXPECT_EQ(drawn({link({0, 0}, {1, 0}, 1), link({1, 0}, {1, 1}, 2), link({1, 0}, {2, 0}, 1)}),
            "0 2 | 1");
}

TEST(Chains, ALoopIsClosedAndBeginsWithItsFirstPiece) {
  const std::vector<ChainLink> square{link({1, 1}, {0, 1}), link({0, 0}, {1, 0}),
                                      link({1, 1}, {1, 0}), link({0, 0}, {0, 1})};
  EXPECT_EQ(drawn(square), "0 -3 1 -2");
  EXPECT_EQ(drawn({link({0, 0}, {0, 0})}), "0");  // no longer than its rounding
}

TEST(Chains, AtAJunctionItGoesStraightOn) {
  const std::vector<ChainLink> cross{link({0, 0}, {1, 0}), link({0, 0}, {0.1, 1}),
                                     link({-1, 0.1}, {0, 0}), link({0, 0}, {0, -1})};
  EXPECT_EQ(drawn(cross), "2 0 | -3 1");
  // The bar of a T, whichever is first.
  EXPECT_EQ(drawn({link({0, -1}, {0, 0}), link({-1, 0}, {0, 0}), link({0, 0}, {1, 0})}), "0 | 1 2");
  // Depths turn nothing.
  const std::vector<ChainLink> steep{
      {{-1, 0, 5}, {0, 0, 0}, 0}, {{0, 0, 0}, {1, 0, 5}, 0}, {{0, 0, 0}, {1, 0.5, 0}, 0}};
  EXPECT_EQ(drawn(steep), "0 1 | 2");
}

// ---- Properties ---------------------------------------------------------------------------------

using Node = std::tuple<double, double, double, std::uint64_t>;
Node node(const Point3& p, std::uint64_t key) { return {p.x, p.y, p.z, key}; }

/// Describes the error in the chains; empty if they are correct.
std::string wrong(const std::vector<ChainLink>& pieces) {
  const Chains chains = chains_of(pieces);
  std::vector<int> drawn(pieces.size(), 0);
  std::map<Node, int> meeting, open;
  for (const ChainLink& piece : pieces) {
    ++meeting[node(piece.from, piece.key)];
    ++meeting[node(piece.to, piece.key)];
  }
  std::uint32_t first_before = 0;
  for (std::size_t k = 0; k < chains.first.size(); ++k) {
    const auto chain = chains.chain(k);
    if (chain.empty()) return "an empty chain";
    std::uint32_t first = chain[0].piece;
    Point3 pen(0.0);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const ChainLink& piece = pieces[chain[i].piece];
      ++drawn[chain[i].piece];
      if (piece.key != pieces[chain[0].piece].key) return "keys mixed";
      const Point3 from = chain[i].reversed ? piece.to : piece.from;
      if (i > 0 && from != pen) return "not end to end";
      pen = chain[i].reversed ? piece.from : piece.to;
      first = std::min(first, chain[i].piece);
    }
    for (const auto& [piece, reversed] : chain) {
      if (piece == first && reversed) return "the first piece runs backward";
    }
    if (k > 0 && first < first_before) return "not in order";
    first_before = first;
    const ChainLink& begin = pieces[chain[0].piece];
    const Point3 start = chain[0].reversed ? begin.to : begin.from;
    if (start == pen && chain[0].piece == first) continue;  // it may be closed
    ++open[node(start, begin.key)];
    ++open[node(pen, begin.key)];
  }
  for (const int times : drawn) {
    if (times != 1) return "a piece not drawn once";
  }
  for (const auto& [at, ends] : meeting) {
    const auto found = open.find(at);
    if ((found == open.end() ? 0 : found->second) > ends % 2) return "a chain could go on";
  }
  return "";
}

TEST(Chains, EachPieceIsDrawnOnceAndNoChainCouldGoOn) {
  for (int seed = 0; seed < 2000; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    const int grid = s.between(1, 6), keys = s.between(1, 3), many = s.between(0, 60);
    std::vector<ChainLink> pieces;
    for (int k = 0; k < many; ++k) {
      const auto at = [&] { return Point3(s.between(0, grid), s.between(0, grid), s.below(2)); };
      const Point3 a = at(), b = at();
      pieces.push_back({a, b, static_cast<std::uint64_t>(s.below(keys))});
    }
    ASSERT_EQ(wrong(pieces), "") << seed;
    ASSERT_EQ(chains_of(pieces).places.size(), pieces.size());
  }
}

TEST(Chains, WhereVeryManyMeetEachGoesOnOppositeInLittleTime) {
  std::vector<ChainLink> star;
  constexpr int kMany = 100'000;
  for (int k = 0; k < kMany; ++k) {
    const auto turn = static_cast<double>(k * std::int64_t{7919} % kMany) / kMany;
    const double angle = 2.0 * std::numbers::pi * turn;
    star.push_back({{0, 0, 0}, {std::cos(angle), std::sin(angle), 0}, 0});
  }
  const Chains chains = chains_of(star);
  ASSERT_EQ(chains.first.size(), std::size_t{kMany / 2});
  for (std::size_t k = 0; k < chains.first.size(); ++k) {
    const auto chain = chains.chain(k);
    ASSERT_EQ(chain.size(), 2u);
    const Point3 &a = star[chain[0].piece].to, &b = star[chain[1].piece].to;
    ASSERT_LT(a.x * b.x + a.y * b.y, -0.999);
  }
}

}  // namespace
}  // namespace displayfile
