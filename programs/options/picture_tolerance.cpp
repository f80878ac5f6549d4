#include "programs/options/picture_tolerance.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void PictureTolerance::add_to(CLI::App& command) {
  command
      .add_option("--tolerance", channel,
                  "for pictures: a pixel is wrong if a channel differs by more than this, of 255")
      ->type_name("N")
      ->transform(number_in(0, 255))
      ->capture_default_str()
      ->group(kPictureOptions);
  command
      .add_option("--wrong-pixels", wrong_pixels,
                  "for pictures: number of wrong pixels allowed, such as 20, or 0.5% of all")
      ->type_name("N|SHARE%")
      ->group(kPictureOptions);
}

std::int64_t PictureTolerance::most_wrong(std::int64_t pixels) const {
  if (wrong_pixels.empty()) return 0;
  const bool percent = wrong_pixels.ends_with('%');
  const char* const end = wrong_pixels.data() + wrong_pixels.size() - (percent ? 1 : 0);
  double value = 0.0;
  const auto [stop, failure] = std::from_chars(wrong_pixels.data(), end, value);
  const bool number = failure == std::errc{} && stop == end && value >= 0.0 &&
                      (percent ? value <= 100.0 : value <= 1e15 && value == std::floor(value));
  if (!number) {
    throw Error(
        fmt::format("--wrong-pixels {}: expected a number of pixels, such as 20, or 0% to "
                    "100% of all",
                    wrong_pixels));
  }
  if (!percent) return static_cast<std::int64_t>(value);
  // More than the rounding of a share of whole pixels, and less than any decimals that are meant.
  constexpr double kRounding = 1e-15;
  return static_cast<std::int64_t>(value * static_cast<double>(pixels) / 100.0 * (1.0 + kRounding));
}

bool PictureTolerance::passes(const PictureDifference& difference) const {
  return difference.same_size && difference.wrong_pixels <= most_wrong(difference.pixels);
}

bool is_picture_file(const std::string& name) {
  const std::string extension = extension_of(name);
  return extension == ".png" || extension == ".ppm";
}

Picture read_picture(const std::string& name) {
  return extension_of(name) == ".ppm" ? read_ppm(name) : read_png(name, Alpha::stored);
}

}  // namespace displayfile
