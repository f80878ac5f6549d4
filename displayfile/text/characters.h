#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace displayfile {

/// Length in bytes of the UTF-8 character at the start of a text that is not empty; 0 if there is
/// none (RFC 3629, section 4).
std::size_t utf8_length(std::string_view text);

/// True if a text begins in UTF-16: with its byte order mark, and a character of ASCII.
bool begins_in_utf16(std::string_view text);

/// The text but for the byte order mark of UTF-8 with which some editors begin one.
std::string_view without_byte_order_mark(std::string_view text);

/// How many bytes at the start of the text are characters that can be drawn: UTF-8, without control
/// characters and what Unicode says is no character (U+FDD0 to U+FDEF, and U+FFFE, U+FFFF and so on
/// of each plane). All of them, if the text is one.
std::size_t drawable_length(std::string_view text);

/// What is wrong at the start of a text whose first byte is of no character that can be drawn: for
/// messages.
std::string not_drawable(std::string_view text);

/// The text with '?' in the place of what cannot be drawn.
std::string drawable(std::string_view text);

/// The text in quotation marks, as drawing programs and dumps have it: a backslash stands before
/// quotation marks and backslashes, and nowhere else.
std::string in_quotation_marks(std::string_view text);

}  // namespace displayfile
