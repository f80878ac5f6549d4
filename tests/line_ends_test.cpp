// Ends of lines in SVG and PDF: round caps, and none where something hides the rest of the line.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/output_device.h"
#include "interp/draw/draw.h"
#include "interp/vector/svg_device.h"
#include "tests/rasterised.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

constexpr std::uint32_t kRedPixel = 0xff0000ff, kYellowPixel = 0xff00ffff, kWhitePixel = 0xffffffff;

/// A wall without lines up to half the picture's height, and lines behind it that rise above it.
constexpr const char* kBehindAWall = R"(
  set-window 0 1 0 1
  set-view-depth -1 1
  set-hidden-scope all
  open-segment 1
  set-line-style none
  set-fill-style solid 1 1 0
  polygon-abs-3 0.1 0.1 0.5  0.9 0.1 0.5  0.9 0.5 0.5  0.1 0.5 0.5
  set-line-style solid 1 0 0 16
  move-abs-3 0.5 0.2 -0.5
  line-abs-3 0.5 0.8 -0.5
  close-segment)";

DrawnPieces pieces_of(const GraphicsSystem& g, HiddenMethod method,
                      HiddenSurfaceOptions options = {}) {
  SortedDisplayFile sorted;
  options.method = method;
  return drawn_pieces(sorted.update(g, method, options));
}

/// The cuts of lines, by the heights of their two ends.
using Cuts = std::vector<std::array<double, 4>>;
Cuts cuts_of_lines(const DrawnPieces& pieces) {
  Cuts all;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces.kinds[k] != DrawnPieces::Kind::line) continue;
    const std::size_t at = pieces.first[k];
    all.push_back({pieces.points[at].y, pieces.points[at + 1].y, double(pieces.cuts[at]),
                   double(pieces.cuts[at + 1])});
  }
  return all;
}

TEST(LineCuts, AreWhereSomethingHidesTheRest) {
  const GraphicsSystem g = replayed(kBehindAWall);
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin, HiddenMethod::map}) {
    EXPECT_EQ(cuts_of_lines(pieces_of(g, method)), (Cuts{{0.5, 0.8, 1, 0}}));
  }
  EXPECT_EQ(cuts_of_lines(pieces_of(g, HiddenMethod::none)), (Cuts{{0.2, 0.8, 0, 0}}));
}

TEST(LineCuts, OfAHiddenPartAreWhereItIsSeen) {
  const DrawnPieces pieces = pieces_of(replayed(kBehindAWall), HiddenMethod::franklin,
                                       {.hidden_lines = HiddenLines::dashed});
  EXPECT_EQ(cuts_of_lines(pieces), (Cuts{{0.2, 0.5, 0, 1}, {0.5, 0.8, 1, 0}}));
}

/// A part of a line in the middle, and one that ends at a vertex of the wall: that vertex is not
/// one of the line's.
TEST(LineCuts, AtBothEndsAndAtVerticesOfWhatHides) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 1
    open-segment 1
    set-line-style none
    set-hidden-line-removal on
    polygon-abs-3 0.2 0.1 0.5  0.8 0.1 0.5  0.8 0.25 0.5  0.2 0.25 0.5
    polygon-abs-3 0.5 0.75 0.5  0.8 0.9 0.5  0.2 0.9 0.5
    set-line-style solid 1 0 0 16
    move-abs-3 0.5 0.0 -0.5
    line-abs-3 0.5 1.0 -0.5
    close-segment)");
  EXPECT_EQ(cuts_of_lines(pieces_of(g, HiddenMethod::franklin)),
            (Cuts{{0.0, 0.1, 0, 1}, {0.25, 0.75, 1, 1}, {0.9, 1.0, 1, 0}}));
}

