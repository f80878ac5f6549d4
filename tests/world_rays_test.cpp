// Ray casting in object space: what its rays see, held against the truth of each view.

#include "interp/visibility/world_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "clip/error.h"
#include "interp/truth/truth.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/from_environment.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"
#include "tests/world_truth.h"

namespace displayfile {
namespace {

using test::from_environment;
using test::has_image_transformations;
using test::Source;

/// A scene as the application drew it and as it was retained.
struct Retained : test::Retained {
  explicit Retained(const Scene& drawn) { enter(drawn, system); }
  WorldRays rays() const { return {scene, system.display_file()}; }
};

/// The exact truth of the display file that the scene makes in the view.
std::vector<std::int32_t> truth_in(Scene scene, const View& view, int size) {
  scene.view = view;
  return truth(entered(scene).display_file(), size, size, false).ids;
}

PixelCentre centre_of_index(std::size_t k, int size) {
  const int i = static_cast<int>(k);
  return {i % size, size - 1 - i / size, {size, size}};
}

TEST(WorldRays, NoWrongPixelFromAnyEye) {
  const int eyes = from_environment("DISPLAYFILE_WORLD_RAYS_EYES", 12);
  const int size = from_environment("DISPLAYFILE_WORLD_RAYS_SIZE", 48);
  for (const GeneratedScene& generated : generated_scenes()) {
    const Scene scene = generated.make(generated.name == "planes" ? 16 : 200, 1);
    const Retained retained(scene);
    const WorldRays rays = retained.rays();
    const test::Ball3 ball = test::ball_around(scene.points);
    Source s(1);
    std::ptrdiff_t hits = 0;
    for (int i = 0; i < eyes; ++i) {
      const View view =
          i % 2 == 0 ? test::any_parallel_view(s, ball) : test::any_perspective_view(s, ball);
      const auto seen = rays.picks(view, {size, size}, 1 + i % 3);
      ASSERT_EQ(seen, truth_in(scene, view, size)) << generated.name << "\n" << test::text_of(view);
      hits += std::ssize(seen) - std::ranges::count(seen, -1);
    }
    EXPECT_GT(hits, eyes * size * size / 50) << generated.name;
  }
}

/// Front and back planes, a viewport that is a part of the picture, and a picture that is no
/// square.
TEST(WorldRays, NoWrongPixelInViewsThatClip) {
  const Scene city = generated_scene("city").make(300, 2);
  const Retained retained(city);
  const WorldRays rays = retained.rays();
  const test::Ball3 ball = test::ball_around(city.points);
  Source s(3);
  for (int i = 0; i < 16; ++i) {
    View view = test::any_view(s, ball);
    view.front_clipping = i % 2 == 0;
    view.back_clipping = i % 3 == 0;
    view.set_depth(-0.1 * ball.radius, 0.3 * ball.radius);
    if (i % 4 == 1) view.set_viewport({0.25, 0.75, 0.125, 1.0});
    Scene scene = city;
    scene.view = view;
    const auto seen = rays.picks(view, {64, 40});
    GraphicsSystem system;
    system.set_viewport(view.viewport.x_min, view.viewport.x_max, view.viewport.y_min,
                        view.viewport.y_max);
    enter(scene, system);
    const auto right = truth(system.display_file(), 64, 40, false).ids;
    std::size_t wrong = 0, first = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k] != right[k] && wrong++ == 0) first = k;
    }
    EXPECT_EQ(wrong, 0u) << "view " << i << ", pixel " << first % 64 << "," << 39 - first / 64
                         << ": " << seen[first] << ", truth " << right[first] << "; "
                         << test::text_of(view);
  }
}

/// Views in which much is edge-on or ties: from a vertex, or along an axis.
View special_view(Source& s, const Scene& scene, const test::Ball3& ball) {
  Point3 axis(0.0);
  axis[s.below(3)] = s.below(2) == 0 ? 1.0 : -1.0;
  if (s.below(2) == 0) {
    const auto any = static_cast<std::size_t>(s.below(static_cast<int>(scene.points.size())));
    return test::perspective_view(scene.points[any], axis, 1.0, ball);
  }
  return test::parallel_view(axis, axis, ball);
}

