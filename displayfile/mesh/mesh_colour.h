#pragma once

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace displayfile {

/// Red, green, blue and opacity as a file has them: to 1 or to 255.
using Rgba = glm::dvec4;

/// The opacity of colours for which none is given, whichever of the two their parts go to.
inline constexpr double kOpaque = 255.0;

/// Each part brought into [0,1]; minus zero is zero.
template <class Parts>
Parts brought_into_range(const Parts& parts) {
  return glm::clamp(parts, 0.0, 1.0) + 0.0;
}

}  // namespace displayfile
