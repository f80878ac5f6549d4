#include "tests/bench/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace displayfile::bench {

namespace {

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += fmt::format(" {:<{}} |", cells[i], widths[i]);
  return text + "\n";
}

}  // namespace

std::string text_table(const std::vector<std::string>& heads,
                       const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    std::size_t width = heads[i].size();
    for (const auto& row : rows) width = std::max(width, row[i].size());
    widths.push_back(width);
  }
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.push_back(std::string(width, '-'));
  std::string text = line(heads, widths) + line(rule, widths);
  for (const auto& row : rows) text += line(row, widths);
  return text;
}

std::string text_table(const std::vector<Result>& results) {
  std::vector<std::vector<std::string>> rows;
  for (const Result& r : results) {
    rows.push_back({r.work, r.asked, r.measured, r.spread, r.beside, r.verdict});
  }
  return text_table({"work", "asked", "measured", "least to greatest", "beside it", ""}, rows);
}

}  // namespace displayfile::bench
