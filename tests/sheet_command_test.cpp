// `displayfile sheet`, as its users meet it.

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <sstream>

#include "tests/command_fixture.h"

namespace {

class SheetCommandTest : public Command {
 protected:
  void SetUp() override {
    write("box.obj",
          "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 0 0 30\nv 60 0 30\nv 60 40 30\nv 0 40 30\n"
          "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  }
  /// The path of a layer.
  std::string path_of(const std::string& file, const std::string& layer) {
    const std::string text = read(folder_ / file);
    const std::size_t at = text.find("id=\"" + layer + "\"");
    if (at == std::string::npos) return {};
    const std::size_t begin = text.find(" d=\"", at) + 4;
    return text.substr(begin, text.find('"', begin) - begin);
  }
  /// Its coordinates.
  std::vector<double> numbers(const std::string& file, const std::string& layer) {
    std::string path = path_of(file, layer);
    for (char& c : path) c = std::isalpha(static_cast<unsigned char>(c)) && c != 'e' ? ' ' : c;
    std::istringstream in(path);
    std::vector<double> all;
    for (double x = 0.0; in >> x;) all.push_back(x);
    return all;
  }

  struct Text {
    double x, y, size;
    bool centred;
    std::string characters;
    /// As letters of usual faces, on an average, at the least.
    double width() const { return 0.45 * size * static_cast<double>(characters.size()); }
    double left() const { return centred ? x - width() / 2.0 : x; }
    double top() const { return y - 0.72 * size; }
  };
  std::vector<Text> texts(const std::string& file) {
    const std::string text = read(folder_ / file);
    const std::regex element(
        "<text x=\"([^\"]+)\" y=\"([^\"]+)\" font-size=\"([^\"]+)\"( [^>]+)?>([^<]*)<");
    std::vector<Text> all;
    for (std::sregex_iterator it(text.begin(), text.end(), element), end; it != end; ++it) {
      const auto number = [&](std::size_t k) { return std::stod((*it)[k]); };
      all.push_back({number(1), number(2), number(3), (*it)[4].matched, (*it)[5]});
    }
    return all;
  }
  /// Whether something of a layer is drawn within the text's rectangle: by points along its lines.
  /// Paths of several lines have as many points each.
  bool is_drawn_over(const std::string& file, const std::string& layer, std::size_t points_of_line,
                     const Text& text) {
    const auto all = numbers(file, layer);
    for (std::size_t i = 0; i + 2 < all.size(); i += 2) {
      if ((i / 2 + 1) % points_of_line == 0) continue;
      for (double t = 0.0; t <= 1.0; t += 0.002) {
        const double x = all[i] + t * (all[i + 2] - all[i]);
        const double y = all[i + 1] + t * (all[i + 3] - all[i + 1]);
        if (x > text.left() && x < text.left() + text.width() && y > text.top() && y < text.y) {
          return true;
        }
      }
    }
    return false;
  }
  /// Letters of sections lie apart from each other, from cutting lines and arrows, and from views.
  void expect_marks_apart(const std::string& file) {
    std::vector<Text> marks = texts(file);
    std::erase_if(marks, [](const Text& text) { return !text.centred; });
    ASSERT_FALSE(marks.empty());
    for (const Text& a : marks) {
      EXPECT_FALSE(is_drawn_over(file, "CUTTING", 2, a)) << a.characters;
      EXPECT_FALSE(is_drawn_over(file, "CUTTING_ENDS", 3, a)) << a.characters;
      EXPECT_FALSE(is_drawn_over(file, "HATCH", 2, a)) << a.characters;
      for (const Text& b : marks) {
        const bool meet = a.left() < b.left() + b.width() && b.left() < a.left() + a.width() &&
                          a.top() < b.y && b.top() < a.y;
        EXPECT_TRUE(&a == &b || !meet) << a.characters << " and " << b.characters;
      }
    }
  }
};

/// A side of a path, its ends in order.
using Stroke = std::array<double, 4>;

/// The strokes of an SVG path of M, L and Z.
std::vector<Stroke> strokes_of(const std::string& path) {
  std::vector<Stroke> all;
  std::istringstream in(path);
  double x = 0.0, y = 0.0, x0 = 0.0, y0 = 0.0;
  const auto to = [&](double x1, double y1) {
    const bool rises = std::pair(x, y) < std::pair(x1, y1);
    all.push_back(rises ? Stroke{x, y, x1, y1} : Stroke{x1, y1, x, y});
    x = x1;
    y = y1;
  };
  for (char command = 'M'; in >> std::ws && in.peek() != EOF;) {
    if (std::isalpha(in.peek()) != 0) in >> command;
    if (command == 'Z') {
      to(x0, y0);
      continue;
    }
    double x1 = 0.0, y1 = 0.0;
    in >> x1 >> y1;
    if (command == 'L') {
      to(x1, y1);
    } else {
      x = x0 = x1;
      y = y0 = y1;
    }
    command = 'L';
  }
  return all;
}

/// How far two strokes run along each other.
double overlap(const Stroke& a, const Stroke& b) {
  const double length = std::hypot(a[2] - a[0], a[3] - a[1]);
  const double u = (a[2] - a[0]) / length, v = (a[3] - a[1]) / length;
  const auto along = [&](double x, double y) { return (x - a[0]) * u + (y - a[1]) * v; };
  const auto across = [&](double x, double y) { return (x - a[0]) * v - (y - a[1]) * u; };
  if (std::abs(across(b[0], b[1])) > 1e-3 || std::abs(across(b[2], b[3])) > 1e-3) return 0.0;
  const auto [low, high] = std::minmax({along(b[0], b[1]), along(b[2], b[3])});
  return std::min(high, length) - std::max(low, 0.0);
}

TEST_F(SheetCommandTest, AMillimetreIsAMillimetreAtOneToOne) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --scale 1:1"), 0) << err_;
  const auto all = numbers("box.svg", "VISIBLE");
  ASSERT_FALSE(all.empty());
  const double left = [&] {
    double x = 1e9;
    for (std::size_t i = 0; i < all.size(); i += 2) x = std::min(x, all[i]);
    return x;
  }();
  int widths = 0;
  for (std::size_t i = 0; i < all.size(); i += 2) widths += std::abs(all[i] - left - 60.0) < 1e-11;
  EXPECT_GE(widths, 4);  // two corners of the front view, two of the top view
}

TEST_F(SheetCommandTest, HiddenLinesUnderVisibleOnesAreLeftOut) {
  ASSERT_EQ(run("sheet box.obj -o box.svg"), 0) << err_;
  EXPECT_EQ(numbers("box.svg", "HIDDEN").size() / 2, 6U);  // three edges of the isometric view
}

TEST_F(SheetCommandTest, SectionsAreHatched) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --section front=10 --section side=5"), 0) << err_;
  EXPECT_EQ(err_, "");
  EXPECT_FALSE(numbers("box.svg", "HATCH").empty());
  EXPECT_NE(read(folder_ / "box.svg").find(">B-B<"), std::string::npos);
}

/// A plate with a boss on it. The plate's upper face is a polygon with a bridge, or two without.
std::string plate_with_boss(bool bridged) {
  std::string text =
      "v -30 -15 0\nv 30 -15 0\nv 30 15 0\nv -30 15 0\nv -30 -15 5\nv 30 -15 5\nv 30 15 5\n"
      "v -30 15 5\nv -10 -10 5\nv 10 -10 5\nv 10 10 5\nv -10 10 5\nv -10 -10 20\n"
      "v 10 -10 20\nv 10 10 20\nv -10 10 20\n"
      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
      "f 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\nf 13 14 15 16\n";
  return text + (bridged ? "f 5 6 7 8 5 9 12 11 10 9\n" : "f 5 6 7 11 10 9\nf 5 9 12 11 7 8\n");
}

TEST_F(SheetCommandTest, AFaceWithAHoleIsCutAsItsPartsWithoutHolesAre) {
  write("bridged.obj", plate_with_boss(true));
  write("parts.obj", plate_with_boss(false));
  for (const char* section : {"front=2", "front=-12", "top=3", "top=12", "side=5", "side=20"}) {
    const auto strokes = [&](const std::string& part, const std::string& layer) {
      EXPECT_EQ(run("sheet " + part + ".obj -o s.svg --up z --title plate --section " + section),
                0);
      EXPECT_EQ(err_, "");
      auto all = strokes_of(path_of("s.svg", layer));
      for (Stroke& stroke : all) {
        for (double& x : stroke) x = std::round(x * 1e6);
      }
      std::ranges::sort(all);
      return all;
    };
    for (const char* layer : {"VISIBLE", "HIDDEN", "HATCH"}) {
      EXPECT_EQ(strokes("bridged", layer), strokes("parts", layer)) << section << " " << layer;
    }
  }
}

TEST_F(SheetCommandTest, NoLineOfASectionIsDrawnTwice) {
  write("plate.obj", plate_with_boss(true));
  write("turned.draw",
        "open-segment 1\nturn-3 40  9 -10  20 -10  20 10  9 10  9 4  15 4  15 -4  9 -4\n"
        "close-segment\n");
  for (const char* part : {"box.obj --section front=10", "plate.obj --up z --section front=2",
                           "plate.obj --up z --section side=10", "turned.draw --section front=0"}) {
    ASSERT_EQ(run(std::string("sheet -o s.svg ") + part), 0) << err_;
    std::vector<Stroke> all = strokes_of(path_of("s.svg", "VISIBLE"));
    const std::vector<Stroke> hidden = strokes_of(path_of("s.svg", "HIDDEN"));
    all.insert(all.end(), hidden.begin(), hidden.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_GT(std::hypot(all[i][2] - all[i][0], all[i][3] - all[i][1]), 1e-6) << part;
      for (std::size_t k = 0; k < i; ++k) EXPECT_LT(overlap(all[i], all[k]), 1e-2) << part;
    }
  }
}

/// A plane that touches a shaft: rounding leaves a strip of the cut face that is as good as none.
TEST_F(SheetCommandTest, ACutFaceWithoutAreaIsNotDrawn) {
  write("shaft.draw",
        "open-segment 1\nrotate-y-3 90\n"
        "turn-3 48  0 0  10 0  12 2  12 40  18 40  18 90  14 90  14 130  12 132  0 132\n"
        "close-segment\n");
  for (const char* plane : {"front=12", "top=12", "top=14", "front=-12"}) {
    ASSERT_EQ(run(std::string("sheet shaft.draw -o s.svg --up z --section ") + plane), 0) << err_;
    for (const Stroke& stroke : strokes_of(path_of("s.svg", "HATCH"))) {
      EXPECT_GT(std::hypot(stroke[2] - stroke[0], stroke[3] - stroke[1]), 1e-6) << plane;
    }
  }
}

/// The slope of a wedge is seen edge-on in the front view; its edges are behind the face that was
/// cut, and the middle one behind the block on it.
TEST_F(SheetCommandTest, EdgesOfAFaceSeenEdgeOnAreHidden) {
  write("ramp.draw",
        "open-segment 1\nbegin-solid difference\nbegin-solid union\nwedge-3 0 60 0 40 0 30\n"
        "box-3 20 30 20 30 0 40\nend-solid\nbox-3 -64 64 -64 25 -64 64\nend-solid\n"
        "close-segment\n");
  if (run("sheet ramp.draw -o s.svg --up z --scale 1:1") == 2) GTEST_SKIP() << err_;
  int slopes = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "HIDDEN"))) {
    slopes += std::abs(stroke[2] - stroke[0] - 10.0) < 1e-9 &&
              std::abs(std::abs(stroke[3] - stroke[1]) - 5.0) < 1e-9;
  }
  EXPECT_EQ(slopes, 1);
}

