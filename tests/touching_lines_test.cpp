// Lines that lie in faces: sides that stand on a face, and lines that were entered in one. They are
// whole, whatever viewing rounds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/drawn_pieces.h"
#include "displayfile/sorted_display_file.h"
#include "displayfile/text/drawing_program.h"
#include "interp/draw.h"
#include "interp/truth/judged_lines.h"
#include "tests/from_environment.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::from_environment;
using test::Source;

constexpr HiddenMethod kMethodsOfLines[] = {HiddenMethod::franklin, HiddenMethod::roberts,
                                            HiddenMethod::appel};

std::vector<std::int32_t> ids_of(const GraphicsSystem& g) {
  DrawOptions options;
  options.width = options.height = 48;
  options.hidden = HiddenMethod::z_buffer;
  options.with_ids = true;
  return draw(g, options).ids;
}

/// The length of the visible lines, in units of the picture; of those of one colour alone, if it is
/// given, and not those of polygon 0 unless they are.
double length_of(const GraphicsSystem& g, HiddenMethod method,
                 const std::optional<Colour>& colour = std::nullopt) {
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = method;
  const DrawnPieces pieces = drawn_pieces(sorted.update(g, method, options));
  double length = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces.kinds[k] != DrawnPieces::Kind::line) continue;
    if (colour ? pieces.line_colours[k] != *colour : pieces.picks[k] == 0) continue;
    length += glm::distance(Point2(pieces.points[pieces.first[k]]),
                            Point2(pieces.points[pieces.first[k] + 1]));
  }
  return length;
}

/// Its lower sides lie in the face that it stands on; the face below, which has them too, is turned
/// away and removed.
TEST(TouchingLines, ABoxOnABoxHasAllItsSides) {
  GraphicsSystem g;
  replay(
      "set-view-plane-normal -1 2 -1.3\n"
      "set-view-up 0 0 1\n"
      "set-parallel 1 -2 1.3\n"
      "set-window -4 4 -4 4\n"
      "set-hidden-line-removal on\n"
      "open-segment 1\n"
      "set-fill-style solid 1 1 1\n"
      "set-line-style solid 0 0 0 1\n"
      "box-3 -2 2 -2 2 0 1\n"
      "set-line-style solid 1 0 0 1\n"
      "box-3 -1 1 -1 1 1 2\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method : kMethodsOfLines) {
    EXPECT_NEAR(400.0 * length_of(g, method, Colour{1, 0, 0}), 596.58, 0.01) << name_of(method);
  }
}

/// With the faces that are turned away removed as much is seen of the boxes as with them, but for
/// sides of two of these, which are seen in few views.
TEST(TouchingLines, BoxesOnAFloorHaveAllTheirSides) {
  int compared = 0, different = 0;
  const int views = from_environment("DISPLAYFILE_TOUCHING_VIEWS", 60 / test::kSlower);
  for (int seed = 0; seed < views; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto entered = [&](bool removed) {
      GraphicsSystem g;
      Source s(static_cast<std::uint64_t>(seed));
      test::view_from_anywhere(s, g, {Point3(0.0), 3.0});
      if (s.below(2) == 0) test::turn_and_move(s, g);
      g.set_back_face_removal(removed);
      g.open_segment(1);
      test::enter_boxes_on_floor(s, g);
      g.close_segment();
      return g;
    };
    const GraphicsSystem g = entered(true);
    const double expected = length_of(entered(false), HiddenMethod::franklin);
    if (ids_of(g) != ids_of(entered(false)))
      continue;  // the eye is in a box, or sees the floor from below
    ++compared;
    if (std::abs(length_of(g, HiddenMethod::franklin) - expected) > 1e-9) ++different;
    for (const HiddenMethod method : kMethodsOfLines) {
      EXPECT_TRUE(judged_lines(g.display_file(), {.method = method}).are_right())
          << name_of(method);
    }
  }
  EXPECT_LE(50 * different, compared);
  EXPECT_GT(10 * compared, 3 * views);
}

