// sort(whole=True) of the Python package: at any place of the picture polygons are drawn in the
// order of their depths there.

#include "interp/python/join_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <iostream>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "clip/geometry/planarity.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/output_device.h"
#include "tests/from_environment.h"
#include "tests/painted_scenes.h"
#include "tests/polygon_sides.h"
#include "tests/predicate_inputs.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using test::any_place;
using test::any_scene;
using test::covers;
using test::distance_to_side;
using test::from_environment;
using test::is_near_a_side;
using test::kSlower;
using test::Loop;
using test::PaintedScene;
using test::Source;

DrawnPieces sorted_pieces(const PaintedScene& scene, HiddenMethod method) {
  GraphicsSystem system;
  system.set_hidden_surfaces(
      {.touching = Touching{Touching::Kind::off}});  // places are judged by these coordinates
  system.set_window(0, 1, 0, 1);
  system.set_view_depth(-1, 0);
  system.open_segment(1);
  std::int32_t pick = 0;
  for (const Loop& polygon : scene.polygons) {
    system.set_pick_id(pick++);
    system.polygon_abs_3(polygon);
  }
  for (const auto& [from, to] : scene.lines) {
    system.set_pick_id(pick++);
    system.move_abs_3(from.x, from.y, from.z);
    system.line_abs_3(to.x, to.y, to.z);
  }
  system.close_segment();
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = method;
  return drawn_pieces(sorted.update(system, method, options));
}

DrawnPieces joined_pieces(const PaintedScene& scene, DrawnPieces pieces) {
  std::vector<std::uint32_t> sides;
  std::vector<Point3> points;
  for (const Loop& polygon : scene.polygons) {
    sides.push_back(static_cast<std::uint32_t>(polygon.size()));
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  python::join_pieces(sides, points, pieces);
  return pieces;
}

std::span<const Point3> points_of(const DrawnPieces& pieces, std::size_t k) {
  return std::span(pieces.points).subspan(pieces.first[k], pieces.first[k + 1] - pieces.first[k]);
}

// ---- The judge ---------------------------------------------------------------------------
// It shares no code with the sorts or with joining: depths are those of planes through corners.

/// Nearer than this to a side of a polygon, or of a piece, nothing is checked.
constexpr double kNearSide = 1e-6, kNearCut = 1e-9;
/// The largest move of a place at a cut, and the number of moves.
constexpr double kMove = 1e-7;
constexpr int kMoves = 10;
/// Depths that differ by less are in either order.
constexpr double kGap = 1e-9;

/// The box of a polygon in the picture.
struct Box {
  Point2 low, high;
  explicit Box(std::span<const Point3> loop) : low(loop[0].x, loop[0].y), high(low) {
    for (const Point3& p : loop) {
      low = glm::min(low, Point2(p.x, p.y));
      high = glm::max(high, Point2(p.x, p.y));
    }
  }
  bool is_near(const Point2& p, double near) const {
    return low.x - near <= p.x && p.x <= high.x + near && low.y - near <= p.y &&
           p.y <= high.y + near;
  }
};

/// All depths that a polygon may have at a place.
struct Depths {
  long double low = std::numeric_limits<long double>::infinity(), high = -low;
  void add(long double z, long double error) {
    low = std::min(low, z - error);
    high = std::max(high, z + error);
  }
};

using Triple = std::array<Point3, 3>;

/// Twice the area of the triangle in the picture, with its sign.
long double turn(const Triple& t) {
  return (static_cast<long double>(t[1].x) - t[0].x) * (static_cast<long double>(t[2].y) - t[0].y) -
         (static_cast<long double>(t[1].y) - t[0].y) * (static_cast<long double>(t[2].x) - t[0].x);
}

/// Adds the depth of the plane through three points, with a bound of its rounding. None of a plane
/// that is seen from its edge: a triangle that holds a place away from its sides is not that thin.
void add_depth_of_plane(const Triple& t, const Point2& p, Depths& depths) {
  const long double all = turn(t);
  if (std::abs(all) < 1e-12L) return;
  const Point3 at(p.x, p.y, 0.0);
  const long double b = turn({t[0], at, t[2]}) / all, c = turn({t[0], t[1], at}) / all;
  const long double bz = static_cast<long double>(t[1].z) - t[0].z,
                    cz = static_cast<long double>(t[2].z) - t[0].z;
  const long double error = 16 * std::numeric_limits<long double>::epsilon() *
                            (1 + (std::abs(bz) + std::abs(cz)) / std::abs(all));
  depths.add(t[0].z + b * bz + c * cz, error);
}

/// A polygon as the judge sees it.
struct Judged {
  Loop corners;  ///< as given
  Box box;
  Loop different;  ///< without those that repeat the one before
  std::vector<Triple> planes;
  double off = 0.0;      ///< the largest distance in depth of a corner from the only plane
  bool is_clear = true;  ///< false: any depth, and any place in its box, may be its own
};

bool is_convex(const Loop& loop) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto at = [&](std::size_t k) { return loop[(i + k) % loop.size()]; };
    (turn({at(0), at(1), at(2)}) > 0 ? left : right) = true;
  }
  return left != right;  // of up to four corners
}

