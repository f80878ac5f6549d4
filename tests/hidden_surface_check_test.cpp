// HIDDEN-SURFACE-CHECK as applications use it: the result of close_segment, and the drawing.

#include "displayfile/segments/hidden_surface_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/interpreter.h"
#include "interp/draw/draw.h"
#include "interp/truth/truth.h"
#include "tests/polygon_area.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

constexpr int kSize = 96;

/// A system whose display coordinates are its world coordinates.
GraphicsSystem sorting_system(HiddenMethod method) {
  GraphicsSystem g = test::unit_square_without_lines();
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_hidden_surfaces({.method = method});
  return g;
}

FillStyle red() { return {FillStyle::Kind::solid, {1, 0, 0}}; }
FillStyle green() { return {FillStyle::Kind::solid, {0, 1, 0}}; }

/// A square of the display at one depth.
void enter_square(GraphicsSystem& g, double low, double high, double z) {
  g.polygon_abs_3({{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
}

/// Triangles anywhere, so that many run through each other.
void enter_triangles(GraphicsSystem& g, int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random() % 4096) / 4096.0; };
  const auto point = [&] {
    const double x = coordinate(), y = coordinate();
    return Point3(x, y, coordinate());
  };
  for (int i = 0; i < count; ++i) {
    const Point3 a = point(), b = point(), c = point();
    g.polygon_abs_3({a, b, c});
  }
}

std::vector<std::int32_t> true_ids(const GraphicsSystem& g) {
  return truth(g.display_file(), kSize, kSize, false).ids;
}

std::vector<std::int32_t> drawn_ids(const GraphicsSystem& g, DrawOptions options = {}) {
  options.width = options.height = kSize;
  options.samples = 1;
  options.with_ids = true;
  return draw(g, options).ids;
}

/// The contents of a walk: instructions as one word each, and the polygons themselves.
struct Walked {
  struct Polygon {
    std::vector<Point3> vertices;
    std::vector<std::int32_t> sides;
    FillStyle fill;
    int pick;
  };
  std::string words;
  std::vector<Polygon> polygons;
  FillStyle fill_style;
  int pick_id = -1;

  void fill(const FillStyle& s) {
    words += s.kind == FillStyle::Kind::hollow ? "hollow " : s.colour.r > 0 ? "red " : "green ";
    fill_style = s;
  }
  void line_style(const LineStyle& s) {
    words += s.kind == LineStyle::Kind::none ? "no-line " : "line-style ";
  }
  void pick(int id) {
    words += "pick-" + std::to_string(id) + " ";
    pick_id = id;
  }
  void segment(int name) { words += "segment-" + std::to_string(name) + " "; }
  void move(const Point3&) { words += "move "; }
  void line(const Point3&) { words += "line "; }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    words += "polygon ";
    polygons.push_back(
        {{vertices.begin(), vertices.end()}, {sides.begin(), sides.end()}, fill_style, pick_id});
  }
};

Walked walked(const GraphicsSystem& g, int segment) {
  Walked walk;
  g.display_file().segment(segment).walk_drawn(walk);
  return walk;
}

class HiddenSurfaceCheck : public testing::TestWithParam<HiddenMethod> {};
INSTANTIATE_TEST_SUITE_P(, HiddenSurfaceCheck,
                         testing::Values(HiddenMethod::bsp, HiddenMethod::depth_sort),
                         [](const auto& parameter) {
                           return parameter.param == HiddenMethod::bsp ? "Bsp" : "DepthSort";
                         });

// ---- The order, and its contents -----------------------------------------------------------

TEST_P(HiddenSurfaceCheck, BackToFrontWithStylesOnlyWhereTheyChange) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  g.set_fill_style(red());
  enter_square(g, 0.3, 0.7, 0.9);
  g.set_fill_style(green());
  enter_square(g, 0.2, 0.8, 0.5);
  g.set_fill_style(red());
  enter_square(g, 0.1, 0.9, 0.1);
  enter_square(g, 0.2, 0.6, 0.3);
  g.close_segment();
  EXPECT_EQ(walked(g, 1).words,
            "red no-line pick-2 polygon pick-3 polygon green pick-1 polygon red pick-0 polygon ");
  Walked entered;
  g.display_file().segment(1).walk_entered_drawn(entered);
  EXPECT_EQ(entered.words,
            "red no-line pick-0 polygon green pick-1 polygon red pick-2 polygon pick-3 polygon ");
}

