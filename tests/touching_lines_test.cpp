// Lines that lie in faces: sides that stand on a face, and lines that were entered in one. They are
// drawn whole, whatever viewing rounds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/intersection_lines.h"
#include "interp/device/output_device.h"
#include "interp/draw/draw.h"
#include "interp/truth/judged_lines.h"
#include "tests/from_environment.h"
#include "tests/length_of_lines.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::expect_length;
using test::from_environment;
using test::kMethodsOfLines;
using test::length_of;
using test::Source;

std::vector<std::int32_t> ids_of(const GraphicsSystem& g) {
  DrawOptions options{.samples = 1};
  options.width = options.height = 48;
  options.surfaces.method = HiddenMethod::z_buffer;
  options.with_ids = true;
  return draw(g, options).ids;
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

// Lengths are those of tests/touching/line_oracle.py.

TEST(TouchingLines, ABoxOnAFloorHasItsThreeLowerSides) {
  expect_length(
      "set-view-reference-point 0 0 0.5\n"
      "set-view-plane-normal 3.84881418275641 -1.2161918460103505 -3.4738652720460284\n"
      "set-view-up 0 0 1\n"
      "set-perspective -3.84881418275641 1.2161918460103505 3.9738652720460284\n"
      "set-view-depth -4.260346137901296 8\n"
      "set-window -2.4 2.4 -2.4 2.4\n"
      "set-hidden-line-removal on\n"
      "set-line-style solid 0 0 0\n"
      "open-segment 1\n"
      "set-fill-style solid .8 .75 .6\n"
      "polygon-abs-3 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n"
      "set-fill-style solid .5 .6 .8\n"
      "box-3 -0.6 0.8 -0.9 0.5 0 1\n"
      "close-segment\n",
      {0, 0, 0}, 3.941842708979628);
}
TEST(TouchingLines, AWindowFlushInAWallHasItsFrameAndPanes) {
  expect_length(
      "set-view-reference-point 0 0 0.5\n"
      "set-view-plane-normal 1.7093433872424135 3.663905814532202 -4.738333200117385\n"
      "set-view-up 0 0 1\n"
      "set-perspective -1.7093433872424135 -3.663905814532202 5.238333200117385\n"
      "set-view-depth -4.983034394333278 8\n"
      "set-window -2.4 2.4 -2.4 2.4\n"
      "set-hidden-line-removal on\n"
      "set-line-style solid 0 0 0\n"
      "open-segment 1\n"
      "set-fill-style solid .85 .8 .7\n"
      "polygon-abs-3 -2.0 0 -1.0 2.0 0 -1.0 2.0 0 2.0 -2.0 0 2.0\n"
      "set-fill-style solid .4 .25 .1\n"
      "polygon-abs-3 -0.8 0 -0.3 0.8 0 -0.3 0.8 0 1.2 -0.8 0 1.2\n"
      "set-fill-style solid .6 .8 .95\n"
      "polygon-abs-3 -0.7 0 -0.2 -0.05 0 -0.2 -0.05 0 1.1 -0.7 0 1.1\n"
      "polygon-abs-3 0.05 0 -0.2 0.7 0 -0.2 0.7 0 1.1 0.05 0 1.1\n"
      "close-segment\n",
      {0, 0, 0}, 4.754096349108592);
}
TEST(TouchingLines, TheFeetOfATableInARoomAreClosed) {
  expect_length(
      "set-view-reference-point 0 0.6 0\n"
      "set-view-plane-normal -2.5 -4.4 -3.5\n"
      "set-perspective 2.5 5 3.5\n"
      "set-view-depth -5 8\n"
      "set-window -1.7 1.7 -1.5 1.9\n"
      "set-light 2 4 3 0.35\n"
      "set-hidden-line-removal on\n"
      "set-line-style solid 0.1 0.1 0.1 0.8\n"
      "open-segment 1\n"
      "set-fill-style solid 0.85 0.8 0.7\n"
      "polygon-abs-3 -1.5 0 1.5 1.5 0 1.5 1.5 0 -1.5 -1.5 0 -1.5\n"
      "set-fill-style solid 0.8 0.85 0.9\n"
      "polygon-abs-3 -1.5 0 -1.5 1.5 0 -1.5 1.5 2 -1.5 -1.5 2 -1.5\n"
      "set-fill-style solid 0.75 0.82 0.75\n"
      "polygon-abs-3 -1.5 0 1.5 -1.5 0 -1.5 -1.5 2 -1.5 -1.5 2 1.5\n"
      "close-segment\n"
      "open-segment 2\n"
      "set-fill-style solid 0.6 0.4 0.25\n"
      "box-3 -0.8 0.8 0.7 0.78 -0.5 0.5\n"
      "box-3 -0.75 -0.67 0 0.7 -0.45 -0.37\n"
      "box-3 0.67 0.75 0 0.7 -0.45 -0.37\n"
      "box-3 -0.75 -0.67 0 0.7 0.37 0.45\n"
      "box-3 0.67 0.75 0 0.7 0.37 0.45\n"
      "close-segment\n"
      "open-segment 3\n"
      "create-transformation-3\n"
      "translate-3 0 1 0\n"
      "set-fill-style solid 0.9 0.3 0.3\n"
      "polygon-abs-3 -0.5 -0.1 0.25 0.5 0.1 0.25 0.5 0.1 0.1 -0.5 -0.1 0.1\n"
      "create-transformation-3\n"
      "rotate-y-3 120\n"
      "translate-3 0 1 0\n"
      "set-fill-style solid 0.3 0.7 0.3\n"
      "polygon-abs-3 -0.5 -0.1 0.25 0.5 0.1 0.25 0.5 0.1 0.1 -0.5 -0.1 0.1\n"
      "create-transformation-3\n"
      "rotate-y-3 240\n"
      "translate-3 0 1 0\n"
      "set-fill-style solid 0.3 0.4 0.9\n"
      "polygon-abs-3 -0.5 -0.1 0.25 0.5 0.1 0.25 0.5 0.1 0.1 -0.5 -0.1 0.1\n"
      "close-segment\n",
      {0.1, 0.1, 0.1}, 7.442114892993217);
}

/// A wall that stands on a floor does not pass through it, whatever viewing makes of its foot.
TEST(TouchingLines, NoIntersectionWherePolygonsTouch) {
  for (int degrees = 0; degrees < 90; ++degrees) {
    GraphicsSystem g;
    g.set_view_plane_normal({-1, -2, -2});
    g.set_parallel({1, 2, 2});
    g.rotate_x_3(degrees);
    g.open_segment(1);
    g.polygon_abs_3({{-0.9, 0, -0.9}, {-0.9, 0, 0.9}, {0.9, 0, 0.9}, {0.9, 0, -0.9}});
    g.polygon_abs_3({{-0.5, 0, 0.1}, {0.5, 0, 0.1}, {0.5, 0.3, 0.1}, {-0.5, 0.3, 0.1}});
    g.close_segment();
    EXPECT_EQ(intersection_lines(ViewedScene(g.display_file()).primitives(), 1).size(), 0u)
        << degrees;
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

/// A line well behind a wall does not lie in it because of something entered far away.
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

/// With a ROUNDOFF, rounding may leave pieces of touching lines, but no strokes without length,
/// which a pen draws as dots.
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
    if (!touches) g.set_hidden_surfaces({.touching = Touching{Touching::Kind::off}});
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

/// A face in a plane of the modelling coordinates, a small hollow polygon near it, and where that
/// is seen: whole without the face.
struct NearAFace {
  int seed;
  Touching touching{};
  double window = 3.0;  ///< half its width

  /// The visible length of a polygon with these y, if `with_face` with a face at y = 0.
  double length(const std::array<double, 3>& y, bool with_face, HiddenMethod method) const {
    GraphicsSystem g;
    Source s(static_cast<std::uint64_t>(seed));
    test::view_from_anywhere(s, g, {Point3(0.0), 3.0});
    g.set_window(-window, window, -window, window);
    if (seed % 2 == 1) test::turn_and_move(s, g);
    g.set_hidden_surfaces({.touching = touching});
    g.open_segment(1);
    g.set_line_style({LineStyle::Kind::none});
    if (with_face) g.polygon_abs_3({{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}});
    g.set_fill_style({FillStyle::Kind::hollow});
    g.set_line_style({LineStyle::Kind::solid});
    const double x = test::decimal(s, -1, 0), z = test::decimal(s, -1, 0);
    g.polygon_abs_3({{x, y[0], z}, {x + 0.8, y[1], z + 0.1}, {x + 0.3, y[2], z + 0.9}});
    g.close_segment();
    return length_of(g, method, Colour{0, 0, 0});
  }
  double whole(const std::array<double, 3>& y) const {
    return length(y, false, HiddenMethod::franklin);
  }
  /// The sign of y where the face hides it; 0 if none of it is in the picture.
  int behind() const {
    for (const int sign : {1, -1}) {
      const std::array y{0.01 * sign, 0.01 * sign, 0.01 * sign};
      if (length(y, true, HiddenMethod::franklin) < whole(y)) return sign;
    }
    return 0;
  }
};

/// A polygon farther from a plane than the reach, by however little, is before it or behind it. No
/// coordinate is larger than 2.
TEST(TouchingLines, MoreThanTheReachApartAreHidden) {
  const double reach = 8.0 * 0x1p-52 * 2.0;
  int hidden = 0;
  for (int seed = 0; seed < 60 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const NearAFace scene{seed, {}, seed % 3 == 0 ? 0.4 : 3.0};
    const int behind = scene.behind();
    if (behind == 0) continue;
    for (const double reaches : {-4.0, -1.1, -0.9, 0.0, 0.9, 1.1, 4.0}) {
      const double at = reaches * reach;
      const bool is_hidden = std::abs(reaches) > 1.0 && reaches * behind > 0.0;
      const double expected = is_hidden ? 0.0 : scene.whole({at, at, at});
      for (const HiddenMethod method : kMethodsOfLines) {
        EXPECT_NEAR(scene.length({at, at, at}, true, method), expected, 1e-9)
            << name_of(method) << ", " << reaches << " reaches";
      }
      if (is_hidden) ++hidden;
    }
  }
  EXPECT_GT(hidden, 20 / test::kSlower);
}

/// With one end within reach of a plane a line is wholly on the side of the other, though the end
/// may be on the other side of the plane.
TEST(TouchingLines, WithOneEndOnAPlaneAreOnTheSideOfTheOther) {
  const double reach = 8.0 * 0x1p-52 * 2.0;
  int hidden = 0;
  for (int seed = 0; seed < 60 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const NearAFace scene{seed};
    const int behind = scene.behind();
    if (behind == 0) continue;
    for (const double foot : {-0.9 * reach, 0.0, 0.9 * reach}) {
      for (const int side : {-1, 1}) {
        const std::array y{foot, foot, 1e-12 * side};
        for (const HiddenMethod method : kMethodsOfLines) {
          // Behind the face the side between the feet is seen.
          const double expected =
              side != behind ? scene.whole(y) : scene.length({0.0, 0.0, 1e-3 * side}, true, method);
          EXPECT_NEAR(scene.length(y, true, method), expected, 1e-9) << name_of(method);
        }
        hidden += side == behind ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 20 / test::kSlower);
}

/// A reach that is much of the picture.
TEST(TouchingLines, WithinALargeReachLieInTheFace) {
  for (int seed = 0; seed < 40 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    NearAFace scene{seed};
    const int behind = scene.behind();
    if (behind == 0) continue;
    scene.touching = {Touching::Kind::length, 0.05};
    for (const HiddenMethod method : kMethodsOfLines) {
      const double within = 0.04 * behind, beyond = 0.06 * behind;
      EXPECT_NEAR(scene.length({within, within, within}, true, method),
                  scene.whole({within, within, within}), 1e-9)
          << name_of(method);
      EXPECT_LE(scene.length({beyond, beyond, beyond}, true, method),
                0.5 * scene.whole({beyond, beyond, beyond}))
          << name_of(method);
    }
  }
}

/// A wall that is edge-on up to rounding has sides at the depths of their own ends: that of its
/// plane would be arbitrary.
TEST(TouchingLines, SidesOfWallsSeenEdgeOnAreWhereTheyAre) {
  for (int seed = 0; seed < 200 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto length = [&](bool with_walls, HiddenMethod method) {
      Source s(static_cast<std::uint64_t>(seed));
      const double turn = test::decimal(s, -180, 180), angle = std::atan(1.0) / 45.0 * turn;
      const double y = test::decimal(s, 0.2, 1.5), z = test::decimal(s, 0.2, 1.5);
      // The direction (0, y, z), turned about z.
      const Point3 to_eye(-std::sin(angle) * y, std::cos(angle) * y, z);
      GraphicsSystem g;
      g.set_view_plane_normal(to_eye);
      g.set_view_up({0, 0, 1});
      g.set_parallel(-to_eye);
      g.set_window(-3, 3, -3, 3);
      g.rotate_z_3(turn);
      g.open_segment(1);
      for (const double at : {-1.3, 0.4}) {
        const double x = at + test::decimal(s, 0, 0.3), a = x + 0.7;
        const double b = test::decimal(s, 0.3, 1), c = test::decimal(s, 0.3, 1);
        g.polygon_abs_3({{x, 0, 0}, {x, 0, c}, {a, 0, c}, {a, 0, 0}});
        g.polygon_abs_3({{x, b, 0}, {a, b, 0}, {a, b, c}, {x, b, c}});
        g.polygon_abs_3({{x, 0, 0}, {a, 0, 0}, {a, b, 0}, {x, b, 0}});
        g.polygon_abs_3({{x, 0, c}, {x, b, c}, {a, b, c}, {a, 0, c}});
        if (!with_walls) continue;
        g.polygon_abs_3({{x, 0, 0}, {x, b, 0}, {x, b, c}, {x, 0, c}});
        g.polygon_abs_3({{a, 0, 0}, {a, 0, c}, {a, b, c}, {a, b, 0}});
      }
      g.close_segment();
      return length_of(g, method, Colour{0, 0, 0});
    };
    const double expected = length(false, HiddenMethod::roberts);
    for (const HiddenMethod method : kMethodsOfLines) {
      EXPECT_NEAR(length(true, method), expected, 1e-9) << name_of(method);
    }
  }
}

/// The polygon in whose plane others lie may be a back face that is removed. Without it the third
/// would lie in the second's plane, and hide nothing of the first's sides; the length is that which
/// tests/touching/line_oracle.py prints.
TEST(TouchingLines, LieInThePlanesOfPolygonsThatAreNotSeen) {
  GraphicsSystem g;
  replay(
      "set-view-plane-normal -1.102 0.306 2.607\n"
      "set-view-up 0.0 1.0 0.0\n"
      "set-perspective 3.2658 -2.0932 -6.4050\n"
      "set-view-reference-point 0.3006 -0.6961 0.9228\n"
      "set-window -1.480 2.412 -2.946 1.506\n"
      "set-line-style solid 0 0 0\n"
      "set-touching 0.001\n"
      "set-viewport 0.28 0.67 0.22 0.70\n"
      "set-back-face-removal on\n"
      "rotate-x-3 99.78\n"
      "rotate-y-3 -83.15\n"
      "rotate-z-3 -45.41\n"
      "translate-3 0.32 -0.71 0.92\n"
      "open-segment 1\n"
      "polygon-abs-3 -2.0 -0.30 -2.0  -2.0 -0.30 2.0  2.0 -0.30 2.0  2.0 -0.30 -2.0\n"
      "polygon-abs-3 0.56 -0.30060 0.41  1.62 -0.30060 0.41  1.62 -0.30060 1.24  0.56 -0.30060 "
      "1.24\n"
      "polygon-abs-3 0.65 -0.30075 0.71  1.48 -0.29979 0.71  0.65 -0.29970 1.12\n"
      "polygon-abs-3 1.18 -0.30069 0.54  1.56 -0.29987 0.54  1.18 -0.30135 1.23\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method : kMethodsOfLines) {
    EXPECT_NEAR(length_of(g, method, Colour{0, 0, 0}), 0.490819778125, 1e-9) << name_of(method);
  }
}

}  // namespace
}  // namespace displayfile
