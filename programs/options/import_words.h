#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <string>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The options of commands that read meshes: limits of the import library for each mesh, and how
/// near facets are to curved surfaces.
struct ImportWords {
  std::string memory, seconds, deflection;
  bool any_format = false;

  void add_to(CLI::App& command);
  /// Throws Error for a word that is not understood.
  ImportLimits limits() const;
};

}  // namespace displayfile
