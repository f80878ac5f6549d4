// Modelling transformations, saved ones too, and the image transformations of segments.

#include "displayfile/graphics_system.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/draw/draw.h"
#include "tests/error_of.h"
#include "tests/listing.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

using test::expect_error;
using test::listing;
using test::unit_square;

TEST(GraphicsSystem, ModellingTransformationsActInTheOrderOfTheCalls) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.translate_3(0.5, 0, 0);
  g.rotate_z_3(90);  // turns the moved point about the origin, exactly
  g.move_abs_3(0, 0, 0);
  g.create_transformation_3();
  g.line_abs_3(0.25, 0.25, 0);
  g.scale_3(2, 4, 1);
  g.line_abs_3(0.25, 0.25, 0);
  g.close_segment();
  EXPECT_EQ(listing(g, 1), "solid;move 0 0.5 0;line 0.25 0.25 0;line 0.5 1 0;");
}

TEST(GraphicsSystem, ImageTransformationScalesThenRotatesThenTranslates) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.move_abs_2(0, 0);
  g.line_abs_2(0.5, 0.25);
  g.close_segment();
  g.set_image_translation(1, 0.5, 0.125);
  g.set_image_rotation(1, 90);
  g.set_image_scale(1, 2, 1);
  EXPECT_EQ(listing(g, 1), "solid;move 0.5 0.125 0;line 0.25 1.125 0;");
}

/// The centre stays where it is, whatever the scale and the rotation; unset, or of no effect, it
/// changes no bit.
TEST(GraphicsSystem, ImageTransformationAboutACentreOfItsOwn) {
  const auto drawn = [](const std::function<void(GraphicsSystem&)>& set) {
    GraphicsSystem g = unit_square();
    g.open_segment(1);
    g.move_abs_2(0.5, 0.25);
    g.line_abs_2(0.75, 0.375);
    g.close_segment();
    set(g);
    return listing(g, 1);
  };
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_centre(1, 0.5, 0.25);
              g.set_image_rotation(1, 90);
              g.set_image_scale(1, 2, 1);
            }),
            "solid;move 0.5 0.25 0;line 0.375 0.75 0;");
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_rotation(1, 180);
              g.set_image_translation(1, 0.125, 0);
              g.set_image_centre(1, 0.5, 0.25);
            }),
            "solid;move 0.625 0.25 0;line 0.375 0.125 0;");
  const auto plain = drawn([](GraphicsSystem&) {});
  EXPECT_EQ(drawn([](GraphicsSystem& g) { g.set_image_centre(1, 0.3, 0.7); }), plain);
  EXPECT_EQ(drawn([](GraphicsSystem& g) {
              g.set_image_rotation(1, 17);
              g.set_image_centre(1, 0, 0);
            }),
            drawn([](GraphicsSystem& g) { g.set_image_rotation(1, 17); }));
  drawn([](GraphicsSystem& g) {
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), 1.1e9, -1e300}) {
      expect_error([&] { g.set_image_centre(1, wrong, 0); }, "image centre is");
      expect_error([&] { g.set_image_centre(1, 0, wrong); }, "at most 1e9");
    }
    EXPECT_EQ(g.display_file().segment(1).image, ImageTransformation{});
  });
}

/// to_device returns the end of a line that goes there, to the bit.
TEST(GraphicsSystem, ToDeviceIsWhereThingsAreDrawn) {
  const auto expect_same = [](GraphicsSystem& g) {
    const Point3 joint(0.125, -0.25, 0.5);
    const std::optional<Point3> before = g.to_device(joint);
    g.open_segment(1);
    EXPECT_EQ(g.to_device(joint), before);
    g.move_abs_3(0, 0, 0);
    g.line_abs_3(joint.x, joint.y, joint.z);
    g.close_segment();
    EXPECT_EQ(g.display_file().segment(1).entered()->stored_points().back(), before);
  };
  GraphicsSystem parallel;
  parallel.rotate_z_3(33);
  parallel.translate_3(0.1, 0.2, -0.1);
  expect_same(parallel);

  GraphicsSystem perspective;
  perspective.set_perspective({0.3, 0.2, 4});
  perspective.set_window(-1, 1, -2, 1);
  perspective.set_window_fit(WindowFit::widen);
  perspective.set_viewport(0.25, 0.75, 0, 1);
  perspective.set_aspect_ratio(1.5);
  perspective.rotate_x_3(-20);
  expect_same(perspective);
  EXPECT_FALSE(perspective.to_device({0, -10, 20})) << "behind the eye";
  perspective.create_transformation_3();
  EXPECT_FALSE(perspective.to_device({0.3, 0.2, 4})) << "the eye";
  const std::optional<Point3> outside = perspective.to_device({100, 0, 0});
  ASSERT_TRUE(outside);
  EXPECT_GT(outside->x, 1.0);
  expect_error([&] { perspective.to_device({0, 0, 1e300}); }, "coordinates 0 0 1e+300");
  perspective.set_perspective({0, 0, -4});
  expect_error([&] { perspective.to_device({0, 0, 0}); }, "centre of projection");
}