/// A hollow polygon that a solid one runs through is cut, but drawn as its own outline.
TEST_P(HiddenSurfaceCheck, CutSidesAreInvisible) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  enter_square(g, 0.1, 0.9, 0.5);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.set_line_style({});
  const std::vector<Point3> hollow{{0.2, 0.3, 0.1},
                                   {0.8, 0.3, 0.9},
                                   {0.8, 0.7, 0.9},
                                   {0.4, 0.6, 0.3666666666666667},
                                   {0.2, 0.7, 0.1}};
  g.polygon_abs_3(hollow);
  g.close_segment();
  double outline = 0.0, drawn = 0.0;
  int pieces = 0;
  for (std::size_t i = 0; i < hollow.size(); ++i) {
    outline += length(hollow[i] - hollow[(i + 1) % hollow.size()]);
  }
  for (const auto& piece : walked(g, 1).polygons) {
    if (piece.fill.kind != FillStyle::Kind::hollow) continue;
    ++pieces;
    EXPECT_EQ(piece.pick, 1);
    for (std::size_t i = 0; i < piece.sides.size(); ++i) {
      if (piece.sides[i] != op::line) continue;
      drawn +=
          length(piece.vertices[i] - piece.vertices[i > 0 ? i - 1 : piece.vertices.size() - 1]);
    }
  }
  EXPECT_GE(pieces, 2);
  EXPECT_NEAR(drawn, outline, 1e-12);
}

using test::area;

TEST_P(HiddenSurfaceCheck, StylesAndPickIdentifiersFollowEveryPiece) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  std::map<int, double> areas, areas_of_pieces;
  std::map<int, Colour> colours;
  g.set_pick_id(40);
  g.set_fill_style(red());
  enter_triangles(g, 1, 1);
  g.set_pick_id(50);
  g.set_fill_style(green());
  enter_triangles(g, 1, 2);
  g.set_pick_id(60);
  g.set_fill_style({FillStyle::Kind::solid, {0, 0, 1}});
  enter_triangles(g, 1, 3);
  g.set_pick_id(-1);
  enter_triangles(g, 30, 4);
  g.close_segment();
  Walked entered;
  g.display_file().segment(1).walk_entered(entered);
  for (const auto& p : entered.polygons) {
    areas[p.pick] += area(p.vertices);
    colours[p.pick] = p.fill.colour;
  }
  const Walked drawn = walked(g, 1);
  EXPECT_GT(drawn.polygons.size(), entered.polygons.size());
  for (const auto& p : drawn.polygons) {
    areas_of_pieces[p.pick] += area(p.vertices);
    EXPECT_EQ(p.fill.colour, colours[p.pick]);
  }
  ASSERT_EQ(areas.size(), areas_of_pieces.size());
  for (const auto& [pick, size] : areas) EXPECT_NEAR(areas_of_pieces[pick], size, 1e-12) << pick;
}

TEST_P(HiddenSurfaceCheck, LinesAreInTheOrder) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  g.set_line_style({});
  g.move_abs_3(0.1, 0.5, 0.2);  // behind, from a polygon's last vertex on
  g.line_abs_3(0.9, 0.5, 0.2);
  g.line_abs_3(0.9, 0.6, 0.8);
  g.set_line_style({LineStyle::Kind::none});
  enter_square(g, 0.3, 0.7, 0.5);
  g.set_line_style({LineStyle::Kind::dashed});
  g.line_abs_3(0.3, 0.1, 0.8);
  g.close_segment();
  const DisplayFile& file = g.display_file();
  EXPECT_EQ(file.segment(1).sorted()->counts.pieces, 4u) << "three lines and the square";
  const auto pixels = [&](HiddenMethod method) {
    return draw(g, {.width = kSize, .height = kSize, .surfaces = {.method = method}, .samples = 1})
        .pixels;
  };
  ASSERT_EQ(file.segment(1).sorted()->counts.cuts, 0u);
  EXPECT_EQ(pixels(GetParam()), pixels(HiddenMethod::z_buffer));
}

