// New views of a retained scene without a sort: the picture of a view is that of the display file
// which entering it would have made, whatever the scene, the method and the number of threads.

#include "tests/from_eyes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/scene_viewer.h"
#include "displayfile/views/turntable.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/image_space.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/hard_cases.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/error_of.h"
#include "tests/gallery.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::error_of;
using test::FromEyes;

using test::Retained;

constexpr int kWidth = 72, kHeight = 56;

DrawOptions options_of(HiddenMethod method, int threads = 1) {
  DrawOptions options{.samples = 1};
  options.width = kWidth;
  options.height = kHeight;
  options.surfaces.method = method;
  options.surfaces.threads = threads;
  options.with_ids = options.with_depth = true;
  return options;
}

Picture entered_anew(const DisplayFile& file, HiddenMethod method) {
  RasterRequest request;
  request.width = kWidth;
  request.height = kHeight;
  request.surfaces.method = method;
  request.ids = request.depth = true;
  return draw_with_software(file, request);
}

void expect_same(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.pixels, b.pixels);
}

/// By every method, in that view.
void expect_right(FromEyes& renderer, const View& view, const glm::dmat3& lights) {
  static test::Share share;
  const DisplayFile file = renderer.display_file(view, lights);
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    if (!share.takes_next()) continue;
    SCOPED_TRACE(name_of(entry.method));
    expect_same(renderer.draw(view, options_of(entry.method), lights),
                entered_anew(file, entry.method));
  }
  EXPECT_EQ(renderer.draw(view, options_of(HiddenMethod::z_buffer, 3), lights).ids,
            truth_as_entered(file, kWidth, kHeight, false).ids);
}

/// In the view that it was drawn in, and in others.
void expect_right(const Retained& retained) {
  const DisplayFile& file = retained.system.display_file();
  FromEyes renderer(retained.scene, file);
  const Turntable turntable(retained.scene, file, {});
  for (const double degrees : {0.0, 35.0, 110.0, 245.0}) {
    SCOPED_TRACE(degrees);
    const auto [view, lights] = turntable.at(degrees);
    expect_right(renderer, view, lights);
  }
}

/// Lines, light, shadows, smooth shading, clipping, image transformations, texts.
TEST(InView, DrawsTheGalleryFromOtherEyes) {
  int drawn = 0;
  test::for_each_in_gallery([&](const std::string&, const Retained& retained) {
    if (!test::is_of_one_view(retained.scene)) return;
    ASSERT_NO_FATAL_FAILURE(expect_right(retained));
    ++drawn;
  });
  EXPECT_GE(drawn, 12);
}

TEST(InView, DrawsGeneratedScenes) {
  for (const GeneratedScene& scene : generated_scenes()) {
    SCOPED_TRACE(scene.name);
    Retained retained;
    enter(scene.make(200, 3), retained.system);
    ASSERT_NO_FATAL_FAILURE(expect_right(retained));
  }
}

