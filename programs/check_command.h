#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/hidden_surface_words.h"
#include "programs/mesh_words.h"

namespace displayfile {

/// `displayfile check`: what segments hold, in the order that is drawn, against golden files. It
/// draws nothing.
struct CheckCommand {
  std::vector<std::string> inputs;
  HiddenSurfaceWords hidden_surfaces;
  MeshWords meshes;
  int threads = 1;
  std::string golden_folder;
  bool update = false;

  CLI::App& add_to(CLI::App& app);
  int run() const;  ///< 1 if a difference was found
};

}  // namespace displayfile