TEST_P(HiddenSurfaceCheck, NothingToSort) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  g.close_segment();
  EXPECT_EQ(walked(g, 1).words, "");
  g.open_segment(2);
  g.move_abs_3(0.5, 0.5, 0.5);
  g.set_fill_style({FillStyle::Kind::hollow});
  enter_square(g, 0.1, 0.9, 0.5);  // hollow and without lines: draws nothing
  g.close_segment();
  EXPECT_EQ(walked(g, 2).words, "");
  EXPECT_EQ(g.display_file().segment(2).polygons(), 1u);  // as entered
  g.open_segment(3);
  g.set_fill_style(red());
  g.polygon_abs_3({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}});
  g.polygon_abs_3({{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, {0.5, 0.5, 0.5}});  // edge-on
  g.close_segment();
  EXPECT_EQ(drawn_ids(g), true_ids(g));
  EXPECT_THROW(g.close_segment(), Error);
}

/// Segments that lie at one depth store no z, and are sorted like others.
TEST_P(HiddenSurfaceCheck, FlatSegment) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  g.set_line_style({});
  g.set_fill_style(green());
  enter_square(g, 0.25, 0.75, 0.5);
  enter_square(g, 0.5, 0.8, 0.5);
  g.move_abs_2(0.1, 0.1);
  g.line_abs_2(0.9, 0.9);
  g.close_segment();
  EXPECT_FALSE(g.display_file().segment(1).stores_z());
  EXPECT_EQ(walked(g, 1).words, "green line-style pick-0 polygon pick-1 polygon move line ");
  EXPECT_EQ(drawn_ids(g), true_ids(g));
}

TEST(HiddenSurfaceCheckErrors, OnlyMethodsThatWorkInObjectSpace) {
  for (const auto method : {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::automatic}) {
    EXPECT_FALSE(is_object_space(method));
    EXPECT_THROW(hidden_surface_check(std::make_shared<Instructions>(), {}, {.method = method}),
                 Error);
  }
}

// ---- The hook: when a segment is sorted --------------------------------------------------

TEST_P(HiddenSurfaceCheck, OnlyWhereAskedFor) {
  GraphicsSystem g = sorting_system(GetParam());
  const auto segment_with = [&](int name) {
    g.open_segment(name);
    enter_square(g, 0.3, 0.7, 0.9);
    enter_square(g, 0.2, 0.8, 0.5);
    g.close_segment();
    return g.display_file().segment(name).sorted() != nullptr;
  };
  EXPECT_TRUE(segment_with(1));
  g.set_hidden_surfaces({.removal = false});
  EXPECT_FALSE(segment_with(2));
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.method = HiddenMethod::automatic});
  EXPECT_FALSE(segment_with(3));
  g.set_hidden_surfaces({.method = HiddenMethod::none});
  EXPECT_FALSE(segment_with(4));
  g.set_hidden_surfaces({.method = GetParam()});
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  EXPECT_FALSE(segment_with(5));  // sorted with the others, when they are drawn
  g.set_hidden_surfaces({.scope = HiddenScope::segment});
  g.set_hidden_surfaces({.precision = Precision{.exact = false, .roundoff = 1e-3}});
  EXPECT_TRUE(segment_with(6));
  EXPECT_EQ(g.display_file().segment(6).sorted()->plan.precision.roundoff, 1e-3);
}

TEST_P(HiddenSurfaceCheck, TruthAndZBufferReadWhatWasEntered) {
  GraphicsSystem sorted = sorting_system(GetParam()), entered = sorting_system(GetParam());
  entered.set_hidden_surfaces({.method = HiddenMethod::automatic});
  for (GraphicsSystem* g : {&sorted, &entered}) {
    g->open_segment(1);
    enter_triangles(*g, 60, 7);
    g->close_segment();
  }
  ASSERT_GT(sorted.display_file().segment(1).sorted()->counts.cuts, 0u);
  EXPECT_EQ(true_ids(sorted), true_ids(entered));
  EXPECT_EQ(drawn_ids(sorted, {.surfaces = {.method = HiddenMethod::z_buffer}}),
            drawn_ids(entered));
  EXPECT_EQ(drawn_ids(sorted, {.surfaces = {.method = HiddenMethod::none}}),
            drawn_ids(entered, {.surfaces = {.method = HiddenMethod::none}}));
  EXPECT_NE(drawn_ids(sorted, {.surfaces = {.method = HiddenMethod::none}}), true_ids(sorted));
  EXPECT_EQ(drawn_ids(sorted), true_ids(sorted));
}

