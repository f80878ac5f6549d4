#include "programs/bench/readme_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "clip/error.h"

namespace displayfile::bench {

namespace {

constexpr std::string_view kEnd = "end";

/// The name in a marker; nothing if the line is none.
std::optional<std::string> marked(std::string_view line) {
  constexpr std::string_view kOpen = "<!-- bench:", kClose = "-->";
  if (!line.starts_with(kOpen)) return std::nullopt;
  line.remove_prefix(kOpen.size());
  std::string name(line.substr(0, line.find(kClose)));
  std::erase_if(name, [](char c) { return c == ' ' || c == '\r'; });
  return name;
}

std::string table_row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += cell.empty() ? " |" : ' ' + cell + " |";
  return text + '\n';
}

std::string markdown(const Summary& summary) {
  std::string text = summary.text + '\n';
  if (summary.rows.empty()) return text;
  text += '\n' + table_row(summary.rows.front()) + '|';
  for (std::size_t i = 0; i < summary.rows.front().size(); ++i) {
    text += summary.is_of_numbers(i) ? "---:|" : "---|";
  }
  text += '\n';
  for (std::size_t i = 1; i < summary.rows.size(); ++i) text += table_row(summary.rows[i]);
  return text;
}

}  // namespace

ReadmeFigures::ReadmeFigures(std::string path) : path_(std::move(path)) {
  std::ifstream in(path_, std::ios::binary);
  if (!in) throw Error(path_ + ": cannot be read");
  for (std::string line; std::getline(in, line);) lines_.push_back(line);
  find_blocks();
}

std::string ReadmeFigures::place(std::size_t line) const {
  return fmt::format("{}:{}: ", path_, line + 1);
}

void ReadmeFigures::find_blocks() {
  const std::vector<std::string> names = summary_names();
  std::optional<Block> open;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto name = marked(lines_[i]);
    if (!name) continue;
    if (*name == kEnd) {
      if (!open) throw Error(place(i) + "the end of no block");
      open->end = i;
      blocks_.push_back(*std::exchange(open, std::nullopt));
      continue;
    }
    if (open) throw Error(place(open->begin) + "the block '" + open->name + "' has no end");
    if (std::ranges::find(names, *name) == names.end()) {
      std::string expected;
      for (const std::string& known : names) expected += ' ' + known;
      throw Error(place(i) + "no such block '" + *name + "': expected one of" + expected);
    }
    open = Block{*name, i, i};
  }
  if (open) throw Error(place(open->begin) + "the block '" + open->name + "' has no end");
  if (blocks_.empty()) throw Error(path_ + ": no block such as <!-- bench: methods -->");
}

std::string ReadmeFigures::with(std::span<const Summary> summaries) const {
  std::string text;
  std::size_t line = 0;
  const auto copy_until = [&](std::size_t end) {
    for (; line < end; ++line) text += lines_[line] + '\n';
  };
  for (const Block& block : blocks_) {
    const auto summary = std::ranges::find(summaries, block.name, &Summary::name);
    if (summary == summaries.end()) {
      throw Error(place(block.begin) + "this run has no figures for the block '" + block.name +
                  "'");
    }
    copy_until(block.begin + 1);
    text += markdown(*summary);
    line = block.end;
  }
  copy_until(lines_.size());
  return text;
}

}  // namespace displayfile::bench
