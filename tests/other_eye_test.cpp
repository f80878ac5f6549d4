// A system seen from another eye: everything equals the result of a drawing program in that view,
// whether it is drawn from the retained scene or by a replay.

#include "interp/draw/other_eye.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/program_in_view.h"
#include "displayfile/views/turntable.h"
#include "interp/truth/truth.h"
#include "tests/error_of.h"
#include "tests/gallery.h"
#include "tests/replayed.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::dump_of;
using test::error_of;

DrawOptions options_of(HiddenMethod method) {
  DrawOptions options{.samples = 1};
  options.width = 72;
  options.height = 56;
  options.surfaces.method = method;
  options.with_ids = options.with_depth = true;
  return options;
}

/// Calls visit(name, system, program) for each drawing program of the gallery that draws in one
/// view; `program` is its recording.
template <class Visit>
void for_each_in_one_view(Visit&& visit) {
  int visited = 0;
  std::ostringstream recorded;
  Recorder recorder(recorded);
  test::for_each_in_gallery(
      [&](GraphicsSystem& system) {
        recorded.str("");
        system.set_recorder(&recorder);
      },
      [&](const std::string& name, test::Retained& retained) {
        retained.system.set_recorder(nullptr);
        try {
          OtherEye(retained.system, retained.scene, "");
        } catch (const Error&) {
          return;  // it draws in several
        }
        ++visited;
        visit(name, retained, recorded.str());
      });
  EXPECT_GE(visited, 15);
}

TEST(ProgramInView, ViewRoutinesAreReplacedByOneView) {
  View view;
  view.set_perspective({1.0, 2.0, 6.5});
  view.set_window({-2.0, 2.0, -1.0, 1.0});
  EXPECT_EQ(program_in_view("  set-perspective 3 2 1 # near\n"
                            "set-fill-style solid 1 0 0\r\n"
                            "set-window -5 5 -5 5\n\n"
                            "set-window-frame 1\n"
                            "open-segment 1",
                            view),
            "set-window-fit stretch\n"
            "set-view-reference-point 0 0 0\n"
            "set-view-plane-normal 0 0 -1\n"
            "set-view-distance 0\n"
            "set-view-up 0 1 0\n"
            "set-perspective 1 2 6.5\n"
            "set-view-depth -1 3\n"
            "set-front-plane-clipping off\n"
            "set-back-plane-clipping off\n"
            "set-window -2 2 -1 1\n"
            "set-viewport 0 1 0 1\n"
            "set-fill-style solid 1 0 0\r\n"
            "\n"
            "set-window-frame 1\n"
            "open-segment 1\n");
}

TEST(ProgramInView, TheViewItWasDrawnInGivesTheSameDisplayFile) {
  for_each_in_one_view(
      [](const std::string&, test::Retained& retained, const std::string& program) {
        const OtherEye eye(retained.system, retained.scene, program);
        EXPECT_EQ(dump_of(program_in_view(program, eye.as_drawn())),
                  dump(retained.system.display_file()));
      });
}

TEST(OtherEye, DrawsWhatTheProgramInThatViewDraws) {
  test::Share share;
  for_each_in_one_view(
      [&](const std::string& name, test::Retained& retained, const std::string& program) {
        OtherEye eye(retained.system, retained.scene, program);
        const Turntable turntable(retained.scene, retained.system.display_file(), {});
        for (const double degrees : {0.0, 25.0, 200.0}) {
          SCOPED_TRACE(degrees);
          const View view = turntable.at(degrees).view;
          eye.set_view(view);
          const GraphicsSystem replayed = test::replayed(program_in_view(program, view));
          EXPECT_EQ(dump(eye.system().display_file()), dump(replayed.display_file()));
          EXPECT_EQ(eye.program(), program_in_view(program, view));
          int drawn = 0;
          for (const HiddenMethodEntry& entry : hidden_methods()) {
            const DrawOptions options = options_of(entry.method);
            if (!eye.draws(options)) continue;
            ++drawn;
            if (!share.takes_next()) continue;
            SCOPED_TRACE(entry.name);
            const Picture expected = draw(replayed, options);
            DrawOptions of_segments = options;  // which has no meaning in image space
            of_segments.surfaces.scope = HiddenScope::segment;
            const Picture& picture = eye.draw(drawn % 2 == 0 ? options : of_segments);
            EXPECT_EQ(picture.ids, expected.ids);
            EXPECT_EQ(picture.depth, expected.depth);
            EXPECT_EQ(picture.pixels, expected.pixels);
          }
          EXPECT_GE(drawn, retained.system.counts().has_hatching ? 0 : 5);
          if (name == "cyclic-overlap") {
            EXPECT_EQ(eye.draw(options_of(HiddenMethod::z_buffer)).ids,
                      truth(replayed.display_file(), 72, 56, false).ids);
          }
        }
      });
}

