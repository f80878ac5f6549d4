// Sheets as draughtsmen draw them: hidden lines by view, hatching of neighbours, whole parts in
// sections, centre lines, details, parts lists, and arcs in DXF.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/sheet_fixture.h"

namespace {

class SheetDrafting : public SheetCommandTest {
 protected:
  std::vector<Stroke> strokes(const std::string& layer) {
    return strokes_of(path_of("s.svg", layer));
  }

  void draw(const std::string& arguments) {
    ASSERT_EQ(run("sheet -o s.svg " + arguments), 0) << err_;
    EXPECT_EQ(err_, "");
  }
  /// A program of one segment for each text.
  void write_segments(const std::string& file, const std::vector<std::string>& segments) {
    std::string program;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      program += "open-segment " + std::to_string(i + 1) + "\n" + segments[i] + "close-segment\n";
    }
    write(file, program);
  }

  /// Hatching of the boxes of a row, in a section at 1:1: each box's directions and spacings.
  struct Hatch {
    std::set<bool> rises;
    double spacing = 0.0;
  };
  /// `ends` are the boxes' ends from left to right, from the left end of the first.
  std::vector<Hatch> hatches(const std::vector<std::array<double, 2>>& ends) {
    double left = 1e9;
    for (const Stroke& s : strokes("HATCH")) left = std::min(left, s[0]);
    std::vector<Hatch> all;
    for (const auto& [from, to] : ends) {
      Hatch& hatch = all.emplace_back();
      std::set<double> places;
      for (const Stroke& s : strokes("HATCH")) {
        if (0.5 * (s[0] + s[2]) < left + from || 0.5 * (s[0] + s[2]) > left + to) continue;
        const bool rises = s[3] < s[1];  // y runs down in SVG
        hatch.rises.insert(rises);
        places.insert((rises ? s[0] + s[1] : s[0] - s[1]) / std::sqrt(2.0));
      }
      double before = 0.0;
      for (const double place : places) {
        if (before != 0.0) hatch.spacing = place - before;
        before = place;
      }
    }
    return all;
  }
  double length(const std::vector<Stroke>& strokes) {
    double sum = 0.0;
    for (const Stroke& s : strokes) sum += std::hypot(s[2] - s[0], s[3] - s[1]);
    return sum;
  }
  std::size_t count_of_length(const std::string& layer, double wanted) {
    std::size_t count = 0;
    for (const Stroke& s : strokes(layer)) {
      count += std::abs(std::hypot(s[2] - s[0], s[3] - s[1]) - wanted) < 1e-4;
    }
    return count;
  }

  /// An entity of a DXF file: its groups except its handle.
  using Entity = std::map<int, std::string>;
  std::vector<Entity> entities(const std::string& file, const std::string& kind) {
    std::istringstream dxf(read(folder_ / file));
    std::vector<Entity> all;
    bool is_of_kind = false;
    for (std::string code, value; std::getline(dxf, code) && std::getline(dxf, value);) {
      if (!value.empty() && value.back() == '\r') value.pop_back();
      const int group = std::stoi(code);
      if (group == 0) is_of_kind = value == kind;
      if (group == 0 && is_of_kind) all.emplace_back();
      if (is_of_kind) all.back()[group] = value;
    }
    return all;
  }
};

constexpr const char* kRing = "turn-3 72  9 -10  20 -10  20 10  9 10\n";
constexpr const char* kShaft = "cylinder-3 0 0 -30 9 60 72\n";

