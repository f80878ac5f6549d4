#include "displayfile/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::dump_of;
using test::error_of_program;

// ---- The routines of programs --------------------------------------------------------------

struct RoutineCase {
  std::string line;
  std::function<void(GraphicsSystem&)> call;
};

/// Every routine of a drawing program is the application's call of that name, with its
/// arguments in order: seen by recording both.
TEST(DrawingProgram, EveryRoutineIsTheApplicationsCall) {
  using G = GraphicsSystem;
  using enum LineStyle::Kind;
  constexpr auto kSolid = FillStyle::Kind::solid;
  const std::vector<RoutineCase> outside_of_segments{
      {"set-view-reference-point 1 2 3",
       [](G& g) {
         g.set_view_reference_point({1, 2, 3});
       }},
      {"set-view-plane-normal 1 2 -3",
       [](G& g) {
         g.set_view_plane_normal({1, 2, -3});
       }},
      {"set-view-distance 2.5", [](G& g) { g.set_view_distance(2.5); }},
      {"set-view-up 0 1 .5",
       [](G& g) {
         g.set_view_up({0, 1, 0.5});
       }},
      {"set-parallel .1 .2 1",
       [](G& g) {
         g.set_parallel({0.1, 0.2, 1});
       }},
      {"set-perspective 1 2 30",
       [](G& g) {
         g.set_perspective({1, 2, 30});
       }},
      {"set-view-depth -2 4", [](G& g) { g.set_view_depth(-2, 4); }},
      {"set-front-plane-clipping on", [](G& g) { g.set_front_plane_clipping(true); }},
      {"set-back-plane-clipping off", [](G& g) { g.set_back_plane_clipping(false); }},
      {"set-window -1 2 -3 4", [](G& g) { g.set_window(-1, 2, -3, 4); }},
      {"set-viewport .1 .2 .3 .4", [](G& g) { g.set_viewport(0.1, 0.2, 0.3, 0.4); }},
      {"set-window-fit stretch", [](G& g) { g.set_window_fit(WindowFit::stretch); }},
      {"set-background .1 .2 .3",
       [](G& g) {
         g.set_background({Background::Kind::solid, {0.1, 0.2, 0.3}});
       }},
      {"set-background none", [](G& g) { g.set_background({Background::Kind::none}); }},
      {"open-segment 8", [](G& g) { g.open_segment(8); }},
      {"delete-segment 1", [](G& g) { g.delete_segment(1); }},
      {"delete-all-segments", [](G& g) { g.delete_all_segments(); }},
      {"rename-segment 1 9", [](G& g) { g.rename_segment(1, 9); }},
      {"set-visibility 1 off", [](G& g) { g.set_visibility(1, false); }},
      {"set-segment-title 1 \"a b\"", [](G& g) { g.set_segment_title(1, "a b"); }},
      {"set-image-translation 1 .2 .3", [](G& g) { g.set_image_translation(1, 0.2, 0.3); }},
      {"set-image-scale 1 2 3", [](G& g) { g.set_image_scale(1, 2, 3); }},
      {"set-image-rotation 1 30", [](G& g) { g.set_image_rotation(1, 30); }},
      {"set-image-centre 1 .5 .25", [](G& g) { g.set_image_centre(1, 0.5, 0.25); }},
      {"set-hidden-line-removal on", [](G& g) { g.set_hidden_surfaces({.removal = true}); }},
      {"set-back-face-removal on", [](G& g) { g.set_back_face_removal(true); }},
      {"set-hidden-method z-buffer",
       [](G& g) { g.set_hidden_surfaces({.method = HiddenMethod::z_buffer}); }},
      {"set-hidden-method auto",
       [](G& g) { g.set_hidden_surfaces({.method = HiddenMethod::automatic}); }},
      {"set-hidden-method none",
       [](G& g) { g.set_hidden_surfaces({.method = HiddenMethod::none}); }},
      {"set-hidden-method back-face",
       [](G& g) { g.set_hidden_surfaces({.method = HiddenMethod::back_face}); }},
      {"set-z-buffer on", [](G& g) { g.set_hidden_surfaces({.z_buffer = true}); }},
      {"set-shadows on", [](G& g) { g.set_shadows(true); }},
  };
  const std::vector<RoutineCase> inside_of_a_segment{
      {"close-segment", [](G& g) { g.close_segment(); }},
      {"create-transformation-3", [](G& g) { g.create_transformation_3(); }},
      {"translate-3 1 2 3", [](G& g) { g.translate_3(1, 2, 3); }},
      {"scale-3 1 2 3", [](G& g) { g.scale_3(1, 2, 3); }},
      {"rotate-x-3 10", [](G& g) { g.rotate_x_3(10); }},
      {"rotate-y-3 20", [](G& g) { g.rotate_y_3(20); }},
      {"rotate-z-3 30", [](G& g) { g.rotate_z_3(30); }},
      {"restore-transformation-3", [](G& g) { g.restore_transformation_3(); }},
      {"move-abs-3 1 2 3", [](G& g) { g.move_abs_3(1, 2, 3); }},
      {"line-abs-3 .1 .2 .3", [](G& g) { g.line_abs_3(0.1, 0.2, 0.3); }},
      {"move-rel-3 1 2 3", [](G& g) { g.move_rel_3(1, 2, 3); }},
      {"line-rel-3 .1 .2 .3", [](G& g) { g.line_rel_3(0.1, 0.2, 0.3); }},
      {"move-abs-2 1 2", [](G& g) { g.move_abs_2(1, 2); }},
      {"line-abs-2 .1 .2", [](G& g) { g.line_abs_2(0.1, 0.2); }},
      {"move-rel-2 1 2", [](G& g) { g.move_rel_2(1, 2); }},
      {"line-rel-2 .1 .2", [](G& g) { g.line_rel_2(0.1, 0.2); }},
      {"polygon-abs-3 0 0 .1  .5 0 .2  .5 .6 .3",
       [](G& g) {
         g.polygon_abs_3({{0, 0, 0.1}, {0.5, 0, 0.2}, {0.5, 0.6, 0.3}});
       }},
      {"polygon-rel-3 0 0 .1  .5 0 .2  .5 .6 .3",
       [](G& g) {
         g.polygon_rel_3({{0, 0, 0.1}, {0.5, 0, 0.2}, {0.5, 0.6, 0.3}});
       }},
      {"polygon-abs-2 0 0 .5 0 .5 .6 0 .7",
       [](G& g) {
         g.polygon_abs_2({{0, 0}, {0.5, 0}, {0.5, 0.6}, {0, 0.7}});
       }},
      {"polygon-rel-2 0 0 .5 0 .5 .6 0 .7",
       [](G& g) {
         g.polygon_rel_2({{0, 0}, {0.5, 0}, {0.5, 0.6}, {0, 0.7}});
       }},
      {"set-fill-style solid .1 .2 .3",
       [=](G& g) {
         g.set_fill_style({kSolid, {0.1, 0.2, 0.3}});
       }},
      {"set-fill-style hollow", [](G& g) { g.set_fill_style({FillStyle::Kind::hollow}); }},
      {"set-line-style none", [](G& g) { g.set_line_style({none}); }},
      {"set-line-style solid .1 .2 .3",
       [](G& g) {
         g.set_line_style({solid, {0.1, 0.2, 0.3}, 1.0});
       }},
      {"set-line-style solid .1 .2 .3 4",
       [](G& g) {
         g.set_line_style({solid, {0.1, 0.2, 0.3}, 4.0});
       }},
      {"set-line-style dashed .1 .2 .3",
       [](G& g) {
         g.set_line_style({dashed, {0.1, 0.2, 0.3}, 1.0, 6.0, 4.0});
       }},
      {"set-line-style dashed .1 .2 .3 5",
       [](G& g) {
         g.set_line_style({dashed, {0.1, 0.2, 0.3}, 5.0, 6.0, 4.0});
       }},
      {"set-line-style dashed .1 .2 .3 5 8 9",
       [](G& g) {
         g.set_line_style({dashed, {0.1, 0.2, 0.3}, 5.0, 8.0, 9.0});
       }},
      {"set-light 1 2 3",
       [](G& g) {
         g.set_light({1, 2, 3}, 0.2);
       }},
      {"set-light 1 2 3 .5",
       [](G& g) {
         g.set_light({1, 2, 3}, 0.5);
       }},
      {"set-pick-id 12", [](G& g) { g.set_pick_id(12); }},
      {"text \"a  b\"", [](G& g) { g.text("a  b"); }},
      {"text \"#1, \\\"x\\\" \\\\\"# a label", [](G& g) { g.text("#1, \"x\" \\"); }},
      {"text \"\"", [](G& g) { g.text(""); }},
      {"set-text-style .05", [](G& g) { g.set_text_style({0.05}); }},
      {"set-text-style .05 centre",
       [](G& g) {
         g.set_text_style({0.05, TextStyle::Alignment::centre});
       }},
      {"set-text-style .05 always",
       [](G& g) {
         g.set_text_style({0.05, TextStyle::Alignment::left, true});
       }},
      {"set-text-style 1 right always",
       [](G& g) {
         g.set_text_style({1, TextStyle::Alignment::right, true});
       }},
  };
  const auto check = [](const RoutineCase& routine, bool segment_open) {
    SCOPED_TRACE(routine.line);
    GraphicsSystem by_program, by_call;
    std::ostringstream from_program, from_call;
    Recorder program_recorder(from_program), call_recorder(from_call);
    by_program.set_recorder(&program_recorder);
    by_call.set_recorder(&call_recorder);
    for (GraphicsSystem* g : {&by_program, &by_call}) {
      g->open_segment(1);
      if (!segment_open) g->close_segment();
      g->save_transformation_3();
    }
    EXPECT_EQ(error_of_program(routine.line + "\n", by_program),
              routine.line == "open-segment 8"
                  ? "scene.draw:1:15: segment 8 still open at the end: expected close-segment"
                  : "");
    routine.call(by_call);
    EXPECT_EQ(from_program.str(), from_call.str());
    EXPECT_EQ(dump(by_program.display_file()), dump(by_call.display_file()));
  };
  for (const RoutineCase& routine : outside_of_segments) check(routine, false);
  for (const RoutineCase& routine : inside_of_a_segment) check(routine, true);
}

