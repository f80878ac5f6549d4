// Gouraud shading in vectors: a triangle is one linear gradient, exactly.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "interp/device/interpreter.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/polygon_paints.h"
#include "interp/vector/svg_device.h"
#include "tests/shaded_scenes.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

constexpr int kWidth = 97, kHeight = 83;
const LineStyle kNoLines{LineStyle::Kind::none};

/// A polygon in pixels, and its paint.
FillPaint paint_of(const std::vector<Point2>& page, const std::vector<double>& intensities,
                   PolygonPaints& paints, const FillStyle& fill = kFill) {
  std::vector<Point3> device;
  for (const Point2& p : page) device.emplace_back(p.x / 1024, 1.0 - p.y / 1024, 0.5);
  const std::vector<std::int32_t> sides(page.size(), op::move);
  return paints.paint_of({device, sides, fill, kNoLines, 7, intensities}, page, page, 0.01);
}
FillPaint paint_of(const std::vector<Point2>& page, const std::vector<double>& intensities) {
  PolygonPaints paints;
  return paint_of(page, intensities, paints);
}

double levels_off(const FillPaint& paint, const Point2& p, double intensity) {
  return 255.0 * 0.9 * std::abs(paint.ramp->at(p) - intensity);
}

TEST(PolygonPaints, AtTheVerticesARampIsTheirIntensity) {
  Dice dice(5);
  int ramps = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, along(dice, 0, 3));
    std::vector<Point2> page;
    std::vector<double> intensities;
    const Point2 middle{along(dice, 0, 1000), along(dice, 0, 1000)};
    for (int k = 0; k < 3; ++k) {
      const double dx = along(dice, -size, size), dy = along(dice, -size, size);
      page.push_back(middle + Point2(dx, dy));
      intensities.push_back(along(dice, 0, 1));
    }
    const Point2 u = page[1] - page[0], v = page[2] - page[0], w = page[2] - page[1];
    const double longest = std::sqrt(std::max({dot(u, u), dot(v, v), dot(w, w)}));
    if (std::abs(u.x * v.y - u.y * v.x) / longest < 0.5) continue;
    const FillPaint paint = paint_of(page, intensities);
    ASSERT_TRUE(paint.ramp);
    EXPECT_EQ(paint.pixel, pixel_of(kFill.colour));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(levels_off(paint, page[k], intensities[k]), 0.126);
    }
    ++ramps;
  }
  EXPECT_GT(ramps, 1000);
}

TEST(PolygonPaints, ALongRampEndsAtWholeUnits) {
  const FillPaint paint = paint_of({{10, 10}, {300, 20}, {150, 200}}, {0.2, 0.6, 0.9});
  ASSERT_TRUE(paint.ramp);
  for (const double end :
       {paint.ramp->black_x, paint.ramp->black_y, paint.ramp->full_x, paint.ramp->full_y}) {
    EXPECT_NEAR(end * 100, std::round(end * 100), 1e-6);
  }
}

TEST(PolygonPaints, WhatHardlyVariesIsEven) {
  const std::vector<Point2> page{{10, 10}, {300, 20}, {150, 200}};
  EXPECT_EQ(paint_of(page, {0.5, 0.502, 0.501}),
            (FillPaint{pixel_of(kFill.colour * ((0.5 + 0.502 + 0.501) / 3))}));
  EXPECT_TRUE(paint_of(page, {0.5, 0.504, 0.501}).ramp);
  EXPECT_EQ(paint_of(page, {}), FillPaint{pixel_of(kFill.colour)});
  PolygonPaints paints;
  EXPECT_EQ(paint_of(page, {0, 1, 0}, paints, {FillStyle::Kind::solid, {0, 0, 0}}),
            FillPaint{0xff000000u});
}

