#include "interp/opengl/osmesa.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "clip/base/error.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "tests/error_of.h"
#include "tests/mesa_leaks.h"

namespace displayfile {
namespace {

constexpr std::uint32_t kWhite = 0xFFFFFFFF, kRed = 0xFF0000FF, kGreen = 0xFF00FF00,
                        kBlack = 0xFF000000;

FillStyle solid(double r, double g, double b) { return {FillStyle::Kind::solid, {r, g, b}}; }
const FillStyle red = solid(1, 0, 0), green = solid(0, 1, 0);
const LineStyle no_line{LineStyle::Kind::none};

/// A display file made directly, in normalised device coordinates.
class OsmesaTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
    segment().set_style(no_line);
  }

  Segment& segment() { return file.contains(1) ? file.segment(1) : file.create(1); }
  void polygon(std::initializer_list<Point3> vertices, const FillStyle& fill, int pick = 0) {
    segment().set_style(fill);
    segment().set_pick(pick);
    const std::vector<std::uint8_t> all(vertices.size(), 1);
    segment().enter_polygon({vertices.begin(), vertices.end()}, all);
  }
  void square(double x, double y, double side, double z, const FillStyle& fill, int pick = 0) {
    polygon({{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}}, fill, pick);
  }
  /// Column i and row j, j counted from the bottom.
  static std::size_t at(const Picture& picture, int i, int j) {
    return static_cast<std::size_t>((picture.height - 1 - j) * picture.width + i);
  }
  static std::size_t count(const Picture& picture, std::uint32_t colour) {
    return static_cast<std::size_t>(std::ranges::count(picture.pixels, colour));
  }
  Picture draw(bool z_buffer = true, int depth_bits = 24) const {
    return draw_with_osmesa(
        file,
        {.width = 16,
         .height = 16,
         .surfaces = {.method = z_buffer ? HiddenMethod::z_buffer : HiddenMethod::none},
         .ids = true,
         .depth = true},
        depth_bits);
  }

  DisplayFile file;
};

TEST_F(OsmesaTest, AnEmptyDisplayFileIsAWhitePicture) {
  const Picture picture = draw();
  EXPECT_EQ(picture.width, 16);
  EXPECT_EQ(picture.height, 16);
  EXPECT_EQ(picture.pixels, std::vector<std::uint32_t>(256, kWhite));
  EXPECT_EQ(picture.ids, std::vector<std::int32_t>(256, -1));
  EXPECT_EQ(picture.depth, std::vector<double>(256, -std::numeric_limits<double>::infinity()));
}

TEST_F(OsmesaTest, OnlyWhatIsAskedForComesBack) {
  square(0, 0, 1, 0.5, red);
  const Picture picture = draw_with_osmesa(file, {.width = 4, .height = 4});
  EXPECT_EQ(picture.pixels, std::vector<std::uint32_t>(16, kRed));
  EXPECT_TRUE(picture.ids.empty());
  EXPECT_TRUE(picture.depth.empty());
}

TEST_F(OsmesaTest, ATriangleCoversThePixelsWhoseCentresAreInside) {
  polygon({{0.1, 0.1, 0.5}, {0.9, 0.2, 0.5}, {0.3, 0.8, 0.5}}, red, 7);
  const Picture picture = draw();
  const auto left_of = [](Point2 a, Point2 b, Point2 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
  };
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i) {
      const Point2 centre((i + 0.5) / 16, (j + 0.5) / 16);
      const bool inside = left_of({0.1, 0.1}, {0.9, 0.2}, centre) &&
                          left_of({0.9, 0.2}, {0.3, 0.8}, centre) &&
                          left_of({0.3, 0.8}, {0.1, 0.1}, centre);
      EXPECT_EQ(picture.pixels[at(picture, i, j)], inside ? kRed : kWhite) << i << ' ' << j;
      EXPECT_EQ(picture.ids[at(picture, i, j)], inside ? 7 : -1) << i << ' ' << j;
    }
  }
}

