#include "hidden/lines/verticals.h"

#include <algorithm>

namespace displayfile {

Verticals::Verticals(const GridSurface& surface) : upward_(surface.upward()) {
  // Below this, a vertical as long as the picture is deep moves less than any error in the picture.
  constexpr double kNoDirection = 1e-12;
  are_points_ =
      upward_.w == 0.0 && std::hypot(upward_.x, upward_.y) <= kNoDirection * std::abs(upward_.z);
  if (are_points_) return;
  for (std::uint32_t k = 0; k < surface.points(); ++k) middle_ += Point2(surface.point(k));
  middle_ /= surface.points();
  up_ = direction_at(middle_);
  const double length = std::hypot(up_.x, up_.y);
  if (!(length > 0.0)) return;
  up_ /= length;
  across_ = {up_.y, -up_.x};
  in_columns_.reserve(surface.points());
  for (std::uint32_t k = 0; k < surface.points(); ++k) {
    constexpr double kTogether = 1e-3;  // relative to their separation in the middle
    const Place at = place(Point2(surface.point(k)));
    if (!(at.over > kTogether * length)) return;
    in_columns_.emplace_back(at.across / at.over * length, at.along / at.over * length);
    box_.include(in_columns_.back());
    const double from_middle = std::hypot(at.across, at.along);
    largest_scale_ = std::max(
        largest_scale_, length / at.over * (1.0 + std::abs(upward_.w) * from_middle / at.over));
  }
  make_columns_ = true;
}

Verticals::Place Verticals::place(const Point2& p) const {
  const Point2 from = p - middle_, up = direction_at(p);
  return {from.x * across_.x + from.y * across_.y, from.x * up_.x + from.y * up_.y,
          up.x * up_.x + up.y * up_.y};
}

double Verticals::part_at_column(const Point2& a, const Point2& b, double x) const {
  const Point2 middle_up = direction_at(middle_);
  const double scaled = x / std::hypot(middle_up.x, middle_up.y);
  const Place of_a = place(a), of_b = place(b);
  const double at_a = of_a.across - scaled * of_a.over, at_b = of_b.across - scaled * of_b.over;
  const double part = at_a / (at_a - at_b);
  return part > 0.0 ? std::fmin(part, 1.0) : 0.0;
}

}  // namespace displayfile
