#pragma once

#include <string>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// What the import library says of a file that it does not read.
class NotRead : public Error {
 public:
  using Error::Error;
};

/// Reads a mesh by the import library, as read_by_import_library does, in a process of its own
/// (import_process.md): what the library does there, this process goes on. It may be called from
/// several threads at once. What readers write to standard error is written to std::cerr.
///
/// Throws NotRead where read_by_import_library throws Error, with its words; and Error, naming the
/// file, if the library crashed on it, took longer or more memory than the limits say, or if the
/// process cannot be started. The limits must be more than zero.
Mesh read_by_import_process(const std::string& path, bool with_normals, const ImportLimits& limits);

}  // namespace displayfile