TEST_F(OsmesaTest, TheUnitSquareIsTheWholePictureAndTheTopRowComesFirst) {
  square(0, 0, 1, 0.5, red);
  polygon({{0, 0.5, 0.6}, {0.25, 0.5, 0.6}, {0.25, 1, 0.6}, {0, 1, 0.6}}, green);
  const Picture picture = draw_with_osmesa(
      file, {.width = 8, .height = 4, .surfaces = {.method = HiddenMethod::z_buffer}});
  const std::vector<std::uint32_t> upper = {kGreen, kGreen, kRed, kRed, kRed, kRed, kRed, kRed};
  const std::vector<std::uint32_t> lower(8, kRed);
  for (std::size_t row = 0; row < 4; ++row) {
    const auto begin = picture.pixels.begin() + static_cast<std::ptrdiff_t>(row * 8);
    EXPECT_EQ(std::vector<std::uint32_t>(begin, begin + 8), row < 2 ? upper : lower);
  }
}

TEST_F(OsmesaTest, CentresOnLeftAndTopEdgesBelongOnRightAndBottomEdgesDoNot) {
  square(1.5 / 16, 1.5 / 16, 3.0 / 16, 0.5, red);
  const Picture picture = draw();
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i) {
      const bool belongs = i >= 1 && i <= 3 && j >= 2 && j <= 4;
      EXPECT_EQ(picture.pixels[at(picture, i, j)], belongs ? kRed : kWhite) << i << ' ' << j;
    }
  }
}

TEST_F(OsmesaTest, TheNearestIsSeenWhateverTheOrder) {
  square(0.0, 0.0, 0.75, 0.8, red, 1);
  square(0.25, 0.25, 0.75, 0.4, green, 2);
  const Picture nearest = draw(true), last = draw(false);
  EXPECT_EQ(nearest.pixels[at(nearest, 8, 8)], kRed);
  EXPECT_EQ(nearest.ids[at(nearest, 8, 8)], 1);
  EXPECT_EQ(nearest.ids[at(nearest, 14, 14)], 2);
  EXPECT_EQ(last.pixels[at(last, 8, 8)], kGreen);
  EXPECT_EQ(last.ids[at(last, 8, 8)], 2);
}

TEST_F(OsmesaTest, OfEqualDepthsTheOneEnteredLaterIsSeen) {
  polygon({{0, 0, 0.1}, {1, 0, 0.9}, {0, 1, 0.3}}, red, 1);
  polygon({{0, 0, 0.1}, {1, 0, 0.9}, {0, 1, 0.3}}, green, 2);
  EXPECT_EQ(count(draw(), kRed), 0u);
  EXPECT_GT(count(draw(), kGreen), 100u);
}

TEST_F(OsmesaTest, InterpenetratingPolygonsCrossWhereTheirDepthsDo) {
  polygon({{0, 0, 0.2}, {1, 0, 0.8}, {1, 1, 0.8}, {0, 1, 0.2}}, red);
  polygon({{0, 0, 0.8}, {1, 0, 0.2}, {1, 1, 0.2}, {0, 1, 0.8}}, green);
  const Picture picture = draw();
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(picture.pixels[at(picture, i, 5)], i < 8 ? kGreen : kRed) << i;
  }
}

TEST_F(OsmesaTest, ConcavePolygonsKeepTheirHollow) {
  // A bracket, open to the right: 16 by 16 less a notch of 8 by 8.
  polygon({{0, 0, 0.5},
           {1, 0, 0.5},
           {1, 0.25, 0.5},
           {0.5, 0.25, 0.5},
           {0.5, 0.75, 0.5},
           {1, 0.75, 0.5},
           {1, 1, 0.5},
           {0, 1, 0.5}},
          red, 3);
  square(0, 0, 1, 0.4, green, 4);
  const Picture picture = draw();
  EXPECT_EQ(count(picture, kRed), 256u - 64u);
  EXPECT_EQ(count(picture, kGreen), 64u);
  EXPECT_EQ(picture.ids[at(picture, 12, 8)], 4);
  EXPECT_EQ(picture.ids[at(picture, 12, 1)], 3);
  EXPECT_NEAR(picture.depth[at(picture, 12, 1)], 0.5, 1e-6);
  EXPECT_NEAR(picture.depth[at(picture, 12, 8)], 0.4, 1e-6);
}

