#include "programs/inputs/made_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "clip/base/error.h"
#include "clip/system/descriptors.h"

namespace displayfile {

namespace fs = std::filesystem;

void MadeFolders::make_for(const fs::path& file) {
  const std::lock_guard lock(one_at_a_time_);
  const fs::path folder = file.parent_path();
  std::error_code error;
  std::vector<fs::path> missing;
  fs::path above = folder;
  for (; !above.empty() && !fs::exists(above, error); above = above.parent_path()) {
    missing.push_back(above);
  }
  if (missing.empty()) return;
  std::ranges::reverse(missing);
  const int from = above.empty() ? kNotHeld : held(above);
  const UnfinishedPath::Naming naming;
  for (const fs::path& made : missing) {
    made_.push_back({from, from == kNotHeld ? made : made.lexically_relative(above)});
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

int MadeFolders::held(const fs::path& folder) {
  constexpr std::size_t kMostHeld = 64;
  const auto found = held_.find(folder);
  if (found != held_.end()) return found->second;
  if (held_.size() >= kMostHeld) return kNotHeld;
  const int number = hold_folder(folder);
  if (number != kNotHeld) held_.emplace(folder, number);
  return number;
}

MadeFolders::~MadeFolders() {
  std::ranges::reverse(made_);
  // Folders that are not empty stay.
  for (const auto& [from, path] : made_) remove_empty_folder(from, path);
  for (const auto& [path, number] : held_) release_folder(number);
}

}  // namespace displayfile
