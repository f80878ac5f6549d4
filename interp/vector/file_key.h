#pragma once

#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>

namespace displayfile {

// In a page with several SVG files, ids, classes and style rules are shared by the whole page. So
// ids, and classes that have rules, end in the file's key, which differs between drawings and is
// the same for the same drawing. If a prefix is set (VectorOptions::id_prefix), they begin with
// that instead.

/// Ends a name in a text whose key is not known yet. Names consist of letters, digits, - and _;
/// texts have no control characters.
inline constexpr std::string_view kOwn = "-\x01";

/// The key of a text in parts: 7 characters 0-9a-z, 36 bits of a hash of the bytes.
std::string file_key(std::initializer_list<std::string_view> parts);

/// Writes a text, with the key where kOwn is.
void write_with_key(std::string_view text, std::string_view key, std::ostream& out);
/// Writes a text with the prefix before each name that ends in kOwn, which is left out.
void write_with_prefix(std::string_view text, std::string_view prefix, std::ostream& out);
/// Writes a document in parts: with the prefix, or without one with the key of all parts.
void write_with_own_names(std::initializer_list<std::string_view> parts, std::string_view prefix,
                          std::ostream& out);

}  // namespace displayfile
