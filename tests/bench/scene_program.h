#pragma once

#include <string>

#include "programs/scenes/scene.h"

namespace displayfile::bench {

/// Writes a drawing program of the scene, in which the touching of polygons is not set: builds that
/// do not know it read the program too. Throws Error if the file cannot be written.
void write_program(const Scene& scene, const std::string& path);

}  // namespace displayfile::bench
