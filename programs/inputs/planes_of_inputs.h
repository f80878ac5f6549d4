#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// Between which inputs cutting planes are set, for warnings of those that cut nothing.
class PlanesOfInputs {
 public:
  /// All inputs up to number i have been entered into the system.
  void entered(std::size_t i, const GraphicsSystem& system);
  /// Warns of each plane that cut nothing of all that was entered while it was set, or all of it.
  void warn(std::span<const std::string> inputs, const GraphicsSystem& system) const;

 private:
  std::vector<std::int64_t> planes_set_;              // after each input
  std::map<std::int64_t, std::size_t> ended_within_;  // by order of setting, without effect
};

}  // namespace displayfile
