// The contents of SVG and PDF files.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "interp/device/interpreter.h"
#include "interp/draw/draw.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;
using namespace test;

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

class VectorFile : public TemporaryFolder {
 protected:
  std::string svg(const GraphicsSystem& g, int width, int height, bool by_map = false) const {
    DrawOptions options;
    options.width = width;
    options.height = height;
    if (by_map) options.surfaces.method = HiddenMethod::map;
    draw(g, file("a.svg"), options);
    return without_keys(content(file("a.svg")));
  }
};

std::string body(const std::string& svg) { return svg.substr(svg.find("<rect")); }

/// Where depths decide, dashes are cut here: a dash that continues in the next line is still one
/// path.
TEST_F(VectorFile, ADashGoesOnInTheLineThatContinuesItsOwn) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::dashed, kBlue, 1.0, 1000.0, 1.0});
  g.move_abs_2(0.05, 0.5);
  for (int k = 1; k <= 60; ++k) g.line_abs_2(0.05 + 0.015 * k, 0.5 + 0.1 * (k % 3) / 7.0);
  g.close_segment();
  EXPECT_EQ(count(svg(g, 90, 60, true), "<path"), 1u);
}

/// Lines that come back to where they began are a closed path, whose last corner is joined.
TEST_F(VectorFile, ALoopOfLinesIsAClosedPath) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_line_style(line(kBlue, 3.0));
  g.move_abs_2(0.25, 0.25);
  g.line_abs_2(0.75, 0.25);
  g.line_abs_2(0.5, 0.75);
  g.line_abs_2(0.25, 0.25);
  g.move_abs_2(0.0, 0.0);  // there and back: open
  g.line_abs_2(0.25, 0.0);
  g.line_abs_2(0.0, 0.0);
  g.close_segment();
  const std::string drawn = svg(g, 40, 40, false);
  EXPECT_EQ(count(drawn, "d=\"M10 30l20 0-10-20Z\""), 1u) << drawn;
  EXPECT_EQ(count(drawn, "d=\"M0 40l10 0-10 0\""), 1u) << drawn;
}

/// The line drawing of a hidden edge may stick out at a corner of the outline by its rounding.
TEST(SvgDevice, ALineOfNoMoreThanRoundingIsNotDrawn) {
  using Counts = std::array<std::size_t, 3>;  // of paths, of dots, of closed paths
  const auto drawn = [](const std::vector<Point3>& points) {
    SvgDevice device(100, 100);
    device.begin_segment(1);
    for (std::size_t k = 1; k < points.size(); ++k) {
      device.line({points[k - 1], points[k], {LineStyle::Kind::solid, Colour(0.0), 14.0}});
    }
    device.end_segment();
    std::ostringstream out;
    device.finish(out);
    const std::string svg = std::move(out).str();
    EXPECT_EQ(count(svg, "l0 0"), count(svg, "square"));
    return Counts{count(svg, "<path"), count(svg, "square"), count(svg, "Z\"")};
  };
  const Point3 a(0.25, 0.25, 0), b(0.75, 0.25, 0), c(0.25, 0.75, 0),
      beside_a(0.25, 0.25 + 1e-15, 0);
  EXPECT_EQ(drawn({a, beside_a}), (Counts{0, 0, 0}));
  EXPECT_EQ(drawn({a, a}), (Counts{1, 1, 0}));
  EXPECT_EQ(drawn({b, a, beside_a, c}), (Counts{1, 0, 0}));
  EXPECT_EQ(drawn({beside_a, a, b, c, a}), (Counts{1, 0, 1}));
  EXPECT_EQ(drawn({a, b, c, a, beside_a}), (Counts{1, 0, 1}));
}

/// However many of them there are.
TEST(SvgDevice, ShortLinesThatContinueEachOtherAreDrawn) {
  SvgDevice device(100, 100);
  device.begin_segment(1);
  const LineStyle style{LineStyle::Kind::solid, Colour(0.0), 1.0};
  const auto at = [](int k) { return Point3(0.25 + 1e-9 * k, 0.5, 0.0); };
  device.line({{0.0, 0.5, 0.0}, at(0), style});
  for (int k = 0; k < 1000; ++k) device.line({at(k), at(k + 1), style});
  device.end_segment();
  std::ostringstream out;
  device.finish(out);
  EXPECT_NE(out.str().find("M0 50l25"), std::string::npos) << out.str();
  EXPECT_EQ(count(out.str(), "<path"), 1u);
}