/// The largest triangle of the polygon's corners with the first of them, by greed.
Triple widest(const Loop& loop) {
  Triple t{loop[0], loop[0], loop[0]};
  for (const Point3& p : loop) {
    if (std::hypot(p.x - loop[0].x, p.y - loop[0].y) >
        std::hypot(t[1].x - loop[0].x, t[1].y - loop[0].y)) {
      t[1] = p;
    }
  }
  for (const Point3& p : loop) {
    if (std::abs(turn({t[0], t[1], p})) > std::abs(turn(t))) t[2] = p;
  }
  return t;
}

/// A polygon that is not flat is drawn as triangles, which the judge does not know. For four
/// corners it takes all planes through three; for more it requires all corners nearly in one plane.
Judged judged(const Loop& corners) {
  Judged j{corners, Box(corners), {}, {}};
  for (const Point3& p : corners) {
    if (j.different.empty() || p != j.different.back()) j.different.push_back(p);
  }
  while (j.different.size() > 1 && j.different.back() == j.different.front()) {
    j.different.pop_back();
  }
  const Loop& v = j.different;
  if (v.size() < 3) return j;
  if (v.size() == 3) {
    j.planes = {{v[0], v[1], v[2]}};
  } else if (v.size() == 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      j.planes.push_back({v[k], v[(k + 1) % 4], v[(k + 2) % 4]});
    }
    j.is_clear = is_flat(corners) || is_convex(v);
  } else {
    j.planes = {widest(v)};
    for (const Point3& p : v) {
      Depths at;
      add_depth_of_plane(j.planes[0], {p.x, p.y}, at);
      if (at.low <= at.high) {
        j.off = std::max(
            {j.off, static_cast<double>(at.high - p.z), static_cast<double>(p.z - at.low)});
      }
    }
    j.is_clear = is_flat(corners) && j.off < 1e-7;
  }
  return j;
}

Depths depths_at(const Judged& polygon, const Point2& p) {
  Depths depths;
  for (const Triple& t : polygon.planes) add_depth_of_plane(t, p, depths);
  depths.low -= 2 * polygon.off;
  depths.high += 2 * polygon.off;
  return depths;
}

/// The expected result at a place: the polygons that cover it, with their depths.
struct Covering {
  std::int32_t item;
  Depths depths;
};
using Coverings = std::vector<Covering>;

/// None where it is not clear: near a side, or at a polygon that is not.
std::optional<Coverings> coverings_at(const std::vector<Judged>& polygons, const Point2& p) {
  Coverings found;
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const Judged& polygon = polygons[k];
    if (!polygon.box.is_near(p, kNearSide)) continue;
    if (!polygon.is_clear) return std::nullopt;
    if (is_near_a_side(polygon.corners, p, kNearSide)) return std::nullopt;
    if (!covers(polygon.different, p)) continue;
    const Depths depths = depths_at(polygon, p);
    if (depths.low > depths.high) return std::nullopt;
    found.push_back({static_cast<std::int32_t>(k), depths});
  }
  return found;
}

/// True if one of two or more is certainly the nearest.
bool has_nearest(const Coverings& all) {
  if (all.size() < 2) return false;
  const auto nearest =
      std::ranges::max_element(all, {}, [](const Covering& c) { return c.depths.low; });
  return std::ranges::all_of(all, [&](const Covering& c) {
    return c.item == nearest->item || c.depths.high + kGap < nearest->depths.low;
  });
}

/// A scene sorted one way, in pieces or joined.
struct Sorted {
  std::string way;
  DrawnPieces pieces;
  std::vector<Box> boxes;
  Sorted(std::string name, DrawnPieces sorted) : way(std::move(name)), pieces(std::move(sorted)) {
    for (std::size_t k = 0; k < pieces.size(); ++k) boxes.emplace_back(points_of(pieces, k));
  }
};

/// The pieces that cover the place, in the order in which they are drawn; none near a cut.
std::optional<std::vector<std::size_t>> drawn_at(const Sorted& sorted, const Point2& p) {
  const DrawnPieces& pieces = sorted.pieces;
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces.kinds[k] == DrawnPieces::Kind::line || !sorted.boxes[k].is_near(p, kNearCut))
      continue;
    if (is_near_a_side(points_of(pieces, k), p, kNearCut)) return std::nullopt;
    if (covers(points_of(pieces, k), p)) found.push_back(k);
  }
  return found;
}

