#pragma once

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <optional>
#include <string>

#include "interp/draw/size_on_paper.h"

namespace displayfile {

/// The option --size, as a word.
struct PictureSizeWord {
  std::string size = "512x512";

  /// `on_paper`: the command also takes millimetres.
  void add_to(CLI::App& command, bool on_paper = false);
  bool is_set() const { return option != nullptr && option->count() > 0; }
  /// None: not in millimetres. Throws Error for sides that paper cannot have.
  std::optional<MillimetreSize> millimetres() const;
  /// In pixels. Throws Error for anything but WIDTHxHEIGHT, and for a size that no picture has.
  void read(int& width, int& height) const;
  double aspect() const;  ///< width over height; throws as read does

  const CLI::Option* option = nullptr;  ///< set by add_to
};

}  // namespace displayfile
