#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "displayfile/segments/display_file.h"

namespace displayfile {

/// The first difference between two canonical dumps (displayfile/files.h), none if they are the
/// same. The message names the segment, the instruction (counted from 1 within the segment, a
/// line of the dump each) and both values:
///   segment 3, instruction 17 (line 0.1 0.25 0): y is 0.25, expected 0.5
/// Throws Error, with the text's name and the place, if one of them is not a whole dump.
std::optional<std::string> first_difference(std::string_view actual, std::string_view expected,
                                            std::string_view actual_name = "the dump",
                                            std::string_view expected_name = "the expected dump");

/// Throws Error, with the name and the place, if the text is not a whole dump.
void require_dump(std::string_view text, std::string_view name);

/// The first difference between what is dumped of the display file and a golden file, which
/// holds a dump. Throws Error, naming the file, if it cannot be read or is not a whole dump.
std::optional<std::string> check_golden(const DisplayFile& display_file,
                                        const std::string& golden_file);

/// Writes the golden file, whole or not at all. Throws Error if that fails.
void update_golden(const DisplayFile& display_file, const std::string& golden_file,
                   const std::optional<Colour>& fills = {});

}  // namespace displayfile
