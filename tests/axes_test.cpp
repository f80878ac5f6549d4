// The axes of a box: their edges in a view, and the texts at their ticks.

#include "displayfile/user_routines/axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/text/seen_texts.h"
#include "tests/error_of.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using namespace test;

std::vector<DeviceText> drawn_texts(const GraphicsSystem& g) {
  return ViewedScene(g.display_file()).texts();
}

std::vector<std::string> texts_of(const GraphicsSystem& g) {
  std::vector<std::string> texts;
  for (const DeviceText& text : drawn_texts(g)) texts.push_back(text.characters);
  return texts;
}

using Names = std::array<std::string_view, 3>;

GraphicsSystem axes_of(const Point3& low, const Point3& high, const Names& names = {"", "", ""}) {
  GraphicsSystem g;
  const Point3 margin = 0.4 * (high - low);
  g.set_window(low.x - margin.x, high.x + margin.x, low.y - margin.y, high.y + margin.y);
  g.open_segment(1);
  axes_3(g, low, high, names);
  g.close_segment();
  return g;
}

std::vector<std::string> numbers(double low, double high) {
  std::vector<std::string> found;
  for (const DeviceText& text : drawn_texts(axes_of({low, 0, 0}, {high, high - low, 0}))) {
    if (text.style.alignment == TextStyle::Alignment::centre) found.push_back(text.characters);
  }
  return found;
}

