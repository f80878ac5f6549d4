#include "programs/options/number_range.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

NumberRange number_range(const std::string& option, const std::string& text, int all,
                         const char* things) {
  NumberRange range{-1, -1};
  const char* const end = text.data() + text.size();
  const auto [colon, failure] = std::from_chars(text.data(), end, range.first);
  bool is_range = failure == std::errc{} && colon != end && *colon == ':';
  if (is_range) {
    const auto [stop, failed] = std::from_chars(colon + 1, end, range.end);
    is_range = failed == std::errc{} && stop == end;
  }
  if (!is_range || range.first < 0 || range.end <= range.first || range.end > all) {
    throw Error(fmt::format("{} {}: expected FIRST:END, {} from FIRST up to END, of 0:{}", option,
                            text, things, all));
  }
  return range;
}

}  // namespace displayfile
