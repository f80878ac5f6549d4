#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <string_view>

namespace displayfile {

/// Throws Error for an input that is a folder, and for a pattern such as *.stl that names no file
/// and that no shell has expanded.
void require_no_folder_or_pattern(const std::string& input);

/// Throws Error if a word of a command's line would be an input, names no file and looks like a
/// value: after an option without one ("--pens 3"), or after one whose values are separated by
/// commas ("--lines outline crease"). `words` are those after the command's name.
void require_no_mistaken_values(const CLI::App& command, std::span<char* const> words);

}  // namespace displayfile
