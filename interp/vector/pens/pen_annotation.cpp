#include "interp/vector/pens/pen_annotation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "interp/annotation/page_annotation.h"
#include "interp/vector/pens/stroke_letters.h"

namespace displayfile {

namespace {

class AnnotationStrokes {
 public:
  AnnotationStrokes(const AnnotationMark& mark, const Point2& picture, PenDevice& device)
      : mark_(mark), picture_(picture), device_(device) {
    style_.colour = mark.kind == AnnotationMark::Kind::text ? mark.text.line.colour : mark.colour;
    style_.width = mark.width;
  }

  void draw() {
    using enum AnnotationMark::Kind;
    switch (mark_.kind) {
      case line: return path(mark_.points, mark_.closed);
      case area: return filled();
      case text: return letters();
      case blank: return;
    }
  }

 private:
  void stroke(const Point2& from, const Point2& to) {
    const auto device = [&](const Point2& p) {
      return Point3(p.x / picture_.x, p.y / picture_.y, 1.0);
    };
    device_.line({device(from), device(to), style_});
  }
  void path(std::span<const Point2> points, bool closed) {
    for (std::size_t i = 1; i < points.size(); ++i) stroke(points[i - 1], points[i]);
    if (closed) stroke(points.back(), points.front());
  }
  /// Its outline, and lines from its first point to its sides, a pen's width apart there.
  void filled() {
    const std::span<const Point2> points = mark_.points;
    path(points, true);
    double next = mark_.width;  // from the last corner
    for (std::size_t i = 2; i < points.size(); ++i) {
      const Point2 from = points[i - 1], along = points[i] - from;
      const double length = glm::length(along);
      for (; next < length; next += mark_.width) stroke(points[0], from + next / length * along);
      next -= length;
    }
  }
  void letters() {
    const DeviceText& text = mark_.text;
    if (device_.draw_text(text)) return;
    const double turn = text.turn * std::numbers::pi / 180.0;
    const Point2 along(std::cos(turn), std::sin(turn)), up(-along.y, along.x);
    const Point2 anchor(text.anchor.x * picture_.x, text.anchor.y * picture_.y);
    const double height = text.style.size * picture_.y * kCapitalsOfEm;
    const StrokeLetters letters = stroke_letters(text.characters);
    const double before = text.style.alignment == TextStyle::Alignment::left ? 0.0
                          : text.style.alignment == TextStyle::Alignment::right
                              ? letters.width
                              : 0.5 * letters.width;
    for (const auto& [from, to] : letters.strokes) {
      const auto at = [&](const Point2& p) {
        return anchor + height * ((p.x - before) * along + p.y * up);
      };
      stroke(at(from), at(to));
    }
  }

  const AnnotationMark& mark_;
  Point2 picture_;
  PenDevice& device_;
  LineStyle style_;
};

}  // namespace

void draw_annotation(std::span<const AnnotationMark> marks, const Point2& picture,
                     PenDevice& device) {
  for (const AnnotationMark& mark : marks) AnnotationStrokes(mark, picture, device).draw();
}

}  // namespace displayfile