/// Its slope across would be a thousand times that along it, and is meaningless.
TEST(PolygonPaints, ANeedlesRampRunsAlongIt) {
  for (const double width : {0.3, 1e-3, 1e-9, 0.0}) {
    const std::vector<Point2> page{{10, 10}, {110, 10}, {50, 10 + width}};
    const FillPaint paint = paint_of(page, {0.2, 0.8, 0.9});
    ASSERT_TRUE(paint.ramp);
    EXPECT_LE(levels_off(paint, page[0], 0.2), 0.126);
    EXPECT_LE(levels_off(paint, page[1], 0.8), 0.126);
    EXPECT_NEAR(paint.ramp->at({50, 30}), 0.44, 0.01);
  }
}

TEST(PolygonPaints, WhatIsAPointIsEven) {
  EXPECT_EQ(paint_of({{5, 5}, {5, 5}, {5, 5}}, {0, 1, 0.5}).ramp, std::nullopt);
  EXPECT_EQ(paint_of({{5, 5}, {5 + 1e-9, 5}, {5, 5 + 1e-9}}, {0, 1, 0.5}).ramp, std::nullopt);
}

TEST(PolygonPaints, WhatIsFarLargerThanThePageIsEvenThere) {
  PolygonPaints paints;
  const std::vector<Point3> device{{-1e9, -1e9, 0}, {1e9, -1e9, 0}, {0, 1e9, 0}};
  const std::vector<std::int32_t> sides(3, op::move);
  const std::vector<double> intensities{0.0, 0.0, 1.0};
  const std::vector<Point2> page{{-1e9, 1e9}, {1e9, 1e9}, {0, -1e9}},
      shown{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}};
  EXPECT_EQ(paints.paint_of({device, sides, kFill, kNoLines, 0, intensities}, page, shown, 1.0),
            FillPaint{pixel_of(kFill.colour * 0.4999999)});
}

TEST(PolygonPaints, PiecesOfOneTriangleHaveOnePaint) {
  PolygonPaints paints;
  const auto intensity = [](const Point2& p) { return 0.1 + 0.004 * p.x + 0.0021 * p.y; };
  const auto of_piece = [&](const std::vector<Point2>& page) {
    std::vector<double> intensities;
    for (const Point2& p : page) intensities.push_back(intensity(p));
    return paint_of(page, intensities, paints);
  };
  const FillPaint first = of_piece({{0, 0}, {100, 0}, {0, 100}});
  ASSERT_TRUE(first.ramp);
  EXPECT_EQ(of_piece({{100, 0}, {100, 100}, {50, 130}, {0, 100}}), first);
  EXPECT_EQ(of_piece({{3, 3}, {3.1, 3}, {3, 3.1}}), first);      // hardly varies
  EXPECT_EQ(of_piece({{0, 0}, {90, 90}, {45, 45.001}}), first);  // a needle
}

/// The paints that a device receives, to be evaluated at points.
class Evaluated : public VectorDevice {
 public:
  Evaluated() : VectorDevice(kWidth, kHeight) {}

  std::set<FillPaint> paints() const {
    std::set<FillPaint> all;
    for (const Painted& painted : painted_) all.insert(painted.paint);
    return all;
  }
  std::optional<std::uint32_t> at(const Point2& p) const {
    std::optional<std::uint32_t> pixel;  // the last is on top
    for (const Painted& painted : painted_) {
      if (contains(painted, p)) pixel = pixel_at(painted.paint, p);
    }
    return pixel;
  }

 private:
  struct Painted {
    FillPaint paint;
    std::vector<std::vector<Point2>> loops;
  };
  static bool contains(const Painted& painted, const Point2& p) {
    bool inside = false;
    for (const auto& loop : painted.loops) {
      Point2 from = loop.back();
      for (const Point2& to : loop) {
        if ((from.y < p.y) != (to.y < p.y) &&
            from.x + (p.y - from.y) / (to.y - from.y) * (to.x - from.x) < p.x) {
          inside = !inside;
        }
        from = to;
      }
    }
    return inside;
  }
  static std::uint32_t pixel_at(const FillPaint& paint, const Point2& p) {
    if (!paint.ramp) return paint.pixel;
    const double part = std::clamp(paint.ramp->at(p), 0.0, 1.0) / 255.0;
    return pixel_of(Colour((paint.pixel & 255) * part, ((paint.pixel >> 8) & 255) * part,
                           ((paint.pixel >> 16) & 255) * part));
  }

