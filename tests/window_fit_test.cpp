// Windows whose shape is not that of their viewport in the picture.

#include "clip/view/window_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"

namespace displayfile {
namespace {

TEST(WindowFit, WidensAboutTheMiddle) {
  EXPECT_EQ(widened({0, 2, 0, 2}, 2.0), (Rectangle{-1, 3, 0, 2}));
  EXPECT_EQ(widened({0, 2, 0, 2}, 0.5), (Rectangle{0, 2, -1, 3}));
  EXPECT_EQ(widened({-3, 1, 5, 6}, 1.0), (Rectangle{-3, 1, 3.5, 7.5}));
  const Rectangle thirds{0.1, 0.7, -0.3, 1.3};
  EXPECT_EQ(widened(thirds, shape_of(thirds) * (1.0 + 1e-14)), thirds) << "rounding is no shape";
}

TEST(WindowFit, ReadsItsWords) {
  for (const WindowFit fit : {WindowFit::widen, WindowFit::stretch}) {
    EXPECT_EQ(window_fit(name_of(fit)), fit);
  }
  EXPECT_THROW(window_fit("Widen"), Error);
}

/// A square of a side of 1 about the origin, drawn in a picture of an aspect ratio of 2.
std::string dump_of(const std::string& settings, double aspect = 2.0) {
  GraphicsSystem g;
  g.set_aspect_ratio(aspect);
  replay(
      settings +
          "open-segment 1\npolygon-abs-2 -0.5 -0.5  0.5 -0.5  0.5 0.5  -0.5 0.5\nclose-segment\n",
      "program", g);
  return dump(g.display_file());
}

TEST(WindowFit, WhoSetNoWindowHasItWidened) {
  const std::string widened = dump_of("set-window -2 2 -1 1\n");
  const std::string stretched = dump_of("", 1.0);
  EXPECT_EQ(dump_of(""), widened);
  EXPECT_EQ(dump_of("set-perspective 0 0 9\n"),
            dump_of("set-perspective 0 0 9\nset-window -2 2 -1 1\n"));
  EXPECT_EQ(dump_of("set-window -1 1 -1 1\n"), stretched) << "it is the program's own";
  EXPECT_EQ(dump_of("set-viewport 0 1 0 1\n"), stretched);
  EXPECT_EQ(dump_of("set-window-fit stretch\n"), stretched);
  EXPECT_EQ(dump_of("set-window-fit widen\nset-window -1 1 -1 1\n"), widened);
  EXPECT_EQ(dump_of("set-viewport 0 0.5 0 1\nset-window-fit widen\n"),
            dump_of("set-viewport 0 0.5 0 1\n", 1.0))
      << "half of a wide picture is square";
  EXPECT_NE(dump_of("set-viewport 0 0.5 0 1\nset-window-fit widen\n", 1.0),
            dump_of("set-viewport 0 0.5 0 1\n", 1.0));
}

TEST(WindowFit, TellsTheWorstOfTheWindowsThatWereStretched) {
  GraphicsSystem g;
  g.set_aspect_ratio(1.5);
  const auto open = [&](int name, const Rectangle& w) {
    g.set_window(w.x_min, w.x_max, w.y_min, w.y_max);
    g.open_segment(name);
    g.close_segment();
  };
  g.open_segment(9);
  g.close_segment();
  open(1, {0, 3, 0, 2});
  EXPECT_FALSE(g.counts().stretched_window);
  open(2, {0, 2, 0, 2});
  open(3, {0, 1, 0, 4});
  open(4, {0, 2, 0, 2});
  ASSERT_TRUE(g.counts().stretched_window);
  EXPECT_EQ(g.counts().stretched_window->segment, 3);
  EXPECT_EQ(g.counts().stretched_window->window, 0.25);
  EXPECT_EQ(g.counts().stretched_window->viewport, 1.5);
  GraphicsSystem said;
  said.set_window_fit(WindowFit::stretch);
  said.set_window(0, 1, 0, 4);
  said.open_segment(1);
  said.close_segment();
  EXPECT_FALSE(said.counts().stretched_window);
}

TEST(WindowFit, RefusesWhatCannotBe) {
  GraphicsSystem g;
  for (const double aspect : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(g.set_aspect_ratio(aspect), Error);
  }
  EXPECT_EQ(g.aspect_ratio(), 1.0);
  g.open_segment(1);
  EXPECT_THROW(g.set_aspect_ratio(2.0), Error);
  EXPECT_THROW(g.set_window_fit(WindowFit::widen), Error);
}

/// The numbers of columns and rows of a picture that show something.
Point2 extent(const Picture& picture) {
  int left = picture.width, right = -1, top = picture.height, bottom = -1;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.ids[static_cast<std::size_t>(y * picture.width + x)] < 0) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return {right - left + 1, bottom - top + 1};
}

TEST(WindowFit, ASquareIsAsHighAsWide) {
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(90, 200), std::pair(64, 64)}) {
    GraphicsSystem g;
    g.set_aspect_ratio(static_cast<double>(width) / height);
    g.open_segment(1);
    g.polygon_abs_2({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    g.close_segment();
    DrawOptions options{.samples = 1};
    options.width = width;
    options.height = height;
    options.with_ids = true;
    const Point2 seen = extent(draw(g, options));
    EXPECT_NEAR(seen.x, seen.y, 1.0) << width << " x " << height;
    EXPECT_NEAR(seen.x, 0.5 * std::min(width, height), 1.0);
  }
}

/// The warnings of a picture in memory, and of one in a file, of a square in a system of that
/// aspect.
int warnings_of(const std::string& settings, double aspect, int width, int height) {
  GraphicsSystem g;
  g.set_aspect_ratio(aspect);
  replay(settings +
             "open-segment 1\npolygon-abs-2 0.2 0.2  0.8 0.2  0.8 0.8  0.2 0.8\nclose-segment\n",
         "program", g);
  std::vector<std::string> warned;
  DrawOptions options{.width = width, .height = height};
  options.warn = [&](const DrawWarning& warning) {
    EXPECT_EQ(warning.kind, DrawWarning::Kind::stretched);
    warned.push_back(warning.text);
  };
  draw(g, options);
  draw_as(g, "svg", options);
  EXPECT_TRUE(warned.empty() || (warned.size() == 2 && warned[0] == warned[1]));
  const std::string shape = "set_aspect_ratio(" + std::to_string(width / height) + ")";
  if (!warned.empty()) {
    EXPECT_NE(warned[0].find(shape), std::string::npos) << warned[0];
  }
  return static_cast<int>(warned.size());
}

TEST(WindowFit, APictureOfAnotherShapeThanItsSystemsIsWarnedOf) {
  EXPECT_EQ(warnings_of("", 1.0, 40, 40), 0);
  EXPECT_EQ(warnings_of("", 1.0, 80, 40), 2);
  EXPECT_EQ(warnings_of("", 2.0, 80, 40), 0);
  EXPECT_EQ(warnings_of("", 2.0, 40, 40), 2);
  EXPECT_EQ(warnings_of("set-window 0 2 0 1\n", 1.0, 80, 40), 0) << "it is as wide as its window";
  EXPECT_EQ(warnings_of("set-window-fit stretch\n", 1.0, 80, 40), 0) << "it is meant";
  EXPECT_EQ(warnings_of("", 1.0, 101, 100), 0) << "whole pixels have no other shape";
}

std::vector<std::string> warnings_of_square(GraphicsSystem& g, int width, int height) {
  g.open_segment(1);
  g.polygon_abs_2({{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}});
  g.close_segment();
  std::vector<std::string> warned;
  DrawOptions options{.width = width, .height = height};
  options.warn = [&](const DrawWarning& warning) {
    EXPECT_EQ(warning.kind, DrawWarning::Kind::stretched);
    warned.push_back(warning.text);
  };
  draw(g, options);
  return warned;
}

TEST(WindowFit, AWindowOfAnotherShapeThanAPictureOfTheSystemsIsWarnedOf) {
  for (const auto& [right, stretched] : {std::pair(1.0, true), std::pair(2.0, false)}) {
    GraphicsSystem g;
    g.set_aspect_ratio(2);
    g.set_window(0, right, 0, 1);
    const std::vector<std::string> warned = warnings_of_square(g, 80, 40);
    ASSERT_EQ(warned.size(), stretched ? 1u : 0u);
    if (!stretched) continue;
    EXPECT_EQ(warned[0],
              "segment 1: a window 1 times as wide as high is stretched to a viewport 2 times as "
              "wide as high: expected a window of that shape, or set_window_fit");
  }
  for (const WindowFit fit : {WindowFit::widen, WindowFit::stretch}) {
    GraphicsSystem g;
    g.set_aspect_ratio(2);
    g.set_window_fit(fit);
    g.set_window(0, 1, 0, 1);
    EXPECT_TRUE(warnings_of_square(g, 80, 40).empty());
  }
}

TEST(WindowFit, ImagesThatTurningDistortsAreWarnedOf) {
  for (const double degrees : {0.0, 45.0, 90.0, 180.0}) {
    for (const int width : {40, 80}) {
      GraphicsSystem g;
      g.set_aspect_ratio(width / 40.0);
      g.open_segment(2);
      g.close_segment();
      g.set_image_rotation(2, degrees);
      const std::vector<std::string> warned = warnings_of_square(g, width, 40);
      const bool distorts = width != 40 && (degrees == 45.0 || degrees == 90.0);
      ASSERT_EQ(warned.size(), distorts ? 1u : 0u) << degrees << ", " << width;
      if (distorts) {
        EXPECT_NE(warned[0].find("the image rotation of segment 2 distorts it in a picture of"),
                  std::string::npos);
      }
    }
  }
}

/// The warnings of a view of a retained square, drawn in memory and as vectors.
int warnings_in_view(const View& view, const GraphicsSystem& g, bool has_settings, int width,
                     int height) {
  InView seen = in_view(g, view);
  if (!has_settings) seen.settings = nullptr;
  std::vector<std::string> warned;
  DrawOptions options{.width = width, .height = height, .samples = 1};
  options.warn = [&](const DrawWarning& warning) {
    EXPECT_EQ(warning.kind, DrawWarning::Kind::stretched);
    warned.push_back(warning.text);
  };
  Renderer renderer;
  renderer.draw(seen, options);
  options.format = "svg";
  std::ostringstream vectors;
  renderer.draw(seen, vectors, options);
  EXPECT_TRUE(warned.empty() || (warned.size() == 2 && warned[0] == warned[1]));
  return static_cast<int>(warned.size());
}

GraphicsSystem retained_square(const std::string& settings, double aspect) {
  GraphicsSystem g;
  g.retain();
  g.set_aspect_ratio(aspect);
  replay(settings +
             "open-segment 1\npolygon-abs-2 0.2 0.2  0.8 0.2  0.8 0.8  0.2 0.8\nclose-segment\n",
         "program", g);
  return g;
}

TEST(WindowFit, AViewOfAnotherShapeThanThePictureIsWarnedOf) {
  const GraphicsSystem g = retained_square("", 1.0), wide = retained_square("", 2.0);
  const GraphicsSystem meant = retained_square("set-window-fit stretch\n", 1.0);
  const View widened = wide.retained()->segments().front().view;  // as it was viewed
  View view;
  for (const bool has_settings : {false, true}) {
    EXPECT_EQ(warnings_in_view(view, g, has_settings, 40, 40), 0);
    EXPECT_EQ(warnings_in_view(view, g, has_settings, 80, 40), 2);
    EXPECT_EQ(warnings_in_view(view, g, has_settings, 101, 100), 0);
    EXPECT_EQ(warnings_in_view(widened, wide, has_settings, 80, 40), 0);
    EXPECT_EQ(warnings_in_view(widened, wide, has_settings, 40, 40), 2);
    EXPECT_EQ(warnings_in_view(view, meant, has_settings, 80, 40), has_settings ? 0 : 2);
  }
  view.set_window({-2, 2, -1, 1});
  EXPECT_EQ(warnings_in_view(view, g, false, 80, 40), 0);
  view.set_viewport({0, 0.5, 0, 1});
  EXPECT_EQ(warnings_in_view(view, g, false, 80, 40), 2);
  EXPECT_EQ(warnings_in_view(view, g, false, 80, 20), 0);
}

/// All views of a turntable are stretched alike: the first one warns.
TEST(WindowFit, ATurntableWarnsOnce) {
  for (const std::string settings : {"", "set-window-fit stretch\n"}) {
    const GraphicsSystem g = retained_square(settings, 1.0);
    for (const int width : {40, 80}) {
      int warned = 0;
      DrawOptions options{.width = width, .height = 40, .samples = 1};
      options.warn = [&](const DrawWarning& warning) {
        EXPECT_EQ(warning.kind, DrawWarning::Kind::stretched) << warning.text;
        ++warned;
      };
      TurntableRenderer views(g, *g.retained(), g.display_file(), {4}, options);
      views.draw(0);
      views.draw(1);
      EXPECT_EQ(warned, width == 80 && settings.empty() ? 1 : 0) << settings;
    }
  }
}

}  // namespace
}  // namespace displayfile
