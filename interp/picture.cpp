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

}  // namespace displayfile
