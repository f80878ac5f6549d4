#pragma once

#include <string_view>

namespace displayfile {

/// What is made of solids: the first one with the second, that with the third, and so on.
enum class SolidOperation {
  unite,       ///< what is in any of them
  intersect,   ///< what is in all of them
  difference,  ///< what is in the first, but in none of the others
};

/// Reads `union`, `intersection` or `difference`; throws Error for anything else.
SolidOperation solid_operation(std::string_view text);
std::string_view name_of(SolidOperation operation);

}  // namespace displayfile
