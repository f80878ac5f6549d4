#pragma once

#include <cstddef>
#include <string>

#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// The restrictions that the kernel enforces (import_process.md, "What is enforced").
struct Enforced {
  bool memory =
      false;  ///< by the address space; otherwise the waiting process monitors resident memory
  bool files = false;  ///< Landlock: no file is opened but neighbours
  bool calls = false;  ///< seccomp: no system call but those that reading needs
};

/// Confines this process at its start, before anything is loaded: it ends when the waiting process
/// ends, leaves no core file, writes no file, has few files open, and no descriptor but the first
/// `descriptors`; after `seconds` of the processor's time it is ended. Returns false if the waiting
/// process has ended already.
bool begin_confinement(long waiting_process, int descriptors, std::size_t seconds);

/// Restricts the process before a mesh is read: no more than `bytes` of additional memory, no files
/// except the mesh's neighbours, and no system calls except those needed for reading: no socket, no
/// process, no program. Irreversible. Throws Error, naming the mesh, if the kernel offers a
/// protection and then refuses it.
Enforced confine(const NeighbourFiles& neighbours, const std::string& mesh, std::size_t bytes);

}  // namespace displayfile