TEST_F(SheetCommandTest, SolidsOfOneProgramThatTouchAreHatched) {
  const std::string low = "box-3 0 40 0 20 0 10\n", high = "box-3 0 10 0 20 10 30\n";
  write("box.draw", "open-segment 1\n" + low + high + "close-segment\n");
  write("two.draw",
        "open-segment 1\n" + low + "close-segment\nopen-segment 2\n" + high + "close-segment\n");
  write("a.draw", "open-segment 1\n" + low + "close-segment\n");
  write("b.draw", "open-segment 1\n" + high + "close-segment\n");
  const auto sheet = [&](const std::string& parts) {
    EXPECT_EQ(run("sheet " + parts + " --up z --title a -o s.svg --section front=-10"), 0);
    EXPECT_EQ(err_, "");
    return read(folder_ / "s.svg");
  };
  const std::string files = sheet("a.draw b.draw");
  EXPECT_FALSE(numbers("s.svg", "HATCH").empty());
  EXPECT_TRUE(sheet("box.draw") == files);
  EXPECT_TRUE(sheet("two.draw") == files);
}

/// Hatching goes through, and hides what lies behind it.
TEST_F(SheetCommandTest, WhatTwoBodiesShareIsMaterial) {
  const std::string first = "box-3 0 40 0 20 0 20\n", second = "box-3 10 30 -10 30 5 15\n";
  const auto sheet = [&](const std::string& bodies, const std::string& layer) {
    write("bodies.draw", "open-segment 1\n" + bodies + "close-segment\n");
    EXPECT_EQ(run("sheet bodies.draw -o s.svg --scale 1:1 --section front=10"), 0);
    EXPECT_EQ(err_, "");
    double length = 0.0;
    for (const Stroke& stroke : strokes_of(path_of("s.svg", layer))) {
      length += std::hypot(stroke[2] - stroke[0], stroke[3] - stroke[1]);
    }
    return length;
  };
  const double whole = sheet(first, "HATCH"), both = sheet(first + second, "HATCH");
  EXPECT_NEAR(both / whole, 1.5, 0.02);  // 20 x 20 more than 40 x 20
  const std::string behind = "box-3 18 22 8 12 -20 -10\n";
  EXPECT_NEAR(sheet(first + second + behind, "VISIBLE") - sheet(first + second, "VISIBLE"),
              sheet(first + behind, "VISIBLE") - sheet(first, "VISIBLE"), 40.0);
}

