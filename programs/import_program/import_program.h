#pragma once

#include <string>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// A library that reads meshes for a waiting process.
struct MeshReader {
  /// Loads the library, before the process is confined. Throws Error, naming the mesh.
  void (*load)(const std::string& path);
  /// Reads a mesh, confined. `deflection`: ImportLimits::deflection. Throws Error, naming it.
  Mesh (*read)(const std::string& path, bool with_normals, double deflection);
};

/// The program `displayfile-import`, with its arguments (displayfile/mesh/import_protocol.h): reads
/// one mesh by Assimp, confined, for the waiting process, replies on a pipe, and ends this process.
/// Returns a status if it was called wrongly or no process waits.
int read_for_waiting_process(int argc, char** argv);
/// The same by another library.
int read_for_waiting_process(int argc, char** argv, const MeshReader& reader);

}  // namespace displayfile