TEST(Axes, NumbersAreMultiplesOfARoundOne) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(numbers(0, 1), (Words{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(numbers(0.1, 0.6), (Words{"0.1", "0.2", "0.3", "0.4", "0.5", "0.6"}));
  EXPECT_EQ(numbers(-1, 1.5), (Words{"\u22121", "\u22120.5", "0", "0.5", "1", "1.5"}));
  EXPECT_EQ(numbers(-3.2, 3.2), (Words{"\u22122", "0", "2"}));
  EXPECT_EQ(numbers(3, 47), (Words{"10", "20", "30", "40"}));
  EXPECT_EQ(numbers(500000, 500001),
            (Words{"500000", "500000.2", "500000.4", "500000.6", "500000.8", "500001"}));
  EXPECT_EQ(numbers(0, 3e-7), (Words{"0", "1e-07", "2e-07", "3e-07"}));
  EXPECT_EQ(numbers(1, std::nextafter(1.0, 2.0)).front(), "1");
}

/// An x axis that is 1 / 1.8 of the picture's height long, with texts of a size.
GraphicsSystem axis_with_texts(double low, double high, double size) {
  GraphicsSystem g;
  const double margin = 0.4 * (high - low);
  g.set_window(low - margin, high + margin, -margin, high - low + margin);
  g.set_text_style({.size = size});
  g.open_segment(1);
  axes_3(g, {low, 0, 0}, {high, 0, 0}, {"", "", ""});
  g.close_segment();
  return g;
}
constexpr double kAxis = 1.0 / 1.8;

/// In a row a number has 2.8 times the size of the texts to itself, and an axis at most five steps.
TEST(Axes, StepsAreAsWideAsNumbersNeed) {
  using Words = std::vector<std::string>;
  const auto numbers_of = [](double size) { return texts_of(axis_with_texts(0, 5, size)); };
  const double five = kAxis / (5 * 2.8), two = kAxis / (2 * 2.8);
  EXPECT_EQ(numbers_of(0.2 * five), (Words{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(numbers_of(0.99 * five), (Words{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(numbers_of(1.01 * five), (Words{"0", "2", "4"}));
  EXPECT_EQ(numbers_of(1.01 * two), (Words{"0", "5"}));
}

/// The same in a column, where a number needs half of that.
TEST(Axes, StepsAreAsHighAsNumbersNeed) {
  using Words = std::vector<std::string>;
  const auto numbers_of = [](double size) {
    GraphicsSystem g;
    g.set_window(-2, 7, -2, 7);
    g.set_text_style({.size = size});
    g.open_segment(1);
    axes_3(g, {0, 0, 0}, {0, 5, 0}, {"", "", ""});
    g.close_segment();
    return texts_of(g);
  };
  const double five = kAxis / (5 * 1.4);
  EXPECT_EQ(numbers_of(0.99 * five), (Words{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(numbers_of(1.01 * five), (Words{"0", "2", "4"}));
}

/// Ticks have 0.4 of the texts' size, numbers stand 0.45 below them; a long number that would be
/// closer than half a size to the one before stands farther out.
TEST(Axes, NumbersStandInARowWhileTheyHaveRoom) {
  const double letters = 6 * 0.6;  // of 100000, in sizes
  for (const double apart : {letters + 0.55, letters + 0.45}) {
    const double size = kAxis / 5 / apart;
    const GraphicsSystem g = axis_with_texts(100000, 100005, size);
    const std::vector<DeviceText> texts = drawn_texts(g);
    ASSERT_EQ(texts.size(), 6u);
    const double axis = 0.4 / 1.8, capital = 0.7;
    for (std::size_t k = 0; k < texts.size(); ++k) {
      EXPECT_NEAR(texts[k].anchor.x, (0.4 + 0.2 * static_cast<double>(k)) / 1.8, 1e-9);
      const double below = (axis - texts[k].anchor.y) / size - capital;  // of the letters' tops
      const bool is_farther = apart < letters + 0.5 && k % 2 == 1;
      if (is_farther) {
        EXPECT_NEAR(below, 0.4 + 0.45 + 1.0, 1e-6) << k;
      } else {
        EXPECT_NEAR(below, 0.4 + 0.45, 1e-6) << k;
      }
    }
    int ticks = 0;
    const ViewedScene scene(g.display_file());
    for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
      const PointRow points = scene.points(item);
      if (scene.kind(item) != Primitives::Kind::line || points[0].x != points[1].x) continue;
      EXPECT_NEAR(std::abs(points[0].y - points[1].y), 0.4 * size, 1e-9);
      ++ticks;
    }
    EXPECT_EQ(ticks, 6);
  }
}

/// A flat chart: the x axis below, the y axis to the left, names in their middles.
TEST(Axes, OfAFlatChart) {
  const GraphicsSystem g = axes_of({0, 0, 0}, {10, 5, 0}, {"time", "speed", "none"});
  EXPECT_EQ(texts_of(g), (std::vector<std::string>{"0", "2", "4", "6", "8", "10", "0", "1", "2",
                                                   "3", "4", "5", "time", "speed"}));
  for (const DeviceText& text : drawn_texts(g)) {
    const bool is_below = text.anchor.y < 0.4 / 1.8;
    const bool is_left = text.anchor.x < 0.4 / 1.8;
    EXPECT_TRUE(is_below || is_left) << text.characters;
    if (is_below && !is_left) {
      EXPECT_EQ(text.style.alignment, TextStyle::Alignment::centre);
    }
    if (text.characters == "time") {
      EXPECT_NEAR(text.anchor.x, 0.5, 1e-9);
    }
    if (text.characters == "speed") {
      EXPECT_EQ(text.style.alignment, TextStyle::Alignment::right);
    }
  }
}

/// A solid box and its axes from all around, in parallel and in perspective.
GraphicsSystem box_seen_from(double azimuth, double elevation, bool perspective,
                             const Names& names = {"one", "two", "three"}) {
  const double a = azimuth * 0.0174532925, e = elevation * 0.0174532925;
  const Point3 eye(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
  GraphicsSystem g;
  g.set_view_plane_normal(-eye);
  g.set_view_up({0, 0, 1});
  if (perspective) {
    g.set_perspective(8.0 * eye);
  } else {
    g.set_parallel(eye);
  }
  g.set_window(-3, 3, -3, 3);
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.scope = HiddenScope::all});
  g.set_back_face_removal(false);
  g.open_segment(1);
  const auto face = [&](int axis, double at) {
    std::vector<Point3> corners(4);
    for (int k = 0; k < 4; ++k) {
      corners[static_cast<std::size_t>(k)][axis] = at;
      corners[static_cast<std::size_t>(k)][(axis + 1) % 3] = k == 1 || k == 2 ? 1 : -1;
      corners[static_cast<std::size_t>(k)][(axis + 2) % 3] = k >= 2 ? 1 : -1;
    }
    g.polygon_abs_3(corners);
  };
  for (int axis = 0; axis < 3; ++axis) {
    face(axis, -1);
    face(axis, 1);
  }
  axes_3(g, {-1, -1, -1}, {1, 1, 1}, names);
  g.close_segment();
  return g;
}

TEST(Axes, AreOutsideOfTheirBoxInEveryView) {
  int views = 0;
  for (const bool perspective : {false, true}) {
    for (int azimuth = 7; azimuth < 360; azimuth += 24) {
      for (int elevation = -81; elevation < 90; elevation += 18) {
        const GraphicsSystem g = box_seen_from(azimuth, elevation, perspective);
        const ViewedScene scene(g.display_file());
        const std::size_t seen = seen_texts(g.display_file(), true).size();
        ++views;
        ASSERT_EQ(seen, scene.texts().size()) << azimuth << ' ' << elevation << ' ' << perspective;
        if (perspective && (elevation < -70 || elevation > 70)) continue;  // "three" is left out
        for (const char* name : {"one", "two", "three"}) {
          ASSERT_EQ(std::ranges::count(scene.texts(), name, &DeviceText::characters), 1)
              << name << ' ' << azimuth << ' ' << elevation << ' ' << perspective;
        }
      }
    }
  }
  EXPECT_EQ(views, 300);
}

/// The approximate extent of its letters, in a picture that is as wide as high.
Rectangle covered_by(const DeviceText& text) {
  using Alignment = TextStyle::Alignment;
  const double of_letter = 0.55 * text.style.size;
  const double width = of_letter * static_cast<double>(text.characters.size());
  const double before = text.style.alignment == Alignment::left     ? 0.0
                        : text.style.alignment == Alignment::centre ? 0.5 * width
                                                                    : width;
  const double left = text.anchor.x - before;
  return {left, left + width, text.anchor.y, text.anchor.y + 0.7 * text.style.size};
}

/// True if a text covers a point of an edge of the box from low to high.
bool is_over_an_edge(const Rectangle& text, const GraphicsSystem& g, const Point3& low,
                     const Point3& high) {
  for (int from = 0; from < 8; ++from) {
    for (int axis = 0; axis < 3; ++axis) {
      Point3 a, b;
      for (int k = 0; k < 3; ++k) a[k] = b[k] = ((from >> k) & 1) != 0 ? high[k] : low[k];
      b[axis] = high[axis];
      for (double t = 0.0; a != b && t <= 1.0; t += 0x1p-9) {
        const Point3 p = g.to_device((1.0 - t) * a + t * b).value();
        if (p.x > text.x_min && p.x < text.x_max && p.y > text.y_min && p.y < text.y_max) {
          return true;
        }
      }
    }
  }
  return false;
}

/// An axis that rises little, with a text across it that is as long as half of the axis.
TEST(Axes, NoTextRunsThroughAnAxisThatRisesALittle) {
  for (const double turned : {-23.0, -21.0, -12.0, -3.0, 3.0, 12.0, 21.0, 23.0}) {
    GraphicsSystem g;
    g.set_window(-1, 1, -1, 1);
    g.rotate_z_3(turned);
    const Point3 low(-0.6, -0.2, 0), high(0.6, 0.3, 0);
    g.open_segment(1);
    axes_3(g, low, high, {"distance from the source in metres", "", ""});
    g.close_segment();
    const std::vector<DeviceText> texts = drawn_texts(g);
    EXPECT_TRUE(std::ranges::any_of(texts, [](const DeviceText& text) {
      return text.characters.starts_with("distance");
    })) << turned;
    for (const DeviceText& text : texts) {
      EXPECT_FALSE(is_over_an_edge(covered_by(text), g, low, high))
          << turned << " " << text.characters;
    }
  }
}

TEST(Axes, NoLongNumberRunsThroughItsAxis) {
  for (const double turned : {-22.0, -15.0, 15.0, 22.0}) {
    GraphicsSystem g;
    g.set_window(-1, 1, -1, 1);
    g.translate_3(-1000000.5, 0, 0);
    g.rotate_z_3(turned);
    const Point3 low(1000000, -0.3, 0), high(1000001, 0.3, 0);
    g.open_segment(1);
    axes_3(g, low, high);
    g.close_segment();
    const std::vector<DeviceText> texts = drawn_texts(g);
    EXPECT_GE(texts.size(), 5u) << turned;
    for (const DeviceText& text : texts) {
      EXPECT_FALSE(is_over_an_edge(covered_by(text), g, low, high))
          << turned << " " << text.characters;
    }
  }
}

TEST(Axes, LongNamesAreInThePictureAndNoTextIsOverAnother) {
  const Names names{"temperature of the air", "distance from the shore", "height above the sea"};
  for (const bool perspective : {false, true}) {
    for (int azimuth = 7; azimuth < 360; azimuth += 24) {
      for (int elevation = -63; elevation < 70; elevation += 18) {
        SCOPED_TRACE(testing::Message() << azimuth << ' ' << elevation << ' ' << perspective);
        const GraphicsSystem g = box_seen_from(azimuth, elevation, perspective, names);
        std::vector<DeviceText> texts = drawn_texts(g);
        for (std::size_t i = 0; i < texts.size(); ++i) {
          if (texts[i].characters.starts_with("\u2212")) texts[i].characters.replace(0, 3, "-");
          const Rectangle box = covered_by(texts[i]);
          EXPECT_TRUE(box.x_min >= 0.0 && box.x_max <= 1.0 && box.y_min >= 0.0 && box.y_max <= 1.0)
              << texts[i].characters;
          EXPECT_FALSE(is_over_an_edge(box, g, Point3(-1), Point3(1))) << texts[i].characters;
          for (std::size_t k = 0; k < i; ++k) {
            const Rectangle other = covered_by(texts[k]);
            EXPECT_FALSE(box.x_min < other.x_max && other.x_min < box.x_max &&
                         box.y_min < other.y_max && other.y_min < box.y_max)
                << texts[i].characters << " over " << texts[k].characters;
          }
        }
        EXPECT_GE(texts.size(), 11u);  // two numbers may be one at a corner where axes meet
        for (const std::string_view name : names) {
          EXPECT_EQ(std::ranges::count(texts, name, &DeviceText::characters), 1) << name;
        }
      }
    }
  }
}

TEST(Axes, AnAxisSeenEndOnIsLeftOut) {
  GraphicsSystem g;  // looking along z
  g.set_window(-3, 3, -3, 3);
  g.open_segment(1);
  axes_3(g, {-1, -1, -1}, {1, 1, 1});
  g.close_segment();
  const std::vector<std::string> texts = texts_of(g);
  EXPECT_EQ(std::ranges::count(texts, "x"), 1);
  EXPECT_EQ(std::ranges::count(texts, "y"), 1);
  EXPECT_EQ(std::ranges::count(texts, "z"), 0);
}

/// In the modelling transformation, in the styles in force, which stay; recorded as the routines
/// that make them.
TEST(Axes, AreMadeOfUserRoutines) {
  std::ostringstream recorded;
  Recorder recorder(recorded);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.set_text_style({.size = 0.05, .alignment = TextStyle::Alignment::right, .always = true});
  const TextStyle style = g.looks().attributes.text;
  g.scale_3(0.01, 0.5, 1);
  g.open_segment(1);
  axes_3(g, {0, 0, 0}, {50, 1, 0});
  EXPECT_EQ(g.looks().attributes.text, style);
  g.line_rel_3(10, 1, 0);  // from the box's corner
  g.close_segment();
  EXPECT_EQ(texts_of(g).front(), "0");
  EXPECT_EQ(drawn_texts(g).front().style.size, 0.05);
  EXPECT_TRUE(drawn_texts(g).front().style.always);
  EXPECT_EQ(recorded.str().find("axes"), std::string::npos);
  EXPECT_NE(recorded.str().find("move-abs-3 0 0 0\nline-rel-3 10 1 0\n"), std::string::npos);
  GraphicsSystem again;
  replay(recorded.str(), "recorded.draw", again);
  EXPECT_EQ(dump(again.display_file()), dump(g.display_file()));
  GraphicsSystem program;
  replay(
      "set-text-style 0.05 right always\nscale-3 0.01 0.5 1\nopen-segment 1\n"
      "axes-3 0 50 0 1 0 0\nline-rel-3 10 1 0\nclose-segment\n",
      "axes.draw", program);
  EXPECT_EQ(dump(program.display_file()), dump(g.display_file()));
}

TEST(Axes, RefusedBeforeAnythingIsDrawn) {
  GraphicsSystem none;
  expect_error([&] { axes_3(none, {0, 0, 0}, {1, 1, 1}); }, "no segment open: open one first");
  const auto refused = [](const std::string& line, const std::string& view = "") {
    GraphicsSystem g;
    replay(view, "view.draw", g);
    g.open_segment(1);
    const std::string before = dump(g.display_file());
    const std::string error = error_of_program(line + "\n", g);
    EXPECT_EQ(dump(g.display_file()), before) << line;
    return error;
  };
  EXPECT_EQ(refused("axes-3 0 1 0 1 0"),
            "scene.draw:1:17: axes-3: 5 arguments, expected 6 or 9: x-min x-max y-min y-max z-min "
            "z-max [\"x\" \"y\" \"z\"]");
  EXPECT_EQ(refused("axes-3 0 1 1 0 0 1"),
            "scene.draw:1:1: axes from y 1 to 0: expected y-min <= y-max, in this order: x-min "
            "x-max y-min y-max z-min z-max");
  EXPECT_EQ(refused("axes-3 0 0 1 1 2 2"),
            "scene.draw:1:1: axes of a point: expected x-min < x-max, or likewise for y or z");
  EXPECT_EQ(refused("axes-3 0 1 0 1 0 1 \"a\" \"b\" c"),
            "scene.draw:1:28: expected a text in quotation marks, not 'c'");
  EXPECT_EQ(refused("axes-3 0 1 0 1 0 9", "set-perspective 0 0 5\n"),
            "scene.draw:1:1: axes: the box or the numbers and names beside it are not entirely in "
            "front of the eye");
  EXPECT_NE(refused("axes-3 0 1e100 -1e100 1e100 0 1").find("expected finite numbers"),
            std::string::npos);
  GraphicsSystem g;
  g.open_segment(1);
  expect_error([&] { axes_3(g, {0, 0, 0}, {1, 1, 1}, {"a\n", "", ""}); }, "character U+000A");
  EXPECT_TRUE(texts_of(g).empty());
}

}  // namespace
}  // namespace displayfile
