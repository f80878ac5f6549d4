#pragma once

#include <CLI/App.hpp>
#include <string>

#include "displayfile/mesh/mesh_options.h"
#include "programs/camera_options.h"

namespace displayfile {

/// The options of commands that enter meshes, as words: those of the camera, and the colour.
struct MeshWords : CameraWords {
  std::string colour;

  void add_to(CLI::App& command);
  /// Throws Error for a word that is not understood.
  MeshOptions options() const;
};

}  // namespace displayfile
