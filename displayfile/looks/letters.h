#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// Sizes of letters relative to the em. Approximate, since fonts differ.
constexpr double kCapitalHeight = 0.7, kLetterAdvance = 0.6;

/// The number of characters of a text in UTF-8.
inline std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Approximate extent of a text, relative to its anchor, in heights of the picture, y up; the
/// letters stand on y = 0.
inline PaperBox letters_at_anchor(const TextStyle& style, std::string_view text) {
  const double width = kLetterAdvance * style.size * static_cast<double>(letters_of(text));
  const double before = style.alignment == TextStyle::Alignment::left    ? 0.0
                        : style.alignment == TextStyle::Alignment::right ? width
                                                                         : 0.5 * width;
  return {{-before, 0.0}, {width - before, kCapitalHeight * style.size}};
}

/// A text of a scene, for views that make room for its letters.
struct PlacedText {
  Point3 anchor;     ///< in world coordinates
  PaperBox letters;  ///< relative to the anchor in the picture, in its heights, y up
};

}  // namespace displayfile
