#include "interp/files/picture_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "clip/base/error.h"

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

void count_kind(std::int32_t a, std::int32_t b, PictureDifference& result) {
  if (a >= 0 && b >= 0) {
    ++result.polygon_and_polygon;
  } else {
    ++result.background_and_polygon;
    if (a < 0) ++result.background_in_first;
  }
}

void measure_depth_error(const std::vector<double>& a, const std::vector<double>& b,
                         PictureDifference& result) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isfinite(a[i]) != std::isfinite(b[i])) ++result.finite_in_one;
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
    const double error = std::abs(a[i] - b[i]);
    result.largest_error = std::max(result.largest_error, error);
    sum += error;
    ++result.finite_in_both;
  }
  if (result.finite_in_both > 0) sum /= static_cast<double>(result.finite_in_both);
  result.mean_error = sum;
}

constexpr std::uint32_t kMark = 0xFF0000FF;  // red
constexpr std::uint32_t kPaper = 0xFFFFFFFF;

std::uint32_t grey(std::uint32_t tone) { return 0xFF000000u | tone << 16 | tone << 8 | tone; }

/// Light enough for the marks to stand out; consecutive identifiers have distinguishable tones.
std::uint32_t tone_of(std::int32_t id) {
  return id < 0 ? kPaper : grey(192u + static_cast<std::uint32_t>(id) * 23u % 48u);
}
std::uint32_t tone_of(double depth) { return std::isfinite(depth) ? grey(216) : kPaper; }

std::uint32_t lightened(std::uint32_t pixel) {
  const std::uint32_t red = pixel & 0xff, green = pixel >> 8 & 0xff, blue = pixel >> 16 & 0xff;
  return grey(191u + (red + 2 * green + blue) / 16u);
}

void require_same_size(bool same) {
  if (!same) throw Error("the sizes differ: wrong pixels cannot be marked");
}

}  // namespace

PictureDifference compare(const Picture& a, const Picture& b, int tolerance) {
  PictureDifference result;
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) {
    result.same_size = false;
    return result;
  }
  result.pixels = static_cast<std::int64_t>(a.pixels.size());
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i] == b.pixels[i]) continue;
    const int apart = largest_channel_difference(a.pixels[i], b.pixels[i]);
    result.wrong_pixels += apart > tolerance ? 1 : 0;
    largest = std::max(largest, apart);
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
            count_kind(va[i], vb[i], result);
          }
        }
        if constexpr (std::is_same_v<decltype(va), decltype(vb)> &&
                      std::is_floating_point_v<std::decay_t<decltype(va[0])>>) {
          measure_depth_error(va, vb, result);
        }
      },
      a.values, b.values);
  return result;
}

Picture marked(const Picture& a, const Picture& b, int tolerance) {
  require_same_size(a.width == b.width && a.height == b.height);
  Picture marks{a.width, a.height, {}, {}, {}};
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const bool wrong = largest_channel_difference(a.pixels[i], b.pixels[i]) > tolerance;
    marks.pixels.push_back(wrong ? kMark : lightened(a.pixels[i]));
  }
  return marks;
}

Picture marked(const NpyArray& a, const NpyArray& b) {
  require_same_size(a.width == b.width && a.height == b.height);
  Picture marks{a.width, a.height, {}, {}, {}};
  std::visit(
      [&](const auto& va, const auto& vb) {
        for (std::size_t i = 0; i < va.size(); ++i) {
          const double apart = difference(static_cast<double>(va[i]), static_cast<double>(vb[i]));
          marks.pixels.push_back(apart == 0.0 ? tone_of(va[i]) : kMark);
        }
      },
      a.values, b.values);
  return marks;
}

}  // namespace displayfile
