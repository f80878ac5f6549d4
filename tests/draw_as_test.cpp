// Pictures into strings and streams are the files, byte for byte.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>

#include "clip/base/error.h"
#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
#include "interp/vector/dxf/dxf_drawing.h"
#include "tests/error_of.h"
#include "tests/from_eyes.h"
#include "tests/gallery.h"
#include "tests/slower.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::expect_error;

class DrawAs : public test::TemporaryFolder {};

TEST_F(DrawAs, BytesAreThoseOfTheFile) {
  std::size_t drawn = 0;
  test::Share share;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    for (const Choice& format : picture_formats()) {
      if (name.size() % 2 == 1 && format.name == ".eps") continue;  // Cairo takes its time
      if (!share.takes_next()) continue;
      SCOPED_TRACE(format.name);
      DrawOptions options{.samples = 1};
      options.width = options.height = 96;
      if (format.name == ".dxf") {
        if (!kWritesDxf) continue;
        options.pens.emplace();
        options.surfaces.method = HiddenMethod::franklin;
      }
      const auto path = file(name + std::string(format.name));
      draw(retained.system, path, options);
      EXPECT_TRUE(draw_as(retained.system, format.name, options) == test::content(path.string()));
      ++drawn;
    }
  });
  EXPECT_GT(drawn, 60u / test::kShare);
}

TEST_F(DrawAs, EveryRendererWritesToStreams) {
  test::Retained retained;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/cube.draw", retained.system);
  DrawOptions options{.samples = 1};
  options.format = "svg";
  options.width = options.height = 64;
  const std::string expected = draw_as(retained.system, "svg", options);
  std::ostringstream by_renderer, by_view;
  Renderer().draw(retained.system, by_renderer, options);
  EXPECT_EQ(by_renderer.str(), expected);
  options.format = "png";
  FromEyes views(retained.scene, retained.system.display_file());
  views.draw(retained.system.view(), by_view, options);
  views.draw(retained.system.view(), file("view.png"), options);
  EXPECT_TRUE(by_view.str() == test::content(file("view.png").string()));
}

/// A stream that accepts a limited number of bytes.
class ShortBuffer : public std::streambuf {
 public:
  explicit ShortBuffer(std::size_t room) { setp(bytes_.data(), bytes_.data() + room); }

 private:
  std::array<char, 1024> bytes_{};
};

TEST_F(DrawAs, WhatCannotBeWrittenIsAnError) {
  test::Retained retained;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/cube.draw", retained.system);
  const GraphicsSystem& system = retained.system;
  expect_error([&] { draw_as(system, ""); }, "unknown picture format ''");
  expect_error([&] { draw_as(system, "gif"); }, "expected one of .png");
  expect_error([&] { draw_as(system, "png", {.width = 0}); }, "picture size");
  std::ostringstream out;
  out << "before";
  expect_error([&] { draw(system, out); }, "the stream: unknown picture format ''");
  DrawOptions options{.samples = 1};
  options.format = "svg";
  options.device = "osmesa";
  expect_error([&] { draw(system, out, options); }, "the stream: the osmesa device draws pixels");
  EXPECT_EQ(out.str(), "before");
  ShortBuffer room(100);
  std::ostream short_stream(&room);
  options.device = "software";
  expect_error([&] { draw(system, short_stream, options); },
               "the stream: not all could be written");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace displayfile
