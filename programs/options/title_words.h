#pragma once

#include <string>
#include <string_view>

namespace displayfile {

/// Throws Error, naming the option, for a text that holds what no document does: what is not UTF-8,
/// and control characters.
void require_drawable(std::string_view option, std::string_view text);

/// The title of a document: what --title says, which must be drawable, or a file's name, in which
/// '?' stands for what is not.
std::string title_or_name(const std::string& title, const std::string& name);

}  // namespace displayfile
