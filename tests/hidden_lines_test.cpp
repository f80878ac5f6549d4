// Hidden lines (hidden/lines/visible_lines.h): worked by hand, against the truth, and the methods
// against each other.

#include "hidden/lines/visible_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "tests/from_environment.h"
#include "tests/line_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

constexpr HiddenMethod kMethods[] = {HiddenMethod::roberts, HiddenMethod::appel,
                                     HiddenMethod::franklin, HiddenMethod::plain_appel};

/// All sides and lines, drawn or not.
std::vector<LineName> all_lines(const ItemList& list) {
  ItemList drawn = list;
  std::ranges::fill(drawn.visible, std::uint8_t{1});
  return drawn_lines(drawn.view());
}

std::vector<VisiblePiece> pieces(const ItemList& list, HiddenMethod method,
                                 const SurfacePlan& options = {}) {
  return visible_lines(list.view(), all_lines(list), options.by(method)).pieces;
}

std::string text(std::span<const VisiblePiece> pieces) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& [item, corner, from, to] : pieces) {
    out << item << ":" << corner << " " << from << " " << to << "\n";
  }
  return out.str();
}

// ---- Worked by hand -----------------------------------------------------------------------------

/// The parts of the last item of a list that are seen, the corner 1's; the same by each method.
std::vector<std::pair<double, double>> seen(const ItemList& list, std::uint32_t corner = 1) {
  std::vector<std::pair<double, double>> parts;
  const auto item = static_cast<std::uint32_t>(list.items.size() - 1);
  for (const HiddenMethod method : kMethods) {
    std::vector<std::pair<double, double>> found;
    const LineName line{item, corner};
    for (const auto& piece : visible_lines(list.view(), {&line, 1}, {.method = method}).pieces) {
      found.emplace_back(piece.from, piece.to);
    }
    if (method == kMethods[0]) parts = found;
    EXPECT_EQ(found, parts) << name_of(method);
  }
  return parts;
}
using Parts = std::vector<std::pair<double, double>>;
const Parts kAll{{0.0, 1.0}}, kNothing{};

/// The visible parts of the line among these.
Parts line_among(const std::vector<Loop>& loops, const Point3& a, const Point3& b) {
  ItemList list;
  for (const Loop& loop : loops) list.solid(loop);
  list.line(a, b);
  return seen(list);
}

const Loop kSquare = square(0.25, 0.25, 0.75, 0.75, 0.5);

TEST(HiddenLines, BehindBeforeAndHalfBehindASquare) {
  EXPECT_EQ(line_among({kSquare}, {0.3, 0.4, 0.2}, {0.7, 0.6, 0.2}), kNothing);
  EXPECT_EQ(line_among({kSquare}, {0.3, 0.4, 0.8}, {0.7, 0.6, 0.8}), kAll);
  EXPECT_EQ(line_among({kSquare}, {0.5, 0.5, 0.2}, {1.0, 0.5, 0.2}), (Parts{{0.5, 1.0}}));
  EXPECT_EQ(line_among({kSquare}, {0.0, 0.5, 0.2}, {1.0, 0.5, 0.2}),
            (Parts{{0.0, 0.25}, {0.75, 1.0}}));
  EXPECT_EQ(line_among({kSquare}, {0.0, 0.1, 0.2}, {1.0, 0.1, 0.2}), kAll);
}

TEST(HiddenLines, ThroughASquareItIsSeenFromWhereItComesOut) {
  EXPECT_EQ(line_among({kSquare}, {0.375, 0.5, 0.25}, {0.625, 0.5, 0.75}), (Parts{{0.5, 1.0}}));
  EXPECT_EQ(line_among({kSquare}, {0.0, 0.5, 0.0}, {1.0, 0.5, 1.0}),
            (Parts{{0.0, 0.25}, {0.5, 1.0}}));
}

