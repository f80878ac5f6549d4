#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/bench/command/temporary_folder.h"

// Tests that write files.

namespace displayfile::test {

/// The bytes of a file. Fails the test if it cannot be read: two files of which neither is there
/// would be equal.
inline std::string content(const std::filesystem::path& path) {
  const std::ifstream file(path, std::ios::binary);
  if (!file) ADD_FAILURE() << path << ": cannot be read";
  std::ostringstream all;
  all << file.rdbuf();
  return all.str();
}

/// A test with a folder of its own, gone afterwards.
class TemporaryFolder : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  /// Writes it.
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  bool empty_folder() const { return std::filesystem::is_empty(folder_); }

  const bench::TemporaryFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

}  // namespace displayfile::test
