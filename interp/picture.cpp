#include "interp/picture.h"

#include <fmt/format.h>

#include "clip/error.h"

namespace displayfile {

void require_picture_size(long long width, long long height) {
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw Error(fmt::format("picture size {}x{}: expected 1x1 to {}x{} pixels", width, height,
                            kLargestSide, kLargestSide));
  }
}

std::uint32_t pixel_of(const Colour& colour) {
  const auto byte = [](double c) { return static_cast<std::uint32_t>(c * 255.0 + 0.5); };
  return 0xFF000000u | byte(colour.b) << 16 | byte(colour.g) << 8 | byte(colour.r);
}

}  // namespace displayfile