/// Hidden-line removal turned off later leaves sorted segments unchanged.
TEST_P(HiddenSurfaceCheck, ClosedSegmentsKeepTheirOrder) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  enter_triangles(g, 60, 8);
  g.close_segment();
  g.set_hidden_surfaces({.removal = false});
  EXPECT_EQ(drawing_method(g, {}), HiddenMethod::none);
  EXPECT_EQ(drawn_ids(g), true_ids(g));
}

// ---- The drawing -------------------------------------------------------------------------

/// The sort at closing was of points that an image transformation then moved.
TEST_P(HiddenSurfaceCheck, ImageTransformation) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  enter_triangles(g, 50, 9);
  g.close_segment();
  const auto as_closed = g.display_file().segment(1).sorted();
  g.set_image_rotation(1, 33);
  g.set_image_scale(1, 0.9, -0.7);
  g.set_image_translation(1, 0.4, 0.6);
  EXPECT_EQ(g.display_file().segment(1).sorted(), as_closed);
  EXPECT_EQ(drawn_ids(g), true_ids(g));
  SortedDisplayFile kept;
  const DisplayFile drawn = kept.update(g, GetParam());
  EXPECT_TRUE(drawn.segment(1).sorted_as_drawn());
  EXPECT_NE(drawn.segment(1).sorted(), as_closed);
  EXPECT_EQ(kept.update(g, GetParam()).segment(1).sorted(), drawn.segment(1).sorted());
  g.set_image_rotation(1, 0);
  g.set_image_scale(1, 1, 1);
  g.set_image_translation(1, 0, 0);
  EXPECT_EQ(kept.update(g, GetParam()).segment(1).sorted(), as_closed);
}

/// Two segments that interlock: each sorted, the second is drawn over the first.
TEST_P(HiddenSurfaceCheck, ScopeOfAllSegments) {
  GraphicsSystem g = sorting_system(GetParam());
  for (int name : {1, 2, 3}) {
    g.open_segment(name);
    enter_triangles(g, 25, 10 + static_cast<unsigned>(name));
    g.close_segment();
  }
  g.set_image_translation(2, 0.1, -0.05);
  g.set_visibility(3, false);
  EXPECT_NE(drawn_ids(g), true_ids(g));
  EXPECT_EQ(drawn_ids(g, {.surfaces = {.scope = HiddenScope::all}}), true_ids(g));
  EXPECT_EQ(drawn_ids(g, {.surfaces = {.method = GetParam()}}),
            true_ids(g));  // set by the call
  EXPECT_EQ(drawn_ids(g, {.surfaces = {.method = GetParam(), .scope = HiddenScope::segment}}),
            drawn_ids(g));
  g.set_hidden_surfaces({.scope = HiddenScope::segment});
  EXPECT_NE(drawn_ids(g, {.surfaces = {.method = GetParam()}}),
            true_ids(g));  // as the application set it
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  EXPECT_EQ(drawn_ids(g), true_ids(g));
}

TEST_P(HiddenSurfaceCheck, WhatWasClosedUnderScopeAllIsSortedByItselfUnderScopeSegment) {
  GraphicsSystem g = sorting_system(GetParam()), always_each = sorting_system(GetParam());
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  for (GraphicsSystem* system : {&g, &always_each}) {
    for (int name : {1, 2}) {
      system->open_segment(name);
      enter_triangles(*system, 25, 10 + static_cast<unsigned>(name));
      system->close_segment();
    }
  }
  g.set_hidden_surfaces({.scope = HiddenScope::segment});
  EXPECT_EQ(drawn_ids(g), drawn_ids(always_each));
  SortedDisplayFile kept;
  const auto sorted = kept.update(g, GetParam()).segment(1).sorted();
  EXPECT_NE(sorted, nullptr);
  EXPECT_EQ(kept.update(g, GetParam()).segment(1).sorted(), sorted);
  EXPECT_EQ(drawn_ids(g, {.surfaces = {.scope = HiddenScope::segment}}), drawn_ids(always_each));
}

