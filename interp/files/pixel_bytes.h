#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "interp/device/picture.h"

namespace displayfile {

/// Writes the first channels of each pixel, of R, G, B and A, as bytes. If these are three, a byte
/// more is written behind the last.
template <std::size_t Channels, class Byte>
void write_channels(std::span<const std::uint32_t> pixels, Byte* to) {
  static_assert((Channels == 3 || Channels == 4) && sizeof(Byte) == 1);
  constexpr std::size_t kTogether = 8;
  // Four bytes are written as fast as three; the next pixel's cover the fourth.
  const auto write = [&](std::size_t i) {
    const std::uint32_t rgba = in_bytes(pixels[i]);
    std::memcpy(to + Channels * i, &rgba, sizeof(rgba));
  };
  std::size_t i = 0;
  for (; i + kTogether <= pixels.size(); i += kTogether) {
    for (std::size_t k = 0; k < kTogether; ++k) write(i + k);
  }
  for (; i < pixels.size(); ++i) write(i);
}

}  // namespace displayfile
