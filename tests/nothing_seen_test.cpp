// Why a picture is empty.

#include "interp/draw/nothing_seen.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/collected_text.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/draw/world_views.h"
#include "tests/from_eyes.h"

namespace displayfile {
namespace {

using test::FromEyes;

/// Nothing if something is seen.
std::string why(std::string_view program, const SeenIn& in = {}) {
  GraphicsSystem system;
  RetainedScene scene;
  system.retain(&scene);
  replay(program, "program", system);
  const DisplayFile& file = system.display_file();
  EXPECT_EQ(nothing_is_seen(scene, file, in), nothing_is_seen(file, in));
  return nothing_is_seen(file, in) ? why_nothing_is_seen(scene, file, in) : "";
}

/// The same where nothing is retained.
std::string why_by_display_file(std::string_view program, const SeenIn& in = {}) {
  GraphicsSystem system;
  replay(program, "program", system);
  const DisplayFile& file = system.display_file();
  return nothing_is_seen(file, in) ? why_nothing_is_seen(file, in) : "";
}

SeenIn pixels(int side) { return {.pixels = PictureSize{side, side}}; }

std::string triangle_at(const std::string& x, const std::string& y, const std::string& z) {
  return "translate-3 " + x + " " + y + " " + z +
         "\nopen-segment 1\npolygon-abs-3 0 0 0  0.5 0 0  0 0.5 0\nclose-segment\n";
}

TEST(NothingSeen, TellsWhereEverythingIs) {
  const std::string depth =
      "set-view-depth -1 1\nset-front-plane-clipping on\nset-back-plane-clipping on\n";
  const std::string only = "the only polygon or line is ";
  EXPECT_EQ(why(triangle_at("0", "0", "0")), "");
  EXPECT_EQ(why("set-perspective 0 0 5\n" + triangle_at("0", "0", "6")), only + "behind the eye");
  EXPECT_EQ(why("set-perspective 0 0 5\n" + depth + triangle_at("0", "0", "6")),
            only + "behind the eye");
  EXPECT_EQ(why(depth + triangle_at("0", "0", "2")), only + "before the front plane");
  EXPECT_EQ(why(depth + triangle_at("0", "0", "-2")), only + "behind the back plane");
  EXPECT_EQ(why(triangle_at("-5", "0", "0")), only + "to the left of the window");
  EXPECT_EQ(why(triangle_at("5", "0", "0")), only + "to the right of the window");
  EXPECT_EQ(why(triangle_at("0", "-5", "0")), only + "below the window");
  EXPECT_EQ(why(triangle_at("0", "5", "0")), only + "above the window");
  EXPECT_EQ(why("open-segment 1\npolygon-abs-3 2.5 0 0  0 2.5 0  3 3 0\nclose-segment\n"),
            only + "outside of the view volume");
  EXPECT_EQ(why("open-segment 1\nmove-abs-2 1.5 0\nline-abs-2 0.8 1.5\nclose-segment\n"),
            only + "outside of the view volume");
}

TEST(NothingSeen, TellsWhatIsNotDrawn) {
  EXPECT_EQ(why(""), "no polygon or line was entered");
  EXPECT_EQ(why("open-segment 1\nmove-abs-3 0 0 0\nclose-segment\n"),
            "no polygon or line was entered");
  EXPECT_EQ(why(triangle_at("0", "0", "0") + "set-visibility 1 off\n"),
            "what was entered is in segments that are not visible");
  EXPECT_EQ(why(triangle_at("0", "0", "0") + "delete-segment 1\n"),
            "no polygon or line was entered");
  EXPECT_EQ(why("set-fill-style hollow\nset-line-style none\n" + triangle_at("0", "0", "0")),
            "the only polygon or line is hollow, with no line style");
  EXPECT_EQ(why("set-back-face-removal on\nopen-segment 1\n"
                "polygon-abs-3 0 0 0  0 0.5 0  0.5 0 0\nclose-segment\n"),
            "the only polygon or line is turned away, as back faces are removed");
}

/// A triangle in the segment 1, after the routines in `before`.
std::string triangle(const std::string& vertices, const std::string& before = "") {
  return "set-line-style none\n" + before + "open-segment 1\npolygon-abs-3 " + vertices +
         "\nclose-segment\n";
}
constexpr const char* kEdgeOn = "0.1 0 0  0.1 0.5 0  0.1 0 0.5";
constexpr const char* kSmall = "0.001 0.001 0  0.003 0.001 0  0.001 0.003 0";

TEST(NothingSeen, TellsWhatIsSeenEdgeOn) {
  const std::string words = "the only polygon or line is seen edge-on, with no line style";
  const std::string removed = "set-back-face-removal on\n";
  for (const SeenIn& in : {SeenIn{}, pixels(64)}) {
    EXPECT_EQ(why(triangle(kEdgeOn), in), words);
    EXPECT_EQ(why(triangle(kEdgeOn, removed), in), words);
    EXPECT_EQ(why(triangle("0.1 0 0  0.2 0.1 0  0.3 0.2 0"), in), words);  // from everywhere
    EXPECT_EQ(why(triangle(kEdgeOn, "set-line-style solid 0 0 0 1\n"), in), "");
    EXPECT_EQ(why_by_display_file(triangle(kEdgeOn), in),
              "the only polygon or line in the view volume is seen edge-on, with no line style");
  }
  EXPECT_EQ(why(triangle("-0.9 0 0  0.9 0 0  0 1e-8 0")), "");  // thin, and in vectors an area
  // The eye is in its plane up to rounding: vertices are seen on one line within that.
  const std::string eye = "set-perspective 0.3 0.7 3\nset-window -3 3 -3 3\n";
  const std::string plane = "0.3 0.7 0  0.4 0.9 0  0.6333333333333333 1.3666666666666667 1";
  EXPECT_EQ(why(triangle(plane, eye)), words);
  EXPECT_EQ(why(triangle(plane, eye), pixels(100)), words);
}

TEST(NothingSeen, TellsWhatIsSmallerThanAPixel) {
  const std::string words =
      "the only polygon or line is smaller or thinner than a pixel, over no sample of a pixel";
  EXPECT_EQ(why(triangle(kSmall), pixels(100)), words);
  EXPECT_EQ(why(triangle(kSmall), pixels(4000)), "");
  EXPECT_EQ(why(triangle(kSmall)), "");  // vectors
  EXPECT_EQ(why(triangle(kSmall, "set-line-style solid 0 0 0 1\n"), pixels(100)), "");
  EXPECT_EQ(why(triangle("-0.9 0.001 0  0.9 0.001 0  0 0.003 0"), pixels(100)), words);
  EXPECT_EQ(
      why_by_display_file(triangle(kSmall), pixels(100)),
      "the only polygon or line in the view volume is smaller or thinner than a pixel, over no "
      "sample of a pixel");
}

/// No side of a hollow polygon around the window is seen.
TEST(NothingSeen, TellsWhatHasItsSidesOutside) {
  const std::string around =
      "open-segment 1\npolygon-abs-2 -9 -9  9 -9  9 9  -9 9\nclose-segment\n";
  const std::string words = "hollow, with no side that is drawn in the view volume";
  for (const SeenIn& in : {SeenIn{}, pixels(64)}) {
    EXPECT_EQ(why("set-fill-style hollow\n" + around, in), "the only polygon or line is " + words);
    EXPECT_EQ(why_by_display_file("set-fill-style hollow\n" + around, in),
              "the only polygon or line in the view volume is " + words);
    EXPECT_EQ(why(around, in), "");
  }
}

TEST(NothingSeen, TellsWhatImagesMoveAway) {
  const std::string moved = triangle("0 0 0  0.5 0 0  0 0.5 0") + "set-image-translation 1 3 0\n";
  EXPECT_EQ(why(moved),
            "the only polygon or line is moved out of the picture by image transformations");
  EXPECT_EQ(why(moved + "set-image-translation 1 0.1 0\n"), "");
}

TEST(NothingSeen, TellsLessWhereNothingIsRetained) {
  EXPECT_EQ(why_by_display_file(""), "no polygon or line was entered");
  EXPECT_EQ(why_by_display_file(triangle_at("0", "0", "0")), "");
  EXPECT_EQ(why_by_display_file(triangle_at("5", "0", "0")),
            "nothing that was entered is inside of the view volume and turned to the viewer");
  EXPECT_EQ(why_by_display_file(triangle_at("0", "0", "0") + "set-visibility 1 off\n"),
            "what was entered is in segments that are not visible");
  EXPECT_EQ(why_by_display_file("set-line-style none\nopen-segment 1\npolygon-abs-3 " +
                                    std::string(kEdgeOn) + "\npolygon-abs-3 " + kSmall +
                                    "\nset-fill-style hollow\npolygon-abs-3 " + kSmall +
                                    "\nclose-segment\n",
                                pixels(50)),
            "of 3 polygons and lines in the view volume 1 is hollow, with no line style, 1 is seen "
            "edge-on, with no line style, 1 is smaller or thinner than a pixel, over no sample of "
            "a pixel");
}

/// Every way to draw warns of it, once, and only where nothing is visible.
class WarnedPictures {
 public:
  explicit WarnedPictures(std::string_view program) {
    system_.retain(&scene_);
    replay(program, "program", system_);
    options_.warn = [this](const DrawWarning& warning) {
      EXPECT_EQ(warning.kind, DrawWarning::Kind::nothing_seen);
      warned_.push_back(warning.text);
    };
  }

