#include "clip/base/real_path.h"

namespace displayfile {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path, std::error_code& error) {
  constexpr int kMostLinks = 40;  // as the system has it
  fs::path followed = fs::absolute(path, error);
  for (int links = 0; !error && links < kMostLinks; ++links) {
    followed = fs::weakly_canonical(followed, error);
    if (error) break;
    // That follows no link to what is not there.
    std::error_code not_there;
    if (!fs::is_symlink(fs::symlink_status(followed, not_there))) return followed;
    followed = followed.parent_path() / fs::read_symlink(followed, error);
  }
  if (!error) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
  return {};
}

}  // namespace displayfile
