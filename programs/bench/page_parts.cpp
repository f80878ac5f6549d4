#include "programs/bench/page_parts.h"

#include <fmt/format.h>

#include <map>

#include "programs/bench/json_report.h"

namespace displayfile::bench {

namespace {

/// Distinct also for most who do not see all colours.
std::string colour_of(const std::string& method) {
  static const std::map<std::string, std::string> colours{
      {"none", "#7f7f7f"},        {"z-buffer", "#1f5fbf"},   {"plain-z-buffer", "#e08a00"},
      {"bsp", "#1f8f3f"},         {"depth-sort", "#c92a2a"}, {"scan-line", "#7b3fb5"},
      {"scan-line-z", "#8c5a2b"}, {"warnock", "#d6489a"},    {"ray-cast", "#0f9aa8"},
      {"osmesa", "#111111"},      {"auto", "#8fce00"},       {"embree", "#b8a000"},
      {"gl2ps", "#ff6f61"},       {"roberts", "#1f5fbf"},    {"appel", "#e08a00"},
      {"franklin", "#c92a2a"},    {"map", "#3a4a9f"},
  };
  const auto colour = colours.find(method);
  return colour == colours.end() ? "#556b2f" : colour->second;
}

}  // namespace

Mark mark_of(const std::vector<Column>& all, const Column& column) {
  int shape = 0;
  for (const Column& c : all) {
    if (c == column) break;
    shape += c.method == column.method;
  }
  return {colour_of(column.method), shape, column.exact || column.precision.empty()};
}

std::string table_row(std::string_view tag, const std::vector<std::string>& cells) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) text += fmt::format("<{}>{}", tag, cell);
  return text + '\n';
}

std::string spread_cells(const Spread& s) {
  return number(s.median) + "<td>" + number(s.least) + "<td>" + number(s.greatest);
}

std::string row_begun(const Cell& cell) {
  return fmt::format("<tr><td>{}<td class='l'>{}<td>{}<td>{}", escaped(cell.key.method),
                     escaped(cell.key.precision), cell.key.threads, cell.exact ? "exact" : "");
}

std::string row_skipped(const Cell& cell, int columns) {
  return row_begun(cell) +
         fmt::format("<td class='l' colspan='{}'>skipped: {}\n", columns, escaped(cell.skipped));
}

}  // namespace displayfile::bench
