// One tree, many views: the drawings of RetainedViews, compared with the truth of each view.

#include "displayfile/views/retained_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/sorted_display_file.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/from_environment.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"
#include "tests/world_truth.h"

namespace displayfile {
namespace {

using namespace test;

test::Ball3 ball_around_all(const RetainedScene& scene) {
  std::vector<Point3> points;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    const auto more = scene.points(segment);
    points.insert(points.end(), more.begin(), more.end());
  }
  return test::ball_around(points);
}

// ---- From a hundred eyes -----------------------------------------------------------------

/// As many polygons as keep the test short.
struct Generated {
  const char* name;
  int polygons;
};
class GeneratedScenes : public testing::TestWithParam<Generated> {};
INSTANTIATE_TEST_SUITE_P(, GeneratedScenes,
                         testing::Values(Generated{"city", 300}, Generated{"village", 300},
                                         Generated{"terrain", 300}, Generated{"soup", 300},
                                         Generated{"planes", 16}, Generated{"cycles", 150},
                                         Generated{"needles", 200}),
                         [](const auto& p) { return std::string(p.param.name); });

TEST_P(GeneratedScenes, NoWrongPixelFromAnyEye) {
  const int polygons = GetParam().polygons * from_environment("DISPLAYFILE_WORLD_TREE_TIMES", 1);
  const int size = from_environment("DISPLAYFILE_WORLD_TREE_SIZE", 64);
  Retained retained;
  enter(generated_scene(GetParam().name).make(static_cast<std::size_t>(polygons), 1),
        retained.system);
  RetainedViews views(retained.scene, retained.system.display_file(), {});
  const test::Ball3 ball = ball_around_all(retained.scene);
  Source s(1);
  constexpr std::size_t kEyes = 100 / kSlower;
  std::size_t viewed = 0, pixels = 0, undecided = 0;
  for (std::size_t i = 0; i < kEyes; ++i) {
    const View view =
        i % 2 == 0 ? test::any_parallel_view(s, ball) : test::any_perspective_view(s, ball);
    const DisplayFile file = views.view(view);
    const Judged picture = judged(file, size);
    ASSERT_TRUE(picture.wrong.empty()) << text_of(picture.wrong[0]) << "\n" << test::text_of(view);
    viewed += file.polygons();
    pixels += picture.pixels;
    undecided += picture.undecided;
  }
  EXPECT_GT(viewed, kEyes * static_cast<std::size_t>(polygons) / 4);
  EXPECT_LT(undecided, pixels / 1000) << "the order is hardly put to the test";
}

/// Eyes in special places: at a vertex, on the line of an edge, looking along an axis.
View special_view(Source& s, const Scene& scene, const test::Ball3& ball) {
  const auto any = [&](std::size_t n) { return s.below(static_cast<int>(n)); };
  const Point3 vertex = scene.points[static_cast<std::size_t>(any(scene.points.size()))];
  const auto i = static_cast<std::size_t>(any(scene.points.size() - 1));
  const Point3 edge = scene.points[i + 1] - scene.points[i];
  Point3 axis(0.0);
  axis[any(3)] = any(2) == 0 ? 1.0 : -1.0;
  const bool along_edge = any(2) == 0 && glm::length(edge) > 0.01 * ball.radius;
  const Point3 into = along_edge ? edge : axis;
  if (any(2) == 0) {
    return test::perspective_view(along_edge ? scene.points[i] : vertex, into, 1.0, ball);
  }
  return test::parallel_view(into, into, ball);
}

/// The results for a family.
struct Tally {
  std::size_t views = 0, pixels = 0, undecided = 0;
  std::size_t rounding = 0;  ///< pixels that the rounding of the transformation decides
};

/// On scenes made to break methods the picture may differ where the rounding of the transformation
/// itself decides, and only there: it then equals the picture of the world's polygons without
/// rounding.
void judge_family(const HardCase& family, int eyes, int size, Tally& tally) {
  for (const double severity : family.severities) {
    const Scene scene = family.make(family.size, severity, 1);
    Retained retained;
    enter(scene, retained.system);
    if (has_image_transformations(retained.system.display_file())) continue;  // after viewing
    RetainedViews views(retained.scene, retained.system.display_file(), {});
    const test::WorldTruth world(retained.scene);
    const test::Ball3 ball = ball_around_all(retained.scene);
    Source s(1);
    for (int i = 0; i < eyes; ++i) {
      const View view = i % 2 == 0 ? special_view(s, scene, ball) : test::any_view(s, ball);
      const Judged picture = judged(views.view(view), size);
      for (const Pixel& pixel : picture.wrong) {
        const std::int32_t right = world.seen_at(view, pixel.centre);
        ASSERT_EQ(pixel.drawn, right)
            << family.name << " " << severity << ", " << text_of(pixel) << "\n"
            << test::text_of(view);
      }
      ++tally.views;
      tally.pixels += picture.pixels;
      tally.undecided += picture.undecided;
      tally.rounding += picture.wrong.size();
    }
  }
}

TEST(HardCases, DifferOnlyWhereTheTransformationsRoundingDecides) {
  const int eyes = from_environment("DISPLAYFILE_WORLD_TREE_EYES", test::kSlower > 1 ? 2 : 6);
  const int size = from_environment("DISPLAYFILE_WORLD_TREE_SIZE", 32);
  Tally all;
  for (const HardCase& family : hard_cases()) {
    Tally tally;
    judge_family(family, eyes, size, tally);
    if (tally.rounding > 0) {
      std::cout << family.name << ": " << tally.rounding << " pixels of " << tally.pixels << " in "
                << tally.views << " views are as the rounding of the transformation decides\n";
    }
    all.views += tally.views;
    all.pixels += tally.pixels;
    all.undecided += tally.undecided;
    all.rounding += tally.rounding;
  }
  std::cout << all.rounding << " of " << all.pixels << " pixels in " << all.views << " views; "
            << all.undecided << " were not left to the order\n";
  EXPECT_GT(all.rounding, 0u) << "the check was never put to work";
  EXPECT_LT(all.undecided, all.pixels / 10) << "the order is hardly put to the test";
}

// ---- Meshes ------------------------------------------------------------------------------

/// The mesh files that DISPLAYFILE_WORLD_TREE_MESHES names, or that are in the folders it names,
/// separated by colons; one of the import library's own, where it names none.
std::vector<std::string> mesh_files() {
  std::vector<std::string> files;
  const char* const set = std::getenv("DISPLAYFILE_WORLD_TREE_MESHES");
  std::istringstream names(set == nullptr ? "/usr/share/assimp/models/OBJ/spider.obj" : set);
  for (std::string name; std::getline(names, name, ':');) {
    if (!std::filesystem::is_directory(name)) {
      files.push_back(name);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(name)) {
      if (entry.path().extension() == ".obj") files.push_back(entry.path().string());
    }
  }
  return files;
}

TEST(Meshes, NoWrongPixelFromAnyEye) {
  const std::vector<std::string> files = mesh_files();
  const int size = from_environment("DISPLAYFILE_WORLD_TREE_SIZE", 200);
  const int eyes = from_environment("DISPLAYFILE_WORLD_TREE_EYES", kSlower > 1 ? 2 : 10);
  for (const std::string& file : files) {
    const Mesh mesh = read_mesh(file);
    Retained retained;
    fit_view(std::span(&mesh, 1), retained.system);
    retained.system.set_line_style({LineStyle::Kind::none});
    enter_mesh(mesh, retained.system, 1);
    RetainedViews views(retained.scene, retained.system.display_file(), {});
    const test::WorldTruth world(retained.scene);
    const test::Ball3 ball = ball_around_all(retained.scene);
    const std::size_t polygons = retained.system.display_file().polygons();
    Source s(1);
    Tally tally;
    for (int i = 0; i < eyes; ++i) {
      const View view =
          i % 2 == 0 ? test::any_parallel_view(s, ball) : test::any_perspective_view(s, ball);
      const Judged picture = judged(views.view(view), size);
      for (const Pixel& pixel : picture.wrong) {
        EXPECT_EQ(pixel.drawn, world.seen_at(view, pixel.centre))
            << file << ", " << text_of(pixel) << "\n"
            << test::text_of(view);
      }
      ++tally.views;
      tally.pixels += picture.pixels;
      tally.undecided += picture.undecided;
      tally.rounding += picture.wrong.size();
    }
    std::cout << std::filesystem::path(file).stem().string() << ": " << polygons << " polygons, "
              << views.counts().pieces << " pieces, " << tally.views << " eyes, " << tally.rounding
              << " pixels of " << tally.pixels << " other than the truth, " << tally.undecided
              << " not left to the order\n";
    EXPECT_EQ(tally.rounding, 0u) << file;
  }
}

// ---- The retained scene ------------------------------------------------------------------

/// As entered, the display file of a view equals the application's own drawing in that view.
TEST(RetainedViews, TheSameInstructionsAsDrawnInThatView) {
  Retained retained;
  enter_two_segments(retained.system);
  const View drawn_in = retained.system.view();
  for (const HiddenScope scope : {HiddenScope::segment, HiddenScope::all}) {
    RetainedViews views(retained.scene, retained.system.display_file(), {.scope = scope});
    EXPECT_EQ(views.trees(), scope == HiddenScope::all ? 1u : 2u);
    EXPECT_EQ(entered_text(views.view(drawn_in)), entered_text(retained.system.display_file()));
    GraphicsSystem other;
    other.set_window(-0.5, 0.5, -0.3, 0.7);
    enter_two_segments(other);
    View moved = drawn_in;
    moved.set_window({-0.5, 0.5, -0.3, 0.7});
    EXPECT_EQ(entered_text(views.view(moved)), entered_text(other.display_file()));
    EXPECT_EQ(views.walks(), views.trees());  // the eye has not moved
    EXPECT_EQ(views.reused(), views.trees());
  }
}

struct Walked {
  std::vector<int> segments, picks;
  std::size_t polygons = 0, lines = 0, visible_sides = 0;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(int id) { picks.push_back(id); }
  void segment(int name) { segments.push_back(name); }
  void move(const Point3&) {}
  void line(const Point3&) { ++lines; }
  void polygon(std::span<const Point3>, std::span<const std::int32_t> sides) {
    ++polygons;
    visible_sides += static_cast<std::size_t>(std::ranges::count(sides, op::line));
  }
};

TEST(RetainedViews, ASortedSceneNamesTheSegmentWhereItChanges) {
  Retained retained;
  enter_two_segments(retained.system);
  RetainedViews views(retained.scene, retained.system.display_file(), {});
  const DisplayFile file = views.view(retained.system.view());
  ASSERT_NE(file.sorted(), nullptr);
  Walked sorted;
  file.sorted()->walk(sorted);
  EXPECT_GT(sorted.segments.size(), 2u) << "the segments run through each other";
  EXPECT_EQ(std::ranges::adjacent_find(sorted.segments), sorted.segments.end());
  EXPECT_GT(sorted.polygons, file.polygons());
  EXPECT_GT(views.counts().cuts, 0u);
  for (const int id : sorted.picks) EXPECT_TRUE(id <= 2 || id == 70) << id;
}

/// Where an order's lines run that are drawn as such, and which of them are hidden.
std::string strokes_of(const SortedScene& sorted) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& part : sorted.parts) {
    const SortedPieces& all = part->pieces;
    for (std::size_t k = 0; k < all.pieces.size(); ++k) {
      if (!all.is_stroke(k)) continue;
      text << (all.is_hidden(k) ? "hidden" : "seen") << " of " << all.pieces[k].item;
      for (std::uint32_t i = all.pieces[k].first; i < all.pieces[k].first + 2; ++i) {
        text << ' ' << all.points[i].x << ' ' << all.points[i].y << ' ' << all.points[i].z;
      }
      text << '\n';
    }
  }
  return text.str();
}

