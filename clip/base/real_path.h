#pragma once

#include <filesystem>
#include <system_error>

namespace displayfile {

/// The absolute path after following symbolic links, including links to files that do not exist
/// yet. Empty, with the error, if it cannot be found, as for circular links.
std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);

}  // namespace displayfile
