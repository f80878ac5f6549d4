#pragma once

/// Looks: colours, styles of fills, lines and texts, light and shading, and the background.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "clip/point.h"
#include "clip/surfaces.h"

namespace displayfile {

/// Red, green and blue, each in [0,1].
using Colour = glm::dvec3;

/// How the shadowed parts of a solid fill are drawn (interp/raster/shadows.md).
struct FillShadow {
  Colour colour;
  /// The light's position in normalised device coordinates, homogeneous: an infinitely distant
  /// light may have a finite image in a perspective view. Points on the ray from p toward it are (p
  /// + u light) / (1 + u w), u > 0.
  HomogeneousPoint light;
  bool operator==(const FillShadow&) const = default;
};

/// How a polygon's inside is drawn.
struct FillStyle {
  enum class Kind { solid, hollow };
  Kind kind = Kind::solid;
  Colour colour{0.8, 0.8, 0.8};
  std::optional<FillShadow> shadow{};  ///< none: the fill shows no shadows
  bool operator==(const FillStyle&) const = default;
};

/// Lines that may have a style of their own: a kind of lines (displayfile/segments/line_kinds.md),
/// or the hidden parts of lines.
enum class StyledLines : std::uint8_t {
  outline,
  boundary,
  crease,
  material,
  intersection,
  all,
  hidden,
};

/// Reads the name of a kind of lines, or `hidden`; throws Error for anything else.
StyledLines styled_lines(std::string_view text);
std::string_view name_of(StyledLines lines);

struct LineKindStyle;

/// The styles of lines by kind. Copies share one table, which does not change.
class LineKindStyles {
 public:
  bool empty() const { return table_ == nullptr; }
  const LineKindStyle& of(StyledLines lines) const;
  /// These styles with another one for `lines`.
  LineKindStyles with(StyledLines lines, const LineKindStyle& style) const;
  bool operator==(const LineKindStyles& other) const;

 private:
  struct Table;
  std::shared_ptr<const Table> table_;  // null: every style is the default
};

/// How lines, and the edges of polygons, are drawn. Width and dashes are in pixels.
struct LineStyle {
  enum class Kind { solid, dashed, none };
  Kind kind = Kind::solid;
  Colour colour{0.0, 0.0, 0.0};
  double width = 1.0;
  double dash = 6.0, gap = 4.0;  ///< lengths drawn and skipped, if dashed
  LineKindStyles of_kinds{};     ///< of kinds with styles of their own
  bool operator==(const LineStyle&) const = default;
};

/// The style of lines of one kind, in place of the line style in force; members without a value are
/// those of the line style. Lengths are in pixels.
struct LineKindStyle {
  std::optional<double> width{};
  std::optional<LineStyle::Kind> kind{};  ///< solid or dashed
  std::optional<double> dash{}, gap{};    ///< both or neither, with `dashed`
  std::optional<Colour> colour{};
  bool operator==(const LineKindStyle&) const = default;
};

/// The style of a polygon's side, or of a line of intersection, of these kinds: `line` with what
/// the first of its kinds has instead. A side whose kinds were not determined counts as `all`.
LineStyle side_line_style(const LineStyle& line, LineKinds kinds);

/// The style of the hidden parts of a line: what `hidden` has in `line.of_kinds`, by default
/// following drafting practice: dashed, half as wide but at least half a pixel, in the line's
/// colour. Dashes have the lengths of `line`, scaled by the width if that is more than a pixel.
LineStyle hidden_line_style(const LineStyle& line);

/// How texts are drawn: in the system's "sans-serif" font and the line style's colour, black if the
/// line style is none.
struct TextStyle {
  /// Which point of the text's base line is at its anchor, the current position.
  enum class Alignment { left, centre, right };
  double size = 0.03;  ///< of the letters (the em), as a fraction of the picture's height
  Alignment alignment = Alignment::left;
  bool always = false;  ///< drawn even where hidden-surface removal hides the anchor
  bool operator==(const TextStyle&) const = default;
};

/// Reads `left`, `centre` or `right`; throws Error for anything else.
TextStyle::Alignment alignment(std::string_view text);
std::string_view name_of(TextStyle::Alignment alignment);

/// A directional light and the ambient light.
struct Light {
  Point3 toward;   ///< unit, world coordinates
  double ambient;  ///< in [0,1]
  bool operator==(const Light&) const = default;
};

/// How a polygon is shaded.
enum class Shading {
  flat,     ///< one intensity per polygon
  gouraud,  ///< one per vertex, interpolated linearly in the picture (displayfile/looks/gouraud.md)
  phong,    ///< a normal per vertex, interpolated, lit at each pixel (displayfile/looks/phong.md)
};

/// Reads `flat`, `gouraud` or `phong`; throws Error for anything else.
Shading shading(std::string_view text);
std::string_view name_of(Shading shading);

/// Attributes that primitives entered in sequence share.
struct Attributes {
  FillStyle fill;
  LineStyle line;
  /// Replaces `line` where a polygon's dark face is visible, as on the lower side of a surface.
  /// None: `line` on both faces.
  std::optional<LineStyle> dark_line = std::nullopt;
  TextStyle text;
  std::optional<Light> light;  ///< lights fills in every view
  bool back_face_removal = false;
  bool shadows = false;
  Shading shading = Shading::flat;  ///< of polygons whose vertices have normals
  /// The line style for the visible face, light or dark.
  const LineStyle& line_of(bool dark) const { return dark && dark_line ? *dark_line : line; }
  /// True if sides may be drawn in some view.
  bool is_outlined() const {
    return line.kind != LineStyle::Kind::none ||
           (dark_line && dark_line->kind != LineStyle::Kind::none);
  }
  bool operator==(const Attributes&) const = default;
};

/// The background: a colour, or none, so that a picture laid over another is transparent there.
struct Background {
  enum class Kind { solid, none };
  Kind kind = Kind::solid;
  Colour colour{1.0, 1.0, 1.0};
  bool operator==(const Background&) const = default;
};

}  // namespace displayfile
