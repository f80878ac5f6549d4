// --explode by the command.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

/// Pictures of 100 x 100 pixels, seen along -z: (x, y) is the pixel (x, 100 - y).
class ExplodeCommand : public Command {
 protected:
  ExplodeCommand() {
    write("view.draw", "set-window 0 100 0 100\nset-line-style none\n");
    write("three.draw", "set-window 0 100 0 100\nset-line-style none\n" +
                            segment(1, 10, 20, 0, 10) + segment(2, 20, 40, 0, 10) +
                            segment(3, 10, 40, 10, 15));
  }

  static std::string rectangle(int x0, int x1, int y0, int y1) {
    return fmt::format("polygon-abs-2 {0} {2}  {1} {2}  {1} {3}  {0} {3}\n", x0, x1, y0, y1);
  }
  static std::string segment(int name, int x0, int x1, int y0, int y1) {
    return fmt::format("open-segment {}\n{}close-segment\n", name, rectangle(x0, x1, y0, y1));
  }
  /// The picture's fills, as they are without hidden-surface removal, in order.
  std::vector<std::string> fills(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments + " -o a.svg --size 100x100 --hidden none"), 0) << err_;
    const std::string svg = read(folder_ / "a.svg");
    std::vector<std::string> all;
    for (auto at = svg.find("<path class=\"f"); at != svg.npos;
         at = svg.find("<path class=\"f", at + 1)) {
      const auto data = svg.find(" d=\"", at) + 4;
      all.push_back(svg.substr(data, svg.find('"', data) - data));
    }
    return all;
  }
  std::string::difference_type strokes() const {
    const std::string svg = read(folder_ / "a.svg");
    std::string::difference_type n = 0;
    for (auto at = svg.find("<path class=\"l"); at != svg.npos;
         at = svg.find("<path class=\"l", at + 1))
      ++n;
    return n;
  }
};

/// Along x the parts are 10, 20 and 30 long: gaps of half of their mean, 20, follow each.
TEST_F(ExplodeCommand, PartsAreMovedAlongAnAxisInTheirOrder) {
  const std::vector<std::string> before = fills("three.draw");
  ASSERT_EQ(before.size(), 3u);
  EXPECT_EQ(before[0], "M10 90l0 10 10 0 0-10Z");
  EXPECT_EQ(strokes(), 0);
  // The first begins at 10 and ends at 20; so does the third begin at 10, but it ends at 40.
  const std::vector<std::string> after = fills("three.draw --explode x");
  ASSERT_EQ(after.size(), 3u);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[2], "M30 85l0 5 30 0 0-5Z");    // from 20 + 10 to 60
  EXPECT_EQ(after[1], "M70 90l0 10 20 0 0-10Z");  // from 60 + 10 to 90
  EXPECT_GT(strokes(), 3);
  // Trace lines begin where the parts before them would have taken their part along.
  const std::string svg = read(folder_ / "a.svg");
  EXPECT_NE(svg.find("d=\"M25 87.5l"), svg.npos) << svg;
  EXPECT_NE(svg.find("d=\"M50 95l"), svg.npos) << svg;
  EXPECT_EQ(svg.find("d=\"M30 95l"), svg.npos);
  EXPECT_EQ(fills("three.draw --explode x=0.5"), after);
  const std::vector<std::string> farther = fills("three.draw --explode x=0.75");
  EXPECT_EQ(farther[2], "M35 85l0 5 30 0 0-5Z");
  EXPECT_EQ(err_, "");
}