/// Lines, and sides of polygons, that a sort cuts in two.
TEST(LineCuts, OfASortAreWhereItsPiecesMeet) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 2
    open-segment 1
    set-fill-style solid 1 1 0
    set-line-style none
    polygon-abs-3 0 0 0.5  1 0 0.5  1 1 0.5  0 1 0.5
    set-line-style solid 1 0 0 16
    polygon-abs-3 0.2 0.2 0  0.8 0.2 1  0.8 0.8 1  0.2 0.8 0
    move-abs-3 0.5 0.1 0
    line-abs-3 0.5 0.9 1
    close-segment)");
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    const DrawnPieces pieces = pieces_of(g, method);
    std::size_t cuts = 0;
    for (std::size_t i = 0; i < pieces.points.size(); ++i) {
      if (pieces.cuts[i] == 0) continue;
      ++cuts;
      EXPECT_NEAR(pieces.points[i].x, 0.5, 1e-12);
    }
    EXPECT_EQ(cuts, 2u * 3u) << "two sides and the line";
  }
}

/// The viewport is the picture's left half, and a border of it is inside of the picture.
TEST(LineCuts, AreWhereTheWindowEnds) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 1
    set-viewport 0 0.5 0 1
    set-hidden-scope all
    open-segment 1
    set-line-style solid 1 0 0 16
    move-abs-3 -1 0.25 0
    line-abs-3 2 0.75 0
    move-abs-3 -1 0.5 0
    line-abs-3 0.5 0.5 0
    close-segment)");
  for (const HiddenMethod method : {HiddenMethod::franklin, HiddenMethod::map, HiddenMethod::bsp}) {
    std::vector<std::array<double, 4>> ends;
    const DrawnPieces pieces = pieces_of(g, method);
    for (std::size_t i = 0; i < pieces.points.size(); i += 2) {
      ends.push_back({pieces.points[i].x, pieces.points[i + 1].x, double(pieces.cuts[i]),
                      double(pieces.cuts[i + 1])});
    }
    EXPECT_EQ(ends, (Cuts{{0.0, 0.5, 0, 1}, {0.0, 0.25, 0, 0}}));
  }
}

TEST(LineCuts, OfIntersectionsAreNotAtTheirOwnEnds) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 2
    set-lines intersection
    open-segment 1
    set-fill-style solid 1 1 0
    polygon-abs-3 0.2 0.2 0.5  0.8 0.2 0.5  0.8 0.8 0.5  0.2 0.8 0.5
    polygon-abs-3 0.3 0.0 0  0.7 0.0 1  0.7 1.0 1  0.3 1.0 0
    polygon-abs-3 0.4 0.4 0.9  0.6 0.4 0.9  0.6 0.5 0.9  0.4 0.5 0.9
    close-segment)");
  Cuts cuts = cuts_of_lines(pieces_of(g, HiddenMethod::franklin));
  std::erase_if(cuts, [](const auto& line) { return line[0] == line[1]; });
  EXPECT_EQ(cuts.size(), 2u);
  for (const auto& [from, to, at_from, at_to] : cuts) {
    EXPECT_EQ(at_from, from == 0.2 || from == 0.8 ? 0.0 : 1.0) << from;
    EXPECT_EQ(at_to, to == 0.2 || to == 0.8 ? 0.0 : 1.0) << to;
  }
}

/// The paths and the rules of lines of a picture of 100 x 100.
std::string svg_of(std::initializer_list<DrawnLine> lines) {
  SvgDevice device(100, 100);
  device.begin_segment(1);
  for (const DrawnLine& line : lines) device.line(line);
  device.end_segment();
  std::ostringstream out;
  device.finish(out);
  const std::string svg = without_keys(std::move(out).str());
  std::string found;
  const std::regex wanted("(\\.l[0-9]+\\{.*\\}|<path .*/>)\n");
  for (std::sregex_iterator i(svg.begin(), svg.end(), wanted), end; i != end; ++i) {
    found += (*i)[1].str() + "\n";
  }
  return found;
}

const Point3 kLeft(0.2, 0.5, 0), kMiddle(0.5, 0.5, 0), kRight(0.8, 0.5, 0), kTop(0.8, 0.9, 0);

