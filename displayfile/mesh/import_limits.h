#pragma once

#include <cstddef>

namespace displayfile {

/// What the import library may take to read one mesh, in the process of its own in which it runs
/// (import_process.md). OBJ, OFF, PLY and STL are read in this process, and need none of it.
struct ImportLimits {
  std::size_t memory = std::size_t{2} << 30;  ///< bytes, beside what the library itself takes
  double seconds = 60.0;                      ///< by the clock
  /// Where there is no such process: formats are read whose readers are not on the list of those
  /// that are allowed (allowed_formats.h). Elsewhere it changes nothing.
  bool any_format = false;
};

}  // namespace displayfile
