// Some rows of a picture are those rows of the whole one.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
#include "interp/opengl/osmesa.h"
#include "tests/error_of.h"
#include "tests/from_eyes.h"
#include "tests/gallery.h"
#include "tests/slower.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::expect_error;

template <class Value>
void append(std::vector<Value>& to, const std::vector<Value>& rows) {
  to.insert(to.end(), rows.begin(), rows.end());
}

/// The picture in parts of uneven heights, one after another.
Picture in_parts(const GraphicsSystem& system, DrawOptions options) {
  Picture picture;
  Renderer renderer;
  for (int first = 0, height = 1; first < options.height; height = height * 3 % 31) {
    options.rows = PictureRows{first, std::min(first + height, options.height)};
    const Picture& rows = renderer.draw(system, options);
    EXPECT_EQ(rows.height, options.rows->end - first);
    append(picture.pixels, rows.pixels);
    append(picture.ids, rows.ids);
    append(picture.depth, rows.depth);
    first = options.rows->end;
  }
  return picture;
}

class PictureRowsTest : public test::TemporaryFolder {};

TEST_F(PictureRowsTest, AreThoseOfTheWholePicture) {
  test::Share share;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    for (const HiddenMethod method :
         {HiddenMethod::automatic, HiddenMethod::z_buffer, HiddenMethod::scan_line,
          HiddenMethod::scan_line_z, HiddenMethod::warnock, HiddenMethod::ray_cast,
          HiddenMethod::bsp, HiddenMethod::none, HiddenMethod::franklin}) {
      if (!share.takes_next()) continue;
      SCOPED_TRACE(name + " by " + std::string(name_of(method)));
      DrawOptions options{.samples = 1};
      options.width = 70;
      options.height = 90;
      options.surfaces.method = method;
      options.with_ids = options.with_depth = method != HiddenMethod::franklin;
      options.surfaces.threads = 1 + static_cast<int>(name.size() % 2);
      options.samples = name.size() % 5 == 0 ? 2 : 1;
      const Picture whole = draw(retained.system, options);
      const Picture parts = in_parts(retained.system, options);
      EXPECT_TRUE(parts.pixels == whole.pixels);
      EXPECT_TRUE(parts.ids == whole.ids);
      EXPECT_TRUE(parts.depth == whole.depth);
    }
  });
}

TEST_F(PictureRowsTest, OfViews) {
  test::Retained retained;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/gears.draw", retained.system);
  DrawOptions options{.samples = 1};
  options.width = options.height = 64;
  FromEyes views(retained.scene, retained.system.display_file());
  const Picture whole = views.draw(retained.system.view(), options);
  options.rows = PictureRows{10, 33};
  const Picture rows = views.draw(retained.system.view(), options);
  ASSERT_EQ(rows.height, 23);
  EXPECT_TRUE(std::equal(rows.pixels.begin(), rows.pixels.end(),
                         whole.pixels.begin() + std::ptrdiff_t{10} * 64));
}

TEST_F(PictureRowsTest, OfOsmesa) {
  if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
  test::Retained retained;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/gears.draw", retained.system);
  DrawOptions options{.width = 64, .height = 64, .samples = 1};
  options.rows = PictureRows{10, 33};
  options.device = "osmesa";
  options.with_depth = true;
  const Picture by_osmesa = draw(retained.system, options);
  options.rows = std::nullopt;
  const Picture all = draw(retained.system, options);
  ASSERT_EQ(by_osmesa.pixels.size(), std::size_t{23} * 64);
  EXPECT_TRUE(std::equal(by_osmesa.pixels.begin(), by_osmesa.pixels.end(),
                         all.pixels.begin() + std::ptrdiff_t{10} * 64));
  EXPECT_TRUE(std::equal(by_osmesa.depth.begin(), by_osmesa.depth.end(),
                         all.depth.begin() + std::ptrdiff_t{10} * 64));
}

TEST_F(PictureRowsTest, FilesHaveThemToo) {
  test::Retained retained;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/cube.draw", retained.system);
  DrawOptions options{.samples = 1};
  options.width = options.height = 40;
  const std::string whole = draw_as(retained.system, "ppm", options);
  options.rows = PictureRows{0, 15};
  std::string parts =
      draw_as(retained.system, "ppm", options).substr(std::string("P6\n40 15\n255\n").size());
  options.rows = PictureRows{15, 40};
  parts += draw_as(retained.system, "ppm", options).substr(std::string("P6\n40 25\n255\n").size());
  EXPECT_TRUE(whole == "P6\n40 40\n255\n" + parts);
}

TEST_F(PictureRowsTest, OthersAreErrors) {
  const GraphicsSystem system;
  for (const PictureRows rows : {PictureRows{-1, 3}, PictureRows{3, 3}, PictureRows{5, 2},
                                 PictureRows{0, 41}, PictureRows{40, 41}}) {
    DrawOptions options{.samples = 1};
    options.width = options.height = 40;
    options.rows = rows;
    expect_error([&] { draw(system, options); }, "expected rows within the picture's 40");
    expect_error([&] { draw_as(system, "png", options); }, "expected rows within the picture's 40");
  }
  DrawOptions options{.samples = 1};
  options.rows = PictureRows{0, 10};
  expect_error([&] { draw_as(system, "svg", options); }, "vectors have no rows");
}

}  // namespace
}  // namespace displayfile
