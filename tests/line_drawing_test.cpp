// The visible behaviour of the methods that find lines: they are drawn, dumped, kept with a segment
// and replayed as an order of polygons is; fills hide, but are not drawn.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/segments/scene_lines.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/views/turntable.h"
#include "hidden/lines/line_ends.h"
#include "interp/draw/draw.h"
#include "tests/from_eyes.h"
#include "tests/gallery.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::FromEyes;

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

/// Two cubes, each in a segment, the second before the first; from another eye, if one is given.
void enter_cubes(GraphicsSystem& g, const View* view = nullptr) {
  g.set_perspective(view != nullptr ? view->centre_of_projection : Point3(1.5, 1.2, 5.0));
  g.set_view_depth(-2.0, 3.0);
  if (view != nullptr) {
    g.set_view_reference_point(view->reference_point);
    g.set_view_plane_normal(view->plane_normal);
    g.set_view_up(view->up);
  }
  g.open_segment(1);
  enter_cube(g, -0.2, -0.4);
  g.close_segment();
  g.open_segment(2);
  enter_cube(g, 0.1, 0.4);
  g.close_segment();
}

struct Counts {
  int polygons = 0, lines = 0, picks = 0, moves = 0;
};
Counts counts(const std::string& dump) {
  Counts found;
  std::istringstream words(dump);
  bool in_polygon = false;
  for (std::string line; std::getline(words, line);) {
    found.polygons += line.starts_with("polygon ") ? 1 : 0;
    found.picks += line.starts_with("pick ") ? 1 : 0;
    found.moves += line.starts_with("move ") ? 1 : 0;
    in_polygon = in_polygon || line.starts_with("polygon ");
    found.lines += !in_polygon && line.starts_with("line ") ? 1 : 0;
  }
  return found;
}

/// The number of lines under each pick identifier.
std::map<int, int> lines_of_picks(const std::string& dump) {
  std::map<int, int> lines;
  std::istringstream words(dump);
  int pick = -1;
  for (std::string line; std::getline(words, line);) {
    if (line.starts_with("pick ")) pick = std::stoi(line.substr(5));
    if (line.starts_with("line ")) ++lines[pick];
  }
  return lines;
}

std::string drawn(const GraphicsSystem& g, HiddenMethod method,
                  HiddenScope scope = HiddenScope::all) {
  SortedDisplayFile sorted;
  return dump(sorted.update(g, method, {.method = method, .scope = scope}));
}

TEST(LineDrawing, ShowsTheNineEdgesOfACubeThatAreSeen) {
  GraphicsSystem g;
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_hidden_surfaces({.method = HiddenMethod::franklin});
  g.set_hidden_surfaces({.removal = true});
  g.open_segment(1);
  enter_cube(g, 0.0, 0.0);
  g.close_segment();
  const std::string text = dump(g.display_file());
  const Counts found = counts(text);
  EXPECT_EQ(found.polygons, 0);
  EXPECT_EQ(found.lines, 9);
  // The lines are under their polygons: the first of those that share them.
  const auto lines = lines_of_picks(text);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines.at(0), 4);
  EXPECT_EQ(lines.at(2), 3);
  EXPECT_EQ(lines.at(4), 2);
  // Four corners have three lines, so that there are two strokes, and one around the outline; they
  // continue where the pick identifier changes.
  EXPECT_GT(found.picks, 3);
  EXPECT_EQ(found.moves, 3) << text;
}

/// A side that two polygons share is drawn if one of them is outlined, whichever was entered first;
/// nothing is drawn of a polygon with line style none.
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
  EXPECT_EQ(all, drawn(g, HiddenMethod::appel));
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

