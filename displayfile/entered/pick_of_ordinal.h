#pragma once

#include <cstdint>
#include <limits>

namespace displayfile {

/// The pick identifier of the polygon with this ordinal, from 0; it wraps to 0 after the largest
/// one.
constexpr std::int32_t pick_of_ordinal(std::int64_t ordinal) {
  return static_cast<std::int32_t>(ordinal & std::numeric_limits<std::int32_t>::max());
}

}  // namespace displayfile
