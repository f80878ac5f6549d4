#include "interp/vector/pens/pen_annotation.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

namespace displayfile {

namespace {

class AnnotationStrokes {
 public:
  AnnotationStrokes(const AnnotationMark& mark, const Point2& picture, const Background& background,
                    PenDevice& device)
      : mark_(mark), picture_(picture), background_(background), device_(device) {
    style_.colour = mark.colour;
    style_.width = mark.width;
  }

  void draw() {
    using enum AnnotationMark::Kind;
    switch (mark_.kind) {
      case line: return path(mark_.points, mark_.closed);
      case area: return filled();
      case text: return device_.draw_annotation_text(mark_.text);
      case blank: return hide();
    }
  }

 private:
  Point3 in_device(const Point2& p) const { return {p.x / picture_.x, p.y / picture_.y, 1.0}; }
  void stroke(const Point2& from, const Point2& to) {
    device_.line({in_device(from), in_device(to), style_});
  }
  /// Hides earlier drawing as a fill in the background's colour does, if there is a background.
  void hide() {
    if (background_.kind == Background::Kind::none) return;
    std::vector<Point3> polygon;
    for (const Point2& p : mark_.points) polygon.push_back(in_device(p));
    device_.blank(polygon);
  }
  void path(std::span<const Point2> points, bool closed) {
    for (std::size_t i = 1; i < points.size(); ++i) stroke(points[i - 1], points[i]);
    if (closed) stroke(points.back(), points.front());
  }
  /// Draws an area as its outline, and lines from its first point to its sides, a pen's width apart
  /// there. The outline is moved inward by half a pen's width, so that the area is no larger than
  /// in other formats.
  void filled() {
    std::vector<Point2> points = mark_.points;
    Point2 middle(0.0);
    for (const Point2& p : points) middle += p / static_cast<double>(points.size());
    for (Point2& p : points) {
      const double distance = glm::distance(p, middle);
      if (distance > mark_.width) p += 0.5 * mark_.width / distance * (middle - p);
    }
    path(points, true);
    double next = mark_.width;  // from the last corner
    for (std::size_t i = 2; i < points.size(); ++i) {
      const Point2 from = points[i - 1], along = points[i] - from;
      const double length = glm::length(along);
      for (; next < length; next += mark_.width) stroke(points[0], from + next / length * along);
      next -= length;
    }
  }
  const AnnotationMark& mark_;
  Point2 picture_;
  const Background& background_;
  PenDevice& device_;
  LineStyle style_;
};

}  // namespace

void draw_annotation(std::span<const AnnotationMark> marks, const Point2& picture,
                     const Background& background, PenDevice& device) {
  for (const AnnotationMark& mark : marks) {
    AnnotationStrokes(mark, picture, background, device).draw();
  }
}

}  // namespace displayfile
