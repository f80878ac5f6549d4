#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "interp/device/picture.h"
#include "interp/files/png_file.h"

// Vector files as somebody else draws them.

namespace displayfile::test {

/// True if there is such a program.
inline bool have(const std::string& tool) {
  return std::system(("command -v " + tool + " > /dev/null 2>&1").c_str()) == 0;
}

/// The program that draws files of that ending.
inline std::string rasteriser(const std::string& format) {
  return format == "svg" ? "rsvg-convert" : "pdftoppm";
}

/// An SVG or PDF file in pixels; written beside it, too.
inline Picture rasterised(const std::filesystem::path& file) {
  const std::string command =
      file.extension() == ".svg"
          ? fmt::format("rsvg-convert '{0}' -o '{0}.png'", file.string())
          : fmt::format("pdftoppm -r 72 -png -singlefile '{0}' '{0}'", file.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return read_png(file.string() + ".png");
}

/// The pixel that holds a point, in [0,1] over the picture, y up.
inline std::uint32_t at(const Picture& picture, double x, double y) {
  const auto column = static_cast<std::size_t>(x * picture.width);
  const auto row = static_cast<std::size_t>((1.0 - y) * picture.height);
  return picture.pixels[row * static_cast<std::size_t>(picture.width) + column];
}

}  // namespace displayfile::test
