// Dimensions as ISO 129-1 draws them: filled arrowheads, extension lines with a gap and an
// overshoot, numbers above the line, to be read from the bottom or from the right.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "interp/annotation/page_annotation.h"

namespace displayfile {

namespace {

// In parts of the capitals' height.
constexpr double kGapOfNumber = 0.4;          // above the line
constexpr double kRoomOfNumber = 0.6;         // along the line, both sides together
constexpr double kExtensionGap = 8.0 / 14.0;  // 8 line widths, as the overshoot
constexpr double kArrowsInLine = 3.0;         // lengths of arrows, of a line with arrows inside

Point2 up_from(const Point2& direction) { return {-direction.y, direction.x}; }

/// The direction or its opposite, in which a text is read from the bottom, or from the right where
/// it is upright within 15 degrees.
Point2 readable(const Point2& direction) {
  constexpr double kUpright = 0.2588;  // the sine of 15 degrees
  const bool is_upright = std::abs(direction.x) <= kUpright;
  return (is_upright ? direction.y < 0.0 : direction.x < 0.0) ? -direction : direction;
}

double path_length(std::span<const Point2> path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += glm::distance(path[i], path[i + 1]);
  return length;
}

/// The point of a path at a distance along it from its start.
Point2 point_along(std::span<const Point2> path, double distance) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double step = glm::distance(path[i], path[i + 1]);
    if (distance <= step && step > 0.0) return path[i] + distance / step * (path[i + 1] - path[i]);
    distance -= step;
  }
  return path.back();
}

/// The part of a path between two distances along it.
std::vector<Point2> part_of_path(std::span<const Point2> path, double from, double to) {
  std::vector<Point2> part{point_along(path, from)};
  double at = 0.0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    at += glm::distance(path[i - 1], path[i]);
    if (at > from && at < to) part.push_back(path[i]);
  }
  part.push_back(point_along(path, to));
  return part;
}

}  // namespace

/// Draws a line from a point of the model to an end of the dimension line.
void AnnotationPencil::extension_line(const Point2& from, const Point2& to) {
  const double length = glm::distance(from, to), gap = kExtensionGap * height_;
  if (length <= gap) return;
  const Point2 direction = (to - from) / length;
  line({from + gap * direction, to + gap * direction});
}

/// Draws an arrowhead from outside, with its line.
void AnnotationPencil::outer_arrow(const Point2& tip, const Point2& direction) {
  line({tip - 2.0 * arrow_length() * direction, tip - 0.5 * arrow_length() * direction});
  arrow(tip, direction);
}

/// Draws arrowheads between the ends, or outside of them if there is no room; returns true if there
/// is.
bool AnnotationPencil::arrows_of_line(const Point2& start, const Point2& end,
                                      const Point2& direction) {
  const double half_arrow = 0.5 * arrow_length();
  const bool have_room = glm::distance(start, end) >= kArrowsInLine * arrow_length();
  if (have_room) {
    line({start + half_arrow * direction, end - half_arrow * direction});
    arrow(start, -direction);
    arrow(end, direction);
  } else {
    line({start, end});
    outer_arrow(start, direction);
    outer_arrow(end, -direction);
  }
  return have_room;
}

/// Draws a line from a point in a direction, with the number above its end, after a length `before`
/// without a number.
void AnnotationPencil::number_on_line(const Point2& start, double before, const Point2& direction) {
  const double room = width_of(kept_->characters) + kRoomOfNumber * height_;
  const Point2 read = readable(direction);
  line({start, start + (before + room) * direction});
  text(kept_->characters,
       start + (before + 0.5 * room) * direction + kGapOfNumber * height_ * up_from(read),
       TextStyle::Alignment::centre, read);
}

/// A number without room on the line is placed beyond the end that is read last.
void AnnotationPencil::dimension_line(const Point2& from, const Point2& to) {
  const double length = glm::distance(from, to);
  if (length < line_width(height_)) return;
  const Point2 direction = readable((to - from) / length);
  const bool turned = glm::dot(direction, to - from) < 0.0;
  const Point2 start = turned ? to : from, end = turned ? from : to;
  const bool arrows_inside = arrows_of_line(start, end, direction);
  if (width_of(kept_->characters) + kRoomOfNumber * height_ <= length) {
    return text(kept_->characters,
                0.5 * (start + end) + kGapOfNumber * height_ * up_from(direction),
                TextStyle::Alignment::centre, direction);
  }
  number_on_line(end + (arrows_inside ? 0.0 : 2.0 * arrow_length()) * direction, 0.0, direction);
}