/// An interrupted sort leaves segments sorted before unchanged, and an open segment open.
TEST(LineDrawing, IsStoppedWithNothingChanged) {
  GraphicsSystem g;
  enter_cubes(g);
  SortedDisplayFile kept;
  HiddenSurfaceOptions options{.method = HiddenMethod::franklin, .scope = HiddenScope::all};
  const std::string before = dump(kept.update(g, HiddenMethod::franklin, options));
  g.set_image_translation(2, 0.3, 0.0);
  options.progress = [](std::size_t, std::size_t) { throw Error("enough"); };
  EXPECT_THROW(kept.update(g, HiddenMethod::franklin, options), Error);
  EXPECT_EQ(dump(kept.display_file()), before);
  options.progress = {};
  EXPECT_EQ(dump(kept.update(g, HiddenMethod::franklin, options)),
            drawn(g, HiddenMethod::franklin));

  g.set_hidden_surfaces({.method = HiddenMethod::franklin});
  g.set_hidden_surfaces({.removal = true});
  g.set_progress([](std::size_t, std::size_t) { throw Error("enough"); });
  g.open_segment(3);
  enter_cube(g, 0.0, 0.0);
  EXPECT_THROW(g.close_segment(), Error);
  g.set_progress({});
  g.close_segment();
  EXPECT_EQ(counts(drawn(g, HiddenMethod::franklin)).polygons, 0);
}

/// A retained scene's lines in a new view are those of a system that enters it there.
TEST(LineDrawing, NewViewsOfARetainedSceneAreThoseOfEnteringIt) {
  test::Retained retained;
  enter_cubes(retained.system);
  FromEyes renderer(retained.scene, retained.system.display_file());
  const Turntable turntable(retained.scene, retained.system.display_file(), {});
  DrawOptions options;
  options.samples = 1;
  options.width = options.height = 90;
  options.with_ids = false;
  for (const HiddenMethod method : {HiddenMethod::roberts, HiddenMethod::franklin}) {
    options.surfaces.method = method;
    for (const auto scope : {std::optional<HiddenScope>(), std::optional(HiddenScope::segment)}) {
      options.surfaces.scope = scope;
      for (const double degrees : {0.0, 40.0, 190.0}) {
        const View view = turntable.at(degrees).view;
        GraphicsSystem anew;
        enter_cubes(anew, &view);
        EXPECT_EQ(renderer.draw(view, options).pixels, draw(anew, options).pixels) << degrees;
      }
    }
  }
  options.with_ids = true;
  EXPECT_THROW(renderer.draw(turntable.at(0.0).view, options), Error);
}

TEST(LineDrawing, IsRecordedAndReplayed) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem g, again;
  g.set_recorder(&recorder);
  g.set_hidden_surfaces({.method = HiddenMethod::roberts});
  g.set_hidden_surfaces({.hidden_lines = HiddenLines::dashed});
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  enter_cubes(g);
  EXPECT_NE(recording.str().find("set-hidden-lines dashed\n"), std::string::npos);
  replay(recording.str(), "recording", again);
  EXPECT_EQ(again.hidden_surfaces().hidden_lines, HiddenLines::dashed);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
}

/// All methods find the same of every drawing program, and draw the same pixels.
TEST(LineDrawing, IsTheSameByAllMethodsOverTheGallery) {
  test::for_each_in_gallery([](const std::string&, const test::Retained& retained) {
    const GraphicsSystem& g = retained.system;
    const std::string by_roberts_drawn = drawn(g, HiddenMethod::roberts);
    DrawOptions options;
    options.samples = 1;
    options.width = options.height = 90;
    options.surfaces.method = HiddenMethod::roberts;
    const Picture by_roberts = draw(g, options);
    options.surfaces.threads = 3;
    for (const HiddenMethod method : {HiddenMethod::appel, HiddenMethod::franklin}) {
      EXPECT_EQ(drawn(g, method), by_roberts_drawn) << name_of(method);
      options.surfaces.method = method;
      EXPECT_EQ(draw(g, options).pixels, by_roberts.pixels) << name_of(method);
    }
  });
}

// ---- Hidden lines -------------------------------------------------------------------------------

void enter_cube_with_back(GraphicsSystem& g) {
  g.set_perspective({1.5, 1.2, 5.0});
  g.set_hidden_surfaces({.method = HiddenMethod::franklin});
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.open_segment(1);
  enter_cube(g, 0.0, 0.0);
  g.close_segment();
}

