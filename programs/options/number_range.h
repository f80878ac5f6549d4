#pragma once

#include <string>

namespace displayfile {

/// From one number up to, but not including, another.
struct NumberRange {
  int first, end;
};

/// What FIRST:END says, a part of 0 to `all`, which are `things`. Throws Error, naming the option,
/// for another text, an empty range, or one that is not within them.
NumberRange number_range(const std::string& option, const std::string& text, int all,
                         const char* things);

}  // namespace displayfile
