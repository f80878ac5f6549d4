#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "programs/bench/summary.h"

namespace displayfile::bench {

/// A text in Markdown with blocks that a report's summaries are written into:
///
///   <!-- bench: methods -->
///   whatever the last run wrote
///   <!-- bench: end -->
class ReadmeFigures {
 public:
  /// Reads the file and finds its blocks. Throws Error, with the file and the line, for one whose
  /// name is none of summary_names(), or that has no end or no beginning; and if the file cannot be
  /// read or has no block.
  explicit ReadmeFigures(std::string path);

  /// The whole text, with the summaries in its blocks. Throws Error, with the file and the line,
  /// for a block that none of them is for.
  std::string with(std::span<const Summary> summaries) const;

 private:
  struct Block {
    std::string name;
    std::size_t begin, end;  // the lines of its markers, counted from 0
  };
  void find_blocks();
  std::string place(std::size_t line) const;

  std::string path_;
  std::vector<std::string> lines_;
  std::vector<Block> blocks_;
};

}  // namespace displayfile::bench
