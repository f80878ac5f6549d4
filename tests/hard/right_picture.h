#pragma once

#include "interp/device/picture.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/scene.h"

namespace displayfile {

/// What is to be seen of a scene, exactly, with size x size pixels: by the truth that begins where
/// `from` says. What touches is decided as the scene says.
Picture right_picture(const Scene& scene, JudgedFrom from, int size);

}  // namespace displayfile
