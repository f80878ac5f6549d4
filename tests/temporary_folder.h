#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/bench/command/temporary_folder.h"

// Tests that write files.

namespace displayfile::test {

/// The bytes of a file; none if it cannot be read.
inline std::string content(const std::filesystem::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
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