  /// The warning of each of them, in pixels and in vectors.
  void expect(const std::string& in_pixels, const std::string& in_vectors) {
    const DisplayFile& file = system_.display_file();
    Renderer renderer;
    DrawOptions samples = options_;
    samples.samples = 2;
    DrawOptions anew = options_;
    anew.surfaces.method = HiddenMethod::z_buffer;
    TurntableRenderer turntable(system_, scene_, file, {3}, anew);
    told(in_pixels, [&] { draw(system_, options_); });
    told(in_pixels, [&] { draw(system_, samples); });
    told(in_pixels, [&] { renderer.draw(system_, options_); });
    told(in_pixels, [&] { turntable.draw(0); });
    for (const char* format : {"ppm", "svg"}) {
      const std::string& expected = std::string(format) == "ppm" ? in_pixels : in_vectors;
      const auto to_file = [&](const DrawOptions& options) {
        CollectedText bytes;
        told(expected, [&] { draw(system_, bytes, in(options, format)); });
      };
      to_file(options_);
      to_file(samples);
    }
    expect_in_view(system_.view(), in_pixels, in_vectors);
  }

  /// The same of the retained scene in a view, which may be another than it was drawn in.
  void expect_in_view(const View& view, const std::string& in_pixels,
                      const std::string& in_vectors) {
    FromEyes views(scene_, system_.display_file());
    const WorldViews world(scene_, system_.display_file());
    told(in_pixels, [&] { views.draw(view, options_); });
    told(in_pixels, [&] { draw(world.view(view), options_); });
    for (const char* format : {"ppm", "svg"}) {
      const std::string& expected = std::string(format) == "ppm" ? in_pixels : in_vectors;
      CollectedText bytes;
      told(expected, [&] { views.draw(view, bytes, in(options_, format)); });
      told(expected, [&] { draw(world.view(view), bytes, in(options_, format)); });
    }
  }

