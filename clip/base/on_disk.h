#pragma once

#include <filesystem>

namespace displayfile {

/// Waits until the file's data is on the disk. False, with errno set, if that fails; true for file
/// systems without such an operation.
bool put_on_disk(int descriptor);

/// The same for the names in a folder; an empty path is the working folder. True also if the folder
/// may not be opened: its contents may be usable all the same.
bool put_names_on_disk(const std::filesystem::path& folder);

}  // namespace displayfile