TEST(LineDrawing, HiddenLinesAreDashedBeforeTheVisibleOnes) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.hidden_lines = HiddenLines::dashed});
  g.set_line_style({.colour = {0.0, 0.0, 1.0}, .width = 3.0});
  enter_cube_with_back(g);
  const std::string all = dump(g.display_file());
  EXPECT_EQ(counts(all).lines, 12);
  const auto dashed = all.find("line-style dashed 0 0 1 1.5 9 6");
  const auto solid = all.find("line-style solid 0 0 1 3");
  ASSERT_NE(dashed, all.npos) << all;
  EXPECT_LT(dashed, solid);
  EXPECT_EQ(counts(all.substr(dashed, solid - dashed)).lines, 3);
  EXPECT_EQ(counts(all).polygons, 0);
}

/// As with the precision: hidden lines found by close-segment stay until other options are
/// requested.
TEST(LineDrawing, HiddenLinesAreFoundAnewWhereTheyAreAskedForOtherwise) {
  GraphicsSystem g;
  enter_cube_with_back(g);
  const std::string none = dump(g.display_file());
  EXPECT_EQ(counts(none).lines, 9);
  SortedDisplayFile kept;
  const auto lines = [&](std::optional<HiddenLines> asked) {
    return counts(dump(kept.update(g, HiddenMethod::franklin, {.hidden_lines = asked}))).lines;
  };
  EXPECT_EQ(lines({}), 9);
  EXPECT_EQ(lines(HiddenLines::dashed), 12);
  EXPECT_EQ(lines(HiddenLines::none), 9);
  g.set_hidden_surfaces(
      {.hidden_lines = HiddenLines::dashed});  // of segments that are closed from now on
  EXPECT_EQ(lines({}), 9);
  const auto together = [&](std::optional<HiddenLines> asked) {
    return counts(dump(kept.update(g, HiddenMethod::franklin,
                                   {.scope = HiddenScope::all, .hidden_lines = asked})))
        .lines;
  };
  EXPECT_EQ(together({}), 12);
  EXPECT_EQ(kept.work().sorted, 1u);
  EXPECT_EQ(together({}), 12);
  EXPECT_EQ(kept.work().sorted, 0u);
  EXPECT_EQ(together(HiddenLines::none), 9);
  EXPECT_EQ(kept.work().sorted, 1u);
}

TEST(LineDrawing, AWhollyHiddenSegmentIsDrawnDashedWithTheScopeAll) {
  GraphicsSystem g;
  g.open_segment(1);
  g.polygon_abs_3({{-0.3, -0.2, -1}, {0.3, -0.2, -1}, {0.0, 0.3, -1}});
  g.close_segment();
  g.open_segment(2);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
  g.close_segment();
  SortedDisplayFile sorted;
  const std::string all = dump(sorted.update(g, HiddenMethod::franklin,
                                             {.method = HiddenMethod::franklin,
                                              .scope = HiddenScope::all,
                                              .hidden_lines = HiddenLines::dashed}));
  EXPECT_EQ(counts(all).lines, 7);
  const std::size_t dashed = all.find("line-style dashed"), second = all.find("segment 2");
  ASSERT_NE(dashed, all.npos) << all;
  EXPECT_LT(all.find("segment 1"), dashed);
  EXPECT_LT(dashed, second);
}

/// In the orders of the sorts they come after all fills.
TEST(LineDrawing, HiddenLinesAreDrawnOverFillsThatWereSorted) {
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    GraphicsSystem g;
    enter_cubes(g);
    SortedDisplayFile sorted;
    const HiddenSurfaceOptions plain{.method = method, .scope = HiddenScope::all};
    HiddenSurfaceOptions dashed = plain;
    dashed.hidden_lines = HiddenLines::dashed;
    const std::string without = dump(sorted.update(g, method, plain));
    const std::string with = dump(sorted.update(g, method, dashed));
    const std::size_t begin = with.find("line-style dashed");
    ASSERT_NE(begin, with.npos);
    EXPECT_GT(counts(with.substr(begin)).lines, 3);
    EXPECT_EQ(with.find("polygon ", begin), with.npos);
    EXPECT_EQ(counts(with).polygons, counts(without).polygons);
    EXPECT_EQ(counts(without).lines, 0);
    // The same as a method of lines draws.
    const std::string lines = dump(sorted.update(g, HiddenMethod::franklin,
                                                 {.method = HiddenMethod::franklin,
                                                  .scope = HiddenScope::all,
                                                  .hidden_lines = HiddenLines::dashed}));
    const auto moves_and_lines = [](const std::string& text) {
      std::istringstream in(text);
      std::vector<std::string> found;
      for (std::string line; std::getline(in, line);) {
        if (line.starts_with("line-style solid")) break;
        if (line.starts_with("line ")) found.push_back(line);
      }
      return found;
    };
    EXPECT_EQ(moves_and_lines(with.substr(begin)), moves_and_lines(lines));
  }
}

