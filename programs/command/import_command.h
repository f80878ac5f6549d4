#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"
#include "programs/options/shading_word.h"

namespace displayfile {

/// `displayfile import`: a drawing program from meshes.
struct ImportCommand {
  std::vector<std::string> meshes;
  PictureSizeWord size;  ///< of the picture that the window is made for
  ShadingWord shading;   ///< gouraud: with normals of vertices
  MeshWords options;
  std::optional<Touching> touching;
  std::string output;

  CLI::App& add_to(CLI::App& app);
  int run();
};

}  // namespace displayfile