TEST_F(SheetCommandTest, AMirroredBodyIsAsSolidAsAnother) {
  const auto hatching = [&](const std::string& mirror, const std::string& other) {
    write("bodies.draw", "open-segment 1\nbox-3 -5 40 0 20 0 20\n" + mirror + "box-3 " + other +
                             " 0 20 0 20\nclose-segment\n");
    EXPECT_EQ(run("sheet bodies.draw -o s.svg --scale 1:1 --section front=10"), 0) << err_;
    return path_of("s.svg", "HATCH");
  };
  EXPECT_EQ(hatching("scale-3 -1 1 1\n", "-5 40"), hatching("", "-40 5"));
}

/// The inner faces of a hollow part enclose a volume that is not its own.
TEST_F(SheetCommandTest, AHollowPartIsHatchedAroundItsHollow) {
  write("hollow.draw",
        "open-segment 1\nbegin-solid difference\nbox-3 0 40 0 30 0 20\nbox-3 10 30 10 20 5 15\n"
        "end-solid\nclose-segment\n");
  write("whole.draw", "open-segment 1\nbox-3 0 40 0 30 0 20\nclose-segment\n");
  const auto hatching = [&](const std::string& part, const std::string& front) {
    EXPECT_EQ(run("sheet " + part + " --up z --scale 1:1 -o s.svg --section front=" + front), 0);
    EXPECT_EQ(err_, "");
    return numbers("s.svg", "HATCH");
  };
  EXPECT_EQ(hatching("hollow.draw", "-5"), hatching("whole.draw", "-5"));
  EXPECT_GT(hatching("hollow.draw", "-15").size(), hatching("whole.draw", "-15").size());
}

