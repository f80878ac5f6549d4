// Warnock's area subdivision, area by area: the categories and lists of the problem book's section
// 10.6, the lists inherited from an area's parent, and the picture of both forms.

#include "interp/visibility/warnock.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/plain_warnock.h"
#include "interp/visibility/z_buffer.h"
#include "programs/scenes/hard_cases.h"
#include "tests/truth_scenes.h"
#include "tests/without_entered.h"

namespace displayfile {
namespace {

using Fill = ViewedScene::Fill;
using Decision = PlainWarnock::Decision;
using enum AreaCategory;
using test::Vertices;

DisplayFile file_of(const std::vector<Vertices>& polygons) {
  return test::file_of(polygons, {LineStyle::Kind::none});
}
ViewedScene scene_of(const std::vector<Vertices>& polygons) {
  return ViewedScene(file_of(polygons));
}

/// Level, in eighths of the picture's side.
Vertices rectangle(double left, double right, double bottom, double top, double z) {
  return {{left / 8, bottom / 8, z},
          {right / 8, bottom / 8, z},
          {right / 8, top / 8, z},
          {left / 8, top / 8, z}};
}

std::size_t pixels(const PictureSize& size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}
std::size_t index(const PictureSize& size, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
         static_cast<std::size_t>(column);
}
template <class Do>
void for_pixels(const SampleArea& area, Do&& act) {
  for (int row = area.first_row; row < area.end_row; ++row) {
    for (int column = area.first_column; column < area.end_column; ++column) act(column, row);
  }
}

/// The fills seen, rows from the bottom; drawn in bands of `rows` rows. Fails where a pixel is not
/// reported exactly once.
std::vector<Fill> seen_by(const ImageSpaceMethod& method, const PictureSize& size, int rows) {
  std::vector<Fill> fills(pixels(size));
  std::vector<int> told(pixels(size));
  for (int begin = 0; begin < size.height; begin += rows) {
    const int end = std::min(begin + rows, size.height);
    method.draw_rows(begin, end, [&](int row, int first, std::span<const Fill> seen) {
      EXPECT_TRUE(row >= begin && row < end) << row;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        fills[index(size, first, row) + i] = seen[i];
        ++told[index(size, first, row) + i];
      }
    });
  }
  EXPECT_EQ(std::ranges::count(told, 1), std::ssize(told));
  return fills;
}

/// A visit that lasts.
struct Visited {
  SampleArea area;
  std::vector<PlainWarnock::Listed> list;
  Decision decision;
  bool operator==(const Visited&) const = default;
};
std::vector<Visited> visits_of(const ViewedScene& scene, const PictureSize& size,
                               int row_begin = 0) {
  struct Observer : PlainWarnock::Unobserved {
    std::vector<Visited> visits;
    void visit(const PlainWarnock::Visit& visited) {
      visits.push_back(
          {visited.area, {visited.list.begin(), visited.list.end()}, visited.decision});
    }
  } observer;
  PlainWarnock warnock;
  warnock.prepare({scene, size, {}}, 1);
  warnock.draw_rows(
      row_begin, size.height, [](int, int, std::span<const Fill>) {}, observer);
  return observer.visits;
}

/// Calls check(form, its name) with the books' algorithm and with the one that finishes early.
template <class Check>
void for_both_forms(const ImageSpaceMethod::Request& request, Check&& check) {
  PlainWarnock plain;
  Warnock early;
  for (const auto& [form, name] : {std::pair<ImageSpaceMethod*, const char*>{&plain, "plain"},
                                   std::pair<ImageSpaceMethod*, const char*>{&early, "early"}}) {
    form->prepare(request, 1);
    check(static_cast<const ImageSpaceMethod&>(*form), name);
  }
}

void PrintTo(const Visited& visit, std::ostream* out) {
  const auto& [left, right, bottom, top] = visit.area;
  *out << fmt::format("[{}, {}) x [{}, {}):", left, right, bottom, top);
  for (const auto& [fill, category] : visit.list) {
    *out << fmt::format(" {}-{}", fill, static_cast<int>(category));
  }
  *out << fmt::format(" -> {}", static_cast<int>(visit.decision));
}

// ---- Categories --------------------------------------------------------------------------------

constexpr PictureSize kEight{8, 8};

AreaCategory category(const Vertices& polygon, const SampleArea& area,
                      const PictureSize& size = kEight) {
  return category_of(polygon, extents_of(polygon, size), area, size);
}

TEST(AreaCategories, TheProblemBooksFour) {
  const SampleArea area{2, 6, 2, 6};
  EXPECT_EQ(category({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, area), surrounding);
  EXPECT_EQ(category({{0, 0, 0}, {0.5, 0, 0}, {0.5, 1, 0}}, area), intersecting);
  EXPECT_EQ(category({{0.3, 0.3, 0}, {0.6, 0.3, 0}, {0.4, 0.7, 0}}, area), contained);
  EXPECT_EQ(category({{0.8, 0, 0}, {1, 0, 0}, {1, 1, 0}}, area), disjoint);
}

/// The minimax test sees the triangle's extents overlap the area; its long side passes by.
TEST(AreaCategories, DisjointBeyondASide) {
  EXPECT_EQ(category({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 3, 0, 3}), disjoint);
}

/// The area lies in the notch of a U, and in the middle of a frame that is run through twice.
TEST(AreaCategories, ConcaveAndSelfCrossing) {
  const Vertices u = {{0, 0, 0},       {1, 0, 0},       {1, 1, 0},    {0.75, 1, 0},
                      {0.75, 0.25, 0}, {0.25, 0.25, 0}, {0.25, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(category(u, {2, 6, 2, 6}), disjoint);
  EXPECT_EQ(category(u, {2, 6, 1, 6}), intersecting);
  EXPECT_EQ(category(u, {2, 6, 0, 2}), surrounding);
  const Vertices twice = {{0, 0, 0},     {1, 0, 0},     {1, 1, 0},     {0, 1, 0},
                          {0, 0, 0},     {0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.8, 0.8, 0},
                          {0.2, 0.8, 0}, {0.2, 0.2, 0}};
  EXPECT_EQ(category(twice, {2, 6, 2, 6}), disjoint);
}

/// A polygon as large as the area and no larger covers all of its centres: it surrounds it.
TEST(AreaCategories, AreasAreMadeOfCentres) {
  const Vertices square = rectangle(2, 6, 2, 6, 0);
  EXPECT_EQ(category(square, {2, 6, 2, 6}), surrounding);
  EXPECT_EQ(category(square, {2, 7, 2, 6}), contained);
  EXPECT_EQ(category(square, {3, 7, 3, 7}), intersecting);
  // Sides through the outermost centres: left and top belong, right and bottom do not.
  const Vertices through = rectangle(2.5, 5.5, 2.5, 5.5, 0);
  EXPECT_EQ(extents_of(through, kEight), (SampleArea{2, 5, 3, 6}));
  EXPECT_EQ(category(through, {2, 3, 5, 6}), surrounding);
  EXPECT_EQ(category(through, {5, 6, 5, 6}), disjoint);
  EXPECT_EQ(category(through, {2, 3, 2, 3}), disjoint);
}

// ---- Lists and decisions -----------------------------------------------------------------------

/// A triangle alone in a quarter; a wall before a window and behind a door; nothing. The window's
/// plane, not the window, comes out before the wall within the quarter.
TEST(WarnockSteps, EachAreasListAndDecision) {
  Vertices window = rectangle(5, 7, 5, 7, 0.0);
  window[1].z = window[2].z = 0.45;
  const Fill triangle = 1, wall = 2, behind = 3, door = 4;
  const ViewedScene scene = scene_of({{{0.1, 0.1, 0.6}, {0.4, 0.1, 0.6}, {0.2, 0.4, 0.6}},
                                      rectangle(4, 8, 0, 8, 0.5),
                                      window,
                                      rectangle(6, 8, 0, 2, 0.9)});
  const std::vector<Visited> expected = {
      {{0, 8, 0, 8},
       {{triangle, contained}, {wall, contained}, {behind, contained}, {door, contained}},
       Decision::subdivided},
      {{0, 4, 0, 4}, {{triangle, contained}}, Decision::one_polygon},
      {{4, 8, 0, 4}, {{wall, surrounding}, {door, contained}}, Decision::subdivided},
      {{4, 6, 0, 2}, {{wall, surrounding}}, Decision::surrounded},
      {{6, 8, 0, 2}, {{door, surrounding}}, Decision::surrounded},
      {{4, 6, 2, 4}, {{wall, surrounding}}, Decision::surrounded},
      {{6, 8, 2, 4}, {{wall, surrounding}}, Decision::surrounded},
      {{0, 4, 4, 8}, {}, Decision::background},
      {{4, 8, 4, 8}, {{wall, surrounding}}, Decision::surrounded}};
  EXPECT_EQ(visits_of(scene, kEight), expected);
}

/// Two sheets that cross in a column of centres, where both are equally near.
TEST(WarnockSteps, APixelIsDecidedAtItsCentre) {
  const ViewedScene scene = scene_of({{{0, 0, 0.25}, {1, 0, 0.75}, {1, 1, 0.75}, {0, 1, 0.25}},
                                      {{0, 0, 0.75}, {1, 0, 0.25}, {1, 1, 0.25}, {0, 1, 0.75}}});
  const std::vector<PlainWarnock::Listed> both = {{1, surrounding}, {2, surrounding}};
  const std::vector<Visited> expected = {{{0, 3, 0, 1}, both, Decision::subdivided},
                                         {{0, 1, 0, 1}, both, Decision::pixel},
                                         {{1, 3, 0, 1}, both, Decision::subdivided},
                                         {{1, 2, 0, 1}, both, Decision::pixel},
                                         {{2, 3, 0, 1}, both, Decision::pixel}};
  EXPECT_EQ(visits_of(scene, {3, 1}), expected);
  PlainWarnock warnock;
  warnock.prepare({scene, {3, 1}, {}}, 1);
  EXPECT_EQ(seen_by(warnock, {3, 1}, 1), (std::vector<Fill>{2, 2, 1}));
}

/// However many sheets there are, and however close: one hides the rest over the whole picture.
TEST(WarnockSteps, SheetsOverThePictureAreOneArea) {
  std::vector<Vertices> sheets;
  for (int k = 0; k < 50; ++k) {
    Vertices sheet = rectangle(0, 8, 0, 8, 0);
    for (Point3& v : sheet) v.z = 0.25 + v.x / 4 + v.y / 8 + (k * 7 % 50) / 2 * 0x1p-52;
    sheets.push_back(sheet);
  }
  const std::vector<Visited> visits = visits_of(scene_of(sheets), {64, 64});
  ASSERT_EQ(visits.size(), 1U);
  EXPECT_EQ(visits[0].decision, Decision::surrounded);
}

/// A triangle over a sheet: the areas on its long side, the diagonal, are all that is subdivided;
/// 1, 2, 4, ..., n/2 of them.
TEST(WarnockSteps, AreasAlongAnEdge) {
  const ViewedScene scene =
      scene_of({rectangle(0, 8, 0, 8, 0), {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}}});
  for (const int n : {2, 8, 64, 256}) {
    const auto areas = static_cast<std::size_t>(4 * n - 3);
    EXPECT_EQ(visits_of(scene, {n, n}).size(), areas) << n;
  }
}

/// Among depths that are equal within the ROUNDOFF the polygon entered later is visible.
TEST(WarnockSteps, Roundoff) {
  const ViewedScene scene = scene_of({rectangle(0, 8, 0, 8, 0.5), rectangle(0, 8, 0, 8, 0.5 - 1e-7),
                                      rectangle(1, 3, 1, 3, 0.5 - 2e-7)});
  for (const double roundoff : {1e-6, 1e-9}) {
    for_both_forms({scene, kEight, roundoff}, [&](const ImageSpaceMethod& form, const char* name) {
      const std::vector<Fill> seen = seen_by(form, kEight, 8);
      const bool equal = roundoff > 1e-7;
      EXPECT_EQ(seen[index(kEight, 0, 0)], equal ? 2U : 1U) << name;
      EXPECT_EQ(seen[index(kEight, 2, 2)], equal ? 3U : 1U) << name;
    });
  }
}

// ---- Invariants of every area ------------------------------------------------------------------

/// A small random scene, and its truth.
struct Known {
  Known(const test::SceneFamily& family, std::uint32_t seed)
      : name(fmt::format("{}, seed {}", family.name, seed)),
        file(test::scene(family, seed, 2 + static_cast<int>(seed % 11))),
        scene(file),
        size{test::kSmallShapes[seed % test::kSmallShapes.size()].width,
             test::kSmallShapes[seed % test::kSmallShapes.size()].height} {}

  std::string name;
  DisplayFile file;
  ViewedScene scene;
  PictureSize size;
};
template <class Check>
void for_known_scenes(std::uint32_t scenes, Check&& check) {
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < scenes; ++seed) {
      const Known known(family, 7000 + seed);
      check(known);
      if (testing::Test::HasFailure()) FAIL() << known.name;
    }
  }
}

std::vector<char> covered_by(const ViewedScene& scene, Fill fill, const PictureSize& size) {
  std::vector<char> covered(pixels(size));
  ScanConverter converter;
  converter.scan_convert(scene.vertices(fill), {size, 0, size.height},
                         [&](int row, int first, int end) {
                           for (int i = first; i < end; ++i) covered[index(size, i, row)] = 1;
                         });
  return covered;
}

std::vector<Fill> z_buffered(const ViewedScene& scene, const PictureSize& size) {
  ZBuffer z_buffer;
  z_buffer.prepare({scene, size, {}}, 1);
  return seen_by(z_buffer, size, size.height);
}

/// By scan conversion, which shares no decision with the categories.
TEST(WarnockAreas, CategoriesAreTrue) {
  for_known_scenes(40, [](const Known& known) {
    const ViewedScene& scene = known.scene;
    const PictureSize size = known.size;
    std::vector<std::vector<char>> covered(1);
    for (Fill fill = 1; fill < scene.end(); ++fill) {
      covered.push_back(covered_by(scene, fill, size));
    }
    for (const Visited& visit : visits_of(scene, size)) {
      for (Fill fill = 1; fill < scene.end(); ++fill) {
        const AreaCategory direct = category_of(
            scene.vertices(fill), extents_of(scene.vertices(fill), size), visit.area, size);
        int inside = 0, all = 0;
        for_pixels(visit.area, [&](int column, int row) {
          ++all;
          inside += covered[fill][index(size, column, row)];
        });
        const auto total = std::ranges::count(covered[fill], 1);
        if (direct == surrounding) {
          EXPECT_EQ(inside, all);
        }
        if (direct == disjoint) {
          EXPECT_EQ(inside, 0);
        }
        if (direct == contained) {
          EXPECT_EQ(inside, total);
        }
        if (is_pixel(visit.area)) {
          EXPECT_TRUE(direct == surrounding || direct == disjoint);
        }
      }
    }
  });
}

TEST(WarnockAreas, InheritedCategoriesAreThoseFoundAnew) {
  for_known_scenes(40, [](const Known& known) {
    for (const Visited& visit : visits_of(known.scene, known.size)) {
      for (const auto& [fill, listed] : visit.list) {
        const auto vertices = known.scene.vertices(fill);
        EXPECT_EQ(category_of(vertices, extents_of(vertices, known.size), visit.area, known.size),
                  listed);
      }
    }
  });
}

/// The list of an area holds all that is seen in it.
TEST(WarnockAreas, NothingSeenIsMissingFromTheList) {
  for_known_scenes(40, [](const Known& known) {
    const std::vector<Fill> seen = z_buffered(known.scene, known.size);
    for (const Visited& visit : visits_of(known.scene, known.size)) {
      for_pixels(visit.area, [&](int column, int row) {
        const Fill fill = seen[index(known.size, column, row)];
        EXPECT_TRUE(fill == ViewedScene::kBackground ||
                    std::ranges::find(visit.list, fill, &PlainWarnock::Listed::fill) !=
                        visit.list.end());
      });
    }
  });
}

/// The areas that are not subdivided lie side by side, and are all of the rows; those that are come
/// to an end at pixels.
TEST(WarnockAreas, FillTheRows) {
  for_known_scenes(20, [](const Known& known) {
    const int begin = known.size.height / 3;
    std::vector<int> times(pixels(known.size));
    for (const Visited& visit : visits_of(known.scene, known.size, begin)) {
      if (visit.decision == Decision::subdivided) {
        EXPECT_FALSE(is_pixel(visit.area));
        continue;
      }
      for_pixels(visit.area, [&](int column, int row) { ++times[index(known.size, column, row)]; });
    }
    for_pixels({0, known.size.width, 0, known.size.height}, [&](int column, int row) {
      EXPECT_EQ(times[index(known.size, column, row)], row >= begin ? 1 : 0);
    });
  });
}

// ---- Pictures ----------------------------------------------------------------------------------

/// Empty if both forms show the fills of the truth, in bands of any height.
std::string wrong(const DisplayFile& file, const PictureSize& size) {
  const ViewedScene scene(file);
  const Picture expected = truth_as_entered(file, size.width, size.height, false);
  std::string wrong;
  for_both_forms({scene, size, {}}, [&](const ImageSpaceMethod& form, const char* name) {
    for (const int rows : {size.height, 5}) {
      const std::vector<Fill> seen = seen_by(form, size, rows);
      for_pixels({0, size.width, 0, size.height}, [&](int column, int row) {
        const int drawn = scene.pick(seen[index(size, column, row)]);
        const int true_id = expected.ids[index(size, column, size.height - 1 - row)];
        if (drawn == true_id || !wrong.empty()) return;
        wrong = fmt::format("{}, {} rows at a time, column {}, row {}: drawn {}, truth {}", name,
                            rows, column, row, drawn, true_id);
      });
    }
  });
  return wrong;
}

TEST(WarnockPictures, BothFormsAreTheTruth) {
  for_known_scenes(100, [](const Known& known) { EXPECT_EQ(wrong(known.file, known.size), ""); });
}

/// Large enough for the early form to subdivide.
TEST(WarnockPictures, BothFormsAreTheTruthWithManyPolygons) {
  for (const test::SceneFamily& family : test::scene_families()) {
    EXPECT_EQ(wrong(test::scene(family, 2000, 200), {100, 75}), "") << family.name;
  }
}

TEST(WarnockPictures, BothFormsAreTheTruthOfTheHardCases) {
  for (const HardCase& family : hard_cases()) {
    for (const double severity : family.severities) {
      const GraphicsSystem system = entered(family.make(family.size, severity, 5));
      const DisplayFile file = family.judged_from == JudgedFrom::entered
                                   ? system.display_file()
                                   : test::without_entered(system.display_file());
      EXPECT_EQ(wrong(file, {45, 36}), "") << family.name << ' ' << severity;
    }
  }
}

TEST(WarnockPictures, TakesUpOneSceneAfterAnother) {
  const ViewedScene left = scene_of({rectangle(0, 4, 0, 8, 0.5)});
  const ViewedScene none = scene_of({});
  Warnock warnock;
  warnock.prepare({left, kEight, {}}, 1);
  EXPECT_EQ(seen_by(warnock, kEight, 8), z_buffered(left, kEight));
  warnock.prepare({none, {3, 2}, {}}, 1);
  EXPECT_EQ(seen_by(warnock, {3, 2}, 2), std::vector<Fill>(6, ViewedScene::kBackground));
  warnock.prepare({left, {9, 4}, {}}, 1);
  EXPECT_EQ(seen_by(warnock, {9, 4}, 3), z_buffered(left, {9, 4}));
}

}  // namespace
}  // namespace displayfile
