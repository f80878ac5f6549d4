#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// The figures of a report that answer one question: a section of the page, and a block of a README
/// (programs/bench/readme_figures.h).
struct Summary {
  std::string name;   ///< of the block
  std::string title;  ///< on the page
  std::string text;   ///< before the table; plain
  /// The first is the head; none: no table.
  std::vector<std::vector<std::string>> rows;

  /// True if the column is of numbers, which stand to the right.
  bool is_of_numbers(std::size_t column) const;
};

/// Those that the report has figures for.
std::vector<Summary> summaries(const Report& report);

/// The names of all that there can be.
std::vector<std::string> summary_names();

}  // namespace displayfile::bench
