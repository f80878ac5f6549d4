#pragma once

#include "displayfile/style.h"

namespace displayfile {

/// What is seen where nothing is drawn: a colour, or nothing at all, so that a picture laid over
/// another shows that one there.
struct Background {
  enum class Kind { solid, none };
  Kind kind = Kind::solid;
  Colour colour{1.0, 1.0, 1.0};
  bool operator==(const Background&) const = default;
};

}  // namespace displayfile
