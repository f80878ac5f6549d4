#include "interp/draw/size_on_paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "clip/base/error.h"
#include "clip/point.h"
#include "interp/device/picture.h"

namespace displayfile {

std::optional<MillimetreSize> millimetre_size(std::string_view size, std::string_view option) {
  constexpr std::string_view kMillimetresWord = "mm";
  if (!size.ends_with(kMillimetresWord)) return std::nullopt;
  MillimetreSize sides{};
  const char* const end = size.data() + size.size() - kMillimetresWord.size();
  auto [p, failure] = std::from_chars(size.data(), end, sides.width);
  const bool has_width = failure == std::errc{};
  const std::string_view rest(p, static_cast<std::size_t>(end - p));
  if (rest.starts_with(kMillimetresWord)) p += kMillimetresWord.size();
  const bool has_cross = has_width && p != end && (*p == 'x' || *p == 'X');
  const auto height = has_cross ? std::from_chars(p + 1, end, sides.height)
                                : std::from_chars_result{p, std::errc::invalid_argument};
  if (height.ec != std::errc{} || height.ptr != end) {
    throw Error(fmt::format("{} {}: expected WIDTHxHEIGHTmm, such as 80x60mm", option, size));
  }
  for (const double side : {sides.width, sides.height}) {
    if (side >= 1.0 && side <= kLargestSheet) continue;
    throw Error(fmt::format("{} {}: expected sides of 1 to {} mm", option, size, kLargestSheet));
  }
  return sides;
}

namespace {

/// In mm; a point for a picture of unknown density.
double usual_pixel(const DrawOptions& options) {
  return options.dpi ? kMillimetresOfInch / *options.dpi : 1.0 / kPointsOfMillimetre;
}

/// A picture's sides in pixels.
struct Sides {
  int width, height;
};

/// In mm: the pixel size with which the picture covers the whole room.
double covering_pixel(const Sides& sides, const Point2& room) {
  return std::max(room.x / sides.width, room.y / sides.height);
}

int whole_side(double side) { return std::max(1, static_cast<int>(std::lround(side))); }

Sides usual_sides(const Point2& room, double pixel) {
  return {whole_side(room.x / pixel), whole_side(room.y / pixel)};
}

/// The first picture with about that pixel size and nearly the room's shape; millimetres.
Sides sides_of_shape(const Point2& room, double pixel) {
  constexpr double kAbout = 0.02;
  const Sides usual_ones = usual_sides(room, pixel);
  const int usual = usual_ones.width;
  const auto sides = [&](int width) { return Sides{width, whole_side(width * room.y / room.x)}; };
  const auto over = [&](const Sides& of) {
    const double covering = covering_pixel(of, room);
    return std::max(covering * of.width - room.x, covering * of.height - room.y);
  };
  const int most = static_cast<int>(kAbout * usual);
  for (int k = 0; k <= most; ++k) {
    for (const int width : {usual - k, usual + k}) {
      if (over(sides(width)) <= kOverMargins) return sides(width);
    }
  }
  return usual_ones;
}

}  // namespace

void take_shape_of_paper(DrawOptions& options, bool at_scale) {
  if (!options.vectors.paper) options.vectors.paper.emplace();
  Paper& paper = *options.vectors.paper;
  const PaperFit fit = fit_on_paper(paper, options.width, options.height);
  paper.turned = fit.width > fit.height ? Paper::Turned::landscape : Paper::Turned::portrait;
  const Point2 room = Point2(fit.width, fit.height) - 2.0 * paper.margin;
  const double pixel = usual_pixel(options);
  if (options.dpi) {
    const auto pixels = [&](double side) {
      return std::max(1, static_cast<int>(std::floor(side / pixel + 1e-6)));
    };
    options.width = pixels(room.x);
    options.height = pixels(room.y);
    return;
  }
  const Sides sides = at_scale ? sides_of_shape(room, pixel) : usual_sides(room, pixel);
  options.width = sides.width;
  options.height = sides.height;
  const double covering = covering_pixel(sides, room);
  const Point2 over = covering * Point2(sides.width, sides.height) - room;
  if (at_scale && std::max(over.x, over.y) <= kOverMargins) paper.pixel = covering;
}

void take_size_on_paper(const MillimetreSize& size, DrawOptions& options) {
  const double pixel = usual_pixel(options);
  const Point2 room(size.width, size.height);
  const bool on_sheet = options.vectors.paper && !options.dpi;
  const Sides sides = on_sheet ? sides_of_shape(room, pixel) : usual_sides(room, pixel);
  options.width = sides.width;
  options.height = sides.height;
  if (options.dpi) return;
  if (on_sheet) {
    options.vectors.paper->pixel = covering_pixel(sides, room);
    return;
  }
  const bool is_wide = size.width > size.height;
  options.vectors.paper =
      Paper{.width = size.width,
            .height = size.height,
            .margin = 0.0,
            .turned = is_wide ? Paper::Turned::landscape : Paper::Turned::portrait};
}

}  // namespace displayfile