/// Planes cut the parts where they are assembled, and move with them; trace lines are not cut.
TEST_F(ExplodeCommand, CutPartsAreMovedAsTheyAreCut) {
  const std::string parts = segment(1, 10, 50, 0, 10) + segment(2, 10, 54, 10, 20);
  const std::string plane = "set-window 0 100 0 100\nset-line-style none\nset-cutting-plane 1 ";
  write("right.draw", plane + "1 0 0 -40\n" + parts);
  EXPECT_EQ(fills("right.draw --explode x=1"),
            (std::vector<std::string>{"M40 90l0 10 10 0 0-10Z", "M62 80l0 10 14 0 0-10Z"}));
  EXPECT_EQ(fills("right.draw --explode -x=1"),
            (std::vector<std::string>{"M18 90l0 10 10 0 0-10Z", "M40 80l0 10 14 0 0-10Z"}));
  EXPECT_GT(strokes(), 1);
  write("low.draw", plane + "0 -1 0 15\n" + parts);
  EXPECT_EQ(fills("low.draw --explode y=2"),
            (std::vector<std::string>{"M10 90l0 10 40 0 0-10Z", "M54 70l-44 0 0 5 44 0Z"}));
  // A plane that is set within a segment moves with it too.
  write("later.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 10, 30, 0, 10) +
                          "open-segment 2\nset-cutting-plane 1 0 -1 0 15\n" +
                          rectangle(10, 30, 10, 20) + "close-segment\n");
  EXPECT_EQ(fills("later.draw --explode y=2").at(1), "M30 70l-20 0 0 5 20 0Z");
}

/// A part that is farther away keeps its distance from the one before it, and the gap is added.
TEST_F(ExplodeCommand, DistancesStay) {
  write("apart.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 0, 10, 0, 10) +
                          segment(2, 10, 20, 0, 10) + segment(3, 50, 60, 0, 10));
  const std::vector<std::string> moved = fills("apart.draw --explode x");
  ASSERT_EQ(moved.size(), 3u);
  EXPECT_EQ(moved[1], "M15 90l0 10 10 0 0-10Z");
  EXPECT_EQ(moved[2], "M60 90l0 10 10 0 0-10Z");
}

TEST_F(ExplodeCommand, TheOtherWayTheLastStays) {
  write("right.draw", "set-window -100 0 0 100\nset-line-style none\n" +
                          segment(1, -30, -20, 0, 10) + segment(2, -20, -10, 0, 10));
  const std::vector<std::string> moved = fills("right.draw --explode -x=2");
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0], "M50 90l0 10 10 0 0-10Z");  // its end from 80 to 60
  EXPECT_EQ(moved[1], "M80 90l0 10 10 0 0-10Z");
}

/// Parts that are named come first, in that order; gaps are half of the parts' mean length, 20.
TEST_F(ExplodeCommand, PartsAreInTheOrderThatIsSet) {
  const std::vector<std::string> before = fills("three.draw");
  const std::vector<std::string> after = fills("three.draw --explode x:2,1");
  ASSERT_EQ(after.size(), 3u);
  EXPECT_EQ(after[1], before[1]);                 // from 20 to 40
  EXPECT_EQ(after[0], "M50 90l0 10 10 0 0-10Z");  // 10 after it
  EXPECT_EQ(after[2], "M70 85l0 5 30 0 0-5Z");
  EXPECT_EQ(fills("three.draw --explode x=0.5:2"), fills("three.draw --explode x:2,1,3"));
  EXPECT_EQ(fills("three.draw --explode x:1,3,2"), fills("three.draw --explode x"));
  write("lid.draw", segment(1, 10, 20, 0, 10));
  write("base.draw", segment(1, 10, 20, 10, 30));
  const std::vector<std::string> inputs =
      fills("view.draw lid.draw base.draw --explode y:base,lid");
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[1], "M10 70l0 20 10 0 0-20Z");
  EXPECT_EQ(inputs[0], "M10 52.5l0 10 10 0 0-10Z");
  write("named.draw", read(folder_ / "three.draw") + "set-segment-title 2 \"Cover plate\"\n");
  EXPECT_EQ(fills("named.draw --explode 'x:Cover plate,1'"), after);
  expect_error("draw three.draw -o a.svg --explode x:2,4",
               "--explode x:2,4: no part has the name 4: expected some of 1, 2, 3");
  expect_error("draw three.draw -o a.svg --explode x:2,1,2", "2 is there twice");
}