/// Bit for bit: they are found in the view, not in the world.
TEST(RetainedViews, HiddenLinesAndIntersectionsAreThoseOfTheSceneDrawnInThatView) {
  const auto draw_along = [](const Point3& normal) {
    GraphicsSystem g;
    g.set_view_plane_normal(normal);
    g.set_back_face_removal(false);
    g.set_hidden_surfaces({.lines = line_selection("all,intersection")});
    enter_two_segments(g);
    return g;
  };
  const GraphicsSystem first = draw_along({0.0, 0.0, -1.0});
  for (const HiddenScope scope : {HiddenScope::segment, HiddenScope::all}) {
    for (const HiddenLines hidden : {HiddenLines::none, HiddenLines::dashed}) {
      RetainedViews views(*first.retained(), first.display_file(),
                          {.hidden_lines = hidden, .scope = scope});
      for (const Point3& normal : {Point3(0.0, 0.0, -1.0), Point3(0.3, -0.2, -1.0)}) {
        const GraphicsSystem there = draw_along(normal);
        SortedDisplayFile sorted;
        const DisplayFile& right =
            sorted.update(there, HiddenMethod::bsp,
                          {.method = HiddenMethod::bsp, .scope = scope, .hidden_lines = hidden});
        const DisplayFile file = views.view(there.view());
        const auto strokes = [&](const DisplayFile& drawn) {
          if (scope == HiddenScope::all) return strokes_of(*drawn.sorted());
          std::string text;
          for (const Segment& segment : drawn.segments()) text += strokes_of(*segment.sorted());
          return text;
        };
        const std::string found = strokes(file);
        EXPECT_NE(found.find("seen"), std::string::npos);
        EXPECT_EQ(found.find("hidden") != std::string::npos, hidden == HiddenLines::dashed);
        EXPECT_EQ(found, strokes(right));
        EXPECT_EQ(drawn(file, 120).pixels, drawn(right, 120).pixels);
      }
    }
  }
}