/// Describes an error in the drawing order at a place; empty if there is none.
std::string wrong_in(const Coverings& right, const DrawnPieces& pieces,
                     const std::vector<std::size_t>& drawn) {
  std::vector<std::int32_t> items, expected;
  for (const std::size_t k : drawn) items.push_back(pieces.picks[k]);
  for (const Covering& c : right) expected.push_back(c.item);
  auto sorted_items = items;
  std::ranges::sort(sorted_items);
  if (sorted_items != expected) return "other polygons are drawn than lie there, or one twice";
  const auto depths_of = [&](std::int32_t item) {
    return std::ranges::find(right, item, &Covering::item)->depths;
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1; j < items.size(); ++j) {
      if (depths_of(items[j]).high + kGap >= depths_of(items[i]).low) continue;
      return "polygon " + std::to_string(items[j]) + " is painted over nearer polygon " +
             std::to_string(items[i]);
    }
  }
  return "";
}

/// Describes an error in the pieces drawn before and after a place on a line; empty if there is
/// none.
std::string wrong_on_line(const Coverings& right, const DrawnPieces& pieces, std::int32_t line,
                          const Point3& at) {
  std::optional<std::size_t> place;
  for (std::size_t k = 0; k < pieces.size() && !place; ++k) {
    if (pieces.picks[k] != line || pieces.kinds[k] != DrawnPieces::Kind::line) continue;
    const auto ends = points_of(pieces, k);
    if (distance_to_side({at.x, at.y}, ends[0], ends[1]) < kNearCut) place = k;
  }
  if (!place) return "a line is not drawn there";
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto c = std::ranges::find(right, pieces.picks[k], &Covering::item);
    if (c == right.end() || !covers(points_of(pieces, k), {at.x, at.y})) continue;
    if (k > *place && c->depths.high + kGap < at.z)
      return "a polygon is painted over a nearer line";
    if (k < *place && c->depths.low - kGap > at.z) return "a line is drawn over a nearer polygon";
  }
  return "";
}

// ---- Tests -------------------------------------------------------------------------------

struct Counts {
  std::int64_t asked = 0;    ///< places
  std::int64_t unclear = 0;  ///< of them near a side, or where a polygon's depth is not known
  std::int64_t alone = 0, as_near = 0;  ///< of one polygon or none; without a nearest one
  std::int64_t decided = 0;             ///< all others
  std::int64_t moved = 0;               ///< at a cut in one of four orders, and therefore moved
  std::int64_t at_cuts = 0;             ///< orders that still have a cut there
  std::int64_t on_lines = 0, wrong = 0;
  std::int64_t sorted_pieces = 0, joined_pieces = 0;
};

std::vector<Sorted> sorted_every_way(const PaintedScene& scene, Counts& counts) {
  std::vector<Sorted> all;
  for (const HiddenMethod method : {HiddenMethod::depth_sort, HiddenMethod::bsp}) {
    const std::string name(name_of(method));
    all.emplace_back(name, sorted_pieces(scene, method));
    all.emplace_back(name + ", whole", joined_pieces(scene, all.back().pieces));
    counts.sorted_pieces += std::ssize(all[all.size() - 2].boxes);
    counts.joined_pieces += std::ssize(all.back().boxes);
  }
  return all;
}

using DrawnInEachWay = std::vector<std::optional<std::vector<std::size_t>>>;

DrawnInEachWay drawn_in_each_way(const std::vector<Sorted>& ways, const Point2& p) {
  DrawnInEachWay drawn;
  for (const Sorted& way : ways) drawn.push_back(drawn_at(way, p));
  return drawn;
}

/// Where a polygon is cut, two pieces of it meet, and which of them covers a place is undecided: a
/// place beside the cut is looked at instead. More places lie at cuts than by chance, since they
/// are chosen between corners, and a quadrilateral that is not flat is cut from corner to corner.
DrawnInEachWay drawn_beside_cuts(Source& s, const std::vector<Sorted>& ways, Point2& p,
                                 Counts& counts) {
  DrawnInEachWay drawn = drawn_in_each_way(ways, p);
  const auto is_at_cut = [&] {
    return std::ranges::any_of(drawn, [](const auto& of_way) { return !of_way; });
  };
  if (is_at_cut()) ++counts.moved;
  for (int k = 0; k < kMoves && is_at_cut(); ++k) {
    p += kMove * Point2(2.0 * s.unit() - 1.0, 2.0 * s.unit() - 1.0);
    drawn = drawn_in_each_way(ways, p);
  }
  return drawn;
}

