// The data kept between the views of a retained scene: shadows while only the eye moves, visible
// surfaces while only the light does. Every picture is that of entering the view anew, bit for bit,
// whatever was drawn before it; and counts show that kept data are not made again.

#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "displayfile/views/turntable.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/visibility/image_space.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/from_eyes.h"
#include "tests/gallery.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::Retained;

constexpr int kWidth = 64, kHeight = 48;

/// A rotation of the lights, in radians.
glm::dmat3 turned(double angle) {
  return glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, Point3(0.3, 1.0, 0.2)));
}

struct Step {
  View view;
  glm::dmat3 lights{1.0};
  HiddenMethod method = HiddenMethod::z_buffer;
  int width = kWidth, height = kHeight, threads = 1;
};

const Picture& draw(FromEyes& renderer, const Step& step) {
  DrawOptions options{.samples = 1};
  options.width = step.width;
  options.height = step.height;
  options.surfaces.method = step.method;
  options.surfaces.threads = step.threads;
  options.with_ids = options.with_depth = true;
  return renderer.draw(step.view, options, step.lights);
}

Picture entered_anew(FromEyes& renderer, const Step& step) {
  RasterRequest request;
  request.width = step.width;
  request.height = step.height;
  request.surfaces.method = step.method;
  request.ids = request.depth = true;
  return draw_with_software(renderer.display_file(step.view, step.lights), request);
}

void expect_right(FromEyes& renderer, const Step& step) {
  const Picture& drawn = draw(renderer, step);
  const Picture anew = entered_anew(renderer, step);
  EXPECT_EQ(drawn.ids, anew.ids);
  EXPECT_EQ(drawn.depth, anew.depth);
  EXPECT_EQ(drawn.pixels, anew.pixels);
}

/// The eye moves, then the light, then both, with other sizes, methods and threads in between.
void expect_right(const Retained& retained) {
  const DisplayFile& file = retained.system.display_file();
  const Turntable turntable(retained.scene, file, {});
  const auto view = [&](double degrees) { return turntable.at(degrees).view; };
  FromEyes renderer(retained.scene, file);
  Step step;
  for (const double degrees : {0.0, 25.0, 140.0, 25.0, 260.0}) {
    step.view = view(degrees);
    expect_right(renderer, step);
  }
  for (const double angle : {0.4, 1.1, 2.9}) {
    step.lights = turned(angle);
    expect_right(renderer, step);
  }
  step.threads = 3;
  for (const double degrees : {70.0, 80.0, 90.0}) {
    step.view = view(degrees);
    expect_right(renderer, step);
  }
  step.lights = turned(1.0);
  step.view = view(100.0);
  expect_right(renderer, step);
  step.method = HiddenMethod::scan_line;
  expect_right(renderer, step);
  step.width = 37;
  expect_right(renderer, step);
  step.lights = turned(1.5);
  expect_right(renderer, step);
  step.method = HiddenMethod::automatic;
  step.width = kWidth;
  expect_right(renderer, step);
}

TEST(KeptViews, AreThoseEnteredAnewOfTheGallery) {
  int drawn = 0;
  const auto light = [](GraphicsSystem& system) {
    system.set_light({0.4, 0.9, 0.6}, 0.3);  // unless the program sets another
    system.set_shadows(true);
  };
  test::Share share;
  test::for_each_in_gallery(light, [&](const std::string&, const Retained& retained) {
    if (!test::is_of_one_view(retained.scene) || !share.takes_next()) return;
    ASSERT_NO_FATAL_FAILURE(expect_right(retained));
    ++drawn;
  });
  EXPECT_GE(drawn, 12 / test::kShare);
}

TEST(KeptViews, AreThoseEnteredAnewOfGeneratedScenes) {
  for (const bool shadows : {true, false}) {
    for (const GeneratedScene& scene : generated_scenes()) {
      SCOPED_TRACE(scene.name);
      Retained retained;
      retained.system.set_light({0.5, 0.8, 1.0}, 0.25);
      retained.system.set_shadows(shadows);
      enter(scene.make(200, 3), retained.system);
      ASSERT_NO_FATAL_FAILURE(expect_right(retained));
    }
  }
}

/// Points on planes, sheets that nearly touch, huge offsets: where rounding decides, it decides as
/// in a view that is entered anew.
TEST(KeptViews, AreThoseEnteredAnewOfHardCases) {
  test::Share share;
  for (const HardCase& hard : hard_cases()) {
    if (!share.takes_next()) continue;
    SCOPED_TRACE(hard.name);
    Retained retained;
    retained.system.set_light({0.2, 0.3, 1.0}, 0.25);
    retained.system.set_shadows(true);
    retained.system.set_perspective({0.7, 0.4, 4.0});
    enter(hard.make(hard.size, hard.severities.back(), 1), retained.system);
    if (!test::is_of_one_view(retained.scene)) continue;
    ASSERT_NO_FATAL_FAILURE(expect_right(retained));
  }
}

