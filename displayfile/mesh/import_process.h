#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The import library's message about a file that it cannot read.
class NotRead : public Error {
 public:
  using Error::Error;
};

/// A program that reads meshes for this process.
struct ImportProgram {
  const char* name;      ///< of its file
  const char* variable;  ///< of the environment: replaces the places to look for it
  const char* library;   ///< by which it reads, for messages
  const char* package;   ///< of Debian, that has it
};

/// Reads a mesh by such a program, as read_by_import_process does by Assimp.
Mesh read_by_program(const ImportProgram& program, const std::string& path, bool with_normals,
                     const ImportLimits& limits);

/// Reads a mesh by the import library, as read_by_import_library does, in a separate process
/// (import_process.md), so that faults of the library do not affect this process. Several threads
/// may call it at once. Output of readers on standard error goes to std::cerr.
///
/// Throws NotRead where read_by_import_library throws Error, with its message; and Error, naming
/// the file, if the library crashed, exceeded the limits of time or memory, or the process cannot
/// be started. The limits of time and memory must be more than zero, the deflection finite and not
/// negative.
Mesh read_by_import_process(const std::string& path, bool with_normals, const ImportLimits& limits);

/// Starts the import program with these arguments, the first of which is its path, and with the
/// descriptors for its reply and messages; returns the process, or minus the errno.
using ImportStarter = std::function<int(std::vector<std::string>& words, int reply, int messages)>;

/// The function that starts the import program: posix_spawn. Tests that read very many files
/// replace it by a faster equivalent before any mesh is read.
ImportStarter& import_starter();

}  // namespace displayfile