TEST(RetainedViews, InvisibleSegmentsAreLeftOut) {
  Retained retained;
  enter_two_segments(retained.system);
  retained.system.set_visibility(4, false);
  RetainedViews views(retained.scene, retained.system.display_file(), {});
  const DisplayFile file = views.view(retained.system.view());
  ASSERT_EQ(file.segments().size(), 1u);
  EXPECT_EQ(file.segments()[0].name(), 2);
}

TEST(RetainedViews, FollowsDeletedAndRenamedSegments) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  enter_two_segments(g);
  g.delete_segment(4);
  g.rename_segment(2, 9);
  RetainedViews views(retained.scene, g.display_file(), {});
  EXPECT_EQ(entered_text(views.view(g.view())), entered_text(g.display_file()));
  g.delete_all_segments();
  EXPECT_TRUE(retained.scene.segments().empty());
  RetainedViews none(retained.scene, g.display_file(), {});
  EXPECT_TRUE(none.view(g.view()).segments().empty());
}

TEST(RetainedViews, ImageTransformationsActAfterViewing) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  enter(generated_scene("soup").make(40, 1), g);
  const int name = g.display_file().segments()[0].name();
  g.set_image_scale(name, 0.5, 0.75);
  g.set_image_rotation(name, 30.0);
  g.set_image_translation(name, 0.3, 0.1);
  for (const HiddenScope scope : {HiddenScope::segment, HiddenScope::all}) {
    RetainedViews views(retained.scene, g.display_file(), {.scope = scope});
    Source s(1);
    for (int i = 0; i < 10; ++i) {
      const View view = test::any_view(s);
      const Judged picture = judged(views.view(view), 48);
      ASSERT_TRUE(picture.wrong.empty()) << text_of(picture.wrong[0]);
    }
  }
}

