// Lines as pictures have them (hidden/lines/strokes_once.md): each place once, and no crumbs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/draw/draw.h"

namespace displayfile {
namespace {

/// The strokes that a walk passes on: their number, and their length in device coordinates.
struct Lines {
  double length = 0.0;
  std::size_t strokes = 0;
  Point3 pen{0.0};

  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(std::int32_t) {}
  void move(const Point3& p) { pen = p; }
  void line(const Point3& p) {
    length += std::hypot(p.x - pen.x, p.y - pen.y);
    ++strokes;
    pen = p;
  }
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}
};

/// The same for a picture, whose walk leaves out lines that do not change it: every line once, none
/// a crumb.
struct LinesOfPicture : Lines {
  bool is_crumb(const Point3&, const Point3&) const { return false; }
};

template <class Visitor>
Visitor walked(const GraphicsSystem& g, HiddenMethod method) {
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = method;
  Visitor lines;
  sorted.update(g, method, options).sorted()->walk(lines);
  return lines;
}

LinesOfPicture lines_of(const GraphicsSystem& g, HiddenMethod method) {
  return walked<LinesOfPicture>(g, method);
}

double length_of_dump(const GraphicsSystem& g, HiddenMethod method) {
  return walked<Lines>(g, method).length;
}

constexpr std::array kLineMethods{HiddenMethod::franklin, HiddenMethod::roberts,
                                  HiddenMethod::appel};

/// An upright slab from above: each side of its top has one of its bottom right below it. A dump
/// has both, a picture one.
TEST(DrawnLines, ThatLieOnEachOtherAreDrawnOnce) {
  GraphicsSystem g;
  replay(
      "set-view-plane-normal 0 -1 0\n"
      "set-view-up 0 0 -1\n"
      "set-parallel 0 1 0\n"
      "set-window -5 5 -5 5\n"
      "set-view-depth -20 20\n"
      "open-segment 1\n"
      "box-3 -4 4 0 10 -0.5 0.5\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method : kLineMethods) {
    SCOPED_TRACE(name_of(method));
    const LinesOfPicture lines = lines_of(g, method);
    EXPECT_NEAR(lines.length, 1.8, 1e-12);
    EXPECT_EQ(lines.strokes, 4u);
    EXPECT_NEAR(length_of_dump(g, method), 3.6, 1e-12);
  }
}

std::size_t dark_pixels(const Picture& picture, int first_column, int end_column, int first_row,
                        int end_row) {
  std::size_t dark = 0;
  for (int row = first_row; row < end_row; ++row) {
    for (int column = first_column; column < end_column; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                      static_cast<std::size_t>(column);
      if ((picture.pixels[at] & 0xffu) < 128) ++dark;
    }
  }
  return dark;
}

/// A line behind a surface of three rectangles, where the corner of two lies along the third's
/// side.
TEST(DrawnLines, NothingIsSeenThroughASeam) {
  GraphicsSystem g;
  replay(
      "set-view-reference-point 2 1 1\n"
      "set-view-plane-normal 1.201116 1.282492 -1.466972\n"
      "set-parallel -1.201116 -1.282492 1.466972\n"
      "set-window -3 3 -3 3\n"
      "set-hidden-line-removal on\n"
      "set-back-face-removal off\n"
      "open-segment 1\n"
      "set-line-style none\n"
      "set-fill-style solid 1 1 1\n"
      "polygon-abs-3 0 1 1  4 1 1  4 2 1  0 2 1\n"
      "polygon-abs-3 0 0 1  2 0 1  2 1 1  0 1 1\n"
      "polygon-abs-3 2 0 1  4 0 1  4 1 1  2 1 1\n"
      "set-line-style solid 0 0 0 1\n"
      "move-abs-3 0.819741 0.5 0.9\n"
      "line-abs-3 0.819741 1.5 0.9\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method :
       {HiddenMethod::franklin, HiddenMethod::roberts, HiddenMethod::appel, HiddenMethod::z_buffer,
        HiddenMethod::bsp, HiddenMethod::map}) {
    DrawOptions options;
    options.samples = 1;
    options.width = options.height = 300;
    options.surfaces.method = method;
    EXPECT_EQ(dark_pixels(draw(g, options), 0, 300, 0, 300), 0u) << name_of(method);
  }
}

/// A side of the pocket and one below it, which are one line up to rounding: dashes, and gaps.
TEST(DrawnLines, HiddenOnesOnEachOtherAreDashedOnce) {
  GraphicsSystem g;
  replay(
      "set-view-plane-normal 1.7e-16 -1.7e-16 -1\n"
      "set-parallel -1.7e-16 1.7e-16 1\n"
      "set-window -1 21 -1 13\n"
      "set-view-depth -60 60\n"
      "set-hidden-method franklin\n"
      "set-hidden-line-removal on\n"
      "set-back-face-removal off\n"
      "set-hidden-lines dashed\n"
      "set-lines outline crease\n"
      "set-line-style solid 0 0 0 1\n"
      "open-segment 1\n"
      "begin-solid difference\n"
      "box-3 0 20 0 12 0 10\n"
      "box-3 5 15 4 8 -1 5\n"
      "end-solid\n"
      "close-segment\n",
      "test", g);
  DrawOptions options;
  options.samples = 1;
  options.width = 440;
  options.height = 280;
  EXPECT_EQ(dark_pixels(draw(g, options), 120, 121, 105, 175), 42u);
}

/// A line that is shorter than it is wide, and one of which only such a piece is left.
TEST(DrawnLines, CrumbsAreLeftOut) {
  const auto dark = [](const char* lines, bool crumbs) {
    GraphicsSystem g;
    g.set_window(0, 1, 0, 1);
    const std::string program =
        "set-hidden-line-removal on\n"
        "open-segment 1\n"
        "set-line-style none\n"
        "set-fill-style solid 1 1 1\n"
        "polygon-abs-3 0.1 0.1 0.5  0.5 0.1 0.5  0.5 0.9 0.5  0.1 0.9 0.5\n"
        "polygon-abs-3 0.503 0.1 0.5  0.9 0.1 0.5  0.9 0.9 0.5  0.503 0.9 0.5\n"
        "set-line-style solid 0 0 0 1\n";
    replay(program + lines + "close-segment\n", "test", g);
    std::size_t most = 0;
    for (const HiddenMethod method : {HiddenMethod::franklin, HiddenMethod::z_buffer}) {
      DrawOptions options;
      options.samples = 1;
      options.width = options.height = 100;
      options.surfaces.method = method;
      options.crumbs = crumbs;
      most = std::max(most, dark_pixels(draw(g, options), 0, 100, 0, 100));
    }
    return most;
  };
  const char* const between = "move-abs-3 0.2 0.5 0\nline-abs-3 0.8 0.5 0\n";
  EXPECT_EQ(dark(between, false), 0u);
  EXPECT_GT(dark(between, true), 0u);
  const char* const short_one = "move-abs-3 0.3 0.5 0.7\nline-abs-3 0.304 0.5 0.7\n";
  EXPECT_GT(dark(short_one, false), 0u) << "as it was entered";
}

}  // namespace
}  // namespace displayfile