constexpr std::string_view kTriangle =
    "displayfile-dump 1\n"
    "segment 1 visible\n"
    "fill solid 0.8 0.8 0.8\n"
    "line-style solid 0 0 0 1\n"
    "pick 0\n"
    "polygon 3 0.5 1 0.75\n"
    "line 0.5 0.5 0.75\n"
    "line 1 0.5 0.75\n"
    "line 0.5 1 0.75\n"
    "end\n";

TEST(DrawingProgram, CommentsBlankLinesTabsAndLineEndsAreFree) {
  const std::string plain = "open-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 1 0\nclose-segment\n";
  EXPECT_EQ(dump_of(plain), kTriangle);
  EXPECT_EQ(dump_of("open-segment 1\r\npolygon-abs-3 0 0 0 1 0 0 0 1 0\r\nclose-segment\r\n"),
            kTriangle);
  EXPECT_EQ(dump_of("\xEF\xBB\xBF" + plain), kTriangle);
  EXPECT_EQ(dump_of(plain.substr(0, plain.size() - 1)), kTriangle);  // no line end at the end
  EXPECT_EQ(dump_of("# a triangle\n\n  \t\n\topen-segment\t1 # segment 1\n#close-segment\n"
                    "polygon-abs-3   0 0 0   1 0 0   0 1 0#the triangle\n  close-segment  \n\n"),
            kTriangle);
  EXPECT_EQ(dump_of("# caf\u00e9 \u2192 \U0001F4D0\n" + plain), kTriangle);
  EXPECT_EQ(dump_of(""), "displayfile-dump 1\nend\n");
  EXPECT_EQ(dump_of("# nothing"), "displayfile-dump 1\nend\n");
}