TEST(RetainedViews, RefusesSegmentsMovedApartToBeSortedTogether) {
  Retained retained;
  enter_two_segments(retained.system);
  retained.system.set_image_translation(2, 0.1, 0.0);
  const DisplayFile& file = retained.system.display_file();
  EXPECT_THROW(RetainedViews(retained.scene, file, {}), Error);
  EXPECT_NO_THROW(RetainedViews(retained.scene, file, {.scope = HiddenScope::segment}));
}

TEST(RetainedViews, RetainingBeginsWithTheFirstSegment) {
  GraphicsSystem g;
  enter_two_segments(g);
  RetainedScene scene;
  EXPECT_THROW(g.retain(&scene), Error);
  EXPECT_NO_THROW(g.retain(nullptr));
}

/// Polygons whose vertices are in line in space cover nothing; their outlines are drawn.
TEST(RetainedViews, DegeneratePolygonsKeepTheirOutlines) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0.0}, {0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}});
  g.polygon_abs_3({{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}});
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({{-0.5, 0.5, 0.0}, {0.0, 0.0, 0.0}, {0.5, -0.5, 0.0}});
  g.close_segment();
  RetainedViews views(retained.scene, g.display_file(), {});
  const DisplayFile file = views.view(g.view());
  EXPECT_EQ(file.polygons(), 3u);
  Walked sorted;
  file.sorted()->walk(sorted);
  EXPECT_GE(sorted.lines + sorted.visible_sides, 3u);
  EXPECT_TRUE(judged(file, 32).wrong.empty());
}

}  // namespace
}  // namespace displayfile
