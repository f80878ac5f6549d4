// Why a picture is empty.

#include "displayfile/nothing_seen.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "displayfile/graphics_system.h"
#include "displayfile/text/drawing_program.h"

namespace displayfile {
namespace {

/// Nothing if something is seen.
std::string why(std::string_view program) {
  GraphicsSystem system;
  RetainedScene scene;
  system.retain(&scene);
  replay(program, "program", system);
  EXPECT_EQ(nothing_is_seen(scene, system.display_file()), nothing_is_seen(system.display_file()));
  return nothing_is_seen(system.display_file()) ? why_nothing_is_seen(scene, system.display_file())
                                                : "";
}

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
