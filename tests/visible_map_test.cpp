// The visible-surface map (hidden/map/visible_map.h) against the definition, in rationals.

#include "hidden/map/visible_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/draw/draw.h"
#include "programs/scenes/random_scenes.h"
#include "tests/from_environment.h"
#include "tests/map_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

std::vector<Point2> places_at_random(Source& s, int count) {
  std::vector<Point2> places;
  for (; count > 0; --count) {
    const double x = s.unit(), y = s.unit();
    places.emplace_back(x, y);
  }
  return places;
}

std::string wrong_in(const ItemList& list, int places = 12) {
  Source s(1'000'003);
  return wrong_in_map(list.view(), visible_map(list.view(), {}), places_at_random(s, places));
}

/// The scene that is left when everything is left out without which it is right.
std::string shrunken_wrong(const ItemList& list) {
  const ItemList least =
      shrunken(list, [](const ItemList& part) { return !wrong_in(part).empty(); });
  return wrong_in(least) + least.text();
}

TEST(VisibleMap, EveryFamilyAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 30 / kSlower);
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < scenes; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      if (wrong_in(list).empty()) continue;
      ADD_FAILURE() << family.name << ", seed " << k << "\n" << shrunken_wrong(list);
      break;
    }
  }
}

/// A wall on a floor, whose lower side is in the floor's plane within a ROUNDOFF. The fills are
/// exact, and the lines over them heed the ROUNDOFF.
TEST(VisibleMap, LinesOverItHeedTheRoundoff) {
  GraphicsSystem system;
  system.set_view_plane_normal({-12, 17, -10});
  system.set_view_up({0, 0, 1});
  system.set_perspective({12, -17, 10});
  system.set_window(-3, 3, -3, 3);
  system.set_hidden_surfaces({.removal = true});
  system.set_hidden_surfaces({.touching = Touching{Touching::Kind::off}});
  system.open_segment(1);
  system.polygon_abs_3({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}});
  system.polygon_abs_3({{-2, -1, -1e-12}, {1, -1, -1e-12}, {1, -1, 1.7}, {-2, -1, 1.7}});
  system.close_segment();
  DrawOptions options{.width = 128,
                      .height = 128,
                      .surfaces = {.method = HiddenMethod::map},
                      .samples = 1,
                      .with_ids = true};
  const Picture exact = draw(system, options);
  options.surfaces.precision = {false, 1e-9};
  const Picture rounded = draw(system, options);
  EXPECT_EQ(rounded.ids, exact.ids) << "no face is lost";
  EXPECT_NE(rounded.pixels, exact.pixels) << "the side was hidden";
}

// ---- Polygons declared to lie in a plane -------------------------------------------------------

