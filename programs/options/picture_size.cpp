#include "programs/options/picture_size.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string_view>

#include "clip/base/error.h"
#include "interp/device/picture.h"
#include "interp/draw/size_on_paper.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void PictureSizeWord::add_to(CLI::App& command, bool on_paper) {
  option = command
               .add_option("--size", size,
                           on_paper ? "in pixels; of a PDF, in points; or in mm, such as 80x60mm: "
                                      "the sheet's size or, with --paper, the picture's on it, or "
                                      "that of a PNG with --dpi. By default on paper, its shape"
                                    : "in pixels; of a PDF, in points")
               ->type_name(on_paper ? "WIDTHxHEIGHT[mm]" : "WIDTHxHEIGHT")
               ->capture_default_str()
               ->group(kPictureOptions);
}

std::optional<MillimetreSize> PictureSizeWord::millimetres() const {
  return millimetre_size(size, "--size");
}

void PictureSizeWord::read(int& width, int& height) const {
  long long across = 0, up = 0;
  const char *p = size.data(), *end = p + size.size();
  const auto w = std::from_chars(p, end, across);
  const bool cross = w.ec == std::errc{} && w.ptr != end && (*w.ptr == 'x' || *w.ptr == 'X');
  const auto h = cross ? std::from_chars(w.ptr + 1, end, up) : w;
  if (!cross || h.ec != std::errc{} || h.ptr != end) {
    throw Error(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, such as 512x512", size));
  }
  require_picture_size(across, up);
  width = static_cast<int>(across);
  height = static_cast<int>(up);
}

double PictureSizeWord::aspect() const {
  int width = 0, height = 0;
  read(width, height);
  return static_cast<double>(width) / height;
}

}  // namespace displayfile
