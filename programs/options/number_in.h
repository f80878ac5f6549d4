#pragma once

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <charconv>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace displayfile {

/// Checks the value of an option: a decimal number from `least` to `most`, whatever it begins with,
/// and no other text, such as nan.
template <class Number>
CLI::Validator number_in(Number least, Number most) {
  constexpr bool kWhole = std::integral<Number>;
  const auto read = [least, most](std::string& word) -> std::string {
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const char* const end = digits.data() + digits.size();
    Number value{};
    const auto [stop, failure] = std::from_chars(digits.data(), end, value);
    const bool is_number = failure == std::errc{} && stop == end;
    if (is_number && value >= least && value <= most) {
      word = fmt::format("{}", value);  // the parser takes 010 for 8
      return {};
    }
    std::string wanted = fmt::format("{}: expected a {}number", word, kWhole ? "whole " : "");
    if (most == std::numeric_limits<Number>::max()) return wanted;
    return fmt::format("{}, {} to {}", wanted, least, most);
  };
  const char* const kind = !kWhole ? "FLOAT" : std::signed_integral<Number> ? "INT" : "UINT";
  return CLI::Validator(read, fmt::format("{} in [{} - {}]", kind, least, most));
}

/// The same for any finite number; help does not mention it.
template <class Number>
CLI::Validator any_number() {
  using Limits = std::numeric_limits<Number>;
  return number_in(Limits::lowest(), Limits::max()).description("");
}

}  // namespace displayfile