/// In the isometric view, whose coordinates are rounded, too: of the edges that go to the right and
/// up these are two of each box's upper and right faces, and the foot of the one on the other.
TEST_F(SheetCommandTest, TheFootOfASolidOnAnotherIsSeen) {
  write("two.draw", "open-segment 1\nbox-3 0 40 0 20 0 10\nbox-3 0 10 0 20 10 30\nclose-segment\n");
  ASSERT_EQ(run("sheet two.draw --up z -o s.svg --scale 1:1"), 0) << err_;
  const double right = 20.0 / std::sqrt(2.0), up = 20.0 / std::sqrt(6.0);
  int edges = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "VISIBLE"))) {
    edges += std::abs(stroke[2] - stroke[0] - right) < 1e-6 &&
             std::abs(stroke[1] - stroke[3] - up) < 1e-6;
  }
  EXPECT_EQ(edges, 5);
}

/// Each end of a cutting line has an arrow along the direction of looking: here to the left, as the
/// side view is seen from the right.
TEST_F(SheetCommandTest, ArrowsOfACuttingLineSayFromWhereItIsSeen) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --section side=20 --scale 1:1"), 0) << err_;
  const std::vector<double> ends = numbers("box.svg", "CUTTING_ENDS");
  const std::vector<double> line = numbers("box.svg", "CUTTING");
  ASSERT_EQ(ends.size(), 2U * 2U * 6U);  // two lines of three points at each of two ends
  ASSERT_EQ(line.size(), 4U);
  for (std::size_t i = 0; i < ends.size(); i += 2) EXPECT_GE(ends[i], line[0] - 1e-9);
  EXPECT_NEAR(ends[4], line[0] + 6.0, 1e-9);  // the arrow's tail
}

TEST_F(SheetCommandTest, LettersOfSectionsKeepClear) {
  const std::string middle = "--section front=15 --section side=30";
  for (const std::string& arguments :
       {middle, middle + " --section top=20", middle + " --section top=20 --paper a5",
        middle + " --section top=20 --scale 1:20", middle + " --section top=20 --scale 1:100",
        middle + " --section top=40 --paper a5-portrait",
        std::string("--section front=30 --section top=40 --section side=60 --paper a6")}) {
    SCOPED_TRACE(arguments);
    ASSERT_EQ(run("sheet box.obj -o s.svg " + arguments), 0) << err_;
    expect_marks_apart("s.svg");
  }
  ASSERT_EQ(run("sheet box.obj -o s.svg --projection first --section front=15 --section side=-30 "
                "--section top=20 --scale 1:20"),
            0)
      << err_;
  expect_marks_apart("s.svg");
}

/// Below its middle, if nothing is there.
TEST_F(SheetCommandTest, ASectionHasItsLettersBelow) {
  ASSERT_EQ(run("sheet box.obj -o s.svg --section front=15 --scale 1:1"), 0) << err_;
  const auto line = numbers("s.svg", "HATCH");
  const auto all = texts("s.svg");
  const auto caption = std::ranges::find(all, "A-A", &Text::characters);
  ASSERT_NE(caption, all.end());
  double low = 0.0, left = 1e9;
  for (std::size_t i = 0; i < line.size(); i += 2) {
    left = std::min(left, line[i]);
    low = std::max(low, line[i + 1]);
  }
  EXPECT_NEAR(caption->x, left + 30.0, 1e-3);
  EXPECT_NEAR(caption->y, low + 7.0, 1e-3);
}

TEST_F(SheetCommandTest, ALongTitleKeepsWithinItsCell) {
  const auto lines_of_title = [&](const std::string& arguments) {
    EXPECT_EQ(run("sheet box.obj -o s.svg --paper a4-portrait " + arguments), 0) << err_;
    std::vector<Text> lines;
    bool in_title = false;
    for (const Text& text : texts("s.svg")) {
      if (text.characters == "SCALE") in_title = false;
      if (in_title) lines.push_back(text);
      if (text.characters == "TITLE") in_title = true;
    }
    constexpr double kScales = 200.0 - 150.0 + 0.55 * 150.0, kBottom = 297.0 - 10.0;
    for (const Text& line : lines) {
      EXPECT_LT(line.left() + line.width(), kScales) << line.characters;
      EXPECT_LT(line.y, kBottom) << line.characters;
      EXPECT_GE(line.size * 0.72, 1.79) << line.characters;
    }
    return lines;
  };
  EXPECT_EQ(lines_of_title("--title Bracket").size(), 1U);
  EXPECT_NEAR(lines_of_title("--title 'Bracket, welded, of three plates'").front().size * 0.72, 3.5,
              1e-3);
  const auto lines = lines_of_title(
      "--title 'Bracket, welded, with a very long name that will surely not fit in the title block "
      "of a sheet'");
  ASSERT_GT(lines.size(), 1U);
  EXPECT_TRUE(lines.back().characters.ends_with("sheet"));
  EXPECT_EQ(err_, "");
  const auto of_one_word = lines_of_title("--title " + std::string(90, 'x'));
  EXPECT_GT(of_one_word.size(), 1U);
  for (const Text& line : of_one_word) {
    constexpr double kWidthOfX = 0.592;  // in DejaVu Sans
    EXPECT_LT(line.left() + line.width() * kWidthOfX / 0.45, 132.5) << line.characters;
  }
  EXPECT_EQ(err_, "");
  const auto shortened = lines_of_title("--title '" + std::string(500, 'x') + "'");
  EXPECT_TRUE(shortened.back().characters.ends_with("\xE2\x80\xA6"));
  EXPECT_NE(err_.find("s.svg: too long for the title block, and shortened: TITLE xxx"),
            std::string::npos)
      << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>" + std::string(500, 'x')), std::string::npos);
}