/// A height field that is finer than the pixels, entered with shared vertices or without, and with
/// all that polygons can have.
void enter_field(bool shared, GraphicsSystem& g) {
  constexpr std::uint32_t kSide = test::kSlower > 1 ? 12 : 40;
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  const auto at = [](std::uint32_t i, std::uint32_t j) { return j * (kSide + 1) + i; };
  for (std::uint32_t j = 0; j <= kSide; ++j) {
    for (std::uint32_t i = 0; i <= kSide; ++i) {
      vertices.emplace_back(0.05 * i - 1.0, 0.05 * j - 1.0, 0.03 * ((i * i + 3 * j) % 7));
    }
  }
  for (std::uint32_t j = 0; j < kSide; ++j) {
    for (std::uint32_t i = 0; i < kSide; ++i) {
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      corners.insert(corners.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  if (shared) return g.polygons_abs_3({vertices, corners});
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    g.polygon_abs_3({vertices[corners[k]], vertices[corners[k + 1]], vertices[corners[k + 2]]});
  }
}

TEST(InView, DrawsFineMeshesOfEveryLook) {
  using Set = void (*)(GraphicsSystem&);
  for (const Set set :
       {Set([](GraphicsSystem&) {}), Set([](GraphicsSystem& g) {
          g.set_light({0.3, 0.4, 1.0});
        }),
        Set([](GraphicsSystem& g) { g.set_back_face_removal(true); }), Set([](GraphicsSystem& g) {
          g.set_light({0.3, 0.4, 1.0});
          g.set_back_face_removal(true);
        }),
        Set([](GraphicsSystem& g) { g.set_line_style({LineStyle::Kind::solid}); }),
        Set([](GraphicsSystem& g) { g.set_window(-0.6, 0.5, -0.4, 0.5); })}) {
    for (const bool shared : {false, true}) {
      Retained retained;
      GraphicsSystem& g = retained.system;
      g.set_line_style({LineStyle::Kind::none});
      g.set_window(-2.5, 2.5, -2.5, 2.5);
      g.set_perspective({0.2, 0.4, 6.0});
      set(g);
      g.open_segment(3);
      enter_field(shared, g);
      g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
      enter_field(shared, g);  // the same again: later wins
      g.close_segment();
      g.open_segment(5);
      g.polygon_abs_3({{-1, -1, 0.2}, {1, -1, 0.1}, {1.2, 1, 0.3}, {-1, 1.3, 0.4}});
      g.close_segment();
      ASSERT_NO_FATAL_FAILURE(expect_right(retained));
    }
  }
}

/// The attributes of segments may change between views. A polygon that covers no centre still hides
/// lines and texts.
TEST(InView, WhatCoversNoCentreHidesLinesAndTexts) {
  for (const bool with_text : {false, true}) {
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_hidden_surfaces({.removal = true});
    g.open_segment(1);
    if (with_text) {
      g.move_abs_3(-0.3, 0, 0);
      g.text("E");
    } else {
      g.move_abs_3(-0.3, 0, 0);
      g.line_abs_3(0.3, 0, 0);
    }
    g.set_line_style({LineStyle::Kind::none});
    g.polygon_abs_3({{-0.9, -0.01, 0.5}, {0.9, -0.01, 0.5}, {0, 0.014, 0.5}});
    const std::vector<double> flat(std::size_t{121} * 121, 0.5);
    g.surface_3({-0.9, 0.9, 121, -0.9, 0.9, 121, flat});
    g.close_segment();
    expect_right(retained);
    FromEyes renderer(retained.scene, g.display_file());
    for (const ImageSpaceEntry& entry : image_space_methods()) {
      const DrawOptions options = options_of(entry.method);
      expect_same(renderer.draw(g.view(), options), draw(g, options));
    }
  }
}

TEST(InView, FollowsVisibilityAndImages) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  test::enter_two_segments(g);
  const DisplayFile& file = g.display_file();
  FromEyes renderer(retained.scene, file);
  const View view = Turntable(retained.scene, file, {}).at(20.0).view;
  ASSERT_NO_FATAL_FAILURE(expect_right(renderer, view, glm::dmat3(1.0)));
  const int first = retained.scene.segments().front().name;
  g.set_visibility(first, false);
  ASSERT_NO_FATAL_FAILURE(expect_right(renderer, view, glm::dmat3(1.0)));
  g.set_visibility(first, true);
  g.set_image_rotation(first, 25.0);
  g.set_image_translation(first, 0.1, -0.05);
  ASSERT_NO_FATAL_FAILURE(expect_right(renderer, view, glm::dmat3(1.0)));
}

/// The display file of a view is, to the last bit, the one that entering it would have made.
TEST(InView, WritesTheDisplayFileThatEnteringMakes) {
  for (const bool shared : {false, true}) {
    const auto enter = [&](GraphicsSystem& g) {
      g.set_light({0.3, 0.4, 1.0});
      g.open_segment(1);
      enter_field(shared, g);
      g.close_segment();
    };
    Retained retained;
    enter(retained.system);
    GraphicsSystem anew;
    anew.set_perspective({0.9, 0.4, 3.0});
    enter(anew);
    FromEyes renderer(retained.scene, retained.system.display_file());
    EXPECT_EQ(test::entered_text(renderer.display_file(anew.view())),
              test::entered_text(anew.display_file()));
  }
}

TEST(InView, ThreadsDoNotChangeTheScene) {
  Retained retained;
  enter(generated_scene("city").make(3000, 2), retained.system);
  const View view = Turntable(retained.scene, retained.system.display_file(), {}).at(70.0).view;
  SceneViewer one(retained.scene, retained.system.display_file());
  SceneViewer four(retained.scene, retained.system.display_file());
  const ViewedScene& a = one.view({.view = view, .centres_of = PictureSize{64, 64}});
  const ViewedScene& b = four.view({.view = view, .centres_of = PictureSize{64, 64}, .threads = 4});
  ASSERT_EQ(a.items(), b.items());
  ASSERT_EQ(a.end(), b.end());
  for (ViewedScene::Item i = 0; i < a.items(); ++i) {
    ASSERT_EQ(a.pick_of_item(i), b.pick_of_item(i));
    ASSERT_TRUE(std::ranges::equal(a.points(i), b.points(i)));
  }
}

/// From the third view on the same memory is used, except where centres lie on sides, as in views
/// along the axes.
TEST(InView, AsksForNoMemoryFromTheThirdViewOn) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_line_style({LineStyle::Kind::none});
  g.set_window(-2.5, 2.5, -2.5, 2.5);
  g.set_perspective({0.2, 0.4, 6.0});
  g.open_segment(3);
  enter_field(true, g);
  g.close_segment();
  const Turntable turntable(retained.scene, g.display_file(), {});
  FromEyes renderer(retained.scene, g.display_file());
  for (int k = 0; k < 12; ++k) {
    const auto [view, lights] = turntable.at(30.0 * k + 7.0);
    const DrawOptions options = options_of(HiddenMethod::z_buffer);
    const auto counted = bench::counted_memory(
        [&, &view = view, &lights = lights] { renderer.draw(view, options, lights); });
    if (k >= 2) {
      EXPECT_EQ(counted.allocations, 0) << "view " << k;
    }
  }
}

