#include "displayfile/looks/colour_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace displayfile {

namespace {

/// Numbers this close to a whole number of steps stand for it: where several parts of a colour pass
/// a step in one place, rounding must not leave needles between their cuts.
double snapped(double steps) {
  constexpr double kNear = 1e-9;
  const double whole = std::round(steps);
  return std::abs(steps - whole) <= kNear ? whole : steps;
}

Colour snapped(const Colour& steps) {
  return {snapped(steps.r), snapped(steps.g), snapped(steps.b)};
}

/// Where a part of the colour has a value between those of the two ends of a side: found from the
/// end of the lower value, whichever way the side runs.
ColouredCorner crossing(const ColouredCorner& a, const ColouredCorner& b, int part, double value) {
  const bool rises = a.colour[part] < b.colour[part];
  const ColouredCorner& low = rises ? a : b;
  const ColouredCorner& high = rises ? b : a;
  const double t = (value - low.colour[part]) / (high.colour[part] - low.colour[part]);
  ColouredCorner at{low.point + t * (high.point - low.point),
                    low.normal + t * (high.normal - low.normal),
                    snapped(low.colour + t * (high.colour - low.colour))};
  at.colour[part] = value;
  return at;
}

}  // namespace

void ColourPieces::cut(const std::array<ColouredCorner, 3>& triangle) {
  corners_.assign(triangle.begin(), triangle.end());
  for (ColouredCorner& corner : corners_) corner.colour = snapped(corner.colour * double{kSteps});
  ends_.assign(1, corners_.size());
  for (int part = 0; part < 3; ++part) cut_at_steps(part);
}

std::span<const ColouredCorner> ColourPieces::corners_of(std::size_t piece) const {
  const std::size_t first = piece == 0 ? 0 : ends_[piece - 1];
  return std::span(corners_).subspan(first, ends_[piece] - first);
}

ColourPieces::Piece ColourPieces::operator[](std::size_t piece) const {
  const auto corners = corners_of(piece);
  Colour low = corners.front().colour, high = low;
  for (const ColouredCorner& corner : corners) {
    low = glm::min(low, corner.colour);
    high = glm::max(high, corner.colour);
  }
  return {corners, (low + high) / (2.0 * kSteps)};
}

void ColourPieces::cut_at_steps(int part) {
  cut_corners_.clear();
  cut_ends_.clear();
  for (std::size_t piece = 0; piece < ends_.size(); ++piece) {
    const auto polygon = corners_of(piece);
    const auto [low, high] = std::ranges::minmax(
        polygon, {}, [part](const ColouredCorner& corner) { return corner.colour[part]; });
    const double end = high.colour[part];
    double step = std::floor(low.colour[part]);
    do {
      add_band(polygon, part, step);
      step += 1.0;
    } while (step < end);
  }
  std::swap(corners_, cut_corners_);
  std::swap(ends_, cut_ends_);
}

/// Adds the part of a polygon from `low` to the next step, unless nothing of it is left.
void ColourPieces::add_band(std::span<const ColouredCorner> polygon, int part, double low) {
  const std::size_t first = cut_corners_.size();
  const double high = low + 1.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ColouredCorner& from = polygon[k];
    const ColouredCorner& to = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    const double a = from.colour[part], b = to.colour[part];
    if (a >= low && a <= high) add_corner(from, first);
    const bool rises = a < b;
    for (const double level : {rises ? low : high, rises ? high : low}) {
      if (std::min(a, b) < level && level < std::max(a, b)) {
        add_corner(crossing(from, to, part, level), first);
      }
    }
  }
  const bool ends_at_first =
      cut_corners_.size() > first && cut_corners_.back().point == cut_corners_[first].point;
  if (ends_at_first) cut_corners_.pop_back();
  if (cut_corners_.size() < first + 3) return cut_corners_.resize(first);
  cut_ends_.push_back(cut_corners_.size());
}

/// Leaves out a corner where the one before is, among those from `first` on.
void ColourPieces::add_corner(const ColouredCorner& corner, std::size_t first) {
  if (cut_corners_.size() > first && cut_corners_.back().point == corner.point) return;
  cut_corners_.push_back(corner);
}

}  // namespace displayfile
