#include "programs/sheet/drawing_scale.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "clip/base/error.h"

namespace displayfile {

std::string DrawingScale::text() const { return fmt::format("{}:{}", paper, part); }

std::optional<DrawingScale> read_scale(std::string_view word) {
  DrawingScale scale;
  const char *const begin = word.data(), *const end = begin + word.size();
  const auto first = std::from_chars(begin, end, scale.paper);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ':') {
    const auto second = std::from_chars(first.ptr + 1, end, scale.part);
    if (second.ec == std::errc{} && second.ptr == end && scale.paper > 0.0 && scale.part > 0.0 &&
        std::isfinite(scale.paper) && std::isfinite(scale.part)) {
      return scale;
    }
  }
  return std::nullopt;
}

DrawingScale drawing_scale(std::string_view word) {
  if (const auto scale = read_scale(word)) return *scale;
  throw Error(
      fmt::format("--scale {}: expected PAPER:PART, two positive numbers, such as 1:2", word));
}

DrawingScale largest_standard_scale(const std::function<bool(double)>& fits) {
  for (double power = 1e6; power >= 1.0; power /= 10.0) {
    for (const double k : {5.0, 2.0, 1.0}) {
      const DrawingScale scale{k * power, 1.0};
      if (fits(scale.factor())) return scale;
    }
  }
  for (double power = 1.0; power <= 1e9; power *= 10.0) {
    for (const double k : {1.0, 2.0, 5.0}) {
      const DrawingScale scale{1.0, k * power};
      if (fits(scale.factor())) return scale;
    }
  }
  throw Error("no standard scale makes the views fit on the paper");
}

}  // namespace displayfile