TEST_F(SheetDrafting, HiddenLinesAreInViewsThatAreNeitherCutNorIsometric) {
  write_segments("a.draw", {"box-3 0 40 0 20 0 10\n", "box-3 5 10 5 10 -5 0\n"});
  const auto hidden = [&](const std::string& arguments) {
    draw("a.draw --scale 1:1 " + arguments);
    return strokes("HIDDEN").size();
  };
  const std::size_t of_all = hidden("--hidden-lines all");
  const std::size_t of_front = hidden("--hidden-lines front"),
                    of_top = hidden("--hidden-lines top"), of_side = hidden("--hidden-lines side"),
                    of_isometric = hidden("--hidden-lines isometric");
  EXPECT_EQ(of_front, 4U);
  EXPECT_GT(of_isometric, 4U);
  EXPECT_EQ(of_front + of_top + of_side + of_isometric, of_all);
  EXPECT_EQ(hidden(""), of_front + of_top + of_side);
  EXPECT_EQ(hidden("--hidden-lines dashed"), of_all);
  EXPECT_EQ(hidden("--hidden-lines none"), 0U);
  EXPECT_EQ(hidden("--hidden-lines front,isometric"), of_front + of_isometric);
  EXPECT_EQ(hidden("--section front=5"), of_top + of_side);
  EXPECT_EQ(hidden("--section front=5 --hidden-lines front"), 4U);
  for (const char* word : {"back", "front,", "all,front", "frontal"}) {
    expect_error(
        std::string("sheet a.draw -o s.svg --hidden-lines ") + word,
        std::string("--hidden-lines ") + word + ": expected all or none, or some of front,");
  }
}

TEST_F(SheetDrafting, VisibleLinesAreTheSameWithoutHiddenOnes) {
  write_segments("a.draw", {"box-3 0 40 0 20 0 10\n", "torus-3 10 10 5 12 4 24\n"});
  const auto visible = [&](const std::string& arguments) {
    draw("a.draw " + arguments);
    auto all = strokes("VISIBLE");
    std::ranges::sort(all);
    return all;
  };
  EXPECT_EQ(visible("--hidden-lines all"), visible("--hidden-lines none"));
}

TEST_F(SheetDrafting, NeighboursAreHatchedInDifferentDirections) {
  write_segments("row.draw",
                 {"box-3 0 20 0 20 0 10\n", "box-3 20 40 0 20 0 10\n", "box-3 40 60 0 20 0 10\n"});
  draw("row.draw --scale 1:1 --section front=5");
  const auto all = hatches({{0, 20}, {20, 40}, {40, 60}});
  EXPECT_EQ(all[0].rises, std::set{true});
  EXPECT_EQ(all[1].rises, std::set{false});
  EXPECT_EQ(all[2].rises, std::set{true});
  for (const Hatch& hatch : all) EXPECT_NEAR(hatch.spacing, 2.0, 1e-3);
}

/// If three bodies touch each other, the third has a wider spacing.
TEST_F(SheetDrafting, NeighboursAreHatchedInDifferentSpacings) {
  write_segments("three.draw",
                 {"box-3 0 20 0 10 0 10\n", "box-3 20 40 0 10 0 10\n", "box-3 0 40 10 40 0 10\n"});
  draw("three.draw --scale 1:1 --section front=5");
  std::map<bool, std::set<double>> places;
  for (const Stroke& s : strokes("HATCH")) {
    const bool rises = s[3] < s[1];
    places[rises].insert((rises ? s[0] + s[1] : s[0] - s[1]) / std::sqrt(2.0));
  }
  std::set<double> spacings;
  for (const auto& [rises, of_direction] : places) {
    for (auto at = of_direction.begin(); std::next(at) != of_direction.end(); ++at) {
      spacings.insert(std::round(1e3 * (*std::next(at) - *at)) / 1e3);
    }
  }
  EXPECT_TRUE(spacings.contains(2.0));
  EXPECT_TRUE(spacings.contains(3.0) || spacings.contains(1.0));  // 3, and where both are in a row
  EXPECT_EQ(places.size(), 2U);
}

/// As near on paper as twice the spacing of the hatching.
TEST_F(SheetDrafting, WhatStandsSideBySideIsHatchedAsNeighboursAre) {
  write_segments("gap.draw", {"box-3 0 20 0 20 0 10\n", "box-3 23 43 0 20 0 10\n"});
  const auto alike = [&](const std::string& arguments, double scale) {
    draw("gap.draw --section front=5 " + arguments);
    const auto all = hatches({{0, 20 * scale}, {23 * scale, 43 * scale}});
    return all[0].rises == all[1].rises;
  };
  EXPECT_FALSE(alike("--scale 1:1", 1.0));
  EXPECT_TRUE(alike("--scale 2:1", 2.0));
  EXPECT_FALSE(alike("--scale 2:1 --hatch 4", 2.0));
}

