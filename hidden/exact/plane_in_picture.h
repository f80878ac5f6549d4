#pragma once

#include "hidden/exact/exact_number.h"

namespace displayfile {

/// A plane in the picture, in exact numbers: a x + b y + c z + d = 0 in device coordinates. As
/// entered, it is not the plane through three points of a display file, which viewing rounded.
struct PlaneInPicture {
  ExactNumber a, b, c, d;
  bool is_edge_on() const { return c.sign() == 0; }
};

}  // namespace displayfile
