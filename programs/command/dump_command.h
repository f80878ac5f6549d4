#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// `displayfile dump`: prints the instructions of segments in drawing order. It draws nothing.
struct DumpCommand {
  std::vector<std::string> inputs;
  HiddenSurfaceWords hidden_surfaces;
  PictureSizeWord size;  ///< of the picture that windows are made for
  MeshWords meshes;
  std::string output;  ///< standard output if empty

  CLI::App& add_to(CLI::App& app);
  int run();
};

}  // namespace displayfile