  void open_group(int) override {}
  void close_group() override {}
  void paint_fill(const Path& path, const FillPaint& paint, bool) override {
    painted_.push_back({paint, {{path.points.begin(), path.points.end()}}});
  }
  void paint_figure(const Figure& figure) override {
    for (const FigureRegion& region : figure.regions) {
      painted_.push_back({region.paint, {}});
      for (std::size_t k = 0; k < region.loops.size(); ++k) {
        auto& loop = painted_.back().loops.emplace_back();
        for (const LatticePoint& p : region.loops.loop(k)) {
          loop.emplace_back(p.x * figure.unit, p.y * figure.unit);
        }
      }
    }
  }
  void paint_lines(const Path&, const LineStyle&, LineKinds, LineCap) override {}
  void paint_text(const DeviceText&, const Point2&, double) override {}

  std::vector<Painted> painted_;
};

GraphicsSystem sorted(const ShadedScene& scene, HiddenMethod method) {
  GraphicsSystem g;
  g.set_hidden_surfaces({.method = method});
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_view_depth(-2, 2);
  enter(scene, Shading::gouraud, g);
  return g;
}

/// Where pixels around show one polygon too.
TEST(VectorRamps, AtPixelCentresTheyAreTheRastersColours) {
  for (const HiddenMethod method : {HiddenMethod::map, HiddenMethod::bsp}) {
    for (const ShadedScene& scene : {triangles(1, 60), triangles(2, 60), ball(14, 9)}) {
      const GraphicsSystem g = sorted(scene, method);
      const Picture expected = picture(drawn(scene, Shading::gouraud), HiddenMethod::z_buffer);
      Evaluated device;
      interpret(g.display_file(), device);
      int compared = 0, largest = 0;
      const auto place = [&](int x, int y) { return static_cast<std::size_t>(y * kWidth + x); };
      for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
          bool one = expected.ids[place(x, y)] >= 0;
          for (const int d : {-1, 0, 1}) {
            for (const int e : {-1, 0, 1}) {
              one = one && expected.ids[place(x + d, y + e)] == expected.ids[place(x, y)];
            }
          }
          const auto seen = device.at({x + 0.5, y + 0.5});
          if (!one || !seen) continue;
          ++compared;
          for (int shift = 0; shift < 24; shift += 8) {
            const auto channel = [&](std::uint32_t p) {
              return static_cast<int>(p >> shift & 255);
            };
            largest =
                std::max(largest, std::abs(channel(*seen) - channel(expected.pixels[place(x, y)])));
          }
        }
      }
      EXPECT_GT(compared, 500);
      EXPECT_LE(largest, 1) << name_of(method);
    }
  }
}

