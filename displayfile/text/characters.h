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

/// The text without a UTF-8 byte order mark.
std::string_view without_byte_order_mark(std::string_view text);

/// The length in bytes of the drawable characters at the start of the text: UTF-8, without control
/// characters and Unicode's noncharacters (U+FDD0 to U+FDEF, and U+FFFE, U+FFFF and so on of each
/// plane). The full length if all are drawable.
std::size_t drawable_length(std::string_view text);

/// The error at the start of a text that does not begin with a drawable character, for messages.
std::string not_drawable(std::string_view text);

/// The text with '?' for characters that cannot be drawn.
std::string drawable(std::string_view text);

/// The text in quotation marks, as in drawing programs and dumps: with a backslash before quotation
/// marks and backslashes only.
std::string in_quotation_marks(std::string_view text);

}  // namespace displayfile
