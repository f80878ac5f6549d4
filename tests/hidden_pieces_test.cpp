// Lines where they are hidden (hidden/lines/hidden_pieces.h): with the visible pieces they make up
// the whole line; covered pieces are left out, on cases solved by hand and against all pairs.

#include "hidden/lines/hidden_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hidden/lines/line_ends.h"
#include "hidden/lines/lines_on_lines.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

struct Found {
  std::vector<LineName> lines;
  SeenLines seen;
  std::vector<HiddenPiece> hidden, left;
};
Found found(const ItemList& list, HiddenMethod method = HiddenMethod::franklin) {
  Found all;
  all.lines = drawn_lines(list.view());
  all.seen = visible_lines(list.view(), all.lines, {.method = method});
  all.hidden = hidden_pieces(all.lines, all.seen);
  all.left = uncovered_pieces(list.view(), all.seen, all.hidden);
  return all;
}

bool in_order(const VisiblePiece& a, const VisiblePiece& b) {
  return std::tie(a.item, a.corner, a.from) < std::tie(b.item, b.corner, b.from);
}

std::string described(std::vector<VisiblePiece> pieces) {
  std::ranges::sort(pieces, in_order);
  std::ostringstream out;
  out.precision(17);
  for (const auto& [item, corner, from, to] : pieces) {
    out << item << ":" << corner << " " << from << " " << to << "\n";
  }
  return out.str();
}

// ---- Hidden pieces ------------------------------------------------------------------------------

/// Bit for bit: each line begins at 0, each piece where the one before ends, and the last at 1.
TEST(HiddenPieces, TileEveryLineWithWhatIsSeen) {
  for_each_scene_of_families(60 / kSlower, [](const ItemList& list, const auto& name, int seed) {
    for (const HiddenMethod method : {HiddenMethod::roberts, HiddenMethod::franklin}) {
      const Found all = found(list, method);
      std::vector<VisiblePiece> pieces = all.seen.pieces;
      pieces.insert(pieces.end(), all.hidden.begin(), all.hidden.end());
      std::ranges::sort(pieces, in_order);
      auto piece = pieces.begin();
      for (const LineName& line : all.lines) {
        double at = 0.0;
        for (; piece != pieces.end() && LineName{piece->item, piece->corner} == line; ++piece) {
          ASSERT_EQ(piece->from, at) << name << " " << seed;
          ASSERT_LT(piece->from, piece->to);
          at = piece->to;
        }
        ASSERT_EQ(at, 1.0) << name << " " << seed << "\n" << list.text();
      }
      ASSERT_EQ(piece, pieces.end());
    }
  });
}

// ---- Covered pieces, by hand --------------------------------------------------------------------

