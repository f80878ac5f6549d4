#pragma once

#include <filesystem>
#include <system_error>

namespace displayfile {

/// Where a path leads, from the root: symbolic links are followed, those to what is not there yet,
/// too. Empty, with the error, where it cannot be told, as where links lead around.
std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);

}  // namespace displayfile