TEST_F(SheetDrafting, APartIsHatchedAlikeInAllViews) {
  write_segments("two.draw", {"box-3 0 20 0 20 0 10\n", "box-3 20 40 0 20 0 10\n"});
  draw("two.draw --scale 1:1 --section side=30");
  EXPECT_EQ(hatches({{0, 10}})[0].rises, std::set{true});  // by itself
  draw("two.draw --scale 1:1 --section side=30 --section front=5");
  EXPECT_EQ(hatches({{0, 20}})[0].rises, std::set{true});
  EXPECT_EQ(hatches({{20, 40}})[0].rises, std::set{false});
  EXPECT_EQ(hatches({{41, 400}})[0].rises, std::set{false});  // the side view
}

/// The second body of the second part has no neighbour, and is hatched as its first.
TEST_F(SheetDrafting, BodiesOfAPartAreHatchedAlike) {
  const std::string first = "box-3 0 20 0 20 0 10\n", beside = "box-3 20 40 0 20 0 10\n",
                    apart = "box-3 60 80 0 20 0 10\n";
  const auto rises_apart = [&](const std::vector<std::string>& segments) {
    write_segments("parts.draw", segments);
    draw("parts.draw --scale 1:1 --section front=5");
    return hatches({{60, 80}})[0].rises;
  };
  EXPECT_EQ(rises_apart({first, beside + apart}), std::set{false});
  EXPECT_EQ(rises_apart({first, beside, apart}), std::set{true});
}

/// A pin of fewer facets than its hole reaches into it by a little, and a hollow is no neighbour.
TEST_F(SheetDrafting, AFilledHollowHasANeighbourInIt) {
  write_segments("pin.draw", {kRing, "cylinder-3 0 0 -10 9 20 48\n"});
  draw("pin.draw --scale 1:1 --section side=0");
  const auto all = hatches({{0, 20}});
  EXPECT_EQ(all[0].rises.size(), 2U);
}

TEST_F(SheetDrafting, AWholePartIsNotHatched) {
  write("ring.draw", std::string("open-segment 1\n") + kRing + "close-segment\n");
  write("shaft.draw", std::string("open-segment 1\n") + kShaft + "close-segment\n");
  draw("ring.draw --scale 1:1 --section side=0");
  const double of_ring = length(strokes("HATCH"));
  draw("ring.draw shaft.draw --scale 1:1 --section side=0");
  EXPECT_GT(length(strokes("HATCH")), 1.5 * of_ring);
  draw("ring.draw shaft.draw --scale 1:1 --section side=0 --uncut shaft");
  EXPECT_NEAR(length(strokes("HATCH")), of_ring, 0.01 * of_ring);
  EXPECT_EQ(count_of_length("VISIBLE", 60.0), 2U);  // of the shaft in the side view
}

/// A whole part hides cut faces behind it, their outlines and their hatching.
TEST_F(SheetDrafting, AWholePartHidesCutFaces) {
  write_segments("two.draw", {"box-3 0 40 0 20 0 10\n", "box-3 10 20 5 25 3 12\n"});
  draw("two.draw --scale 1:1 --section front=5 --uncut two:2");
  EXPECT_NEAR(2.0 * length(strokes("HATCH")), 40.0 * 20.0 - 10.0 * 15.0, 15.0);
  double left = 1e9;
  for (const Stroke& s : strokes("HATCH")) left = std::min(left, s[0]);
  int above = 0;  // parts of the block's upper edge: it is hidden between 10 and 20
  for (const Stroke& s : strokes("VISIBLE")) {
    if (s[2] > left + 41.0 || std::abs(s[3] - s[1]) > 1e-6) continue;
    above += std::abs(s[2] - s[0] - 10.0) < 0.1 || std::abs(s[2] - s[0] - 20.0) < 0.1;
  }
  EXPECT_EQ(above, (2 + 2) * 2);  // and the other box's ends; as many in the top view
}

/// Where the part behind the cut face is smaller than it, nothing else is drawn there.
TEST_F(SheetDrafting, CutFacesBesideAWholePartHaveOutlines) {
  write_segments("two.draw", {"cone-3 20 20 0 5 10 48 15\n", "box-3 18 22 18 22 3 12\n"});
  draw("two.draw --scale 1:1 --section front=5 --uncut two:2");
  EXPECT_EQ(count_of_length("VISIBLE", 2.0 * 10.0 * std::sin(std::acos(-1.0) / 48.0)), 48U);
}

