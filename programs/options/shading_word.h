#pragma once

#include <CLI/App.hpp>
#include <string>

#include "displayfile/looks/style.h"
#include "programs/options/option_groups.h"

namespace displayfile {

/// The option --shading, as a word.
struct ShadingWord {
  std::string word = "flat";

  void add_to(CLI::App& command) {
    command
        .add_option("--shading", word,
                    "initial shading of the inputs: flat, or gouraud or phong for smooth meshes")
        ->type_name("flat|gouraud|phong")
        ->capture_default_str()
        ->group(kPictureOptions);
  }
  /// Throws Error for an unknown word.
  Shading shading() const { return displayfile::shading(word); }
};

}  // namespace displayfile
