#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace displayfile {

inline constexpr std::string_view kXmlDeclaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
/// An attribute of the root of files with layers.
inline constexpr std::string_view kInkscapeNamespace =
    " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"";

/// Escapes characters for XML text between tags.
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

/// The value of font-family for a font, whose name needs no escapes: the name, with sans-serif as a
/// fallback; or one of the generic families of CSS.
inline std::string css_font(const std::string& font) {
  constexpr std::string_view kKinds[] = {"sans-serif", "serif", "monospace", "cursive", "fantasy"};
  if (std::ranges::find(kKinds, font) != std::end(kKinds)) return font;
  return "'" + font + "',sans-serif";
}

/// The same for the value of an attribute, between double quotation marks.
inline void append_escaped_value(std::string& out, std::string_view characters) {
  for (std::size_t end = 0; end != characters.npos;) {
    end = characters.find('"');
    append_escaped(out, characters.substr(0, end));
    if (end == characters.npos) return;
    out += "&quot;";
    characters.remove_prefix(end + 1);
  }
}

}  // namespace displayfile
