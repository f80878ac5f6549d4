// What a user sees of the methods that find lines: they are drawn, dumped, kept with a segment and
// replayed as an order of polygons is; fills hide, but are not drawn.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/recorder.h"
#include "displayfile/sorted_display_file.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "interp/draw.h"
#include "tests/gallery.h"

namespace displayfile {
namespace {

void enter_cube(GraphicsSystem& g, double x, double z) {
  const auto at = [&](double dx, double y, double dz) { return Point3(x + dx, y, z + dz); };
  const double h = 0.3;
  g.polygon_abs_3({at(-h, -h, h), at(h, -h, h), at(h, h, h), at(-h, h, h)});
  g.polygon_abs_3({at(h, -h, -h), at(-h, -h, -h), at(-h, h, -h), at(h, h, -h)});
  g.polygon_abs_3({at(h, -h, h), at(h, -h, -h), at(h, h, -h), at(h, h, h)});
  g.polygon_abs_3({at(-h, -h, -h), at(-h, -h, h), at(-h, h, h), at(-h, h, -h)});
  g.polygon_abs_3({at(-h, h, h), at(h, h, h), at(h, h, -h), at(-h, h, -h)});
  g.polygon_abs_3({at(-h, -h, -h), at(h, -h, -h), at(h, -h, h), at(-h, -h, h)});
}

/// Two cubes, each in a segment, the second before the first.
void enter_cubes(GraphicsSystem& g) {
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_view_depth(-2.0, 3.0);
  g.open_segment(1);
  enter_cube(g, -0.2, -0.4);
  g.close_segment();
  g.open_segment(2);
  enter_cube(g, 0.1, 0.4);
  g.close_segment();
}

struct Counts {
  int polygons = 0, lines = 0, picks = 0;
};
Counts counts(const std::string& dump) {
  Counts found;
  std::istringstream words(dump);
  bool in_polygon = false;
  for (std::string line; std::getline(words, line);) {
    found.polygons += line.starts_with("polygon ") ? 1 : 0;
    found.picks += line.starts_with("pick ") ? 1 : 0;
    in_polygon = in_polygon || line.starts_with("polygon ");
    found.lines += !in_polygon && line.starts_with("line ") ? 1 : 0;
  }
  return found;
}

std::string drawn(const GraphicsSystem& g, HiddenMethod method,
                  HiddenScope scope = HiddenScope::all) {
  SortedDisplayFile sorted;
  return dump(sorted.update(g, method, {.method = method, .scope = scope}));
}

TEST(LineDrawing, ShowsTheNineEdgesOfACubeThatAreSeen) {
  GraphicsSystem g;
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_hidden_method(HiddenMethod::franklin);
  g.set_hidden_line_removal(true);
  g.open_segment(1);
  enter_cube(g, 0.0, 0.0);
  g.close_segment();
  const Counts found = counts(dump(g.display_file()));
  EXPECT_EQ(found.polygons, 0);
  EXPECT_EQ(found.lines, 9);
  EXPECT_EQ(found.picks, 3);  // the lines stand under the polygons that they belong to
}

/// A side that two polygons share is drawn if one of them is outlined, whichever was entered first;
/// of a polygon of line style none nothing is drawn.
TEST(LineDrawing, ShowsTheSidesOfWhatHasALineStyle) {
  for (const bool outlined_first : {true, false}) {
    GraphicsSystem g;
    g.open_segment(1);
    for (const bool first : {true, false}) {
      const bool outlined = first == outlined_first;
      g.set_line_style({outlined ? LineStyle::Kind::solid : LineStyle::Kind::none});
      if (outlined) {
        g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}});
      } else {
        g.polygon_abs_3({{0.5, -0.5, 0}, {-0.5, -0.5, 0}, {0, -0.9, 0}});
      }
    }
    g.close_segment();
    const std::string dump = drawn(g, HiddenMethod::franklin);
    EXPECT_EQ(counts(dump).lines, 3) << dump;
    EXPECT_EQ(dump.find("line-style none"), dump.npos) << dump;
  }
}

TEST(LineDrawing, SegmentsHideEachOthersLinesWithTheScopeAll) {
  GraphicsSystem g;
  enter_cubes(g);
  const std::string all = drawn(g, HiddenMethod::franklin);
  const std::string each = drawn(g, HiddenMethod::franklin, HiddenScope::segment);
  EXPECT_NE(all, each);
  EXPECT_EQ(all, drawn(g, HiddenMethod::roberts));
  g.set_visibility(2, false);
  const std::string alone = drawn(g, HiddenMethod::franklin);
  EXPECT_EQ(counts(alone).lines, 9);
  g.set_visibility(2, true);
  EXPECT_EQ(drawn(g, HiddenMethod::franklin), all);
}

TEST(LineDrawing, FollowsEditsOfSegments) {
  GraphicsSystem g;
  enter_cubes(g);
  SortedDisplayFile kept;
  const HiddenSurfaceOptions options{.method = HiddenMethod::franklin, .scope = HiddenScope::all};
  const std::string before = dump(kept.update(g, HiddenMethod::franklin, options));
  g.set_image_translation(2, 0.3, 0.0);
  const std::string moved = dump(kept.update(g, HiddenMethod::franklin, options));
  EXPECT_NE(moved, before);
  EXPECT_EQ(moved, drawn(g, HiddenMethod::franklin));
  g.set_image_translation(2, 0.0, 0.0);
  EXPECT_EQ(dump(kept.update(g, HiddenMethod::franklin, options)), before);
}

TEST(LineDrawing, IsRecordedAndReplayed) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem g, again;
  g.set_recorder(&recorder);
  g.set_hidden_method(HiddenMethod::roberts);
  g.set_hidden_line_removal(true);
  enter_cubes(g);
  replay(recording.str(), "recording", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
}

/// Both methods find the same of every drawing program, and draw the same pixels.
TEST(LineDrawing, IsTheSameByBothMethodsOverTheGallery) {
  test::for_each_in_gallery([](const std::string&, const test::Retained& retained) {
    const GraphicsSystem& g = retained.system;
    EXPECT_EQ(drawn(g, HiddenMethod::roberts), drawn(g, HiddenMethod::franklin));
    DrawOptions options;
    options.width = options.height = 90;
    options.hidden = HiddenMethod::roberts;
    const Picture by_roberts = draw(g, options);
    options.hidden = HiddenMethod::franklin;
    options.threads = 3;
    EXPECT_EQ(draw(g, options).pixels, by_roberts.pixels);
  });
}

TEST(LineDrawing, HasNeitherItemBufferNorDepths) {
  GraphicsSystem g;
  enter_cubes(g);
  DrawOptions options;
  options.hidden = HiddenMethod::franklin;
  options.with_ids = true;
  EXPECT_THROW(draw(g, options), Error);
  options.with_ids = false;
  options.with_depth = true;
  EXPECT_THROW(draw(g, options), Error);
}

}  // namespace
}  // namespace displayfile