TEST(HiddenLines, BehindASharedEdgeItIsHiddenBehindAnOutlineSeen) {
  const Loop left = square(0.0, 0.0, 0.5, 1.0, 0.5), right = square(0.5, 0.0, 1.0, 1.0, 0.5);
  const Point3 a(0.5, 0.25, 0.2), b(0.5, 0.75, 0.2);
  EXPECT_EQ(line_among({left, right}, a, b), kNothing);
  EXPECT_EQ(line_among({left}, a, b), kAll);
  EXPECT_EQ(line_among({right}, a, b), kAll);
  // Not with different depths, and not with different lengths.
  EXPECT_EQ(line_among({left, square(0.5, 0.0, 1.0, 0.5, 0.9)}, a, b), (Parts{{0.5, 1.0}}));
}

TEST(HiddenLines, OnTheOutlineOfANearerSquareItIsSeen) {
  ItemList list;
  list.solid(kSquare);
  list.solid(square(0.25, 0.25, 0.5, 0.5, 0.25));
  EXPECT_EQ(seen(list, 1), kAll);  // along the bottom
  EXPECT_EQ(seen(list, 2), kNothing);
  EXPECT_EQ(seen(list, 3), kNothing);
  EXPECT_EQ(seen(list, 0), kAll);
}

TEST(HiddenLines, CoplanarLinesAndEdgesOfPolygonsAreSeen) {
  EXPECT_EQ(line_among({kSquare}, {0.3, 0.3, 0.5}, {0.9, 0.6, 0.5}), kAll);
  ItemList list;
  list.solid(kSquare);
  list.solid(square(0.0, 0.3, 1.0, 0.4, 0.5));
  for (std::uint32_t corner = 0; corner < 4; ++corner) EXPECT_EQ(seen(list, corner), kAll);
}

TEST(HiddenLines, EdgeOnPolygonsHollowOnesAndLinesHideNothing) {
  const Loop edge_on{{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}, {0.75, 0.5, 1.0}, {0.25, 0.5, 1.0}};
  EXPECT_EQ(line_among({edge_on}, {0.0, 0.5, 0.5}, {1.0, 0.5, 0.5}), kAll);
  ItemList list;
  list.hollow(kSquare);
  list.line({0.0, 0.5, 0.9}, {1.0, 0.5, 0.9});
  list.line({0.0, 0.5, 0.1}, {1.0, 0.5, 0.1});
  EXPECT_EQ(seen(list), kAll);
}

TEST(HiddenLines, SidesOfEdgeOnPolygonsHaveTheirOwnDepth) {
  ItemList list;
  list.solid(kSquare);
  list.solid({{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}, {0.75, 0.5, 1.0}, {0.25, 0.5, 1.0}});
  EXPECT_EQ(seen(list, 1), kNothing);
  EXPECT_EQ(seen(list, 3), kAll);
  EXPECT_EQ(seen(list, 2), kNothing);  // a point in the projection: it has no pieces
}

TEST(HiddenLines, SelfCrossingPolygonsCoverByEvenOdd) {
  const Loop bow_tie{{0.0, 0.0, 0.5}, {1.0, 1.0, 0.5}, {1.0, 0.0, 0.5}, {0.0, 1.0, 0.5}};
  EXPECT_EQ(line_among({bow_tie}, {0.0, 0.25, 0.1}, {1.0, 0.25, 0.1}), (Parts{{0.25, 0.75}}));
  EXPECT_EQ(line_among({bow_tie}, {0.5, 0.0, 0.1}, {0.5, 1.0, 0.1}), kAll);
  // The middle of a pentagram is covered twice.
  Loop star;
  for (int k = 0; k < 5; ++k) {
    const double angle = std::numbers::pi * (0.5 + 0.8 * k);
    star.push_back({0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle), 0.5});
  }
  EXPECT_EQ(line_among({star}, {0.45, 0.5, 0.1}, {0.55, 0.5, 0.1}), kAll);
  EXPECT_EQ(line_among({star}, {0.49, 0.9, 0.1}, {0.51, 0.9, 0.1}), kNothing);
}

