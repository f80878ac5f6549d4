#include <cmath>
#include <numbers>

#include "programs/sheet/arrangement.h"

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

/// A truncated cone and its view from the left, where its small end is (ISO 5456-2): beside that
/// end by the third angle, on the other side by the first.
void add_projection_symbol(const Point2& middle, SheetProjection projection, DrawingSheet& sheet) {
  constexpr double kSmall = 2.0, kLarge = 4.0, kHalfLength = 4.0, kApart = 6.0;
  const double to_cone = projection == SheetProjection::third ? kApart : -kApart;
  const Point2 cone = middle + Point2(to_cone, 0.0), circles = middle - Point2(to_cone, 0.0);
  sheet.lines.push_back({SheetLayer::text,
                         {cone + Point2(-kHalfLength, -kSmall), cone + Point2(kHalfLength, -kLarge),
                          cone + Point2(kHalfLength, kLarge), cone + Point2(-kHalfLength, kSmall)},
                         true});
  add_circle(circles, kSmall, sheet);
  add_circle(circles, kLarge, sheet);
}

}  // namespace

void add_title_block(const SheetWords& words, const DrawingScale& scale, DrawingSheet& sheet) {
  constexpr double kText = 3.5, kLabel = 1.8, kInset = 1.6, kApart = 1.3;
  const double margin = words.margin;
  const Point2 high(words.width - margin, words.height - margin);
  add_rectangle(Point2(margin), high, sheet);
  const double width = std::min(kTitleWidth, words.width - 2.0 * margin);
  const double left = high.x - width, top = margin + kTitleHeight,
               middle = margin + 0.5 * kTitleHeight;
  add_rectangle({left, margin}, {high.x, top}, sheet);
  const double scales = left + 0.55 * width, symbol = left + 0.78 * width;
  for (const double x : {scales, symbol}) {
    sheet.lines.push_back({SheetLayer::frame, {{x, margin}, {x, top}}});
  }
  const auto add_field = [&](double x, double y, const char* label, const std::string& text) {
    sheet.texts.push_back({{x + kInset, y - kInset - kLabel}, kLabel, label});
    sheet.texts.push_back({{x + kInset, y - kInset - kLabel - kApart - kText}, kText, text});
  };
  if (words.date.empty()) {
    add_field(left, top, "TITLE", words.title);
    add_field(scales, top, "SCALE", scale.text());
  } else {
    sheet.lines.push_back({SheetLayer::frame, {{scales, middle}, {symbol, middle}}});
    add_field(left, top, "TITLE", words.title);
    add_field(scales, top, "SCALE", scale.text());
    add_field(scales, middle, "DATE", words.date);
  }
  add_projection_symbol({0.5 * (symbol + high.x), middle}, words.projection, sheet);
}

}  // namespace displayfile
