// One tree, many views: what RetainedViews draws, held against the truth of each view.

#include "displayfile/retained_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/dump.h"
#include "displayfile/fitted_view.h"
#include "displayfile/mesh.h"
#include "displayfile/turntable.h"
#include "hard/generated_scenes.h"
#include "hard/hard_cases.h"
#include "interp/software.h"
#include "interp/truth.h"
#include "tests/random_views.h"
#include "tests/world_truth.h"

namespace displayfile {
namespace {

using test::Source;

int from_environment(const char* name, int usual) {
  const char* const set = std::getenv(name);
  return set == nullptr ? usual : std::atoi(set);
}

/// A scene as the application drew it and as it was retained.
struct Retained {
  RetainedScene scene;
  GraphicsSystem system;
  Retained() { system.retain(&scene); }
  Retained(const Retained&) = delete;
  Retained& operator=(const Retained&) = delete;
};

Picture drawn(const DisplayFile& file, int size) {
  RasterRequest request;
  request.width = request.height = size;
  request.ids = request.sorted = true;
  return draw_with_software(file, request);
}

struct Pixel {
  PixelCentre centre;
  std::int32_t drawn, truth;
};
std::string text_of(const Pixel& pixel) {
  std::ostringstream out;
  out << "pixel " << pixel.centre.column << "," << pixel.centre.row << ": " << pixel.drawn
      << " was drawn in place of " << pixel.truth;
  return out.str();
}

/// A picture held against the truth of the same view, whole polygons in order of entry.
struct Judged {
  std::vector<Pixel> wrong;
  std::size_t pixels = 0;
  std::size_t undecided = 0;  ///< not left to the order of the tree
};
Judged judged(const DisplayFile& file, int size) {
  const Picture picture = drawn(file, size);
  const std::vector<std::int32_t> right = truth(file, size, size, false).ids;
  Judged judged{{}, right.size(), picture.undecided_centres};
  for (int i = 0; i < size * size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (picture.ids[k] == right[k]) continue;
    judged.wrong.push_back(
        {{i % size, size - 1 - i / size, {size, size}}, picture.ids[k], right[k]});
  }
  return judged;
}

/// Around all points of a scene.
test::Ball3 ball_around(const RetainedScene& scene) {
  std::vector<Point3> points;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    points.insert(points.end(), segment.points.begin(), segment.points.end());
  }
  Point3 low = points.at(0), high = low;
  for (const Point3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {0.5 * (low + high), 0.51 * glm::length(high - low)};
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
  const test::Ball3 ball = ball_around(retained.scene);
  Source s(1);
  std::size_t viewed = 0, pixels = 0, undecided = 0;
  for (int i = 0; i < 100; ++i) {
    const View view =
        i % 2 == 0 ? test::any_parallel_view(s, ball) : test::any_perspective_view(s, ball);
    const DisplayFile file = views.view(view);
    const Judged picture = judged(file, size);
    ASSERT_TRUE(picture.wrong.empty()) << text_of(picture.wrong[0]) << "\n" << test::text_of(view);
    viewed += file.polygons();
    pixels += picture.pixels;
    undecided += picture.undecided;
  }
  EXPECT_GT(viewed, 25u * static_cast<std::size_t>(polygons));
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
  View view = test::looking(into);
  view.set_reference_point(ball.middle);
  view.set_parallel(into);
  view.set_depth(-2.0 * ball.radius, 2.0 * ball.radius);
  view.set_window({-ball.radius, ball.radius, -ball.radius, ball.radius});
  return view;
}

bool has_image_transformations(const DisplayFile& file) {
  return std::ranges::any_of(file.segments(),
                             [](const Segment& segment) { return !segment.image.is_identity(); });
}

/// What was found of a family.
struct Tally {
  std::size_t views = 0, pixels = 0, undecided = 0;
  std::size_t rounding = 0;  ///< pixels that the rounding of the transformation decides
};

/// On scenes made to break methods the picture may differ where the rounding of the transformation
/// itself decides, and only there: it then shows what the world's polygons give unrounded.
void judge_family(const HardCase& family, int eyes, int size, Tally& tally) {
  for (const double severity : family.severities) {
    const Scene scene = family.make(family.size, severity, 1);
    Retained retained;
    enter(scene, retained.system);
    if (has_image_transformations(retained.system.display_file())) continue;  // after viewing
    RetainedViews views(retained.scene, retained.system.display_file(), {});
    const test::WorldTruth world(retained.scene);
    const test::Ball3 ball = ball_around(retained.scene);
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
  const int eyes = from_environment("DISPLAYFILE_WORLD_TREE_EYES", 6);
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
/// separated by colons.
std::vector<std::string> mesh_files() {
  std::vector<std::string> files;
  const char* const set = std::getenv("DISPLAYFILE_WORLD_TREE_MESHES");
  std::istringstream names(set == nullptr ? "" : set);
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
  if (files.empty()) GTEST_SKIP() << "DISPLAYFILE_WORLD_TREE_MESHES names no meshes";
  const int size = from_environment("DISPLAYFILE_WORLD_TREE_SIZE", 200);
  const int eyes = from_environment("DISPLAYFILE_WORLD_TREE_EYES", 100);
  for (const std::string& file : files) {
    const Mesh mesh = read_mesh(file);
    Retained retained;
    fit_view(std::span(&mesh, 1), retained.system);
    retained.system.set_line_style({LineStyle::Kind::none});
    enter_mesh(mesh, retained.system, 1);
    RetainedViews views(retained.scene, retained.system.display_file(), {});
    const test::WorldTruth world(retained.scene);
    const test::Ball3 ball = ball_around(retained.scene);
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

}  // namespace
}  // namespace displayfile
