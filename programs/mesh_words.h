#pragma once

#include <CLI/App.hpp>
#include <string>

#include "displayfile/mesh/mesh_options.h"

namespace displayfile {

/// The options of commands that enter meshes, as words.
struct MeshWords {
  std::string colour;

  void add_to(CLI::App& command);
  /// Throws Error for a word that is not understood.
  MeshOptions options() const;
};

}  // namespace displayfile