TEST_F(VectorFile, SvgOfASmallScene) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(3);
  g.set_fill_style(solid({1.0, 0.5, 0.0}));
  g.set_line_style(line(kBlack, 1.5));
  g.polygon_abs_2({{0.1, 0.1}, {0.5, 0.1}, {0.5, 0.5}, {0.1, 0.5}});  // with its edges
  g.set_line_style(kNoLine);
  g.polygon_abs_2({{0.1, 0.6}, {0.5, 0.6}, {1.0 / 3.0, 0.9}});  // without: seams are closed
  g.close_segment();
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::dashed, kBlue, 2.0, 6.0, 4.0});
  g.move_abs_2(0.0, 0.25);
  g.line_abs_2(1.0, 0.25);
  g.line_abs_2(1.0, 1.0);  // continues the line: one path
  g.move_abs_2(0.5, 0.5);
  g.line_abs_2(0.5, 0.5);  // a dot
  g.close_segment();
  EXPECT_EQ(svg(g, 200, 100, false),
            R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="200" height="100" viewBox="0 0 200 100">
<style>
.background{fill:#ffffff}
.segment{fill:none;fill-rule:evenodd;stroke-width:0.75;stroke-linejoin:round}
.f1{fill:#ff8000}
.f2{fill:#ff8000;stroke:#ff8000}
.l1{stroke:#000000;stroke-width:1.5;stroke-linecap:round}
.l2{stroke:#0000ff;stroke-width:2;stroke-dasharray:6 4}
</style>
<rect class="background" width="200" height="100"/>
<g id="segment-3" class="segment">
<path class="f1 l1" d="M20 50l0 40 80 0 0-40Z"/>
<path class="f2" d="M66.667 10l-46.667 30 80 0Z"/>
</g>
<g id="segment-1" class="segment">
<path class="l2" d="M0 75l200 0 0-75"/>
<path class="l2" stroke-linecap="square" d="M100 50l0 0"/>
</g>
</svg>
)");
}

TEST_F(VectorFile, NothingAndInvisibleSegmentsMakeAnEmptyPicture) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  g.set_visibility(1, false);
  for (const bool by_map : {false, true}) {
    EXPECT_EQ(body(svg(g, 10, 10, by_map)),
              "<rect class=\"background\" width=\"10\" height=\"10\"/>\n</svg>\n");
  }
}

TEST(SvgDevice, AGroupOpenedAgainHasAnIdOfItsOwn) {
  SvgDevice device(10, 10);
  for (const int name : {1, 12, 1, 1}) {
    device.begin_segment(name);
    device.end_segment();
  }
  std::ostringstream out;
  device.finish(out);
  for (const char* id : {"\"segment-1\"", "\"segment-12\"", "\"segment-1-2\"", "\"segment-1-3\""}) {
    EXPECT_EQ(count(without_keys(out.str()), id), 1u) << id;
  }
}

/// Draws one polygon on an SVG device of 100 x 100.
std::string svg_of(const std::vector<Point3>& vertices, const std::vector<std::int32_t>& sides,
                   const LineStyle& style = line(kBlack)) {
  SvgDevice device(100, 100);
  const FillStyle fill = solid(kRed);
  const DrawnPolygon polygon{vertices, sides, fill, style, 0};
  device.begin_segment(1);
  device.fill(polygon);
  device.edges(polygon);
  device.end_segment();
  std::ostringstream out;
  device.finish(out);
  return body(without_keys(out.str()));
}

const std::vector<Point3> kSquare{{.2, .2, 0}, {.8, .2, 0}, {.8, .8, 0}, {.2, .8, 0}};

TEST(SvgDevice, OnlyVisibleSidesAreDrawn) {
  // The sides that end at the second and the fourth vertex.
  const std::string svg = svg_of(kSquare, {op::move, op::line, op::move, op::line});
  EXPECT_EQ(count(svg, "class=\"l1\" d=\"M20 80l60 0M80 20l-60 0\""), 1u) << svg;
  // A run continues over the polygon's first vertex.
  const std::string three = svg_of(kSquare, {op::line, op::line, op::move, op::line});
  EXPECT_EQ(count(three, "class=\"l1\" d=\"M80 20l-60 0 0 60 60 0\""), 1u) << three;
  EXPECT_EQ(count(svg_of(kSquare, {op::move, op::move, op::move, op::move}), "<path"), 1u);
}

TEST(SvgDevice, SeamsAreClosedWhereEdgesDoNotCoverThem) {
  const std::vector<std::int32_t> all(4, op::line);
  SvgDevice device(10, 10);
  const auto style_of_fill = [&](const LineStyle& style, const std::vector<std::int32_t>& sides) {
    SvgDevice one(100, 100);
    const FillStyle fill = solid(kRed);
    one.fill({kSquare, sides, fill, style, 0});
    std::ostringstream out;
    one.finish(out);
    return count(without_keys(out.str()), ".f1{fill:#ff0000;stroke:#ff0000}");
  };
  EXPECT_EQ(style_of_fill(line(kBlack), all), 0u);
  EXPECT_EQ(style_of_fill(line(kBlack), {op::line, op::move, op::line, op::line}), 1u);
  EXPECT_EQ(style_of_fill(line(kBlack, 0.1), all), 1u);
  EXPECT_EQ(style_of_fill({LineStyle::Kind::dashed}, all), 1u);
  EXPECT_EQ(style_of_fill(kNoLine, all), 1u);
}

TEST(SvgDevice, EdgeOnAndNotFinitePolygonsAreLeftOut) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::int32_t> none(3, op::move);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {.5, .5, 1}, {.9, .9, 0}}, none), "<path"), 0u);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {infinity, .5, 1}, {.9, .9, 0}}, none), "<path"), 0u);
  EXPECT_EQ(count(svg_of({{.1, .1, 0}, {.5, std::nan(""), 1}, {.9, .1, 0}},
                         std::vector<std::int32_t>(3, op::line)),
                  "nan"),
            0u);
}

