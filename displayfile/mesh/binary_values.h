#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

namespace displayfile {

/// The number stored in the first bytes, which must exist.
template <class Number>
Number binary_value(std::string_view bytes, std::endian order) {
  std::array<char, sizeof(Number)> raw;
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

}  // namespace displayfile
