#pragma once

#include <span>
#include <string>

#include "displayfile/graphics_system.h"
#include "displayfile/retained_scene.h"
#include "interp/draw.h"
#include "programs/mesh_words.h"

namespace displayfile {

/// Inputs entered into a system of their own, as the command draws them.
class DrawnInputs {
 public:
  /// Throws Error as enter_inputs does. The inputs must live on.
  DrawnInputs(std::span<const std::string> inputs, const DrawOptions& options,
              const MeshWords& meshes, Shading shading);
  DrawnInputs(const DrawnInputs&) = delete;
  DrawnInputs& operator=(const DrawnInputs&) = delete;

  const GraphicsSystem& system() const { return system_; }
  /// As given, but for bare meshes with the method that is picked for them.
  const DrawOptions& options() const { return options_; }

  /// Warns, with the reason, if the picture is empty. The reason is worked out only then, for which
  /// inputs that were not retained are entered once more.
  void warn_if_nothing_is_seen() const;

 private:
  void enter(GraphicsSystem& system) const;
  std::string why_nothing_is_seen() const;

  std::span<const std::string> inputs_;
  DrawOptions options_;
  MeshWords meshes_;
  Shading shading_;
  RetainedScene scene_;  // of the system, if it retains
  GraphicsSystem system_;
};

}  // namespace displayfile
