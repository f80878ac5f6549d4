#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>

#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/output_device.h"

// The visible lines of programs, by the methods of lines.

namespace displayfile::test {

inline constexpr HiddenMethod kMethodsOfLines[] = {HiddenMethod::franklin, HiddenMethod::roberts,
                                                   HiddenMethod::appel};

/// The length of the visible lines, in units of the picture; only those of one colour if it is
/// given, otherwise without those of polygon 0.
inline double length_of(const GraphicsSystem& g, HiddenMethod method,
                        const std::optional<Colour>& colour = std::nullopt) {
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = method;
  const DrawnPieces pieces = drawn_pieces(sorted.update(g, method, options));
  double length = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces.kinds[k] != DrawnPieces::Kind::line) continue;
    if (colour ? pieces.line_colours[k] != *colour : pieces.picks[k] == 0) continue;
    length += glm::distance(Point2(pieces.points[pieces.first[k]]),
                            Point2(pieces.points[pieces.first[k] + 1]));
  }
  return length;
}

/// The lines of a program, in the colour of all of them, by every method.
inline void expect_length(const char* program, const Colour& colour, double length) {
  GraphicsSystem g;
  replay(program, "test", g);
  for (const HiddenMethod method : kMethodsOfLines) {
    EXPECT_NEAR(length_of(g, method, colour), length, 1e-9) << name_of(method);
  }
}

}  // namespace displayfile::test
