// Leaders and balloons.

#include <algorithm>
#include <glm/geometric.hpp>

#include "interp/annotation/page_annotation.h"

namespace displayfile {

namespace {

// In parts of the capitals' height.
constexpr double kLanding = 1.0, kGapOfLeader = 0.4, kDot = 0.22;
constexpr double kLeastBalloon = 1.15, kGapOfBalloon = 0.5;

}  // namespace

double AnnotationPencil::balloon_radius(const PageAnnotation& balloon) {
  const double half_text = 0.5 * width_of_text(balloon.kept->characters);
  return balloon.height * std::max(kLeastBalloon, half_text + kGapOfBalloon);
}

double AnnotationPencil::leader_width(const PageAnnotation& leader) {
  return leader.height * (kLanding + kGapOfLeader + width_of_text(leader.kept->characters));
}

/// The arrowhead or the dot at the model, and the line from there. A line shorter than an arrow is
/// not drawn.
void AnnotationPencil::leader_end(const Point2& at, const Point2& from) {
  const double length = glm::distance(at, from);
  if (length <= arrow_length()) return;
  const Point2 direction = (at - from) / length;
  if (kept_->style.ends == AnnotationStyle::Ends::arrow) {
    line({from, at - 0.5 * arrow_length() * direction});
    return arrow(at, direction);
  }
  line({from, at});
  add(AnnotationMark::Kind::area).points = circle(at, kDot * height_);
}

/// A line, a landing and a text at the landing's height (ISO 128-2), or above or below the line's
/// end.
void AnnotationPencil::leader(const PageAnnotation& leader) {
  using enum PageAnnotation::Side;
  const Point2& at = leader.at;
  leader_end(leader.points[0], at);
  if (leader.side == above || leader.side == below) {
    const double by = leader.side == above ? kGapOfLeader : -kGapOfLeader - 1.0;
    return text(kept_->characters, at + Point2(0.0, by * height_), TextStyle::Alignment::centre);
  }
  const double toward = leader.side == right ? 1.0 : -1.0;
  line({at, at + Point2(toward * kLanding * height_, 0.0)});
  text(kept_->characters, at + height_ * Point2(toward * (kLanding + kGapOfLeader), -0.5),
       leader.side == right ? TextStyle::Alignment::left : TextStyle::Alignment::right);
}

/// A circle that hides the figure (ISO 6433), with the line to it.
void AnnotationPencil::balloon(const PageAnnotation& balloon) {
  const double radius = balloon_radius(balloon);
  const Point2& at = balloon.points[0];
  const double length = glm::distance(at, balloon.at);
  if (length > radius) {
    leader_end(at, balloon.line_end.value_or(balloon.at + radius / length * (at - balloon.at)));
  }
  const std::vector<Point2> outline = circle(balloon.at, radius);
  add(AnnotationMark::Kind::blank).points = outline;
  line(outline, true);
  text(kept_->characters, balloon.at - Point2(0.0, 0.5 * height_), TextStyle::Alignment::centre);
}

}  // namespace displayfile