TEST_F(OsmesaTest, SelfCrossingPolygonsAreFilledEvenOdd) {
  std::vector<Point3> star;  // a pentagram: every corner turns the same way, twice around
  for (int k = 0; k < 5; ++k) {
    const double angle = (90.0 + 144.0 * k) * std::acos(-1.0) / 180.0;
    star.emplace_back(0.5 + 0.45 * std::cos(angle), 0.5 + 0.45 * std::sin(angle), 0.5);
  }
  const std::vector<std::uint8_t> all(5, 1);
  for (int n = 0; n < 2; ++n) {  // the second must find the stencil as the first did
    segment().set_style(n == 0 ? green : red);
    segment().enter_polygon(star, all);
  }
  const Picture picture = draw_with_osmesa(
      file,
      {.width = 64, .height = 64, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true});
  EXPECT_EQ(picture.pixels[at(picture, 32, 32)], kWhite);  // the pentagon in the middle
  EXPECT_EQ(picture.pixels[at(picture, 32, 55)], kRed);    // the upper ray
  EXPECT_EQ(count(picture, kGreen), 0u);
}

TEST_F(OsmesaTest, ConcavePolygonsHideAndAreHiddenByDepth) {
  const auto arrow = [&](double z, const FillStyle& fill) {
    polygon({{0, 0, z}, {0.5, 0.3, z}, {1, 0, z}, {0.5, 1, z}}, fill);
  };
  arrow(0.6, red);
  arrow(0.4, green);
  EXPECT_EQ(count(draw(), kGreen), 0u);
  EXPECT_GT(count(draw(), kRed), 40u);
}

TEST_F(OsmesaTest, AHollowPolygonDrawsNoFill) {
  polygon({{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}}, FillStyle{FillStyle::Kind::hollow});
  EXPECT_EQ(count(draw(), kWhite), 256u);
  EXPECT_EQ(draw().ids, std::vector<std::int32_t>(256, -1));
}

TEST_F(OsmesaTest, EdgeOnPolygonsCoverNothing) {
  polygon({{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, {0.5, 0.5, 0.2}}, red);
  polygon({{0.1, 0.5, 0.1}, {0.9, 0.5, 0.9}, {0.8, 0.5, 0.2}, {0.2, 0.5, 0.7}}, red);
  EXPECT_EQ(count(draw(), kWhite), 256u);
}

TEST_F(OsmesaTest, DepthIsThatOfThePlane) {
  polygon({{0, 0, 0.1}, {1, 0, 0.5}, {1, 1, 0.9}, {0, 1, 0.5}}, red);
  for (int bits : {16, 24, 32}) {
    const Picture picture = draw(true, bits);
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 16; ++i) {
        const double z = 0.1 + 0.4 * (i + 0.5) / 16 + 0.4 * (j + 0.5) / 16;
        EXPECT_NEAR(picture.depth[at(picture, i, j)], z, bits == 16 ? 1.0 / 65536 : 2e-7);
      }
    }
  }
}

TEST_F(OsmesaTest, APolygonThatIsNotFlatTakesTheDepthOfItsSupportPlane) {
  // p (0,0), q (1,1), r (1,0), the first of the two farthest from pq: z = 0.2 + 0.4 x.
  polygon({{0, 0, 0.2}, {1, 0, 0.6}, {1, 1, 0.6}, {0, 1, 0.9}}, red);
  const Picture picture = draw();
  for (int i = 0; i < 16; ++i) {
    EXPECT_NEAR(picture.depth[at(picture, i, 15)], 0.2 + 0.4 * (i + 0.5) / 16, 1e-6);
  }
}