TEST_F(VectorFile, FarCoordinatesAreCutOffOutsideOfThePicture) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_line_style(line(kBlack));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.move_abs_2(0, 0);
  g.line_abs_2(1, 1);
  g.close_segment();
  g.set_image_scale(1, 1e90, 1e90);
  const std::string text = body(svg(g, 100, 100));
  EXPECT_GE(count(text, "class=\"l1\""), 1u);
  EXPECT_EQ(count(text, "class=\"f1\""), 1u);
  std::istringstream numbers(text);
  for (char c; numbers.get(c);) {
    if (c < '0' || c > '9') continue;
    numbers.unget();
    double v = 0.0;
    numbers >> v;
    ASSERT_LE(v, 32767.0) << text;
  }
}

TEST_F(VectorFile, BadSizesAndPathsAreErrorsAndLeaveNothing) {
  GraphicsSystem g = unit_square_without_lines();
  const DisplayFile& d = g.display_file();
  for (const auto& size : {std::pair{0, 0}, {0, 5}, {5, -1}, {70000, 5}, {5, 1000000}}) {
    const int w = size.first, h = size.second;
    EXPECT_FALSE(error_of([&] { write_svg(d, w, h, file("a.svg")); }).empty());
    EXPECT_FALSE(error_of([&] { write_pdf(d, w, h, file("a.pdf")); }).empty());
  }
  const fs::path nowhere = file("no-such-folder") / "a";
  EXPECT_NE(error_of([&] { write_svg(d, 9, 9, nowhere); }).find(nowhere), std::string::npos);
  EXPECT_NE(error_of([&] { write_pdf(d, 9, 9, nowhere); }).find(nowhere), std::string::npos);
  EXPECT_TRUE(empty_folder());
}

TEST_F(VectorFile, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  GraphicsSystem g = unit_square_without_lines();
  EXPECT_NE(error_of([&] { write_svg(g.display_file(), 9, 9, "/dev/full"); }), "");
  EXPECT_NE(error_of([&] { write_pdf(g.display_file(), 9, 9, "/dev/full"); }), "");
}

TEST_F(VectorFile, PdfBytesDependOnTheDrawingAlone) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  write_pdf(g.display_file(), 300, 200, file("a.pdf"));
  const std::string pdf = content(file("a.pdf"));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(count(pdf, "/CreationDate (20000101"), 1u);
  EXPECT_EQ(count(pdf, "/MediaBox [ 0 0 300 200 ]"), 1u);
  write_pdf(g.display_file(), 300, 200, file("b.pdf"));
  EXPECT_EQ(content(file("b.pdf")), pdf);
}

}  // namespace
}  // namespace displayfile
