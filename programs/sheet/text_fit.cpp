#include "programs/sheet/text_fit.h"

#include <algorithm>
#include <array>
#include <optional>

#include "displayfile/text/characters.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

namespace {

constexpr std::array kHeights{3.5, 2.5, 1.8};
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

/// Characters of ASCII by width, in twentieths of the font's size, rounded up.
struct WidthClass {
  int twentieths;
  std::string_view characters;
};
constexpr std::array kWidths{
    WidthClass{6, "'IJijl"},    WidthClass{7, " ,./:;\\|"},
    WidthClass{8, "()-[]ft"},   WidthClass{9, "!r"},
    WidthClass{10, "\"*_`"},    WidthClass{11, "?csz"},
    WidthClass{12, "FLkvxy"},   WidthClass{13, "$0123456789EPSTYabdeghnopqu{}"},
    WidthClass{14, "ABCKRVXZ"}, WidthClass{15, "NU"},
    WidthClass{16, "&DGHOQ"},   WidthClass{17, "#+<=>^w~"},
    WidthClass{18, "M"},        WidthClass{20, "%@Wm"},
};

std::size_t length_of_character(std::string_view text) {
  return std::max<std::size_t>(utf8_length(text), 1);
}

/// In parts of the font's size; of letters beyond ASCII as most are at the most.
double width_of_character(std::string_view character) {
  constexpr double kOfTwoBytes = 0.8, kOfMore = 1.0;
  if (character.size() > 1) return character.size() == 2 ? kOfTwoBytes : kOfMore;
  const auto* const found = std::ranges::find_if(kWidths, [&](const WidthClass& widths) {
    return widths.characters.find(character) != std::string_view::npos;
  });
  return found == kWidths.end() ? kOfMore : found->twentieths / 20.0;
}

/// A line may end after these.
bool may_be_broken_after(char c) { return std::string_view(" -_/").find(c) != std::string::npos; }

/// Bytes of the text's first line. Blanks at its end need no room. Within words it is broken where
/// it must and may be; 0 if it may not.
std::size_t first_line(std::string_view text, double height, double room, bool within_words) {
  double width = 0.0;
  std::size_t at = 0, at_break = 0;
  while (at < text.size()) {
    const std::string_view character = text.substr(at, length_of_character(text.substr(at)));
    width += width_of_character(character) * height / kCapitalsOfFont;
    if (width > room && character != " ") break;
    at += character.size();
    if (may_be_broken_after(character.back())) at_break = at;
  }
  if (at == text.size()) return at;
  if (at_break > 0) return at_break;
  return within_words ? std::max(at, length_of_character(text)) : 0;
}

std::string_view without_blanks_around(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Nothing if words must be broken that may not be.
std::optional<std::vector<std::string>> in_lines(std::string_view text, double height, double room,
                                                 bool within_words) {
  std::vector<std::string> lines;
  text = without_blanks_around(text);
  while (!text.empty()) {
    const std::size_t length = first_line(text, height, room, within_words);
    if (length == 0) return std::nullopt;
    lines.emplace_back(without_blanks_around(text.substr(0, length)));
    text = without_blanks_around(text.substr(length));
  }
  return lines;
}

std::size_t most_lines(double room, double height) {
  return 1 + static_cast<std::size_t>(std::max(0.0, (room - height) / (kLinePitch * height)));
}

/// With an ellipsis in place of its end.
std::string shortened(std::string line, double height, double room) {
  while (!line.empty() && text_width(line + std::string(kEllipsis), height) > room) {
    const auto is_within_character = [&] { return (line.back() & 0xC0) == 0x80; };
    while (line.size() > 1 && is_within_character()) line.pop_back();
    line.pop_back();
  }
  return std::string(without_blanks_around(line)) + std::string(kEllipsis);
}

}  // namespace

double text_width(std::string_view text, double height) {
  double width = 0.0;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    width += width_of_character(text.substr(0, length));
    text.remove_prefix(length);
  }
  return width * height / kCapitalsOfFont;
}

FittedText fit_text(std::string_view text, const Point2& room) {
  for (const bool within_words : {false, true}) {
    for (const double height : kHeights) {
      auto lines = in_lines(text, height, room.x, within_words);
      if (lines && lines->size() <= most_lines(room.y, height)) return {height, std::move(*lines)};
    }
  }
  const double height = kHeights.back();
  std::vector<std::string> lines = *in_lines(text, height, room.x, true);
  lines.resize(most_lines(room.y, height));
  lines.back() = shortened(std::move(lines.back()), height, room.x);
  return {height, std::move(lines), false};
}

}  // namespace displayfile
