// A turntable's views: each equals the scene's picture in that view, by any method, whichever
// others are drawn.

#include "interp/draw/turntable_renderer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/turntable.h"
#include "tests/error_of.h"
#include "tests/retained_truth.h"
#include "tests/temporary_folder.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using namespace test;

constexpr int kViews = 5;

class TurntableRendererTest : public TemporaryFolder {
 protected:
  TurntableRendererTest() { enter_two_segments(retained_.system); }

  TurntableRenderer renderer(const DrawOptions& options, const TurntableViews& views = {kViews}) {
    return {retained_.system, retained_.scene, retained_.system.display_file(), views, options};
  }
  static DrawOptions options_of(std::optional<HiddenMethod> method) {
    DrawOptions options{.width = 60, .height = 50, .samples = 1};
    options.surfaces.method = method;
    options.with_ids = options.with_depth = !method || !finds_lines(*method);
    return options;
  }
  static std::string ppm_of(TurntableRenderer& turntable, int view) {
    std::ostringstream bytes;
    turntable.draw(view, bytes);
    return bytes.str();
  }

  Retained retained_;
};

constexpr std::optional<HiddenMethod> kMethods[] = {
    std::nullopt,           HiddenMethod::z_buffer, HiddenMethod::scan_line,
    HiddenMethod::franklin, HiddenMethod::bsp,      HiddenMethod::world_ray_cast};

TEST_F(TurntableRendererTest, AViewIsTheSameWhicheverOthersAreDrawn) {
  for (const auto method : kMethods) {
    const std::string name(name_of(method.value_or(HiddenMethod::automatic)));
    TurntableRenderer all = renderer(options_of(method));
    EXPECT_EQ(all.views(), kViews);
    Picture first;
    for (int k = 0; k < kViews; ++k) {
      Picture seen = all.draw(k);
      TurntableRenderer one = renderer(options_of(method));
      const Picture alone = one.draw(k);
      EXPECT_EQ(seen.pixels, alone.pixels) << name << k;
      EXPECT_EQ(seen.ids, alone.ids) << name << k;
      EXPECT_EQ(seen.depth, alone.depth) << name << k;
      if (k == 0) {
        first = seen;
      } else {
        EXPECT_NE(seen.pixels, first.pixels) << name << k;
      }
      all.give_back(std::move(seen));
    }
  }
}

/// The pixels in a file are those in memory.
TEST_F(TurntableRendererTest, FilesAreThePicturesInMemory) {
  for (const auto method : kMethods) {
    DrawOptions options = options_of(method);
    options.format = "ppm";
    options.with_ids = options.with_depth = false;
    TurntableRenderer turntable = renderer(options);
    const Picture picture = turntable.draw(3);
    std::string expected = "P6\n60 50\n255\n";
    for (const std::uint32_t pixel : picture.pixels) {
      for (int shift = 0; shift < 24; shift += 8) {
        expected += static_cast<char>(pixel >> shift & 255);
      }
    }
    EXPECT_EQ(ppm_of(turntable, 3), expected);
  }
}

/// Pieces of one tree show the same as the display file in that view.
TEST_F(TurntableRendererTest, ByDefaultViewsAreOfOneTree) {
  TurntableRenderer turntable = renderer(options_of(std::nullopt));
  const DisplayFile& file = retained_.system.display_file();
  const Turntable turned(retained_.scene, file, {});
  RetainedViews views(retained_.scene, file, {});
  const auto [view, lights] = turned.at(72.0);
  EXPECT_EQ(turntable.draw(1).ids, draw(views.view(view, lights), options_of(std::nullopt)).ids);
  EXPECT_EQ(turntable.renderer().trees().sorted, 1u);
  TurntableRenderer anew = renderer(options_of(HiddenMethod::z_buffer));
  anew.draw(1);
  EXPECT_EQ(anew.renderer().trees().sorted, 0u);
  EXPECT_EQ(anew.renderer().made().surfaces, 1u);
  TurntableRenderer rays = renderer(options_of(HiddenMethod::world_ray_cast));
  rays.draw(1);
  EXPECT_GT(rays.renderer().trees().polygons_in_boxes, 0u);
}

TEST_F(TurntableRendererTest, NumbersItsFiles) {
  EXPECT_EQ(numbered("a/turn.png", 7, 36), "a/turn-007.png");
  EXPECT_EQ(numbered("turn.svg", 7, 10000), "turn-0007.svg");
  DrawOptions options = options_of(HiddenMethod::z_buffer);
  options.ids = folder_ / "i.npy";
  TurntableRenderer turntable = renderer(options);
  EXPECT_EQ(turntable.draw_numbered(2, folder_ / "t.ppm"), folder_ / "t-002.ppm");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "t-002.ppm"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "i-002.npy"));
  EXPECT_EQ(error_of([&] {
              require_views_drawable({kViews, 0, 2}, folder_ / "t.ppm", options);
            }),
            "");
  expect_error(
      [&] {
        require_views_drawable({kViews, 0, 2}, folder_ / "none" / "t.ppm", options);
      },
      "t-000.ppm");
}

