#pragma once

#include <CLI/App.hpp>
#include <string>

#include "interp/device/picture.h"

namespace displayfile {

/// The options of pictures in vectors, as words.
struct VectorWords {
  std::string precision, seams;
  bool pick_ids = false;

  void add_to(CLI::App& command);
  /// Throws Error for an unknown word, or for a precision out of its range.
  VectorOptions options() const;
};

}  // namespace displayfile