TEST(DrawingProgram, NumbersInEveryForm) {
  EXPECT_EQ(dump_of("open-segment +1\npolygon-abs-3 0 -0 0e5 +1 .0 0. 0 1e0 0.0000\n"
                    "close-segment\n"),
            kTriangle);
  GraphicsSystem system;
  replay("set-view-distance 4.9406564584124654e-324", "p", system);
  EXPECT_EQ(system.view().distance, 4.9406564584124654e-324);
  replay("set-view-distance 0.1000000000000000055511151231257827021181583404541015625", "p",
         system);
  EXPECT_EQ(system.view().distance, 0.1);
}

TEST(DrawingProgram, PolygonOfManySides) {
  std::string program = "open-segment 1\npolygon-abs-2";
  constexpr int kSides = 50000;
  for (int i = 0; i < kSides; ++i) program += i % 2 == 0 ? " .25 .5" : " .5 .25";
  program += "\nclose-segment\n";
  GraphicsSystem system;
  replay(program, "p", system);
  EXPECT_EQ(system.counts().polygons, 1);
  EXPECT_NE(dump(system.display_file()).find("polygon 50000 "), std::string::npos);
}

TEST(DrawingProgram, SegmentThatTheApplicationOpenedMayStayOpen) {
  GraphicsSystem system;
  system.open_segment(1);
  EXPECT_EQ(error_of_program("polygon-abs-3 0 0 0 1 0 0 0 1 0\n", system), "");
  EXPECT_EQ(system.open_segment_name(), 1);
}