/// The middles of the boxes are 15, 30 and 25 in x and 5, 5 and 12.5 in y; that of all is
/// (25, 7.5).
TEST_F(ExplodeCommand, PartsAreMovedAwayFromTheMiddle) {
  write("centre.draw", "set-window -50 50 -50 50\nset-line-style none\n" +
                           segment(1, -10, 0, 0, 10) + segment(2, 0, 10, 0, 10));
  const std::vector<std::string> moved = fills("centre.draw --explode radial");
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0], "M35 40l0 10 10 0 0-10Z");
  EXPECT_EQ(moved[1], "M55 40l0 10 10 0 0-10Z");
  EXPECT_EQ(fills("centre.draw --explode radial=3")[0], "M25 40l0 10 10 0 0-10Z");
}

/// Each of several inputs is a part, with all of its segments.
TEST_F(ExplodeCommand, InputsAreParts) {
  write("one.draw", segment(1, 10, 20, 0, 10) + segment(2, 20, 30, 0, 10));
  write("two.draw", segment(3, 10, 30, 10, 20));
  write("nothing.draw", "# no segment\nopen-segment 9\nclose-segment\n");
  const std::vector<std::string> moved =
      fills("view.draw one.draw nothing.draw two.draw --explode y=1");
  ASSERT_EQ(moved.size(), 3u);
  EXPECT_EQ(moved[0], "M10 90l0 10 10 0 0-10Z");
  EXPECT_EQ(moved[1], "M20 90l0 10 10 0 0-10Z");
  EXPECT_EQ(moved[2], "M10 70l0 10 20 0 0-10Z");
}

/// Whatever transformation is in force where a segment is drawn.
TEST_F(ExplodeCommand, TransformationsActBefore) {
  write("turned.draw",
        "set-window 0 100 0 100\nset-line-style none\ntranslate-3 10 0 0\nsave-transformation-3\n" +
            segment(1, 0, 10, 0, 10) + "rotate-z-3 90\nopen-segment 2\n" +
            rectangle(0, 10, -20, -10) + "create-transformation-3\n" + rectangle(10, 20, 10, 20) +
            "restore-transformation-3\nclose-segment\n");
  const std::vector<std::string> before = fills("turned.draw"),
                                 moved = fills("turned.draw --explode x=1");
  ASSERT_EQ(moved.size(), 3u);
  EXPECT_EQ(moved[0], before[0]);
  EXPECT_EQ(before[1].substr(0, 4), "M20 ");
  EXPECT_EQ(before[2].substr(0, 4), "M20 ");
  EXPECT_EQ(moved[1].substr(0, 4), "M30 ") << moved[1];  // they are 10 long: a gap of 10
  EXPECT_EQ(moved[2].substr(0, 4), "M30 ") << moved[2];
}

TEST_F(ExplodeCommand, ObjectsOfAMeshArePartsAndAreInThePicture) {
  const auto cube = [](const std::string& name, int z) {
    std::string text = "o " + name + "\n";
    for (int k = 0; k < 8; ++k)
      text += fmt::format("v {} {} {}\n", k & 1, k >> 1 & 1, z + (k >> 2));
    return text +
           "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 "
           "-3\n";
  };
  write("cubes.obj", cube("low", 0) + cube("middle", 1) + cube("high", 2));
  for (const std::string options : {"-o a.svg", "-o a.svg --pens", "-o a.png", "-o a.pdf",
                                    "-o a.png --hidden z-buffer --turntable 2"}) {
    ASSERT_EQ(run("draw cubes.obj --up z --explode z " + options), 0) << options << err_;
    EXPECT_EQ(err_, "") << options;
  }
  // The fitted view holds all three: the picture with a factor of 5 is another, but none is cut
  // off.
  ASSERT_EQ(
      run("draw cubes.obj --up z --explode z=5 -o a.png --ids a.npy --size 64x64 --lines crease"),
      0);
  const std::string ids = read(folder_ / "a.npy");
  std::vector<bool> seen(18);
  for (std::size_t at = 128; at + 4 <= ids.size(); at += 4) {
    const auto id = static_cast<unsigned char>(ids[at]);
    if (id < seen.size() && ids[at + 3] == 0) seen[id] = true;
  }
  for (std::size_t part = 0; part < 3; ++part) {
    EXPECT_GE(std::count(seen.begin() + static_cast<std::ptrdiff_t>(6 * part),
                         seen.begin() + static_cast<std::ptrdiff_t>(6 * part + 6), true),
              3)
        << part;
  }
}

