#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/mesh_words.h"
#include "programs/picture_size.h"

namespace displayfile {

/// `displayfile truth`: the exact item buffer, of the display file or from world coordinates.
struct TruthCommand {
  std::vector<std::string> inputs;
  PictureSizeWord size;
  MeshWords meshes;
  std::string ids;    ///< not written if empty
  std::string depth;  ///< not written if empty

  std::string from = "display-file";

  CLI::App& add_to(CLI::App& app);
  int run() const;

 private:
  bool is_from_world() const;
};

}  // namespace displayfile
