#pragma once

#include <optional>
#include <string_view>

#include "displayfile/looks/style.h"

namespace displayfile {

/// The colour of a word: R,G,B, each 0 to 1, or a word of drawing programs (colour_of_word in
/// displayfile/looks/colour_words.h). None for any other.
std::optional<Colour> colour_of(std::string_view word);

}  // namespace displayfile