TEST_F(SheetDrafting, AWholePartBeforeThePlaneIsRemoved) {
  write_segments("two.draw", {"box-3 0 40 0 20 0 10\n", "box-3 5 15 5 15 20 30\n"});
  draw("two.draw --scale 1:1 --section front=5");
  const auto visible = strokes("VISIBLE"), hatch = strokes("HATCH");
  ASSERT_EQ(run("sheet -o s.svg two.draw --scale 1:1 --section front=5 --uncut two:2"), 0) << err_;
  EXPECT_EQ(strokes("VISIBLE"), visible);
  EXPECT_EQ(strokes("HATCH"), hatch);
}

TEST_F(SheetDrafting, WholePartsAreNamed) {
  write("two.obj",
        "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nv 20 0 0\nv 29 0 0\nv 20 9 0\nv 20 0 9\n"
        "o bolt\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\no nut\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n");
  const auto hatched = [&](const std::string& names) {
    draw("two.obj --scale 1:1 --section front=3 --uncut " + names);
    return length(strokes("HATCH"));
  };
  const double of_one = hatched("bolt");
  EXPECT_GT(of_one, 0.0);
  EXPECT_NEAR(hatched("nut"), of_one, 0.2 * of_one);
  EXPECT_EQ(hatched("nut,bolt"), 0.0);
  EXPECT_EQ(hatched("two"), 0.0);
  expect_error("sheet two.obj -o s.svg --section front=3 --uncut nut,screw",
               "--uncut screw: no part has this name: expected some of bolt, nut");
  expect_error("sheet two.obj -o s.svg --uncut nut", "--uncut has no effect without --section");
  expect_error("sheet two.obj -o s.svg --hatch 3", "--hatch has no effect without --section");
  ASSERT_EQ(run("sheet two.obj -o s.svg --section side=3 --uncut nut"), 0);
  EXPECT_NE(err_.find("--uncut nut: no section plane goes through it"), std::string::npos) << err_;
}

/// The view shows the rest of the part: its letters stand below the middle of that, and it stands
/// under the same points of the top view.
TEST_F(SheetDrafting, ACutViewIsPlacedByWhatIsLeft) {
  write_segments("two.draw", {"box-3 10 30 0 20 0 10\n", "box-3 0 100 0 50 20 30\n"});
  draw("two.draw --scale 1:1 --section front=5");
  double left = 1e9, low = 0.0;
  for (const Stroke& s : strokes("HATCH")) {
    left = std::min(left, s[0]);
    low = std::max({low, s[1], s[3]});
  }
  const auto all = texts("s.svg");
  const auto caption = std::ranges::find(all, "A-A", &Text::characters);
  ASSERT_NE(caption, all.end());
  EXPECT_NEAR(caption->x, left + 10.0, 1e-2);
  EXPECT_NEAR(caption->y, low + 7.0, 1e-2);
  int aligned = 0;  // ends of the small box in the top view
  for (const Stroke& s : strokes("VISIBLE")) {
    aligned += std::abs(s[0] - s[2]) < 1e-6 && std::abs(s[3] - s[1] - 10.0) < 1e-4 &&
               (std::abs(s[0] - left) < 1e-2 || std::abs(s[0] - left - 20.0) < 1e-2);
  }
  EXPECT_EQ(aligned, 2);
}

/// Three views that are cut show only the rest, and so have a larger scale.
TEST_F(SheetDrafting, ACutAssemblyHasTheScaleOfWhatIsLeft) {
  write_segments("two.draw", {"box-3 0 24 0 24 0 24\n", "box-3 36 110 36 110 36 110\n"});
  const auto scale = [&](const std::string& arguments) {
    draw("two.draw " + arguments);
    const auto all = texts("s.svg");
    return std::next(std::ranges::find(all, "SCALE", &Text::characters))->characters;
  };
  EXPECT_EQ(scale(""), scale("--section front=10"));
  EXPECT_NE(scale(""), scale("--section front=10 --section top=10 --section side=10"));
}