/// Lines that are entered in a wall, in decimals on a slope and under a modelling transformation.
TEST(TouchingLines, LinesInAFaceAreWhole) {
  const int views = from_environment("DISPLAYFILE_TOUCHING_VIEWS", 60 / test::kSlower);
  for (int seed = 0; seed < views; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto entered = [&](bool with_face) {
      GraphicsSystem g;
      Source s(static_cast<std::uint64_t>(seed));
      test::view_from_anywhere(s, g, {Point3(0.0), 3.0});
      if (s.below(2) == 0) test::turn_and_move(s, g);
      g.set_line_style({LineStyle::Kind::none});
      g.open_segment(1);
      const double rise = test::decimal(s, 0.3, 1.2), foot = test::decimal(s, -1, 0);
      const auto on_roof = [&](double x, double z) { return Point3(x, foot + rise * z, z); };
      if (with_face) {
        g.polygon_abs_3({on_roof(-2, -1.7), on_roof(2, -1.7), on_roof(2, 1.7), on_roof(-2, 1.7)});
      }
      g.set_line_style({LineStyle::Kind::solid});
      for (int line = 0; line < 6; ++line) {
        const Point3 from = on_roof(test::decimal(s, -2, 2), test::decimal(s, -1.7, 1.7));
        const Point3 to = on_roof(test::decimal(s, -2, 2), test::decimal(s, -1.7, 1.7));
        g.move_abs_3(from.x, from.y, from.z);
        g.line_abs_3(to.x, to.y, to.z);
      }
      g.close_segment();
      return g;
    };
    const GraphicsSystem g = entered(true);
    const double expected = length_of(entered(false), HiddenMethod::franklin);
    for (const HiddenMethod method : kMethodsOfLines) {
      EXPECT_NEAR(length_of(g, method), expected, 1e-9) << name_of(method);
      EXPECT_TRUE(judged_lines(g.display_file(), {.method = method}).are_right())
          << name_of(method);
    }
  }
}

/// What was entered far away makes no line that is well behind a wall one that lies in it.
TEST(TouchingLines, WellBehindAreHiddenWhateverIsFarAway) {
  for (const double far : {0.0, 1e9, 1e60}) {
    GraphicsSystem g;
    g.set_window(0, 1, 0, 1);
    g.set_view_depth(-1, 0);
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
    g.polygon_abs_3({{far, 2, 0.5}, {far, 3, 0.5}, {far + 1, 3, 0.5}});
    g.set_line_style({LineStyle::Kind::solid});
    g.move_abs_3(0.25, 0.25, 0.375);
    g.line_abs_3(0.75, 0.25, 0.375);
    g.close_segment();
    for (const HiddenMethod method : kMethodsOfLines) {
      EXPECT_EQ(length_of(g, method), 0.0) << name_of(method) << ", " << far;
    }
  }
}

/// A ROUNDOFF lets through what rounding makes of touching lines, but no strokes without length, of
/// which a pen makes dots.
TEST(TouchingLines, WithARoundoffNoStrokeIsADot) {
  const double roundoff = 1e-9;
  std::size_t strokes = 0;
  for (int seed = 0; seed < 80; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    GraphicsSystem g;
    test::view_from_anywhere(s, g, {Point3(0.0), 3.0});
    if (seed % 2 == 1) test::turn_and_move(s, g);
    g.open_segment(1);
    test::enter_boxes_on_floor(s, g);
    g.close_segment();
    for (const HiddenMethod method : kMethodsOfLines) {
      for (const HiddenLines hidden : {HiddenLines::none, HiddenLines::dashed}) {
        SortedDisplayFile sorted;
        HiddenSurfaceOptions options;
        options.method = method;
        options.precision = {.exact = false, .roundoff = roundoff};
        options.hidden_lines = hidden;
        const DrawnPieces pieces = drawn_pieces(sorted.update(g, method, options));
        for (std::size_t k = 0; k < pieces.size(); ++k) {
          if (pieces.kinds[k] != DrawnPieces::Kind::line) continue;
          ++strokes;
          EXPECT_GT(glm::distance(Point2(pieces.points[pieces.first[k]]),
                                  Point2(pieces.points[pieces.first[k] + 1])),
                    0.1 * roundoff)
              << name_of(method) << ", seed " << seed;
        }
      }
    }
  }
  EXPECT_GT(strokes, 1000u);
}

/// Where nothing touches, a line behind a face by as little is hidden.
TEST(TouchingLines, AreComparedAsViewedWhereNothingTouches) {
  for (const bool touches : {true, false}) {
    GraphicsSystem g;
    g.set_window(0, 1, 0, 1);
    g.set_view_depth(-1, 0);
    if (!touches) g.set_touching({Touching::Kind::off});
    g.set_line_style({LineStyle::Kind::none});
    g.open_segment(1);
    g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
    g.set_line_style({LineStyle::Kind::solid});
    g.move_abs_3(0.25, 0.25, std::nextafter(0.5, 0.0));
    g.line_abs_3(0.75, 0.25, std::nextafter(0.5, 0.0));
    g.move_abs_3(0.25, 0.75, 0.5 - 1e-9);
    g.line_abs_3(0.75, 0.75, 0.5 - 1e-9);
    g.close_segment();
    for (const HiddenMethod method : kMethodsOfLines) {
      EXPECT_EQ(length_of(g, method), touches ? 0.5 : 0.0) << name_of(method);
    }
  }
}

}  // namespace
}  // namespace displayfile
