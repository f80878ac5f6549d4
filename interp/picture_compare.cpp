#include "interp/picture_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace displayfile {

namespace {

int largest_channel_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const int channel_a = static_cast<int>((a >> shift) & 0xff);
    const int channel_b = static_cast<int>((b >> shift) & 0xff);
    largest = std::max(largest, std::abs(channel_a - channel_b));
  }
  return largest;
}

double difference(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0.0;
  const double apart = std::abs(a - b);
  return std::isfinite(apart) ? apart : std::numeric_limits<double>::infinity();
}

}  // namespace

PictureDifference compare(const Picture& a, const Picture& b) {
  PictureDifference result;
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) {
    result.same_size = false;
    return result;
  }
  result.pixels = static_cast<std::int64_t>(a.pixels.size());
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i] == b.pixels[i]) continue;
    ++result.wrong_pixels;
    largest = std::max(largest, largest_channel_difference(a.pixels[i], b.pixels[i]));
  }
  result.largest = largest;
  return result;
}

PictureDifference compare(const NpyArray& a, const NpyArray& b) {
  PictureDifference result;
  std::visit(
      [&](const auto& va, const auto& vb) {
        if (a.width != b.width || a.height != b.height || va.size() != vb.size()) {
          result.same_size = false;
          return;
        }
        result.pixels = static_cast<std::int64_t>(va.size());
        for (std::size_t i = 0; i < va.size(); ++i) {
          const double apart = difference(static_cast<double>(va[i]), static_cast<double>(vb[i]));
          if (apart == 0.0) continue;
          ++result.wrong_pixels;
          result.largest = std::max(result.largest, apart);
          if constexpr (std::is_same_v<decltype(va), decltype(vb)> &&
                        std::is_integral_v<std::decay_t<decltype(va[0])>>) {
            const bool background = va[i] < 0 || vb[i] < 0;
            ++(background ? result.background_and_polygon : result.polygon_and_polygon);
          }
        }
      },
      a.values, b.values);
  return result;
}

}  // namespace displayfile