TEST_F(ExplodeCommand, WhatCannotBeMovedApartIsRefused) {
  write("alone.draw", segment(1, 0, 1, 0, 1));
  expect_error("draw alone.draw -o a.svg --explode z",
               "--explode z: alone.draw is one part: expected");
  write("none.draw", "set-window 0 1 0 1\n");
  expect_error("draw none.draw -o a.svg --explode z", "none.draw has no part");
  write("same.draw", segment(1, 0, 2, 0, 2) + segment(2, 0, 2, 0, 2));
  expect_error("draw same.draw -o a.svg --explode radial", "the parts have one middle");
  expect_error("draw - -o a.svg --explode z", "standard input can be read once only",
               (folder_ / "same.draw").string());
  for (const std::string word :
       {"w", "xy", "z=", "z=0", "z=-1", "z=nan", "z=1001", "z=1x", "radial=", "radially", "-radial",
        "radial:1", "x:", "x:1,", "x=:1"}) {
    expect_error("draw three.draw -o a.svg --explode=" + word,
                 "--explode " + word + ": expected x, y");
  }
  write("bad.draw", segment(1, 0, 2, 0, 2) + "nonsense\n");
  expect_error("draw bad.draw -o a.svg --explode z", "bad.draw:4:1");
  expect_error("draw three.draw missing.obj -o a.svg --explode z", "missing.obj");
}

/// A program's own view stays.
TEST_F(ExplodeCommand, WhatIsMovedOutOfAViewIsNamed) {
  fills("three.draw --explode x=2");
  EXPECT_EQ(err_,
            "three.draw: --explode x=2 moves segments out of the view that is set: 2: expected a "
            "larger window or view depth\n");
  write("out.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 10, 20, 0, 10) +
                        segment(2, 90, 110, 0, 10));  // it was not whole before
  fills("out.draw --explode x");
  EXPECT_EQ(err_, "");
}

/// Annotation moves with its segment; annotation without a part to move with is reported by name.
TEST_F(ExplodeCommand, AnnotationMovesWithItsSegment) {
  const std::string balloon = "set-annotation-size 2 px\nballoon-3 30 5 0 7 \"\" 0 0\n";
  write("with.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 10, 20, 0, 10) +
                         "open-segment 2\n" + rectangle(20, 40, 0, 10) + balloon +
                         "close-segment\n");
  const auto place = [&](const std::string& options) {
    EXPECT_EQ(run("draw with.draw -o a.svg --size 100x100 " + options), 0) << err_;
    const std::string svg = read(folder_ / "a.svg");
    const std::size_t at = svg.rfind(" x=\"", svg.find(">7<")) + 4;
    return std::stod(svg.substr(at));
  };
  const double before = place("");
  EXPECT_EQ(err_, "");
  EXPECT_NEAR(place("--explode x=1") - before, 15.0, 1e-3);
  EXPECT_EQ(err_, "");
  write("apart.draw", "open-segment 9\n" + balloon + "close-segment\n");
  ASSERT_EQ(run("draw three.draw apart.draw -o a.svg --size 100x100 --explode x"), 0) << err_;
  EXPECT_EQ(
      err_,
      "apart.draw: --explode x: annotation of segment 9 stays where it is: expected it in the "
      "segment of its part, or the part's name as the segment's title\n");
  // Its title assigns it to a part: a segment of one input, or one of several inputs.
  write("titled.draw",
        "open-segment 9\n" + balloon + "close-segment\nset-segment-title 9 \"mid\"\n");
  write("names.draw", read(folder_ / "three.draw") + "set-segment-title 2 \"mid\"\n");
  const auto balloon_of = [&](const std::string& arguments) {
    EXPECT_EQ(run("draw view.draw titled.draw -o a.svg --size 100x100 --explode x " + arguments), 0)
        << err_;
    EXPECT_EQ(err_, "");
    const std::string svg = read(folder_ / "a.svg");
    return std::stod(svg.substr(svg.rfind(" x=\"", svg.find(">7<")) + 4));
  };
  EXPECT_NEAR(balloon_of("names.draw"), before + 50.0, 1e-3);
  write("low.draw", segment(1, 10, 20, 0, 10));
  write("mid.draw", segment(1, 20, 40, 0, 10));
  EXPECT_NEAR(balloon_of("low.draw mid.draw"), before + 7.5, 1e-3);
}

