#pragma once

#include <string>
#include <vector>

namespace displayfile::bench {

/// What a figure is asked to be, what it was measured to be, and whether it holds.
struct Result {
  std::string work, asked, measured, spread, beside, verdict;
};

/// The verdicts.
inline std::string holds_if(bool holds) { return holds ? "holds" : "DOES NOT HOLD"; }

/// A table in Markdown, its columns aligned.
std::string text_table(const std::vector<std::string>& heads,
                       const std::vector<std::vector<std::string>>& rows);
std::string text_table(const std::vector<Result>& results);

}  // namespace displayfile::bench
