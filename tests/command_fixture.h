#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

inline std::string read(const fs::path& file) { return displayfile::test::content(file); }

/// The command `displayfile` as its users meet it: run in a folder of the test's own.
class Command : public displayfile::test::TemporaryFolder {
 protected:
  static inline const std::string kTriangle =
      "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
      "polygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n";

  void write(const std::string& name, const std::string& text) { file(name, text); }

  /// Runs the command in the test's folder; standard output and error go to out_ and err_.
  int run(const std::string& arguments, const std::string& input = "/dev/null") {
    const std::string line = "cd '" + folder_.string() + "' && " + before_ +
                             "'" DISPLAYFILE_COMMAND "' " + arguments + " <" + input +
                             " >.out 2>.err";
    const int status = std::system(line.c_str());
    out_ = read(folder_ / ".out");
    err_ = read(folder_ / ".err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Runs the command, which must succeed. Returns false only if this build lacks a library and the
  /// message names it: then a test may be skipped. Any other failure fails the test.
  bool can_run(const std::string& arguments, const std::string& lacks) {
    const int status = run(arguments);
    if (status == 2 && err_.find(lacks) != std::string::npos) return false;
    EXPECT_EQ(status, 0) << arguments << "\n" << err_;
    return true;
  }

  /// Exit status 2, a message of one line that holds the words, nothing printed, and no file
  /// but those that were there.
  void expect_error(const std::string& arguments, const std::string& words,
                    const std::string& input = "/dev/null") {
    const auto files = [&] {
      std::vector<std::string> names;
      for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        if (name != ".out" && name != ".err") names.push_back(name);
      }
      std::ranges::sort(names);
      return names;
    };
    const auto before = files();
    EXPECT_EQ(run(arguments, input), 2) << arguments;
    EXPECT_NE(err_.find(words), std::string::npos) << arguments << "\n" << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
    EXPECT_EQ(out_, "");
    EXPECT_EQ(files(), before) << arguments;
  }

  std::string before_;  ///< run by the shell first
  std::string out_, err_;
};
