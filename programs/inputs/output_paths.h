#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace displayfile {

/// The file to which an output's name resolves, for detecting two names of one file; also for
/// standard output, or "-" if it is not a file. None for another device or pipe, which several
/// outputs may share, for no name, and if unknown.
std::optional<std::filesystem::path> output_at(const std::filesystem::path& name);
/// The same of an input's name, where "-" is standard input.
std::optional<std::filesystem::path> input_at(const std::filesystem::path& name);

/// Throws Error, before any work, if two outputs of a command are one file, or both are standard
/// output; or if one of them is one of its inputs, or a list of these (input_lists). Empty names
/// are ignored.
void require_files_of_their_own(std::span<const std::string> outputs,
                                std::span<const std::string> inputs,
                                std::span<const std::string> lists = {});
/// The same for a command that writes one file of each kind, with require_no_field.
void require_files_of_their_own(std::initializer_list<std::string> outputs,
                                std::span<const std::string> inputs,
                                std::span<const std::string> lists = {});

/// Throws Error for the output of a command that writes one file, if its name has a field
/// (output_name.h).
void require_no_field(const std::string& output);

/// Throws Error unless the output has the extension, such as ".html", or is standard output.
void require_extension(const std::string& output, const char* extension, const char* what);

}  // namespace displayfile
