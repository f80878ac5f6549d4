#pragma once

#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>

namespace displayfile {

// In a page that holds several SVG files, ids, classes and rules of style are those of the page.
// So ids, and classes that have rules, end in the file's key: of other drawings it is another, and
// of the same drawing the same.

/// Ends a name in a text whose key is not known yet. Names and texts have no control characters.
inline constexpr std::string_view kOwn = "-\x01";

/// The key of a text in parts: 7 characters 0-9a-z, 36 bits of a hash of the bytes.
std::string file_key(std::initializer_list<std::string_view> parts);

/// Writes a text, with the key where kOwn is.
void write_with_key(std::string_view text, std::string_view key, std::ostream& out);

}  // namespace displayfile