TEST(SvgDevice, SolidLinesHaveRoundCaps) {
  const LineStyle style = line(kRed, 4.0);
  EXPECT_EQ(svg_of({{kLeft, kRight, style}, {kRight, kTop, style}}),
            ".l1{stroke:#ff0000;stroke-width:4;stroke-linecap:round}\n"
            "<path class=\"l1\" d=\"M20 50l60 0 0-40\"/>\n");
}

TEST(SvgDevice, CutEndsHaveNoCaps) {
  const LineStyle style = line(kRed, 4.0);
  EXPECT_EQ(svg_of({{kLeft, kRight, style, kDrawn, {true, true}}}),
            ".l1{stroke:#ff0000;stroke-width:4}\n"
            "<path class=\"l1\" d=\"M20 50l60 0\"/>\n");
}

/// The other end's cap is a disc, after all lines of the style; lines that continue have one end
/// each.
TEST(SvgDevice, TheOtherEndOfACutLineHasADisc) {
  const LineStyle style = line(kRed, 4.0);
  EXPECT_EQ(svg_of({{kLeft, kMiddle, style, kDrawn, {false, true}},
                    {kTop, kRight, style, kDrawn, {true, false}},
                    {kRight, kMiddle, style}}),
            ".l1{stroke:#ff0000;stroke-width:4}\n"
            ".l2{stroke:#ff0000;stroke-width:4;stroke-linecap:round}\n"
            "<path class=\"l1\" d=\"M20 50l30 0\"/>\n"
            "<path class=\"l1\" d=\"M80 10l0 40-30 0\"/>\n"
            "<path class=\"l2\" d=\"M20 50l0 0M50 50l0 0\"/>\n");
}

/// A disc would reach over the polygon that hides the line.
TEST(SvgDevice, ALineShorterThanHalfItsWidthHasNoDisc) {
  EXPECT_EQ(svg_of({{kLeft, kMiddle, line(kRed, 61.0), kDrawn, {false, true}}}),
            ".l1{stroke:#ff0000;stroke-width:61}\n"
            "<path class=\"l1\" d=\"M20 50l30 0\"/>\n");
}

TEST(SvgDevice, DashedLinesHaveNoCaps) {
  const LineStyle style{LineStyle::Kind::dashed, kRed, 4.0, 6.0, 3.0};
  EXPECT_EQ(svg_of({{kLeft, kMiddle, style}, {kTop, kRight, style, kDrawn, {false, true}}}),
            ".l1{stroke:#ff0000;stroke-width:4;stroke-dasharray:6 3}\n"
            "<path class=\"l1\" d=\"M20 50l30 0\"/>\n"
            "<path class=\"l1\" d=\"M80 10l0 40\"/>\n");
}

