#pragma once

#include <filesystem>

namespace displayfile {

// A folder that is held can be found again after it has been moved; where the system has none such,
// every folder is kNotHeld, and paths start from where the process is.

inline constexpr int kNotHeld = -1;

/// A number for the folder; kNotHeld if it cannot be held.
int hold_folder(const std::filesystem::path& folder);
void release_folder(int held);
/// Removes the folder, by its path from a held one, if nothing is in it.
void remove_empty_folder(int held, const std::filesystem::path& path);

/// Removes a file, or a folder in which nothing is; false if neither could be removed. For signal
/// handlers too.
bool remove_path(const char* path) noexcept;

}  // namespace displayfile
