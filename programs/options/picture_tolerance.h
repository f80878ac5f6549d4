#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <string>

#include "interp/files/picture_compare.h"

namespace displayfile {

/// The options that set how far pictures may differ.
struct PictureTolerance {
  int channel = 0;           ///< a pixel is wrong if one of its channels, 0 to 255, differs by more
  std::string wrong_pixels;  ///< number allowed, or per cent of all; empty: none

  void add_to(CLI::App& command);
  bool is_set() const { return channel != 0 || !wrong_pixels.empty(); }
  /// Throws Error if the number of pixels is not one.
  void require_number() const { most_wrong(1); }
  /// True if the pictures count as the same. The difference was counted with `channel`.
  bool passes(const PictureDifference& difference) const;

 private:
  std::int64_t most_wrong(std::int64_t pixels) const;
};

bool is_picture_file(const std::string& name);  ///< by its extension: .png or .ppm
Picture read_picture(const std::string& name);  ///< throws Error as read_png and read_ppm do

}  // namespace displayfile
