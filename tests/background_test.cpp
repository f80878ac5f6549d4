// The background of pictures.

#include "displayfile/looks/style.h"

#include <gtest/gtest.h>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/png_file.h"
#include "interp/opengl/osmesa.h"
#include "interp/visibility/plain_z_buffer.h"
#include "tests/temporary_folder.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using BackgroundTest = test::TemporaryFolder;

constexpr Background kNone{Background::Kind::none};
constexpr std::uint32_t kRed = 0xFF0000FF;

/// A red triangle in the lower left half, and a line beside it.
void enter(GraphicsSystem& g) {
  g.set_window(0, 1, 0, 1);
  g.set_view_depth(-1, 1);
  g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  g.close_segment();
}

DrawOptions options(HiddenMethod method, const Background& background) {
  DrawOptions o{.samples = 1};
  o.width = o.height = 24;
  o.surfaces.method = method;
  o.background = background;
  o.with_ids = true;
  return o;
}

/// The pixels of a picture on white are those on another background, except where nothing is
/// visible.
void expect_only_the_background_differs(const Picture& on_white, const Picture& picture,
                                        std::uint32_t background) {
  ASSERT_EQ(picture.ids, on_white.ids);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    EXPECT_EQ(picture.pixels[i], on_white.ids[i] < 0 ? background : on_white.pixels[i]) << i;
  }
}

TEST_F(BackgroundTest, IsThatOfEveryMethod) {
  for (const auto& entry : hidden_methods()) {
    if (shows_lines_only(entry.method)) continue;  // which have no item buffer
    RetainedScene scene;
    GraphicsSystem g;
    g.retain(&scene);
    enter(g);
    const Picture on_white = draw(g, options(entry.method, {}));
    EXPECT_EQ(on_white.pixels.front(), 0xFFFFFFFFu) << entry.name;
    expect_only_the_background_differs(on_white, draw(g, options(entry.method, kNone)), 0);
    const Background blue{Background::Kind::solid, {0, 0, 1}};
    expect_only_the_background_differs(on_white, draw(g, options(entry.method, blue)), 0xFFFF0000);
  }
}

TEST_F(BackgroundTest, IsThatOfOsmesaAndOfThePlainZBuffer) {
  GraphicsSystem g;
  enter(g);
  RasterRequest request;
  request.width = request.height = 24;
  request.surfaces.method = HiddenMethod::z_buffer;
  request.ids = true;
  std::vector<Picture (*)(const DisplayFile&, const RasterRequest&)> devices{
      [](const DisplayFile& d, const RasterRequest& r) {
        return draw_with_plain_z_buffer(d, r, DepthFormat::float_64);
      }};
  if (osmesa_available()) {
    devices.push_back(
        [](const DisplayFile& d, const RasterRequest& r) { return draw_with_osmesa(d, r); });
  }
  for (const auto& device : devices) {
    request.background = {};
    const Picture on_white = device(g.display_file(), request);
    request.background = kNone;
    expect_only_the_background_differs(on_white, device(g.display_file(), request), 0);
    request.background = {Background::Kind::solid, {0.2, 0.4, 0.6}};
    expect_only_the_background_differs(on_white, device(g.display_file(), request), 0xFF996633);
  }
}

/// A renderer keeps its prepared data; the background is not part of that.
TEST_F(BackgroundTest, TheApplicationsHoldsUnlessThePictureHasItsOwn) {
  GraphicsSystem g;
  enter(g);
  g.set_background({Background::Kind::solid, {0, 1, 0}});
  DrawOptions asked = options(HiddenMethod::z_buffer, {});
  EXPECT_EQ(draw(g, asked).pixels[1], 0xFFFFFFFFu);
  asked.background.reset();
  EXPECT_EQ(draw(g, asked).pixels[1], 0xFF00FF00u);
  g.set_background(kNone);
  EXPECT_EQ(draw(g, asked).pixels[1], 0u);
  EXPECT_THROW(g.set_background({Background::Kind::solid, {0, 1.5, 0}}), Error);
  EXPECT_EQ(g.looks().background, kNone);
}