TEST_F(SheetDrafting, TurnedShapesHaveCentreLines) {
  const auto halves = [&](const std::string& program, const std::string& arguments = "") {
    write_segments("c.draw", {program});
    draw("c.draw --scale 1:1 " + arguments);
    std::map<int, int> counts;  // of tenths of a millimetre
    for (const Stroke& s : strokes("CENTRE")) {
      ++counts[static_cast<int>(std::lround(10.0 * std::hypot(s[2] - s[0], s[3] - s[1])))];
    }
    return counts;
  };
  using Counts = std::map<int, int>;
  const std::string cylinder = "cylinder-3 5 5 0 10 30 48\n";
  const Counts axis_and_cross{{130, 4}, {180, 4}};  // 10 + 3, and 15 + 3
  EXPECT_EQ(halves(cylinder), axis_and_cross);
  EXPECT_EQ(halves("cone-3 5 5 0 10 30 48\n"), axis_and_cross);
  EXPECT_EQ(halves("turn-3 48  4 0  10 0  10 30  4 30\n"), axis_and_cross);
  EXPECT_EQ(halves("rotate-x-3 90\n" + cylinder), axis_and_cross);
  EXPECT_EQ(halves("rotate-z-3 10\n" + cylinder), axis_and_cross);
  EXPECT_EQ(halves("scale-3 2 2 1\ntranslate-3 1 1 1\ncylinder-3 5 5 0 5 30 48\n"), axis_and_cross);
  EXPECT_EQ(halves("sphere-3 0 0 0 10 48\n"), (Counts{{130, 12}}));
  EXPECT_EQ(halves("torus-3 0 0 0 8 2 48\n"), (Counts{{40, 4}, {130, 4}}));
  EXPECT_EQ(halves("scale-3 2 1 1\n" + cylinder), Counts{});  // not round
  EXPECT_EQ(halves("prism-3 5 5 0 10 30 6\n"), Counts{});
  EXPECT_EQ(halves(cylinder, "--centre-lines off"), Counts{});
  EXPECT_EQ(halves(cylinder + cylinder), axis_and_cross);
  expect_error("sheet c.draw -o s.svg --centre-lines no", "--centre-lines no: expected on or off");
}

/// An axis that a section has cut off is not drawn, and none where a cutting line is.
TEST_F(SheetDrafting, CentreLinesOfSections) {
  write_segments("two.draw", {"cylinder-3 0 0 -40 10 20 48\n", "cylinder-3 0 0 0 15 20 48\n"});
  const auto halves = [&](const std::string& arguments) {
    draw("two.draw --scale 1:1 " + arguments);
    return strokes("CENTRE").size();
  };
  EXPECT_EQ(halves(""), 4U + 4U + 4U);  // the crosses have one middle
  EXPECT_EQ(halves("--section front=-30"), 4U + 4U + 4U);
  EXPECT_EQ(count_of_length("CENTRE", 13.0), 4U + 4U + 4U);
  EXPECT_EQ(count_of_length("CENTRE", 18.0), 0U);  // the cross of the one before the plane
  EXPECT_EQ(halves("--section side=0"), 4U + 4U + 2U);
}

/// Axes behind a section are hidden by the cut faces, and by parts that are left whole.
TEST_F(SheetDrafting, CutFacesHideCentreLines) {
  write_segments("behind.draw", {"box-3 -20 20 -20 20 0 10\n", "cylinder-3 0 0 -40 6 20 48\n",
                                 "cylinder-3 22 0 -40 8 20 48\n"});
  const auto draw_lines = [&](const std::string& arguments) {
    draw("behind.draw --scale 1:1 --lines outline " + arguments);
    double sum = 0.0;
    for (const Stroke& s : strokes("CENTRE")) sum += std::hypot(s[2] - s[0], s[3] - s[1]);
    return sum;
  };
  const double whole = draw_lines("");
  // Nothing is left of the first cylinder's cross; of the second's, the part beside the box.
  const double small = 2.0 * (12.0 + 6.0), behind = 20.0 - (22.0 - 8.0 - 3.0);
  EXPECT_NEAR(draw_lines("--section front=5"), whole - small - behind, 1e-3);
  for (const Stroke& s : strokes("CENTRE")) {
    for (const Stroke& h : strokes("HATCH")) EXPECT_LE(overlap(s, h), 1e-6);
  }
  // Nor is a centre line hidden that runs along the view on both sides of the box.
  write_segments("along.draw",
                 {"box-3 -20 20 -20 20 0 10\n",
                  "rotate-y-3 90\ntranslate-3 0 5 -20\ncylinder-3 0 0 -30 6 60 48\n"});
  draw("along.draw --scale 1:1 --section front=5");
  EXPECT_EQ(count_of_length("CENTRE", (10.0 + 3.0) / 2.0), 4U);
  EXPECT_EQ(count_of_length("CENTRE", 30.0 + 3.0), 2U);  // in the top view
  // Nor is that of a shape which the plane cuts beside its axis.
  write_segments("off.draw", {"rotate-y-3 90\ncylinder-3 0 0 -30 10 60 48\n"});
  draw("off.draw --scale 1:1 --section front=4");
  EXPECT_EQ(count_of_length("CENTRE", 30.0 + 3.0), 4U);
  // Shapes that the plane goes through have their own.
  write_segments("through.draw", {"box-3 -20 20 -20 20 0 40\ncylinder-3 0 0 -40 6 42 48\n"});
  draw("through.draw --scale 1:1 --section front=1");
  EXPECT_GE(count_of_length("CENTRE", 6.0 + 3.0), 4U);
}

