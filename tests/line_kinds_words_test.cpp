// The words for kinds of lines, the routine that selects them, and the recorder of it.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/user_routines/system_inside.h"
#include "tests/error_of.h"
#include "tests/quad_meshes.h"
#include "tests/replayed.h"
#include "tests/sides_of_kinds.h"

namespace displayfile {
namespace {

using test::drawn_sides;
using test::enter;
using test::error_of;
using test::error_of_program;
using test::kAll;
using test::kCrease;
using test::kMaterial;
using test::kOutline;
using test::torus;

TEST(LineKinds, WordsReadBackToTheSelection) {
  EXPECT_EQ(words_of({}), "all");
  EXPECT_TRUE(LineSelection{}.is_all_alone());
  for (const std::string words :
       {"all", "outline", "outline boundary crease material intersection all", "crease=12.5"}) {
    LineSelection read{.kinds = 0};
    std::istringstream each(words);
    for (std::string word; each >> word;) add_line_kind(word, read);
    EXPECT_EQ(words_of(read), words);
  }
  EXPECT_EQ(line_selection("crease=40,crease").crease_degrees, 40.0);
  EXPECT_EQ(line_selection("outline,outline"), line_selection("outline"));
  EXPECT_EQ(names_of(kOutline | kCrease), "outline crease");
  EXPECT_EQ(first_name_of(kAll | kMaterial), "material");
  EXPECT_EQ(names_of(kDrawn), "");
}

TEST(LineKinds, OtherWordsAreRefused) {
  EXPECT_NE(error_of([] { line_selection("outlines"); }).find("did you mean 'outline'?"),
            std::string::npos)
      << error_of([] { line_selection("outlines"); });
  for (const char* const bad : {"", "crease=", "crease=181", "crease=-1", "crease=nan", "crease=x",
                                "crease=30x", "outline=3", "outline,", ",outline"}) {
    EXPECT_NE(error_of([&] { line_selection(bad); }).find("expected"), std::string::npos) << bad;
  }
  EXPECT_EQ(line_selection("crease=0").crease_degrees, 0.0);
  EXPECT_EQ(line_selection("crease=180").crease_degrees, 180.0);
  GraphicsSystem g;
  EXPECT_NE(error_of([&] { g.set_hidden_surfaces({.lines = LineSelection{.kinds = 0}}); }), "");
  EXPECT_NE(
      error_of([&] {
        g.set_hidden_surfaces({.lines = LineSelection{.kinds = kCrease, .crease_degrees = NAN}});
      }),
      "");
  EXPECT_NE(error_of([&] { g.set_hidden_surfaces({.lines = LineSelection{.kinds = kDrawn}}); }),
            "");
  EXPECT_EQ(g.hidden_surfaces().lines, LineSelection{});
}

TEST(LineKinds, DrawingProgramsTellTheWord) {
  EXPECT_EQ(error_of_program("set-lines outline creese\n").substr(0, 16), "scene.draw:1:19:");
  EXPECT_EQ(error_of_program("set-lines outline crease=200\n").substr(0, 16), "scene.draw:1:19:");
  EXPECT_NE(error_of_program("set-lines\n").find("expected one or more of all"), std::string::npos);
  EXPECT_EQ(error_of_program("set-lines crease=12 outline\n"), "");
}

TEST(LineKinds, NeedWhatWasRetained) {
  GraphicsSystem g;
  g.open_segment(1);
  g.close_segment();
  EXPECT_NE(error_of([&] { g.set_hidden_surfaces({.lines = line_selection("outline")}); }), "");
  EXPECT_EQ(g.hidden_surfaces().lines, LineSelection{});
  EXPECT_EQ(error_of([&] { g.set_hidden_surfaces({.lines = LineSelection{}}); }), "");
  GraphicsSystem first;
  first.set_hidden_surfaces({.lines = line_selection("outline")});
  EXPECT_NE(first.retained(), nullptr);
  EXPECT_NE(error_of([&] { first.retain(nullptr); }), "");
  RetainedScene scene;
  first.retain(&scene);
  EXPECT_EQ(first.retained(), &scene);
}

TEST(LineKinds, ReplacedLinesStay) {
  GraphicsSystem g;
  SystemInside::replace_lines(g, line_selection("crease"));
  replay("set-lines all outline\n", "scene.draw", g);
  EXPECT_EQ(g.hidden_surfaces().lines, line_selection("crease"));
  EXPECT_NE(error_of_program("set-lines what\n", g), "");
}

TEST(LineKinds, AreRecordedAndReplayed) {
  std::ostringstream program;
  Recorder recorder(program);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_hidden_surfaces({.lines = line_selection("outline,crease=12.25")});
  g.open_segment(1);
  enter(g, torus(7, 5));
  g.close_segment();
  EXPECT_NE(program.str().find("set-lines outline crease=12.25\n"), std::string::npos);
  const GraphicsSystem again = test::replayed(program.str());
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  EXPECT_EQ(drawn_sides(again.display_file()), drawn_sides(g.display_file()));
}

}  // namespace
}  // namespace displayfile
