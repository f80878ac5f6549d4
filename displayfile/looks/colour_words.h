#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "displayfile/looks/style.h"

namespace displayfile {

/// True for #rrggbb and #rgb in hexadecimal digits.
bool is_hexadecimal_colour(std::string_view word);

/// The colour of one word: #rrggbb, #rgb (each digit stands for two equal ones), or one of the 148
/// names of CSS in lower case, such as darkorange. None for any other word. Source: W3C, CSS Color
/// Module Level 4.
std::optional<Colour> colour_of_word(std::string_view word);

/// For messages about an unknown name: " did you mean 'red'?", or nothing if no name is near.
std::string nearest_colour_name(std::string_view word);

}  // namespace displayfile
