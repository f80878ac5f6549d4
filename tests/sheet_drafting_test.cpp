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

  /// An entity of a DXF file: its groups but for its handle.
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

TEST_F(SheetDrafting, CirclesAndArcsOfOutlinesAreThatInDxf) {
  const auto draw_dxf = [&](const std::string& program) {
    write_segments("round.draw", {program});
    return can_run("sheet round.draw -o s.dxf --scale 1:1",
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

/// A polygon whose corners are on a circle, but not evenly, is none; nor is an oval one.
TEST_F(SheetDrafting, OnlyFacetsOfCirclesAreCircles) {
  const auto circles = [&](double stretch, bool uneven) {
    std::ostringstream profile;
    profile.precision(17);
    for (int k = 0; k < 40; ++k) {
      const double angle = (k + (uneven && k % 2 == 1 ? 0.3 : 0.0)) * std::acos(-1.0) / 20.0;
      profile << " " << 10.0 * std::cos(angle) << " " << stretch * std::sin(angle);
    }
    write_segments("p.draw", {"extrude-3 0 10 " + profile.str() + "\n"});
    if (!can_run("sheet p.draw -o s.dxf --scale 1:1 --lines all",
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
  draw("c.draw --section side=0");
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
