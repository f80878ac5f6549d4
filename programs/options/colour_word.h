#pragma once

#include <optional>
#include <string_view>

#include "displayfile/looks/style.h"

namespace displayfile {

/// The colour that a word says: R,G,B, each 0 to 1; #rrggbb; white or black. None for any other.
std::optional<Colour> colour_of(std::string_view word);

}  // namespace displayfile