TEST_F(BackgroundTest, SamplesOnNothingHaveTheirColourAndAlphaForWhatTheyCover) {
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    GraphicsSystem g;
    enter(g);
    DrawOptions asked = options(method, kNone);
    asked.samples = 4;
    const Picture picture = draw(g, asked);
    asked.background.reset();
    const Picture on_white = draw(g, asked);
    std::size_t partly = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      const std::uint32_t pixel = picture.pixels[i], alpha = pixel >> 24;
      partly += alpha > 0 && alpha < 255 ? 1 : 0;
      EXPECT_EQ(pixel & 0xFFFFFF, alpha == 0 ? 0 : kRed & 0xFFFFFF);
      // Composited over white, it equals the picture drawn on white.
      const auto green = static_cast<double>(on_white.pixels[i] >> 8 & 0xFF);
      EXPECT_NEAR(green, 255.0 - alpha, 1.0);
    }
    EXPECT_EQ(partly, 24u) << "along the slanted side";
  }
}

TEST_F(BackgroundTest, PngHasAlphaOnlyWhereThereIsNoBackground) {
  GraphicsSystem g;
  enter(g);
  draw(g, file("white.png"), options(HiddenMethod::z_buffer, {}));
  draw(g, file("none.png"), options(HiddenMethod::z_buffer, kNone));
  EXPECT_EQ(test::content(file("white.png")).substr(24, 2), std::string("\x08\x02", 2)) << "RGB";
  EXPECT_EQ(test::content(file("none.png")).substr(24, 2), std::string("\x08\x06", 2)) << "RGBA";
  EXPECT_EQ(read_png(file("none.png"), Alpha::stored).pixels,
            draw(g, options(HiddenMethod::z_buffer, kNone)).pixels);
  EXPECT_EQ(read_png(file("none.png")).pixels, read_png(file("white.png")).pixels)
      << "laid over white";
  write_png(draw(g, options(HiddenMethod::z_buffer, kNone)), file("copy.png"));
  EXPECT_EQ(test::content(file("copy.png")), test::content(file("none.png")));
}

TEST_F(BackgroundTest, PpmSaysThatItHasNoAlpha) {
  GraphicsSystem g;
  enter(g);
  g.set_background(kNone);
  try {
    draw(g, file("a.ppm"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(".ppm files have no alpha"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(file("a.ppm")));
  DrawOptions asked{.samples = 1};
  asked.background = Background{};
  EXPECT_NO_THROW(draw(g, file("a.ppm"), asked));
}

TEST_F(BackgroundTest, SvgHasARectangleOfItOrNone) {
  GraphicsSystem g;
  enter(g);
  for (const HiddenMethod method : {HiddenMethod::none, HiddenMethod::z_buffer}) {
    draw(g, file("white.svg"), options(method, {}));
    draw(g, file("blue.svg"), options(method, {Background::Kind::solid, {0, 0, 1}}));
    draw(g, file("none.svg"), options(method, kNone));
    std::string white = test::without_keys(test::content(file("white.svg")));
    const std::string style = ".background{fill:#ffffff}";
    const std::size_t at = white.find(style);
    ASSERT_NE(at, std::string::npos);
    EXPECT_NE(white.find("<rect class=\"background\" width=\"24\" height=\"24\"/>"),
              std::string::npos);
    white.replace(at, style.size(), ".background{fill:#0000ff}");
    EXPECT_EQ(test::without_keys(test::content(file("blue.svg"))), white);
    const std::string none = test::content(file("none.svg"));
    EXPECT_EQ(none.find("background"), std::string::npos);
    EXPECT_EQ(none.find("<rect"), std::string::npos);
    EXPECT_NE(none.find("<path"), std::string::npos);
  }
}

TEST_F(BackgroundTest, PdfWithNoneIsShorterByARectangle) {
  GraphicsSystem g;
  enter(g);
  draw(g, file("white.pdf"), options(HiddenMethod::none, {}));
  draw(g, file("none.pdf"), options(HiddenMethod::none, kNone));
  draw(g, file("again.pdf"), options(HiddenMethod::none, {}));
  EXPECT_EQ(test::content(file("white.pdf")), test::content(file("again.pdf")));
  EXPECT_LT(std::filesystem::file_size(file("none.pdf")),
            std::filesystem::file_size(file("white.pdf")));
}

TEST_F(BackgroundTest, RoutineOfDrawingPrograms) {
  GraphicsSystem g;
  EXPECT_EQ(g.looks().background, Background{});
  replay("set-background 0.25 0.5 1\n", "program", g);
  EXPECT_EQ(g.looks().background, (Background{Background::Kind::solid, {0.25, 0.5, 1}}));
  replay("open-segment 1\nset-background none\nclose-segment\n", "program", g);
  EXPECT_EQ(g.looks().background, kNone);
}

}  // namespace
}  // namespace displayfile