TEST(HiddenLines, ConcavePolygonsAndRepeatedVertices) {
  const Loop notched{{0.0, 0.0, 0.5},  {1.0, 0.0, 0.5},  {1.0, 1.0, 0.5},  {0.75, 1.0, 0.5},
                     {0.75, 0.5, 0.5}, {0.25, 0.5, 0.5}, {0.25, 1.0, 0.5}, {0.0, 1.0, 0.5}};
  EXPECT_EQ(line_among({notched}, {0.0, 0.75, 0.1}, {1.0, 0.75, 0.1}), (Parts{{0.25, 0.75}}));
  EXPECT_EQ(line_among({notched}, {0.0, 0.5, 0.1}, {1.0, 0.5, 0.1}), (Parts{{0.25, 0.75}}));
  const Loop again{kSquare[0], kSquare[0], kSquare[1], kSquare[0],
                   kSquare[1], kSquare[2], kSquare[2], kSquare[3]};
  EXPECT_EQ(line_among({again}, {0.0, 0.5, 0.2}, {1.0, 0.5, 0.2}),
            (Parts{{0.0, 0.25}, {0.75, 1.0}}));
  EXPECT_EQ(line_among({again}, {0.0, 0.25, 0.2}, {1.0, 0.25, 0.2}), kAll);
}

TEST(HiddenLines, PolygonsThatShareASideShowItWhereOneDoes) {
  // The quadrilateral's fourth vertex is off its plane, so that its sides there lie elsewhere than
  // the triangle's. A sheet goes between the two depths.
  const Point3 a(0.25, 0.5, 0.5), b(0.75, 0.75, 0.75), c(0.25, 1.0, 0.5), d(0.75, 1.0, 0.5);
  ItemList list;
  list.solid({c, a, d, b});  // p, q, r are among the first three
  list.solid({a, Point3(0.75, 0.0, 0.75), b});
  list.solid(square(0.0, 0.0, 1.0, 1.0, 0.9));
  const LineItems items(entered(list));
  for (const HiddenMethod method : kMethods) {
    for (const LineName& line : all_lines(list)) {
      const SeenLines found = visible_lines(list.view(), {&line, 1}, {.method = method});
      const LineId id{line.item, line.corner};
      const LineErrors errors =
          compare_lines(items, true_lines(items, {&id, 1}), claimed_pieces(found));
      EXPECT_EQ(errors.missing + errors.extra, 0.0) << name_of(method);
    }
  }
}

TEST(HiddenLines, ACycleOfThreeHidesAPartOfEach) {
  ItemList list;
  add_ring_of_bars(list, 3);
  for (const HiddenMethod method : kMethods) {
    const auto found = pieces(list, method);
    for (std::uint32_t bar = 0; bar < 3; ++bar) {
      for (const std::uint32_t along : {1u, 3u}) {
        const auto count = std::ranges::count_if(
            found, [&](const VisiblePiece& p) { return p.item == bar && p.corner == along; });
        EXPECT_GE(count, 1);
        EXPECT_FALSE(std::ranges::any_of(found, [&](const VisiblePiece& p) {
          return p.item == bar && p.corner == along && p.from == 0.0 && p.to == 1.0;
        }));
      }
    }
  }
}

