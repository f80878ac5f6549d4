#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "displayfile/segments/display_file.h"

namespace displayfile {

/// A difference between two dumps, and its place in the first.
struct DumpDifference {
  std::string text;
  std::string segment = {};     ///< its name; empty: it is missing
  std::size_t segment_at = 0;   ///< where the segment's line begins, in bytes
  std::size_t instruction = 0;  ///< counted from 1 within the segment; 0: the segment as a whole
};

/// The first difference between two canonical dumps (displayfile/files.h), none if they are the
/// same. The message names the segment, the instruction (counted from 1 within the segment, a
/// line of the dump each) and both values. Throws Error, with the text's name and position, if one
/// of them is not a complete dump.
std::optional<DumpDifference> find_difference(std::string_view actual, std::string_view expected,
                                              std::string_view actual_name = "the dump",
                                              std::string_view expected_name = "the expected dump");

/// The text of that difference. Throws Error, with the text's name and position, if one of them is
/// not a complete dump.
std::optional<std::string> first_difference(std::string_view actual, std::string_view expected,
                                            std::string_view actual_name = "the dump",
                                            std::string_view expected_name = "the expected dump");

/// Throws Error, with the name and position, if the text is not a complete dump.
void require_dump(std::string_view text, std::string_view name);

/// Writes the golden file, completely or not at all. Throws Error if that fails.
void update_golden(const DisplayFile& display_file, const std::string& golden_file,
                   const std::optional<Colour>& fills = {});

}  // namespace displayfile
