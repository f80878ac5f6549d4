#include "displayfile/characters.h"

#include <fmt/format.h>

namespace displayfile {

namespace {

unsigned byte(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
}

/// Whether the character, of that many bytes, can be written in UTF-8 but not drawn.
bool is_control(std::string_view text, std::size_t length) {
  const unsigned first = byte(text, 0), second = byte(text, 1);
  if (length == 1) return first < 0x20 || first == 0x7F;
  if (length == 2) return first == 0xC2 && second < 0xA0;  // U+0080 to U+009F
  return length == 3 && first == 0xEF && second == 0xBF && byte(text, 2) >= 0xBE;
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

std::size_t drawable_length(std::string_view text) {
  std::size_t drawable = 0;
  while (drawable < text.size()) {
    const std::string_view rest = text.substr(drawable);
    const std::size_t length = utf8_length(rest);
    if (length == 0 || is_control(rest, length)) break;
    drawable += length;
  }
  return drawable;
}

std::string not_drawable(std::string_view text) {
  if (utf8_length(text) == 0) {
    return fmt::format("byte {:#04x} in a text: expected UTF-8", byte(text, 0));
  }
  const unsigned character =
      byte(text, 0) < 0x80 ? byte(text, 0)
      : byte(text, 0) < 0xE0
          ? (byte(text, 0) & 0x1F) << 6 | (byte(text, 1) & 0x3F)
          : (byte(text, 0) & 0x0F) << 12 | (byte(text, 1) & 0x3F) << 6 | (byte(text, 2) & 0x3F);
  return fmt::format("character U+{:04X} in a text: expected characters that can be drawn",
                     character);
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