TEST(HiddenLines, TouchingCubesSeenAlongAnAxis) {
  ItemList list;
  const auto cube = [&](double x, double y, double z) {
    const auto at = [&](int i, int j, int k) {
      return Point3(x + 0.25 * i, y + 0.25 * j, z + 0.25 * k);
    };
    list.solid({at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
    list.solid({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
    list.solid({at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
    list.solid({at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)});
    list.solid({at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)});
    list.solid({at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
  };
  cube(0.25, 0.25, 0.25);
  cube(0.5, 0.25, 0.25);
  for (const HiddenMethod method : kMethods) {
    for (const VisiblePiece& piece : pieces(list, method)) {
      EXPECT_EQ(piece.from, 0.0);
      EXPECT_EQ(piece.to, 1.0);
    }
    // Along the wall between the cubes the hind edges have a front face before each side.
    const auto found = pieces(list, method);
    const auto is_seen = [&](std::uint32_t item, std::uint32_t corner) {
      return std::ranges::any_of(
          found, [&](const VisiblePiece& p) { return p.item == item && p.corner == corner; });
    };
    EXPECT_TRUE(is_seen(0, 1));   // on the outline, behind the front edge
    EXPECT_FALSE(is_seen(0, 3));  // behind the front edge that both cubes have
    EXPECT_TRUE(is_seen(1, 2));
  }
}

TEST(HiddenLines, SheetsNearlyCoplanarAreToldApart) {
  const double z = 0.5, up = std::nextafter(z, 1.0), down = std::nextafter(z, 0.0);
  const Point3 a(0.3, 0.4, z), b(0.7, 0.6, z);
  EXPECT_EQ(line_among({square(0.25, 0.25, 0.75, 0.75, up)}, a, b), kNothing);
  EXPECT_EQ(line_among({square(0.25, 0.25, 0.75, 0.75, down)}, a, b), kAll);
  // With ROUNDOFF the depths are equal.
  ItemList list;
  list.solid(square(0.25, 0.25, 0.75, 0.75, z + 1e-12));
  list.line(a, b);
  const LineName line{1, 1};
  for (const HiddenMethod method : kMethods) {
    SurfacePlan options;
    EXPECT_TRUE(visible_lines(list.view(), {&line, 1}, options.by(method)).pieces.empty());
    options.precision.exact = false;
    EXPECT_EQ(visible_lines(list.view(), {&line, 1}, options.by(method)).pieces.size(), 1u);
  }
}

TEST(HiddenLines, EndsAreRoundedOnceToTheNearest) {
  // The outline at x = 1/3 (rounded) is crossed at 1/3 of a line of length 1, exactly that double.
  const double third = 1.0 / 3.0;
  EXPECT_EQ(line_among({square(third, 0.0, 1.0, 1.0, 0.5)}, {0.0, 0.5, 0.1}, {1.0, 0.25, 0.1}),
            (Parts{{0.0, third}}));
  // At 1/3 of another, which is no double.
  EXPECT_EQ(line_among({square(0.25, 0.0, 1.0, 1.0, 0.5)}, {0.0, 0.5, 0.1}, {0.75, 0.25, 0.1}),
            (Parts{{0.0, third}}));
}

TEST(HiddenLines, NamesOfLinesThatThereAreNotAreRefused) {
  ItemList list;
  list.solid(kSquare);
  list.line({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0});
  const auto find = [&](LineName line, HiddenMethod method = HiddenMethod::roberts) {
    return visible_lines(list.view(), {&line, 1}, {.method = method});
  };
  EXPECT_THROW(find({2, 0}), Error);
  EXPECT_THROW(find({0, 4}), Error);
  EXPECT_THROW(find({1, 0}), Error);
  EXPECT_THROW(find({0, 0}, HiddenMethod::bsp), Error);
  EXPECT_EQ(visible_lines(list.view(), {}, {.method = HiddenMethod::roberts}).pieces.size(), 0u);
}

TEST(DrawnLines, SidesAreListedOnceAndByTheFirstThatIsDrawn) {
  ItemList list;
  const Point3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, -0.0), e(1, 1, 0.0);
  list.add(ItemList::Kind::solid, {a, b, c}, {1, 1, 0});
  list.add(ItemList::Kind::hollow, {c, b, d}, {0, 1, 1});
  list.add(ItemList::Kind::solid, {c, b, e}, {1, 1, 1});
  list.line(b, c);
  list.line(a, Point3(0, 0, 1));  // a point in the projection
  // Item 0 does not draw b c, item 1 does not draw c d: the next item draws these.
  const std::vector<LineName> expected{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 0}, {3, 1}};
  EXPECT_EQ(drawn_lines(list.view()), expected);
}

// ---- Progress and stopping ----------------------------------------------------------------------

/// Some thousands of lines, of triangles over one another.
ItemList many_lines() {
  ItemList list;
  for (int k = 0; k < 1500; ++k) {
    const double x = 0.02 * (k % 50), y = 0.03 * (k / 50), z = 0.01 * (k * 7 % 13);
    list.solid({{x, y, z}, {x + 0.1, y, z}, {x, y + 0.1, z + 0.05}});
  }
  return list;
}

TEST(HiddenLines, TellOfProgressUpToTheEndAndFindTheSame) {
  const ItemList list = many_lines();
  for (const HiddenMethod method : kMethods) {
    for (const int threads : {1, 3}) {
      std::size_t calls = 0, last = 0, all = 0;
      SurfacePlan options;
      options.threads = threads;
      options.progress = [&](std::size_t done, std::size_t of) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, of);
        last = done;
        all = of;
        ++calls;
      };
      EXPECT_EQ(pieces(list, method, options), pieces(list, method));
      EXPECT_GT(calls, 3u);
      EXPECT_EQ(all, all_lines(list).size());
      EXPECT_EQ(last, all);
    }
  }
}

TEST(HiddenLines, AreStoppedByWhoIsTold) {
  const ItemList list = many_lines();
  struct Stop {};
  for (const HiddenMethod method : kMethods) {
    for (const int threads : {1, 3}) {
      bool stopped = false;
      SurfacePlan options;
      options.threads = threads;
      options.progress = [&](std::size_t done, std::size_t all) {
        EXPECT_FALSE(stopped) << "told again after it stopped the work";
        stopped = 2 * done > all;
        if (stopped) throw Stop();
      };
      EXPECT_THROW(pieces(list, method, options), Stop);
      EXPECT_TRUE(stopped);
    }
  }
}

// ---- Against the truth --------------------------------------------------------------------------

TEST(HiddenLines, EveryFamilyAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_LINE_SCENES", 40 / kSlower);
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < scenes; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      ASSERT_EQ(wrong_lines(entered(list)), "") << family.name << ", seed " << k << "\n"
                                                << list.text();
    }
  }
}