/// A hole of a solid has the axis of the subtracted shape, as far as the hole goes.
TEST_F(SheetDrafting, HolesHaveCentreLinesAsLongAsTheyAre) {
  write_segments("hole.draw", {"begin-solid difference\nbox-3 -20 20 -20 20 0 12\n"
                               "cylinder-3 0 0 -5 8 50 48\nend-solid\n"});
  if (!can_run("sheet hole.draw -o s.svg --scale 1:1", "needs CGAL")) GTEST_SKIP() << err_;
  EXPECT_EQ(count_of_length("CENTRE", 8.0 + 3.0), 4U);
  EXPECT_EQ(count_of_length("CENTRE", 6.0 + 3.0), 4U);
  write_segments("chords.draw", {"begin-solid intersection\nbox-3 -6 6 -6 6 0 12\n"
                                 "cylinder-3 0 0 -10 10 40 4\nend-solid\n"});
  draw("chords.draw --scale 1:1");
  EXPECT_EQ(count_of_length("CENTRE", 6.0 + 3.0), 4U);  // all vertices are within facets
  write_segments("none.draw", {"begin-solid intersection\nbox-3 -5 5 -5 5 0 12\n"
                               "cylinder-3 0 0 0 30 12 48\nend-solid\n"});
  draw("none.draw");
  EXPECT_TRUE(strokes("CENTRE").empty());  // nothing of the cylinder's surface is left
}

TEST_F(SheetDrafting, ADetailIsDrawnAtItsScale) {
  draw("box.obj --scale 1:1 --detail front=0,0,5@4:1");
  EXPECT_EQ(count_of_length("VISIBLE", 20.0), 2U);  // of the corner's edges
  std::array<double, 4> box{1e9, 1e9, -1e9, -1e9};
  double smallest = 1e9;
  for (const Stroke& s : strokes("DETAIL")) {
    box = {std::min(box[0], s[0]), std::min({box[1], s[1], s[3]}), std::max(box[2], s[2]),
           std::max({box[3], s[1], s[3]})};
    smallest = std::min(smallest, std::hypot(s[2] - s[0], s[3] - s[1]));
  }
  EXPECT_NEAR(smallest, 2.0 * 5.0 * std::sin(std::acos(-1.0) / 180.0), 1e-4);
  const auto all = texts("s.svg");
  EXPECT_EQ(std::ranges::count(all, "X (4:1)", &Text::characters), 1);
  EXPECT_EQ(std::ranges::count(all, "X", &Text::characters), 1);
  draw("box.obj --detail front=0,0,5@4:1 --detail side=-30,0,4@5:1");
  EXPECT_NE(read(folder_ / "s.svg").find(">Y (5:1)<"), std::string::npos);
}

TEST_F(SheetDrafting, ADetailOfASectionIsHatchedAsElsewhere) {
  draw("box.obj --scale 1:1 --section front=10");
  const double whole = length(strokes("HATCH"));
  draw("box.obj --scale 1:1 --section front=10 --detail front=30,20,4@5:1");
  const double of_detail = length(strokes("HATCH")) - whole;
  EXPECT_NEAR(of_detail, std::acos(-1.0) * 20.0 * 20.0 / 2.0, 10.0);
  draw("box.obj --scale 1:1 --section front=10 --detail front=30,20,1e-4@100000:1 --hatch 1");
  EXPECT_LT(strokes("HATCH").size(), 200U);  // only the inside of the circle is hatched
}