TEST_P(HiddenSurfaceCheck, SegmentsBeginAndEndWhereTheyChange) {
  GraphicsSystem g = sorting_system(GetParam());
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  g.set_fill_style(red());
  g.open_segment(4);
  enter_square(g, 0.1, 0.9, 0.1);
  enter_square(g, 0.2, 0.8, 0.5);
  g.close_segment();
  g.open_segment(2);
  enter_square(g, 0.3, 0.7, 0.3);
  enter_square(g, 0.4, 0.6, 0.7);
  g.close_segment();
  g.open_segment(9);
  g.close_segment();
  g.open_segment(8);
  enter_square(g, 0.4, 0.6, 0.9);
  g.close_segment();
  g.set_visibility(8, false);
  struct Device : OutputDevice {
    std::string words;
    void begin_segment(int name) override { words += "(" + std::to_string(name); }
    void end_segment() override { words += ")"; }
    void fill(const DrawnPolygon& p) override { words += " " + std::to_string(p.pick); }
    void edges(const DrawnPolygon&) override {}
    void line(const DrawnLine&) override {}
  } drawn, entered;
  SortedDisplayFile kept;
  const DisplayFile& file = kept.update(g, GetParam());
  interpret(file, drawn);
  EXPECT_EQ(drawn.words, "(4 0)(2 2)(4 1)(2 3)");
  interpret(file, entered, Pass::everything, Order::entered);
  EXPECT_EQ(entered.words, "(4 0 1)(2 2 3)(9)");

  std::istringstream text(dump(file));
  std::string heads;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("line ")) continue;
    heads += line.starts_with("polygon") ? "polygon\n" : line + "\n";
  }
  EXPECT_EQ(heads,
            "displayfile-dump 1\n"
            "segment 4 visible\nfill solid 1 0 0\nline-style none\npick 0\npolygon\n"
            "segment 2 visible\npick 2\npolygon\n"
            "segment 4 visible\npick 1\npolygon\n"
            "segment 2 visible\npick 3\npolygon\n"
            "segment 9 visible\n"
            "segment 8 invisible\nfill solid 1 0 0\nline-style none\npick 4\npolygon\n"
            "end\n");
}

/// Where polygons are coplanar the one entered later is visible, the later segment's before all
/// others.
TEST_P(HiddenSurfaceCheck, CoplanarPolygonsOfSeveralSegments) {
  GraphicsSystem g = sorting_system(GetParam());
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  for (int name : {7, 3, 5}) {
    g.open_segment(name);
    enter_square(g, 0.1 * name, 0.1 * name + 0.2, 0.5);
    enter_square(g, 0.2, 0.8, 0.5);
    g.close_segment();
  }
  EXPECT_EQ(drawn_ids(g), true_ids(g));
}

// ---- Sorted once -------------------------------------------------------------------------

TEST_P(HiddenSurfaceCheck, OnlyWhatChangedIsSortedAgain) {
  GraphicsSystem g = sorting_system(HiddenMethod::automatic);
  for (int name : {1, 2}) {
    g.open_segment(name);
    enter_triangles(g, 20, static_cast<unsigned>(name));
    g.close_segment();
  }
  const HiddenSurfaceOptions each{.method = GetParam(), .scope = HiddenScope::segment};
  const HiddenSurfaceOptions all{.method = GetParam(), .scope = HiddenScope::all};
  SortedDisplayFile kept;
  const DisplayFile first = kept.update(g, GetParam(), each);
  const DisplayFile again = kept.update(g, GetParam(), each);
  EXPECT_EQ(first.segment(1).sorted(), again.segment(1).sorted());
  EXPECT_EQ(first.segment(2).sorted(), again.segment(2).sorted());
  g.set_image_translation(2, 0.25, 0);
  const DisplayFile moved = kept.update(g, GetParam(), each);
  EXPECT_EQ(first.segment(1).sorted(), moved.segment(1).sorted());
  EXPECT_NE(first.segment(2).sorted(), moved.segment(2).sorted());

  const auto together = kept.update(g, GetParam(), all).sorted();
  ASSERT_NE(together, nullptr);
  EXPECT_EQ(kept.update(g, GetParam(), all).sorted(), together);
  const auto changes_order = [&](const std::function<void()>& change) {
    const auto before = kept.update(g, GetParam(), all).sorted();
    change();
    return kept.update(g, GetParam(), all).sorted() != before;
  };
  EXPECT_TRUE(changes_order([&] { g.set_visibility(1, false); }));
  EXPECT_FALSE(changes_order([&] { g.set_image_scale(1, 0.5, 0.5); }));  // not to be seen
  EXPECT_TRUE(changes_order([&] { g.set_visibility(1, true); }));
  EXPECT_TRUE(changes_order([&] { g.rename_segment(1, 6); }));
  EXPECT_TRUE(changes_order([&] { g.set_image_rotation(2, 5); }));
  EXPECT_TRUE(changes_order([&] {  // another segment of the same name
    g.delete_segment(2);
    g.open_segment(2);
    enter_triangles(g, 20, 99);
    g.close_segment();
  }));
  HiddenSurfaceOptions rounded = all;
  rounded.precision = Precision{.exact = false};
  const auto exact = kept.update(g, GetParam(), all).sorted();
  EXPECT_NE(kept.update(g, GetParam(), rounded).sorted(), exact);
  EXPECT_EQ(kept.update(g, GetParam(), rounded).sorted()->plan.precision.exact, false);
}