/// On scenes made to break methods what is seen may differ from the truth of the display file only
/// where the rounding of the transformation decides: it is then what the world's polygons give
/// unrounded.
TEST(WorldRays, DifferOnlyWhereTheTransformationsRoundingDecides) {
  const int eyes = from_environment("DISPLAYFILE_WORLD_RAYS_EYES", 2);
  const int size = from_environment("DISPLAYFILE_WORLD_RAYS_SIZE", 16);
  std::size_t pixels = 0, views = 0, rounding = 0;
  for (const HardCase& family : hard_cases()) {
    std::size_t of_family = 0;
    for (const double severity : family.severities) {
      const Scene scene = family.make(family.size, severity, 1);
      const Retained retained(scene);
      if (has_image_transformations(retained.system.display_file())) continue;  // after viewing
      const WorldRays rays = retained.rays();
      const test::WorldTruth world(retained.scene);
      const test::Ball3 ball = test::ball_around(scene.points);
      Source s(1);
      for (int i = 0; i < eyes; ++i) {
        const View view = i % 2 == 0 ? special_view(s, scene, ball) : test::any_view(s, ball);
        const auto seen = rays.picks(view, {size, size});
        const auto right = truth_in(scene, view, size);
        for (std::size_t k = 0; k < seen.size(); ++k) {
          if (seen[k] == right[k]) continue;
          ++of_family;
          const PixelCentre centre = centre_of_index(k, size);
          ASSERT_EQ(seen[k], world.seen_at(view, centre))
              << family.name << " " << severity << ", pixel " << centre.column << "," << centre.row
              << ", truth " << right[k] << "\n"
              << test::text_of(view);
        }
        ++views;
        pixels += seen.size();
      }
    }
    if (of_family > 0) std::cout << family.name << ": " << of_family << "\n";
    rounding += of_family;
  }
  std::cout << rounding << " of " << pixels << " pixels in " << views
            << " views are as the rounding of the transformation decides\n";
  EXPECT_GT(rounding, 0u) << "the check was never put to work";
}

/// Every pixel, by rational numbers.
TEST(WorldRays, SeesWhatTheWorldGivesUnrounded) {
  constexpr int kSize = 8;
  for (const HardCase& family : hard_cases()) {
    const Scene scene = family.make(family.size, family.severities.front(), 2);
    const Retained retained(scene);
    if (has_image_transformations(retained.system.display_file())) continue;
    const test::WorldTruth world(retained.scene);
    Source s(4);
    const View view = special_view(s, scene, test::ball_around(scene.points));
    const auto seen = retained.rays().picks(view, {kSize, kSize});
    for (std::size_t k = 0; k < seen.size(); ++k) {
      ASSERT_EQ(seen[k], world.seen_at(view, centre_of_index(k, kSize)))
          << family.name << ", pixel " << k << "\n"
          << test::text_of(view);
    }
  }
}

TEST(WorldRays, BackFacesRemovedAndHollowFillsNotSeen) {
  RetainedScene scene;
  GraphicsSystem g;
  g.retain(&scene);
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.set_back_face_removal(true);
  g.polygon_abs_3({{-0.9, -0.9, 0.5}, {-0.9, 0.9, 0.5}, {0.1, 0.0, 0.5}});  // a back face
  g.polygon_abs_3({{-0.9, -0.9, 0.3}, {0.1, 0.0, 0.3}, {-0.9, 0.9, 0.3}});
  g.set_fill_style({FillStyle::Kind::hollow});
  g.polygon_abs_3({{-0.9, -0.9, 0.9}, {0.9, -0.9, 0.9}, {0.9, 0.9, 0.9}, {-0.9, 0.9, 0.9}});
  g.close_segment();
  const WorldRays rays(scene, g.display_file());
  const auto seen = rays.picks(g.view(), {32, 32});
  EXPECT_EQ(seen, truth(g.display_file(), 32, 32, false).ids);
  EXPECT_GT(std::ranges::count(seen, 1), 100);

  g.set_visibility(1, false);
  EXPECT_EQ(WorldRays(scene, g.display_file()).polygons(), 0u);
  g.set_visibility(1, true);
  g.set_image_translation(1, 0.5, 0.0);
  EXPECT_THROW(WorldRays(scene, g.display_file()), Error);
}

}  // namespace
}  // namespace displayfile