/// One plate through another, in one segment.
void enter_crossing_plates(GraphicsSystem& g) {
  g.set_back_face_removal(false);
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
  g.polygon_abs_3({{-0.4, -0.3, -1}, {0.4, -0.3, -1}, {0.4, 0.3, 1}, {-0.4, 0.3, 1}});
  g.close_segment();
}

TEST(LineDrawing, IntersectionsAreDrawnOverFillsThatWereSortedInEitherScope) {
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    GraphicsSystem g;
    g.set_hidden_surfaces({.method = method});
    g.set_hidden_surfaces({.removal = true});
    g.set_hidden_surfaces({.lines = line_selection("intersection")});
    enter_crossing_plates(g);
    SortedDisplayFile sorted;
    const auto last_line = [&](HiddenScope scope) {
      const DisplayFile& file = sorted.update(g, method, {.scope = scope});
      const auto order =
          scope == HiddenScope::all ? file.sorted() : file.segments().front().sorted();
      const std::string text = dump(file);
      const auto polygons = static_cast<std::size_t>(counts(text).polygons);
      EXPECT_EQ(order->counts.pieces, polygons + 1) << name_of(scope);
      return text.substr(text.rfind("\nmove "));
    };
    const std::string all = last_line(HiddenScope::all);
    EXPECT_EQ(counts(all).lines, 1) << all;
    EXPECT_EQ(last_line(HiddenScope::segment), all) << name_of(method);
  }
}

/// Later settings apply to segments closed later, in pixels as in the instructions.
TEST(LineDrawing, PixelsHaveTheHiddenLinesAndIntersectionsThatAnOrderHas) {
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    const auto pictures = [&](HiddenLines hidden, const char* lines) {
      GraphicsSystem g;
      g.set_hidden_surfaces({.method = method});
      g.set_hidden_surfaces({.removal = true});
      g.set_hidden_surfaces({.hidden_lines = hidden});
      g.set_hidden_surfaces({.lines = line_selection(lines)});
      enter_crossing_plates(g);
      DrawOptions options;
      options.samples = 1;
      options.width = options.height = 90;
      const Picture before = draw(g, options);
      g.set_hidden_surfaces(
          {.hidden_lines = hidden == HiddenLines::none ? HiddenLines::dashed : HiddenLines::none});
      g.set_hidden_surfaces({.lines = line_selection("all")});
      EXPECT_EQ(draw(g, options).pixels, before.pixels) << name_of(method) << " " << lines;
      return before;
    };
    const Picture plain = pictures(HiddenLines::none, "all");
    EXPECT_NE(pictures(HiddenLines::dashed, "all").pixels, plain.pixels);
    EXPECT_NE(pictures(HiddenLines::none, "all,intersection").pixels, plain.pixels);
  }
}

// ---- Chains -------------------------------------------------------------------------------------

/// Chains change the order and direction of the pieces, and nothing else.
TEST(LineDrawing, ChainsAreOfThePiecesThatAreSeen) {
  test::for_each_in_gallery([](const std::string&, const test::Retained& retained) {
    const ViewedScene scene(retained.system.display_file());
    Primitives items = scene.primitives();
    const std::vector<std::uint8_t> sides = scene.drawn_sides();
    items.visible = sides;
    const SortedPieces sorted = lines_in_order(
        items, {}, find_lines(scene, {.method = HiddenMethod::franklin}), HiddenLines::none);
    using Piece = std::tuple<std::uint32_t, double, double, double, double>;
    const auto piece = [](std::uint32_t item, Point3 a, Point3 b) {
      if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) std::swap(a, b);
      return Piece{item, a.x, a.y, b.x, b.y};
    };
    std::vector<Piece> found, expected;
    for (const SortedPiece& p : sorted.pieces) {
      found.push_back(piece(p.item, sorted.points[p.first], sorted.points[p.first + 1]));
    }
    for (const auto& [item, corner, from, to] :
         visible_lines(items, drawn_lines(items), {.method = HiddenMethod::franklin}).pieces) {
      const LineEnds ends(items, {item, corner});
      if (Point2(ends.at(from)) == Point2(ends.at(to))) continue;  // no dot is drawn
      expected.push_back(piece(item, ends.at(from), ends.at(to)));
    }
    std::ranges::sort(found);
    std::ranges::sort(expected);
    EXPECT_EQ(found, expected);
  });
}

