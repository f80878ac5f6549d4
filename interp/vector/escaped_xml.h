#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace displayfile {

/// Characters as XML has them, between tags.
inline void append_escaped(std::string& out, std::string_view characters) {
  for (const char c : characters) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      default: out.push_back(c);
    }
  }
}

/// The value of font-family for a font, whose name needs no escapes: the name, and sans-serif where
/// the viewer does not have it; or one of the kinds that CSS names.
inline std::string css_font(const std::string& font) {
  constexpr std::string_view kKinds[] = {"sans-serif", "serif", "monospace", "cursive", "fantasy"};
  if (std::ranges::find(kKinds, font) != std::end(kKinds)) return font;
  return "'" + font + "',sans-serif";
}

}  // namespace displayfile
