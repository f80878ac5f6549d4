#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace displayfile {

// Names of outputs with fields that stand for parts of an input's name, such as
// "thumbnails/{name}.png", when each of many inputs is drawn into a file of its own:
//   {name}    the input's file name without its extension, unless that would leave "." or "..";
//             stdin for standard input
//   {ext}     its extension without the dot; if it has none, the dot before the field goes too
//   {folder}  its folder; below the text before the field, if there is one: then without a
//             root and without ".."
//   {number}  its place among the inputs, from 000
//   {{ and }} braces

/// True if the text has a field or a brace.
bool is_name_pattern(std::string_view text);

/// True if the text has one of these fields.
bool has_field(std::string_view text);

/// The name of the output of input k of `count`, from 0. Throws Error for an unknown field or an
/// unmatched brace.
std::string output_name(std::string_view pattern, const std::string& input, std::size_t k,
                        std::size_t inputs);

/// The folder that stands before the first field: it is not made, while those that fields name are.
std::filesystem::path folder_before_fields(std::string_view pattern);

/// The input's folders as they are kept below another one: without a root and without "..".
std::filesystem::path folder_within(const std::string& input);

}  // namespace displayfile
