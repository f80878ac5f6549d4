// Pixel centres that viewing's rounding would decide: on sides, on vertices, and where planes meet,
// by every method. Judged by the truth from the scene as entered.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/picker.h"
#include "tests/from_environment.h"
#include "tests/from_eyes.h"
#include "tests/ids_by_method.h"
#include "tests/predicate_inputs.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::from_environment;
using test::ids_by;
using test::Retained;
using test::Source;
using test::wrong_pixels;

/// Views of which the matrix rounds, that put a grid's points on to centres or nearly.
void view_on_grid(Source& s, GraphicsSystem& g) {
  constexpr std::array<double, 4> kHalfSides{1.5, 3.0, 5.0, 3.5};
  const double half = kHalfSides[static_cast<std::size_t>(s.below(4))];
  g.set_window(-half, half, -half, half);
  switch (s.below(5)) {
    case 0: break;
    case 1:
      g.set_view_plane_normal({1, 0, 0});
      g.set_parallel({-1, 0, 0});
      break;
    case 2: g.set_perspective({0, 0, 5}); break;
    case 3:
      g.set_view_plane_normal({-1, -1, -1});
      g.set_parallel({1, 1, 1});
      break;
    default:
      g.set_view_plane_normal({-1, 0, -1});
      g.set_parallel({1, 0, 1});
      break;
  }
  if (s.below(3) == 0) g.set_viewport(0.0, 0.7, 0.0, 0.7);
  g.set_view_depth(-1.0, 1.0 + s.below(2));
  g.set_front_plane_clipping(s.below(4) == 0);
  g.set_back_plane_clipping(s.below(4) == 0);
}

double on_grid(Source& s, double step) { return s.between(-4, 4) * step; }

/// A triangle, or a rectangle that lies along two axes.
std::vector<Point3> polygon_on_grid(Source& s, double step) {
  const auto any = [&] { return Point3(on_grid(s, step), on_grid(s, step), on_grid(s, step)); };
  const Point3 p = any(), q = any();
  if (s.below(2) == 0) return {p, q, any()};
  const int level = s.below(3), across = (level + 1) % 3, up = (level + 2) % 3;
  std::vector<Point3> rectangle(4, p);
  rectangle[1][across] = rectangle[2][across] = q[across];
  rectangle[2][up] = rectangle[3][up] = q[up];
  return rectangle;
}

/// Polygons on a grid, some turned, in one segment or two.
void enter_polygons(Source& s, GraphicsSystem& g) {
  constexpr std::array<double, 4> kSteps{1.0, 0.5, 0.1, 0.3};
  const double step = kSteps[static_cast<std::size_t>(s.below(4))];
  const int segments = s.below(3) == 0 ? 2 : 1;
  for (int segment = 1; segment <= segments; ++segment) {
    g.open_segment(segment);
    if (s.below(3) == 0) g.rotate_z_3(s.below(2) == 0 ? 45 : 37);
    for (int n = s.between(2, 6); n > 0; --n) g.polygon_abs_3(polygon_on_grid(s, step));
    g.close_segment();
  }
}

void enter_on_grid(Source& s, GraphicsSystem& g) {
  view_on_grid(s, g);
  enter_polygons(s, g);
}

Picture truth_of(const Retained& retained, int size) {
  return entered_truth(retained.scene, retained.system.display_file(), size, size, false,
                       std::nullopt)
      .picture;
}

/// The picked identifiers at the centre of each pixel.
std::vector<std::int32_t> picked_ids(const GraphicsSystem& g, int size) {
  Picker picker(std::make_shared<const ViewedScene>(g.display_file()), {size, size}, 1);
  std::vector<std::int32_t> ids;
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const auto pick = picker.pick(*picker.pixel_at(column + 0.5, row + 0.5, 0.0), 0.0);
      ids.push_back(pick ? pick->id : -1);
    }
  }
  return ids;
}

int scenes() { return from_environment("DISPLAYFILE_GRID_SCENES", 150 / test::kSlower); }
int size_of(Source& s) {
  constexpr std::array kSizes{10, 12, 14, 20, 30};
  return kSizes[static_cast<std::size_t>(s.below(5))];
}

TEST(FillsAsEntered, NoPixelIsWrongByAnyMethodWhereCentresLieOnSides) {
  std::size_t decided_by_viewing = 0;
  for (int seed = 0; seed < scenes(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed));
    const int size = size_of(s);
    Retained retained;
    enter_on_grid(s, retained.system);
    const Picture truth = truth_of(retained, size);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      EXPECT_EQ(wrong_pixels(ids_by(retained.system, method, size), truth), 0u) << name_of(method);
    }
    EXPECT_EQ(wrong_pixels(picked_ids(retained.system, size), truth), 0u) << "picks";
    decided_by_viewing += wrong_pixels(
        displayfile::truth(retained.system.display_file(), size, size, false).ids, truth);
  }
  EXPECT_GT(decided_by_viewing, 0u) << "viewing decides nothing in these scenes";
}

/// An image transformation comes after viewing: it rounds once more.
TEST(FillsAsEntered, NoPixelIsWrongUnderImageTransformations) {
  for (int seed = 0; seed < scenes(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed) + 5000);
    const int size = size_of(s);
    Retained retained;
    GraphicsSystem& g = retained.system;
    enter_on_grid(s, g);
    if (s.below(2) == 0) g.set_image_rotation(1, 45);
    if (s.below(2) == 0) g.set_image_scale(1, 0.5, 0.3);
    g.set_image_translation(1, 0.1 * s.below(3), 0.05 * s.below(3));
    const Picture truth = truth_of(retained, size);
    for (const HiddenMethod method : test::kSurfaceMethods) {
      if (method == HiddenMethod::world_ray_cast) continue;
      EXPECT_EQ(wrong_pixels(ids_by(g, method, size), truth), 0u) << name_of(method);
    }
  }
}

/// Views of a retained scene, each with the data that earlier views left in memory.
TEST(FillsAsEntered, NoPixelIsWrongInKeptViews) {
  for (int seed = 0; seed < scenes() / 3; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto of_scene = static_cast<std::uint64_t>(seed) + 9000;
    const auto enter = [&](GraphicsSystem& g) {
      Source s(of_scene);
      enter_polygons(s, g);
    };
    Retained kept;
    enter(kept.system);
    for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::scan_line}) {
      FromEyes views(kept.scene, kept.system.display_file());
      Source s(of_scene);
      for (int n = 0; n < 3; ++n) {
        Retained alone;
        view_on_grid(s, alone.system);
        enter(alone.system);
        const int size = size_of(s);
        const Picture& picture =
            views.draw(alone.system.view(), test::options_for_ids(size, method));
        EXPECT_EQ(wrong_pixels(picture.ids, truth_of(alone, size)), 0u) << name_of(method);
      }
    }
  }
}

}  // namespace
}  // namespace displayfile