/// A program's saved transformations are restored at its end; the application's stay.
TEST(DrawingProgram, SavedTransformationsAreRestoredAtTheEnd) {
  GraphicsSystem system;
  EXPECT_NE(
      error_of_program("save-transformation-3\n  save-transformation-3\nrestore-transformation-3\n",
                       system)
          .find("3:25: 1 transformation still saved at the end: expected "
                "restore-transformation-3"),
      std::string::npos);
  EXPECT_EQ(system.counts().transformations_saved, 1u);
  EXPECT_EQ(error_of_program("save-transformation-3\nrestore-transformation-3\n", system), "");
  system.restore_transformation_3();
  EXPECT_NE(error_of_program("\n restore-transformation-3\n", system)
                .find("2:2: no transformation saved"),
            std::string::npos);
}

// ---- Errors in programs -------------------------------------------------------------------

struct Wrong {
  std::string program, message;
};

/// Errors of the parser: place, what was found, what was expected.
TEST(DrawingProgram, ErrorsNamePlaceAndExpectation) {
  const Wrong cases[] = {
      {"# one\n\npolygon-abs-4 1 2 3\n",
       "3:1: unknown routine 'polygon-abs-4': did you mean 'polygon-abs-3'? expected a user "
       "routine"},
      {"  SET_WINDOW 0 1 0 1\n",
       "1:3: unknown routine 'SET_WINDOW': did you mean 'set-window'? expected a user routine"},
      {"open-segmnet 1\n",
       "1:1: unknown routine 'open-segmnet': did you mean 'open-segment'? expected a user routine"},
      {"line-style none\n",
       "1:1: unknown routine 'line-style': did you mean 'set-line-style'? expected a user routine"},
      {"circle 0 0 1\n",
       "1:1: unknown routine 'circle': expected a user routine, such as open-segment or "
       "polygon-abs-3"},
      {"set-window 0 1 0  \n",
       "1:17: set-window: 3 arguments, expected 4: x-min x-max y-min y-max"},
      {"set-window 0 1 0 1 9\n",
       "1:20: set-window: 5 arguments, expected 4: x-min x-max y-min y-max"},
      {"set-view-distance # none\n", "1:18: set-view-distance: 0 arguments, expected 1: distance"},
      {"delete-all-segments 1\n", "1:21: delete-all-segments: 1 argument, expected none"},
      {"set-view-distance two\n", "1:19: expected a number, not 'two'"},
      {"set-view-distance 1.5x\n", "1:19: expected a number, not '1.5x'"},
      {"set-view-distance 0x10\n", "1:19: expected a number, not '0x10'"},
      {"set-view-distance +-1\n", "1:19: expected a number, not '+-1'"},
      {"set-view-distance 1,5\n",
       "1:19: expected a number, not '1,5': numbers have no commas: separate them by "
       "blanks, and write decimals with a point"},
      {"set-perspective 3,2,6\n",
       "1:22: set-perspective: 1 argument, expected 3: x y z: numbers have no commas: separate "
       "them by blanks, and write decimals with a point"},
      {"set-view-up 0 inf 0\n", "1:15: expected a finite number, not 'inf'"},
      {"set-view-up 0 -infinity 0\n", "1:15: expected a finite number, not '-infinity'"},
      {"set-view-up 0 0 nan\n", "1:17: expected a finite number, not 'nan'"},
      {"set-view-distance 1e999\n", "1:19: number '1e999' out of range of a double"},
      {"open-segment 1.0\n", "1:14: expected a whole number, not '1.0'"},
      {"open-segment one\n", "1:14: expected a whole number, not 'one'"},
      {"open-segment 2147483648\n", "1:14: whole number '2147483648' out of range"},
      {"set-z-buffer yes\n", "1:14: expected on or off, not 'yes'"},
      {"set-shadows 1\n", "1:13: expected on or off, not '1'"},
      {"set-shadows\n", "1:12: set-shadows: 0 arguments, expected 1: on|off"},
      {"set-shadows on 1 0 0\n", "1:16: set-shadows: 4 arguments, expected 1: on|off"},
      {"set-hidden-method painter\n",
       "1:19: unknown hidden-surface method 'painter': expected one of"},
      {"set-fill-style\n", "1:15: set-fill-style: 0 arguments, expected solid r g b | hollow"},
      {"set-fill-style red\n", "1:16: expected solid or hollow, not 'red'"},
      {"set-fill-style solid 1 0\n",
       "1:25: set-fill-style: 3 arguments, expected solid r g b | hollow"},
      {"set-fill-style hollow 1\n", "1:24: set-fill-style: 2 arguments, expected"},
      {"set-fill-style solid 1 0 x\n", "1:26: expected a number, not 'x'"},
      {"set-window-fit shrink\n", "1:16: window fit is widen or stretch, not 'shrink'"},
      {"set-background 1 1\n", "1:19: set-background: 2 arguments, expected r g b | none"},
      {"set-line-style dotted 0 0 0\n", "1:16: expected solid, dashed or none, not 'dotted'"},
      {"set-line-style dashed 0 0 0 1 2\n",
       "1:32: set-line-style: 6 arguments, expected solid r g b [width] | dashed r g b [width "
       "[dash gap]] | none"},
      {"set-line-style solid 0 0 0 1 2 3\n", "1:33: set-line-style: 7 arguments, expected"},
      {"set-line-style none 1\n", "1:22: set-line-style: 2 arguments, expected"},
      {"set-light 1 2\n", "1:14: set-light: 2 arguments, expected 3 or 4: x y z [ambient]"},
      {"open-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 1\n",
       "2:30: polygon-abs-3: 8 arguments, expected a multiple of 3: x y z ..."},
      {"open-segment 1\npolygon-rel-2 0 0 0 1 0\n",
       "2:24: polygon-rel-2: 5 arguments, expected a multiple of 2: dx dy ..."},
      {"open-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 ? 0\n", "2:29: expected a number, not '?'"},
      {"open-segment 12\nmove-abs-3 0 0 0\n\n",
       "2:17: segment 12 still open at the end: expected close-segment"},
      {"\xEF\xBB\xBFset-z-buffer yes\r\n", "1:14: expected on or off, not 'yes'"},
      {"# \u00e9\u00e9\u00e9\n\u00e9\u2192x on\n", "2:1: unknown routine '\u00e9\u2192x'"},
      {"set-view-distance \u00e9\u00e9 1\n", "1:22: set-view-distance: 2 arguments"},
      {"set-view-up 0 1 \u2192x\n", "1:17: expected a number, not '\u2192x'"},
      {"set-view-up 0 \u2192 x\n", "1:15: expected a number, not '\u2192'"},
  };
  for (const auto& [program, message] : cases) {
    SCOPED_TRACE(program);
    EXPECT_EQ(error_of_program(program).substr(0, 11 + message.size()), "scene.draw:" + message);
  }
}

