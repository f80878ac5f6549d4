#pragma once

#include <filesystem>

namespace displayfile {

/// Waits until what was written to the file is on the disk. False, with the reason in errno, if it
/// cannot be put there; true where the file system knows no such thing.
bool put_on_disk(int descriptor);

/// The same of the names in a folder; an empty path is the working folder. True also where the
/// folder may not be opened: what is in it may be used all the same.
bool put_names_on_disk(const std::filesystem::path& folder);

}  // namespace displayfile