/// Sorted together, only the segments that overlap changed ones are sorted again.
TEST_P(HiddenSurfaceCheck, OnlyGroupsThatChangedAreSortedAgain) {
  GraphicsSystem g = sorting_system(HiddenMethod::automatic);
  for (int name = 1; name <= 4; ++name) {  // in a row, apart from each other
    const double x = 0.25 * name - 0.2;
    g.open_segment(name);
    g.set_fill_style(name % 2 == 0 ? red() : green());
    for (const double z : {0.5, 0.25}) {
      g.polygon_abs_3({{x, 0.1, z}, {x + 0.1, 0.1, 1.0 - z}, {x + 0.1, 0.9, z}});
    }
    g.close_segment();
  }
  const HiddenSurfaceOptions all{.method = GetParam(), .scope = HiddenScope::all};
  SortedDisplayFile kept;
  DrawOptions draw_all{.samples = 1};
  draw_all.surfaces.method = GetParam();
  const auto expect_work = [&](std::size_t groups, std::size_t sorted) {
    kept.update(g, GetParam(), all);
    EXPECT_EQ(kept.work().groups, groups);
    EXPECT_EQ(kept.work().sorted, sorted);
    draw_all.width = draw_all.height = kSize;
    draw_all.with_ids = true;
    EXPECT_EQ(draw(g, draw_all, kept).ids, true_ids(g));
    EXPECT_EQ(kept.work().sorted, 0u);
  };
  expect_work(4, 4);
  expect_work(4, 0);
  g.set_image_translation(4, 0, 0.05);  // still alone
  expect_work(4, 1);
  g.set_image_translation(2, 0.22, 0.03);  // on to the third
  expect_work(3, 1);
  g.set_visibility(1, false);
  expect_work(2, 0);
  g.set_image_translation(2, 0, 0);
  expect_work(3, 2);
  g.set_visibility(1, true);
  expect_work(4, 1);
}

/// Contents entered while the segment is open belong to the segment alone, not to copies made for
/// drawing.
TEST_P(HiddenSurfaceCheck, AnOpenSegmentIsDrawnAsItIs) {
  GraphicsSystem g = sorting_system(GetParam());
  g.open_segment(1);
  enter_square(g, 0.2, 0.8, 0.5);
  SortedDisplayFile kept;
  const HiddenSurfaceOptions all{.method = GetParam()};
  const DisplayFile before = kept.update(g, GetParam(), all);
  enter_square(g, 0.3, 0.7, 0.25);
  EXPECT_EQ(before.polygons(), 1u);
  EXPECT_EQ(before.sorted()->counts.pieces, 1u);
  EXPECT_EQ(kept.update(g, GetParam(), all).sorted()->counts.pieces, 2u);
  g.close_segment();
  EXPECT_EQ(drawn_ids(g), true_ids(g));
}

TEST(SegmentCopies, ShareInstructionsUntilOneIsChanged) {
  const std::vector<Point3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  const std::vector<std::uint8_t> all(3, 1);
  Segment segment(1);
  segment.enter_polygon(triangle, all);
  Segment open_copy = segment;
  segment.close();
  Segment closed_copy = segment;
  EXPECT_NE(open_copy.entered(), segment.entered());
  EXPECT_EQ(closed_copy.entered(), segment.entered());
  closed_copy.enter_polygon(triangle, all);
  EXPECT_EQ(segment.polygons(), 1u);
  EXPECT_EQ(open_copy.polygons(), 1u);
  EXPECT_EQ(closed_copy.polygons(), 2u);
}

}  // namespace
}  // namespace displayfile
