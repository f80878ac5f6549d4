#pragma once

#include <string>
#include <string_view>

namespace displayfile {

/// Throws Error, naming the option, for a text with invalid UTF-8 or control characters.
void require_drawable(std::string_view option, std::string_view text);

/// The title of a document: the value of --title, which must be drawable, or a file's name, with
/// '?' for characters that are not.
std::string title_or_name(const std::string& title, const std::string& name);

}  // namespace displayfile
