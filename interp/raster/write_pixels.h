#pragma once

#include <cstdint>
#include <span>

namespace displayfile {

/// Writes pixel_of[number[i]] into pixels[i], in the widest vectors that the processor has.
void write_pixels(std::span<const std::uint32_t> number, const std::uint32_t* pixel_of,
                  std::uint32_t* pixels);

}  // namespace displayfile
