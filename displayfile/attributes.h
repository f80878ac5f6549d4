#pragma once

#include <optional>

#include "displayfile/lighting.h"
#include "displayfile/shading.h"
#include "displayfile/style.h"

namespace displayfile {

/// How primitives are drawn that were entered in a row.
struct Attributes {
  FillStyle fill;
  LineStyle line;
  TextStyle text;
  std::optional<Light> light;  ///< the fill is lit in each view
  bool back_face_removal = false;
  bool shadows = false;
  Shading shading = Shading::flat;  ///< of polygons whose vertices have normals
  bool operator==(const Attributes&) const = default;
};

/// True if they are equal but for the colour of the fill.
inline bool equal_but_for_colour(const Attributes& a, const Attributes& b) {
  return a.fill.kind == b.fill.kind && a.fill.shadow == b.fill.shadow && a.line == b.line &&
         a.text == b.text && a.light == b.light && a.back_face_removal == b.back_face_removal &&
         a.shadows == b.shadows && a.shading == b.shading;
}

}  // namespace displayfile
