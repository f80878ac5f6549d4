#pragma once

#include <string>

namespace displayfile {

/// Looks for what the import library would pass over in silence, or would allocate memory for
/// without end, before it sees the file:
///   any format   not a regular file, or empty;
///   OBJ          indices and coordinates, each checked;
///   OFF          announced counts against the lines that follow, corners of a face, indices,
///                coordinates;
///   PLY          the header's keywords;
///   PLY, STL     announced counts, lists included, against the bytes that follow.
/// Other formats are left to the library. Throws Error with file, line and column (text) or
/// file alone (binary), and what was expected.
void check_mesh_file(const std::string& path);

}  // namespace displayfile
