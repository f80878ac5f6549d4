// The title, and the parts list.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "interp/annotation/page_annotation.h"

namespace displayfile {

namespace {

constexpr double kTitle = 1.43;  // times the annotation's size: the next but one of ISO 3098
// In parts of the capitals' height.
constexpr double kTableMargin = 1.2, kTableRow = 2.0, kPadding = 0.7;

}  // namespace

double AnnotationPencil::margin_of_list(double height) { return kTableMargin * height; }

std::vector<PartsListRow> parts_list_rows(std::span<const KeptAnnotation> all) {
  std::map<int, PartsListRow> rows;
  for (const KeptAnnotation& balloon : all) {
    if (balloon.kind != KeptAnnotation::Kind::balloon || balloon.name.empty()) continue;
    int number = 0;
    const std::string& digits = balloon.characters;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    ++rows.try_emplace(number, PartsListRow{number, balloon.name, 0}).first->second.quantity;
  }
  std::vector<PartsListRow> result;
  result.reserve(rows.size());
  for (const auto& [number, row] : rows) result.push_back(row);
  return result;
}

void AnnotationPencil::title() {
  height_ *= kTitle;
  text(kept_->characters, {0.5 * page_.width, page_.height - kTableMargin * height_ - height_},
       TextStyle::Alignment::centre);
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
