// Sections on sheets: cut faces, their hatching, and their marks.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/sheet_fixture.h"

namespace {

TEST_F(SheetCommandTest, SectionsAreHatched) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --section front=10 --section side=5"), 0) << err_;
  EXPECT_EQ(err_, "");
  EXPECT_FALSE(numbers("box.svg", "HATCH").empty());
  EXPECT_NE(read(folder_ / "box.svg").find(">B-B<"), std::string::npos);
}

TEST_F(SheetCommandTest, AFaceWithAHoleIsCutAsItsPartsWithoutHolesAre) {
  write("bridged.obj", plate_with_boss(true));
  write("parts.obj", plate_with_boss(false));
  for (const char* section : {"front=2", "front=-12", "top=3", "top=12", "side=5", "side=20"}) {
    const auto strokes = [&](const std::string& part, const std::string& layer) {
      EXPECT_EQ(run("sheet " + part +
                    ".obj -o s.svg --up z --title plate --hidden-lines all --section " + section),
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
    ASSERT_EQ(run(std::string("sheet -o s.svg --hidden-lines all ") + part), 0) << err_;
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

/// Hatching continues through both, and hides the parts behind it.
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

/// Points in the plane count as before it: a face there is cut if it is nearer to the viewer than
/// the rest of the part.
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
    EXPECT_NE(err_.find("section plane at 15 does not cut the part"), std::string::npos) << err_;
    ASSERT_EQ(run("sheet -o s.svg --section front=5 " + part), 0) << err_;
    EXPECT_EQ(err_.find("does not cut"), std::string::npos) << err_;
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

/// The parts behind a bore or a ring are visible through it, whatever fills or overlaps its hole.
TEST_F(SheetCommandTest, WhatIsBehindAHoleIsSeenThroughIt) {
  const std::string behind =
      "open-segment 1\nbox-3 -10 10 -10 10 -6 -5\nbox-3 -0.4 0.4 -0.4 0.4 -5 -4\n";
  const std::string profile =
      "3 -3  3 3  -1 3  -1 2  -2 2  -2 1  -3 1  -3 -1  -2 -1  -2 -2  -1 -2  -1 -3\n";
  const std::string bush = "begin-solid difference\nbox-3 -9 9 -9 9 -2 2\nextrude-3 -3 3 " +
                           profile + "end-solid\nbegin-solid difference\nextrude-3 -2 2 " +
                           profile + "box-3 -0.75 0.75 -0.75 0.75 -3 3\nend-solid\n";
  const std::string rings =
      "turn-3 24  0.8 -2  9 -2  9 2  0.8 2\nturn-3 24  2 -2  5 -2  5 2  2 2\n";
  for (const std::string& bodies : {bush, rings}) {
    write("part.draw", behind + bodies + "close-segment\n");
    ASSERT_EQ(run("sheet part.draw -o s.svg --scale 1:1 --section front=0"), 0) << err_;
    int of_block = 0;
    for (const Stroke& stroke : strokes_of(path_of("s.svg", "VISIBLE"))) {
      of_block += std::abs(std::hypot(stroke[2] - stroke[0], stroke[3] - stroke[1]) - 0.8) < 1e-6;
    }
    EXPECT_GE(of_block, 4) << bodies;
  }
}

/// The plane touches a ridge: the cut face has no area there, and hides nothing.
TEST_F(SheetCommandTest, ARidgeThatIsTouchedHidesNothing) {
  write("ring.draw",
        "open-segment 1\nbox-3 -10 10 -10 10 -6 -5\nbox-3 8 9 8 9 -5 5\ntorus-3 0 0 0 3 1 8\n"
        "box-3 -1 1 -1 1 -5 -2\nclose-segment\n");
  const auto hidden = [&](const char* front) {
    EXPECT_EQ(run(std::string(
                      "sheet ring.draw -o s.svg --scale 1:1 --hidden-lines all --section front=") +
                  front),
              0);
    int of_box = 0;
    for (const Stroke& stroke : strokes_of(path_of("s.svg", "HIDDEN"))) {
      of_box += std::abs(std::hypot(stroke[2] - stroke[0], stroke[3] - stroke[1]) - 2.0) < 1e-6;
    }
    return of_box;
  };
  EXPECT_EQ(hidden("1"), hidden("1.001"));
}

/// A pin that reaches from a hole into the block around it, its faces turned in or out.
TEST_F(SheetCommandTest, APinInAHoleIsSolidWhicheverWayItIsTurned) {
  const std::string block =
      "open-segment 1\nbegin-solid difference\nbox-3 0 10 0 10 0 10\n"
      "box-3 3.5 6.5 3.5 6.5 -1 11\nend-solid\nclose-segment\nopen-segment 2\n";
  const std::array<std::array<const char*, 4>, 6> faces{{{"3 7 10", "7 7 10", "7 3 10", "3 3 10"},
                                                         {"7 3 0", "7 7 0", "3 7 0", "3 3 0"},
                                                         {"7 3 10", "7 7 10", "7 7 0", "7 3 0"},
                                                         {"3 7 0", "3 7 10", "3 3 10", "3 3 0"},
                                                         {"7 7 0", "7 7 10", "3 7 10", "3 7 0"},
                                                         {"3 3 10", "7 3 10", "7 3 0", "3 3 0"}}};
  const auto hatching = [&](bool reversed) {
    std::string pin;
    for (const auto& face : faces) {
      pin += "polygon-abs-3";
      for (std::size_t k = 0; k < 4; ++k) pin += std::string("  ") + face[reversed ? 3 - k : k];
      pin += "\n";
    }
    write("pin.draw", block + pin + "close-segment\n");
    EXPECT_EQ(run("sheet pin.draw -o s.svg --scale 1:1 --section front=5"), 0) << err_;
    return path_of("s.svg", "HATCH");
  };
  EXPECT_EQ(hatching(false), hatching(true));
}

/// Segments that a program deletes are those of the inputs before it.
TEST_F(SheetCommandTest, AProgramMayDeleteWhatAnotherOneEntered) {
  write("a.draw", "open-segment 1\nbox-3 0 4 0 4 0 4\nclose-segment\n");
  write("b.draw", "delete-segment 1\nopen-segment 1\nbox-3 0 8 0 4 0 4\nclose-segment\n");
  ASSERT_EQ(run("sheet a.draw b.draw --title one -o s.svg"), 0) << err_;
  write("c.draw", "open-segment 1\nbox-3 0 8 0 4 0 4\nclose-segment\n");
  ASSERT_EQ(run("sheet c.draw --title one -o t.svg"), 0) << err_;
  EXPECT_EQ(path_of("s.svg", "VISIBLE"), path_of("t.svg", "VISIBLE"));
}

}  // namespace