/// Triangles of a flat area, all of them in the plane of one; beside the area others that share
/// sides with it, steep ones too; and parts of the triangles.
ItemList flat_area(Source& s) {
  const int n = s.between(2, 5);
  const Point3 origin(s.unit() * 0.3, s.unit() * 0.3, s.unit());
  Point3 across(0.5, 0.0, s.unit() - 0.5), up(0.0, 0.5, s.unit() - 0.5);
  const bool exact = s.below(4) == 0;
  if (!exact) {
    across += 0.2 * Point3(s.unit(), s.unit(), s.unit());
    up += 0.2 * Point3(s.unit(), s.unit(), s.unit());
  }
  std::vector<Point3> grid;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double u = (i + (exact ? 0.0 : 0.4 * s.unit())) / n;
      const double v = (j + (exact ? 0.0 : 0.4 * s.unit())) / n;
      grid.push_back(origin + u * across + v * up);
    }
  }
  const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (n + 1) + i)]; };
  const std::array<Point3, 3> plane{at(0, 0), at(1, 0), at(0, 1)};
  ItemList list;
  const auto add = [&](const Loop& loop) {
    list.solid_in(plane, loop);
    if (s.below(3) != 0) return;
    const double t = s.below(2) == 0 ? 0.5 : s.unit();
    list.solid_in(plane, {loop[0], loop[0] + t * (loop[1] - loop[0]),
                          loop[0] + (1.0 - t) * (loop[2] - loop[0])});
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      add({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      add({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  for (int k = 0; k < n; ++k) {  // a fold along two sides of it
    const Point3 fold(s.below(2) == 0 ? 1e-9 * s.unit() : 0.2 * (s.unit() - 0.5),
                      s.below(2) == 0 ? 1e-16 * s.unit() : -0.1 * s.unit(), 0.3 * (s.unit() - 0.5));
    list.solid({at(k, 0), at(k + 1, 0), at(k + 1, 0) + fold, at(k, 0) + fold});
    list.solid({at(n, k), at(n, k + 1), at(n, k) + fold});
    if (s.below(2) == 0) list.solid({at(k, n), at(k + 1, n), at(k, 0)});
  }
  return list;
}

TEST(VisibleMap, PolygonsInOnePlaneAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 120 / kSlower);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const ItemList list = flat_area(s);
    if (wrong_in(list).empty()) continue;
    ADD_FAILURE() << "seed " << k << "\n" << shrunken_wrong(list);
    break;
  }
}

// ---- Against the plain form ---------------------------------------------------------------------

using EdgeInWords = std::tuple<double, double, double, double, std::uint32_t, std::uint32_t>;

/// The edges in order, each from its lower end.
std::vector<EdgeInWords> edges_of(const VisibleMap& map) {
  std::vector<EdgeInWords> edges;
  for (const auto& [from, to, left, right] : map.edges) {
    const Point2 &p = map.points[from], &q = map.points[to];
    const bool runs_up = std::tie(p.x, p.y) < std::tie(q.x, q.y);
    if (p == q) continue;
    edges.push_back(runs_up ? EdgeInWords{p.x, p.y, q.x, q.y, left, right}
                            : EdgeInWords{q.x, q.y, p.x, p.y, right, left});
  }
  std::ranges::sort(edges);
  return edges;
}

/// How the map differs from that without shortcuts, in words; empty if it does not.
std::string difference_from_plain(const Primitives& items, int threads = 1) {
  const auto plain = edges_of(visible_map(items, {.shortcuts = false}));
  const auto map = edges_of(visible_map(items, {.threads = threads}));
  if (map == plain) return "";
  std::ostringstream differ;
  const auto tell = [&](const char* which, const auto& these, const auto& others) {
    for (const EdgeInWords& e : these) {
      if (std::ranges::binary_search(others, e)) continue;
      const auto& [x, y, u, v, left, right] = e;
      differ << which << " (" << x << ", " << y << ") to (" << u << ", " << v
             << "): " << static_cast<int>(left) << " | " << static_cast<int>(right) << "\n";
      if (differ.str().size() > 500) return;
    }
  };
  tell("only plain:", plain, map);
  tell("only with shortcuts:", map, plain);
  return differ.str();
}

/// Fails, with a minimal part of the scene that still differs, if the map on some threads is not
/// the plain one.
bool is_the_plain_one(const ItemList& list, int seed) {
  if (difference_from_plain(list.view(), 1 + seed % 3).empty()) return true;
  const ItemList least = shrunken(
      list, [](const ItemList& part) { return !difference_from_plain(part.view()).empty(); });
  ADD_FAILURE() << "seed " << seed << ": " << difference_from_plain(least.view()) << "\n"
                << least.text();
  return false;
}

TEST(VisibleMap, ShortcutsAndThreadsChangeNothingInCrowds) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 60 / kSlower);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const ItemList list = crowd(s, s.between(20, 400));
    if (!is_the_plain_one(list, k)) break;
  }
}

TEST(VisibleMap, CrowdsAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 6 / kSlower + 1);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const ItemList list = crowd(s, s.between(10, 40));
    if (wrong_in(list).empty()) continue;
    ADD_FAILURE() << "seed " << k << "\n" << shrunken_wrong(list);
    break;
  }
}

/// A triangle in the plane of one a little higher or lower, so that it is not even.
void add_uneven(ItemList& list, Source& s, const Loop& loop) {
  const double most = std::pow(10.0, -s.between(3, 7));
  std::array<Point3, 3> plane;
  for (std::size_t k = 0; k < 3; ++k) {
    plane[k] = loop[k] + Point3(0.0, 0.0, most * (s.unit() - 0.5));
  }
  list.solid_in(plane, loop);
}

