#pragma once

#include <CLI/App.hpp>
#include <string>

namespace displayfile {

/// The option --size, as a word.
struct PictureSizeWord {
  std::string size = "512x512";

  void add_to(CLI::App& command);
  /// In pixels. Throws Error for anything but WIDTHxHEIGHT, and for a size that no picture has.
  void read(int& width, int& height) const;
  double aspect() const;  ///< width over height; throws as read does
};

}  // namespace displayfile