void AnnotationPencil::diameter(const PageAnnotation& diameter) {
  const Point2 &from = diameter.points[0], &to = diameter.points[1];
  const double length = glm::distance(from, to);
  if (!diameter.number_beyond || length < line_width(height_)) return dimension_line(from, to);
  const double beyond = *diameter.number_beyond;
  const Point2 direction = (beyond < 0.0 ? from - to : to - from) / length;
  const Point2 start = beyond < 0.0 ? to : from, end = beyond < 0.0 ? from : to;
  arrows_of_line(start, end, direction);
  number_on_line(end, std::abs(beyond), direction);
}

/// A line from the centre with an arrowhead at the circle; where the number has no room on it, one
/// from outside.
void AnnotationPencil::radius(const PageAnnotation& radius) {
  const Point2 &centre = radius.points[0], &at = radius.points[1];
  const double length = glm::distance(centre, at);
  if (length < line_width(height_)) return;
  const Point2 outward = (at - centre) / length, direction = readable(outward);
  const double room = width_of(kept_->characters) + kRoomOfNumber * height_;
  if (!radius.number_beyond && room + arrow_length() <= length) {
    line({centre, at - 0.5 * arrow_length() * outward});
    arrow(at, outward);
    return text(kept_->characters,
                centre + 0.5 * (length - arrow_length()) * outward +
                    kGapOfNumber * height_ * up_from(direction),
                TextStyle::Alignment::centre, direction);
  }
  const double before = std::max(1.5 * arrow_length(), radius.number_beyond.value_or(0.0));
  arrow(at, -outward);
  number_on_line(at + 0.5 * arrow_length() * outward, before - 0.5 * arrow_length(), outward);
}

/// An arc with arrowheads; its number is level, on the outer side of the arc's middle.
void AnnotationPencil::angle(std::span<const Point2> points) {
  const Point2 vertex = points[0];
  const std::span<const Point2> arc = points.subspan(3);
  const double length = path_length(arc), half_arrow = 0.5 * arrow_length();
  if (length < line_width(height_)) return;
  for (const auto& [at, end] :
       {std::pair(points[1], arc.front()), std::pair(points[2], arc.back())}) {
    const bool is_opposite = glm::dot(end - vertex, at - vertex) < 0.0;
    if (is_opposite) extension_line(vertex, end);
    if (!is_opposite && glm::dot(end - at, at - vertex) > 0.0) extension_line(at, end);
  }
  const std::vector<Point2> back(arc.rbegin(), arc.rend());
  const bool arrows_inside = length >= kArrowsInLine * arrow_length();
  if (arrows_inside) {
    line(part_of_path(arc, half_arrow, length - half_arrow));
  } else {
    line({arc.begin(), arc.end()});
  }
  for (const std::span<const Point2> from_tip : {arc, std::span<const Point2>(back)}) {
    const Point2 tip = from_tip.front();
    const Point2 inner = point_along(from_tip, std::min(arrow_length(), length));
    const double chord = glm::distance(tip, inner);
    if (!(chord > 0.0)) continue;
    const Point2 outward = (tip - inner) / chord;
    arrows_inside ? arrow(tip, outward) : outer_arrow(tip, -outward);
  }
  const Point2 middle = point_along(arc, 0.5 * length);
  const double distance = glm::distance(vertex, middle);
  const Point2 outward = distance > 0.0 ? (middle - vertex) / distance : Point2(0.0, 1.0);
  const double reach = (kGapOfNumber + 0.5 * std::abs(outward.y)) * height_ +
                       0.5 * std::abs(outward.x) * width_of(kept_->characters);
  text(kept_->characters, middle + reach * outward - Point2(0.0, 0.5 * height_),
       TextStyle::Alignment::centre);
}

}  // namespace displayfile
