#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/order_of_entry.h"
#include "tests/truth_scenes.h"

// Sorted display files painted, compared with the truth of the scene as entered.

namespace displayfile::test {

/// A polygon, or a piece of one.
struct Fill {
  Vertices vertices;
  int pick = 0;
};
using Fills = std::vector<Fill>;

inline Colour colour_of(int pick) {
  return {pick % 5 / 4.0, pick / 5 % 5 / 4.0, pick / 25 % 5 / 4.0};
}

template <class Instructions>
void enter(Instructions& instructions, const Fills& fills) {
  instructions.set_style(LineStyle{LineStyle::Kind::none});
  for (const Fill& fill : fills) {
    instructions.set_style(FillStyle{FillStyle::Kind::solid, colour_of(fill.pick)});
    instructions.set_pick(fill.pick);
    instructions.enter_polygon(fill.vertices, std::vector<std::uint8_t>(fill.vertices.size(), 1));
  }
}

inline void enter_segment(DisplayFile& file, int name, const Fills& entered,
                          const Fills& back_to_front) {
  Segment& segment = file.create(name);
  enter(segment, entered);
  Instructions sorted;
  enter(sorted, back_to_front);
  segment.close();
  segment.set_sorted(in_order_of_entry(std::move(sorted)));
}

inline DisplayFile file_of(const Fills& entered, const Fills& back_to_front) {
  DisplayFile file;
  enter_segment(file, 1, entered, back_to_front);
  return file;
}

inline Picture paint(const DisplayFile& file, int width, int height, bool sorted = true,
                     int threads = 1) {
  const RasterRequest request{.width = width,
                              .height = height,
                              .surfaces = {.method = HiddenMethod::none, .threads = threads},
                              .sorted = sorted,
                              .ids = true};
  return draw_with_software(file, request);
}

inline std::size_t heedless_errors(const DisplayFile& file, int width, int height) {
  return different(paint(file, width, height, false).ids, truth(file, width, height, false).ids);
}

/// Describes the errors in the painting, for 1, 2 and 3 threads; empty if there are none.
inline std::string wrong(const DisplayFile& file, int width, int height,
                         const std::vector<std::int32_t>& expected) {
  std::optional<std::size_t> undecided;
  for (const int threads : {1, 2, 3}) {
    const Picture painted = paint(file, width, height, true, threads);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const std::size_t row = k / static_cast<std::size_t>(width);
      const std::size_t column = k % static_cast<std::size_t>(width);
      const std::uint32_t colour = expected[k] < 0 ? 0xFFFFFFFF : pixel_of(colour_of(expected[k]));
      if (painted.ids[k] == expected[k] && painted.pixels[k] == colour) continue;
      return fmt::format("{} threads: row {} from the top, column {}: painted {}, truth {}",
                         threads, row, column, painted.ids[k], expected[k]);
    }
    if (undecided && undecided != painted.undecided_centres) return "threads change the count";
    undecided = painted.undecided_centres;
  }
  return {};
}

inline std::string wrong(const DisplayFile& file, int width, int height) {
  return wrong(file, width, height, truth(file, width, height, false).ids);
}

/// The side of a small picture.
inline constexpr int kSize = 16;

inline const Fill kBackdrop{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0};

}  // namespace displayfile::test