TEST_F(TurntableRendererTest, TurnsAboutAnotherAxisAndFitsItsWindow) {
  const DrawOptions options = options_of(HiddenMethod::z_buffer);
  const Picture plain = renderer(options).draw(1);
  EXPECT_NE(renderer(options, {.number = kViews, .axis = Point3(1, 0, 0)}).draw(1).pixels,
            plain.pixels);
  EXPECT_EQ(renderer(options, {.number = kViews, .axis = Point3(0, 5, 0)}).draw(1).pixels,
            plain.pixels);
  EXPECT_NE(renderer(options, {.number = kViews, .fit_window = true}).draw(1).pixels, plain.pixels);
}

/// A scene of the system's own goes back with it. The first view is the application's own picture.
TEST(TurntableOfTheApplication, FollowsItsPrecisionColourRuleAndPerimeter) {
  const auto expect_same_first = [](Retained& retained, DrawOptions options) {
    options.width = options.height = 40;
    TurntableRenderer turntable(retained.system, retained.scene, retained.system.display_file(),
                                {2}, options);
    EXPECT_EQ(turntable.draw(0).pixels, draw(retained.system, options).pixels);
  };
  {
    Retained near;
    GraphicsSystem& g = near.system;
    g.set_hidden_surfaces({.removal = true});
    g.set_hidden_surfaces({.method = HiddenMethod::z_buffer});
    g.set_hidden_surfaces({.precision = Precision{.exact = false, .roundoff = 0.01}});
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
    g.polygon_abs_3({{-0.5, -0.5, 0.001}, {0.5, -0.5, 0.001}, {0, 0.5, 0.001}});
    g.set_fill_style({FillStyle::Kind::solid, {0, 0, 1}});
    g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
    g.close_segment();
    for (const auto method : {HiddenMethod::z_buffer, HiddenMethod::scan_line}) {
      expect_same_first(near, {.surfaces = {.method = method}});
    }
  }
  {
    Retained box;
    box.system.set_hidden_surfaces({.removal = true});
    box.system.set_hidden_surfaces({.method = HiddenMethod::colour_rule});
    box.system.open_segment(1);
    box_3(box.system, {-0.5, -0.5, -0.5}, {0.5, 0.4, 0.3});
    box.system.close_segment();
    expect_same_first(box, {});
  }
  Retained surface;
  GraphicsSystem& g = surface.system;
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_hidden_surfaces({.method = HiddenMethod::perimeter});
  g.rotate_x_3(-60);
  g.open_segment(1);
  const std::vector<double> heights{0, 0.3, 0, 0.1, -0.4, 0.2, 0, 0.5, 0};
  g.surface_3({-0.5, 0.5, 3, -0.5, 0.5, 3, heights});
  g.close_segment();
  expect_same_first(surface, {});
}

TEST(RetainedByTheSystem, WhatIsRefusedIsNotRetained) {
  GraphicsSystem system;
  system.retain();
  enter_two_segments(system);
  const std::size_t segments = system.retained()->segments().size();
  const std::uint32_t primitives = system.retained()->size();
  EXPECT_GT(primitives, 0u);
  EXPECT_THROW(system.all_or_nothing([&] {
    system.open_segment(9);
    system.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    system.close_segment();
    system.open_segment(9);
  }),
               Error);
  EXPECT_EQ(system.retained()->segments().size(), segments);
  EXPECT_EQ(system.retained()->size(), primitives);
  GraphicsSystem late;
  enter_two_segments(late);
  expect_error([&] { late.retain(); }, "before the first one");
}

TEST_F(TurntableRendererTest, Refuses) {
  for (const int views : {0, -3, 10001}) {
    expect_error([&] { renderer({}, {views}); }, "expected 1 to 10000");
  }
  expect_error([&] { renderer(options_of(HiddenMethod::depth_sort)); },
               "not by depth-sort: expected bsp");
  expect_error([&] { renderer({.width = 0}); }, "picture size");
  TurntableRenderer turntable = renderer({});
  for (const int view : {-1, kViews}) {
    expect_error([&] { turntable.draw(view); }, "expected 0 to 4");
    expect_error([&] { turntable.draw_numbered(view, folder_ / "t.ppm"); }, "expected 0 to 4");
  }
  EXPECT_TRUE(empty_folder());
}

}  // namespace
}  // namespace displayfile