TEST_F(SheetDrafting, DetailsHaveRoomOrAreRefused) {
  const auto scale = [&](const std::string& arguments) {
    draw("box.obj " + arguments);
    const auto all = texts("s.svg");
    return std::next(std::ranges::find(all, "SCALE", &Text::characters))->characters;
  };
  EXPECT_EQ(scale(""), "2:1");
  EXPECT_EQ(scale("--detail front=0,0,10@5:1"), "1:1");
  const std::string refused = "--detail: no room on the paper: expected a smaller circle or scale";
  expect_error("sheet box.obj -o s.svg --detail front=0,0,40@5:1", refused);
  expect_error("sheet box.obj -o s.svg --scale 2:1 --detail front=0,0,10@5:1",
               "--scale 2:1: the views do not fit on the paper: expected 1:1 or less");
  const std::string expected =
      "expected front=, top=, side= or isometric= with X,Y,RADIUS@PAPER:PART";
  for (const char* word : {"back=0,0,1@2:1", "front=0,0@2:1", "front=0,0,0@2:1", "front=0,0,1",
                           "front=0,0,1@2", "front=0,0,nan@2:1", "front@2:1=0,0,1"}) {
    expect_error(std::string("sheet box.obj -o s.svg --detail ") + word,
                 std::string("--detail ") + word + ": " + expected);
  }
  expect_error(
      "sheet box.obj -o s.svg --detail front=70,0,5@2:1",
      "--detail front=70,0,5@2:1: nothing of the view is there: expected a circle within 0 "
      "to 60 and 0 to 40");
}

TEST_F(SheetDrafting, PartsAreListed) {
  write("bolt.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  write("gears.draw",
        "open-segment 4\nbox-3 0 4 0 4 0 4\nclose-segment\nopen-segment 7\nbox-3 5 9 0 4 0 4\n"
        "close-segment\nrename-segment 7 8\n");
  draw("box.obj bolt.obj gears.draw bolt.obj --parts-list");
  std::vector<std::string> words;
  for (const Text& text : texts("s.svg")) words.push_back(text.characters);
  const std::vector<std::string> list{"ITEM", "PART", "QTY",     "1", "box", "1",       "2", "bolt",
                                      "2",    "3",    "gears:4", "1", "4",   "gears:7", "1"};
  EXPECT_TRUE(std::search(words.begin(), words.end(), list.begin(), list.end()) != words.end());
  draw("box.obj bolt.obj");
  EXPECT_EQ(read(folder_ / "s.svg").find(">QTY<"), std::string::npos);
}

/// The views keep clear of it.
TEST_F(SheetDrafting, AListOfManyPartsTakesRoom) {
  std::vector<std::string> segments;
  for (int i = 0; i < 12; ++i) {
    const std::string x = std::to_string(10 * i) + " " + std::to_string(10 * i + 8);
    segments.push_back("box-3 " + x + " 0 8 0 8\n");
  }
  write_segments("many.draw", segments);
  draw("many.draw --parts-list");
  double top_of_list = 1e9, low_of_views = 0.0;
  for (const Text& text : texts("s.svg")) {
    if (text.characters == "many:12") top_of_list = text.y;
  }
  for (const Stroke& s : strokes("VISIBLE")) low_of_views = std::max({low_of_views, s[1], s[3]});
  EXPECT_LT(low_of_views, top_of_list - 2.5);
  expect_error("sheet many.draw -o s.svg --parts-list --paper a6",
               "no room for four views above the parts list");
}