/// A shaded triangle, and before it a bar that leaves two pieces of it.
ShadedScene behind_a_bar() {
  return {
      {{{-0.9, -0.8, 0}, {0.9, -0.8, 0}, {0, 0.9, 0}},
       {{-0.1, -0.95, 1}, {0.1, -0.95, 1}, {0.1, 0.95, 1}, {-0.1, 0.95, 1}}},
      {{{-0.5, 0.7, 1}, {0.5, -0.7, 1}, {0, 0, 1}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}};
}

TEST(VectorRamps, PiecesBehindAnotherPolygonShareAPaint) {
  Evaluated device;
  interpret(sorted(behind_a_bar(), HiddenMethod::map).display_file(), device);
  EXPECT_EQ(device.paints().size(), 2u);
  const std::string svg = [] {
    SvgDevice as_svg(kWidth, kHeight);
    interpret(sorted(behind_a_bar(), HiddenMethod::map).display_file(), as_svg);
    std::ostringstream out;
    as_svg.finish(out);
    return without_keys(out.str());
  }();
  EXPECT_NE(svg.find("id=\"r1\""), svg.npos) << svg;
  EXPECT_EQ(svg.find("id=\"r2\""), svg.npos) << svg;
  EXPECT_NE(svg.find("<path fill=\"url(#r1)\""), svg.npos) << svg;
  EXPECT_NE(svg.find("<path stroke=\"url(#r1)\""), svg.npos) << svg;
}

std::string svg_of(const GraphicsSystem& g, int size) {
  SvgDevice device(size, size);
  interpret(g.display_file(), device);
  std::ostringstream out;
  device.finish(out);
  return without_keys(out.str());
}

/// A triangle over the page, in units of a hundredth of a pixel or in pixels.
TEST(VectorRamps, InSvgTheEndsAreWhereIntensityIsZeroAndOne) {
  const ShadedScene scene{{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                          {{{-0.5, 0.7, 1}, {0.5, -0.7, -1}, {0, 0, 1}}}};
  for (const bool by_map : {true, false}) {
    const std::string svg =
        svg_of(by_map ? sorted(scene, HiddenMethod::map) : drawn(scene, Shading::gouraud), 64);
    EXPECT_NE(svg.find("<linearGradient id=\"c1\" gradientUnits=\"userSpaceOnUse\"><stop "
                       "offset=\"0\"/><stop offset=\"1\" stop-color=\"#e6994d\"/>"),
              svg.npos)
        << svg;
    const std::size_t at = svg.find("<linearGradient id=\"r1\"");
    ASSERT_NE(at, svg.npos) << svg;
    ColourRamp ramp{};
    ASSERT_EQ(std::sscanf(svg.c_str() + at,
                          "<linearGradient id=\"r1\" xlink:href=\"#c1\" x1=\"%lf\" y1=\"%lf\" "
                          "x2=\"%lf\" y2=\"%lf\"/>",
                          &ramp.black_x, &ramp.black_y, &ramp.full_x, &ramp.full_y),
              4)
        << svg.substr(at, 200);
    const double unit = by_map ? 0.01 : 1.0, level = 1 / (255 * 0.9);
    EXPECT_NEAR(ramp.at({16 / unit, 48 / unit}), 1.0, level / 4);
    EXPECT_NEAR(ramp.at({48 / unit, 48 / unit}), kAmbient, level / 4);
    EXPECT_NEAR(ramp.at({32 / unit, 16 / unit}), intensity_of({0, 0, 1}), level / 4);
  }
}

TEST(VectorRamps, FlatScenesHaveNoDefinitions) {
  const ShadedScene flat{{{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}}},
                         {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}};
  EXPECT_EQ(svg_of(sorted(flat, HiddenMethod::map), 64).find("<defs"), std::string::npos);
  EXPECT_EQ(svg_of(drawn(flat, Shading::gouraud), 64).find("<defs"), std::string::npos);
}

TEST(VectorRamps, TheColourRuleFillsWithTheBackground) {
  SvgDevice device(64, 64);
  device.fill_with_background();
  interpret(drawn(triangles(1, 20), Shading::gouraud).display_file(), device);
  std::ostringstream out;
  device.finish(out);
  EXPECT_EQ(out.str().find("url("), std::string::npos);
}

TEST(VectorRamps, InPdfAndEpsTheyAreShadingsNotImages) {
  for (const PageFormat format : {PageFormat::pdf, PageFormat::eps}) {
    std::ostringstream out;
    PdfDevice device(out, 64, 64, {}, {}, format);
    interpret(sorted(behind_a_bar(), HiddenMethod::map).display_file(), device);
    device.finish();
    EXPECT_NE(out.str().find("/ShadingType 2"), std::string::npos);
    EXPECT_EQ(out.str().find("/Subtype /Image"), std::string::npos);
    EXPECT_EQ(out.str().find("/ImageType"), std::string::npos);
  }
}

}  // namespace
}  // namespace displayfile
