#pragma once

/// Looks: colours, styles of fills, lines and texts, annotation, light and shading, and the
/// background.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

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
/// the hidden parts of lines, or the hatching of cut faces.
enum class StyledLines : std::uint8_t {
  outline,
  boundary,
  crease,
  material,
  intersection,
  all,
  hidden,
  hatch,
};

/// Reads the name of a kind of lines, `hidden` or `hatch`; throws Error for anything else.
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

/// The style of a polygon's side, or of a line of intersection, of these kinds: `line`, overridden
/// by the style of the first of the kinds. A side whose kinds were not determined counts as `all`.
LineStyle side_line_style(const LineStyle& line, LineKinds kinds);

/// The style of the hidden parts of a line: as set for `hidden` in `line.of_kinds`; by default, by
/// drafting practice, dashed, half as wide but at least half a pixel, in the line's colour. Dashes
/// have the lengths of `line`, scaled by the width if that is more than a pixel.
LineStyle hidden_line_style(const LineStyle& line);

/// The style of hatching lines on cut faces: `line`, overridden by that of `hatch`. Where `line` is
/// none they are drawn if `hatch` has a style, solid and black unless that says otherwise.
LineStyle hatching_line_style(const LineStyle& line);

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

/// How annotation is drawn: always visible, over the figure, in the line style's colour, black if
/// the line style is none (interp/annotation/README.md).
struct AnnotationStyle {
  enum class Unit { millimetres, pixels };
  enum class Ends { arrow, dot };
  enum class Placement {
    entered,    ///< at the offsets with which it was entered
    automatic,  ///< outside of the figure, clear of each other (interp/annotation/placement.md)
  };
  /// Height of capital letters and digits. Widths of lines and lengths of arrows follow from it. A
  /// millimetre of a picture without a size on paper is 96/25.4 pixels, in PDF and EPS 72/25.4.
  double size = 3.5;
  Unit unit = Unit::millimetres;
  Ends ends = Ends::arrow;  ///< of leaders, at the model
  int decimals = 2;         ///< at most this many of a measure; trailing zeros are omitted
  Placement placement = Placement::entered;
  /// The text of dimensions, with `<>` once, in place of which the measure stands, without a sign:
  /// `\u00d8<> H7`. Empty: the measure with its sign, such as R.
  std::string dimension_text = {};
  bool operator==(const AnnotationStyle&) const = default;
};

/// Read `mm` or `px`, `arrow` or `dot`, `entered` or `auto`; throw Error for anything else.
AnnotationStyle::Unit annotation_unit(std::string_view text);
AnnotationStyle::Ends annotation_ends(std::string_view text);
AnnotationStyle::Placement annotation_placement(std::string_view text);
std::string_view name_of(AnnotationStyle::Unit unit);
std::string_view name_of(AnnotationStyle::Ends ends);
std::string_view name_of(AnnotationStyle::Placement placement);

// Annotation, for GraphicsSystem::annotate. Points are in the coordinates of primitives; a measure
// is a length in world coordinates, after the modelling transformation, or an angle in degrees. A
// text's offset on paper is to the right and up, in the annotation's unit; none: three times its
// size each way.

/// A line from a point of the model to a text.
struct Leader {
  Point3 at;
  std::string text;
  std::optional<Point2> offset = std::nullopt;
};
/// A number in a circle, with a line from a point of the model.
struct Balloon {
  Point3 at;
  int number;             ///< 1 or more
  std::string name = {};  ///< of the part, for the parts list; empty: it is not listed
  std::optional<Point2> offset = std::nullopt;
};
/// The distance of two points along an axis of the coordinates in force, at a line parallel to it
/// through `from` + `offset`; the offset's part along the axis has no effect.
struct LinearDimension {
  enum class Axis { x, y, z };
  Axis axis;
  Point3 from, to, offset;
};
/// The distance of two points, at a line that is moved from them by `offset`.
struct AlignedDimension {
  Point3 from, to, offset;
};
/// The diameter between two opposite points of a circle.
struct DiameterDimension {
  Point3 from, to;
};
struct RadiusDimension {
  Point3 centre, at;  ///< `at` is on the circle
};
/// The angle at a vertex, above 0 and below 180 degrees, at an arc of that radius in the
/// coordinates of primitives.
struct AngleDimension {
  Point3 vertex, from, to;
  double radius;
};
/// A line of text at the middle of the picture's upper margin.
struct Title {
  std::string text;
};
/// A table of the balloons that have names, in all visible segments: number, name and quantity.
struct PartsList {
  enum class Corner { top_left, top_right, bottom_left, bottom_right };
  Corner corner = Corner::bottom_right;  ///< of the picture
};
using Annotation =
    std::variant<Leader, Balloon, LinearDimension, AlignedDimension, DiameterDimension,
                 RadiusDimension, AngleDimension, Title, PartsList>;

/// Read `x`, `y` or `z`; `top-left`, `top-right`, `bottom-left` or `bottom-right`; throw Error for
/// anything else.
LinearDimension::Axis dimension_axis(std::string_view text);
PartsList::Corner list_corner(std::string_view text);
std::string_view name_of(LinearDimension::Axis axis);
std::string_view name_of(PartsList::Corner corner);

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

/// Throws Error for the colour rule without a background, whose colour its fills have in vectors
/// and dumps.
void require_colour_of_fills(HiddenMethod method, const Background& background);

}  // namespace displayfile
