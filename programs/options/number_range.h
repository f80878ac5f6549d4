#pragma once

#include <string>

namespace displayfile {

/// From one number up to, but not including, another.
struct NumberRange {
  int first, end;
};

/// The range FIRST:END within 0 to `all`; errors call its elements `things`. Throws Error, naming
/// the option, for another text, an empty range, or one out of bounds.
NumberRange number_range(const std::string& option, const std::string& text, int all,
                         const char* things);

}  // namespace displayfile