TEST(DrawingProgram, LongWordIsCutInTheMessage) {
  const std::string message = error_of_program("set-view-distance " + std::string(100000, 'x'));
  EXPECT_EQ(message, "scene.draw:1:19: expected a number, not '" + std::string(40, 'x') + "...'");
  EXPECT_LT(error_of_program(std::string(100000, 'p')).size(), 200u);
}

TEST(DrawingProgram, BinaryInputIsRefusedBeforeAnyLineIsCarriedOut) {
  using namespace std::string_literals;
  const Wrong cases[] = {
      {"\0"s, "1:1: not a drawing program: byte 0x00"},
      {"\x7F"s + "ELF\x02\x01\x01\0"s, "1:1: not a drawing program: byte 0x7f"},
      {"# PNG follows\n\x89PNG\r\n\x1A\n"s, "2:1: not a drawing program: byte 0x89"},
      {"# \x1b[0m\n"s, "1:3: not a drawing program: byte 0x1b"},
      {"\xFF\xFEo\0p\0"s, "1:1: not a drawing program: UTF-16"},
      {"\xFE\xFF\0o\0p"s, "1:1: not a drawing program: UTF-16"},
      {"\xFF\xFE"s, "1:1: not a drawing program: byte 0xff"},
      {"\xFF\xFE\0\0o\0\0\0"s, "1:1: not a drawing program: byte 0xff"},  // UTF-32
      {"# caf\xE9\n"s, "1:6: not a drawing program: byte 0xe9"},          // Latin-1
      {"# \xC3"s, "1:3: not a drawing program: byte 0xc3"},               // cut short
      {"# \xE2\x86"s, "1:3: not a drawing program: byte 0xe2"},
      {"# \xF0\x9F\x93"s, "1:3: not a drawing program: byte 0xf0"},
      {"# \xC0\xAF"s, "1:3: not a drawing program: byte 0xc0"},  // longer than its character needs
      {"# \xE0\x80\xAF"s, "1:3: not a drawing program: byte 0xe0"},
      {"# \xED\xA0\x80"s, "1:3: not a drawing program: byte 0xed"},  // a surrogate
      {"# \xF4\x90\x80\x80"s, "1:3: not a drawing program: byte 0xf4"},
      {"# \xF5\x80\x80\x80"s, "1:3: not a drawing program: byte 0xf5"},
      {"# \u00e9\x80"s, "1:4: not a drawing program: byte 0x80"},
  };
  for (const auto& [program, message] : cases) {
    SCOPED_TRACE(message);
    EXPECT_EQ(error_of_program(program), "scene.draw:" + message + ", expected UTF-8 text");
    GraphicsSystem system;
    const std::string after_lines = "open-segment 1\nclose-segment\n" + program;
    EXPECT_NE(error_of_program(after_lines, system), "");
    EXPECT_TRUE(system.display_file().segments().empty());
  }
}