/// Hatching runs level in the view, so another view has other lines: those are drawn.
TEST(OtherEye, CutFacesAreHatchedAnewInEachView) {
  std::ostringstream recorded;
  Recorder recorder(recorded);
  test::Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_recorder(&recorder);
  g.set_view_plane_normal({1, 0.6, -0.4});
  g.set_parallel({1, 0.6, -0.4});
  g.set_window(-2, 2, -2, 2);
  g.set_cutting_plane(1, 1, 0, 0, -0.5);
  g.set_cut_faces({CutFaces::Kind::hatched, 0.1, 45});
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 1}});
  g.open_segment(1);
  box_3(g, {0, 0, 0}, {1, 1, 1});
  g.close_segment();
  g.set_recorder(nullptr);
  View turned = g.view();
  turned.set_up({0, 0.1, 1});
  OtherEye eye(g, retained.scene, recorded.str());
  eye.set_view(turned);
  const DrawOptions options = options_of(HiddenMethod::z_buffer);
  EXPECT_FALSE(eye.draws(options));
  EXPECT_EQ(draw(eye.system(), options).pixels,
            draw(test::replayed(program_in_view(recorded.str(), turned)), options).pixels);
  g.delete_all_segments();
  EXPECT_TRUE(eye.draws(options));
}

TEST(OtherEye, BackgroundIsNoPartOfTheView) {
  GraphicsSystem system;
  std::ostringstream recorded;
  Recorder recorder(recorded);
  system.retain();
  system.set_recorder(&recorder);
  replay(
      "set-background 0 0 1\nset-perspective 0 0 5\nopen-segment 1\n"
      "polygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n",
      "scene.draw", system);
  OtherEye eye(system, *system.retained(), recorded.str());
  View view = eye.as_drawn();
  view.set_perspective({1.0, 0.0, 5.0});
  eye.set_view(view);
  EXPECT_NE(eye.program().find("set-background 0 0 1\n"), std::string::npos);
  EXPECT_EQ(eye.system().looks().background, system.looks().background);
}

TEST(OtherEye, AViewThatDoesNotFitTogetherChangesNothing) {
  GraphicsSystem system;
  std::ostringstream recorded;
  Recorder recorder(recorded);
  system.retain();
  system.set_recorder(&recorder);
  replay(
      "set-perspective 0 0 5\nopen-segment 1\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n",
      "scene.draw", system);
  OtherEye eye(system, *system.retained(), recorded.str());
  const std::string before = eye.program();
  View along_up = eye.as_drawn();
  along_up.set_up({0.0, 0.0, 1.0});
  EXPECT_NE(error_of([&] { eye.set_view(along_up); }), "");
  EXPECT_EQ(eye.program(), before);
}

TEST(OtherEye, SeveralViewsAreAnError) {
  GraphicsSystem system;
  system.retain();
  replay(
      "open-segment 1\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n"
      "set-window 0 1 0 1\nopen-segment 2\npolygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n",
      "scene.draw", system);
  EXPECT_EQ(error_of([&] { OtherEye(system, *system.retained(), ""); }),
            "segments 1 and 2 are drawn in different views: expected one view for all");
}

}  // namespace
}  // namespace displayfile
