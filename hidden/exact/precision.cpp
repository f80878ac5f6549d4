#include "hidden/exact/precision.h"

#include <charconv>
#include <string>

#include "clip/error.h"

namespace displayfile {

Precision precision(std::string_view text) {
  constexpr std::string_view kWithValue = "roundoff=";
  if (text == "exact") return {};
  if (text == "roundoff") return {.exact = false};
  Precision wanted{.exact = false};
  if (text.starts_with(kWithValue)) {
    const char* const end = text.data() + text.size();
    const auto [stop, failure] =
        std::from_chars(text.data() + kWithValue.size(), end, wanted.roundoff);
    const bool good =
        failure == std::errc() && stop == end && wanted.roundoff >= 0.0 && wanted.roundoff < 1.0;
    if (good) return wanted;
  }
  throw Error("the precision is exact, roundoff or roundoff=EPS with 0 <= EPS < 1, not '" +
              std::string(text) + "'");
}

}  // namespace displayfile
