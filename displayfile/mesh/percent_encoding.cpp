#include "displayfile/mesh/percent_encoding.h"

#include <charconv>

namespace displayfile {

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const std::string_view digits = text.substr(i + 1, 2);
    unsigned value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [parsed, failure] = std::from_chars(digits.data(), end, value, 16);
    const bool is_whole = digits.size() == 2 && failure == std::errc() && parsed == end;
    if (!is_whole || value == 0) return std::nullopt;
    decoded += static_cast<char>(value);
    i += digits.size();
  }
  return decoded;
}

}  // namespace displayfile