/// A field of hills with a roof over it, of two lights, all that is seen by some polygons clipped.
void enter_hills(GraphicsSystem& g) {
  constexpr int kSide = 24;
  g.set_line_style({LineStyle::Kind::none});
  g.set_perspective({0.2, 0.4, 6.0});
  g.set_window(-0.9, 0.9, -0.9, 0.9);
  g.set_shadows(true);
  g.open_segment(1);
  g.set_light({0.6, 0.5, 1.0}, 0.2);
  const auto at = [](int i, int j) {
    return Point3(0.1 * i - 1.2, 0.1 * j - 1.2, 0.05 * ((i * i + 3 * j) % 7));
  };
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      g.polygon_abs_3({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      g.polygon_abs_3({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  g.close_segment();
  g.open_segment(2);
  g.set_light({-0.5, 0.2, 1.0}, 0.3);
  g.set_fill_style({FillStyle::Kind::solid, {0.8, 0.3, 0.2}});
  g.polygon_abs_3({{-0.5, -0.5, 0.8}, {0.4, -0.5, 0.7}, {0.4, 0.3, 0.9}, {-0.5, 0.4, 1.0}});
  g.polygon_abs_3({{-2, -2, -0.3}, {2, -2, -0.3}, {2, 2, -0.3}, {-2, 2, -0.3}});
  g.close_segment();
}

View moved(View view, double x) {
  view.set_perspective({x, 0.4 - 0.3 * x, 6.0 - x});
  return view;
}

TEST(KeptViews, FollowTwoLightsClippingAndEyesThatComeClose) {
  Retained retained;
  enter_hills(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  const View view = retained.system.view();
  for (const double x : {0.2, 0.5, 1.0, 4.0, 4.5, 4.9}) expect_right(renderer, {moved(view, x)});
  View far = view;
  far.set_depth(-3.0, 3.0);
  far.set_perspective({0.0, 0.0, 1e7});
  for (int k = 0; k < 3; ++k) expect_right(renderer, {far});
  far.set_parallel({1e5, 0.0, 1.0});  // so oblique that world coordinates cannot decide
  for (int k = 0; k < 3; ++k) expect_right(renderer, {far});
}

/// The attributes of segments may change between views.
TEST(KeptViews, FollowVisibilityAndImages) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  enter_hills(g);
  FromEyes renderer(retained.scene, g.display_file());
  const View view = g.view();
  const auto draw_some = [&] {
    for (const double x : {0.2, 0.3}) {
      expect_right(renderer, {moved(view, x)});
      expect_right(renderer, {moved(view, x), turned(0.1)});
    }
  };
  draw_some();
  g.set_visibility(2, false);
  draw_some();
  g.set_visibility(2, true);
  g.set_image_rotation(2, 25.0);
  draw_some();
  g.set_image_rotation(2, 0.0);
  draw_some();
}

TEST(KeptViews, SamplesAreThoseEnteredAnew) {
  Retained retained;
  enter_hills(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  DrawOptions options{.width = kWidth, .height = kHeight, .samples = 1};
  options.samples = 2;
  options.with_ids = true;
  for (const double angle : {0.0, 0.3, 0.3}) {
    const View view = moved(retained.system.view(), 0.2);
    const Picture drawn = renderer.draw(view, options, turned(angle));
    FromEyes anew(retained.scene, retained.system.display_file());
    const Picture& fresh = anew.draw(view, options, turned(angle));
    EXPECT_EQ(drawn.pixels, fresh.pixels);
    EXPECT_EQ(drawn.ids, fresh.ids);
  }
}

// ---- Kept data are not made again --------------------------------------------------------------

TEST(KeptViews, AMovingLightFindsNoSurfaces) {
  Retained retained;
  enter_hills(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  const View view = retained.system.view();
  for (int k = 0; k < 6; ++k) {
    draw(renderer, {view, turned(0.2 * k)});
    EXPECT_EQ(renderer.made().surfaces, 1u);
  }
  draw(renderer, {moved(view, 0.5)});
  EXPECT_EQ(renderer.made().surfaces, 2u);
  // Where a view comes again, they are kept from then on; until then an eye that moves would pay.
  for (int k = 0; k < 4; ++k) {
    draw(renderer, {moved(view, 0.5), turned(0.2 * k)});
    EXPECT_EQ(renderer.made().surfaces, 3u);
  }
  for (int k = 0; k < 4; ++k) {
    draw(renderer, {moved(view, 0.5), turned(0.2 * k), HiddenMethod::warnock});
    EXPECT_EQ(renderer.made().surfaces, 4u);
  }
  EXPECT_EQ(renderer.made().caster_trees, 1u);
}

TEST(KeptViews, AMovingEyeSearchesForNoShadowTwice) {
  Retained retained;
  enter_hills(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  const View view = retained.system.view();
  for (int k = 0; k < 8; ++k) draw(renderer, {moved(view, 0.2 + 0.05 * k)});
  const std::size_t made = renderer.made().caster_lists;
  EXPECT_GT(made, 0u);
  EXPECT_LE(made, retained.scene.size());  // one a polygon
  for (int k = 0; k < 8; ++k) draw(renderer, {moved(view, 0.2 + 0.05 * k)});
  EXPECT_EQ(renderer.made().caster_lists, made);
  EXPECT_EQ(renderer.made().caster_trees, 1u);
  EXPECT_GT(renderer.bytes_of_casters(), 0u);
  draw(renderer, {view, turned(0.5)});
  EXPECT_GT(renderer.made().caster_lists, made);  // other lights, other lists
}

TEST(KeptViews, WithoutShadowsNothingIsKeptForThem) {
  Retained retained;
  enter(generated_scene("city").make(50, 2), retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  for (int k = 0; k < 3; ++k) draw(renderer, {retained.system.view()});
  EXPECT_EQ(renderer.made().caster_trees, 0u);
  EXPECT_EQ(renderer.bytes_of_casters(), 0u);
  EXPECT_EQ(renderer.made().surfaces, 3u);  // no light, whose moves would keep them
}

}  // namespace
}  // namespace displayfile
