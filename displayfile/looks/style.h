#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <optional>

#include "clip/point.h"
#include "displayfile/looks/text_style.h"

namespace displayfile {

/// Red, green and blue, each in [0,1].
using Colour = glm::dvec3;

/// How a solid fill is drawn where another fill hides the light (interp/raster/shadows.md).
struct FillShadow {
  Colour colour;
  /// Where the light comes from, in normalised device coordinates, homogeneous: far away, but in a
  /// perspective view at a point that need not be. All points of a ray toward it are (p + u light)
  /// / (1 + u w), u > 0.
  HomogeneousPoint light;
  bool operator==(const FillShadow&) const = default;
};

/// How a polygon's inside is drawn.
struct FillStyle {
  enum class Kind { solid, hollow };
  Kind kind = Kind::solid;
  Colour colour{0.8, 0.8, 0.8};
  std::optional<FillShadow> shadow{};  ///< none: no shadow is seen on it
  bool operator==(const FillStyle&) const = default;
};

/// How lines, and the edges of polygons, are drawn. Width and dashes are in pixels.
struct LineStyle {
  enum class Kind { solid, dashed, none };
  Kind kind = Kind::solid;
  Colour colour{0.0, 0.0, 0.0};
  double width = 1.0;
  double dash = 6.0, gap = 4.0;  ///< lengths drawn and left out in turn, if dashed
  bool operator==(const LineStyle&) const = default;
};

/// How a line is drawn where it is hidden: as draughtsmen do, dashed and half as wide, but not
/// below half a pixel, and in its own colour. The dashes are the style's, and grow with a width of
/// more than a pixel.
inline LineStyle hidden_line_style(const LineStyle& line) {
  LineStyle hidden = line;
  hidden.kind = LineStyle::Kind::dashed;
  hidden.width = std::min(line.width, std::max(0.5, line.width / 2.0));
  hidden.dash *= std::max(1.0, hidden.width);
  hidden.gap *= std::max(1.0, hidden.width);
  return hidden;
}

}  // namespace displayfile