/// Two bolts of a lid, which begin elsewhere by a rounding, and a plug of another shape.
TEST_F(ExplodeCommand, EqualPartsSideBySideMoveAlike) {
  const std::string plug =
      "open-segment 4\npolygon-abs-2 40 5e-10  50 5e-10  50 10  45 9  40 10\nclose-segment\n";
  write("bolts.draw", "set-window 0 100 -50 50\nset-line-style none\n" + segment(1, 0, 50, 10, 12) +
                          segment(2, 0, 5, 0, 10) + plug +
                          "open-segment 3\npolygon-abs-2 20 1e-9  25 1e-9  25 10  20 10\n"
                          "close-segment\n");
  const std::vector<std::string> moved = fills("bolts.draw --explode -y=0.5");
  ASSERT_EQ(moved.size(), 4u);
  EXPECT_EQ(moved[0], "M0 38l0 2 50 0 0-2Z");  // begins first
  const auto top_of = [](const std::string& path) {
    const auto space = path.find(' ');
    return std::stod(path.substr(space + 1));
  };
  EXPECT_EQ(top_of(moved[1]), 44.0);  // half of the mean length, 8, after it
  EXPECT_EQ(top_of(moved[3]), 44.0);
  EXPECT_EQ(top_of(moved[2]), 58.0);
  const std::vector<std::string> ordered = fills("bolts.draw --explode -y:1,2,3,4");
  EXPECT_NE(top_of(ordered[1]), top_of(ordered[3]));
}

/// Parts of one place that are one within the other are not side by side, nor those of other shape.
TEST_F(ExplodeCommand, PartsInEachOtherOrOfOtherShapesMoveApart) {
  write("pin.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 10, 30, 0, 10) +
                        segment(2, 15, 25, 0, 10));
  const std::vector<std::string> pin = fills("pin.draw --explode y");
  EXPECT_EQ(pin[0], "M10 90l0 10 20 0 0-10Z");
  EXPECT_EQ(pin[1], "M15 75l0 10 10 0 0-10Z");
  write("other.draw", "set-window 0 100 0 100\nset-line-style none\n" + segment(1, 10, 30, 0, 10) +
                          "open-segment 2\npolygon-abs-2 40 0  50 0  45 10\nclose-segment\n");
  EXPECT_EQ(fills("other.draw --explode y")[1].substr(0, 6), "M45 75");
  write("same.draw", segment(1, 10, 20, 0, 10) + segment(2, 30, 40, 0, 10));
  expect_error("draw same.draw -o a.svg --explode y",
               "--explode y: the parts are equal and side by side: expected another axis, radial, "
               "or an order such as y:1,2");
}

/// Flat parts, each in one plane, have no length along the axis: their size replaces it.
TEST_F(ExplodeCommand, FlatPartsAreMovedTooByTheirSize) {
  write("flat.draw", "set-window 0 100 0 100\nset-line-style none\nset-parallel 0 1 -1\n" +
                         segment(1, 10, 13, 10, 14) + segment(2, 10, 13, 10, 14));
  const std::vector<std::string> moved = fills("flat.draw --explode z=1");
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_NE(moved[0], moved[1]);
}

}  // namespace
