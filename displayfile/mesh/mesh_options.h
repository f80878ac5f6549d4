#pragma once

#include "displayfile/mesh/camera.h"

namespace displayfile {

/// How meshes are entered.
struct MeshOptions {
  Camera camera;  ///< of the fitted view
};

}  // namespace displayfile