/// A surface over a grid of squares, each of two triangles; heights follow waves and noise; where
/// it folds over, parts of it are before others. One in `uneven` triangles is not even; 0: none.
void add_sheet(ItemList& list, Source& s, int squares, bool on_a_grid, int uneven = 0) {
  const double depth = s.unit(), wave = s.unit(), fold = s.below(2) == 0 ? 0.15 : 0.0;
  const double noise = s.below(2) == 0 ? 0.3 / squares : 0.0;
  std::vector<Point3> points;
  for (int j = 0; j <= squares; ++j) {
    for (int i = 0; i <= squares; ++i) {
      const double u = static_cast<double>(i) / squares, v = static_cast<double>(j) / squares;
      Point3 p(u + fold * std::sin(9.0 * v + 5.0 * u), v + fold * std::cos(7.0 * u),
               depth + 0.2 * wave * std::sin(6.0 * u + 4.0 * v) + noise * s.unit());
      if (on_a_grid)
        p = Point3(std::round(p.x * 64.0), std::round(p.y * 64.0), std::round(p.z * 64.0)) / 64.0;
      points.push_back(p);
    }
  }
  for (int j = 0; j < squares; ++j) {
    for (int i = 0; i < squares; ++i) {
      const auto at = [&](int k, int l) {
        return points[static_cast<std::size_t>((j + l) * (squares + 1) + i + k)];
      };
      if (s.below(40) == 0) continue;  // a hole
      const auto add = [&](const Loop& loop) {
        const bool is_uneven = uneven != 0 && s.between(1, uneven) == 1;
        is_uneven ? add_uneven(list, s, loop) : list.solid(loop);
      };
      add({at(0, 0), at(1, 0), at(1, 1)});
      add({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
}

TEST(VisibleMap, ShortcutsChangeNothingInSheets) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 40 / kSlower + 1);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    const bool on_a_grid = s.below(3) == 0;
    for (int n = s.between(1, 3); n > 0; --n) add_sheet(list, s, s.between(4, 14), on_a_grid);
    if (!is_the_plain_one(list, k)) break;
  }
}

TEST(VisibleMap, ShortcutsChangeNothingInSheetsThatAreUneven) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 60 / kSlower + 1);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    const int uneven = s.between(2, 30);
    for (int n = s.between(1, 3); n > 0; --n) add_sheet(list, s, s.between(4, 14), false, uneven);
    if (!is_the_plain_one(list, k)) break;
  }
}

/// Level squares in planes that are steps apart, so that depths leave gaps at their sides.
TEST(VisibleMap, CoversGoOnOverSteps) {
  constexpr double kStep = 0x1p-12;
  for (int k = 0; k < 20; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    const int squares = s.between(3, 9);
    ItemList list;
    list.solid({{-1.0, -1.0, 0.1}, {2.0, -1.0, 0.1}, {0.5, 2.0, 0.1}});
    for (int j = 0; j < squares; ++j) {
      for (int i = 0; i < squares; ++i) {
        const auto at = [&](int x, int y) {
          return Point3((i + x) / static_cast<double>(squares),
                        (j + y) / static_cast<double>(squares), 0.9);
        };
        const Point3 up(0.0, 0.0, s.below(2) == 0 ? kStep : -kStep);
        const std::array<Point3, 3> plane{at(0, 0) + up, at(1, 0) + up, at(0, 1) + up};
        list.solid_in(plane, {at(0, 0), at(1, 0), at(1, 1)});
        list.solid_in(plane, {at(0, 0), at(1, 1), at(0, 1)});
      }
    }
    if (!is_the_plain_one(list, k)) break;
  }
}

TEST(VisibleMap, SheetsThatAreUnevenAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 4 / kSlower + 1);
  for (int k = 0; k < scenes; ++k) {
    Source s(static_cast<std::uint64_t>(k));
    ItemList list;
    for (int n = s.between(1, 2); n > 0; --n) add_sheet(list, s, s.between(3, 5), false, 4);
    if (wrong_in(list).empty()) continue;
    ADD_FAILURE() << "seed " << k << "\n" << shrunken_wrong(list);
    break;
  }
}

}  // namespace
}  // namespace displayfile
