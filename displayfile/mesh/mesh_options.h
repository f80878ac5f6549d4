#pragma once

#include <optional>

#include "displayfile/looks/style.h"
#include "displayfile/mesh/camera.h"
#include "displayfile/mesh/import_limits.h"

namespace displayfile {

/// How meshes are entered, where it is not as their files say.
struct MeshOptions {
  Camera camera;                   ///< of the fitted view
  std::optional<Colour> colour{};  ///< of all faces, whatever files and programs say
  bool file_colours = true;        ///< the colours that files give faces are taken
  /// Faces' sides are drawn, unless the application said how: with a method that shows lines only,
  /// and where lines are selected.
  bool sides_drawn = false;
  bool hidden_sides_drawn = false;  ///< and dashed where they are hidden: no back face is removed
  ImportLimits import_limits{};     ///< of formats that the import library reads
};

}  // namespace displayfile
