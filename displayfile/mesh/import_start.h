#pragma once

#include <functional>
#include <string>
#include <vector>

namespace displayfile {

/// Starts the import program with these words, the first of which is its path, and with the
/// descriptors on which it answers and writes messages; returns the process, or minus the number of
/// an error.
using ImportStarter = std::function<int(std::vector<std::string>& words, int reply, int messages)>;

/// What starts the import program: posix_spawn. Tests that read very many files put something in
/// its place which does the same in less time, before any mesh is read.
ImportStarter& import_starter();

}  // namespace displayfile