TEST_F(SheetCommandTest, ALongDateIsShortened) {
  ASSERT_EQ(run("sheet box.obj -o s.svg --date 'the first of May of the year 2026, a Friday'"), 0);
  EXPECT_NE(err_.find("shortened: DATE the first of"), std::string::npos) << err_;
  ASSERT_EQ(run("sheet box.obj -o s.svg --date '1 May 2026, Friday'"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(SheetCommandTest, AnOpenMeshIsToldAndNotHatched) {
  write("open.obj", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 9\nf 1 2 3\nf 1 3 4\n");
  ASSERT_EQ(run("sheet open.obj -o open.svg --section front=4"), 0) << err_;
  EXPECT_NE(err_.find("not closed"), std::string::npos);
  EXPECT_TRUE(numbers("open.svg", "HATCH").empty());
}

TEST_F(SheetCommandTest, ASectionThatMissesThePartIsRefused) {
  const std::string missed = ": expected a position that cuts the part, ";
  expect_error("sheet box.obj -o s.svg --section front=31", "front=31" + missed + "0 to 30");
  expect_error("sheet box.obj -o s.svg --section front=-1", "front=-1" + missed + "0 to 30");
  expect_error("sheet box.obj -o s.svg --section top=40.5", "top=40.5" + missed + "0 to 40");
  expect_error("sheet box.obj -o s.svg --section side=-1", "side=-1" + missed + "0 to 60");
  expect_error("sheet box.obj -o s.svg --projection first --section side=1",
               "side=1" + missed + "-60 to 0");
  expect_error("sheet box.obj -o s.svg --up z --section front=9", "front=9" + missed + "-40 to 0");
  write("open.obj", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 9\nf 1 2 3\nf 1 3 4\n");
  expect_error("sheet open.obj -o s.svg --section front=99", "front=99" + missed + "0 to 9");
}

/// What lies in the plane counts as before it: the face there is cut, if it is nearer to the viewer
/// than the rest of the part.
TEST_F(SheetCommandTest, ASectionAtTheEndOfThePartCutsAFaceOrNothing) {
  for (const char* position : {"front=30", "top=40", "side=60"}) {
    ASSERT_EQ(run(std::string("sheet box.obj -o s.svg --section ") + position), 0) << err_;
    EXPECT_EQ(err_, "");
    EXPECT_FALSE(numbers("s.svg", "HATCH").empty());
  }
  const std::string touched = ": touches the part and cuts nothing: expected a position between ";
  expect_error("sheet box.obj -o no.svg --section front=0", "front=0" + touched + "0 and 30");
  write("tip.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 2 2 5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  expect_error("sheet tip.obj -o no.svg --section front=5", "front=5" + touched + "0 and 5");
}

TEST_F(SheetCommandTest, ASectionInAGapIsTold) {
  const std::string open =
      "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nv 0 0 20\nv 9 0 20\nv 0 9 20\nv 0 0 29\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 5 7 6\nf 5 6 8\nf 6 7 8\n";
  write("open.obj", open);
  write("closed.obj", open + "f 3 1 4\nf 7 5 8\n");
  for (const std::string part : {"closed.obj", "open.obj"}) {
    ASSERT_EQ(run("sheet -o s.svg --section front=15 " + part), 0) << err_;
    EXPECT_NE(err_.find("the section at 15 does not cut the part"), std::string::npos) << err_;
    ASSERT_EQ(run("sheet -o s.svg --section front=5 " + part), 0) << err_;
    EXPECT_EQ(err_.find("does not cut"), std::string::npos) << err_;
  }
}

TEST_F(SheetCommandTest, APartOfNoThicknessIsDrawn) {
  write("flat.draw", kTriangle);
  write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");  // and of no width
  for (const char* part : {"flat.draw", "line.obj"}) {
    ASSERT_EQ(run(std::string("sheet -o flat.svg ") + part), 0) << err_;
    EXPECT_FALSE(numbers("flat.svg", "VISIBLE").empty());
    EXPECT_EQ(run(std::string("sheet -o cut.svg --section side=0.5 ") + part), 0) << err_;
    EXPECT_TRUE(numbers("cut.svg", "HATCH").empty());
    expect_error(std::string("sheet -o no.svg --section front=0 ") + part,
                 "--section front=0: the part is flat there, at 0: expected no section");
  }
}

/// A box with a bore, and a pin that fills it with the same facets.
TEST_F(SheetCommandTest, TouchingSolidsHaveNoLinesWithinTheFaceThatTheyShare) {
  const std::string box = "box-3 -20 20 -20 20 0 20\n";
  const std::string pin = "open-segment 2\ncylinder-3 0 0 0 8 20 48\nclose-segment\n";
  const std::string bored = "open-segment 1\nbegin-solid difference\n" + box +
                            "cylinder-3 0 0 -1 8 22 48\nend-solid\nclose-segment\n";
  write("pin.draw", bored + pin);
  for (const char* section : {"", " --section side=0"}) {
    const std::string options = std::string(" --up z -o s.svg --scale 1:1") + section;
    if (run("sheet pin.draw" + options) == 2) GTEST_SKIP() << err_;
    EXPECT_EQ(err_, "");
    int facets = 0;  // of the front view's bore, and of the side view's
    for (const Stroke& stroke : strokes_of(path_of("s.svg", "HIDDEN"))) {
      facets +=
          std::abs(stroke[2] - stroke[0]) < 1e-9 && std::abs(stroke[3] - stroke[1] - 20.0) < 1e-9;
    }
    EXPECT_EQ(facets, *section == '\0' ? 4 : 2) << section;
  }
}

/// Two cubes that have a face in common, as groups of one closed surface, or as one object.
TEST_F(SheetCommandTest, WhatIsClosedIsHatchedHoweverItIsDividedIntoObjects) {
  const std::string vertices =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "v 2 0 0\nv 2 1 0\nv 2 0 1\nv 2 1 1\n";
  const std::string first = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\n", end = "f 2 3 7 6\nf 3 4 8 7\n";
  const std::string last = "f 4 1 5 8\n";
  const std::string other =
      "f 2 3 10 9\nf 6 11 12 7\nf 2 9 11 6\nf 9 10 12 11\nf 10 3 7 12\nf 3 2 6 7\n";
  write("one.obj", vertices + first + end + last + other);
  write("two.obj", vertices + "o a\n" + first + end + last + "o b\n" + other);
  write("groups.obj",
        vertices + "g a\n" + first + "g b\n" + end + "g c\n" + last + "o d\n" + other);
  const auto sheet = [&](const std::string& part) {
    EXPECT_EQ(run("sheet " + part + " --title a -o s.svg --section front=0.5"), 0);
    EXPECT_EQ(err_, "") << part;
    EXPECT_FALSE(numbers("s.svg", "HATCH").empty()) << part;
    return read(folder_ / "s.svg");
  };
  const std::string two = sheet("two.obj");
  EXPECT_TRUE(sheet("one.obj") == two);
  EXPECT_TRUE(sheet("groups.obj") == two);
}

TEST_F(SheetCommandTest, WhatProgramsDoNotDrawIsOnNoSheet) {
  const std::string box = "open-segment 1\nbox-3 0 40 0 20 0 10\nclose-segment\n";
  const std::string other = "open-segment 2\nbox-3 0 20 0 20 10 30\nclose-segment\n";
  const auto sheet = [&](const std::string& program) {
    write("a.draw", program);
    EXPECT_EQ(run("sheet a.draw -o s.svg --section front=5"), 0) << err_;
    EXPECT_EQ(err_, "");
    return read(folder_ / "s.svg");
  };
  const std::string alone = sheet(box);
  EXPECT_TRUE(sheet(box + other + "set-visibility 2 off\n") == alone);
  EXPECT_TRUE(sheet(box + "set-fill-style hollow\nset-line-style none\n" + other) == alone);
  EXPECT_FALSE(sheet(box + other) == alone);
}

TEST_F(SheetCommandTest, OutlinesOfAHollowPolygonHideNothing) {
  const std::string box = "open-segment 1\nbox-3 0 40 0 20 0 10\nclose-segment\n";
  const std::string plate =
      "open-segment 2\npolygon-abs-3 5 5 20  35 5 20  35 15 20  5 15 20\nclose-segment\n";
  const auto hidden = [&](const std::string& program) {
    write("a.draw", program);
    EXPECT_EQ(run("sheet a.draw -o s.svg --scale 1:1"), 0) << err_;
    return strokes_of(path_of("s.svg", "HIDDEN")).size();
  };
  EXPECT_EQ(hidden(box + "set-fill-style hollow\n" + plate), hidden(box));
  EXPECT_GT(hidden(box + plate), hidden(box));
}

TEST_F(SheetCommandTest, WhatAProgramSaysBeforeAMeshActsOnIt) {
  write("wide.draw", "scale-3 3 1 1\n");
  write("wide.obj",
        "v 0 0 0\nv 180 0 0\nv 180 40 0\nv 0 40 0\nv 0 0 30\nv 180 0 30\nv 180 40 30\nv 0 40 30\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  write("off.draw", "set-visibility 2 off\n");
  const auto sheet = [&](const std::string& parts) {
    EXPECT_EQ(run("sheet " + parts + " --title a -o s.svg"), 0) << err_;
    EXPECT_EQ(err_, "");
    return read(folder_ / "s.svg");
  };
  const std::string wide = sheet("wide.obj");
  EXPECT_TRUE(sheet("wide.draw box.obj") == wide);
  EXPECT_TRUE(sheet("wide.obj box.obj off.draw") == wide);  // segments are named as in a picture
}

/// A sheet of two sides through the plane, beside a box.
TEST_F(SheetCommandTest, TheCutEdgeOfASheetOfTwoSidesIsALine) {
  write("sheets.draw",
        "open-segment 1\npolygon-abs-3 0 0 -10  20 0 10  20 20 10  0 20 -10\n"
        "polygon-abs-3 0 20 -10  20 20 10  20 0 10  0 0 -10\nbox-3 30 50 0 20 -10 10\n"
        "close-segment\n");
  ASSERT_EQ(run("sheet sheets.draw -o s.svg --scale 1:1 --section front=0"), 0) << err_;
  EXPECT_EQ(err_, "");
  const std::vector<double> hatch = numbers("s.svg", "HATCH");
  ASSERT_FALSE(hatch.empty());
  double left = 1e9;
  for (std::size_t i = 0; i < hatch.size(); i += 2) left = std::min(left, hatch[i]);
  int edges = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "VISIBLE"))) {
    edges += std::abs(stroke[0] - (left - 20.0)) < 0.1 && std::abs(stroke[2] - stroke[0]) < 1e-9 &&
             std::abs(stroke[3] - stroke[1] - 20.0) < 1e-9;
  }
  EXPECT_EQ(edges, 1);
}

/// None where a bridge goes to a hole, and none where a face that is not flat, or one of a solid,
/// is divided.
TEST_F(SheetCommandTest, AllSidesAreThoseThatAPictureHas) {
  write("bridged.obj", plate_with_boss(true));
  ASSERT_EQ(run("sheet bridged.obj --up z -o s.svg --lines outline,boundary,crease"), 0) << err_;
  const std::string creases = read(folder_ / "s.svg");
  ASSERT_EQ(run("sheet bridged.obj --up z -o s.svg --lines all"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "s.svg") != creases);  // a side there and back is one of the file's
  write("bored.draw",
        "open-segment 1\nbegin-solid difference\nbox-3 0 40 0 30 0 20\nbox-3 10 30 10 20 -1 21\n"
        "end-solid\nclose-segment\n");
  for (const char* section : {"", " --section front=-15", " --section side=20"}) {
    const std::string options = std::string(" --up z -o s.svg") + section;
    if (run("sheet bored.draw --lines outline,boundary,crease" + options) == 2) break;
    const std::string whole = read(folder_ / "s.svg");
    ASSERT_EQ(run("sheet bored.draw --lines all" + options), 0) << err_;
    EXPECT_TRUE(read(folder_ / "s.svg") == whole) << section;
  }
  write("bent.obj", "v 0 0 0\nv 40 0 0\nv 40 40 9\nv 0 40 0\nf 1 2 3 4\n");
  ASSERT_EQ(run("sheet bent.obj -o s.svg --lines all"), 0) << err_;
  const std::string bent = read(folder_ / "s.svg");
  ASSERT_EQ(run("sheet bent.obj -o s.svg --lines boundary"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "s.svg") == bent);
}

/// A picture has no lines along them.
TEST_F(SheetCommandTest, EndsThatACuttingPlaneLeavesAreLines) {
  write("box.draw",
        "set-cutting-plane 1 -1 0 0 30\nopen-segment 1\nbox-3 0 40 0 20 0 10\nclose-segment\n");
  ASSERT_EQ(run("sheet box.draw -o s.svg --scale 1:1"), 0) << err_;
  int upright = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "VISIBLE"))) {
    upright +=
        std::abs(stroke[2] - stroke[0]) < 1e-9 && std::abs(stroke[3] - stroke[1] - 20.0) < 1e-9;
  }
  EXPECT_EQ(upright, 2 + 2);  // of the front and the side view
}

TEST_F(SheetCommandTest, LinesAreWhereMaterialsDiffer) {
  write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  write("two.obj",
        "mtllib two.mtl\nv 0 0 0\nv 10 0 0\nv 20 0 0\nv 20 10 9\nv 10 10 9\nv 0 10 9\n"
        "usemtl red\nf 1 2 5 6\nusemtl blue\nf 2 3 4 5\n");
  ASSERT_EQ(run("sheet two.obj -o s.svg --scale 1:1 --lines material"), 0) << err_;
  EXPECT_EQ(strokes_of(path_of("s.svg", "VISIBLE")).size(), 4U);  // one a view
  ASSERT_EQ(run("sheet two.obj -o s.svg --scale 1:1 --lines material --section top=5"), 0) << err_;
  EXPECT_EQ(strokes_of(path_of("s.svg", "VISIBLE")).size(), 4U);
}

TEST_F(SheetCommandTest, ATitleIsWellFormedInXml) {
  ASSERT_EQ(run("sheet box.obj -o s.svg --title 'a]]>b <&'"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>a]]&gt;b &lt;&amp;</title>"), std::string::npos);
}

/// In DXF `%%c` is a diameter sign and `\U+0041` an A.
TEST_F(SheetCommandTest, ATitleInDxfIsWhatItSays) {
  if (run("sheet box.obj -o s.dxf --title '50% 9%%c \\U+0041 \\x \xF0\x9F\x98\x80 \xC3\xA9'") ==
      2) {
    GTEST_SKIP() << err_;
  }
  EXPECT_NE(
      read(folder_ / "s.dxf").find("50% 9%%%%%%c \\U+005CU+0041 \\x \\U+D83D\\U+DE00 \\U+00E9"),
      std::string::npos);
}

TEST_F(SheetCommandTest, WhatIsLeftOutIsToldWithTheNameOnce) {
  write("glass.mtl", "newmtl glass\nd 0.5\n");
  write("glass.obj", "mtllib glass.mtl\nusemtl glass\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
  ASSERT_EQ(run("sheet glass.obj -o s.svg"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("glass.obj: left out: ")) << err_;
}

TEST_F(SheetCommandTest, ALimitSuggestsNothingThatASheetHasNot) {
  write("two.draw",
        "open-segment 1\nbox-3 0 40 0 20 0 20\nbox-3 10 30 -10 30 5 15\nclose-segment\n");
  expect_error("sheet two.draw -o s.svg --limit-pieces 3",
               "3 pieces are not enough: expected a higher limit of pieces");
  EXPECT_EQ(err_.find("pixels"), std::string::npos) << err_;
}

TEST_F(SheetCommandTest, WritesPdfAndDxf) {
  ASSERT_EQ(run("sheet box.obj -o box.pdf"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "box.pdf").starts_with("%PDF"));
  if (run("sheet box.obj -o box.dxf --section front=10") == 2) {
    EXPECT_NE(err_.find("libdxflib-dev"), std::string::npos) << err_;
    return;
  }
  const std::string dxf = read(folder_ / "box.dxf");
  for (const char* word : {"VISIBLE", "HIDDEN", "HATCH", "FRAME", "DASHEDTINY", "$INSUNITS"}) {
    EXPECT_NE(dxf.find(word), std::string::npos) << word;
  }
}

/// Programs that read DXF begin dashes anew at each side of a polyline: a curve's hidden ones are
/// its dashes themselves.
TEST_F(SheetCommandTest, HiddenCurvesAreDashedInDxf) {
  write("ring.draw",
        "open-segment 1\nturn-3 90  9 -10  20 -10  20 10  9 10  9 4  15 4  15 -4  9 -4\n"
        "close-segment\n");
  if (run("sheet ring.draw -o ring.dxf") == 2) GTEST_SKIP() << err_;
  std::istringstream dxf(read(folder_ / "ring.dxf"));
  std::size_t dashes = 0, curves = 0;
  std::string entity, layer;
  for (std::string code, value; std::getline(dxf, code) && std::getline(dxf, value);) {
    const int number = std::stoi(code);
    if (!value.empty() && value.back() == '\r') value.pop_back();
    if (number == 0) entity = value;
    if (number == 8) layer = value;
    if (number != 6 || layer != "HIDDEN") continue;
    dashes += value == "CONTINUOUS";
    curves += entity == "POLYLINE" && value == "BYLAYER";
  }
  EXPECT_GT(dashes, 40U);
  EXPECT_EQ(curves, 0U);
}

TEST_F(SheetCommandTest, AProgramSaysWhichAxisIsUp) {
  const std::string box = "open-segment 1\nbox-3 0 10 0 20 0 40\nclose-segment\n";
  write("y.draw", box);
  write("z.draw", "set-view-plane-normal 0 1 0\nset-parallel 0 1 0\nset-view-up 0 0 2\n" + box);
  const auto sheet = [&](const std::string& arguments) {
    EXPECT_EQ(run("sheet " + arguments + " --title box -o s.svg"), 0) << err_;
    return read(folder_ / "s.svg");
  };
  EXPECT_TRUE(sheet("z.draw") == sheet("y.draw --up z"));
  EXPECT_TRUE(sheet("z.draw") != sheet("y.draw"));
  EXPECT_TRUE(sheet("z.draw --up y") == sheet("y.draw"));
}

TEST_F(SheetCommandTest, ATitleFromANameThatIsNoTextIsDrawnAsOne) {
  fs::copy_file(folder_ / "box.obj", folder_ / "b\xff\x01x.obj");
  ASSERT_EQ(run("sheet 'b\xff\x01x.obj' -o s.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>b??x</title>"), std::string::npos);
}

TEST_F(SheetCommandTest, EveryOptionHasItsMessage) {
  expect_error("sheet box.obj -o box.png", "box.png: expected a sheet that ends in .svg, .pdf or");
  expect_error("sheet box.obj -o s.svg --paper a9", "unknown paper 'a9'");
  expect_error("sheet box.obj -o s.svg --margin 200", "margins of 200 mm");
  expect_error("sheet box.obj -o s.svg --scale 1", "--scale 1: expected PAPER:PART");
  expect_error("sheet box.obj -o s.svg --scale 1:0", "--scale 1:0: expected PAPER:PART");
  expect_error("sheet box.obj -o s.svg --scale 50:1", "--scale 50:1: the views do not fit");
  expect_error("sheet box.obj -o s.svg --projection second", "expected third or first");
  expect_error("sheet box.obj -o s.svg --unit foot", "--unit foot: expected mm, cm, m or inch");
  expect_error("sheet box.obj -o s.svg --section back=1", "--section back=1: expected front=");
  expect_error("sheet box.obj -o s.svg --section front=nan", "--section front=nan: expected");
  expect_error("sheet box.obj -o s.svg --section top=1 --section top=2", "has a section already");
  expect_error("sheet box.obj -o s.svg --hatch 0", "--hatch 0: expected");
  expect_error("sheet box.obj -o s.svg --hatch fine", "--hatch: fine: expected a number");
  expect_error("sheet box.obj -o s.svg --margin -1", "margins of -1 mm");
  expect_error("sheet box.obj -o s.svg --paper 30x30", "no room for four views");
  expect_error("sheet box.obj -o s.svg --threads 0", "--threads");
  expect_error("sheet box.obj -o s.svg --title", "--title");
  expect_error("sheet box.obj -o s.svg --date", "--date");
  expect_error("sheet box.obj -o s.svg --title 'a\x01'", "--title: character U+0001 in a text");
  expect_error("sheet box.obj -o s.svg --date '\xff'", "--date: byte 0xff in a text");
  expect_error("sheet box.obj -o no/s.svg", "no/s.svg: cannot be written");
  expect_error("sheet box.obj -o s.svg --lines edge", "--lines: expected ");
  expect_error("sheet box.obj -o s.svg --lines outlines", "did you mean 'outline'?");
  expect_error("sheet box.obj -o s.svg --up w", "--up w: expected x, y, z, -x, -y or -z");
  expect_error("sheet box.obj -o s.svg --up auto", "--up auto: expected x, y, z, -x, -y or -z");
  expect_error("sheet none.obj -o s.svg", "none.obj: no such file");
  write("empty.draw", "open-segment 1\nclose-segment\n");
  expect_error("sheet empty.draw -o s.svg", "empty.draw: no polygons");
}

}  // namespace