TEST_F(OsmesaTest, DepthMayLeaveTheUnitRange) {
  square(0, 0, 1, -300.0, red, 1);
  square(0, 0, 0.5, 4000.0, green, 2);
  const Picture picture = draw();
  EXPECT_NEAR(picture.depth[at(picture, 12, 12)], -300.0, 0.001);
  EXPECT_NEAR(picture.depth[at(picture, 2, 2)], 4000.0, 0.001);
  EXPECT_EQ(picture.ids[at(picture, 2, 2)], 2);
}

TEST_F(OsmesaTest, DepthBitsAreReportedAsGranted) {
  square(0, 0, 1, 0.5, red);
  const RasterRequest request{
      .width = 16, .height = 16, .surfaces = {.method = HiddenMethod::z_buffer}};
  EXPECT_EQ(OsmesaBuffers(file, request, 16).depth_bits(), 16);
  EXPECT_EQ(OsmesaBuffers(file, request, 24).depth_bits(), 24);
  EXPECT_EQ(OsmesaBuffers(file, request, 32).depth_bits(), 32);
  EXPECT_THROW(OsmesaBuffers(file, request, 8), Error);
  EXPECT_NE(osmesa_description(16).find("16 depth bits"), std::string::npos);
  polygon({{0, 0, 0}, {0.5, 0.3, 0}, {1, 0, 0}, {0.5, 1, 0}}, red);  // needs the stencil
  EXPECT_EQ(OsmesaBuffers(file, request, 16).depth_bits(), 24);
}

TEST_F(OsmesaTest, EveryPickIdentifierComesBackAsItWas) {
  std::set<std::int32_t> entered;
  for (int k = 0; k < 256; ++k) {
    const auto bits = static_cast<std::uint32_t>(k) * 0x01010101u ^ 0x00A53C0Fu;
    const auto pick = static_cast<std::int32_t>(bits & 0x7FFFFFFFu);
    square((k % 16) / 16.0, (k / 16) / 16.0, 1.0 / 16, 0.5, red, pick);
    entered.insert(pick);
  }
  square(0, 0, 1.0 / 16, 0.6, red, std::numeric_limits<std::int32_t>::max());
  entered.insert(std::numeric_limits<std::int32_t>::max());
  const Picture picture = draw();
  for (int k = 1; k < 256; ++k) {
    const auto bits = static_cast<std::uint32_t>(k) * 0x01010101u ^ 0x00A53C0Fu;
    EXPECT_EQ(picture.ids[at(picture, k % 16, k / 16)],
              static_cast<std::int32_t>(bits & 0x7FFFFFFFu));
  }
  EXPECT_EQ(picture.ids[at(picture, 0, 0)], std::numeric_limits<std::int32_t>::max());
}

TEST_F(OsmesaTest, ColoursAreRoundedAsOurOwn) {
  for (int k = 0; k < 256; ++k) {
    square((k % 16) / 16.0, (k / 16) / 16.0, 1.0 / 16, 0.5, solid(k / 255.0, 1 - k / 255.0, 0.5));
  }
  EXPECT_EQ(draw().pixels, draw_with_software(file, {.width = 16, .height = 16}).pixels);
}

TEST_F(OsmesaTest, PolygonsThatReachFarBeyondThePictureAreClipped) {
  const double far = 1e9;
  polygon({{-far, -far, 0.2}, {far, -far, 0.2}, {far, far, 0.2}, {-far, far, 0.2}}, red);
  polygon({{0.5, -far, 0.5}, {far, -far, 0.5}, {far, far, 0.5}, {0.5, far, 0.5}}, green);
  // Concave, with its notch beyond the left border.
  polygon({{-8, -40, 0.7}, {0.25, 0.25, 0.7}, {-8, 40, 0.7}, {-1, 0, 0.7}}, solid(0, 0, 0));
  square(2, 2, 5, 0.9, solid(0, 0, 1));
  const Picture picture = draw();
  EXPECT_EQ(picture.pixels[at(picture, 15, 15)], kGreen);
  EXPECT_EQ(picture.pixels[at(picture, 8, 0)], kGreen);
  EXPECT_EQ(picture.pixels[at(picture, 7, 15)], kRed);
  EXPECT_EQ(picture.pixels[at(picture, 1, 3)], kBlack);
  EXPECT_EQ(count(picture, 0xFFFF0000), 0u);
}

