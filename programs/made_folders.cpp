#include "programs/made_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "clip/error.h"
#include "displayfile/on_disk.h"

namespace displayfile {

namespace fs = std::filesystem;

void MadeFolders::make_for(const fs::path& file) {
  const std::lock_guard lock(one_at_a_time_);
  const fs::path folder = file.parent_path();
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path above = folder; !above.empty() && !fs::exists(above, error);
       above = above.parent_path()) {
    missing.push_back(above);
  }
  if (missing.empty()) return;
  std::ranges::reverse(missing);
  const UnfinishedPath::Naming naming;
  for (const fs::path& made : missing) {
    made_.push_back(made);
    unfinished_.emplace_back(made.string());
  }
  fs::create_directories(folder, error);
  if (error) throw Error(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  for (const fs::path& made : missing) {
    if (put_names_on_disk(made.parent_path())) continue;
    throw Error(fmt::format("{}: is made, but may not be on the disk: {}", made.string(),
                            std::strerror(errno)));
  }
}

MadeFolders::~MadeFolders() {
  std::ranges::reverse(made_);
  std::error_code not_empty;
  for (const fs::path& folder : made_) fs::remove(folder, not_empty);
}

}  // namespace displayfile
