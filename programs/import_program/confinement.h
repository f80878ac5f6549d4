#pragma once

#include <cstddef>
#include <string>

#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// What the kernel was got to enforce (import_process.md, "What is enforced").
struct Enforced {
  bool memory = false;  ///< by the address space; else whoever waits watches what is resident
  bool files = false;   ///< Landlock: no file is opened but neighbours
  bool calls = false;   ///< seccomp: no system call but those that reading needs
};

/// What a process gives up at its start, before anything is loaded: it ends when the one that
/// waits for it ends, leaves no core file, writes no file, has few files open, and no descriptor
/// but the first `descriptors`; after `seconds` of the processor's time it is ended. False if the
/// process that waits has ended already.
bool begin_confinement(long waiting_process, int descriptors, std::size_t seconds);

/// What it gives up before a mesh is read: memory beyond `bytes` more than it has, files but the
/// mesh's neighbours, and all system calls but those that reading needs: no socket, no process, no
/// program. It cannot be taken back. Throws Error, naming the mesh, where the kernel offers a
/// protection and then refuses it.
Enforced confine(const NeighbourFiles& neighbours, const std::string& mesh, std::size_t bytes);

}  // namespace displayfile
