#pragma once

#include <functional>
#include <string>
#include <vector>

namespace displayfile {

/// Starts the import program with these words, the first of which is its path, and with the
/// descriptors for its reply and messages; returns the process, or minus the errno.
using ImportStarter = std::function<int(std::vector<std::string>& words, int reply, int messages)>;

/// The function that starts the import program: posix_spawn. Tests that read very many files
/// replace it by a faster equivalent before any mesh is read.
ImportStarter& import_starter();

}  // namespace displayfile
