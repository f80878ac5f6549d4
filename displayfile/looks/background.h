#pragma once

#include "displayfile/looks/style.h"
#include "hidden/hidden_method.h"

namespace displayfile {

/// What is seen where nothing is drawn: a colour, or nothing at all, so that a picture laid over
/// another shows that one there.
struct Background {
  enum class Kind { solid, none };
  Kind kind = Kind::solid;
  Colour colour{1.0, 1.0, 1.0};
  bool operator==(const Background&) const = default;
};

/// Throws Error for the colour rule if there is no background, whose colour fills have in vectors
/// and in dumps.
void require_colour_of_fills(HiddenMethod method, const Background& background);

}  // namespace displayfile
