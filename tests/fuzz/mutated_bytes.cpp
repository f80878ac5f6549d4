#include "tests/fuzz/mutated_bytes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace displayfile::test {

namespace {

/// Not a distribution of the standard library, which differs from one library to the next.
std::size_t below(std::size_t end, std::mt19937_64& random) {
  return end == 0 ? 0 : static_cast<std::size_t>(random() % end);
}

template <class Values>
auto one_of(const Values& values, std::mt19937_64& random) {
  return values[below(std::size(values), random)];
}

/// A part of at most a quarter, most often a short one.
std::string_view part(std::string_view bytes, std::mt19937_64& random) {
  const std::size_t longest = below(2, random) == 0 ? 16 : bytes.size() / 4 + 1;
  return bytes.substr(below(bytes.size(), random), 1 + below(longest, random));
}

void set_integer(std::string& bytes, std::mt19937_64& random) {
  constexpr std::array<std::uint32_t, 10> kTelling{
      0, 1, 0xFF, 0xFFFF, 0x10000, 0x00FFFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
  std::uint32_t value =
      below(3, random) == 0 ? static_cast<std::uint32_t>(random()) : one_of(kTelling, random);
  if (bytes.size() < 4) return;
  const std::size_t at = below(bytes.size() - 3, random);
  for (std::size_t k = 0; k < 4; ++k, value >>= 8) bytes[at + k] = static_cast<char>(value & 0xFF);
}

void set_number_of_text(std::string& bytes, std::mt19937_64& random) {
  constexpr std::array<std::string_view, 12> kTelling{
      "0",     "-1",         "1e38",       "-1e39",     "nan",          "inf",
      "65536", "4294967295", "2147483647", "999999999", "0.0000000001", ""};
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size(), random));
  const auto first = std::find_if(from, bytes.end(), is_digit);
  const auto end = std::find_if_not(first, bytes.end(), is_digit);
  if (first != end) bytes.replace(first, end, one_of(kTelling, random));
}

void change(std::string& bytes, const std::string& other, std::mt19937_64& random) {
  if (bytes.empty()) return;
  const std::size_t at = below(bytes.size(), random);
  switch (below(10, random)) {
    case 0: bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8, random))); break;
    case 1: bytes[at] = static_cast<char>(random() & 0xFF); break;
    case 2: bytes[at] = one_of(std::string_view("\0\x7f\x80\xff {}\"\n", 9), random); break;
    case 3: set_integer(bytes, random); break;
    case 4: set_number_of_text(bytes, random); break;
    case 5: bytes.erase(at, part(bytes, random).size()); break;
    case 6: bytes.insert(at, std::string(part(bytes, random))); break;
    case 7: bytes.resize(at); break;
    case 8: {
      const std::string moved(part(bytes, random));
      bytes.replace(at, moved.size(), moved);
      break;
    }
    default:
      if (!other.empty()) bytes.insert(at, std::string(part(other, random)));
  }
}

}  // namespace

std::string mutated(std::string bytes, const std::string& other, std::mt19937_64& random) {
  const std::size_t changes = 1 + below(3, random);
  for (std::size_t i = 0; i < changes; ++i) change(bytes, other, random);
  return bytes;
}

}  // namespace displayfile::test
