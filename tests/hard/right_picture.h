#pragma once

#include "interp/device/picture.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/scene.h"

namespace displayfile {

/// The exact picture of a scene with size x size pixels, by the truth that begins at `from`.
/// Touching is decided by the scene's setting.
Picture right_picture(const Scene& scene, JudgedFrom from, int size);

}  // namespace displayfile
