#include "programs/options/colour_word.h"

#include <algorithm>
#include <charconv>

#include "programs/options/number_list.h"

namespace displayfile {

namespace {

std::optional<Colour> of_hexadecimal(std::string_view digits) {
  unsigned value = 0;
  const auto [stop, failure] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 6 || failure != std::errc{} || stop != digits.data() + digits.size()) {
    return std::nullopt;
  }
  const auto part = [&](int shift) { return static_cast<double>(value >> shift & 0xFF) / 255.0; };
  return Colour(part(16), part(8), part(0));
}

}  // namespace

std::optional<Colour> colour_of(std::string_view word) {
  if (word == "white") return Colour(1.0);
  if (word == "black") return Colour(0.0);
  if (word.starts_with('#')) return of_hexadecimal(word.substr(1));
  const auto values = number_list(word);
  const auto is_part = [](double c) { return c >= 0.0 && c <= 1.0; };
  if (!values || values->size() != 3 || !std::ranges::all_of(*values, is_part)) return std::nullopt;
  return Colour((*values)[0], (*values)[1], (*values)[2]);
}

}  // namespace displayfile
