#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "programs/sheet/arrangement.h"
#include "programs/sheet/text_fit.h"

namespace displayfile {

namespace {

void add_rectangle(const Point2& low, const Point2& high, DrawingSheet& sheet) {
  sheet.lines.push_back({SheetLayer::frame, {low, {high.x, low.y}, high, {low.x, high.y}}, true});
}

void add_circle(const Point2& middle, double radius, DrawingSheet& sheet) {
  constexpr int kSides = 72;
  DrawingSheet::Line circle{SheetLayer::text, {}, true};
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    circle.points.push_back(middle + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  sheet.lines.push_back(circle);
}

/// A part of the title block.
struct Cell {
  Point2 low, high;
};

constexpr double kInset = 1.6;

/// A truncated cone and its view from the left, where its small end is (ISO 5456-2): beside that
/// end by the third angle, on the other side by the first. Smaller in a cell that is narrow.
void add_projection_symbol(const Cell& cell, SheetProjection projection, DrawingSheet& sheet) {
  constexpr double kSmall = 2.0, kLarge = 4.0, kHalfLength = 4.0, kApart = 6.0;
  const double room = 0.5 * (cell.high.x - cell.low.x) - kInset;
  const double size = std::min(1.0, room / (kApart + kHalfLength));
  const double to_cone = size * (projection == SheetProjection::third ? kApart : -kApart);
  const Point2 middle = 0.5 * (cell.low + cell.high);
  const Point2 cone = middle + Point2(to_cone, 0.0), circles = middle - Point2(to_cone, 0.0);
  sheet.lines.push_back(
      {SheetLayer::text,
       {cone + size * Point2(-kHalfLength, -kSmall), cone + size * Point2(kHalfLength, -kLarge),
        cone + size * Point2(kHalfLength, kLarge), cone + size * Point2(-kHalfLength, kSmall)},
       true});
  add_circle(circles, size * kSmall, sheet);
  add_circle(circles, size * kLarge, sheet);
}

/// A label and, below it, a text that keeps within the cell.
void add_field(const Cell& cell, const char* label, const std::string& text, DrawingSheet& sheet) {
  constexpr double kLabel = 1.8, kApart = 1.3;
  const Point2 corner(cell.low.x + kInset, cell.high.y - kInset - kLabel);
  sheet.texts.push_back({corner, kLabel, label});
  const double top = corner.y - kApart;
  const Point2 room(cell.high.x - cell.low.x - 2.0 * kInset, top - cell.low.y - kInset);
  const FittedText fitted = fit_text(text, room);
  double baseline = top - fitted.height;
  for (const std::string& line : fitted.lines) {
    sheet.texts.push_back({{corner.x, baseline}, fitted.height, line});
    baseline -= kLinePitch * fitted.height;
  }
  if (!fitted.whole) {
    sheet.shortened.push_back(fmt::format("{} {}", label, fmt::join(fitted.lines, " ")));
  }
}

constexpr double kListRow = 6.0;  // mm

/// Rows from below: the headings, and the parts in order.
void add_parts_list(const SheetWords& words, DrawingSheet& sheet) {
  const PaperBox block = block_of_titles(words);
  const double width = block.high.x - block.low.x;
  const std::array columns{block.low.x, block.low.x + 0.12 * width, block.low.x + 0.88 * width,
                           block.high.x};
  const double low = block.low.y + kTitleHeight;
  add_rectangle({block.low.x, low}, block.high, sheet);
  for (const std::size_t k : {1U, 2U}) {
    sheet.lines.push_back({SheetLayer::frame, {{columns[k], low}, {columns[k], block.high.y}}});
  }
  const auto add_row = [&](std::size_t row, const std::array<std::string, 3>& texts) {
    const double bottom = low + kListRow * static_cast<double>(row);
    if (row > 0) {
      sheet.lines.push_back({SheetLayer::text, {{block.low.x, bottom}, {block.high.x, bottom}}});
    }
    for (std::size_t k = 0; k < texts.size(); ++k) {
      const Point2 room(columns[k + 1] - columns[k] - 2.0 * kInset, kListRow - kInset);
      const FittedText fitted = fit_text(texts[k], room);
      const double baseline = bottom + 0.5 * (kListRow - fitted.height);
      for (const std::string& line : fitted.lines) {
        const bool is_name = k == 1;
        const double at = is_name ? columns[k] + kInset : 0.5 * (columns[k] + columns[k + 1]);
        sheet.texts.push_back(
            {{at, baseline},
             fitted.height,
             line,
             is_name ? TextStyle::Alignment::left : TextStyle::Alignment::centre});
      }
      if (!fitted.whole) sheet.shortened.push_back(fmt::format("PART {}", texts[k]));
    }
  };
  std::array<std::string, 3> heads;
  std::ranges::copy(kPartsListHeads, heads.begin());
  add_row(0, heads);
  for (std::size_t i = 0; i < words.parts.size(); ++i) {
    const PartsListRow& part = words.parts[i];
    add_row(i + 1, {fmt::format("{}", part.number), part.name, fmt::format("{}", part.quantity)});
  }
}

}  // namespace

PaperBox block_of_titles(const SheetWords& words) {
  const double width = std::min(kTitleWidth, words.width - 2.0 * words.margin);
  const double list =
      words.parts.empty() ? 0.0 : kListRow * static_cast<double>(words.parts.size() + 1);
  const Point2 corner(words.width - words.margin, words.margin);
  return {{corner.x - width, corner.y}, {corner.x, corner.y + kTitleHeight + list}};
}

void add_title_block(const SheetWords& words, const DrawingScale& scale, DrawingSheet& sheet) {
  const double margin = words.margin;
  const Point2 high(words.width - margin, words.height - margin);
  add_rectangle(Point2(margin), high, sheet);
  const double left = block_of_titles(words).low.x, width = high.x - left;
  const double top = margin + kTitleHeight, middle = margin + 0.5 * kTitleHeight;
  add_rectangle({left, margin}, {high.x, top}, sheet);
  const double scales = left + 0.55 * width, symbol = left + 0.78 * width;
  for (const double x : {scales, symbol}) {
    sheet.lines.push_back({SheetLayer::frame, {{x, margin}, {x, top}}});
  }
  add_field({{left, margin}, {scales, top}}, "TITLE", words.title, sheet);
  const double below_scale = words.date.empty() ? margin : middle;
  add_field({{scales, below_scale}, {symbol, top}}, "SCALE", scale.text(), sheet);
  if (!words.date.empty()) {
    sheet.lines.push_back({SheetLayer::frame, {{scales, middle}, {symbol, middle}}});
    add_field({{scales, margin}, {symbol, middle}}, "DATE", words.date, sheet);
  }
  add_projection_symbol({{symbol, margin}, {high.x, top}}, words.projection, sheet);
  if (!words.parts.empty()) add_parts_list(words, sheet);
}

}  // namespace displayfile