void ask_at(Source& s, const Point2& chosen, const std::vector<Judged>& polygons,
            const std::vector<Sorted>& ways, Counts& counts, std::string& wrong) {
  ++counts.asked;
  Point2 place = chosen;
  auto right = coverings_at(polygons, place);
  DrawnInEachWay drawn;
  if (right) {
    drawn = drawn_beside_cuts(s, ways, place, counts);
    if (place != chosen) right = coverings_at(polygons, place);
  }
  if (!right) {
    ++counts.unclear;
    return;
  }
  if (right->size() < 2) {
    ++counts.alone;
  } else if (!has_nearest(*right)) {
    ++counts.as_near;
  } else {
    ++counts.decided;
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (!drawn[k]) {
      ++counts.at_cuts;
      continue;
    }
    const std::string fault = wrong_in(*right, ways[k].pieces, *drawn[k]);
    if (fault.empty()) continue;
    ++counts.wrong;
    std::ostringstream out;
    out.precision(17);
    out << ways[k].way << ": at " << place.x << ", " << place.y << ": " << fault;
    wrong = out.str();
  }
}

void ask_on_line(const Point3& at, std::int32_t line, const std::vector<Judged>& polygons,
                 const std::vector<Sorted>& ways, Counts& counts, std::string& wrong) {
  const auto right = coverings_at(polygons, {at.x, at.y});
  if (!right || right->empty()) return;
  ++counts.on_lines;
  for (const Sorted& way : ways) {
    if (!drawn_at(way, {at.x, at.y})) continue;
    const std::string fault = wrong_on_line(*right, way.pieces, line, at);
    if (fault.empty()) continue;
    ++counts.wrong;
    wrong = way.way + ": line " + std::to_string(line) + ": " + fault;
  }
}

void ask_on_lines(Source& s, const PaintedScene& scene, const std::vector<Judged>& polygons,
                  const std::vector<Sorted>& ways, Counts& counts, std::string& wrong) {
  auto line = static_cast<std::int32_t>(scene.polygons.size());
  for (const auto& [from, to] : scene.lines) {
    const bool is_a_point = std::hypot(to.x - from.x, to.y - from.y) < kNearSide;
    for (int k = 0; k < 20 && !is_a_point; ++k) {
      ask_on_line(from + s.unit() * (to - from), line, polygons, ways, counts, wrong);
    }
    ++line;
  }
}

/// Describes an error at random places of a scene; empty if there is none.
std::string wrong_in_scene(Source& s, const PaintedScene& scene, int places, Counts& counts) {
  std::vector<Judged> polygons;
  for (const Loop& loop : scene.polygons) polygons.push_back(judged(loop));
  const std::vector<Sorted> ways = sorted_every_way(scene, counts);
  std::string wrong;
  for (int k = 0; k < places; ++k) {
    const Point2 place = any_place(s, scene);
    ask_at(s, place, polygons, ways, counts, wrong);
  }
  ask_on_lines(s, scene, polygons, ways, counts, wrong);
  return wrong;
}

/// The number of places, those where one of several polygons is certainly nearest, is set in the
/// environment. At each, four orders are checked.
TEST(JoinPieces, WhatIsPaintedLastIsNearest) {
  const int places = from_environment("DISPLAYFILE_PLACES_IN_ORDER", 60'000 / kSlower);
  const int of_scene = from_environment("DISPLAYFILE_PLACES_OF_A_SCENE", 400);
  const int first = from_environment("DISPLAYFILE_PLACES_FIRST_SEED", 0);
  Counts counts;
  int shown = 0;
  for (int seed = first; counts.decided < places && shown < 5; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    const PaintedScene scene = any_scene(s);
    const std::string wrong = wrong_in_scene(s, scene, of_scene, counts);
    if (wrong.empty()) continue;
    ++shown;
    ADD_FAILURE() << "seed " << seed << ": " << wrong << "\n" << text_of(scene);
  }
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.on_lines, counts.decided / (2L * of_scene));
  EXPECT_GT(counts.decided, counts.asked / 8);
  EXPECT_LT(counts.at_cuts, counts.decided / 100);
  EXPECT_LT(counts.joined_pieces, counts.sorted_pieces * 9 / 10);
  std::cout << counts.decided << " places where one of several polygons is nearest, each in four "
            << "orders, and " << counts.on_lines << " on lines: " << counts.wrong << " wrong. Of "
            << counts.asked << " places " << counts.unclear << " are near a side or unclear, "
            << counts.alone << " of fewer than two polygons, " << counts.as_near
            << " of equally near ones; " << counts.moved << " were moved off a cut, and "
            << counts.at_cuts << " orders have a cut there all the same. " << counts.sorted_pieces
            << " pieces were joined to " << counts.joined_pieces << ".\n";
}

}  // namespace
}  // namespace displayfile
