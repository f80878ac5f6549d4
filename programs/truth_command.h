#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/camera_options.h"
#include "programs/picture_size.h"

namespace displayfile {

/// `displayfile truth`: the exact item buffer.
struct TruthCommand {
  std::vector<std::string> inputs;
  PictureSizeWord size;
  CameraWords camera;
  std::string ids;
  std::string depth;  ///< not written if empty

  CLI::App& add_to(CLI::App& app);
  int run() const;
};

}  // namespace displayfile
