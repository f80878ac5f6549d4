#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "programs/bench/process.h"
#include "programs/bench/temporary_folder.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

/// Sketch (Ressler, package sketch), run as a process on its own input: the same polygons, after
/// the same view, as `polygon` statements; no culling by Sketch. Its output is PSTricks.
class Sketch {
 public:
  enum class Sort { depth, bsp };  ///< its default, and `sketch -b`

  /// Sketch's version; nothing if it cannot be run.
  static std::optional<std::string> version();

  /// Writes the input into the folder. Throws Error if that fails.
  Sketch(const DeviceScene& scene, const TemporaryFolder& folder);
  /// Throws Error if Sketch fails; so does fragments.
  void draw(Sort sort) const;
  std::size_t fragments(Sort sort) const;

 private:
  std::string input_, output_;
};

}  // namespace displayfile::bench
