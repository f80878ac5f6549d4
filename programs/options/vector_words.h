#pragma once

#include <CLI/App.hpp>
#include <string>

#include "interp/device/picture.h"

namespace displayfile {

/// The options of pictures in vectors, as words.
struct VectorWords {
  std::string precision, seams;
  bool pick_ids = false;
  std::string font, text;
  std::string id_prefix;
  bool is_inline = false, layers = false;

  void add_to(CLI::App& command);
  /// The values of --font and --text. Throws Error for an unknown word, or as require_lettering.
  Lettering lettering() const;
  /// Throws Error for an unknown word, or for a precision out of its range.
  VectorOptions options() const;
};

/// Throws Error as require_lettering does, naming the option --font.
void require_lettering_of_option(const Lettering& lettering);

}  // namespace displayfile
