#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// `displayfile steps`: an algorithm over one scene, step by step, as a page that plays them or as
/// the data of one (interp/steps/README.md).
struct StepsCommand {
  std::vector<std::string> inputs;
  std::string hidden, output, title;
  PictureSizeWord size{"64x64"};
  MeshWords meshes;
  std::size_t most_steps = 20'000;

  CLI::App& add_to(CLI::App& app);
  int run();
};

}  // namespace displayfile