// ---- The methods against each other ------------------------------------------------------------

/// The first pieces that differ, in words; empty if none do.
std::string difference(const ItemList& list) {
  const auto by_roberts = pieces(list, HiddenMethod::roberts);
  std::string differ;
  for (const HiddenMethod method : {HiddenMethod::appel, HiddenMethod::franklin}) {
    const auto others = pieces(list, method);
    const auto [r, o] = std::ranges::mismatch(by_roberts, others);
    if (r == by_roberts.end() && o == others.end()) continue;
    differ += "roberts: " + text({r, std::min(r + 3, by_roberts.end())}) +
              std::string(name_of(method)) + ": " + text({o, std::min(o + 3, others.end())});
  }
  return differ;
}

TEST(HiddenLines, TheMethodsAgreeOnEveryFamily) {
  const int scenes = from_environment("DISPLAYFILE_LINE_SCENES", 400 / kSlower);
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < scenes; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      ASSERT_EQ(difference(list), "") << family.name << ", seed " << k << "\n" << list.text();
    }
  }
}

TEST(HiddenLines, TheMethodsAgreeOnCrowds) {
  const int scenes = from_environment("DISPLAYFILE_LINE_SCENES", 60 / kSlower);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const ItemList list = crowd(s, s.between(20, 400));
    const std::string differ = difference(list);
    if (differ.empty()) continue;
    const ItemList least =
        shrunken(list, [&](const ItemList& part) { return !difference(part).empty(); });
    ADD_FAILURE() << "seed " << k << ": " << difference(least) << "\n" << least.text();
    break;
  }
}

/// The visible parts of these lines where they differ between finding all lines and only a few;
/// empty if none do.
std::string difference_of_few(const ItemList& list, const std::vector<LineName>& few,
                              const std::vector<IntersectionLine>& intersections) {
  std::string differ;
  for (const HiddenMethod method : kMethods) {
    const SeenLines all =
        visible_lines(list.view(), all_lines(list), {.method = method}, intersections);
    const std::size_t one = intersections.empty() ? 0 : 1;
    const SeenLines alone =
        visible_lines(list.view(), few, {.method = method}, std::span(intersections).first(one));
    std::vector<VisiblePiece> of_few;
    for (const VisiblePiece& piece : all.pieces) {
      if (std::ranges::binary_search(few, LineName{piece.item, piece.corner})) {
        of_few.push_back(piece);
      }
    }
    std::vector<VisibleIntersection> of_one;
    for (const VisibleIntersection& part : all.intersections) {
      if (part.line < one) of_one.push_back(part);
    }
    if (alone.pieces == of_few && alone.intersections == of_one) continue;
    differ += std::string(name_of(method)) + ": " + text(alone.pieces) + "not " + text(of_few);
  }
  return differ;
}

