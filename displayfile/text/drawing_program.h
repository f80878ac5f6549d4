#pragma once

#include <string>
#include <string_view>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// Carries out a drawing program: UTF-8 text, one user routine a line (the application API's
/// names, hyphens for underscores) followed by its arguments, separated by blanks. `#` starts
/// a comment; blank lines, CR LF and a byte order mark are passed over.
///
/// Throws Error with the message "FILE:LINE:COLUMN: what is wrong and what was expected" for a
/// line that is not understood or that the system refuses, for text that is not UTF-8, and for
/// a segment that the program leaves open. Columns count characters from 1. What the lines
/// before the error did stands.
void replay(std::string_view text, std::string_view file_name, GraphicsSystem& system);

/// Carries out the drawing program in a file; "-" is standard input. Throws as replay does, and
/// Error if the file cannot be read.
void replay_file(const std::string& path, GraphicsSystem& system);

}  // namespace displayfile
