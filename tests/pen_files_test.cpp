// Drawings for pens as files: layers, millimetres, pages.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "interp/draw/draw.h"
#include "interp/vector/pdf_layers.h"
#include "interp/vector/pens/pen_drawing.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

Paper sheet(double width, double height, double margin) {
  Paper paper{width, height, margin};
  paper.turned = width > height ? Paper::Turned::landscape : Paper::Turned::portrait;
  return paper;
}

DrawOptions for_pens(const Paper& paper) {
  DrawOptions options;
  options.width = options.height = 100;
  options.vectors.paper = paper;
  options.pens.emplace();
  return options;
}

/// Opened and closed in turn, as in XML.
void expect_well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = text.substr(at + 1, end - at - 1);
    EXPECT_EQ(tag.find('<'), std::string::npos) << tag;
    EXPECT_EQ(std::ranges::count(tag, '"') % 2, 0) << tag;
    if (tag.starts_with('?') || tag.ends_with('/')) continue;
    if (tag.starts_with('/')) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), tag.substr(1));
      open.pop_back();
    } else {
      open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    }
  }
  EXPECT_TRUE(open.empty());
}

class PenFiles : public TemporaryFolder {
 protected:
  std::string svg(const GraphicsSystem& g, const DrawOptions& options) const {
    draw(g, file("a.svg"), options);
    const std::string text = content(file("a.svg"));
    expect_well_formed(text);
    return without_keys(text);
  }
};

/// A layer for each pen, in the order in which they are needed; every side once, where polygons
/// share one too.
TEST_F(PenFiles, SvgHasALayerForEachPen) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_fill_style(solid(kRed));
  g.set_line_style(line(kBlack));
  g.polygon_abs_2({{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}});
  g.polygon_abs_2({{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}});
  g.set_line_style(line(kBlue, 2.0));
  g.move_abs_2(0.1, 0.1);
  g.line_abs_2(0.1, 0.1);  // a dot
  g.move_abs_2(0.25, 0.5);
  g.line_abs_2(0.75, 0.5);
  g.move_abs_2(0.5, 0.5);
  g.line_abs_2(0.9, 0.5);  // lies on it, and continues
  g.close_segment();
  EXPECT_EQ(svg(g, for_pens(sheet(50, 60, 5))), R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1.1" width="50mm" height="60mm" viewBox="0 0 50 60">
<g id="pen-1" inkscape:groupmode="layer" inkscape:label="1 #000000 0.4 mm" fill="none" stroke="#000000" stroke-width="0.4" stroke-linecap="round" stroke-linejoin="round">
<path d="M25 10l20 0 0 40-40 0 0-40 20 0 0 40"/>
</g>
<g id="pen-2" inkscape:groupmode="layer" inkscape:label="2 #0000ff 0.8 mm" fill="none" stroke="#0000ff" stroke-width="0.8" stroke-linecap="round" stroke-linejoin="round">
<path d="M41 30l-26 0"/>
<path d="M9 46l0 0"/>
</g>
</svg>
)");
}

/// A hidden side is not drawn: lines of `auto` are those that are seen.
TEST_F(PenFiles, WhatIsHiddenIsNotDrawn) {
  GraphicsSystem g = unit_square();
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.open_segment(1);
  g.set_line_style(line(kBlack));
  g.polygon_abs_3({{0.2, 0.2, 0.1}, {0.8, 0.2, 0.1}, {0.8, 0.8, 0.1}, {0.2, 0.8, 0.1}});
  g.polygon_abs_3({{0, 0, 0.9}, {1, 0, 0.9}, {1, 1, 0.9}, {0, 1, 0.9}});
  g.close_segment();
  EXPECT_NE(
      svg(g, for_pens(sheet(110, 110, 5))).find("<path d=\"M5 5l0 100 100 0 0-100z\"/>\n</g>"),
      std::string::npos)
      << content(file("a.svg"));
}

TEST_F(PenFiles, DashesAreStrokes) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::dashed, kBlack, 1.0, 30.0, 20.0});
  g.move_abs_2(0, 0.5);
  g.line_abs_2(1, 0.5);
  g.close_segment();
  const std::string text = svg(g, for_pens(sheet(110, 110, 5)));
  EXPECT_NE(text.find("<path d=\"M5 55l30 0\"/>\n<path d=\"M55 55l30 0\"/>\n"), std::string::npos)
      << text;
}

/// Parts outside the picture are not on the paper.
TEST_F(PenFiles, ThePictureEndsAtItsFrame) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.move_abs_2(0, 0.5);
  g.line_abs_2(1, 0.5);
  g.close_segment();
  g.set_image_translation(1, 0.5, 0.0);
  EXPECT_NE(svg(g, for_pens(sheet(110, 110, 5))).find("<path d=\"M55 55l50 0\"/>"),
            std::string::npos)
      << content(file("a.svg"));
  g.set_image_translation(1, 0.0, 2.0);
  EXPECT_EQ(svg(g, for_pens(sheet(110, 110, 5))).find("<g"), std::string::npos);
}

TEST_F(PenFiles, PdfHasThePageOfThePaper) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.move_abs_2(0, 0);
  g.line_abs_2(1, 1);
  g.close_segment();
  draw(g, file("a.pdf"), for_pens(paper_of("A4")));
  EXPECT_NE(content(file("a.pdf")).find("/MediaBox [ 0 0 595.275591 841.889764 ]"),
            std::string::npos);
}

