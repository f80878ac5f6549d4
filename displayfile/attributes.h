#pragma once

#include <optional>

#include "displayfile/lighting.h"
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
  bool operator==(const Attributes&) const = default;
};

}  // namespace displayfile