Loop box(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// The parts left of the last item, a line, behind a square that covers x from 0 to 1.
std::vector<std::pair<double, double>> left_of_line(const std::vector<Loop>& before,
                                                    const Point3& a, const Point3& b) {
  ItemList list;
  list.add(ItemList::Kind::solid, box(0.0, 0.0, 1.0, 1.0, 0.5), {0, 0, 0, 0});
  for (const Loop& line : before) list.line(line[0], line[1]);
  list.line(a, b);
  std::vector<std::pair<double, double>> parts;
  for (const HiddenPiece& piece : found(list).left) {
    if (piece.item + 1 == list.items.size()) parts.emplace_back(piece.from, piece.to);
  }
  return parts;
}
using Shares = std::vector<std::pair<double, double>>;

TEST(UncoveredPieces, WhatALineBeforeCoversIsLeftOut) {
  const Point3 a(0.125, 0.25, 0.25), b(0.625, 0.75, 0.25);  // rises at 45 degrees
  EXPECT_EQ(left_of_line({}, a, b), (Shares{{0.0, 1.0}}));
  const auto near = [](double x0, double x1) {
    return Loop{{x0, x0 + 0.125, 0.75}, {x1, x1 + 0.125, 0.875}};
  };
  EXPECT_EQ(left_of_line({near(0.125, 0.625)}, a, b), Shares{});
  EXPECT_EQ(left_of_line({near(0.625, 0.125)}, a, b), Shares{});
  EXPECT_EQ(left_of_line({near(0.0, 1.0)}, a, b), Shares{});
  EXPECT_EQ(left_of_line({near(0.0, 0.25)}, a, b), (Shares{{0.25, 1.0}}));
  EXPECT_EQ(left_of_line({near(0.25, 0.375)}, b, a), (Shares{{0.0, 0.5}, {0.75, 1.0}}));
  EXPECT_EQ(left_of_line({near(0.25, 0.375), near(0.375, 0.5)}, a, b),
            (Shares{{0.0, 0.25}, {0.75, 1.0}}));
  EXPECT_EQ(left_of_line({near(0.625, 0.75)}, a, b), (Shares{{0.0, 1.0}}));  // touches its end
  // Beside it by as little as can be, and by more than may be.
  for (const auto& [off, left] : std::vector<std::pair<double, Shares>>{
           {0x1p-54, {}}, {1e-12, {}}, {9e-10, {}}, {1e-8, {{0.0, 1.0}}}, {1e-4, {{0.0, 1.0}}}}) {
    Loop beside = near(0.125, 0.625);
    for (Point3& p : beside) p += Point3(-off, off, 0.0) / std::numbers::sqrt2;
    EXPECT_EQ(left_of_line({beside}, a, b), left) << off;
  }
}

TEST(UncoveredPieces, OfHiddenOnesThatCoverEachOtherTheFirstIsDrawn) {
  const Point3 a(0.125, 0.5, 0.25), b(0.625, 0.5, 0.25);
  const auto behind = [](double x0, double x1, double z) {
    return Loop{{x0, 0.5, z}, {x1, 0.5, z}};
  };
  for (const double z : {0.125, 0.375}) {  // farther or nearer
    EXPECT_EQ(left_of_line({behind(0.125, 0.625, z)}, a, b), Shares{});
    EXPECT_EQ(left_of_line({behind(0.0, 0.25, z)}, a, b), (Shares{{0.25, 1.0}}));
    EXPECT_EQ(left_of_line({behind(0.25, 0.5, z)}, a, b), (Shares{{0.0, 0.25}, {0.75, 1.0}}));
  }
}

/// A cube seen along an axis: the back is right behind the front.
TEST(UncoveredPieces, OfACubeSeenAlongAnAxisNothingHiddenIsLeft) {
  ItemList list;
  const Loop front = box(0.25, 0.25, 0.75, 0.75, 0.75), back = box(0.25, 0.25, 0.75, 0.75, 0.25);
  list.solid(front);
  list.solid({back[3], back[2], back[1], back[0]});
  for (std::size_t k = 0; k < 4; ++k) {
    list.solid({front[k], back[k], back[(k + 1) % 4], front[(k + 1) % 4]});
  }
  list.solid(box(0.0, 0.0, 1.0, 1.0, 0.875));  // a sheet hides it all
  const Found all = found(list);
  EXPECT_EQ(all.hidden.size(), 8u);
  EXPECT_EQ(described(all.left), "0:0 0 1\n0:1 0 1\n0:2 0 1\n0:3 0 1\n");
}

/// Lines that fall at 45 degrees, and those that run along an axis, either way.
TEST(UncoveredPieces, WhicheverWayLinesRun) {
  const Point2 ways[] = {{1, 0},   {-1, 0}, {0, 1},    {0, -1},    {1, 1},
                         {-1, -1}, {1, -1}, {-1, 1},   {4, -3},    {3, -4},
                         {-4, 3},  {-3, 4}, {1024, 1}, {-1024, 1}, {1, 1024}};
  for (const Point2& way : ways) {
    const Point2 along = way * (0x1p-4 / std::max(std::abs(way.x), std::abs(way.y)));
    const auto at = [&](double t, double z) {
      return Point3(0.5 + t * along.x, 0.5 + t * along.y, z);
    };
    const Loop near{at(-1.0, 0.75), at(1.0, 0.75)};
    EXPECT_EQ(left_of_line({near}, at(-2.0, 0.25), at(2.0, 0.25)),
              (Shares{{0.0, 0.25}, {0.75, 1.0}}))
        << way.x << " " << way.y;
    EXPECT_EQ(left_of_line({{near[1], near[0]}}, at(-1.0, 0.25), at(2.0, 0.25)),
              (Shares{{2.0 / 3.0, 1.0}}));
  }
}

// ---- Pieces covered up to rounding --------------------------------------------------------------

/// Lines on one line, each end off it by no more than a given distance; hidden by a square, except
/// for some visible ones.
struct NearLines {
  ItemList list;
  std::vector<Point2> ways;  // of each item, its ends as places along the line

  NearLines(std::uint64_t seed, double off) {
    Source s(seed);
    list.add(ItemList::Kind::solid, box(-1.0, -1.0, 2.0, 2.0, 0.5), {0, 0, 0, 0});
    ways.emplace_back(0.0);
    const auto part = [&] { return s.between(0, 1 << 20) * 0x1p-20; };
    constexpr double kTurns[] = {0.0, 0.25, 0.5, 0.75, 0.125, 0.375};  // axes, and in between
    const double turn = s.below(2) == 0 ? kTurns[s.below(6)] : part();
    const double angle = 2.0 * std::numbers::pi * turn;
    const Point2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const Point2 middle(0.4 + 0.2 * part(), 0.4 + 0.2 * part());
    for (int k = 0; k < 8; ++k) {
      const double from = part() - 0.5, length = std::pow(0.1, 2.0 * part());
      const double to = s.below(2) == 0 ? from + length : from - length;
      const double z = s.below(4) == 0 ? 0.75 : 0.25 * part();
      const auto at = [&](double t) {
        return Point3(middle + t * along + off * (2.0 * part() - 1.0) * across, z);
      };
      list.line(at(from), at(to));
      ways.emplace_back(from, to);
    }
  }

  struct Stretch {
    double low, high;
    bool is_hidden;
  };
  /// The pieces along the line.
  std::vector<Stretch> along(std::span<const VisiblePiece> pieces, bool is_hidden) const {
    std::vector<Stretch> all;
    for (const VisiblePiece& piece : pieces) {
      if (piece.item == 0) continue;
      const Point2& way = ways[piece.item];
      const auto at = [&](double share) { return way.x + share * (way.y - way.x); };
      const auto [low, high] = std::minmax({at(piece.from), at(piece.to)});
      all.push_back({low, high, is_hidden});
    }
    return all;
  }
};

double length_of_union(std::vector<NearLines::Stretch> all) {
  std::ranges::sort(all, {}, &NearLines::Stretch::low);
  double length = 0.0, end = -10.0;
  for (const auto& [low, high, is_hidden] : all) {
    length += std::max(0.0, high - std::max(low, end));
    end = std::max(end, high);
  }
  return length;
}

/// Whatever covers whatever, no dash is over another, nor over visible pieces, and none is missing.
TEST(UncoveredPieces, OfLinesThatAreOneButForRoundingOneIsDrawn) {
  constexpr double kCrumbs = 1e-7;
  std::size_t covered = 0;
  for (const double off : {0.0, 1e-16, 1e-12, 4e-10}) {
    for (std::uint64_t seed = 0; seed < 400 / kSlower; ++seed) {
      const NearLines lines(seed, off);
      const Found all = found(lines.list);
      std::vector<NearLines::Stretch> drawn = lines.along(all.left, true);
      double of_left = 0.0;
      for (const auto& piece : drawn) of_left += piece.high - piece.low;
      const auto seen = lines.along(all.seen.pieces, false), hidden = lines.along(all.hidden, true);
      const double of_seen = length_of_union(seen);
      auto every = hidden;
      every.insert(every.end(), seen.begin(), seen.end());
      ASSERT_NEAR(of_seen + of_left, length_of_union(every), kCrumbs) << off << " " << seed;
      drawn.insert(drawn.end(), seen.begin(), seen.end());
      ASSERT_NEAR(length_of_union(drawn), length_of_union(every), kCrumbs) << off << " " << seed;
      covered += all.left.size() < all.hidden.size() ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 400U / kSlower);
}

/// Each is drawn whole where it is hidden.
TEST(UncoveredPieces, OfLinesThatArePlainlyApartEachIsDrawn) {
  for (const double off : {1e-3, 1e-5}) {
    for (std::uint64_t seed = 0; seed < 100 / kSlower; ++seed) {
      const Found all = found(NearLines(seed, off).list);
      ASSERT_EQ(described(all.left), described(all.hidden)) << off << " " << seed;
    }
  }
}

/// Also of many lines of many lengths and directions, any of which may be on each other.
TEST(LeadingLines, AreFoundAsAmongAllPairs) {
  for (std::uint64_t seed = 0; seed < 60 / kSlower; ++seed) {
    Source s(seed);
    std::vector<LineOfPicture> lines;
    const auto part = [&] { return s.between(0, 1 << 20) * 0x1p-20; };
    for (int k = 0; k < 60; ++k) {
      const double angle = std::numbers::pi * (s.below(3) == 0 ? 0.25 * s.below(9) : part());
      const Point2 along(std::cos(angle), std::sin(angle)), at(part(), part());
      for (int copies = s.between(1, 4); copies > 0; --copies) {
        const double from = part() - 0.5, to = from + std::pow(10.0, -4.0 * part());
        const Point2 a = at + from * along, b = at + to * along;
        s.below(2) == 0 ? lines.push_back({a, b}) : lines.push_back({b, a});
      }
    }
    std::vector<std::uint32_t> order(lines.size()), leaders;
    std::iota(order.begin(), order.end(), 0U);
    const auto length = [&](std::uint32_t k) {
      return std::hypot(lines[k].to.x - lines[k].from.x, lines[k].to.y - lines[k].from.y);
    };
    std::ranges::stable_sort(order, std::greater(), length);
    const auto found = leading_lines(lines);
    std::size_t followers = 0;
    for (const std::uint32_t line : order) {
      const auto follows = [&](std::uint32_t leader) {
        const Point2 from = lines[leader].from, to = lines[leader].to;
        const auto off = [&](const Point2& p) {
          const double twice_area =
              (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
          return std::abs(twice_area) / length(leader);
        };
        return off(lines[line].from) < 1e-12 && off(lines[line].to) < 1e-12;
      };
      const auto first = std::ranges::find_if(leaders, follows);
      ASSERT_EQ(found[line], first == leaders.end() ? line : *first) << seed << " " << line;
      followers += first == leaders.end() ? 0 : 1;
      if (first == leaders.end()) leaders.push_back(line);
    }
    ASSERT_GT(followers, 40U);
  }
  EXPECT_TRUE(leading_lines({}).empty());
}

/// By the definition, of lines that are as far apart as files round them.
TEST(LeadingLines, WithinReachAreThoseOfTheDefinition) {
  std::size_t followers = 0;
  for (std::uint64_t seed = 0; seed < 60 / kSlower; ++seed) {
    Source s(seed);
    const double apart = std::pow(10.0, -3.0 - 3.0 * s.unit());
    const double most_turned = std::max(0x1p-16, 64.0 * apart);
    std::vector<LineOfPicture> lines;
    for (int k = 0; k < 100; ++k) {
      const double angle = std::numbers::pi * (s.below(3) == 0 ? 0.25 * s.below(9) : s.unit());
      const Point2 along(std::cos(angle), std::sin(angle)), at(s.unit(), s.unit());
      for (int copies = s.between(1, 4); copies > 0; --copies) {
        const auto near = [&](double share) {
          return at + share * along + 2.0 * apart * Point2(s.unit() - 0.5, s.unit() - 0.5);
        };
        const double from = s.unit() - 0.5, to = from + std::pow(10.0, -3.0 * s.unit());
        lines.push_back({near(from), near(to)});
      }
    }
    std::vector<std::uint32_t> order(lines.size()), leaders;
    std::iota(order.begin(), order.end(), 0U);
    const auto length = [&](std::uint32_t k) {
      return std::hypot(lines[k].to.x - lines[k].from.x, lines[k].to.y - lines[k].from.y);
    };
    std::ranges::stable_sort(order, std::greater(), length);
    const auto found = leading_lines(lines, apart);
    for (const std::uint32_t line : order) {
      const double allowed = std::min(apart, 0.5 * most_turned * length(line));
      const auto follows = [&](std::uint32_t leader) {
        const Point2 way = (lines[leader].to - lines[leader].from) / length(leader);
        const auto is_near = [&](const Point2& p) {
          const Point2 off = p - lines[leader].from;
          const double place = (way.x * off.x + way.y * off.y) / length(leader);
          const double beyond = std::clamp(std::max(-place, place - 1.0), 0.0, 1.0);
          return std::abs(way.x * off.y - way.y * off.x) <= allowed * (1.0 + 2.0 * beyond);
        };
        return is_near(lines[line].from) && is_near(lines[line].to);
      };
      const auto first = std::ranges::find_if(leaders, follows);
      ASSERT_EQ(found[line], first == leaders.end() ? line : *first) << seed << " " << line;
      followers += first == leaders.end() ? 0 : 1;
      if (first == leaders.end()) leaders.push_back(line);
    }
  }
  EXPECT_GT(followers, 1000U / kSlower);
}

// ---- Covered pieces, against all pairs ----------------------------------------------------------

/// Twice the area, over the length of the first two, of a line and a point.
double off_line(const Point3& from, const Point3& to, const Point3& p) {
  const double area = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  return std::abs(area) / std::hypot(to.x - from.x, to.y - from.y);
}

/// The same by comparing each hidden piece with each other piece, of lines that are one up to
/// rounding or plainly apart.
std::vector<HiddenPiece> left_by_all_pairs(const ItemList& list, const Found& all) {
  std::vector<HiddenPiece> left;
  for (const HiddenPiece& piece : all.hidden) {
    const LineEnds own(list.view(), {piece.item, piece.corner});
    std::vector<std::pair<double, double>> covered;
    const auto cover = [&](const VisiblePiece& other) {
      const LineEnds ends(list.view(), {other.item, other.corner});
      constexpr double kRounding = 1e-13;
      if (off_line(own.from, own.to, ends.from) > kRounding) return;
      if (off_line(own.from, own.to, ends.to) > kRounding) return;
      const Point3 way = glm::abs(own.to - own.from);
      const int axis = way.x >= way.y ? 0 : 1;
      const auto share = [&](const Point3& p) {
        return (p[axis] - own.from[axis]) / (own.to[axis] - own.from[axis]);
      };
      covered.push_back(std::minmax({share(ends.at(other.from)), share(ends.at(other.to))}));
    };
    const auto other_line = [&](const VisiblePiece& other) {
      return other.item != piece.item || other.corner != piece.corner;
    };
    for (const VisiblePiece& other : all.seen.pieces) {
      if (other_line(other)) cover(other);
    }
    for (const HiddenPiece& other : all.hidden) {
      if (other_line(other) && in_order(other, piece)) cover(other);
    }
    std::ranges::sort(covered);
    double from = piece.from;
    for (const auto& [low, high] : covered) {
      if (low > from) left.push_back({piece.item, piece.corner, from, std::min(low, piece.to)});
      from = std::max(from, high);
      if (from >= piece.to) break;
    }
    if (from < piece.to) left.push_back({piece.item, piece.corner, from, piece.to});
  }
  return left;
}

/// Rounded to far below what is visible, with crumbs left out and touching pieces joined.
std::string rounded(std::vector<HiddenPiece> pieces) {
  std::ranges::sort(pieces, in_order);
  std::vector<HiddenPiece> joined;
  for (const HiddenPiece& piece : pieces) {
    const double from = std::round(piece.from * 1e9) / 1e9, to = std::round(piece.to * 1e9) / 1e9;
    if (!(from < to)) continue;
    if (!joined.empty() && joined.back().item == piece.item &&
        joined.back().corner == piece.corner && joined.back().to == from) {
      joined.back().to = to;
    } else {
      joined.push_back({piece.item, piece.corner, from, to});
    }
  }
  return described(joined);
}

TEST(UncoveredPieces, AsByAllPairsInEveryFamily) {
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < 60 / kSlower; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      const Found all = found(list);
      ASSERT_EQ(rounded(all.left), rounded(left_by_all_pairs(list, all)))
          << family.name << " " << k << "\n"
          << list.text();
    }
  }
}

/// Many pieces on few lines, any direction: whole multiples of whole steps, so that they are in
/// line exactly, and some an ulp beside.
TEST(UncoveredPieces, AsByAllPairsOnFewLines) {
  for (int k = 0; k < 300 / kSlower; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    list.add(ItemList::Kind::solid, box(0.0, 0.0, 1.0, 1.0, 0.5), {0, 0, 0, 0});
    for (int line = 0; line < 3; ++line) {
      const int dx = s.between(-20, 20), dy = s.between(-20, 20);
      const int x = s.between(400, 600), y = s.between(400, 600);
      if (dx == 0 && dy == 0) continue;
      for (int piece = 0; piece < 12; ++piece) {
        const auto at = [&](int t, double z) {
          return Point3((x + t * dx) / 1024.0, (y + t * dy) / 1024.0, z);
        };
        const int from = s.between(-18, 18), to = s.between(-18, 18);
        Point3 a = at(from, s.below(3) == 0 ? 0.75 : 0.25),
               b = at(to, s.below(3) == 0 ? 0.75 : 0.25);
        if (s.below(8) == 0) a.y = std::nextafter(a.y, 2.0);
        if (from != to) list.line(a, b);
      }
    }
    const Found all = found(list);
    ASSERT_EQ(rounded(all.left), rounded(left_by_all_pairs(list, all))) << k << "\n" << list.text();
  }
}

TEST(UncoveredPieces, ScalingByTwoChangesNothing) {
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < 30 / kSlower; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      ItemList list = family.make(s);
      const std::string plain = described(found(list).left);
      for (Point3& p : list.points) p *= 2.0;
      ASSERT_EQ(described(found(list).left), plain) << family.name << " " << k;
    }
  }
}

}  // namespace
}  // namespace displayfile
