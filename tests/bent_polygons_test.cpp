// Polygons of more than three sides that are flat enough to be entered whole, and yet not flat:
// their plane is that of three vertices as entered, whatever the view and the clipping. Judged by
// the truth from the scene as entered.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "displayfile/views/scene_viewer.h"
#include "displayfile/views/turntable.h"
#include "interp/draw/draw.h"
#include "interp/truth/entered_truth.h"
#include "interp/visibility/image_space.h"
#include "tests/from_environment.h"
#include "tests/from_eyes.h"
#include "tests/ids_by_method.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::from_environment;
using test::ids_by;
using test::Retained;
using test::Source;
using test::wrong_pixels;
using EnterBent = void (*)(Source&, GraphicsSystem&);

constexpr int kBentSize = 48;

double in_range(Source& s, double least, double most) { return least + (most - least) * s.unit(); }

/// 1e-13 to 1e-7 of a polygon's size.
double bend(Source& s) {
  return (s.below(2) == 0 ? 1.0 : -1.0) * std::pow(10.0, in_range(s, -13.0, -7.0));
}

void enter_floor(double y, GraphicsSystem& g) {
  g.polygon_abs_3({{-2, y, -2}, {-2, y, 2}, {2, y, 2}, {2, y, -2}});
}

/// Every vertex is off the floor by as little as any other.
void enter_bent_rugs(Source& s, GraphicsSystem& g) {
  const double y = test::decimal(s, -1, 1);
  enter_floor(y, g);
  for (int n = 0; n < 3; ++n) {
    const double most = bend(s), x = in_range(s, -0.5, 0.5), z = in_range(s, -0.5, 0.5);
    std::vector<Point3> rug;
    const int sides = s.between(4, 7);
    for (int k = 0; k < sides; ++k) {
      const double angle = 6.28 * k / sides;
      rug.emplace_back(x + std::cos(angle), y + most * in_range(s, -1, 1), z + std::sin(angle));
    }
    g.polygon_abs_3(rug);
  }
}

/// One vertex is off the floor: the plane is the floor's, or close to it.
void enter_rugs_with_a_corner_up(Source& s, GraphicsSystem& g) {
  enter_floor(0.0, g);
  for (int n = 0; n < 3; ++n) {
    const double x = in_range(s, -1.5, 0.5), z = in_range(s, -1.5, 0.5),
                 size = in_range(s, 0.3, 1.5);
    std::vector<Point3> rug{{x, 0, z}, {x, 0, z + size}, {x + size, 0, z + size}, {x + size, 0, z}};
    rug[static_cast<std::size_t>(s.below(4))].y = bend(s);
    g.polygon_abs_3(rug);
  }
}

/// Boxes whose coordinates are in single precision after a turn: that bends each face.
void enter_boxes_in_single_precision(Source& s, GraphicsSystem& g) {
  const double angle = in_range(s, 0.0, 6.28), tilt = in_range(s, -0.5, 0.5);
  const auto turned = [&](double x, double y, double z) {
    const double along = std::cos(angle) * x - std::sin(angle) * z;
    const double across = std::sin(angle) * x + std::cos(angle) * z;
    const double up = std::cos(tilt) * y - std::sin(tilt) * across;
    const double deep = std::sin(tilt) * y + std::cos(tilt) * across;
    return Point3(static_cast<float>(along), static_cast<float>(up), static_cast<float>(deep));
  };
  const auto face = [&](const Point3& from, const Point3& u, const Point3& v) {
    std::vector<Point3> polygon;
    for (const Point3& p : {from, from + u, from + u + v, from + v}) {
      polygon.push_back(turned(p.x, p.y, p.z));
    }
    g.polygon_abs_3(polygon);
  };
  face({-1.5, 0, -1.5}, {3, 0, 0}, {0, 0, 3});
  for (int n = 0; n < 3; ++n) {
    const Point3 low(in_range(s, -1.2, 0.2), 0, in_range(s, -1.2, 0.2));
    const Point3 x(in_range(s, 0.2, 0.9), 0, 0), y(0, in_range(s, 0.2, 0.9), 0);
    const Point3 z(0, 0, in_range(s, 0.2, 0.9));
    face(low, x, z);
    face(low + y, x, z);
    face(low, x, y);
    face(low + z, x, y);
    face(low, y, z);
    face(low + x, y, z);
  }
}

/// Seen from anywhere, or in world coordinates that are those of the picture.
void begin(Source& s, GraphicsSystem& g, int seed) {
  if (seed % 4 == 3) {
    g.set_hidden_surfaces({.touching = Touching{Touching::Kind::off}});
    g.set_window(-1, 1, -1, 1);
  } else {
    test::view_from_anywhere(s, g, {Point3(0.0), seed % 4 == 1 ? 1.0 : 3.0});  // or clipped
  }
  if (seed % 4 == 2) test::turn_and_move(s, g);
  g.set_line_style({LineStyle::Kind::none});
  if (seed % 4 == 3) g.rotate_x_3(test::decimal(s, 10, 80));
}

void expect_right(EnterBent enter) {
  const int views = from_environment("DISPLAYFILE_BENT_VIEWS", 32 / test::kSlower);
  for (int seed = 0; seed < views; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    GraphicsSystem& g = retained.system;
    begin(s, g, seed);
    g.open_segment(1);
    enter(s, g);
    g.close_segment();
    const EnteredTruth truth =
        entered_truth(retained.scene, g.display_file(), kBentSize, kBentSize, false, std::nullopt);
    const bool is_transformed = seed % 4 >= 2;
    for (const HiddenMethod method : test::kSurfaceMethods) {
      // A modelling transformation has rounded the vertices before viewing.
      if (is_transformed && method == HiddenMethod::world_ray_cast) continue;
      EXPECT_EQ(wrong_pixels(ids_by(g, method, kBentSize), truth.picture), 0u) << name_of(method);
    }
  }
}

/// In views of the retained scene, by the methods that make no new display file.
void expect_right_in_new_views(EnterBent enter) {
  for (int seed = 0; seed < 12 / test::kSlower; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    Retained retained;
    begin(s, retained.system, 4 * seed);
    retained.system.open_segment(1);
    enter(s, retained.system);
    retained.system.close_segment();
    FromEyes renderer(retained.scene, retained.system.display_file());
    const Turntable turntable(retained.scene, retained.system.display_file(), {});
    for (const double degrees : {0.0, 35.0, 110.0, 245.0}) {
      SCOPED_TRACE(fmt::format("seed {}, {} degrees", seed, degrees));
      const auto [view, lights] = turntable.at(degrees);
      const auto truth =
          truth_as_entered(renderer.display_file(view, lights), kBentSize, kBentSize, false);
      for (const ImageSpaceEntry& entry : image_space_methods()) {
        if (entry.method == HiddenMethod::plain_z_buffer) continue;
        const DrawOptions options = test::options_for_ids(kBentSize, entry.method);
        EXPECT_EQ(wrong_pixels(renderer.draw(view, options, lights).ids, truth), 0u)
            << name_of(entry.method);
      }
    }
  }
}

TEST(BentPolygons, RugsOffTheirFloor) { expect_right(enter_bent_rugs); }
TEST(BentPolygons, RugsWithACornerUp) { expect_right(enter_rugs_with_a_corner_up); }
TEST(BentPolygons, BoxesInSinglePrecision) { expect_right(enter_boxes_in_single_precision); }
TEST(BentPolygons, InNewViews) {
  expect_right_in_new_views(enter_bent_rugs);
  expect_right_in_new_views(enter_boxes_in_single_precision);
}

}  // namespace
}  // namespace displayfile