/// The text is checked in blocks: a character may lie across two, and an error anywhere in one.
TEST(DrawingProgram, BinaryInputIsFoundAtEveryPlace) {
  for (std::size_t length = 0; length < 200; ++length) {
    const std::string comment(length + 1, '#');
    EXPECT_EQ(error_of_program(comment + "\u2192\U0001F4D0\u00e9" + comment), "");
    EXPECT_EQ(error_of_program(comment + '\x01' + comment),
              "scene.draw:1:" + std::to_string(length + 2) +
                  ": not a drawing program: byte 0x01, expected UTF-8 text");
  }
}

/// An error of the application's call gets the place of its routine; nothing has changed, and the
/// program without that line draws the same.
TEST(DrawingProgram, RefusedCallsKeepTheState) {
  const std::string before =
      "set-window -2 2 -2 2\nopen-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 1 0\nclose-segment\n"
      "open-segment 2\nclose-segment\n";
  const std::string after_in_segment = "line-rel-3 .5 .5 0\npolygon-rel-2 .1 0 0 .1 -.1 0\n";
  const std::string after =
      "open-segment 4\nmove-abs-2 0 0\n" + after_in_segment + "close-segment\n";

  const Wrong with_no_segment_open[] = {
      {"close-segment", "no segment open"},
      {"move-abs-3 0 0 0", "no segment open: open one first"},
      {"line-abs-3 0 0 0", "no segment open"},
      {"line-rel-2 0 0", "no segment open"},
      {"polygon-abs-3 0 0 0 1 0 0 0 1 0", "no segment open"},
      {"polygon-rel-2 0 0 1 0 0 1", "no segment open"},
      {"open-segment 0", "invalid segment name 0"},
      {"open-segment -1", "invalid segment name -1"},
      {"open-segment 1", "segment name 1 in use: expected one that is not, such as 3"},
      {"rename-segment 1 2", "segment name 2 in use"},
      {"rename-segment 1 0", "invalid segment name 0"},
      {"rename-segment 9 3", "no segment named 9"},
      {"delete-segment 9", "no segment named 9"},
      {"set-visibility 9 off", "no segment named 9"},
      {"set-segment-title 9 \"a\"", "no segment named 9"},
      {"set-image-translation 9 0 0", "no segment named 9"},
      {"set-image-scale 9 1 1", "no segment named 9"},
      {"set-image-rotation 9 0", "no segment named 9"},
      {"set-image-scale 1 1e101 1", "image scale"},
      {"set-view-plane-normal 0 0 0", "view plane normal is zero"},
      {"set-view-up 0 0 0", "view up is zero"},
      {"set-parallel 0 0 0", "direction of projection is zero"},
      {"set-view-depth 1 -1", "front plane behind back plane"},
      {"set-view-depth 1 1", "front plane behind back plane"},
      {"set-window 1 -1 0 1", "window has no area"},
      {"set-window 0 1 1 1", "window has no area"},
      {"set-background 0 0 2", "colour component 2 out of range"},
      {"set-viewport 0 0 0 1", "viewport has no area"},
      {"set-viewport 0 2 0 1", "viewport leaves the display"},
      {"set-view-reference-point 1e101 0 0", "view reference point"},
      {"set-fill-style solid 1.5 0 0", "colour"},
      {"set-line-style solid 0 0 -1", "colour"},
      {"set-line-style solid 0 0 0 0", "width"},
      {"set-line-style dashed 0 0 0 1 -1 1", "dash"},
      {"set-light 0 0 0", "light direction is zero"},
      {"set-light 0 0 1 2", "ambient"},
      {"set-pick-id -2", "pick identifier"},
      {"translate-3 1e101 0 0", "translation"},
      {"scale-3 1e101 0 0", "scale"},
      {"rotate-y-3 1e101", "angle"},
  };
  const std::string expected = dump_of(before + after);
  for (const auto& [line, message] : with_no_segment_open) {
    SCOPED_TRACE(line);
    GraphicsSystem system;
    replay(before, "before", system);
    const std::string dump_before = dump(system.display_file());
    const std::string error = error_of_program("# wrong:\n\n " + line + "\n" + after, system);
    EXPECT_EQ(error.substr(0, 16), "scene.draw:3:2: ");
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_EQ(dump(system.display_file()), dump_before);
    EXPECT_EQ(error_of_program(after, system), "");
    EXPECT_EQ(dump(system.display_file()), expected);
  }

  const Wrong with_a_segment_open[] = {
      {"open-segment 5", "segment already open"},
      {"delete-segment 4", "segment 4 still open"},
      {"rename-segment 4 5", "segment 4 still open"},
      {"delete-all-segments", "segment 4 still open"},
      {"set-window 0 1 0 1", "segment 4 is open"},
      {"set-view-up 0 1 0", "segment 4 is open"},
      {"set-perspective 0 0 5", "segment 4 is open"},
      {"set-front-plane-clipping on", "segment 4 is open"},
      {"polygon-abs-3", "polygon of 0 sides"},
      {"polygon-abs-3 0 0 0 1 0 0", "polygon of 2 sides"},
      {"polygon-rel-3 0 0 0", "polygon of 1 side"},
      {"polygon-abs-2 0 0 1 1", "polygon of 2 sides"},
      {"polygon-rel-2 0 0 1 1", "polygon of 2 sides"},
      {"polygon-abs-3 0 0 0 1 0 0 0 1e101 0", "finite numbers of magnitude at most 1e100"},
      {"move-abs-3 0 0 1e101", "finite numbers of magnitude at most 1e100"},
      {"line-abs-2 -1e200 0", "finite numbers of magnitude at most 1e100"},
      {"line-rel-3 1e308 1e308 1e308", "finite numbers of magnitude at most 1e100"},
  };
  for (const auto& [line, message] : with_a_segment_open) {
    SCOPED_TRACE(line);
    GraphicsSystem system;
    replay(before, "before", system);
    system.open_segment(4);
    system.move_abs_2(0, 0);
    const std::string dump_before = dump(system.display_file());
    const std::string error = error_of_program(line, system);
    EXPECT_EQ(error.substr(0, 16), "scene.draw:1:1: ");
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_EQ(dump(system.display_file()), dump_before);
    EXPECT_EQ(error_of_program(after_in_segment + "close-segment\n", system), "");
    EXPECT_EQ(dump(system.display_file()), expected);
  }
}