TEST_F(OsmesaTest, CoordinatesThatAreNotNumbersAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  polygon({{0, 0, nan}, {1, 0, 0.5}, {0, 1, 0.5}}, red);
  EXPECT_THROW(draw(), Error);
}

TEST_F(OsmesaTest, SizesBeyondTheLimitAreRefusedByName) {
  for (const auto& [width, height] : {std::pair{0, 5}, {5, -1}, {100000, 5}}) {
    EXPECT_THROW(draw_with_osmesa(file, {.width = width, .height = height}), Error);
  }
  try {
    draw_with_osmesa(file, {.width = 60000, .height = 8});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("at most 16384x16384"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(draw_with_osmesa(file, {.width = 16384, .height = 1}).pixels.size(), 16384u);
}

TEST_F(OsmesaTest, AnEdgeIsSeenOnItsOwnPolygonAndNotThroughANearerOne) {
  segment().set_style(LineStyle{});
  polygon({{0.03, 0.03, 0.1}, {0.97, 0.03, 0.9}, {0.97, 0.97, 0.9}, {0.03, 0.97, 0.1}}, red);
  segment().set_style(no_line);
  const Picture open = draw();
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(open.pixels[at(open, i, 0)], kBlack) << i;
    EXPECT_EQ(open.pixels[at(open, 0, i)], kBlack) << i;
    EXPECT_EQ(open.ids[at(open, i, 0)], i == 0 ? open.ids[at(open, 0, 0)] : 0);  // fills only
  }
  square(0, 0, 1, 0.95, green);
  EXPECT_EQ(count(draw(), kBlack), 0u);
}

TEST_F(OsmesaTest, ALineOnAPolygonsPlaneWinsOverItAndOneBehindDoesNot) {
  polygon({{0, 0, 0.2}, {1, 0, 0.8}, {1, 1, 0.8}, {0, 1, 0.2}}, red);
  segment().set_style(LineStyle{});
  segment().enter_line({0.1, 0.53, 0.26}, {0.9, 0.53, 0.74});
  segment().enter_line({0.1, 0.22, 0.25}, {0.9, 0.22, 0.73});
  const Picture picture = draw();
  for (int i = 2; i < 14; ++i) {
    EXPECT_EQ(picture.pixels[at(picture, i, 8)], kBlack) << i;
    EXPECT_EQ(picture.pixels[at(picture, i, 3)], kRed) << i;
  }
}

TEST_F(OsmesaTest, LinesCoverTheSamePixelsAsOurOwn) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> place(-0.2, 1.2);
  for (const LineStyle& style :
       {LineStyle{}, LineStyle{.width = 4.0}, LineStyle{.kind = LineStyle::Kind::dashed},
        LineStyle{.kind = LineStyle::Kind::dashed, .width = 3, .dash = 11, .gap = 3}}) {
    for (int n = 0; n < 40; ++n) {
      DisplayFile one;
      one.create(1).set_style(style);
      const Point3 bend(place(random), place(random), 0.5);
      one.segment(1).enter_line({place(random), place(random), 0.2}, bend);
      one.segment(1).enter_line(bend, {place(random), place(random), 0.7});
      const RasterRequest request{.width = 120, .height = 80};
      const Picture theirs = draw_with_osmesa(one, request),
                    ours = draw_with_software(one, request);
      std::size_t differ = 0;
      for (std::size_t k = 0; k < ours.pixels.size(); ++k) {
        differ += ours.pixels[k] != theirs.pixels[k];
      }
      // The ends of lines and of dashes: cut at the line here and at pixels there, and wide ones
      // round and at right angles here, upright or level there.
      const std::size_t tenth = count(ours, kBlack) / 10;
      const auto ends = static_cast<std::size_t>(4.0 * style.width);
      EXPECT_LE(differ, 4u + tenth + (style.width > 1.5 ? tenth + ends : 0u))
          << n << " width " << style.width;
    }
  }
}