/// Two squares, one half behind the other: two strokes.
TEST(LineDrawing, APieceThatIsOnePointIsNoDot) {
  const std::vector<Point3> points{{0.25, 0.25, 0.0}, {0.75, 0.25, 0.0}};
  const std::vector<Primitives::Item> items{{0, 2, Primitives::Kind::line}};
  const Primitives line{points, {}, {}, items};
  FoundLines found{{{{0, 1}, kDrawn, 0}}, {}, {}};
  found.seen.pieces = {{0, 1, 0.125, 0.25}, {0, 1, 0.5, std::nextafter(0.5, 1.0)}};
  const SortedPieces order = lines_in_order(line, {}, found, HiddenLines::none);
  ASSERT_EQ(order.pieces.size(), 1u);
  EXPECT_EQ(order.points[0], Point3(0.3125, 0.25, 0.0));
  EXPECT_EQ(order.points[1], Point3(0.375, 0.25, 0.0));
}

TEST(LineDrawing, AStrokeGoesOnAroundCorners) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.method = HiddenMethod::franklin});
  g.set_hidden_surfaces({.removal = true});
  g.open_segment(1);
  g.polygon_abs_3({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
  g.polygon_abs_3({{0.1, -0.5, -1}, {0.9, -0.5, -1}, {0.9, 0.2, -1}, {0.1, 0.2, -1}});
  g.close_segment();
  const std::string text = dump(g.display_file());
  EXPECT_EQ(counts(text).lines, 7);
  EXPECT_EQ(counts(text).moves, 2) << text;
}

/// The dashes of a triangle's sides, which run on around its corners, are those of the line.
TEST(LineDrawing, DashesRunOnThroughCorners) {
  const std::vector<Point3> corners{{-0.61, -0.5, 0}, {0.7, -0.33, 0}, {0.1, 0.57, 0}};
  DrawOptions options;
  options.width = 90;
  options.height = 70;
  options.samples = 1;
  const auto picture = [&](bool as_lines) {
    GraphicsSystem g;
    g.set_hidden_surfaces({.method = HiddenMethod::franklin});
    g.set_hidden_surfaces({.removal = true});
    g.set_line_style({.kind = LineStyle::Kind::dashed, .width = 2.0, .dash = 7.0, .gap = 5.0});
    g.open_segment(1);
    if (as_lines) {
      g.move_abs_3(corners[2].x, corners[2].y, corners[2].z);
      for (const Point3& p : corners) g.line_abs_3(p.x, p.y, p.z);
    } else {
      g.polygon_abs_3(corners);
    }
    g.close_segment();
    return draw(g, options).pixels;
  };
  EXPECT_EQ(picture(false), picture(true));
  GraphicsSystem apart;  // each side with dashes of its own
  apart.set_line_style({.kind = LineStyle::Kind::dashed, .width = 2.0, .dash = 7.0, .gap = 5.0});
  apart.open_segment(1);
  for (const std::size_t k : {0u, 2u, 1u}) {
    const Point3 &a = corners[(k + 2) % 3], &b = corners[k];
    apart.move_abs_3(a.x, a.y, a.z);
    apart.line_abs_3(b.x, b.y, b.z);
  }
  apart.close_segment();
  EXPECT_NE(draw(apart, options).pixels, picture(true));
}

TEST(LineDrawing, HasNeitherItemBufferNorDepths) {
  GraphicsSystem g;
  enter_cubes(g);
  DrawOptions options;
  options.samples = 1;
  options.surfaces.method = HiddenMethod::franklin;
  options.with_ids = true;
  EXPECT_THROW(draw(g, options), Error);
  options.with_ids = false;
  options.with_depth = true;
  EXPECT_THROW(draw(g, options), Error);
}

}  // namespace
}  // namespace displayfile
