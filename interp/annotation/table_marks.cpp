// The title, and the parts list.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "displayfile/text/characters.h"
#include "interp/annotation/page_annotation.h"

namespace displayfile {

namespace {

// In parts of the capitals' height.
constexpr double kTableMargin = 1.2, kTableRow = 2.0, kPadding = 0.7;
constexpr double kTitlePitch = 1.6;            // from baseline to baseline
constexpr double kTitleOfPicture = 1.0 / 3.0;  // of the picture's height, at the most

/// Broken at blanks into lines of that width, in parts of the capitals' height; a wider word has a
/// line of its own. A text that fits stays as it is.
std::vector<std::string> in_lines(std::string_view text, double width) {
  std::vector<std::string> lines;
  std::string line;
  if (width_of_text(text) <= width) return {std::string(text)};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && width_of_text(longer) > width) {
      lines.push_back(std::exchange(line, word));
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

/// In quotation marks, separated by `and`.
std::string listed(const std::set<std::string>& names) {
  std::vector<std::string> quoted;
  quoted.reserve(names.size());
  for (const std::string& name : names) quoted.push_back(in_quotation_marks(name));
  return fmt::format("{}", fmt::join(quoted, " and "));
}

}  // namespace

double AnnotationPencil::margin_of_list(double height) { return kTableMargin * height; }

std::vector<PartsListRow> parts_list_rows(std::span<const KeptAnnotation> all) {
  std::vector<PartsListRow> rows;
  std::map<std::pair<int, std::string_view>, std::size_t> places;  // in rows
  for (const KeptAnnotation& balloon : all) {
    if (balloon.kind != KeptAnnotation::Kind::balloon || balloon.name.empty()) continue;
    int number = 0;
    const std::string& digits = balloon.characters;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const auto [known, is_new] =
        places.try_emplace(std::pair(number, std::string_view(balloon.name)), rows.size());
    if (is_new) rows.push_back({number, balloon.name, 0});
    ++rows[known->second].quantity;
  }
  std::ranges::stable_sort(rows, {}, &PartsListRow::number);
  return rows;
}

std::vector<std::string> parts_list_faults(std::span<const PartsListRow> rows) {
  std::map<int, std::set<std::string>> names_of;
  std::map<std::string, std::set<int>> numbers_of;
  for (const PartsListRow& row : rows) {
    names_of[row.number].insert(row.name);
    numbers_of[row.name].insert(row.number);
  }
  std::vector<std::string> several_names, several_numbers, faults;
  for (const auto& [number, names] : names_of) {
    if (names.size() > 1) several_names.push_back(fmt::format("{} is {}", number, listed(names)));
  }
  for (const auto& [name, numbers] : numbers_of) {
    if (numbers.size() == 1) continue;
    several_numbers.push_back(
        fmt::format("{} is {}", in_quotation_marks(name), fmt::join(numbers, " and ")));
  }
  if (!several_names.empty()) {
    faults.push_back(
        fmt::format("the parts list has several names for a number: {}: expected one for each",
                    fmt::join(several_names, ", ")));
  }
  if (!several_numbers.empty()) {
    faults.push_back(
        fmt::format("the parts list has several numbers for a name: {}: expected one for each",
                    fmt::join(several_numbers, ", ")));
  }
  return faults;
}

/// In letters as large as the picture's width and a third of its height allow, in several lines if
/// need be, but not larger than `title_reduced` says.
void AnnotationPencil::title(const PageAnnotation& title) {
  const double size = height_;
  std::vector<std::string> lines;
  for (std::size_t k = title.title_reduced; k < kTitleHeights.size(); ++k) {
    height_ = kTitleHeights[k] * size;
    const double room = page_.width / height_ - 2.0 * kTableMargin;
    lines = in_lines(kept_->characters, room);
    const double high = 1.0 + kTitlePitch * static_cast<double>(lines.size() - 1);
    const bool is_low = lines.size() == 1 || high * height_ <= kTitleOfPicture * page_.height;
    if (is_low && std::ranges::all_of(
                      lines, [&](const std::string& line) { return width_of_text(line) <= room; }))
      break;
  }
  double base = page_.height - kTableMargin * height_ - height_;
  for (const std::string& line : lines) {
    text(line, {0.5 * page_.width, base}, TextStyle::Alignment::centre);
    base -= kTitlePitch * height_;
  }
}

/// A head, then the rows by number, between lines (ISO 7573). It hides the figure.
void AnnotationPencil::parts_list(const PageAnnotation& list, std::span<const PartsListRow> rows) {
  if (rows.empty()) return;
  std::vector<std::array<std::string, 3>> cells(1);
  std::ranges::copy(kPartsListHeads, cells.front().begin());
  for (const PartsListRow& row : rows) {
    cells.push_back({fmt::format("{}", row.number), row.name, fmt::format("{}", row.quantity)});
  }
  std::array<double, 4> columns{};  // their left sides, and the last one's right side
  for (std::size_t c = 0; c < 3; ++c) {
    double width = 0.0;
    for (const auto& row : cells) width = std::max(width, width_of(row[c]));
    columns[c + 1] = columns[c] + width + 2.0 * kPadding * height_;
  }
  const double width = columns[3], margin = margin_of_list(height_);
  const double height = kTableRow * height_ * static_cast<double>(cells.size());
  const Point2 in_corner(list.corner.x > 0.0 ? page_.width - margin - width : margin,
                         list.corner.y > 0.0 ? page_.height - margin : margin + height);
  const auto [left, top] =
      std::pair(list.top_left.value_or(in_corner).x, list.top_left.value_or(in_corner).y);
  const std::vector<Point2> frame{
      {left, top}, {left + width, top}, {left + width, top - height}, {left, top - height}};
  add(AnnotationMark::Kind::blank).points = frame;
  line(frame, true);
  for (std::size_t c = 1; c < 3; ++c) {
    line({{left + columns[c], top}, {left + columns[c], top - height}});
  }
  for (std::size_t r = 0; r < cells.size(); ++r) {
    const double y = top - kTableRow * height_ * static_cast<double>(r);
    if (r > 0) line({{left, y}, {left + width, y}});
    const double base = y - 0.5 * (kTableRow + 1.0) * height_;
    text(cells[r][0], {left + 0.5 * columns[1], base}, TextStyle::Alignment::centre);
    text(cells[r][1], {left + columns[1] + kPadding * height_, base}, TextStyle::Alignment::left);
    text(cells[r][2], {left + 0.5 * (columns[2] + columns[3]), base}, TextStyle::Alignment::centre);
  }
}

}  // namespace displayfile