/// As other programs draw them.
class LineEnds : public TemporaryFolder, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    if (!have(rasteriser(GetParam())))
      GTEST_SKIP() << rasteriser(GetParam()) << " is not installed";
  }
  Picture draw(const GraphicsSystem& g, HiddenMethod method) const {
    const auto path = file(std::string("a.") + GetParam());
    DrawOptions options{.width = 100, .height = 100, .samples = 1};
    options.surfaces.method = method;
    displayfile::draw(g, path, options);
    return rasterised(path);
  }
};
INSTANTIATE_TEST_SUITE_P(Vector, LineEnds, testing::Values("svg", "pdf"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(LineEnds, ALineEndsWhereSomethingHidesTheRest) {
  const GraphicsSystem g = replayed(kBehindAWall);
  const Picture p = draw(g, HiddenMethod::map);
  for (const double x : {0.43, 0.5, 0.57}) {  // 8 pixels to either side
    EXPECT_EQ(at(p, x, 0.495), kYellowPixel) << x;
    EXPECT_EQ(at(p, x, 0.515), kRedPixel) << x;
  }
  EXPECT_EQ(at(p, 0.5, 0.86), kRedPixel) << "a round cap at its own end";
  EXPECT_EQ(at(p, 0.435, 0.865), kWhitePixel);
  EXPECT_EQ(at(p, 0.5, 0.895), kWhitePixel);
}

/// By franklin the polygons that hide are white, and only the line is drawn.
TEST_P(LineEnds, ByAMethodOfLinesToo) {
  const Picture p = draw(replayed(kBehindAWall), HiddenMethod::franklin);
  for (const double x : {0.43, 0.5, 0.57}) {
    EXPECT_EQ(at(p, x, 0.495), kWhitePixel) << x;
    EXPECT_EQ(at(p, x, 0.515), kRedPixel) << x;
  }
  EXPECT_EQ(at(p, 0.5, 0.86), kRedPixel);
}

/// Lines of two segments are paths of their own, as those of different kinds are.
TEST_P(LineEnds, NoNotchWhereTwoPathsMeet) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 1
    set-hidden-scope all
    set-line-style solid 1 0 0 16
    open-segment 1
    move-abs-3 0.2 0.8 0
    line-abs-3 0.2 0.2 0
    close-segment
    open-segment 2
    move-abs-3 0.2 0.2 0
    line-abs-3 0.8 0.2 0
    close-segment)");
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::none}) {
    const Picture p = draw(g, method);
    EXPECT_EQ(at(p, 0.155, 0.155), kRedPixel) << "outside of the corner, within half a width of it";
  }
}

/// A polygon of which one side is a crease and the others are a boundary: two paths.
TEST_P(LineEnds, NoNotchWhereABoundaryTurnsIntoACrease) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 1
    set-lines boundary crease=10
    open-segment 1
    set-fill-style solid 1 1 0
    set-line-style solid 1 0 0 16
    polygon-abs-3 0.2 0.2 0  0.5 0.5 0.3  0.2 0.8 0
    polygon-abs-3 0.2 0.2 0  0.8 0.2 0  0.5 0.5 0.3
    close-segment)");
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::depth_sort, HiddenMethod::none}) {
    EXPECT_EQ(at(draw(g, method), 0.155, 0.155), kRedPixel);
  }
}

/// A side that goes down into a floor ends there, in whichever order the pieces are drawn.
TEST_P(LineEnds, ASideEndsWhereItsPolygonPassesThroughAnother) {
  const GraphicsSystem g = replayed(R"(
    set-window 0 1 0 1
    set-view-depth -1 2
    open-segment 1
    set-line-style none
    set-fill-style solid 1 1 0
    polygon-abs-3 0 0 0.5  1 0 0.5  1 1 0.5  0 1 0.5
    set-line-style solid 1 0 0 16
    polygon-abs-3 0.2 0.3 0  0.8 0.3 1  0.8 0.7 1  0.2 0.7 0
    close-segment)");
  for (const HiddenMethod method :
       {HiddenMethod::map, HiddenMethod::bsp, HiddenMethod::depth_sort}) {
    const Picture p = draw(g, method);
    for (const double y : {0.3, 0.7}) {
      EXPECT_EQ(at(p, 0.515, y), kRedPixel);
      EXPECT_EQ(at(p, 0.485, y), kYellowPixel);
    }
  }
}

TEST_F(TemporaryFolder, BytesOfLinesDependOnNeitherThreadsNorMethods) {
  const GraphicsSystem g = replayed(kBehindAWall);
  std::vector<std::string> drawn;
  for (const HiddenMethod method :
       {HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::franklin}) {
    for (const int threads : {1, 4}) {
      DrawOptions options{.width = 100, .height = 100, .samples = 1};
      options.surfaces.method = method;
      options.surfaces.threads = threads;
      displayfile::draw(g, file("a.svg"), options);
      drawn.push_back(content(file("a.svg")));
    }
  }
  for (const std::string& other : drawn) EXPECT_EQ(other, drawn.front());
}

}  // namespace
}  // namespace displayfile
