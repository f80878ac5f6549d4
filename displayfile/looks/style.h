#pragma once

/// Looks: colours, styles of fills, lines and texts, light and shading, and the background.

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "clip/point.h"

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
LineStyle hidden_line_style(const LineStyle& line);

/// How texts are drawn, in the font that the system calls "sans-serif" and in the line style's
/// colour: black where that is none.
struct TextStyle {
  /// Which point of the text's base line stands at its anchor, the current position.
  enum class Alignment { left, centre, right };
  double size = 0.03;  ///< of the letters (the em), where the picture's height is 1
  Alignment alignment = Alignment::left;
  bool always = false;  ///< seen also where hidden surfaces are removed and hide the anchor
  bool operator==(const TextStyle&) const = default;
};

/// Reads `left`, `centre` or `right`; throws Error for anything else.
TextStyle::Alignment alignment(std::string_view text);
std::string_view name_of(TextStyle::Alignment alignment);

/// A light from far away, and what there is without it.
struct Light {
  Point3 toward;   ///< unit, world coordinates
  double ambient;  ///< in [0,1]
  bool operator==(const Light&) const = default;
};

/// How light is spread over a polygon.
enum class Shading {
  flat,     ///< one intensity a polygon
  gouraud,  ///< one a vertex, linear over the picture of a triangle (displayfile/looks/gouraud.md)
  phong,    ///< a normal a vertex, linear likewise, lit at each pixel (displayfile/looks/phong.md)
};

/// Reads `flat`, `gouraud` or `phong`; throws Error for anything else.
Shading shading(std::string_view text);
std::string_view name_of(Shading shading);

/// How primitives are drawn that were entered in a row.
struct Attributes {
  FillStyle fill;
  LineStyle line;
  /// Replaces `line` on a polygon whose dark face is seen: the lower side of a
  /// surface. None: as those of the others.
  std::optional<LineStyle> dark_line = std::nullopt;
  TextStyle text;
  std::optional<Light> light;  ///< the fill is lit in each view
  bool back_face_removal = false;
  bool shadows = false;
  Shading shading = Shading::flat;  ///< of polygons whose vertices have normals
  /// The line style where the light face is seen, or the dark one.
  const LineStyle& line_of(bool dark) const { return dark && dark_line ? *dark_line : line; }
  /// True if sides may be drawn in some view.
  bool is_outlined() const {
    return line.kind != LineStyle::Kind::none ||
           (dark_line && dark_line->kind != LineStyle::Kind::none);
  }
  bool operator==(const Attributes&) const = default;
};

/// Seen where nothing is drawn: a colour, or nothing at all, so that a picture laid over
/// another shows that one there.
struct Background {
  enum class Kind { solid, none };
  Kind kind = Kind::solid;
  Colour colour{1.0, 1.0, 1.0};
  bool operator==(const Background&) const = default;
};

}  // namespace displayfile
