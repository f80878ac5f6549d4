#include "hard/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

namespace {

std::vector<std::string> cells(const Tally& tally) {
  std::vector<std::string> texts{fmt::format("{}", tally.scenes), fmt::format("{}", tally.pixels)};
  for (long long wrong : tally.wrong) texts.push_back(fmt::format("{}", wrong));
  return texts;
}

std::vector<std::string> heads(std::span<const Method> methods) {
  std::vector<std::string> texts{"scenes", "pixels"};
  for (const Method& method : methods) texts.push_back(method.column);
  return texts;
}

std::vector<TableRow> with_total(std::span<const TableRow> rows) {
  std::vector<TableRow> all(rows.begin(), rows.end());
  all.push_back({"total", total(rows)});
  return all;
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  scenes += other.scenes;
  polygons += other.polygons;
  pixels += other.pixels;
  wrong.resize(other.wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i] += other.wrong[i];
  return *this;
}

Tally judge(const Scene& scene, const Picture& right, std::span<const Method> methods) {
  const GraphicsSystem system = entered(scene);
  Tally tally{1,
              static_cast<long long>(scene.polygons()),
              static_cast<long long>(right.width) * right.height,
              {}};
  for (const Method& method : methods) {
    tally.wrong.push_back(wrong_pixels(method.draw(system.display_file(), right.width), right));
  }
  return tally;
}

Tally total(std::span<const TableRow> rows) {
  Tally sum;
  for (const TableRow& row : rows) sum += row.tally;
  return sum;
}

std::string text_table(std::span<const TableRow> rows, std::span<const Method> methods,
                       const std::string& first_column) {
  const std::vector<TableRow> all = with_total(rows);
  std::size_t name_width = first_column.size();
  for (const TableRow& row : all) name_width = std::max(name_width, row.name.size());
  const std::vector<std::string> head = heads(methods), sums = cells(all.back().tally);
  std::string text;
  const auto line = [&](const std::string& name, const std::vector<std::string>& row) {
    text += fmt::format("{:<{}}", name, name_width);
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("  {:>{}}", row[i], std::max(head[i].size(), sums[i].size()));
    }
    text += '\n';
  };
  line(first_column, head);
  for (const TableRow& row : all) line(row.name, cells(row.tally));
  return text;
}

std::string markdown_table(std::span<const TableRow> rows, std::span<const Method> methods,
                           const std::string& first_column) {
  std::string text = fmt::format("| {} |", first_column), rule = "|---|";
  for (const std::string& head : heads(methods)) {
    text += fmt::format(" {} |", head);
    rule += "---:|";
  }
  text += '\n' + rule + '\n';
  for (const TableRow& row : with_total(rows)) {
    text += fmt::format("| {} |", row.name);
    for (const std::string& cell : cells(row.tally)) text += fmt::format(" {} |", cell);
    text += '\n';
  }
  return text;
}

std::string csv_table(std::span<const TableRow> rows, std::span<const Method> methods,
                      const std::string& first_column) {
  std::string text = first_column + ",scenes,polygons,pixels";
  for (const Method& method : methods) text += fmt::format(",\"{}\"", method.name);
  text += '\n';
  for (const TableRow& row : rows) {
    text += fmt::format("{},{},{},{}", row.name, row.tally.scenes, row.tally.polygons,
                        row.tally.pixels);
    for (long long wrong : row.tally.wrong) text += fmt::format(",{}", wrong);
    text += '\n';
  }
  return text;
}

}  // namespace displayfile
