#pragma once

#include <optional>

#include "displayfile/style.h"

namespace displayfile {

/// How meshes are entered, where it is not as their files say.
struct MeshOptions {
  std::optional<Colour> colour;  ///< of all faces, whatever files and programs say
};

}  // namespace displayfile
