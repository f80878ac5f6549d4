#include "displayfile/text/characters.h"

#include <fmt/format.h>

#include <algorithm>

namespace displayfile {

namespace {

unsigned byte(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
}

/// The character of `length` bytes at the start of the text.
unsigned character_at_start(std::string_view text, std::size_t length) {
  if (length == 1) return byte(text, 0);
  unsigned character = byte(text, 0) & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) character = character << 6 | (byte(text, i) & 0x3F);
  return character;
}

/// True if a character can be encoded in UTF-8 but not drawn: control characters, and Unicode's
/// noncharacters (which Cairo refuses, and XML in part).
bool is_no_character(unsigned character) {
  const auto in = [&](unsigned low, unsigned high) {
    return character >= low && character <= high;
  };
  return character < 0x20 || in(0x7F, 0x9F) || in(0xFDD0, 0xFDEF) ||
         (character & 0xFFFE) == 0xFFFE;  // the last two of each plane
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto in = [](unsigned value, unsigned low, unsigned high) {
    return value >= low && value <= high;
  };
  const unsigned first = byte(text, 0);
  if (first < 0x80) return 1;
  if (in(first, 0xC2, 0xDF)) return in(byte(text, 1), 0x80, 0xBF) ? 2 : 0;
  const unsigned second_low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned second_high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (!in(byte(text, 1), second_low, second_high) || !in(byte(text, 2), 0x80, 0xBF)) return 0;
  if (in(first, 0xE0, 0xEF)) return 3;
  return in(first, 0xF0, 0xF4) && in(byte(text, 3), 0x80, 0xBF) ? 4 : 0;
}

bool begins_in_utf16(std::string_view text) {
  const auto is_ascii = [](char high, char low) {
    return high == 0 && low != 0 && static_cast<unsigned char>(low) < 0x80;
  };
  if (text.size() < 4) return false;
  return (text.starts_with("\xFF\xFE") && is_ascii(text[3], text[2])) ||
         (text.starts_with("\xFE\xFF") && is_ascii(text[2], text[3]));
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::size_t drawable_length(std::string_view text) {
  std::size_t drawable = 0;
  while (drawable < text.size()) {
    const std::string_view rest = text.substr(drawable);
    const std::size_t length = utf8_length(rest);
    if (length == 0 || is_no_character(character_at_start(rest, length))) break;
    drawable += length;
  }
  return drawable;
}

std::string not_drawable(std::string_view text) {
  const std::size_t length = utf8_length(text);
  if (length == 0) return fmt::format("byte {:#04x} in a text: expected UTF-8", byte(text, 0));
  return fmt::format("character U+{:04X} in a text: expected characters that can be drawn",
                     character_at_start(text, length));
}

std::string drawable(std::string_view text) {
  std::string result;
  for (;;) {
    const std::size_t length = drawable_length(text);
    result += text.substr(0, length);
    text.remove_prefix(length);
    if (text.empty()) return result;
    result += '?';
    text.remove_prefix(std::max<std::size_t>(utf8_length(text), 1));
  }
}

std::string in_quotation_marks(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted += '"';
}

}  // namespace displayfile