/// Views whose parameters do not fit together are refused where the segment is opened.
TEST(DrawingProgram, ViewsThatDoNotFitTogetherAreRefusedAtOpenSegment) {
  const Wrong cases[] = {
      {"set-view-up 0 0 1", "view up along the view plane normal"},
      {"set-perspective 0 0 -5", "centre of projection on the wrong side"},
      {"set-perspective 0 0 0", "centre of projection on the wrong side"},
      {"set-perspective 0 0 5\nset-view-depth -6 1", "centre of projection on the wrong side"},
      {"set-parallel 1 0 0", "direction of projection parallel to the view plane"},
  };
  for (const auto& [lines, message] : cases) {
    SCOPED_TRACE(lines);
    GraphicsSystem system;
    const std::string error = error_of_program(
        "open-segment 1\nclose-segment\n" + lines + "\nopen-segment 2\nclose-segment\n", system);
    const std::string line = std::to_string(4 + std::ranges::count(lines, '\n'));
    EXPECT_EQ(error.substr(0, 16), "scene.draw:" + line + ":1: ");
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_EQ(dump(system.display_file()), "displayfile-dump 1\nsegment 1 visible\nend\n");
    EXPECT_FALSE(system.open_segment_name());
  }
}

// ---- Files --------------------------------------------------------------------------------

