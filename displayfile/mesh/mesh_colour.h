#pragma once

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace displayfile {

/// Red, green, blue and opacity as in a file: up to 1 or up to 255.
using Rgba = glm::dvec4;

/// The default opacity, valid for both scales.
inline constexpr double kOpaque = 255.0;

/// Components scaled to [0,1]; minus zero becomes zero.
template <class Parts>
Parts brought_into_range(const Parts& parts) {
  return glm::clamp(parts, 0.0, 1.0) + 0.0;
}

}  // namespace displayfile