/// A saved transformation acts last: an arm is written from the outside in.
TEST(GraphicsSystem, WhatIsSavedActsOnAllThatIsCalledUntilItIsRestored) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.rotate_z_3(90);
  g.translate_3(0.5, 0.25, 0);
  g.move_abs_3(0, 0, 0);
  g.save_transformation_3();
  g.line_abs_3(0.125, 0, 0);  // as before
  g.translate_3(0.25, 0, 0);  // along the arm, which stands upright
  g.line_abs_3(0, 0, 0);
  g.save_transformation_3();
  g.rotate_z_3(90);
  g.translate_3(0.125, 0, 0);
  g.line_abs_3(0.125, 0, 0);
  g.create_transformation_3();  // anew in the coordinates saved last
  g.line_abs_3(0, 0, 0);
  g.restore_transformation_3();
  g.line_abs_3(0.0625, 0, 0);
  g.restore_transformation_3();
  g.line_abs_3(0, 0, 0);
  g.create_transformation_3();
  g.line_abs_3(1, 1, 0);
  g.close_segment();
  EXPECT_EQ(listing(g, 1),
            "solid;move 0.5 0.25 0;line 0.5 0.375 0;line 0.5 0.5 0;line 0.375 0.625 0;"
            "line 0.5 0.5 0;line 0.5 0.5625 0;line 0.5 0.25 0;line 1 1 0;");
}

/// A restored transformation equals the saved one to the bit, normals of vertices go the same way,
/// and a refused call changes nothing.
TEST(GraphicsSystem, SavedTransformations) {
  const auto draw = [](GraphicsSystem& g) {
    g.set_vertex_normals({{0, 0, 1}, {1, 2, 3}, {0, 1, 1}});
    g.polygon_abs_3({{0.1, 0.1, 0.3}, {0.3, 0.1, 0.1}, {0.1, 0.3, 0.2}});
  };
  const auto start = [](GraphicsSystem& g) {
    g.set_light({1, 2, 3});
    g.set_shading(Shading::gouraud);
    g.open_segment(1);
  };
  GraphicsSystem plain, nested;
  start(plain);
  start(nested);
  plain.rotate_x_3(33);
  plain.scale_3(0.7, 0.8, -0.9);
  plain.rotate_y_3(21);
  draw(plain);
  nested.rotate_y_3(21);
  nested.save_transformation_3();
  nested.scale_3(0.7, 0.8, -0.9);
  nested.save_transformation_3();
  nested.rotate_x_3(33);
  draw(nested);
  plain.close_segment();
  nested.close_segment();
  const auto values = [](const GraphicsSystem& g) {
    std::vector<double> all;
    for (const Point3& p : g.display_file().segment(1).entered()->stored_points()) {
      all.insert(all.end(), {p.x, p.y, p.z});
    }
    const auto intensities = g.display_file().segment(1).entered()->stored_intensities();
    all.insert(all.end(), intensities.begin(), intensities.end());
    return all;
  };
  const auto of_plain = values(plain), of_nested = values(nested);
  ASSERT_EQ(of_plain.size(), 12u);
  ASSERT_EQ(of_nested.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(of_plain[i], of_nested[i], 1e-15);

  GraphicsSystem g = unit_square();
  expect_error([&] { g.restore_transformation_3(); }, "no transformation saved");
  g.rotate_z_3(10);
  g.translate_3(0.3, 0.2, 0.1);
  for (std::size_t i = 0; i < GraphicsSystem::kMostSaved; ++i) g.save_transformation_3();
  expect_error([&] { g.save_transformation_3(); }, "1024 transformations are saved");
  EXPECT_EQ(g.counts().transformations_saved, GraphicsSystem::kMostSaved);
  g.open_segment(1);
  g.move_abs_3(0.1, 0.2, 0.3);
  g.line_abs_3(0.2, 0.2, 0.4);
  expect_error([&] { g.translate_3(std::numeric_limits<double>::quiet_NaN(), 0, 0); }, "nan");
  g.rotate_x_3(50);
  while (g.counts().transformations_saved > 0) g.restore_transformation_3();
  g.move_abs_3(0.1, 0.2, 0.3);
  g.line_abs_3(0.2, 0.2, 0.4);
  g.close_segment();
  const auto points = g.display_file().segment(1).entered()->stored_points();
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], points[2]);
  EXPECT_EQ(points[1], points[3]);
}

TEST(GraphicsSystem, OverflowInTheModellingTransformationIsAnError) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.scale_3(1e60, 1, 1);
  expect_error([&] { g.move_abs_3(1e60, 0, 0); }, "out of range after the modelling");
}

}  // namespace
}  // namespace displayfile