class DrawingProgramFile : public test::TemporaryFolder {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    return file(name, text).string();
  }
  static std::string error_of_file(const std::string& path) {
    GraphicsSystem system;
    try {
      replay_file(path, system);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(DrawingProgramFile, IsReplayed) {
  const std::string path =
      write("triangle.draw", "open-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 1 0\nclose-segment\n");
  GraphicsSystem system;
  replay_file(path, system);
  EXPECT_EQ(dump(system.display_file()), kTriangle);
}

TEST_F(DrawingProgramFile, StandardInputIsADash) {
  const std::string path = write("standard-input", "open-segment 1\nclose-segment 1\n");
  ASSERT_NE(std::freopen(path.c_str(), "r", stdin), nullptr);
  EXPECT_EQ(error_of_file("-"), "standard input:2:15: close-segment: 1 argument, expected none");
}

TEST_F(DrawingProgramFile, ErrorsNameTheFile) {
  const std::string missing = (folder_ / "missing.draw").string();
  EXPECT_EQ(error_of_file(missing), missing + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_of_file(folder_.string()), folder_.string() + ": cannot be read: Is a directory");
  const std::string wrong = write("wrong.draw", "\nopen-segment\n");
  EXPECT_EQ(error_of_file(wrong), wrong + ":2:13: open-segment: 0 arguments, expected 1: name");
}

/// A file without an end, but binary, is refused at once.
TEST_F(DrawingProgramFile, EndlessBinaryFile) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero";
  EXPECT_EQ(error_of_file("/dev/zero"),
            "/dev/zero:1:1: not a drawing program: byte 0x00, expected UTF-8 text");
}

/// Cut at any byte, a program is carried out as far as possible or gives an error at its end.
TEST_F(DrawingProgramFile, CutShort) {
  const std::string program =
      "set-view-up 0 1 0\nopen-segment 1\npolygon-abs-3 0 0 0 1 0 0 0 1 0\nclose-segment\n";
  for (std::size_t length = 0; length < program.size(); ++length) {
    const std::string cut = program.substr(0, length);
    const std::string error = error_of_file(write("cut.draw", cut));
    if (error.empty()) continue;
    const auto last_line =
        1 + std::ranges::count(cut.substr(0, cut.find_last_not_of('\n') + 1), '\n');
    EXPECT_NE(error.find("cut.draw:" + std::to_string(last_line) + ":"), std::string::npos)
        << error << "\nof\n"
        << cut;
  }
}

}  // namespace
}  // namespace displayfile