/// As in SVG, in the order that is set.
TEST_F(PenFiles, PdfHasALayerForEachPen) {
  if (!has_pdf_layers()) GTEST_SKIP() << "no QPDF";
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  for (const Colour& colour : {kRed, kBlue, kBlack}) {
    g.set_line_style(line(colour));
    g.move_abs_2(colour.r, 0);
    g.line_abs_2(1, 1);
  }
  g.close_segment();
  DrawOptions options = for_pens(paper_of("A4"));
  options.pens->layers = {kBlue, kRed};
  draw(g, file("a.pdf"), options);
  const std::string pdf = content(file("a.pdf"));
  const std::size_t blue = pdf.find("/Name (1 #0000ff "), red = pdf.find("/Name (2 #ff0000 "),
                    black = pdf.find("/Name (3 #000000 ");
  EXPECT_LT(blue, pdf.size()) << pdf;
  EXPECT_LT(red, pdf.size());
  EXPECT_LT(black, pdf.size());
  EXPECT_NE(pdf.find("/OCProperties"), std::string::npos);
  EXPECT_EQ(pdf.find("StructTreeRoot"), std::string::npos);
  draw(g, file("b.pdf"), options);
  EXPECT_EQ(content(file("b.pdf")), pdf);
}

/// A hatched scene: a square of a middle grey behind a black one.
TEST_F(PenFiles, HatchingIsALayer) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_fill_style(solid(Colour(0.5)));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.set_fill_style(solid(kBlack));
  g.polygon_abs_2({{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}});
  g.close_segment();
  DrawOptions options = for_pens(sheet(110, 110, 5));
  options.surfaces.method = HiddenMethod::none;
  options.pens->hatching = Hatching{1.0, 0.0, false, {}, 0.25};
  const PenDrawing drawing =
      pen_drawing(g.display_file(), 100, 100, *options.vectors.paper, *options.pens);
  ASSERT_EQ(drawing.layers.size(), 1u);
  EXPECT_EQ(drawing.layers[0].pen, (Pen{0xff000000u, 250}));
  double length = 0.0;
  for (const PenPath& path : drawing.layers[0].paths) length += length_of(path);
  EXPECT_NEAR(length, 1000.0 * (50 * 100 + 50 * 50), 1e-3);
  EXPECT_NE(svg(g, options).find("inkscape:label=\"1 #000000 0.25 mm\""), std::string::npos);
  options.pens->hatching->cross = true;  // black twice as dense as the middle tone
  const PenDrawing crossed =
      pen_drawing(g.display_file(), 100, 100, *options.vectors.paper, *options.pens);
  length = 0.0;
  for (const PenPath& path : crossed.layers[0].paths) length += length_of(path);
  EXPECT_NEAR(length, 1000.0 * (100 * 100 + 50 * 100), 1e-3);
}

/// Without pens a picture on paper is the same as without paper.
TEST_F(PenFiles, AnyVectorsMayBeOnPaper) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.set_fill_style(solid(kRed));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  DrawOptions options;
  options.width = options.height = 100;
  draw(g, file("plain.svg"), options);
  options.vectors.paper = sheet(110, 120, 5);
  const std::string plain = without_keys(content(file("plain.svg")));
  const std::size_t end_of_head = plain.find("<svg");
  EXPECT_EQ(svg(g, options),
            plain.substr(0, end_of_head) +
                "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"110mm\" "
                "height=\"120mm\" viewBox=\"0 0 110 120\">\n"
                "<g transform=\"translate(5 10) scale(1)\">\n" +
                plain.substr(end_of_head) + "</g>\n</svg>\n");
  draw(g, file("a.pdf"), options);
  EXPECT_NE(content(file("a.pdf")).find("/MediaBox [ 0 0 311.811024 340.15748 ]"),
            std::string::npos);
}

TEST_F(PenFiles, AreRefusedWhereTheyMeanNothing) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});
  g.close_segment();
  DrawOptions options = for_pens({});
  expect_error([&] { draw(g, file("a.png"), options); }, ".png files are not for pens");
  for (const HiddenMethod method : {HiddenMethod::bsp, HiddenMethod::depth_sort,
                                    HiddenMethod::z_buffer, HiddenMethod::colour_rule}) {
    options.surfaces.method = method;
    expect_error([&] { draw(g, file("a.svg"), options); }, "by painting over");
  }
  options.surfaces.method = HiddenMethod::franklin;
  options.pens->hatching.emplace();
  expect_error([&] { draw(g, file("a.svg"), options); }, "draws no fills to be hatched");
  options.pens->hatching->spacing = 0.0;
  expect_error([&] { draw(g, file("a.svg"), options); }, "hatching 0 mm apart");
  options.pens.reset();
  options.surfaces.method.reset();
  expect_error([&] { draw(g, file("a.png"), options); }, ".png files have no size on paper");
  options.vectors.paper->margin = 200.0;
  expect_error([&] { draw(g, file("a.svg"), options); }, "margins of 200 mm");
  EXPECT_TRUE(empty_folder());
}

}  // namespace
}  // namespace displayfile
