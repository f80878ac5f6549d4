#pragma once

#include <cstdint>
#include <memory>

#include "interp/files/row_file.h"

namespace displayfile {

/// A page of pixels, and the place of a picture on it, from the upper left corner.
struct PixelPage {
  int width, height;
  int left, top;
};

/// The file of the page, `file`, written by the rows of the picture; `blank` is the pixel around
/// it.
std::unique_ptr<RowFile> page_row_file(std::unique_ptr<RowFile> file, const PixelPage& page,
                                       std::uint32_t blank);

}  // namespace displayfile
