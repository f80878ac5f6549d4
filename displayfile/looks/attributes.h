#pragma once

#include <optional>

#include "displayfile/looks/lighting.h"
#include "displayfile/looks/shading.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// How primitives are drawn that were entered in a row.
struct Attributes {
  FillStyle fill;
  LineStyle line;
  /// Of the sides of a polygon whose dark face is seen, in place of `line`: the lower side of a
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

/// True if they are equal but for the colour of the fill.
inline bool equal_but_for_colour(const Attributes& a, const Attributes& b) {
  return a.fill.kind == b.fill.kind && a.fill.shadow == b.fill.shadow && a.line == b.line &&
         a.dark_line == b.dark_line && a.text == b.text && a.light == b.light &&
         a.back_face_removal == b.back_face_removal && a.shadows == b.shadows &&
         a.shading == b.shading;
}

}  // namespace displayfile