TEST(HiddenLines, OfAFewLinesAsMuchIsSeenAsOfTheseAmongAll) {
  const int scenes = from_environment("DISPLAYFILE_LINE_SCENES", 40 / kSlower);
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < scenes; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      ItemList list = family.make(s);
      const std::vector<LineName> of_family = all_lines(list);
      const ItemList others = crowd(s, s.between(50, 150));
      for (std::size_t i = 0; i < others.items.size(); ++i) {
        Loop loop(others.points_of(i).begin(), others.points_of(i).end());
        if (k % 3 == 1) {  // most of them beside the family
          for (Point3& p : loop) p += Point3(s.between(-2, 2), s.between(-2, 2), 0.0);
        }
        list.add(others.items[i].kind, loop);
      }
      if (k % 4 == 3) {  // far from 0, but exact
        for (Point3& p : list.points) p = glm::round(p * 0x1p20) / 0x1p20 + Point3(0x1p20);
      }
      std::vector<LineName> few;
      for (int n = s.between(1, 8); n > 0 && !of_family.empty(); --n) {
        few.push_back(of_family[static_cast<std::size_t>(s.below(int(of_family.size())))]);
      }
      std::ranges::sort(few);
      few.erase(std::unique(few.begin(), few.end()), few.end());
      ASSERT_EQ(difference_of_few(list, few, intersection_lines(list.view())), "")
          << family.name << ", seed " << k << "\n"
          << list.text();
    }
  }
}

/// The visible length of all lines, in units of the picture.
double seen_length(const ItemList& list, HiddenMethod method, const SurfacePlan& options) {
  double length = 0.0;
  for (const auto& [item, corner, from, to] : pieces(list, method, options)) {
    const auto points = list.points_of(item);
    const Point3 along = points[corner] - points[(corner == 0 ? points.size() : corner) - 1];
    length += (to - from) * std::hypot(along.x, along.y);
  }
  return length;
}

TEST(HiddenLines, WithRoundoffMuchTheSameIsSeenOfASceneThatIsNotHard) {
  Source s(11);
  const ItemList list = families::triangles(s);
  SurfacePlan exact, roundoff;
  roundoff.precision.exact = false;
  for (const HiddenMethod method : kMethods) {
    EXPECT_NEAR(seen_length(list, method, roundoff), seen_length(list, method, exact), 1e-6);
  }
}

// ---- Properties ---------------------------------------------------------------------------------

ItemList mapped(ItemList list, const auto& map) {
  for (Point3& p : list.points) p = map(p);
  return list;
}

TEST(HiddenLines, ScalingByTwoAndMirroringChangeNothing) {
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < 60 / kSlower; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      for (const HiddenMethod method : kMethods) {
        const std::string plain = text(pieces(list, method));
        const auto twice = [](const Point3& p) { return p * 2.0; };
        ASSERT_EQ(text(pieces(mapped(list, twice), method)), plain) << family.name << " " << k;
        const auto mirrored = [](const Point3& p) { return Point3(-p.x, p.y, p.z); };
        ASSERT_EQ(text(pieces(mapped(list, mirrored), method)), plain) << family.name << " " << k;
      }
    }
  }
}

/// Small triangles all over the picture.
ItemList crowd() {
  Source s(7);
  ItemList list;
  for (int k = 0; k < 2000; ++k) {
    const Point3 at = in_cube(s);
    const auto near = [&] { return at + 0.05 * in_cube(s); };
    const Point3 p = near(), q = near(), r = near();
    list.solid({p, q, r});
  }
  return list;
}

TEST(HiddenLines, AnyNumberOfThreadsFindsTheSame) {
  const ItemList list = crowd();
  for (const HiddenMethod method : kMethods) {
    SurfacePlan three;
    three.threads = 3;
    EXPECT_EQ(text(pieces(list, method)), text(pieces(list, method, three))) << name_of(method);
  }
}

/// Franklin leaves out the cells that none of the lines crosses.
TEST(HiddenLines, OfFewLinesTheSameIsSeenAsAmongAll) {
  const ItemList list = crowd();
  const std::vector<LineName> all = all_lines(list);
  for (const std::size_t step : {1000u, 100u, 10u}) {
    std::vector<LineName> few;
    for (std::size_t k = 0; k < all.size(); k += step) few.push_back(all[k]);
    EXPECT_EQ(difference_of_few(list, few, {}), "") << few.size();
  }
}

}  // namespace
}  // namespace displayfile