TEST_F(SheetDrafting, CirclesAndArcsOfOutlinesAreThatInDxf) {
  const auto draw_dxf = [&](const std::string& program) {
    write_segments("round.draw", {program});
    return can_run("sheet round.draw -o s.dxf --scale 1:1 --centre-lines off --hidden-lines none",
                   "this build has no dxflib, which writes DXF");
  };
  constexpr std::size_t kOfSymbol = 2;
  if (!draw_dxf("cylinder-3 0 0 0 10 30 48\n")) GTEST_SKIP() << err_;
  const auto circles = entities("s.dxf", "CIRCLE");
  ASSERT_EQ(circles.size(), 1U + kOfSymbol);  // of the front view
  EXPECT_EQ(circles[0].at(40), "10");
  EXPECT_EQ(circles[0].at(8), "VISIBLE");
  for (const char* polygon : {"cylinder-3 0 0 0 10 30 12\n", "prism-3 0 0 0 10 30 6\n",
                              "turn-3 22  4 0  10 0  10 30  4 30\n"}) {
    ASSERT_TRUE(draw_dxf(polygon));
    EXPECT_EQ(entities("s.dxf", "CIRCLE").size(), kOfSymbol) << polygon;
    EXPECT_EQ(entities("s.dxf", "ARC").size(), 0U) << polygon;
  }
  std::ostringstream slot;  // half circles of radius 5 about -10 and 10
  slot.precision(17);
  slot << "extrude-3 0 10 ";
  for (const double middle : {10.0, -10.0}) {
    for (int k = 0; k <= 18; ++k) {
      const double angle = (k - 9) * std::acos(-1.0) / 18.0;
      const double sign = middle / 10.0;
      slot << " " << middle + sign * 5.0 * std::cos(angle) << " " << sign * 5.0 * std::sin(angle);
    }
  }
  ASSERT_TRUE(draw_dxf(slot.str() + "\n"));
  const auto arcs = entities("s.dxf", "ARC");
  ASSERT_EQ(arcs.size(), 2U);
  std::set<std::string> angles;
  for (const Entity& arc : arcs) {
    EXPECT_EQ(arc.at(40), "5");
    angles.insert(arc.at(50) + " to " + arc.at(51));
  }
  EXPECT_EQ(angles, (std::set<std::string>{"-90 to 90", "90 to -90"}));
}

/// A polygon whose corners are on a circle, but unevenly, is not a circle; nor is an oval.
TEST_F(SheetDrafting, OnlyFacetsOfCirclesAreCircles) {
  const auto circles = [&](double stretch, bool uneven) {
    std::ostringstream profile;
    profile.precision(17);
    for (int k = 0; k < 40; ++k) {
      const double angle = (k + (uneven && k % 2 == 1 ? 0.3 : 0.0)) * std::acos(-1.0) / 20.0;
      profile << " " << 10.0 * std::cos(angle) << " " << stretch * std::sin(angle);
    }
    write_segments("p.draw", {"extrude-3 0 10 " + profile.str() + "\n"});
    if (!can_run("sheet p.draw -o s.dxf --scale 1:1 --lines all --hidden-lines none",
                 "this build has no dxflib, which writes DXF")) {
      return -1;
    }
    return static_cast<int>(entities("s.dxf", "CIRCLE").size() + entities("s.dxf", "ARC").size());
  };
  const int round = circles(10.0, false);
  if (round < 0) GTEST_SKIP() << err_;
  EXPECT_EQ(round, 3);
  EXPECT_EQ(circles(10.0, true), 2);
  EXPECT_EQ(circles(10.5, false), 2);
  EXPECT_EQ(circles(10.004, false), 2);  // sides and angles as of facets, but off by 2 micrometres
}

TEST_F(SheetDrafting, NumbersHaveFiveDecimalsAtMost) {
  write_segments("c.draw", {"cylinder-3 0 0 0 10.123456789 30 48\n"});
  draw("c.draw --section side=0 --detail front=0,0,3@5:1");
  const std::regex longer("[0-9]\\.[0-9]{6}"), five("[0-9]\\.[0-9]{5}");
  EXPECT_FALSE(std::regex_search(path_of("s.svg", "VISIBLE"), longer));
  EXPECT_TRUE(std::regex_search(path_of("s.svg", "VISIBLE"), five));
  EXPECT_FALSE(std::regex_search(read(folder_ / "s.svg"), longer));
  if (!can_run("sheet c.draw -o s.dxf", "this build has no dxflib, which writes DXF")) {
    GTEST_SKIP() << err_;
  }
  EXPECT_FALSE(std::regex_search(read(folder_ / "s.dxf"), longer));
}

}  // namespace
