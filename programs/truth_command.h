#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/mesh_words.h"
#include "programs/picture_size.h"

namespace displayfile {

/// `displayfile truth`: the exact item buffer.
struct TruthCommand {
  std::vector<std::string> inputs;
  PictureSizeWord size;
  MeshWords meshes;
  std::string ids;
  std::string depth;  ///< not written if empty

  CLI::App& add_to(CLI::App& app);
  int run() const;
};

}  // namespace displayfile
