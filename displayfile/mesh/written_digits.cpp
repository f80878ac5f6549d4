#include "displayfile/mesh/written_digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

void WrittenDigits::look_at(std::string_view number) {
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  std::size_t digits = 0;
  int behind_point = 0;
  bool is_behind = false;
  for (const char c : number.substr(0, end)) {
    is_behind |= c == '.';
    if (!is_digit(c)) continue;
    behind_point += is_behind ? 1 : 0;
    digits += c != '0' || digits > 0 ? 1 : 0;
  }
  if (digits < most_) return;
  std::string_view exponent = number.substr(std::min(end + 1, number.size()));
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  constexpr std::int64_t kMost = 10000;  // of which 10 to that power is no double
  const std::int64_t power =
      std::clamp(displayfile::number<std::int64_t>(exponent).value_or(0), -kMost, kMost);
  const int last = static_cast<int>(power) - behind_point;
  last_ = any_ && digits == most_ ? std::max(last_, last) : last;
  most_ = digits;
  any_ = true;
}

double WrittenDigits::rounding() const {
  if (!any_) return 0.0;
  return displayfile::number<double>(fmt::format("5e{}", last_ - 1)).value_or(0.0);
}

}  // namespace displayfile
