// Drawings for pens as DXF, read back as pairs of a group code and a value.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "interp/draw/draw.h"
#include "interp/vector/dxf/dxf_drawing.h"
#include "interp/vector/pens/pen_drawing.h"
#include "interp/vector/pens/pen_files.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"

namespace displayfile {
namespace {

using namespace test;

/// An entity, or an entry of a table, with the values of its groups in order.
struct DxfItem {
  std::string name;
  std::multimap<int, std::string> values;
  std::string operator[](int group) const {
    const auto at = values.find(group);
    return at == values.end() ? "" : at->second;
  }
  std::vector<std::string> all(int group) const {
    std::vector<std::string> found;
    const auto [first, end] = values.equal_range(group);
    for (auto at = first; at != end; ++at) found.push_back(at->second);
    return found;
  }
};

std::vector<DxfItem> items_of(const std::string& dxf, const std::string& section) {
  std::istringstream in(dxf);
  std::vector<DxfItem> items;
  std::string current, code, value;
  while (std::getline(in, code) && std::getline(in, value)) {
    if (std::stoi(code) == 0) {
      items.push_back({value, {}});
      continue;
    }
    if (items.empty()) continue;  // comments
    if (items.back().name == "SECTION" && std::stoi(code) == 2) current = value;
    if (current == section) items.back().values.emplace(std::stoi(code), value);
  }
  std::erase_if(items, [](const DxfItem& item) { return item.values.empty(); });
  return items;
}

class PenDxf : public TemporaryFolder {
 protected:
  void SetUp() override {
    if (!kWritesDxf) GTEST_SKIP() << "no dxflib";
  }

  /// A red triangle, a black broken line of three points and a blue dot, on a sheet of 100 x 50 mm
  /// without margin: the picture is a square of 50 mm in its middle.
  GraphicsSystem drawing() {
    GraphicsSystem g = unit_square();
    g.open_segment(1);
    g.set_line_style(line(kRed));
    g.move_abs_2(0.2, 0.2);
    for (const auto& [x, y] : {std::pair{0.6, 0.2}, {0.2, 0.8}, {0.2, 0.2}}) g.line_abs_2(x, y);
    g.set_line_style(line(kBlack));
    g.move_abs_2(0.1, 0.1);
    g.line_abs_2(0.9, 0.1);
    g.line_abs_2(0.9, 0.9);
    g.set_line_style(line(kBlue));
    g.move_abs_2(0.4, 0.4);
    g.line_abs_2(0.4, 0.4);
    g.close_segment();
    return g;
  }
  DrawOptions options() {
    DrawOptions options;
    options.width = options.height = 100;
    Paper paper{100, 50, 0};
    paper.turned = Paper::Turned::landscape;
    options.vectors.paper = paper;
    options.pens.emplace();
    return options;
  }
};

/// Millimetres of the sheet, y up.
std::vector<std::pair<double, double>> points_of(const DxfItem& item) {
  std::vector<std::pair<double, double>> points;
  for (const int of : {0, 1}) {
    const std::vector<std::string> x = item.all(10 + of), y = item.all(20 + of);
    for (std::size_t k = 0; k < x.size(); ++k) {
      points.emplace_back(std::stod(x[k]), std::stod(y.at(k)));
    }
    if (item.name != "LINE") break;
  }
  return points;
}

TEST_F(PenDxf, HasEachPathOnceInMillimetresFromTheLowerLeftCorner) {
  draw(drawing(), file("a.dxf"), options());
  std::map<std::string, DxfItem> by_layer;
  for (const DxfItem& item : items_of(content(file("a.dxf")), "ENTITIES")) {
    if (item.name == "SECTION") continue;
    EXPECT_TRUE(by_layer.emplace(item[8].substr(0, 9), item).second) << item[8];
  }
  ASSERT_EQ(by_layer.size(), 3u);
  using Points = std::vector<std::pair<double, double>>;
  const DxfItem red = by_layer["1 #ff0000"], black = by_layer["2 #000000"],
                blue = by_layer["3 #0000ff"];
  EXPECT_EQ(red.name, "LWPOLYLINE");
  EXPECT_EQ(red[70], "1");
  Points corners = points_of(red);
  std::ranges::sort(corners);
  EXPECT_EQ(corners, (Points{{35, 10}, {35, 40}, {55, 10}}));
  EXPECT_EQ(black.name, "LWPOLYLINE");
  EXPECT_EQ(black[70], "0");
  corners = points_of(black);
  if (corners.front().first > 30.0 + 1e-9) std::ranges::reverse(corners);
  EXPECT_EQ(corners, (Points{{30, 5}, {70, 5}, {70, 45}}));
  EXPECT_EQ(blue.name, "POINT");
  EXPECT_EQ(points_of(blue), (Points{{45, 20}}));
}

TEST_F(PenDxf, LayersHaveThePensColoursAndWidths) {
  GraphicsSystem g = unit_square();
  g.open_segment(1);
  int row = 0;
  for (const Colour& colour : {kRed, kBlack, Colour(0.2, 0.4, 0.6)}) {
    g.set_line_style(line(colour, row == 2 ? 4.0 : 1.0));  // pixels of half a millimetre
    g.move_abs_2(0.1, 0.1 + 0.2 * row);
    g.line_abs_2(0.9, 0.1 + 0.2 * row++);
  }
  g.close_segment();
  draw(g, file("a.dxf"), options());
  std::vector<std::vector<std::string>> layers;
  for (const DxfItem& item : items_of(content(file("a.dxf")), "TABLES")) {
    if (item.name == "LAYER" && item[2].find('#') != std::string::npos) {
      layers.push_back({item[2], item[62], item[420], item[370], item[6]});
    }
  }
  const std::vector<std::vector<std::string>> expected{
      {"1 #ff0000 0.5 mm", "1", std::to_string(0xff0000), "50", "CONTINUOUS"},
      {"2 #000000 0.5 mm", "7", "", "50", "CONTINUOUS"},
      {"3 #336699 2 mm", "8", std::to_string(0x336699), "200", "CONTINUOUS"}};
  EXPECT_EQ(layers, expected);
  DrawOptions ordered = options();
  ordered.pens->layers = {kBlack};
  draw(g, file("b.dxf"), ordered);
  EXPECT_NE(content(file("b.dxf")).find("1 #000000 0.5 mm"), std::string::npos);
}

TEST_F(PenDxf, IsForPensAloneAndWholeInMemoryToo) {
  const GraphicsSystem g = drawing();
  const std::string name = file("a.dxf").string();
  EXPECT_EQ(
      error_of([&] { draw(g, name, DrawOptions()); }),
      name + ": .dxf files are lines for pens: expected pens, or one of .png .ppm .svg .pdf .eps");
  EXPECT_TRUE(empty_folder());
  draw(g, name, options());
  EXPECT_EQ(draw_as(g, "dxf", options()), content(name));
  const std::string nowhere = file("no/a.dxf").string();
  EXPECT_TRUE(error_of([&] { draw(g, nowhere, options()); }).starts_with(nowhere + ": "));
}

}  // namespace
}  // namespace displayfile