/// In the application's view the picture equals that of drawing the system.
TEST(InView, DrawsByEveryMethodWithTheSystemsSettings) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  test::enter_two_segments(g);
  g.set_background({Background::Kind::solid, {0.1, 0.2, 0.3}});
  Renderer renderer;
  for (const auto& [method, name] : hidden_methods()) {
    SCOPED_TRACE(name);
    DrawOptions options{.width = 60, .height = 50, .samples = 1};
    options.surfaces.method = method;
    for (const char* const format : {"ppm", "svg"}) {
      options.format = format;
      std::string drawn, expected;
      const std::string error = error_of([&] {
        std::ostringstream bytes;
        renderer.draw(in_view(g, g.view()), bytes, options);
        drawn = bytes.str();
      });
      EXPECT_EQ(error, error_of([&] { expected = draw_as(g, format, options); })) << format;
      const bool is_of_world_tree = surfaces_of(method) == HiddenMethod::bsp;
      if (is_of_world_tree && options.format == "svg") continue;  // other pieces
      EXPECT_EQ(drawn, expected) << format;
    }
  }
  EXPECT_EQ(renderer.trees().sorted, 1u);
  g.set_hidden_surfaces({.z_buffer = true});
  const DrawOptions options{.width = 60, .height = 50, .samples = 1, .with_ids = true};
  EXPECT_EQ(renderer.draw(in_view(g, g.view()), options).ids, draw(g, options).ids);
}

TEST(InView, RefusesWhatDrawsNoView) {
  Retained retained;
  test::enter_two_segments(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  EXPECT_THROW(in_view(GraphicsSystem(), {}), Error);
  DrawOptions options = options_of(HiddenMethod::z_buffer);
  options.width = 0;
  EXPECT_THROW(renderer.draw({}, options), Error);
  View view;
  view.plane_normal = Point3(0.0);
  EXPECT_THROW(renderer.draw(view, options_of(HiddenMethod::z_buffer)), Error);
  expect_right(renderer, {}, glm::dmat3(1.0));  // and nothing is lost
}

}  // namespace
}  // namespace displayfile