TEST_F(OsmesaTest, LinesOnBordersBetweenPixelsTakeTheSamePixelsAsOurOwn) {
  segment().set_style(LineStyle{});
  for (double at : {0.0, 0.25, 0.5, 1.0}) {
    segment().enter_line({at, 0, 0.5}, {at, 1, 0.5});
    segment().enter_line({0, at, 0.5}, {1, at, 0.5});
  }
  const RasterRequest request{.width = 16, .height = 24};
  EXPECT_EQ(draw_with_osmesa(file, request).pixels, draw_with_software(file, request).pixels);
}

TEST_F(OsmesaTest, LinesBeyondThePictureAreLeftOutAndLongDashedOnesEnd) {
  segment().set_style(LineStyle{.kind = LineStyle::Kind::dashed, .dash = 1e-3, .gap = 1.0});
  segment().enter_line({-1e90, 0.5, 0.5}, {1e90, 0.5, 0.5});
  segment().enter_line({2, 2, 0.5}, {3, 3, 0.5});
  segment().set_style(LineStyle{.width = 1e6});
  segment().enter_line({-5, 2e5, 0.5}, {5, 2e5, 0.5});
  EXPECT_EQ(count(draw(), kBlack), 0u);
  segment().enter_line({-5, 0.5, 0.5}, {5, 0.5, 0.5});
  EXPECT_EQ(count(draw(), kBlack), 256u);
}

TEST_F(OsmesaTest, InvisibleSegmentsAndImageTransformations) {
  square(0, 0, 0.5, 0.5, red);
  file.segment(1).image.translation = {0.5, 0.5};
  EXPECT_EQ(draw().pixels[at(draw(), 15, 15)], kRed);
  EXPECT_EQ(draw().pixels[at(draw(), 1, 1)], kWhite);
  file.segment(1).visible = false;
  EXPECT_EQ(count(draw(), kWhite), 256u);
}

TEST_F(OsmesaTest, AResidentSceneDrawsAgainAndAgainBesideOthers) {
  square(0, 0, 0.5, 0.5, red, 1);
  OsmesaBuffers first(
      file,
      {.width = 16, .height = 16, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true});
  square(0.5, 0.5, 0.5, 0.5, green, 2);
  OsmesaBuffers second(
      file, {.width = 8, .height = 8, .surfaces = {.method = HiddenMethod::z_buffer}, .ids = true});
  EXPECT_EQ(first.triangles(), 2u);
  EXPECT_EQ(second.triangles(), 4u);
  for (int n = 0; n < 3; ++n) {
    first.draw();
    second.draw();
    EXPECT_EQ(count(first.picture(), kRed), 64u);
    EXPECT_EQ(count(second.picture(), kGreen), 16u);
    EXPECT_EQ(std::ranges::count(second.picture().ids, 1), 16);
  }
}

TEST_F(OsmesaTest, ManyTrianglesGoInOneRunWithTheRightDepths) {
  constexpr int n = 200;  // 80,000 triangles, each row of squares nearer than the one before
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = i / double(n), y = j / double(n), z = y, s = 1.0 / n;
      polygon({{x, y, z}, {x + s, y, z}, {x + s, y + s, z}}, red, 2 * (j * n + i));
      polygon({{x, y, z}, {x + s, y + s, z}, {x, y + s, z}}, red, 2 * (j * n + i) + 1);
    }
  }
  const Picture picture = draw_with_osmesa(file, {.width = n,
                                                  .height = n,
                                                  .surfaces = {.method = HiddenMethod::z_buffer},
                                                  .ids = true,
                                                  .depth = true});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(picture.ids[at(picture, i, j)] / 2, j * n + i);
      ASSERT_NEAR(picture.depth[at(picture, i, j)], j / double(n), 1e-6);
    }
  }
}

TEST(OsmesaAvailable, ABuildWithoutItSaysSoAndOneWithItDraws) {
  const std::string said = test::error_of([] { draw_with_osmesa({}, {.width = 4, .height = 4}); });
  if (osmesa_available()) {
    EXPECT_EQ(said, "");
  } else {
    EXPECT_NE(said.find("no OSMesa"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace displayfile
