#pragma once

#include <string_view>

namespace displayfile {

/// How texts are drawn, in the font that the system calls "sans-serif" and in the line style's
/// colour: black where that is none.
struct TextStyle {
  /// Which point of the text's base line stands at its anchor, the current position.
  enum class Alignment { left, centre, right };
  double size = 0.03;  ///< of the letters (the em), where the picture's height is 1
  Alignment alignment = Alignment::left;
  bool always = false;  ///< seen also where hidden surfaces are removed and hide the anchor
  bool operator==(const TextStyle&) const = default;
};

/// Reads `left`, `centre` or `right`; throws Error for anything else.
TextStyle::Alignment alignment(std::string_view text);
std::string_view name_of(TextStyle::Alignment alignment);

}  // namespace displayfile