 private:
  template <class Draw>
  void told(const std::string& expected, const Draw& draw) {
    warned_.clear();
    draw();
    const std::string text = expected.empty() ? "" : "nothing is seen: " + expected;
    EXPECT_EQ(warned_, text.empty() ? std::vector<std::string>() : std::vector{text});
  }
  static DrawOptions in(DrawOptions options, const char* format) {
    options.format = format;
    return options;
  }
  RetainedScene scene_;
  GraphicsSystem system_;
  std::vector<std::string> warned_;
  DrawOptions options_{.width = 40, .height = 40, .samples = 1};
};

TEST(NothingSeen, IsToldByWhateverDraws) {
  const std::string only = "the only polygon or line is ";
  const std::string edge_on = only + "seen edge-on, with no line style";
  WarnedPictures(triangle(kEdgeOn)).expect(edge_on, edge_on);
  WarnedPictures(triangle(kSmall))
      .expect(only + "smaller or thinner than a pixel, over no sample of a pixel", "");
  const std::string right = only + "to the right of the window";
  WarnedPictures(triangle("5 0 0  6 0 0  5 1 0")).expect(right, right);
  WarnedPictures(triangle("0 0 0  0.5 0 0  0 0.5 0")).expect("", "");
  // A fill in the background's colour counts as visible.
  WarnedPictures("set-background 1 0 0\nset-fill-style solid 1 0 0\n" +
                 triangle("0 0 0  0.5 0 0  0 0.5 0"))
      .expect("", "");
}

TEST(NothingSeen, IsToldOfTheViewThatIsDrawn) {
  WarnedPictures right(triangle("5 0 0  6 0 0  5 1 0"));
  View view;
  view.set_window({4.5, 6.5, -1.0, 1.0});
  right.expect_in_view(view, "", "");
  view.set_window({8.0, 10.0, -1.0, 1.0});
  const std::string left = "the only polygon or line is to the left of the window";
  right.expect_in_view(view, left, left);
}

TEST(NothingSeen, IsNotToldOfATextAlone) {
  WarnedPictures(
      "set-text-style 0.3 left\nopen-segment 1\nmove-abs-2 -0.5 0\ntext \"x\"\nclose-segment\n")
      .expect("", "");
}

/// A polygon that covers a sample's centre is visible.
TEST(NothingSeen, IsToldOfThePictureThatIsDrawn) {
  GraphicsSystem system;
  replay(triangle("0.03 0.03 0  0.06 0.03 0  0.03 0.06 0"), "program", system);
  const auto warned = [&](int samples, std::optional<PictureRows> rows = std::nullopt) {
    int count = 0;
    DrawOptions options{.width = 10, .height = 10, .rows = rows, .samples = samples};
    options.warn = [&](const DrawWarning&) { ++count; };
    draw(system, options);
    return count;
  };
  EXPECT_EQ(warned(1), 1);
  EXPECT_EQ(warned(8), 0);
  EXPECT_EQ(warned(8, PictureRows{0, 2}), 0);  // it is in others
  const Picture unwarned = draw(system, {.width = 10, .height = 10, .samples = 1});
  EXPECT_EQ(unwarned.pixels, std::vector<std::uint32_t>(100, unwarned.pixels[0]));
}

TEST(NothingSeen, CountsEachReason) {
  EXPECT_EQ(why("set-back-face-removal on\nopen-segment 1\n"
                "polygon-abs-3 0 0 0  0 0.5 0  0.5 0 0\npolygon-abs-3 5 0 0  6 0 0  5 1 0\n"
                "polygon-abs-3 5 0 0  6 0 0  5 1 0\nmove-abs-2 -9 0\nline-abs-2 -8 0\n"
                "close-segment\n"),
            "of 4 polygons and lines 1 is to the left of the window, 2 are to the right of the "
            "window, 1 is turned away, as back faces are removed");
  EXPECT_EQ(why(triangle_at("5", "0", "0") +
                "open-segment 2\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n"),
            "all 2 polygons and lines are to the right of the window");
}

}  // namespace
}  // namespace displayfile
