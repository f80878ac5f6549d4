#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "interp/annotation/page_annotation.h"

namespace displayfile {

namespace {

constexpr int kSidesOfCircle = 64;
constexpr double kHalfArrow = 0.1763;  // the tangent of 10 degrees

/// Advances of DejaVu Sans, which is wider than Helvetica, in classes, in parts of the font's size.
double advance_of(char c) {
  constexpr std::string_view kNarrow = "ijlI.,:;'|!()[] ", kWide = "mwMW@%";
  if (kNarrow.find(c) != kNarrow.npos) return 0.4;
  if (kWide.find(c) != kWide.npos) return 1.0;
  if (c >= '0' && c <= '9') return 0.64;
  return c >= 'A' && c <= 'Z' ? 0.74 : 0.64;
}

}  // namespace

double width_of_text(std::string_view characters) {
  double width = 0.0;
  for (const char c : characters) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0u) == 0x80u;  // within a character of UTF-8
    if (!continues) width += byte < 0x80u ? advance_of(c) : 0.8;
  }
  return width / kCapitalsOfEm;
}

std::vector<Point2> points_of(std::span<const AnnotationMark> marks, const AnnotationPage& page) {
  std::vector<Point2> all;
  for (const AnnotationMark& mark : marks) {
    all.insert(all.end(), mark.points.begin(), mark.points.end());
    if (mark.kind != AnnotationMark::Kind::text) continue;
    const TextStyle& style = mark.text.style;
    const double height = style.size * page.height * kCapitalsOfEm;
    const double width = height * width_of_text(mark.text.characters);
    const double before = style.alignment == TextStyle::Alignment::left    ? 0.0
                          : style.alignment == TextStyle::Alignment::right ? width
                                                                           : 0.5 * width;
    const double turn = mark.text.turn * std::numbers::pi / 180.0;
    const Point2 along(std::cos(turn), std::sin(turn)), up(-along.y, along.x);
    const Point2 start =
        Point2(mark.text.anchor.x * page.width, mark.text.anchor.y * page.height) - before * along;
    all.insert(all.end(), {start, start + width * along, start + height * up,
                           start + width * along + height * up});
  }
  return all;
}

void AnnotationPencil::draw(const PageAnnotation& annotation, std::size_t number,
                            std::span<const PartsListRow> rows) {
  using enum KeptAnnotation::Kind;
  kept_ = annotation.kept;
  number_ = number;
  height_ = annotation.height;
  const std::vector<Point2>& p = annotation.points;
  switch (kept_->kind) {
    case KeptAnnotation::Kind::leader: return this->leader(annotation);
    case KeptAnnotation::Kind::balloon: return this->balloon(annotation);
    case linear:
      if (glm::distance(p[2], p[3]) < line_width(height_)) return;
      extension_line(p[0], p[2]);
      extension_line(p[1], p[3]);
      return dimension_line(p[2], p[3]);
    case KeptAnnotation::Kind::diameter: return this->diameter(annotation);
    case KeptAnnotation::Kind::radius: return this->radius(annotation);
    case KeptAnnotation::Kind::angle: return this->angle(p);
    case KeptAnnotation::Kind::title: return this->title(annotation);
    case list: return parts_list(annotation, rows);
  }
}

double AnnotationPencil::width_of(std::string_view characters) const {
  return height_ * width_of_text(characters);
}

AnnotationMark& AnnotationPencil::add(AnnotationMark::Kind kind) {
  AnnotationMark mark{kind, number_, kept_->segment, kept_->colour};
  mark.width = line_width(height_);
  return marks_.emplace_back(std::move(mark));
}

void AnnotationPencil::line(std::vector<Point2> points, bool closed) {
  AnnotationMark& mark = add(AnnotationMark::Kind::line);
  mark.points = std::move(points);
  mark.closed = closed;
}

/// Filled, with an angle of 20 degrees.
void AnnotationPencil::arrow(const Point2& tip, const Point2& direction) {
  const Point2 base = tip - arrow_length() * direction;
  const Point2 aside = kHalfArrow * arrow_length() * Point2(-direction.y, direction.x);
  add(AnnotationMark::Kind::area).points = {tip, base + aside, base - aside};
}

std::vector<Point2> AnnotationPencil::circle(const Point2& centre, double radius) const {
  std::vector<Point2> points;
  for (int k = 0; k < kSidesOfCircle; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSidesOfCircle;
    points.emplace_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void AnnotationPencil::text(std::string_view characters, const Point2& at,
                            TextStyle::Alignment alignment, const Point2& direction) {
  if (characters.empty()) return;
  DeviceText text;
  text.anchor = Point3(at.x / page_.width, at.y / page_.height, 1.0);
  text.style.size = height_ / kCapitalsOfEm / page_.height;
  text.style.alignment = alignment;
  text.line.kind = LineStyle::Kind::solid;
  text.line.colour = kept_->colour;
  text.line.width = line_width(height_);
  text.characters = characters;
  text.segment = kept_->segment;
  constexpr double kLevel = 1e-4;  // degrees, which no picture shows
  const double turn = std::atan2(direction.y, direction.x) * 180.0 / std::numbers::pi;
  if (std::abs(turn) > kLevel) text.turn = turn;
  add(AnnotationMark::Kind::text).text = std::move(text);
}

}  // namespace displayfile
